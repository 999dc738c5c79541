#pragma once

#include <halfedge/build/connect.h>
#include <halfedge/build/edge_table.h>
#include <halfedge/build/groups.h>
#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/links.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace halfedge {

/// The halfedges of a mesh in the making: their arrays, and the edge of each side of a face, which
/// is made when the first of its two faces asks for it.
///
/// The group of a vertex is also the place to look for its edges: `to_vertex` of their even
/// halfedges, up to the first that is still empty. There are three to a group on average. Hash
/// tables help with what a group doesn't show:
///   - the edges of large groups, around vertices of high valence;
///   - edges for which a group has no room: as many as there are boundary edges whose only side
///     runs down. They can't be foreseen, so they are numbered after all groups, and their table
///     grows.
template <bool kLargeGroups, bool kPrev>
class GroupedEdges {
 public:
  GroupedEdges(const Polygons& polygons, const Groups& groups, Links& links)
      : polygons_(polygons),
        groups_(groups.begin.data()),
        groups_end_(groups.end()),
        in_large_(groups.in_large),
        used_(groups.end()),
        links_(links) {}

  /// Makes the arrays, of halfedges as of faces. Nothing else may be called before it is kDone.
  [[nodiscard]] ConnectResult begin() {
    if (certain_halfedges() > kMaxSlots) return ConnectResult::kTooLarge;
    return reserve() ? ConnectResult::kDone : ConnectResult::kOutOfMemory;
  }

  /// kDone, if all edges were made that were asked for, or why not: then the others have links that
  /// mean nothing.
  [[nodiscard]] ConnectResult failure() const { return failure_; }

  /// Gives back what memory isn't used, if all went well: `clashes` is what all calls of take()
  /// returned, joined by or.
  [[nodiscard]] ConnectResult end(Index clashes) {
    if (failure_ != ConnectResult::kDone) return failure_;
    if (clashes != 0) return ConnectResult::kNotManifold;
    for (Array<Index>* array : halfedge_arrays()) {
      (void)array->resize(used_);  // no larger than it is
      if (is_fresh_) array->shrink_to_fit();
    }
    return ConnectResult::kDone;
  }

  /// Empties the groups of the vertices from `first` up to the one before `last`: before the first
  /// of their edges is asked for.
  void clear_groups(std::size_t first, std::size_t last) {
    std::fill(to_ + groups_[first], to_ + groups_[last], kNone);
  }

  /// The halfedge from `from` to `to`, whose edge is made if need be.
  Index find(Index from, Index to) {
    const Index low = std::min(from, to);
    const Index high = std::max(from, to);
    Index h = groups_[low];
    const Index end = groups_[low + 1];
    for (;; h += 2) {
      if (h == end || (kLargeGroups && end - h > Groups::kSearched)) {
        h = find_elsewhere(low, high);
        break;
      }
      if (to_[h] == high) break;
      if (to_[h] == kNone) {
        make_edge(h, low, high);
        break;
      }
    }
    return h + Index{from > to};
  }

  /// Writes that `h` is a side of `f`. Returns 1 if it is one of another face already.
  Index take(Index h, Index f) {
    const Index clash = Index{face_[h] != kNone};
    face_[h] = f;
    return clash;
  }

  /// Writes that `h` comes after `before`.
  void link(Index before, Index h) {
    next_[before] = h;
    if constexpr (kPrev) prev_[h] = before;
  }

  /// Calls `visit` with the first word in each array of the group of `low`.
  template <class Visit>
  [[gnu::always_inline]] void visit_group(Index low, const Visit& visit) const {
    visit_words(groups_[low], visit);
  }
  /// The same for groups without halfedges, too: words behind the arrays aren't visited.
  template <class Visit>
  [[gnu::always_inline]] void visit_group_within(Index low, const Visit& visit) const {
    visit_words(std::min(groups_[low], groups_end_ - 1), visit);
  }

  /// Where the group of a vertex begins, and the arrays, in which a group that was not cleared yet
  /// can hold something else.
  [[nodiscard]] Index group(std::size_t vertex) const { return groups_[vertex]; }
  [[nodiscard]] Index* next() const { return next_; }
  [[nodiscard]] Index* to_vertex() const { return to_; }
  [[nodiscard]] Index* face() const { return face_; }

 private:
  template <class Visit>
  [[gnu::always_inline]] void visit_words(Index h, const Visit& visit) const {
    for (const Index* array : {to_, face_, next_}) visit(array + h);
    if constexpr (kPrev) visit(prev_ + h);
  }

  // ---- the arrays

  [[nodiscard]] auto halfedge_arrays() const {
    if constexpr (kPrev) {
      return std::array{&links_.next, &links_.to_vertex, &links_.face, &links_.prev};
    } else {
      return std::array{&links_.next, &links_.to_vertex, &links_.face};
    }
  }

  // There is an edge for each side that runs up, and for each that runs down.
  [[nodiscard]] std::uint64_t certain_halfedges() const {
    return std::max<std::uint64_t>(groups_end_,
                                   2 * std::uint64_t{polygons_.corners.size()} - groups_end_);
  }

  // Room for the edges that there must be. A mesh that lacks it gets a little more, so that a few
  // boundary loops cost no reallocation; end() gives back what isn't used.
  [[nodiscard]] bool reserve() {
    std::size_t count = std::size_t(certain_halfedges());
    for (const Array<Index>* array : halfedge_arrays()) is_fresh_ |= array->capacity() < count;
    if (is_fresh_) count += 4 * std::size_t(std::sqrt(double(count))) + 64;
    for (Array<Index>* array : halfedge_arrays()) {
      if (!array->recreate(std::max(count, array->capacity()))) return false;
    }
    use_arrays();
    return links_.face_halfedge.recreate(polygons_.face_count()) &&
           (!kLargeGroups || large_.resize(large_slots(), kNone));
  }

  // Twice the edges of large groups, if that fits in the memory that positions take later: as a
  // rule four slots to a vertex, which leaves a quarter of them empty at the least.
  [[nodiscard]] std::size_t large_slots() const {
    const std::size_t edges = in_large_ / 2;
    const std::size_t fitting = 4 * polygons_.vertex_count();
    return std::max(edges + edges / 3, std::min(2 * edges, fitting));
  }

  // Makes room for more of the edges that couldn't be foreseen.
  [[nodiscard]] bool grow() {
    is_fresh_ = true;
    const std::size_t count = capacity_ + capacity_ / 8 + 64;
    bool fits = true;
    for (Array<Index>* array : halfedge_arrays()) {
      fits = fits && array->resize(std::max(count, array->size()));
    }
    use_arrays();  // also where it doesn't fit: some have moved, and the faces that are left follow
    return fits;
  }

  void use_arrays() {
    next_ = links_.next.data();
    prev_ = links_.prev.data();
    to_ = links_.to_vertex.data();
    face_ = links_.face.data();
    capacity_ = links_.next.size();
    for (const Array<Index>* array : halfedge_arrays()) {
      capacity_ = std::min(capacity_, array->size());
    }
  }

  // ---- the edges

  void make_edge(Index h, Index low, Index high) {
    to_[h] = high;
    to_[h + 1] = low;
    face_[h] = face_[h + 1] = kNone;
  }

  [[gnu::noinline]] Index find_elsewhere(Index low, Index high) {
    if constexpr (kLargeGroups) {
      if (groups_[low + 1] - groups_[low] > Groups::kSearched) {
        Index& slot = EdgeTable(large_.span()).slot(low, high, to_);
        if (slot == kNone) slot = take_from_group(low, high);
        if (slot != kNone) return slot;
      }
    }
    return find_unforeseen(low, high);
  }

  // The next free edge of a large group, or kNone. How far the group is used is written where its
  // last edge will have its smaller vertex.
  Index take_from_group(Index low, Index high) {
    const Index end = groups_[low + 1];
    if (to_[end - 2] != kNone) return kNone;
    Index& used = to_[end - 1];
    const Index h = used == kNone ? groups_[low] : used;
    used = h + 2;
    make_edge(h, low, high);
    return h;
  }

  // An edge for which the group of `low` has no room.
  Index find_unforeseen(Index low, Index high) {
    if (!unforeseen_.empty()) {
      const Index known = EdgeTable(unforeseen_.span()).slot(low, high, to_);
      if (known != kNone) return known;
    }
    if (failure_ != ConnectResult::kDone || !make_room()) return 0;
    const Index h = used_;
    used_ += 2;
    EdgeTable(unforeseen_.span()).slot(low, high, to_) = h;
    make_edge(h, low, high);
    return h;
  }

  // Room for one more of these. False, with a reason in failure_, where there is none.
  [[nodiscard]] bool make_room() {
    if (used_ + std::size_t{2} > kMaxSlots) {
      failure_ = ConnectResult::kTooLarge;
    } else if ((used_ + std::size_t{2} > capacity_ && !grow()) ||
               (used_ - groups_end_ >= unforeseen_.size() && !enlarge_table())) {
      failure_ = ConnectResult::kOutOfMemory;
    }
    return failure_ == ConnectResult::kDone;
  }

  [[nodiscard]] bool enlarge_table() {
    Array<Index> larger;
    if (!larger.resize(std::max<std::size_t>(64, 2 * unforeseen_.size()), kNone)) return false;
    for (Index h = groups_end_; h < used_; h += 2) {
      EdgeTable(larger.span()).slot(to_[h + 1], to_[h], to_) = h;
    }
    unforeseen_ = std::move(larger);
    return true;
  }

  const Polygons& polygons_;
  const Index* groups_;
  Index groups_end_;
  Index in_large_;
  Index used_;  // halfedges so far, those of all groups from the start
  Links& links_;
  Index* next_ = nullptr;
  Index* prev_ = nullptr;
  Index* to_ = nullptr;
  Index* face_ = nullptr;
  std::size_t capacity_ = 0;
  bool is_fresh_ = false;
  Array<Index> large_;  // the slots of the two tables
  Array<Index> unforeseen_;
  ConnectResult failure_ = ConnectResult::kDone;
};

}  // namespace halfedge
