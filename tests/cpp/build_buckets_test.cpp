#include <gtest/gtest.h>
#include <halfedge/build/buckets.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "support/large_torus.h"

// Triangles in random order, whose sides are divided among buckets before they are matched.

namespace halfedge::test {
namespace {

/// The sides of a mesh after division, and where each of them went.
struct Divided {
  std::vector<Index> from;
  std::vector<Index> to;
  std::vector<Index> place_of;  // by side, in the order of the faces

  explicit Divided(const Triangles& mesh)
      : from(mesh.corners.size()), to(mesh.corners.size()), place_of(mesh.corners.size()) {
    Buckets buckets;
    buckets.divide(mesh.polygons(), from.data(), to.data());
    std::vector<Index> places(mesh.corners.size());
    std::iota(places.begin(), places.end(), 0U);
    buckets.collect(mesh.polygons(), places.data(), place_of.data());
  }
};

TEST(BuildBuckets, TellTheNumberOfEachSideInTheOrderOfTheFaces) {
  for (const Index size : {3U, 4U, 20U, 301U}) {
    const Triangles mesh = shuffled(large_torus(size), size);
    Divided divided(mesh);
    for (std::size_t side = 0; side < mesh.corners.size(); ++side) {
      const std::size_t next = side % 3 == 2 ? side - 2 : side + 1;
      ASSERT_EQ(divided.from[divided.place_of[side]], mesh.corners[side]);
      ASSERT_EQ(divided.to[divided.place_of[side]], mesh.corners[next]);
    }
    std::sort(divided.place_of.begin(), divided.place_of.end());
    std::vector<Index> places(mesh.corners.size());
    std::iota(places.begin(), places.end(), 0U);
    EXPECT_EQ(divided.place_of, places);
  }
}

TEST(BuildBuckets, KeepTheOrderOfTheSidesOfAVertex) {
  const Triangles mesh = shuffled(large_torus(100), 5);
  const Divided divided(mesh);
  std::vector<Index> last(mesh.positions.size() / 3, 0);  // one on
  for (const Index place : divided.place_of) {
    Index& before = last[std::min(divided.from[place], divided.to[place])];
    EXPECT_GT(place + 1, before);
    before = place + 1;
  }
}

TEST(BuildBuckets, PayForManyVerticesInRandomOrder) {
  constexpr Index kMany = 1100;  // squared
  const Triangles large = large_torus(kMany);
  EXPECT_FALSE(Buckets::pay(large.polygons()));
  EXPECT_TRUE(Buckets::pay(shuffled(large, 1).polygons()));
  EXPECT_FALSE(Buckets::pay(shuffled(large_torus(kMany / 2), 1).polygons()));
  EXPECT_FALSE(Buckets::pay({large.positions, {}, {}}));
  EXPECT_FALSE(Buckets::pay({large.positions, {}, std::span(large.corners).first(3000)}));
}

}  // namespace
}  // namespace halfedge::test
