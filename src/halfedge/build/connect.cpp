#include <halfedge/build/connect.h>
#include <halfedge/build/connect_scattered.h>
#include <halfedge/build/fans.h>
#include <halfedge/build/grouped_edges.h>
#include <halfedge/build/groups.h>
#include <halfedge/inlining.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace halfedge {

namespace {

// Groups are fetched into the cache so many corners before they are needed.
constexpr std::size_t kAhead = 48;
// Where there is no instruction for that, the groups of so many corners are touched in one go,
// unless their first vertex and the one after the last are near by number: then they are in the
// cache.
constexpr std::size_t kTouched = 48;

// Connects the faces one after the other, by finding the edge of each of their sides.
template <bool kTriangles, bool kLargeGroups, bool kPrev>
class FaceConnector {
 public:
  FaceConnector(const Polygons& polygons, const Groups& groups, Links& links)
      : polygons_(polygons), links_(links), edges_(polygons, groups, links) {}

  // Inlined, all instances of it take half as much code again; not inlined, g++ takes 3 % more
  // instructions.
  HALFEDGE_NOINLINE_IN_WASM ConnectResult run() {
    const ConnectResult begun = edges_.begin();
    if (begun != ConnectResult::kDone) return begun;
    edges_.clear_groups(0, polygons_.vertex_count());

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
      const Index first = edges_.find(corners[size - 1], corners[0]);
      Index before = first;
      for (Index i = 0; i + 1 < size; ++i) {
        const Index h = edges_.find(corners[i], corners[i + 1]);
        anchors[corners[i]] = h;
        clashes |= edges_.take(h, f);
        edges_.link(before, h);
        before = h;
      }
      anchors[corners[size - 1]] = first;
      clashes |= edges_.take(first, f);
      edges_.link(before, first);
      firsts[f] = first;
    });
    return edges_.end(clashes);
  }

 private:
  // Where vertices are in no order, nearly all the time is spent waiting for the lines of a group.
  // Two sides of a triangle have their edges in the group of its smallest vertex.
  template <class Size>
  [[gnu::always_inline]] void prefetch_groups(const Index* corners, Size size) const {
    const auto fetch = [](const Index* word) __attribute__((always_inline)) { prefetch(word); };
    const std::size_t before = std::size_t(corners - polygons_.corners.data());
    if (polygons_.corners.size() - before < kAhead + size) return;
    const Index* const ahead = corners + kAhead;
    if constexpr (kTriangles) {
      edges_.visit_group(smallest_vertex(ahead), fetch);
      edges_.visit_group(middle_vertex(ahead), fetch);
    } else {
      for (Index i = 0; i < size; ++i) {
        edges_.visit_group(std::min(ahead[i], ahead[i + 1 == size ? 0 : i + 1]), fetch);
      }
    }
  }

  // The same without an instruction for it, for the next kTouched corners. Larger faces are not
  // told apart: for the side that leads from a last corner to a first, one to the next face is
  // taken.
  HALFEDGE_NOINLINE void touch_groups(const Index* corners) const {
    const auto fetch = [](const Index* word) { touch(word); };
    const std::size_t before = std::size_t(corners - polygons_.corners.data());
    if (polygons_.corners.size() - before <= kTouched) return;
    if (are_near(corners[0], corners[kTouched])) return;
    if constexpr (kTriangles) {
      for (std::size_t i = 0; i < kTouched; i += 3) {
        edges_.visit_group_within(smallest_vertex(corners + i), fetch);
        edges_.visit_group_within(middle_vertex(corners + i), fetch);
      }
    } else {
      for (std::size_t i = 0; i < kTouched; ++i) {
        edges_.visit_group_within(std::min(corners[i], corners[i + 1]), fetch);
      }
    }
  }

  const Polygons& polygons_;
  Links& links_;
  GroupedEdges<kLargeGroups, kPrev> edges_;
};

template <bool kTriangles, bool kPrev>
ConnectResult connect_faces(const Polygons& polygons, Links& links) {
  Groups groups;
  bool repeated = false;
  if (!count_groups<kTriangles>(polygons, links.vertex_halfedge, groups, repeated)) {
    return ConnectResult::kOutOfMemory;
  }
  if (repeated) return ConnectResult::kNotManifold;
  if constexpr (kTriangles) {
    if (are_scattered(polygons, groups)) return connect_scattered<kPrev>(polygons, groups, links);
  }
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
