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

TEST(BuildBuckets, TellTheNumberOfEachSideInTheOrderOfTheFaces) {
  for (const Index size : {1U, 2U, 3U, 20U, 301U}) {
    const Triangles mesh = shuffled(large_torus(size), size);
    const std::size_t sides = mesh.corners.size();
    std::vector<Index> from(sides), to(sides), numbers(sides), by_side(sides);
    Buckets buckets;
    buckets.divide(mesh.polygons(), from.data(), to.data());
    std::iota(numbers.begin(), numbers.end(), 0U);
    buckets.collect(mesh.polygons(), numbers.data(), by_side.data());
    for (std::size_t side = 0; side < sides; ++side) {
      const std::size_t next = side % 3 == 2 ? side - 2 : side + 1;
      ASSERT_EQ(from[by_side[side]], mesh.corners[side]);
      ASSERT_EQ(to[by_side[side]], mesh.corners[next]);
    }
    std::sort(by_side.begin(), by_side.end());
    EXPECT_EQ(by_side, numbers);
  }
}

TEST(BuildBuckets, KeepTheOrderOfTheSidesOfAVertex) {
  const Triangles mesh = shuffled(large_torus(100), 5);
  const std::size_t sides = mesh.corners.size();
  std::vector<Index> from(sides), to(sides), numbers(sides), side_of(sides);
  Buckets buckets;
  buckets.divide(mesh.polygons(), from.data(), to.data());
  std::iota(numbers.begin(), numbers.end(), 0U);
  buckets.collect(mesh.polygons(), numbers.data(), side_of.data());
  std::vector<Index> last(mesh.positions.size() / 3, 0);  // one on
  for (std::size_t side = 0; side < sides; ++side) {
    const Index place = side_of[side];
    Index& before = last[std::min(from[place], to[place])];
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
