#include <halfedge/build/order.h>
#include <halfedge/inlining.h>

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

bool lie_in_rows(const Polygons& polygons) {
  constexpr std::size_t kSamples = 128;
  constexpr std::size_t kLater = 96;  // a multiple of six and eight: pairs of triangles, and quads
  constexpr std::size_t kCorners = 3;
  constexpr Index kNearby = 512;  // along a curve that fills space, every sixth is farther away
  const std::size_t count = polygons.corners.size();
  if (count < kSamples * kLater) return true;
  const std::size_t step = (count - kLater - kCorners) / kSamples;
  std::size_t near = 0;
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    const Index* const corners = &polygons.corners[step * sample];
    bool is_near = true;
    for (std::size_t i = 0; i < kCorners; ++i) {
      is_near &= are_near(corners[i], corners[i + kLater], kNearby);
    }
    if (is_near) ++near;
  }
  return near > kSamples * 15 / 16;
}

HALFEDGE_NOINLINE bool lie_at_random(const Polygons& triangles) {
  constexpr std::size_t kSamples = 1000;
  const std::size_t count = triangles.face_count();
  if (count <= kSamples) return false;
  std::size_t near = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (is_near_next(&triangles.corners[3 * ((count - 1) / kSamples * i)])) ++near;
  }
  return near < kSamples / 2;
}

}  // namespace halfedge
