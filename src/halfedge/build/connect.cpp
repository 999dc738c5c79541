#include <halfedge/build/connect.h>
#include <halfedge/build/edge_table.h>
#include <halfedge/build/fans.h>
#include <halfedge/build/groups.h>
#include <halfedge/inlining.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace halfedge {

namespace {

// Groups are fetched into the cache so many corners before they are needed.
constexpr std::size_t kAhead = 48;
// Where there is no instruction for that, the groups of so many corners are touched in one go,
// unless their first vertex and the one after the last are as near by number: then they are in the
// cache.
constexpr std::size_t kTouched = 48;
constexpr Index kNearby = 2048;

// Connects the faces one after the other, by finding the edge of each of their sides.
//
// The group of a vertex is also the place to look for its edges: `to_vertex` of their even
// halfedges, up to the first that is still empty. There are three to a group on average. Hash
// tables help with what a group doesn't show:
//   - the edges of large groups, around vertices of high valence;
//   - edges for which a group has no room: as many as there are boundary edges whose only side runs
//     down. They can't be foreseen, so they are numbered after all groups, and their table grows.
template <bool kTriangles, bool kLargeGroups, bool kPrev>
class FaceConnector {
 public:
  FaceConnector(const Polygons& polygons, const Groups& groups, Links& links)
      : polygons_(polygons),
        groups_(groups.begin.data()),
        groups_end_(groups.end()),
        in_large_(groups.in_large),
        used_(groups.end()),
        links_(links) {}

  // Inlined, all instances of it take half as much code again; not inlined, g++ takes 3 % more
  // instructions.
  HALFEDGE_NOINLINE_IN_WASM ConnectResult run() {
    if (certain_halfedges() > kMaxSlots) return ConnectResult::kTooLarge;
    if (!reserve()) return ConnectResult::kOutOfMemory;
    std::fill(to_, to_ + groups_end_, kNone);

    Index* const anchors = links_.vertex_halfedge.data();
    Index* const firsts = links_.face_halfedge.data();
    std::fill(anchors, anchors + links_.vertex_halfedge.size(), kNone);
    Index clashes = 0;
    [[maybe_unused]] const Index* touched = polygons_.corners.data();
    for_each_face<kTriangles>(polygons_, [&](Index f, const Index* corners, auto size) {
      if constexpr (kCanPrefetch) {
        prefetch_groups(corners, size);
      } else if (corners >= touched) {
        touch_groups(corners);
        touched = corners + kTouched;
      }
      const Index first = find_halfedge(corners[size - 1], corners[0]);
      Index before = first;
      for (Index i = 0; i + 1 < size; ++i) {
        const Index h = find_halfedge(corners[i], corners[i + 1]);
        anchors[corners[i]] = h;
        clashes |= join(before, h, f);
        before = h;
      }
      anchors[corners[size - 1]] = first;
      clashes |= join(before, first, f);
      firsts[f] = first;
    });
    if (failure_ != ConnectResult::kDone) return failure_;
    if (clashes != 0) return ConnectResult::kNotManifold;
    trim();
    return ConnectResult::kDone;
  }

 private:
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
  // boundary loops cost no reallocation; trim() gives back what isn't used.
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

  void trim() {
    for (Array<Index>* array : halfedge_arrays()) {
      (void)array->resize(used_);  // no larger than it is
      if (is_fresh_) array->shrink_to_fit();
    }
  }

  // ---- the faces

  // Writes that `h`, a side of `f`, follows `before`. Returns 1 if another face has that side.
  Index join(Index before, Index h, Index f) {
    const Index clash = Index{face_[h] != kNone};
    face_[h] = f;
    next_[before] = h;
    if constexpr (kPrev) prev_[h] = before;
    return clash;
  }

  // Where vertices are in no order, nearly all the time is spent waiting for the lines of a group.
  // Two sides of a triangle have their edges in the group of its smallest vertex.
  template <class Size>
  [[gnu::always_inline]] void prefetch_groups(const Index* corners, Size size) const {
    const std::size_t before = std::size_t(corners - polygons_.corners.data());
    if (polygons_.corners.size() - before < kAhead + size) return;
    const Index* const ahead = corners + kAhead;
    if constexpr (kTriangles) {
      const Index low = std::min(ahead[0], ahead[1]);
      const Index high = std::max(ahead[0], ahead[1]);
      prefetch_group(std::min(low, ahead[2]));
      prefetch_group(std::max(low, std::min(high, ahead[2])));
    } else {
      for (Index i = 0; i < size; ++i) {
        prefetch_group(std::min(ahead[i], ahead[i + 1 == size ? 0 : i + 1]));
      }
    }
  }

  [[gnu::always_inline]] void prefetch_group(Index low) const {
    const Index begin = groups_[low];
    for (const Index* array : {to_, face_, next_}) prefetch(array + begin);
    if constexpr (kPrev) prefetch(prev_ + begin);
  }

  // The same without an instruction for it, for the next kTouched corners. Larger faces are not
  // told apart: for the side that leads from a last corner to a first, one to the next face is
  // taken.
  HALFEDGE_NOINLINE void touch_groups(const Index* corners) const {
    const std::size_t before = std::size_t(corners - polygons_.corners.data());
    if (polygons_.corners.size() - before <= kTouched) return;
    if (corners[0] - corners[kTouched] + kNearby < 2 * kNearby) return;
    if constexpr (kTriangles) {
      for (std::size_t i = 0; i < kTouched; i += 3) {
        const Index low = std::min(corners[i], corners[i + 1]);
        const Index high = std::max(corners[i], corners[i + 1]);
        touch_group(std::min(low, corners[i + 2]));
        touch_group(std::max(low, std::min(high, corners[i + 2])));
      }
    } else {
      for (std::size_t i = 0; i < kTouched; ++i) {
        touch_group(std::min(corners[i], corners[i + 1]));
      }
    }
  }

  [[gnu::always_inline]] void touch_group(Index low) const {
    const Index begin = std::min(groups_[low], groups_end_ - 1);
    for (const Index* array : {to_, face_, next_}) touch(array + begin);
    if constexpr (kPrev) touch(prev_ + begin);
  }

  // ---- the edges

  // The halfedge from `from` to `to`, made if need be.
  Index find_halfedge(Index from, Index to) {
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

template <bool kTriangles, bool kPrev>
ConnectResult connect_faces(const Polygons& polygons, Links& links) {
  Groups groups;
  bool repeated = false;
  if (!count_groups<kTriangles>(polygons, links.vertex_halfedge, groups, repeated)) {
    return ConnectResult::kOutOfMemory;
  }
  if (repeated) return ConnectResult::kNotManifold;
  if (groups.in_large == 0) {
    return FaceConnector<kTriangles, false, kPrev>(polygons, groups, links).run();
  }
  return FaceConnector<kTriangles, true, kPrev>(polygons, groups, links).run();
}

bool all_triangles(std::span<const Index> sizes) {
  Index different = 0;
  for (const Index size : sizes) different |= size ^ 3U;
  return different == 0;
}

}  // namespace

template <bool kPrev>
ConnectResult connect(const Polygons& polygons, Links& links) {
  const ConnectResult result = all_triangles(polygons.sizes)
                                   ? connect_faces<true, kPrev>(polygons, links)
                                   : connect_faces<false, kPrev>(polygons, links);
  if (result != ConnectResult::kDone) return result;
  const bool is_closed = links.next.size() == polygons.corners.size();
  if (!is_closed && !join_open_fans(links)) return ConnectResult::kOutOfMemory;
  if (!each_vertex_has_one_cycle(links)) return ConnectResult::kNotManifold;
  return ConnectResult::kDone;
}

template ConnectResult connect<true>(const Polygons& polygons, Links& links);
template ConnectResult connect<false>(const Polygons& polygons, Links& links);

}  // namespace halfedge
