#include <halfedge/decorator/refusal.h>
#include <halfedge/operations/face_plan.h>
#include <halfedge/operations/surgery_refusals.h>

#include <algorithm>

namespace halfedge::operations::internal {

// Around both in step, so that a vertex of high valence costs no more than the other one.
Edge find_edge(const Links& links, Vertex a, Vertex b) {
  const Index first_of_a = links.vertex_halfedge[a.index()];
  const Index first_of_b = links.vertex_halfedge[b.index()];
  Index from_a = first_of_a;
  Index from_b = first_of_b;
  do {
    if (links.to_vertex[from_a] == b.index()) return Edge(from_a / 2);
    if (links.to_vertex[from_b] == a.index()) return Edge(from_b / 2);
    from_a = links.next[from_a ^ 1U];
    from_b = links.next[from_b ^ 1U];
  } while (from_a != first_of_a && from_b != first_of_b);
  return {};
}

Result<void> FacePlan::add(const Links& links, std::span<const float> positions, Halfedge first,
                           bool has_others) {
  const auto no_memory = [] { return decorator::internal::no_memory("the triangles"); };
  corners_.clear();
  points_.clear();
  Index h = first.index();
  do {
    const Index v = links.to_vertex[h];
    const std::size_t at = 3 * std::size_t{v};
    const Point point =
        positions.empty() ? Point{} : Point{positions[at], positions[at + 1], positions[at + 2]};
    if (!corners_.push_back(Vertex(v)) || !points_.push_back(point)) return no_memory();
    h = links.next[h];
  } while (h != first.index());
  largest_ = std::max(largest_, corners_.size());
  if (corners_.size() <= 3) return {};  // degenerate complexes have faces of fewer corners
  if (!loops_.push_back(first)) return no_memory();

  const auto is_edge = [&links](Vertex a, Vertex b) { return find_edge(links, a, b).valid(); };
  switch (cutter_.cut(corners_.span(), points_.span(), is_edge, ears_)) {
    case PolygonCutter::Outcome::kDone:
      return !has_others || cutter_.keep_diagonals(corners_.span()) ? Result<void>() : no_memory();
    case PolygonCutter::Outcome::kBlocked: {
      const Vertex a = corners_[cutter_.blocked().a];
      const Vertex b = corners_[cutter_.blocked().b];
      return no_triangulation(Face(links.face[first.index()]), a, b, find_edge(links, a, b));
    }
    case PolygonCutter::Outcome::kOutOfMemory:
      break;
  }
  return no_memory();
}

}  // namespace halfedge::operations::internal
