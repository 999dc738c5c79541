#include <halfedge/operations/face_plan.h>
#include <halfedge/operations/surgery_refusals.h>
#include <halfedge/refusals.h>

#include <algorithm>
#include <array>

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
  const auto no_memory = [] { return refusals::no_memory("the triangles"); };
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

namespace {

bool has(std::span<const Face> faces, Face f) {
  return std::find(faces.begin(), faces.end(), f) != faces.end();
}

/// Plans these faces, then all others. `blocked` becomes the first that can't be cut.
Result<void> plan_in_order(const Links& links, std::span<const float> positions,
                           std::span<const Face> before_others, FacePlan& plan, Face& blocked) {
  const auto add = [&](Face f) {
    const Halfedge first(links.face_halfedge[f.index()]);
    Result<void> can = plan.add(links, positions, first, true);
    if (!can) blocked = f;
    return can;
  };
  for (const Face f : before_others) {
    if (Result<void> can = add(f); !can) return can;
  }
  const Index slots = Index(links.face_halfedge.size());
  for (Face f(0); f.index() < slots; f = Face(f.index() + 1)) {
    if (is_deleted_link(links.face_halfedge[f.index()]) || has(before_others, f)) continue;
    if (Result<void> can = add(f); !can) return can;
  }
  return {};
}

}  // namespace

Result<void> plan_all(const Links& links, std::span<const float> positions, FacePlan& plan) {
  constexpr std::size_t kMostFirst = 16;
  std::array<Face, kMostFirst> last_blocked;  // the last one at the front
  for (std::size_t tries = 0;; ++tries) {
    const std::span<const Face> before_others = std::span(last_blocked).last(tries);
    Face blocked;
    plan = FacePlan();
    Result<void> can = plan_in_order(links, positions, before_others, plan, blocked);
    if (can || tries == kMostFirst || can.error().code != "no-triangulation" ||
        has(before_others, blocked)) {
      return can;
    }
    last_blocked[kMostFirst - tries - 1] = blocked;
  }
}

}  // namespace halfedge::operations::internal
