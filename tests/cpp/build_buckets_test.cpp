#include <gtest/gtest.h>
#include <halfedge/build/buckets.h>
#include <halfedge/build/groups.h>
#include <halfedge/connectivity/array.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "support/large_torus.h"

// Triangles in random order, whose sides are divided among buckets before they are matched.

namespace halfedge::test {
namespace {

Index end_of(const Triangles& mesh, std::size_t side) {
  return mesh.corners[side % 3 == 2 ? side - 2 : side + 1];
}

Index smaller_vertex(const Triangles& mesh, std::size_t side) {
  return std::min(mesh.corners[side], end_of(mesh, side));
}

bool runs_up(const Triangles& mesh, std::size_t side) {
  return mesh.corners[side] < end_of(mesh, side);
}

/// Where the sides of a mesh are kept.
struct Divided {
  Groups groups;
  Buckets buckets;
  bool are_small = false;
  std::vector<Index> lists;    // by face
  std::vector<Index> slot_of;  // by side, in the order of the faces

  explicit Divided(const Triangles& mesh) : lists(mesh.corners.size() / 3) {
    Array<Index> last_face;
    bool repeated = false;
    EXPECT_TRUE(groups.count<true>(mesh.polygons(), last_face, repeated));
    are_small = buckets.set_up(groups, mesh.polygons().vertex_count());
    buckets.divide(mesh.polygons(), lists, [&](Index slot, Index low, Index high) {
      const std::size_t side = slot_of.size();
      EXPECT_EQ(low, smaller_vertex(mesh, side));
      EXPECT_EQ(high, mesh.corners[side] + end_of(mesh, side) - low);
      slot_of.push_back(slot);
    });
  }
};

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
      std::vector<bool> is_up(divided.groups.end());
      Index places = 0;
      std::size_t bucket = 0;
      divided.buckets.for_each_bucket([&](const Bucket& b) {
        ASSERT_EQ(b.begin, places);
        ASSERT_TRUE(b.begin <= b.ups_end && b.ups_end <= b.downs_begin);
        ASSERT_TRUE(b.downs_begin <= b.downs_end && b.downs_end <= b.end);
        for (Index place = b.begin; place < b.end; ++place) {
          is_up[place] = place < b.ups_end;
          const bool is_down = place >= b.downs_begin && place < b.downs_end;
          ASSERT_EQ(is_taken[place], is_up[place] || is_down);
          bucket_of[place] = bucket;
        }
        places = b.end;
        ++bucket;
      });
      EXPECT_EQ(places, divided.groups.end());
      for (std::size_t side = 0; side < mesh.corners.size(); ++side) {
        const Index place_of_group = divided.groups.begin_of(smaller_vertex(mesh, side));
        ASSERT_EQ(bucket_of[divided.slot_of[side]], bucket_of[place_of_group]);
        ASSERT_EQ(is_up[divided.slot_of[side]], runs_up(mesh, side));
      }
      Index faces = 0;
      divided.buckets.for_each_triangle(divided.lists, [&](Index f, const auto& slots) {
        ASSERT_EQ(f, faces++);
        for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(slots[i], divided.slot_of[3 * f + i]);
        divided.lists[f] = kNone;
      });
      EXPECT_EQ(faces, divided.lists.size());
    }
  }
}

TEST(BuildBuckets, KeepTheOrderOfTheSidesOfAVertexInEachDirection) {
  const Triangles mesh = shuffled(large_torus(100), 5);
  const Divided divided(mesh);
  std::map<std::pair<Index, bool>, Index> last;  // one on
  for (std::size_t side = 0; side < mesh.corners.size(); ++side) {
    Index& before = last[{smaller_vertex(mesh, side), runs_up(mesh, side)}];
    EXPECT_GT(divided.slot_of[side] + 1, before);
    before = divided.slot_of[side] + 1;
  }
}

/// A closed fan around vertex 0.
Triangles fan(Index rim) {
  Triangles mesh;
  mesh.positions.resize(3 * std::size_t{rim + 1});
  for (Index v = 1; v <= rim; ++v) {
    for (const Index corner : {0U, v, v % rim + 1}) mesh.corners.push_back(corner);
  }
  return mesh;
}

TEST(BuildBuckets, AreTooLargeAroundAVertexOfHugeValence) {
  EXPECT_FALSE(Divided(fan(10'000)).are_small);
}

/// Its group would be searched through for each of its sides.
TEST(BuildBuckets, AreTooSlowAroundAVertexOfLargeValenceAmongManyOthers) {
  const auto are_small = [](Index rim) {
    Triangles mesh = fan(rim);
    const Triangles torus = large_torus(400);
    const Index first = rim + 1;
    mesh.positions.insert(mesh.positions.end(), torus.positions.begin(), torus.positions.end());
    for (const Index corner : torus.corners) mesh.corners.push_back(first + corner);
    return Divided(mesh).are_small;
  };
  EXPECT_TRUE(are_small(2048));
  EXPECT_FALSE(are_small(2049));
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
