#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/decorator/faces.h>
#include <halfedge/operations/distinct.h>
#include <halfedge/operations/fans.h>
#include <halfedge/operations/requirements.h>

#include <utility>

namespace halfedge::operations {

namespace internal {

/// Whether a face could lie on the boundary loop from `first` to `last` and, where that doesn't
/// lead to the vertex that `first` leaves, on an edge back to it: not if a vertex would be at two
/// of its corners. Only pinched vertices can be.
/// cost: O(length of the loop + valences), O(p log p) of p pinched vertices
template <class Mesh>
[[nodiscard]] Result<void> check_face_on_boundary(const Mesh& mesh, Halfedge first, Halfedge last) {
  Array<Vertex> pinched;
  const auto add = [&](Vertex v) { return pinched.push_back(v); };
  Index sides = 1;
  bool fits = true;
  for (Halfedge h = first;; h = mesh.next(h), ++sides) {
    if (next_gap(mesh, h).valid()) fits = fits && add(mesh.from_vertex(h));
    if (h == last) break;
  }
  if (mesh.to_vertex(last) != mesh.from_vertex(first)) {
    ++sides;
    if (next_gap(mesh, mesh.next(last)).valid()) fits = fits && add(mesh.to_vertex(last));
  }
  if (!fits) return refusals::no_memory("the corners of the face");
  if (sides < 3) {
    const Vertex corners[] = {mesh.from_vertex(first), mesh.to_vertex(first)};
    return degree_below_three(sides, {corners, sides});
  }
  Result<Vertex> repeated = find_repeated(pinched.span());
  if (!repeated) return repeated;
  if (repeated.value().valid()) return repeated_vertex(repeated.value());
  return {};
}

}  // namespace internal

/// Whether make_hole(f) can be done: else not-a-face; edge-without-face, if an edge of it has no
/// other face.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_make_hole(const Mesh& mesh, Face f) {
  if (Result<void> live = check_live(mesh, f); !live) return live;
  return decorator::check_make_hole(mesh, mesh.face_halfedge(f));
}

/// Removes a face and leaves its edges: they become a boundary loop. (CGAL: Euler::make_hole;
/// delete_face also takes faces whose edges have no other face.)
///
/// pre: each edge of the face has another face
/// attributes: all of what stays stay
/// returns: what was face_halfedge(f), a halfedge of the boundary loop
/// cost: O(degree). inverse: fill_hole(returned)
/// errors: those of check_make_hole
template <EditableSurface Mesh>
[[nodiscard]] Result<Halfedge> make_hole(Mesh& mesh, Face f) {
  if (Result<void> can = check_make_hole(mesh, f); !can) return can;
  return decorator::make_hole(mesh, mesh.face_halfedge(f));
}

/// Whether fill_hole(h) can be done: else not-a-halfedge; not-a-boundary-halfedge; repeated-vertex,
/// if the loop passes a pinched vertex more than once; degree-below-three, of a degenerate complex;
/// out-of-memory.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_fill_hole(const Mesh& mesh, Halfedge h) {
  if (Result<void> can = decorator::check_fill_hole(mesh, h); !can) return can;
  return internal::check_face_on_boundary(mesh, mesh.next(h), h);
}

/// A new face on the boundary loop of `h`. (CGAL: Euler::fill_hole)
///
/// pre: no vertex occurs twice in the loop
/// attributes: the face has the defaults
/// returns: the face; its face_halfedge is h
/// cost: O(sum of the valences along the loop). inverse: make_hole(returned)
/// errors: those of check_fill_hole, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> fill_hole(Mesh& mesh, Halfedge h) {
  if (Result<void> can = check_fill_hole(mesh, h); !can) return can;
  Result<Halfedge> filled = decorator::fill_hole(mesh, h);
  if (!filled) return std::move(filled).failure();
  return mesh.face(h);
}

}  // namespace halfedge::operations
