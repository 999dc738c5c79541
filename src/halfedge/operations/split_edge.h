#pragma once

#include <halfedge/decorator/vertices.h>
#include <halfedge/operations/parameter.h>
#include <halfedge/operations/requirements.h>

#include <optional>
#include <utility>

/// Vertices that come and go in the middle of an edge.
namespace halfedge::operations {

/// Whether insert_vertex_on_edge(e) can be done: else not-an-edge.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_insert_vertex_on_edge(const Mesh& mesh, Edge e) {
  return check_live(mesh, e);
}

/// A new vertex of valence two on `e`; the faces on both sides gain a corner. (CGAL: split_edge)
///
///     u -------- h --------> v
///     u ---------> w --- h --> v       h = edge_halfedge(e)
///
/// attributes: `e` keeps its own and is the half at v, a new edge like it is the half at u. The new
///             vertex w, and its corners, are at (1 - t) u + t v: in the middle, or at the point of
///             the edge that is closest to `position`
/// returns: w. cost: O(1), and finding prev where it isn't stored
/// inverse: remove_vertex_on_edge(w)
/// errors: not-an-edge, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Vertex> insert_vertex_on_edge(Mesh& mesh, Edge e,
                                                   const std::optional<Point>& position = {}) {
  if (Result<void> can = check_insert_vertex_on_edge(mesh, e); !can) return can;
  const Halfedge h = mesh.edge_halfedge(e);
  const double t = internal::parameter_on(mesh, h, position, 0.5);
  Result<Halfedge> half = decorator::split_edge(mesh, h, t);
  if (!half) return std::move(half).failure();
  const Vertex w = mesh.to_vertex(half.value());
  internal::move_to(mesh, w, position);
  return w;
}

/// Whether remove_vertex_on_edge(v) can be done: else not-a-vertex; not-valence-two;
/// degree-below-three, if a triangle lies beside it; edge-exists, if its two neighbours are joined
/// already.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_remove_vertex_on_edge(const Mesh& mesh, Vertex v) {
  if (Result<void> live = check_live(mesh, v); !live) return live;
  if (mesh.is_isolated(v)) return not_valence_two(v, 0);
  const Halfedge h = mesh.vertex_halfedge(v);
  const Halfedge g = mesh.rotate_cw(h);
  if (g == h || mesh.rotate_cw(g) != h) return not_valence_two(v, mesh.valence(v));
  for (const Halfedge side : {h, g}) {
    if (mesh.is_boundary(side)) continue;
    if (mesh.next(mesh.next(mesh.next(side))) == side) {
      return would_have_two_corners(v, mesh.face(side));
    }
  }
  const Vertex a = mesh.to_vertex(h);
  const Vertex b = mesh.to_vertex(g);
  if (const Edge existing = mesh.find_edge(a, b); existing.valid()) {
    return edge_exists(a, b, existing);
  }
  return {};
}

/// Removes a vertex of valence two; its two edges become one, the faces there lose a corner. Of the
/// two edges the one with the lower index stays. (CGAL: join_vertex; the drawing is at
/// insert_vertex_on_edge)
///
/// attributes: the edge keeps its own; so do the corners
/// returns: the edge. cost: O(the smaller valence of its neighbours)
/// inverse: insert_vertex_on_edge
/// errors: those of check_remove_vertex_on_edge
template <EditableSurface Mesh>
[[nodiscard]] Result<Edge> remove_vertex_on_edge(Mesh& mesh, Vertex v) {
  if (Result<void> can = check_remove_vertex_on_edge(mesh, v); !can) return can;
  const Halfedge h = mesh.vertex_halfedge(v);
  const Halfedge g = mesh.rotate_cw(h);
  const Halfedge kept = mesh.edge(h) < mesh.edge(g) ? h : g;
  const Halfedge gone = mesh.opposite(kept == h ? g : h);
  (void)decorator::join_edge(mesh, gone);  // its requirements are fewer
  return mesh.edge(kept);
}

namespace internal {

template <class Mesh>
[[nodiscard]] bool is_in_triangle(const Mesh& mesh, Halfedge h) {
  const Halfedge after = mesh.next(h);
  return !mesh.is_boundary(h) && after != h && mesh.next(mesh.next(after)) == h;
}

/// An edge from to_vertex(x) to to_vertex(y) through their face, which stays on the side of x; on
/// the side of y lies a new face like it.
/// pre: there is room for it
template <class Mesh>
void cut_face(Mesh& mesh, Halfedge x, Halfedge y) {
  const Face f = mesh.face(x);
  const Halfedge cut = mesh.new_unlinked_edge(mesh.to_vertex(x), mesh.to_vertex(y));
  steps::insert_tip(mesh, cut, y);
  steps::insert_tip(mesh, mesh.opposite(cut), x);
  mesh.set_face(cut, f);
  steps::make_face(mesh, mesh.opposite(cut), f);
  steps::mend_face(mesh, f, cut);
}

}  // namespace internal

/// Whether split_edge(e) can be done: else not-an-edge; same-vertex, if the triangles on both sides
/// have the same corners, so that their cuts would be two edges between the same vertices.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_split_edge(const Mesh& mesh, Edge e) {
  if (Result<void> live = check_live(mesh, e); !live) return live;
  const Halfedge h = mesh.edge_halfedge(e);
  const Halfedge o = mesh.opposite(h);
  const Vertex c = mesh.to_vertex(mesh.next(h));
  if (c == mesh.to_vertex(mesh.next(o)) && internal::is_in_triangle(mesh, h) &&
      internal::is_in_triangle(mesh, o)) {
    return same_vertex(e, c);
  }
  return {};
}

/// As insert_vertex_on_edge; and a triangle beside `e` is cut in two. Larger faces gain the corner.
/// (OpenMesh: split_edge; and split, with triangles)
///
///           c                        c
///         ´   `                    ´ | `
///       ´       `                ´   |   `
///     u ---- h ---> v   =>     u --- w -h-> v       h = edge_halfedge(e)
///       `       ´                `   |   ´
///         `   ´                    ` | ´
///           d                        d
///
/// attributes: as insert_vertex_on_edge. The triangles at v keep their faces, those at u are new
///             and have the attributes of the face that they were cut from; the cuts have
///             defaults; their corners at c and d are divided into two alike
/// returns: w. cost: O(1), and finding prev where it isn't stored
/// inverse: collapse of the halfedge from w to u or to v
/// errors: those of check_split_edge, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Vertex> split_edge(Mesh& mesh, Edge e,
                                        const std::optional<Point>& position = {}) {
  if (Result<void> can = check_split_edge(mesh, e); !can) return can;
  if (!steps::make_room(mesh, 1, 3, 2)) {
    return refusals::no_memory("a vertex, three edges and two faces");
  }
  const Halfedge h = mesh.edge_halfedge(e);
  const Halfedge o = mesh.opposite(h);
  const bool cuts_left = internal::is_in_triangle(mesh, h);
  const bool cuts_right = internal::is_in_triangle(mesh, o);
  const double t = internal::parameter_on(mesh, h, position, 0.5);
  const Halfedge k = decorator::internal::halve_edge(mesh, h, t);
  const Vertex w = mesh.to_vertex(k);
  internal::move_to(mesh, w, position);
  if (cuts_left) internal::cut_face(mesh, mesh.next(h), k);
  if (cuts_right) internal::cut_face(mesh, o, mesh.next(mesh.opposite(k)));
  return w;
}

}  // namespace halfedge::operations
