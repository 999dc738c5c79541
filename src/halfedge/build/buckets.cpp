#include <halfedge/build/buckets.h>
#include <halfedge/build/order.h>
#include <halfedge/inlining.h>

#include <algorithm>
#include <cstddef>

namespace halfedge {

bool Buckets::pay(const Polygons& triangles) {
  return triangles.vertex_count() >= kFewVertices && lie_at_random(triangles);
}

HALFEDGE_NOINLINE bool Buckets::set_up(const Groups& groups, std::size_t vertices) {
  shift_ = 0;
  while ((vertices - 1) >> shift_ >= kCount) ++shift_;
  bool are_small = true;
  for (std::size_t i = 0; i <= kCount; ++i) {
    begin_[i] = groups.begin_of(Index(std::min(i << shift_, vertices)));
    if (i > 0) are_small &= begin_[i] - begin_[i - 1] <= vertices;
  }
  Index largest = 0;
  for (Index v = 0; v < vertices; ++v) {
    largest = std::max(largest, groups.begin_of(v + 1) - groups.begin_of(v));
  }
  return are_small && largest <= kLargestGroup;
}

}  // namespace halfedge
