#include <gtest/gtest.h>
#include <halfedge/build/buckets.h>
#include <halfedge/build/build.h>

#include <algorithm>
#include <cstddef>

#include "support/large_torus.h"
#include "support/same_links.h"

// Meshes whose sides are divided among buckets: it takes a million vertices.

namespace halfedge::test {
namespace {

// A mesh without prev has no room to divide its sides.
TEST(BuildBuckets, LeadToTheSameMeshAsWithoutThem) {
  const Triangles torus = shuffled(large_torus(1100), 2);
  ASSERT_TRUE(Buckets::pay(torus.polygons()));
  Mesh mesh;
  BasicMesh<kWithoutPrev> without;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(without, torus.polygons(), report));
  for (int build = 0; build < 2; ++build) {  // into fresh memory, and into that of before
    ASSERT_TRUE(build_from_polygons(mesh, torus.polygons(), report));
    expect_same_links_but_prev(mesh.links(), without.links(), "torus");
    for (const Halfedge h : mesh.halfedges()) ASSERT_EQ(mesh.prev(mesh.next(h)), h);
  }
}

TEST(BuildBuckets, LeadToTheSameRefusals) {
  Triangles torus = shuffled(large_torus(1100), 3);
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
