#pragma once

#include <halfedge/decorator/flip.h>
#include <halfedge/operations/requirements.h>

namespace halfedge::operations {

/// Whether flip_edge(e) can be done: else not-an-edge; boundary-edge; not-a-triangle; same-vertex,
/// if the two opposite corners are one vertex; edge-exists, if they are joined already.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_flip_edge(const Mesh& mesh, Edge e) {
  if (Result<void> live = check_live(mesh, e); !live) return live;
  const Halfedge h = mesh.edge_halfedge(e);
  const Halfedge o = mesh.opposite(h);
  if (mesh.is_boundary(e)) return is_boundary_edge(e, mesh.is_boundary(h) ? h : o);
  for (const Halfedge side : {h, o}) {
    if (mesh.next(mesh.next(side)) != mesh.prev(side)) {
      return not_a_triangle(mesh.face(side), mesh.degree(mesh.face(side)));
    }
  }
  const Halfedge from_a = mesh.prev(h);
  const Halfedge from_b = mesh.prev(o);
  const Vertex a = mesh.to_vertex(mesh.next(h));
  const Vertex b = mesh.to_vertex(mesh.next(o));
  if (a == b) return same_vertex(e, a);
  if (const Halfedge existing = mesh.find_halfedge(from_a, from_b); existing.valid()) {
    return edge_exists(a, b, mesh.edge(existing));
  }
  return {};
}

/// Turns `e` counter-clockwise in the quad of its two triangles: the diagonal 0-2 of the quad 0123
/// becomes 1-3, and the halfedge from 0 to 2 leads from 1 to 3.
///
///     3 ------- 2           3 ------- 2
///     |       ´ |           | `       |
///     |   e ´   |     =>    |   ` e   |
///     | ´       |           |       ` |
///     0 ------- 1           0 ------- 1
///
/// The faces keep their indices: that of the halfedge which led from 0 to 2 stays on its left.
///
/// attributes: those of `e`, of both faces and of the vertices stay; the corners at 1 and 3 are
///             divided into two alike, those at 0 and 2 joined
/// returns: e. cost: O(the smaller valence of its new ends)
/// inverse: itself, three times; twice turns `e` around
/// errors: those of check_flip_edge
template <EditableSurface Mesh>
[[nodiscard]] Result<Edge> flip_edge(Mesh& mesh, Edge e) {
  if (Result<void> can = check_flip_edge(mesh, e); !can) return can;
  decorator::internal::turn_edge(mesh, mesh.edge_halfedge(e));
  return e;
}

}  // namespace halfedge::operations
