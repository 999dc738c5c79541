#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/connectivity.h>

#include <cstdint>

namespace halfedge {

enum class ConnectResult : std::uint8_t { kDone, kNotManifold, kTooLarge, kOutOfMemory };

/// Fills all links of a mesh, or all but prev, from its faces: what `build_from_polygons` promises
/// but for the positions. Finds out that the polygons aren't manifold, not why. The links are
/// undefined after any result but kDone.
///
/// pre: each face has at least three corners, all of them below the number of vertices; there are
/// at most kMaxSlots corners and vertices
/// cost: O(vertices + corners); 8 bytes a vertex of scratch memory, and 12 for some of the boundary
/// edges
template <bool kPrev>
[[nodiscard]] ConnectResult connect(const Polygons& polygons, Links& links);

}  // namespace halfedge
