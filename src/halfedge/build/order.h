#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/handle.h>

#include <cstddef>

// What the size of a mesh and the order of its faces tell of the time that its memory takes.

namespace halfedge {

/// From so many vertices on, what belongs to them doesn't stay in the cache between one use and the
/// next.
inline constexpr std::size_t kTooManyForCache = 100'000;

/// Whether two items are so near by number that what belongs to them is near in memory.
[[nodiscard]] constexpr bool are_near(Index a, Index b, Index nearby = 2048) {
  return a - b + nearby < 2 * nearby;
}

/// Whether sides are scattered over all faces, by the first and the last of some that will be
/// needed together. In a mesh whose faces are in no order, seven of eight such pairs are.
[[nodiscard]] constexpr bool are_scattered(Index first, Index last, Index sides) {
  return !are_near(first, last, sides / 16);
}

/// Whether faces lie row by row, as those of grids do: a loop over them goes straight on in memory,
/// which processors notice, and fetch what it needs by themselves. By samples; also true of a few
/// faces, which fit into the cache. cost: O(1)
[[nodiscard]] bool lie_in_rows(const Polygons& polygons);

/// Whether triangles lie in random order: most of them have no corner near one of the next. By
/// samples. cost: O(1)
[[nodiscard]] bool lie_at_random(const Polygons& triangles);

}  // namespace halfedge
