#pragma once

#include <halfedge/operations/requirements.h>

namespace halfedge::operations {

struct DeleteOptions {
  /// Whether vertices stay that have no edge any more. By default they are deleted too, as most
  /// libraries do. Vertices that were isolated before stay in any case.
  bool keep_isolated_vertices = false;
};

namespace internal {

/// The face of `v` has gone: the vertex is deleted if it has no edge, else its anchor mended.
template <class Mesh>
void leave_vertex(Mesh& mesh, Vertex v, const DeleteOptions& options) {
  if (!mesh.is_isolated(v)) {
    steps::mend_anchor(mesh, mesh.vertex_halfedge(v));
  } else if (!options.keep_isolated_vertices) {
    mesh.release(v);
  }
}

/// same-loop, if a face lies on both sides of one of its edges, as in a segment: a gap can't take
/// its place.
template <class Mesh>
[[nodiscard]] Result<void> check_erase_face(const Mesh& mesh, Face f) {
  for (const Halfedge h : mesh.face_halfedges_ccw(f)) {
    const Halfedge o = mesh.opposite(h);
    if (mesh.face(o) == f) return refusals::in_same_loop(h, o);
  }
  return {};
}

/// pre: check_erase_face(mesh, f)
template <class Mesh>
void erase_face(Mesh& mesh, Face f, const DeleteOptions& options) {
  Halfedge h = mesh.face_halfedge(f);
  Index sides = mesh.degree(f);
  mesh.release(f);
  steps::set_face_of_loop(mesh, h, Face{});
  // A vertex is left once both its sides are: the first one at the end.
  const Vertex first = mesh.from_vertex(h);
  for (;;) {
    const Halfedge after = mesh.next(h);
    const Vertex v = mesh.to_vertex(h);
    const Vertex before = mesh.from_vertex(h);
    if (mesh.is_boundary(mesh.opposite(h))) steps::erase_edge(mesh, h);
    if (before != first) leave_vertex(mesh, before, options);
    if (--sides == 0) return leave_vertex(mesh, v, options);
    h = after;
  }
}

}  // namespace internal

/// Whether delete_face(f) can be done: else not-a-face; same-loop, if it lies on both sides of an
/// edge.
/// cost: O(degree)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_delete_face(const Mesh& mesh, Face f) {
  if (Result<void> live = check_live(mesh, f); !live) return live;
  return internal::check_erase_face(mesh, f);
}

/// Deletes a face, and those of its edges that have no other face, and as `options` say its
/// vertices that have no other edge. Where two faces touch in a vertex then, that is a pinched
/// vertex; one that was may be none any more. (OpenMesh: delete_face; CGAL: Euler::remove_face)
///
/// attributes: all of what stays stay
/// cost: O(sum of the valences of the corners); it needs no memory
/// inverse: add_face(its corners), if no vertex was deleted, up to the order of fans around pinched
///          vertices
/// errors: those of check_delete_face
template <EditableSurface Mesh>
[[nodiscard]] Result<void> delete_face(Mesh& mesh, Face f, const DeleteOptions& options = {}) {
  if (Result<void> can = check_delete_face(mesh, f); !can) return can;
  internal::erase_face(mesh, f, options);
  return {};
}

/// Whether delete_edge(e) can be done: else not-an-edge; same-loop, if one of its faces lies on
/// both sides of an edge. cost: O(degrees of its faces)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_delete_edge(const Mesh& mesh, Edge e) {
  if (Result<void> live = check_live(mesh, e); !live) return live;
  for (const Face f : mesh.edge_faces(e)) {
    if (Result<void> can = internal::check_erase_face(mesh, f); !can) return can;
  }
  return {};
}

/// Deletes the faces of an edge, and by that the edge: delete_face for both.
/// (OpenMesh: delete_edge)
///
/// attributes: all of what stays stay
/// cost: O(sum of the valences of the corners). inverse: add_face, as for delete_face
/// errors: those of check_delete_edge
template <EditableSurface Mesh>
[[nodiscard]] Result<void> delete_edge(Mesh& mesh, Edge e, const DeleteOptions& options = {}) {
  if (Result<void> can = check_delete_edge(mesh, e); !can) return can;
  const Face faces[] = {mesh.face(mesh.edge_halfedge(e, 0)), mesh.face(mesh.edge_halfedge(e, 1))};
  for (const Face f : faces) {
    if (f.valid()) internal::erase_face(mesh, f, options);
  }
  return {};
}

/// Whether delete_vertex(v) can be done: else not-a-vertex; same-loop, if one of its faces lies on
/// both sides of an edge.
/// cost: O(degrees of its faces)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_delete_vertex(const Mesh& mesh, Vertex v) {
  if (Result<void> live = check_live(mesh, v); !live) return live;
  for (const Face f : mesh.vertex_faces_ccw(v)) {
    if (Result<void> can = internal::check_erase_face(mesh, f); !can) return can;
  }
  return {};
}

/// Deletes a vertex with the faces around it: delete_face for each, and the vertex, whatever
/// `options` say of others. (OpenMesh: delete_vertex)
///
/// attributes: all of what stays stay
/// cost: O(sum of the valences of the corners); where prev isn't stored, O(valence^2) besides
/// inverse: none; undo
/// errors: those of check_delete_vertex
template <EditableSurface Mesh>
[[nodiscard]] Result<void> delete_vertex(Mesh& mesh, Vertex v, const DeleteOptions& options = {}) {
  if (Result<void> can = check_delete_vertex(mesh, v); !can) return can;
  while (mesh.is_live(v) && !mesh.is_isolated(v)) {
    const Halfedge out = mesh.vertex_halfedge(v);
    // The face beside the gap, if there is one: then the anchor moves on in O(1).
    const Face f = mesh.face(mesh.is_boundary(out) ? mesh.opposite(out) : out);
    internal::erase_face(mesh, f, options);
  }
  if (mesh.is_live(v)) mesh.release(v);
  return {};
}

/// Deletes all vertices without an edge. (OpenMesh: delete_isolated_vertices)
///
/// returns: how many there were
/// cost: O(vertex slots). It can't be refused
template <EditableSurface Mesh>
Index delete_isolated_vertices(Mesh& mesh) {
  const Index before = mesh.vertex_count();
  for (Index i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    if (mesh.is_live(v) && mesh.is_isolated(v)) mesh.release(v);
  }
  return before - mesh.vertex_count();
}

}  // namespace halfedge::operations
