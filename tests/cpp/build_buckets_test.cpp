#include <gtest/gtest.h>
#include <halfedge/build/buckets.h>
#include <halfedge/build/groups.h>
#include <halfedge/connectivity/array.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "support/large_torus.h"

// Triangles in random order, whose sides are divided among buckets before they are matched.

namespace halfedge::test {
namespace {

/// Where the sides of a mesh are kept.
struct Divided {
  Groups groups;
  Buckets buckets;
  bool are_small = false;
  std::vector<Index> slot_of;  // by side, in the order of the faces

  explicit Divided(const Triangles& mesh) : slot_of(mesh.corners.size()) {
    Array<Index> last_face;
    bool repeated = false;
    EXPECT_TRUE(groups.count<true>(mesh.polygons(), last_face, repeated));
    are_small = buckets.set_up(groups, mesh.polygons().vertex_count());
    visit(mesh, [&](std::size_t side, Index slot) { slot_of[side] = slot; });
  }

  template <class Visit>
  void visit(const Triangles& mesh, const Visit& visit) {
    buckets.for_each_triangle(mesh.polygons(), [&](Index f, const Index* corners, auto& slots) {
      EXPECT_EQ(corners, &mesh.corners[3 * std::size_t{f}]);
      for (std::size_t i = 0; i < 3; ++i) visit(3 * std::size_t{f} + i, slots[i]);
    });
  }
};

Index smaller_vertex(const Triangles& mesh, std::size_t side) {
  return std::min(mesh.corners[side], mesh.corners[side % 3 == 2 ? side - 2 : side + 1]);
}

TEST(BuildBuckets, KeepEachSideAmongThePlacesOfItsVertices) {
  for (const Index size : {3U, 4U, 20U, 301U}) {
    for (const Index gap : {0U, 5U}) {
      const Triangles mesh = without_some(shuffled(large_torus(size), size), gap);
      Divided divided(mesh);
      if (size >= 20) EXPECT_TRUE(divided.are_small);
      std::vector<bool> is_taken(divided.groups.end());
      for (const Index slot : divided.slot_of) {
        ASSERT_FALSE(is_taken.at(slot));
        is_taken[slot] = true;
      }
      std::vector<std::size_t> bucket_of(divided.groups.end());  // by place
      Index places = 0;
      std::size_t bucket = 0;
      divided.buckets.for_each_bucket([&](Index begin, Index end, Index places_end) {
        ASSERT_EQ(begin, places);
        ASSERT_LE(end, places_end);
        for (Index place = begin; place < places_end; ++place) {
          ASSERT_EQ(is_taken[place], place < end);
          bucket_of[place] = bucket;
        }
        places = places_end;
        ++bucket;
      });
      EXPECT_EQ(places, divided.groups.end());
      for (std::size_t side = 0; side < mesh.corners.size(); ++side) {
        const Index place_of_group = divided.groups.begin_of(smaller_vertex(mesh, side));
        ASSERT_EQ(bucket_of[divided.slot_of[side]], bucket_of[place_of_group]);
      }
      divided.visit(mesh, [&](std::size_t side, Index slot) {
        ASSERT_EQ(slot, divided.slot_of[side]);  // the same once more
      });
    }
  }
}

TEST(BuildBuckets, KeepTheOrderOfTheSidesOfAVertex) {
  const Triangles mesh = shuffled(large_torus(100), 5);
  const Divided divided(mesh);
  std::vector<Index> last(mesh.positions.size() / 3, 0);  // one on
  for (std::size_t side = 0; side < mesh.corners.size(); ++side) {
    Index& before = last[smaller_vertex(mesh, side)];
    EXPECT_GT(divided.slot_of[side] + 1, before);
    before = divided.slot_of[side] + 1;
  }
}

TEST(BuildBuckets, AreTooLargeAroundAVertexOfHugeValence) {
  constexpr Index kRim = 10'000;
  Triangles fan;
  fan.positions.resize(3 * std::size_t{kRim + 1});
  for (Index v = 1; v <= kRim; ++v) {
    for (const Index corner : {0U, v, v % kRim + 1}) fan.corners.push_back(corner);
  }
  EXPECT_FALSE(Divided(fan).are_small);
}

TEST(BuildBuckets, PayForManyVerticesInRandomOrder) {
  constexpr Index kMany = 700;  // squared
  const Triangles large = large_torus(kMany);
  EXPECT_FALSE(Buckets::pay(large.polygons()));
  EXPECT_TRUE(Buckets::pay(shuffled(large, 1).polygons()));
  EXPECT_FALSE(Buckets::pay(shuffled(large_torus(kMany / 2), 1).polygons()));
  EXPECT_FALSE(Buckets::pay({large.positions, {}, {}}));
  EXPECT_FALSE(Buckets::pay({large.positions, {}, std::span(large.corners).first(3000)}));
}

}  // namespace
}  // namespace halfedge::test
