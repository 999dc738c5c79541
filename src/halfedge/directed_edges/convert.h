#pragma once

#include <halfedge/directed_edges/directed_edges.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

namespace halfedge {

/// Makes `to` the full mesh of these Directed Edges: the same vertices, faces, positions, anchors,
/// first halfedges of faces, and boundary loops, so that all circulators give the same. Edges are
/// numbered as `build_from_polygons` numbers them. The inverse of `from_mesh`.
///
/// cost: O(halfedges), without a search; 4 bytes a halfedge and 28 a vertex of scratch memory
/// Codes: corrupt-connectivity, if `from` breaks the invariants of validation levels 0 and 1;
/// out-of-memory. `to` is then empty.
[[nodiscard]] Result<void> to_mesh(const DirectedEdgesMesh& from, Mesh& to);

/// Makes `to` the Directed Edges of a triangle mesh: the same vertices, faces, positions and
/// boundary loops. Anchors are the same too; circulators around a face begin where they did. The
/// inverse of `to_mesh`.
///
/// Takes meshes with and without prev, which isn't needed.
///
/// pre: `from` is valid at level 3
/// cost: O(halfedges); 4 bytes a halfedge of scratch memory
/// Codes: not-a-triangle, for the first face that has other than three corners; deleted-item, as
/// there are no deleted slots in Directed Edges; corrupt-connectivity, if links lead astray;
/// out-of-memory. `to` is then empty.
template <Storage kStored>
requires StoresSurface<BasicMesh<kStored>>
[[nodiscard]] Result<void> from_mesh(const BasicMesh<kStored>& from, DirectedEdgesMesh& to);

}  // namespace halfedge
