#pragma once

#include <halfedge/connectivity/connectivity.h>

namespace halfedge {

// A fan is a maximal run of faces around a vertex, each joined to the next by an edge: closed, or
// open with a boundary halfedge at both ends.

/// Joins the open fans of each vertex into one cycle, in the order of the vertices that their
/// outgoing boundary halfedges lead to, and anchors the vertex on the first of these. So the
/// boundary halfedges get their `next` and, where it is stored, their `prev`.
///
/// pre: all other links are set; no two faces run along a side of an edge in the same direction
/// cost: O(halfedges), and sorting the fans of pinched vertices. False when memory is exhausted.
[[nodiscard]] bool join_open_fans(Links& links);

/// Whether all halfedges that leave a vertex are reached by rotating from its anchor, for every
/// vertex: false if a closed fan shares its vertex with another fan.
///
/// pre: `next` is a permutation, each anchor leaves its vertex
/// cost: O(halfedges)
[[nodiscard]] bool each_vertex_has_one_cycle(const Links& links);

}  // namespace halfedge
