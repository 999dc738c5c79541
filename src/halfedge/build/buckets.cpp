#include <halfedge/build/buckets.h>
#include <halfedge/build/each_face.h>

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

bool Buckets::pay(const Polygons& triangles) {
  constexpr std::size_t kSamples = 1000;
  const std::size_t count = triangles.face_count();
  if (triangles.vertex_count() < kFewVertices || count <= kSamples) return false;
  std::size_t near = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (is_near_next(&triangles.corners[3 * ((count - 1) / kSamples * i)])) ++near;
  }
  return near < kSamples / 2;
}

bool Buckets::set_up(const Groups& groups, std::size_t vertices) {
  shift_ = 0;
  while ((vertices - 1) >> shift_ >= kCount) ++shift_;
  bool are_small = true;
  for (std::size_t i = 0; i <= kCount; ++i) {
    const std::size_t first = i << shift_;
    begin_[i] = first < vertices ? groups.begin_of(Index(first)) : groups.end();
    if (i > 0) are_small &= begin_[i] - begin_[i - 1] <= vertices;
  }
  return are_small;
}

}  // namespace halfedge
