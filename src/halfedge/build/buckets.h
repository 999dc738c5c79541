#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/prefetch.h>

#include <array>
#include <cstddef>

namespace halfedge {

/// Divides the sides of triangles among buckets by the smaller vertices of their edges, for meshes
/// that come in random order: one step of a radix sort. What belongs to the vertices of a bucket
/// fits into the cache, so that sides that are taken bucket by bucket don't wait for memory.
///
/// Sides stay in their order within a bucket. So the triangles tell once more where each side went,
/// and nothing is kept of that but where buckets begin.
class Buckets {
 public:
  /// Whether a build of these would wait for memory longer than it takes to divide their sides: if
  /// there are many vertices, and triangles that follow one another have none in common or nearby.
  /// cost: O(1)
  [[nodiscard]] static bool pay(const Polygons& triangles);

  /// Writes which vertices each side leads from and to, bucket by bucket. `from` and `to` are as
  /// long as the corners. cost: O(sides)
  void divide(const Polygons& triangles, Index* from, Index* to);

  /// Writes to `of_side`, in the order of the triangles, what `of_divided` holds for each side, in
  /// the order of the buckets. cost: O(sides)
  void collect(const Polygons& triangles, const Index* of_divided, Index* of_side) const;

 private:
  static constexpr std::size_t kCount = 256;
  // Fewer, and what belongs to all of them fits into the cache, or what is asked for ahead is there
  // in time.
  static constexpr std::size_t kFewVertices = kCanPrefetch ? 1'000'000 : 150'000;

  Index shift_ = 0;  // from a vertex to its bucket
  std::array<Index, kCount + 1> begin_{};
};

}  // namespace halfedge
