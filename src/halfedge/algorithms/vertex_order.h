#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/links.h>
#include <halfedge/result.h>

#include <span>

/// Orders of the vertices of a mesh in which neighbours are close to each other: the new numbers
/// that `reorder` gives them. Each lists all live vertices once; where anchors aren't stored, all
/// vertices are live.
namespace halfedge {

/// Along a Morton curve (Z-order) through the box of the positions, of 2^21 cells to its longest
/// side; vertices in one cell keep their order. Positions that aren't finite don't count for the
/// box: NaN is taken for its least corner, an infinity for the side that it lies beyond.
///
/// pre: 3 positions to a vertex slot
/// cost: O(vertices), a radix sort; 24 bytes a vertex
/// errors: out-of-memory
[[nodiscard]] Result<Array<Index>> morton_order(std::span<const float> positions,
                                                const Links& links);

/// By breadth-first search over the edges, from the vertex of lowest index of each component. For
/// meshes whose positions say nothing of what is near: all at the origin, or flattened.
///
/// pre: anchors are stored. Links that break the invariants aren't followed out of their arrays.
/// cost: O(halfedges); 5 bytes a vertex
/// errors: out-of-memory
[[nodiscard]] Result<Array<Index>> breadth_first_order(const Links& links);

}  // namespace halfedge
