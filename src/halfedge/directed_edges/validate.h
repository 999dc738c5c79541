#pragma once

#include <halfedge/directed_edges/directed_edges.h>
#include <halfedge/validate/validate.h>

#include <vector>

namespace halfedge {

/// Checks the invariants of Directed Edges, all those of `level` and below. An empty list means
/// valid. The levels and codes are those of `validate` for the full mesh; what is computed and not
/// stored needs no check:
///
/// 0 | array-size            opposite and to_vertex are equally long, and at least `sides`, three
///   |                       to a face; the boundary arrays hold the rest; positions are three
///   |                       floats a vertex
///   | empty-link            no link but an anchor is empty
///   | index-out-of-range    links lead to items that exist, boundary links to boundary halfedges
///   | opposite-mismatch     opposite is an involution without fixed points
///   | next-prev-mismatch    boundary_next and boundary_prev are inverse permutations
///   | missing-anchor        a vertex that halfedges leave has an anchor
///   | anchor-elsewhere      from(anchor(v)) == v
/// 1 | to-from-mismatch      to(opposite(h)) == from(h)
/// 2 | unreachable-halfedge  every halfedge that leaves v is reached by rotating from its anchor
/// 3 | interior-anchor       the anchor of a boundary vertex is a boundary halfedge
///   | edge-without-face     an edge has a face on at least one side
/// 4 | repeated-vertex       the corners of a face are different vertices
///   | duplicate-halfedge    at most one halfedge leads from one vertex to another
///   | same-face-twice       the two sides of an edge are different faces
///   | pinched-vertex        warning: the faces at a vertex form one fan
///   | isolated-vertex       information: a vertex has an edge
///   | out-of-memory         there was memory for the checks; those left out are named
///
/// The arrays may hold anything, of any size: no index is used before it is checked, no walk is
/// begun before it is known to end. Levels 2 to 4 are checked where levels 0 and 1 find no error.
///
/// pre: 0 <= level <= kMaxValidationLevel
/// cost: O(halfedges), at most 4 bytes a vertex and 1 byte a halfedge of scratch memory
[[nodiscard]] std::vector<Problem> validate(const DirectedEdges& mesh,
                                            int level = kMaxValidationLevel);
[[nodiscard]] std::vector<Problem> validate(const DirectedEdgesMesh& mesh,
                                            int level = kMaxValidationLevel);

}  // namespace halfedge
