#include <halfedge/sentence.h>
#include <halfedge/validate/checker.h>

namespace halfedge {

template <class Mesh>
void OrbitChecker<Mesh>::check_vertex_orbits() {
  Index reached = 0;
  for (const Vertex v : mesh_.vertices()) reached += mesh_.valence(v);
  if (reached == mesh_.halfedge_count()) return;

  Array<bool> seen;
  if (!has_memory(seen.resize(mesh_.halfedge_slots(), false), "vertex orbits")) return;
  for (const Vertex v : mesh_.vertices()) {
    for (const Halfedge h : mesh_.outgoing_cw(v)) seen[h.index()] = true;
  }
  for (const Halfedge h : mesh_.halfedges()) {
    if (seen[h.index()]) continue;
    const Vertex v = mesh_.from_vertex(h);
    report(Rule::kUnreachableHalfedge, h, [&] {
      return sentence::of("{} leaves {}, but is not reached by rotating from its anchor, {}", h, v,
                          mesh_.vertex_halfedge(v));
    });
  }
}

template <class Mesh>
void OrbitChecker<Mesh>::check_face_loops() {
  Index reached = 0;
  for (const Face f : mesh_.faces()) reached += mesh_.degree(f);
  for (const Halfedge h : mesh_.halfedges()) reached += mesh_.is_boundary(h) ? 1U : 0U;
  if (reached == mesh_.halfedge_count()) return;

  Array<bool> seen;
  if (!has_memory(seen.resize(mesh_.halfedge_slots(), false), "face loops")) return;
  const auto see_loop = [&](Halfedge first) {
    for (const Halfedge h : mesh_.loop_ccw(first)) seen[h.index()] = true;
  };
  for (const Face f : mesh_.faces()) see_loop(mesh_.face_halfedge(f));
  for (const Halfedge h : mesh_.halfedges()) {
    if (mesh_.is_boundary(h) || seen[h.index()]) continue;
    see_loop(h);
    report(Rule::kFaceWithManyLoops, mesh_.face(h), [&] {
      return sentence::of("{} has a second loop, through {}, beside that of its halfedge, {}",
                          mesh_.face(h), h, mesh_.face_halfedge(mesh_.face(h)));
    });
  }
}

template <class Mesh>
void OrbitChecker<Mesh>::check_boundary() {
  check_boundary_anchors();
  for (const Edge e : mesh_.edges()) {
    if (!mesh_.is_boundary(mesh_.edge_halfedge(e, 0)) ||
        !mesh_.is_boundary(mesh_.edge_halfedge(e, 1))) {
      continue;
    }
    report(Rule::kEdgeWithoutFace, e,
           [&] { return sentence::of("{} has no face on either side, expected one at least", e); });
  }
}

template <class Mesh>
void OrbitChecker<Mesh>::check_boundary_anchors() {
  bool all_right = true;
  for (const Halfedge h : mesh_.halfedges()) {
    all_right = all_right && (!mesh_.is_boundary(h) || mesh_.is_boundary(mesh_.from_vertex(h)));
  }
  if (all_right) return;
  for (const Vertex v : mesh_.vertices()) {
    if (mesh_.is_boundary(v)) continue;
    for (const Halfedge h : mesh_.outgoing_cw(v)) {
      if (!mesh_.is_boundary(h)) continue;
      report(Rule::kInteriorAnchor, v, [&] {
        return sentence::of(
            "the anchor of {} is {}, which has a face, although the boundary halfedge {} leaves it",
            v, mesh_.vertex_halfedge(v), h.index());
      });
      break;
    }
  }
}

template class OrbitChecker<Connectivity>;
template class OrbitChecker<BasicConnectivity<kPrevAtRunTime>>;

}  // namespace halfedge
