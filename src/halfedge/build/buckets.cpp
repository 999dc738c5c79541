#include <halfedge/build/buckets.h>
#include <halfedge/build/each_face.h>
#include <halfedge/inlining.h>

#include <algorithm>
#include <cstddef>

namespace halfedge {

namespace {

// Whether any corner of a triangle lies near one of the next triangle, by their numbers.
bool is_near_next(const Index* corners) {
  constexpr Index kNearby = 256;
  bool is_near = false;
  for (int i = 0; i < 3; ++i) {
    for (int j = 3; j < 6; ++j) is_near |= are_near(corners[i], corners[j], kNearby);
  }
  return is_near;
}

}  // namespace

HALFEDGE_NOINLINE bool Buckets::pay(const Polygons& triangles) {
  constexpr std::size_t kSamples = 1000;
  const std::size_t count = triangles.face_count();
  if (triangles.vertex_count() < kFewVertices || count <= kSamples) return false;
  std::size_t near = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (is_near_next(&triangles.corners[3 * ((count - 1) / kSamples * i)])) ++near;
  }
  return near < kSamples / 2;
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
