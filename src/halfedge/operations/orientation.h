#pragma once

#include <halfedge/decorator/components.h>
#include <halfedge/decorator/order.h>
#include <halfedge/operations/requirements.h>

namespace halfedge::operations {

/// Reverses all orientations: each face, and each boundary loop, runs the other way, so that the
/// normal of a face points to its other side. (CGAL: reverse_face_orientations)
///
/// attributes: of halfedges, those of a corner (which interpolate) go to the halfedge that ends
///             there now; all others stay. Normals aren't turned around.
/// cost: O(slots), one byte for each halfedge slot. inverse: itself, exactly
/// errors: out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<void> reverse(Mesh& mesh) {
  return decorator::inside_out(mesh);
}

namespace internal {

/// Turns over whole components, of which these are the edges. pre: `seen` is false for each
/// halfedge slot
template <class Mesh, class Edges>
void reverse_edges(Mesh& mesh, const Edges& edges, Array<bool>& seen) {
  for (const Edge e : edges) {
    for (const Index side : {0U, 1U}) {
      const Halfedge anchor = mesh.edge_halfedge(e, side);
      const Vertex v = mesh.from_vertex(anchor);
      // As in inside_out. What arrives leaves another vertex where no edge is a loop, so no anchor
      // is moved twice; with loop edges one may be, and is still an anchor.
      if (mesh.vertex_halfedge(v) == anchor) mesh.set_vertex_halfedge(v, mesh.prev(anchor));
    }
  }
  decorator::internal::reverse_loops(mesh, edges, seen);
}

}  // namespace internal

/// Whether reverse_component(h) can be done: else not-a-halfedge.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_reverse_component(const Mesh& mesh, Halfedge h) {
  return check_live(mesh, h);
}

/// The same for the faces and boundary loops of the connected component of `h`: what shares a
/// vertex belongs together.
///
/// attributes: as reverse
/// returns: the number of edges in the component
/// cost: O(component), seven bytes for each edge slot, which are cleared. inverse: itself, exactly
/// errors: not-a-halfedge, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Index> reverse_component(Mesh& mesh, Halfedge h) {
  if (Result<void> can = check_reverse_component(mesh, h); !can) return can;
  decorator::internal::ComponentWalk<Mesh> walk(mesh);
  Array<bool> seen;
  if (!walk.prepare() || !seen.resize(mesh.halfedge_slots(), false)) {
    return refusals::no_memory("the edges of the component");
  }
  const Array<Edge>& edges = walk.edges_of(mesh.edge(h));
  internal::reverse_edges(mesh, edges, seen);
  return Index(edges.size());
}

}  // namespace halfedge::operations
