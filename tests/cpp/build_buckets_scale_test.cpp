#include <gtest/gtest.h>
#include <halfedge/build/buckets.h>
#include <halfedge/build/build.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support/large_torus.h"
#include "support/same_links.h"

// Meshes whose sides are divided among buckets: it takes 450,000 vertices.

namespace halfedge::test {
namespace {

// A mesh without prev has no room to divide its sides.
TEST(BuildBuckets, LeadToTheSameMeshAsWithoutThem) {
  const Triangles torus = shuffled(large_torus(700), 2);
  Mesh mesh;
  BasicMesh<kWithoutPrev> without;
  BuildReport report;
  for (const Index gap : {0U, 3U, 50U}) {  // with few holes, and with many
    const Triangles triangles = without_some(torus, gap);
    ASSERT_TRUE(Buckets::pay(triangles.polygons()));
    ASSERT_TRUE(build_from_polygons(without, triangles.polygons(), report));
    for (int build = 0; build < 2; ++build) {  // into other memory, and into that of before
      ASSERT_TRUE(build_from_polygons(mesh, triangles.polygons(), report));
      expect_same_links_but_prev(mesh.links(), without.links(), "torus");
      for (const Halfedge h : mesh.halfedges()) ASSERT_EQ(mesh.prev(mesh.next(h)), h);
    }
  }
}

// A torus beside a fan around a vertex whose sides are too many for a bucket.
TEST(BuildBuckets, AreLeftOutWhereOneWouldBeTooLarge) {
  Triangles triangles = large_torus(420);
  const Index hub = Index(triangles.positions.size() / 3);
  constexpr Index kRim = 300'000;
  for (Index v = hub + 1; v < hub + kRim; ++v) {
    for (const Index corner : {hub, v, v + 1}) triangles.corners.push_back(corner);
  }
  triangles.positions.resize(3 * std::size_t{hub + kRim + 1});
  triangles = shuffled(triangles, 4);
  std::vector<Index> uses(triangles.positions.size() / 3);
  for (const Index corner : triangles.corners) ++uses[corner];
  const Index its_name = Index(std::max_element(uses.begin(), uses.end()) - uses.begin());
  for (Index& corner : triangles.corners) {  // the smaller vertex of all its edges
    corner = corner == its_name ? 0 : corner == 0 ? its_name : corner;
  }
  Mesh mesh;
  BasicMesh<kWithoutPrev> without;
  BuildReport report;
  ASSERT_TRUE(Buckets::pay(triangles.polygons()));
  ASSERT_TRUE(build_from_polygons(mesh, triangles.polygons(), report));
  ASSERT_TRUE(build_from_polygons(without, triangles.polygons(), report));
  expect_same_links_but_prev(mesh.links(), without.links(), "a fan");
}

TEST(BuildBuckets, LeadToTheSameRefusals) {
  Triangles torus = shuffled(large_torus(700), 3);
  std::reverse(torus.corners.begin() + 3000, torus.corners.begin() + 3003);
  ASSERT_TRUE(Buckets::pay(torus.polygons()));
  Mesh mesh;
  BuildReport report;
  ASSERT_FALSE(build_from_polygons(mesh, torus.polygons(), report));
  ASSERT_FALSE(report.problems.empty());
  EXPECT_EQ(report.problems[0].code, "opposite-orientation");
  BasicMesh<kWithoutPrev> without;
  BuildReport of_without;
  ASSERT_FALSE(build_from_polygons(without, torus.polygons(), of_without));
  ASSERT_EQ(report.problems.size(), of_without.problems.size());
  for (std::size_t i = 0; i < report.problems.size(); ++i) {
    EXPECT_EQ(report.problems[i].message, of_without.problems[i].message);
  }
}

}  // namespace
}  // namespace halfedge::test
