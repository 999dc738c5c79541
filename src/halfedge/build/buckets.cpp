#include <halfedge/build/buckets.h>
#include <halfedge/build/each_face.h>
#include <halfedge/build/groups.h>

namespace halfedge {

namespace {

// Calls `visit(bucket, from, to)` for each side.
template <class Visit>
void for_each_side(const Polygons& triangles, Index shift, const Visit& visit) {
  for_each_face<true>(triangles, [&](Index, const Index* corners, auto size) {
    for (Index i = 0; i < size; ++i) {
      const Index from = corners[i];
      const Index to = corners[i + 1 == size ? 0 : i + 1];
      visit(DirectedSide(from, to).low >> shift, from, to);
    }
  });
}

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

void Buckets::divide(const Polygons& triangles, Index* from, Index* to) {
  shift_ = 0;
  while ((triangles.vertex_count() - 1) >> shift_ >= kCount) ++shift_;
  begin_.fill(0);
  for_each_side(triangles, shift_, [&](Index bucket, Index, Index) { ++begin_[bucket + 1]; });
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::array<Index, kCount + 1> next = begin_;
  for_each_side(triangles, shift_, [&](Index bucket, Index a, Index b) {
    const Index place = next[bucket]++;
    from[place] = a;
    to[place] = b;
  });
}

void Buckets::collect(const Polygons& triangles, const Index* of_divided, Index* of_side) const {
  std::array<Index, kCount + 1> next = begin_;
  for_each_side(triangles, shift_,
                [&](Index bucket, Index, Index) { *of_side++ = of_divided[next[bucket]++]; });
}

}  // namespace halfedge
