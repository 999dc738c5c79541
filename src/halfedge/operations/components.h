#pragma once

#include <halfedge/decorator/components.h>
#include <halfedge/operations/requirements.h>

namespace halfedge::operations {

namespace internal {

/// A halfedge of the component of an item; empty for an isolated vertex.
template <class Mesh>
[[nodiscard]] Halfedge halfedge_of(const Mesh& mesh, Vertex v) {
  return mesh.vertex_halfedge(v);
}
template <class Mesh>
[[nodiscard]] Halfedge halfedge_of(const Mesh&, Halfedge h) {
  return h;
}
template <class Mesh>
[[nodiscard]] Halfedge halfedge_of(const Mesh& mesh, Edge e) {
  return mesh.edge_halfedge(e);
}
template <class Mesh>
[[nodiscard]] Halfedge halfedge_of(const Mesh& mesh, Face f) {
  return mesh.face_halfedge(f);
}

}  // namespace internal

/// Whether delete_component(item) can be done: else not-a-vertex, not-a-halfedge, not-an-edge,
/// not-a-face.
template <EditableSurface Mesh, class Item>
[[nodiscard]] Result<void> check_delete_component(const Mesh& mesh, Item item) {
  return check_live(mesh, item);
}

/// Deletes the connected component of an item, a vertex, halfedge, edge or face: all that is
/// reached from it over edges, also through pinched vertices.
///
/// attributes: all of what stays stay
/// returns: the number of faces deleted
/// cost: O(component), and clearing a byte for each edge slot; 4 bytes more for each live edge
/// inverse: none; undo
/// errors: those of check_delete_component, out-of-memory
template <EditableSurface Mesh, class Item>
[[nodiscard]] Result<Index> delete_component(Mesh& mesh, Item item) {
  if (Result<void> can = check_delete_component(mesh, item); !can) return can;
  const Index before = mesh.face_count();
  if (const Halfedge h = internal::halfedge_of(mesh, item); h.valid()) {
    Result<Index> erased = decorator::erase_connected_component(mesh, h);
    if (!erased) return erased;
  } else if constexpr (kind_of(Item{}) == ItemKind::kVertex) {
    mesh.release(item);
  }
  return before - mesh.face_count();
}

/// Deletes all connected components but the `keep` largest, by their number of vertices (of two as
/// large, the one with the smaller edge stays), and all isolated vertices.
/// (CGAL: keep_largest_connected_components)
///
/// attributes: all of what stays stay
/// returns: the number of components deleted; isolated vertices don't count
/// cost: O(slots + c log c) of c components. inverse: none; undo
/// errors: out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Index> keep_largest_components(Mesh& mesh, Index keep) {
  return decorator::keep_largest_connected_components(mesh, keep);
}

}  // namespace halfedge::operations
