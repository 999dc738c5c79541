#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/result.h>

#include <span>

/// The sentences in which the operations refuse, one function to a code. Not templates: they are
/// compiled once, and for size.
namespace halfedge::operations {

/// boundary-edge: `side` is a halfedge of `e` without a face.
[[nodiscard]] Failure is_boundary_edge(Edge e, Halfedge side);
/// not-a-triangle
[[nodiscard]] Failure not_a_triangle(Face f, Index degree);
/// same-vertex: `h` is given for both sides of a vertex to be split, and leads to `v`.
[[nodiscard]] Failure same_side_twice(Halfedge h, Vertex v);
/// same-vertex: both corners opposite to `e` are `v`.
[[nodiscard]] Failure same_vertex(Edge e, Vertex v);
/// edge-exists: `a` and `b` would be joined a second time.
[[nodiscard]] Failure edge_exists(Vertex a, Vertex b, Edge existing);

// ---- faces added, joined, divided -----------------------------------------------------------

/// degree-below-three: of a face that is to be, with these corners; where `without` is taken away.
[[nodiscard]] Failure degree_below_three(Index degree, std::span<const Vertex> corners,
                                         Vertex without = {});
/// repeated-vertex: a face would have `v` at two corners.
[[nodiscard]] Failure repeated_vertex(Vertex v);
/// duplicate-face: the corners are those of `f`, in its order or in reverse.
[[nodiscard]] Failure duplicate_face(Face f, bool is_reversed);
/// edge-with-many-faces: `f` and `g` lie on both sides of `e` already.
[[nodiscard]] Failure edge_with_many_faces(Edge e, Face f, Face g);
/// opposite-orientation: `f` runs from `a` to `b` as the new face would.
[[nodiscard]] Failure opposite_orientation(Edge e, Face f, Vertex a, Vertex b);
/// pinched-vertex: faces would close around `v`, or do already, and leave out others; `f` and `g`
/// are one of each, of which one is empty if it is the new face.
[[nodiscard]] Failure closed_beside_another(Vertex v, Face f, Face g);
/// same-corner: an edge would lead from `v`, where `h` and `g` end, to itself.
[[nodiscard]] Failure same_corner(Vertex v, Halfedge h, Halfedge g);
/// adjacent-corners: `between` leads from one of the corners that should be joined to the other.
[[nodiscard]] Failure adjacent_corners(Halfedge between, Vertex a, Vertex b);
/// faces-share-edges: `f` and `g` have as many edges in common as are listed, the first of which
/// was to be removed.
[[nodiscard]] Failure faces_share_edges(Face f, Face g, std::span<const Edge> edges);
/// faces-share-vertex: `f` and `g` meet at `v` too, beside the edge(s) that were to be removed.
[[nodiscard]] Failure faces_share_vertex(Face f, Face g, Vertex v);
/// isolated-vertex
[[nodiscard]] Failure is_isolated_vertex(Vertex v);
/// pinched-vertex: the boundary halfedges `h` and `g` both leave `v`.
[[nodiscard]] Failure is_pinched_vertex(Vertex v, Halfedge h, Halfedge g);
/// degenerate-face: no normal can be told.
[[nodiscard]] Failure degenerate_face(Face f);
/// not-finite: the argument `name` is `value`.
[[nodiscard]] Failure not_finite(const char* name, double value);
/// not-finite: a position that far from the face would be infinite.
[[nodiscard]] Failure too_far(Face f, double offset);

// ---- edges divided and contracted -----------------------------------------------------------

/// not-valence-two
[[nodiscard]] Failure not_valence_two(Vertex v, Index valence);
/// degree-below-three: the triangle `f` would lose its corner `v`.
[[nodiscard]] Failure would_have_two_corners(Vertex v, Face f);
/// boundary-vertices: `e`, an interior edge, joins two vertices of the boundary.
[[nodiscard]] Failure joins_boundary_vertices(Edge e, Vertex a, Vertex b);
/// edge-without-face: the triangle `f` would vanish, and `g` and `k`, on the boundary, become one.
[[nodiscard]] Failure would_leave_bare_edge(Face f, Edge g, Edge k);
/// common-neighbour: `v` is joined to the ends of `e` by `to_a` and `to_b`.
[[nodiscard]] Failure is_common_neighbour(Vertex v, Edge e, Edge to_a, Edge to_b);
/// repeated-vertex: both ends of `e` are corners of `f`, in which `e` doesn't lie.
[[nodiscard]] Failure has_both_ends(Face f, Edge e, Vertex a, Vertex b);
/// leaves-pillow: contracting `e` would leave `f` and `g` on the same corners.
[[nodiscard]] Failure would_leave_pillow(Edge e, Face f, Face g);
/// different-vertices: `h` and `g` don't leave the same vertex.
[[nodiscard]] Failure leave_different_vertices(Halfedge h, Vertex v, Halfedge g, Vertex w);
/// nothing-between: a new vertex between `h` and `g` would have one edge.
[[nodiscard]] Failure nothing_between(Halfedge h, Halfedge g);
/// edge-without-face: the new edge would lie on the boundary with both sides.
[[nodiscard]] Failure would_be_bare_edge(Vertex v, Halfedge h, Halfedge g);

}  // namespace halfedge::operations
