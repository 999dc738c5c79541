#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/connectivity.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace halfedge {

enum class SweepResult : std::uint8_t { kDone, kNotManifold, kTooLarge, kOutOfMemory };

/// Fills the links of a mesh from the corners of its faces, vertex by vertex in index order.
///
/// All links at a vertex v join two of its edges: a face with the corner p, v, n says that
/// next(p -> v) is v -> n. So once the halfedges v -> x of v are known by x, its corners can be
/// written down in any order. An edge is made, and numbered, by its smaller vertex; until the
/// larger one is visited, `next` of side 0 (which is written by the larger) holds the chain of
/// edges that wait for it. `halfedge_to[x]` is v -> x during the visit of v, and the head of
/// that chain for every x still to come.
///
/// No hash, no sort, and nothing but one index for each vertex that doesn't live in the arrays to
/// be filled.
template <class Corners>
class Sweep {
 public:
  Sweep(Links& links, const Polygons& polygons, const Corners& corners)
      : links_(links),
        in_(polygons.corners.data()),
        corner_count_(polygons.corners.size()),
        face_count_(polygons.face_count()),
        vertex_count_(polygons.vertex_count()),
        corners_(corners) {}

  SweepResult run() {
    if (!allocate()) return SweepResult::kOutOfMemory;
    if (!sort_corners()) return SweepResult::kNotManifold;
    std::size_t begin = 0;
    for (std::size_t v = 0; v < vertex_count_; ++v) {
      const std::size_t end = links_.vertex_halfedge[v];
      const SweepResult visited = visit(Index(v), begin, end);
      if (visited != SweepResult::kDone) return visited;
      begin = end;
    }
    return finish();
  }

 private:
  [[nodiscard]] bool allocate() {
    return links_.vertex_halfedge.recreate(vertex_count_) &&
           links_.face_halfedge.recreate(face_count_) && links_.prev.recreate(corner_count_) &&
           halfedge_to_.recreate(vertex_count_) && ensure_halfedges(corner_count_);
  }

  [[nodiscard]] bool ensure_halfedges(std::size_t count) {
    if (count <= links_.next.size()) return true;
    return links_.next.resize(count) && links_.to_vertex.resize(count) && links_.face.resize(count);
  }

  // The corners grouped by vertex, in `prev`; where a vertex's group ends, in its anchor. False if
  // a face has the same vertex twice in a row.
  [[nodiscard]] bool sort_corners() {
    Array<Index>& ends = links_.vertex_halfedge;
    std::fill(ends.begin(), ends.end(), 0U);
    bool repeated = false;
    for (std::size_t c = 0; c < corner_count_; ++c) {
      ++ends[in_[c]];
      repeated |= in_[c] == in_[corners_.next(Index(c))];
    }
    Index sum = 0;
    for (Index& end : ends) {
      const Index count = end;
      end = sum;
      sum += count;
    }
    for (std::size_t c = 0; c < corner_count_; ++c) links_.prev[ends[in_[c]]++] = Index(c);
    std::fill(halfedge_to_.begin(), halfedge_to_.end(), kNone);
    return !repeated;
  }

  SweepResult visit(Index v, std::size_t begin, std::size_t end) {
    links_.vertex_halfedge[v] = kNone;
    if (begin == end) return SweepResult::kDone;
    take_waiting_edges(v);

    const Index first_new = 2 * edge_count_;
    Index last_face = kNone;
    for (std::size_t i = begin; i < end; ++i) {
      const Index c = links_.prev[i];
      const Index f = corners_.face(c);
      if (f == last_face) return SweepResult::kNotManifold;
      last_face = f;
      const Index n = in_[corners_.next(c)];
      const Index p = in_[corners_.prev(c)];
      for (const Index x : {n, p}) {
        const SweepResult made = make_edge(v, x, first_new);
        if (made != SweepResult::kDone) return made;
      }
      const Index out = halfedge_to_[n];
      const Index in = halfedge_to_[p] ^ 1U;
      if (links_.face[out] != kNone || links_.next[in] != kNone) return SweepResult::kNotManifold;
      links_.face[out] = f;
      links_.next[in] = out;
      if (corners_.is_first(c)) links_.face_halfedge[f] = in;
      links_.vertex_halfedge[v] = out;
    }

    const std::size_t valence = end - begin;
    if (lap_length(links_.vertex_halfedge[v], valence) == valence) return SweepResult::kDone;
    return join_fans(v, begin, end);
  }

  // Lets halfedge_to_ lead to the smaller neighbours of `v`.
  void take_waiting_edges(Index v) {
    for (Index h = halfedge_to_[v]; h != kNone;) {
      const Index waiting = links_.next[h];
      links_.next[h] = kNone;
      halfedge_to_[links_.to_vertex[h ^ 1U]] = h ^ 1U;
      h = waiting;
    }
  }

  // The edge v-x, unless this visit (edges from first_new on) or that of x has made it already.
  SweepResult make_edge(Index v, Index x, Index first_new) {
    const Index known = halfedge_to_[x];
    if (x < v || (known != kNone && known >= first_new)) return SweepResult::kDone;
    const Index h = 2 * edge_count_;
    if (h + 2 > links_.next.size()) {
      const std::size_t grown = std::min<std::size_t>(h + h / 8 + 64, 2 * corner_count_);
      if (h + 2 > kMaxSlots) return SweepResult::kTooLarge;
      if (!ensure_halfedges(grown)) return SweepResult::kOutOfMemory;
    }
    ++edge_count_;
    links_.next[h] = known;  // joins the chain of x
    links_.next[h + 1] = kNone;
    links_.to_vertex[h] = x;
    links_.to_vertex[h + 1] = v;
    links_.face[h] = links_.face[h + 1] = kNone;
    halfedge_to_[x] = h;
    return SweepResult::kDone;
  }

  // The number of halfedges passed in turning clockwise from `first` until it comes back; 0 if it
  // meets the boundary, or isn't back after `limit`.
  [[nodiscard]] std::size_t lap_length(Index first, std::size_t limit) const {
    Index h = first;
    for (std::size_t steps = 1; steps <= limit; ++steps) {
      h = links_.next[h ^ 1U];
      if (h == first) return steps;
      if (h == kNone) return 0;
    }
    return 0;
  }

  // Links the boundary halfedges at `v`, whose corners don't form one closed fan: the fans in the
  // order of the vertices that their outgoing boundary halfedges lead to.
  SweepResult join_fans(Index v, std::size_t begin, std::size_t end) {
    Array<Index>& starts = fan_starts_;
    starts.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const Index p = in_[corners_.prev(links_.prev[i])];
      if (links_.face[halfedge_to_[p]] == kNone && !starts.push_back(p)) {
        return SweepResult::kOutOfMemory;
      }
    }
    std::sort(starts.begin(), starts.end());
    std::size_t turned = 0;
    Index last_in = kNone;
    for (const Index start : starts) {
      const Index first = halfedge_to_[start];
      if (last_in != kNone) links_.next[last_in] = first;
      Index h = first;
      for (; links_.next[h ^ 1U] != kNone; ++turned) h = links_.next[h ^ 1U];
      last_in = h ^ 1U;
    }
    if (turned != end - begin) return SweepResult::kNotManifold;  // there is a closed fan besides
    links_.vertex_halfedge[v] = halfedge_to_[starts[0]];
    links_.next[last_in] = links_.vertex_halfedge[v];
    return SweepResult::kDone;
  }

  SweepResult finish() {
    const std::size_t count = 2 * std::size_t{edge_count_};
    if (!links_.prev.recreate(count)) return SweepResult::kOutOfMemory;
    for (Array<Index>* array : {&links_.next, &links_.to_vertex, &links_.face}) {
      if (!array->resize(count)) return SweepResult::kOutOfMemory;
      array->shrink_to_fit();
    }
    for (std::size_t h = 0; h < count; ++h) links_.prev[links_.next[h]] = Index(h);
    return SweepResult::kDone;
  }

  Links& links_;
  Array<Index> halfedge_to_;
  Array<Index> fan_starts_;
  const Index* in_;
  std::size_t corner_count_;
  std::size_t face_count_;
  std::size_t vertex_count_;
  const Corners& corners_;
  Index edge_count_ = 0;
};

}  // namespace halfedge
