#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/result.h>

/// As refusals.h, of the operations that cut and glue.
namespace halfedge::operations {

/// repeated-vertex: `v` would be glued to more than one vertex, or to itself.
[[nodiscard]] Failure repeated_on_seam(Vertex v);
/// repeated-vertex: `f` has both, and they would become one.
[[nodiscard]] Failure would_repeat_vertex(Face f, Vertex kept, Vertex gone);
/// duplicate-edge: both edges would lead from `a` to `b`.
[[nodiscard]] Failure would_be_duplicate(Edge first, Edge second, Vertex a, Vertex b);
/// pinched-vertex: the faces at `v` between `h` and `g` would close around it, beside others.
[[nodiscard]] Failure would_close_fan(Vertex v, Halfedge h, Halfedge g);
/// no-boundary-end: neither end of `e` lies on the boundary.
[[nodiscard]] Failure no_boundary_end(Edge e, Vertex a, Vertex b);
/// no-boundary-end: nor does any other edge of the list end where `e` does.
[[nodiscard]] Failure no_open_end(Edge e, Vertex a, Vertex b);
/// repeated-edge: `e` is listed twice.
[[nodiscard]] Failure repeated_in_list(Edge e);
/// not-a-path: it is empty; `following` doesn't begin where `h` ends; `e` occurs twice.
[[nodiscard]] Failure empty_path();
[[nodiscard]] Failure not_consecutive(Halfedge h, Vertex end, Halfedge following, Vertex begin);
[[nodiscard]] Failure repeated_on_path(Edge e);
/// not-a-quad
[[nodiscard]] Failure not_a_quad(Face f, Index degree);
/// degree-below-three: a ring of these two would be closed by faces of two corners.
[[nodiscard]] Failure ring_too_short(Face f, Face g);
/// repeated-vertex: the ring of quads over `e` passes `v` more than once.
[[nodiscard]] Failure repeated_on_ring(Edge e, Vertex v);
/// no-triangulation: of `f`, if `a` and `b`, which are joined by `existing`, or, if that is empty,
/// will be across another face, may not be joined.
[[nodiscard]] Failure no_triangulation(Face f, Vertex a, Vertex b, Edge existing);
/// out-of-range: the number called `name` isn't from 0 to 1.
[[nodiscard]] Failure not_a_fraction(const char* name, double value);
/// valence-below-three
[[nodiscard]] Failure valence_below_three(Vertex v, Index valence);
/// valence-below-three: both ends of `e` have no more than one other edge.
[[nodiscard]] Failure both_valences_below_three(Edge e, Vertex a, Vertex b);

}  // namespace halfedge::operations
