#include <halfedge/build/connect_scattered.h>
#include <halfedge/build/grouped_edges.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace halfedge {

namespace {

// With fewer vertices the groups stay in the cache, or near enough to be fetched in time.
constexpr std::size_t kScattered = 150'000;
constexpr std::size_t kBlock = std::size_t{1} << kBlockBits;

// So many runs of so many triangles tell whether all are scattered. In runs, since their order may
// have a rhythm, such as the four parts of each triangle that was divided.
constexpr std::size_t kRuns = 64;
constexpr std::size_t kRun = 16;

// The corners of so many triangles are fetched at once, or so many triangles ahead.
constexpr std::size_t kFetched = 32;

bool share_a_vertex(const Index* a, const Index* b) {
  bool shared = false;
  for (int i = 0; i < 3; ++i) shared |= a[i] == b[0] || a[i] == b[1] || a[i] == b[2];
  return shared;
}

// The triangles are taken in blocks of vertices with consecutive numbers, from the last block to
// the first. The groups of one block fit into the cache.
//
// Two sides of a triangle have their edges in the group of its smallest vertex. The third, its *far
// side*, has its edge in the group of its middle one, in a block that comes no later. So a triangle
// is met twice: in the block of its middle vertex, where the far side is found, and in that of its
// smallest, where the others are, and all three are joined.
//
// In between it waits where the groups of the smallest vertex's block will be, which are empty as
// yet. There is room for it: one of the two sides at the smallest vertex runs up, so that its group
// has two halfedges for this triangle alone.
template <bool kPrev>
class BlockConnector {
 public:
  BlockConnector(const Polygons& triangles, const Groups& groups, Links& links, int block_bits)
      : corners_(triangles.corners.data()),
        faces_(Index(triangles.face_count())),
        vertices_(triangles.vertex_count()),
        block_bits_(block_bits),
        blocks_(block_of(vertices_) + 1),
        links_(links),
        edges_(triangles, groups, links) {}

  ConnectResult run() {
    const ConnectResult begun = edges_.begin();
    if (begun != ConnectResult::kDone) return begun;
    anchors_ = links_.vertex_halfedge.data();
    firsts_ = links_.face_halfedge.data();
    if (!sort_by_middle_vertex()) return ConnectResult::kOutOfMemory;

    for (std::size_t block = blocks_; block-- > 0;) {
      if (!fetch_waiting(block)) return ConnectResult::kOutOfMemory;
      edges_.clear_groups(first_vertex(block), first_vertex(block + 1));
      find_far_sides(block);
      for (const Waiting& triangle : waiting_) join_sides(triangle);
      if (edges_.failure() != ConnectResult::kDone) return edges_.failure();
    }
    return edges_.end(clashes_);
  }

 private:
  // A triangle whose far side is found.
  struct Waiting {
    Index face;
    Index far_side;
    Index from;  // the vertices of the far side
    Index to;
    Index smallest;
    Index turn;  // the corner from which the far side leads: 0, 1 or 2
  };

  [[nodiscard]] std::size_t block_of(std::size_t vertex) const { return vertex >> block_bits_; }
  [[nodiscard]] std::size_t first_vertex(std::size_t block) const {
    return std::min(block << block_bits_, vertices_);
  }

  // Lists the triangles by the block of their middle vertex, and leaves ~(its last triangle) as the
  // anchor of each vertex.
  [[nodiscard]] bool sort_by_middle_vertex() {
    if (!listed_.resize(faces_) || !list_end_.resize(blocks_, 0) || !next_free_.resize(blocks_)) {
      return false;
    }
    std::fill(anchors_, anchors_ + vertices_, kNone);
    for (Index f = 0; f < faces_; ++f) {
      const Index* const corners = corners_of(f);
      ++list_end_[block_of(middle_vertex(corners))];
      for (int i = 0; i < 3; ++i) anchors_[corners[i]] = ~f;
    }
    Index begin = 0;
    for (std::size_t block = 0; block < blocks_; ++block) {
      begin += std::exchange(list_end_[block], begin);
      next_free_[block] = edges_.group(first_vertex(block));
    }
    for (Index f = 0; f < faces_; ++f) {
      listed_[list_end_[block_of(middle_vertex(corners_of(f)))]++] = f;
    }
    return true;
  }

  [[nodiscard]] const Index* corners_of(Index f) const { return corners_ + 3 * std::size_t{f}; }

  // ---- the triangles that wait for a block

  void wait(const Waiting& triangle) {
    Index& next_free = next_free_[block_of(triangle.smallest)];
    const Index h = next_free;
    next_free += 2;
    edges_.next()[h] = triangle.face;
    edges_.next()[h + 1] = triangle.far_side;
    edges_.face()[h] = triangle.from;
    edges_.face()[h + 1] = triangle.to;
    edges_.to_vertex()[h] = triangle.smallest;
    edges_.to_vertex()[h + 1] = triangle.turn;
  }

  // Their place is needed now.
  [[nodiscard]] bool fetch_waiting(std::size_t block) {
    const Index begin = edges_.group(first_vertex(block));
    if (!waiting_.recreate((next_free_[block] - begin) / 2)) return false;
    Index h = begin;
    for (Waiting& triangle : waiting_) {
      triangle = {edges_.next()[h],     edges_.next()[h + 1],  edges_.face()[h],
                  edges_.face()[h + 1], edges_.to_vertex()[h], edges_.to_vertex()[h + 1]};
      h += 2;
    }
    return true;
  }

  // ---- the sides

  void find_far_sides(std::size_t block) {
    const Index* at = listed_.data() + (block == 0 ? 0 : list_end_[block - 1]);
    const Index* const end = listed_.data() + list_end_[block];
    for (; at != end; ++at) {
      fetch_corners(at, end);
      const Index* const corners = corners_of(*at);
      const Index smallest = smallest_vertex(corners);
      const Index turn = smallest == corners[0] ? 1 : smallest == corners[1] ? 2 : 0;
      const Index from = corners[turn];
      const Index to = corners[turn == 2 ? 0 : turn + 1];
      const Index far_side = edges_.find(from, to);
      clashes_ |= edges_.take(far_side, *at);
      const Waiting triangle = {*at, far_side, from, to, smallest, turn};
      if (block_of(smallest) == block) {
        join_sides(triangle);
      } else {
        wait(triangle);
      }
    }
  }

  // They lie in no order: nearly all the time would be spent waiting for them.
  void fetch_corners(const Index* at, const Index* end) const {
    const std::size_t left = std::size_t(end - at);
    if constexpr (kCanPrefetch) {
      prefetch(corners_of(at[std::min(left - 1, kFetched)]));
    } else if (left % kFetched == 0) {
      for (std::size_t i = 0; i < kFetched; ++i) touch(corners_of(at[i]));
    }
  }

  void join_sides(const Waiting& triangle) {
    const Index f = triangle.face;
    const Index far_side = triangle.far_side;
    const Index after = edges_.find(triangle.to, triangle.smallest);
    const Index before = edges_.find(triangle.smallest, triangle.from);
    clashes_ |= edges_.take(after, f);
    clashes_ |= edges_.take(before, f);
    edges_.link(far_side, after);
    edges_.link(after, before);
    edges_.link(before, far_side);
    anchor(triangle.from, far_side, f);
    anchor(triangle.to, after, f);
    anchor(triangle.smallest, before, f);
    firsts_[f] = triangle.turn == 0 ? before : triangle.turn == 1 ? after : far_side;
  }

  void anchor(Index vertex, Index h, Index f) {
    anchors_[vertex] = anchors_[vertex] == ~f ? h : anchors_[vertex];
  }

  const Index* corners_;
  Index faces_;
  std::size_t vertices_;
  int block_bits_;
  std::size_t blocks_;
  Links& links_;
  GroupedEdges<true, kPrev> edges_;
  Index* anchors_ = nullptr;
  Index* firsts_ = nullptr;
  Index clashes_ = 0;
  Array<Index> listed_;     // the triangles, by the block of their middle vertex
  Array<Index> list_end_;   // by block
  Array<Index> next_free_;  // by block: the halfedge in whose place the next triangle will wait
  Array<Waiting> waiting_;  // for the block that is at work
};

}  // namespace

bool are_scattered(const Polygons& triangles, const Groups& groups) {
  const std::size_t vertices = triangles.vertex_count();
  const std::size_t faces = triangles.face_count();
  if (vertices < kScattered || faces <= kRun) return false;
  for (std::size_t v = 0; v < vertices; v += kBlock) {
    const std::size_t end = std::min(v + kBlock, vertices);
    if (groups.begin[end] - groups.begin[v] > vertices / 2) return false;
  }
  std::size_t scattered = 0;
  for (std::size_t run = 0; run < kRuns; ++run) {
    const std::size_t first = std::size_t(run * std::uint64_t{faces - kRun} / kRuns);
    const Index* a = triangles.corners.data() + 3 * first;
    for (std::size_t i = 0; i < kRun; ++i, a += 3) {
      const Index* const b = a + 3;
      scattered += are_near(a[0], b[0]) || share_a_vertex(a, b) ? 0 : 1;
    }
  }
  return scattered > kRuns * kRun / 2;
}

template <bool kPrev>
ConnectResult connect_scattered(const Polygons& triangles, const Groups& groups, Links& links,
                                int block_bits) {
  return BlockConnector<kPrev>(triangles, groups, links, block_bits).run();
}

template ConnectResult connect_scattered<true>(const Polygons& triangles, const Groups& groups,
                                               Links& links, int block_bits);
template ConnectResult connect_scattered<false>(const Polygons& triangles, const Groups& groups,
                                                Links& links, int block_bits);

}  // namespace halfedge
