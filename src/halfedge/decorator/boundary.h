#pragma once

#include <halfedge/decorator/edit.h>
#include <halfedge/decorator/vertices.h>

namespace halfedge::decorator {

/// Whether a face can be added between `h` and `g`: else not-a-halfedge, not-a-boundary-halfedge,
/// different-loops.
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] Result<void> check_add_face_to_boundary(const Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  for (const Halfedge given : {h, g}) {
    if (Result<void> live = check_live(mesh, given); !live) return live;
    if (!is_boundary(mesh, given)) return off_boundary(given, mesh.face(given));
  }
  if (!is_one_loop(mesh, h, g)) return in_different_loops(h, g);
  return {};
}

/// A new edge from to_vertex(g) to to_vertex(h), and a new face between it and the part of the
/// boundary loop from next(h) to g. (CGAL: add_face_to_border)
///
///      ---h--> * ----> * --g-->         ---h--> * ----> * --g-->        (the surface is below)
///                                  =>            ^     |
///             no face                             `-d-´    the new face is between d and the rest
///
/// With g == h the face takes the whole loop, and a loop edge bounds what is left of it.
///
/// pre: h and g are halfedges of one boundary loop, or the same one
/// returns: d, with its new face; next(d) is what next(h) was, prev(d) == g, next(h) == opposite(d)
/// cost: O(sum of the valences along the new face). inverse: join_face(opposite(d))
/// errors: those of check_add_face_to_boundary, out-of-memory
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] Result<Halfedge> add_face_to_boundary(Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  if (Result<void> can = check_add_face_to_boundary(mesh, h, g); !can) return can;
  if (!make_room(mesh, 0, 1, 1)) return no_memory("an edge and a face");
  const Halfedge d = mesh.new_edge(mesh.to_vertex(g), mesh.to_vertex(h));
  steps::insert_tip(mesh, d, h);
  steps::insert_tip(mesh, mesh.opposite(d), g);
  make_face(mesh, d);
  mend_anchors_of_loop(mesh, d);
  return d;
}

/// The same with two new edges and a vertex between them, midway between their other ends.
/// (CGAL's Polyhedron: add_vertex_and_facet_to_border)
///
/// pre: h and g are halfedges of one boundary loop, or the same one
/// returns: the new halfedge with the new face that leads to the new vertex; it is next(g)
/// cost: O(sum of the valences along the new face). inverse: erase_face(next(g))
/// errors: those of check_add_face_to_boundary, out-of-memory
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] Result<Halfedge> add_vertex_and_face_to_boundary(Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  if (Result<void> can = check_add_face_to_boundary(mesh, h, g); !can) return can;
  if (!make_room(mesh, 1, 2, 1)) return no_memory("a vertex, two edges and a face");
  Result<Halfedge> closing = add_face_to_boundary(mesh, h, g);
  if (!closing) return closing;
  return split_edge(mesh, closing.value());
}

/// Whether erase_face(h) can be done: else not-a-halfedge, boundary-halfedge.
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] Result<void> check_erase_face(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  if (is_boundary(mesh, h)) return on_boundary(h);
  return {};
}

/// Removes the face of `h`, those of its edges that have no other face, and those of its vertices
/// that then have no edge. (CGAL: erase_face)
///
/// pre: h has a face
/// cost: O(sum of the valences along the face). inverse: none in general; it undoes
///       add_vertex_and_face_to_boundary and add_face_to_boundary
/// errors: those of check_erase_face, out-of-memory
template <Editable Mesh>
requires StoresSurface<Mesh>
[[nodiscard]] Result<void> erase_face(Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> can = check_erase_face(mesh, h); !can) return can;
  struct Corner {
    Halfedge halfedge;
    Vertex vertex;
  };
  Array<Corner> corners;
  for (const Halfedge on_loop : mesh.loop_ccw(h)) {
    if (!corners.push_back({on_loop, mesh.to_vertex(on_loop)})) return no_memory("the corners");
  }

  mesh.release(mesh.face(h));
  set_face_of_loop(mesh, h, Face{});
  for (const Corner& corner : corners) {
    // An edge that the face had on both sides occurs twice.
    if (mesh.is_deleted(corner.halfedge)) continue;
    if (is_boundary(mesh, mesh.opposite(corner.halfedge))) erase_edge(mesh, corner.halfedge);
  }
  for (const Corner& corner : corners) {
    if (mesh.is_deleted(corner.vertex)) continue;
    if (mesh.is_isolated(corner.vertex)) {
      mesh.release(corner.vertex);
    } else {
      mend_anchor(mesh, mesh.vertex_halfedge(corner.vertex));
    }
  }
  return {};
}

}  // namespace halfedge::decorator
