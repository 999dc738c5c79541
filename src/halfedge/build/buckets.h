#pragma once

#include <halfedge/build/each_face.h>
#include <halfedge/build/groups.h>
#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace halfedge {

/// Divides the sides of triangles among buckets by the smaller vertices of their edges, for meshes
/// that come in random order: one step of a radix sort. What belongs to the vertices of a bucket
/// fits into the cache, so that sides that are taken bucket by bucket don't wait for memory.
///
/// A bucket has the places of the groups of its vertices (groups.h), and keeps its sides at the
/// first of these, in the order in which they come. So the triangles tell whenever it is asked
/// where each of their sides is kept, and nothing has to be stored of that.
class Buckets {
 public:
  /// Whether a build of these would wait for memory longer than it takes to divide their sides: if
  /// there are many vertices, and triangles that follow one another have none in common or nearby.
  /// cost: O(1)
  [[nodiscard]] static bool pay(const Polygons& triangles);

  /// Gives each bucket its places, before any side has got one of them. False if one bucket has
  /// more of them than there are vertices, as with a vertex of huge valence: too many for a cache,
  /// and for what Groups::scratch() has room for, two words of each.
  [[nodiscard]] bool set_up(const Groups& groups, std::size_t vertices);

  /// Calls `visit(face, its corners, slots)` for each triangle: its side from corner `i` is kept in
  /// `slots[i]`.
  template <class Visit>
  void for_each_triangle(const Polygons& triangles, const Visit& visit);

  /// Calls `visit(begin, end, places_end)` for each bucket, after for_each_triangle: its sides are
  /// kept from `begin` to `end`, its places end later if there are more of them than sides.
  template <class Visit>
  void for_each_bucket(const Visit& visit) const {
    for (std::size_t i = 0; i < kCount; ++i) visit(begin_[i], end_[i], begin_[i + 1]);
  }

 private:
  static constexpr std::size_t kCount = 256;
  // Fewer, and what belongs to all of them fits into the cache, or what is asked for ahead is there
  // in time.
  static constexpr std::size_t kFewVertices = kCanPrefetch ? 450'000 : 200'000;

  Index shift_ = 0;                        // from a vertex to its bucket
  std::array<Index, kCount + 1> begin_{};  // where the places of each bucket begin
  std::array<Index, kCount> end_{};        // where its sides end
};

template <class Visit>
void Buckets::for_each_triangle(const Polygons& triangles, const Visit& visit) {
  std::array<Index, kCount> next;  // a local one is known not to be what `visit` writes
  std::copy_n(begin_.begin(), kCount, next.begin());
  for_each_face<true>(triangles, [&](Index f, const Index* corners, auto) {
    std::array<Index, 3> slots;
    for (Index i = 0; i < 3; ++i) {
      slots[i] = next[DirectedSide(corners[i], corners[i == 2 ? 0 : i + 1]).low >> shift_]++;
    }
    visit(f, corners, slots);
  });
  end_ = next;
}

}  // namespace halfedge
