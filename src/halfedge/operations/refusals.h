#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/result.h>

/// The sentences in which the operations refuse, one function to a code. Not templates: they are
/// compiled once, and for size.
namespace halfedge::operations {

/// boundary-edge: `side` is a halfedge of `e` without a face.
[[nodiscard]] Error is_boundary_edge(Edge e, Halfedge side);
/// not-a-triangle
[[nodiscard]] Error not_a_triangle(Face f, Index degree);
/// same-vertex: both corners opposite to `e` are `v`.
[[nodiscard]] Error same_vertex(Edge e, Vertex v);
/// edge-exists: `a` and `b` would be joined a second time.
[[nodiscard]] Error edge_exists(Vertex a, Vertex b, Edge existing);

}  // namespace halfedge::operations
