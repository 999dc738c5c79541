#pragma once

#include <halfedge/build/connect.h>
#include <halfedge/build/groups.h>
#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/links.h>

namespace halfedge {

/// Blocks of 4096 vertices, which have 400 kB of halfedges.
inline constexpr int kBlockBits = 12;

/// Whether triangles come in no order, over so many vertices that the groups of each would have to
/// be fetched from memory. Judged by some of them. False too where one block would have so many of
/// them, around a vertex of high valence, that they took more memory than the positions will.
[[nodiscard]] bool are_scattered(const Polygons& triangles, const Groups& groups);

/// Connects triangles to the links that `connect` makes before it joins fans, but in the order of
/// their vertices instead of their own, in blocks of 2^block_bits vertices.
///
/// pre: as for `connect`; no triangle has a vertex twice
/// cost: O(vertices + corners), expected; 4 bytes a triangle of scratch memory, and 24 for each one
/// whose smallest vertex is in the block that has most of them
template <bool kPrev>
[[nodiscard]] ConnectResult connect_scattered(const Polygons& triangles, const Groups& groups,
                                              Links& links, int block_bits = kBlockBits);

}  // namespace halfedge
