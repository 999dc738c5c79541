#pragma once

#include <halfedge/build/connect.h>
#include <halfedge/build/polygons.h>
#include <halfedge/directed_edges/directed_edges.h>

#include <span>

namespace halfedge {

/// Fills all links from triangles: what `build_from_triangles` promises but for the positions.
/// Finds out that the triangles aren't manifold, not why. The links are undefined after any result
/// but kDone.
///
/// pre: all faces have three corners, all of them below the number of vertices; there are at most
/// kMaxSlots corners and vertices
[[nodiscard]] ConnectResult connect_triangles(const Polygons& triangles, DirectedLinks& links);

/// Joins the open fans of each vertex into one cycle, in the order of the vertices that their
/// outgoing boundary halfedges lead to, and anchors the vertex on the first of these, as
/// `join_open_fans` does for the full structure. So the boundary halfedges get their next and prev.
///
/// pre: all other links are set
/// cost: O(halfedges), and sorting the fans of pinched vertices. kNotManifold if two boundary
/// halfedges lead from one vertex to the same other.
[[nodiscard]] ConnectResult join_open_fans(DirectedLinks& links);

/// Whether all halfedges that leave a vertex are reached by rotating from its anchor, for every
/// vertex: false if a closed fan shares its vertex with another fan. `rotated` is scratch, and has
/// an entry for each halfedge.
///
/// pre: opposite is its own inverse, boundary_next a permutation of the boundary halfedges, and
/// each anchor leaves its vertex; to_vertex isn't read cost: O(halfedges)
[[nodiscard]] bool each_vertex_has_one_cycle(const DirectedLinks& links, std::span<Index> rotated);

}  // namespace halfedge
