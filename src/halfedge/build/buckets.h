#pragma once

#include <halfedge/build/each_face.h>
#include <halfedge/build/groups.h>
#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace halfedge {

/// Where a bucket keeps its sides.
struct Bucket {
  Index begin;  ///< of its places, and of the slots of its sides that run up
  Index ups_end;
  Index downs_begin;
  Index downs_end;
  Index end;  ///< of its places
};

/// Divides the sides of triangles among buckets by the smaller vertices of their edges, for meshes
/// that come in random order: one step of a radix sort. What belongs to the vertices of a bucket
/// fits into the cache, so that sides that are taken bucket by bucket don't wait for memory.
///
/// A bucket has the places of the groups of its vertices (groups.h), and keeps its sides there in
/// two lists, in the order in which they come: those that run up from the first place on, those
/// that run down from the middle on. So a byte for each side, the number of its list, is all that
/// it takes to find where it is kept, its *slot*, once more.
class Buckets {
 public:
  /// Whether a build of these would wait for memory longer than it takes to divide their sides: if
  /// there are many vertices, and triangles that follow one another have none in common or nearby.
  /// cost: O(1)
  [[nodiscard]] static bool pay(const Polygons& triangles);

  /// Gives each bucket its places, before any side has got one of them. False where vertices have a
  /// huge valence: if a group has so many places that it would take long to search it for each of
  /// its sides; or if one bucket has more places than there are vertices, which are too many for a
  /// cache, and for what Groups::scratch() has room for, two words of each.
  [[nodiscard]] bool set_up(const Groups& groups, std::size_t vertices);

  /// Calls `visit(slot, low, high)` for each side, with the smaller and the larger vertex of its
  /// edge. `lists` has a word for each triangle, which gets the numbers of the lists of its sides.
  template <class Visit>
  void divide(const Polygons& triangles, std::span<Index> lists, const Visit& visit);

  /// Calls `visit(face, slots)` for each triangle, after divide(): its side from corner `i` is kept
  /// in `slots[i]`. `visit` may write over the word of the triangle.
  template <class Visit>
  void for_each_triangle(std::span<const Index> lists, const Visit& visit) const;

  /// Calls `visit(bucket)` for each bucket, after divide().
  template <class Visit>
  void for_each_bucket(const Visit& visit) const {
    for (std::size_t i = 0; i < kCount; ++i) {
      const Index begin = begin_[i];
      const Index end = begin_[i + 1];
      visit(Bucket{begin, next_[2 * i], middle(begin, end), next_[2 * i + 1], end});
    }
  }

 private:
  static constexpr std::size_t kCount = 128;
  static constexpr Index kListBits = 8;
  static constexpr Index kListMask = (1U << kListBits) - 1;
  static_assert(2 * kCount == kListMask + 1);
  // Fewer, and what belongs to all of them fits into the cache, or what is asked for ahead is there
  // in time.
  static constexpr std::size_t kFewVertices = kCanPrefetch ? 450'000 : 150'000;

  // No group has more sides of either direction than half of its places.
  [[nodiscard]] static constexpr Index middle(Index begin, Index end) {
    return begin + (end - begin) / 2;
  }

  static constexpr Index kLargestGroup = 4096;

  using Slots = std::array<Index, 2 * kCount>;  // by list: sides of a bucket that run up, and down

  [[nodiscard]] Slots first_slots() const {
    Slots first;
    for (std::size_t i = 0; i < kCount; ++i) {
      first[2 * i] = begin_[i];
      first[2 * i + 1] = middle(begin_[i], begin_[i + 1]);
    }
    return first;
  }

  Index shift_ = 0;                        // from a vertex to its bucket
  std::array<Index, kCount + 1> begin_{};  // where the places of each bucket begin
  Slots next_{};                           // the next slots
};

template <class Visit>
void Buckets::divide(const Polygons& triangles, std::span<Index> lists, const Visit& visit) {
  Slots next = first_slots();  // a local one is known not to be what `visit` writes
  for_each_face<true>(triangles, [&](Index f, const Index* corners, auto) {
    Index lists_of_face = 0;
    for (Index i = 0; i < 3; ++i) {
      const Index from = corners[i];
      const Index to = corners[i == 2 ? 0 : i + 1];
      const DirectedSide side(from, to);
      const Index list = 2 * (side.low >> shift_) - side.down;
      visit(next[list]++, side.low, side.pick(to, from));
      lists_of_face |= list << kListBits * i;
    }
    lists[f] = lists_of_face;
  });
  next_ = next;
}

template <class Visit>
void Buckets::for_each_triangle(std::span<const Index> lists, const Visit& visit) const {
  Slots next = first_slots();
  for (Index f = 0; f < lists.size(); ++f) {
    const Index lists_of_face = lists[f];
    std::array<Index, 3> slots;
    for (Index i = 0; i < 3; ++i) slots[i] = next[lists_of_face >> kListBits * i & kListMask]++;
    visit(f, slots);
  }
}

}  // namespace halfedge
