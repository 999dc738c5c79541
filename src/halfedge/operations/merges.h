#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/links.h>
#include <halfedge/result.h>

#include <span>

/// What gluing needs to know beforehand, whatever is glued: two edges, two paths, two loops.
namespace halfedge::operations::internal {

/// Two vertices that become one: `kept` and `gone`. On either side up to two edges that are glued
/// lead on to the next such vertices: the edge kept_edges[i] takes the place of gone_edges[i].
/// Edges that there are not are empty.
struct Merge {
  Vertex kept = {};
  Vertex gone = {};
  Edge kept_edges[2] = {};
  Edge gone_edges[2] = {};
};

/// Whether the mesh is one of level 4 after all of these are merged, in so far as vertices decide
/// it: else repeated-vertex, if a vertex occurs in two merges, or a face has a vertex that is kept
/// and the one that goes; edge-exists, if the two are joined; duplicate-edge, if there would be two
/// edges between two vertices. Faces `removed` are not looked at.
///
/// pre: level 4; room for as many numbers as there are merges in `scratch`
/// cost: O(sum over the merges of the product of the valences of the vertex that goes and of the
///       one that stays, or of the neighbours of the first where those have fewer; and of the
///       degrees of the faces there), times log n for n merges, which are sorted by `gone`
[[nodiscard]] Result<void> check_merges(const Links& links, std::span<Merge> merges,
                                        std::span<Index> scratch, Face removed_0 = {},
                                        Face removed_1 = {});

}  // namespace halfedge::operations::internal
