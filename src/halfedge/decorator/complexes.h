#pragma once

#include <halfedge/decorator/edit.h>

namespace halfedge::decorator {

/// The smallest complex: one edge whose ends are the same vertex, and a face on either side of it,
/// two halfedges, one vertex, two faces. A sphere with an equator. Its face `face(h)` has the one
/// corner `h`. (CGAL: create_loop)
///
///          ___
///        /     \       next(h) == h
///       |   h   |      next(opposite(h)) == opposite(h)
///        \     /
///          `v´
///
/// returns: one of the halfedges; v is at the origin if vertices have positions
/// post: valid at level 3. cost: O(1). inverse: erase_connected_component(h)
/// errors: out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> make_loop(Mesh& mesh) {
  using namespace internal;
  if (!make_room(mesh, 1, 1, 2)) return no_memory("a loop");
  const Vertex v = mesh.new_vertex();
  const Halfedge h = mesh.new_edge(v, v);
  for (const Halfedge side : {h, mesh.opposite(h)}) {
    mesh.link(side, side);
    make_face(mesh, side);
  }
  set_anchor(mesh, v, h);
  return h;
}

/// One edge with two ends in one face: two halfedges, two vertices, one face. A sphere with a slit.
/// (CGAL: create_segment)
///
///        u --- h ---> v      next(h) == opposite(h), next(opposite(h)) == h
///
/// returns: h; u and v are at the origin if vertices have positions
/// post: valid at level 3. cost: O(1). inverse: erase_connected_component(h)
/// errors: out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> make_segment(Mesh& mesh) {
  using namespace internal;
  if (!make_room(mesh, 2, 1, 1)) return no_memory("a segment");
  const Vertex u = mesh.new_vertex();
  const Vertex v = mesh.new_vertex();
  const Halfedge h = mesh.new_edge(u, v);
  make_face(mesh, h);
  set_anchor(mesh, u, h);
  set_anchor(mesh, v, mesh.opposite(h));
  return h;
}

}  // namespace halfedge::decorator
