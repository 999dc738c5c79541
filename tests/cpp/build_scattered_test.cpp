#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/build/connect_scattered.h>
#include <halfedge/build/fans.h>
#include <halfedge/build/strict.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "support/built.h"
#include "support/canonical.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

// Triangles in no order are connected block by block of their vertices, in large meshes. Here in
// small ones too, with blocks so small that most triangles wait for another.

namespace halfedge::test {
namespace {

/// `scratch` has one entry for each vertex after that.
Groups groups_of(const Shape& shape, Array<Index>& scratch) {
  Groups groups;
  bool repeated = true;
  EXPECT_TRUE(count_groups<true>(shape.polygons(), scratch, groups, repeated));
  EXPECT_FALSE(repeated) << shape.name;
  return groups;
}

template <bool kPrev>
ConnectResult connect_in_blocks(const Shape& shape, int block_bits, Links& links) {
  const Groups groups = groups_of(shape, links.vertex_halfedge);
  return connect_scattered<kPrev>(shape.polygons(), groups, links, block_bits);
}

bool is_scattered(const Shape& shape) {
  Array<Index> scratch;
  return are_scattered(shape.polygons(), groups_of(shape, scratch));
}

bool same_words(const Array<Index>& a, const Array<Index>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// Each polygon cut from its first corner.
Shape triangulated(const Shape& shape) {
  std::vector<std::vector<Index>> triangles;
  for (const std::vector<Index>& face : shape.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      triangles.push_back({face[0], face[i - 1], face[i]});
    }
  }
  return {shape.name + ", triangulated", shape.vertices, std::move(triangles)};
}

/// The whole mesh, with prev or without, or nothing where the triangles are not manifold.
void expect_as_described(const Shape& shape, int block_bits) {
  Mesh expected;
  BuildReport report;
  const bool is_manifold = build_from_polygons(expected, shape.polygons(), report);
  const std::string name = shape.name + ", blocks of 2^" + std::to_string(block_bits);

  Mesh mesh;
  Links& links = mesh.mutable_links();
  const ConnectResult result = connect_in_blocks<true>(shape, block_bits, links);
  if (!is_manifold && result == ConnectResult::kNotManifold) return;
  ASSERT_EQ(result, ConnectResult::kDone) << name;
  ASSERT_TRUE(join_open_fans(links));
  ASSERT_EQ(each_vertex_has_one_cycle(links), is_manifold) << name;
  if (!is_manifold) return;
  ASSERT_EQ(copy_positions(shape.polygons().positions, mesh.mutable_positions()),
            ConnectResult::kDone);
  expect_valid(mesh, name);
  expect_same(mesh, reference_build(shape), name);

  Links without;
  ASSERT_EQ(connect_in_blocks<false>(shape, block_bits, without), ConnectResult::kDone) << name;
  ASSERT_TRUE(join_open_fans(without));
  EXPECT_TRUE(without.prev.empty());
  EXPECT_TRUE(same_words(without.next, links.next)) << name;
  EXPECT_TRUE(same_words(without.to_vertex, links.to_vertex)) << name;
  EXPECT_TRUE(same_words(without.face, links.face)) << name;
}

TEST(BuildScattered, MakesTheMeshThatTheContractDescribesFromEveryShape) {
  for (const Shape& shape : all_shapes()) {
    for (const int bits : {0, 1, 3, 12}) {
      expect_as_described(triangulated(shape), bits);
      expect_as_described(in_random_order(triangulated(shape)), bits);
    }
  }
}

TEST(BuildScattered, MakesTheMeshThatTheContractDescribesFromRandomTriangles) {
  int manifold = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const Shape shape = triangulated(random_polygons(seed));
    BuildReport report;
    Mesh mesh;
    manifold += build_from_polygons(mesh, shape.polygons(), report) ? 1 : 0;
    expect_as_described(shape, int(seed % 5));
  }
  EXPECT_GT(manifold, 50);  // diagonals can meet
}

// Whether the edges of a fan around a hub are foreseen, and where they are numbered, depends on the
// number of the hub.
TEST(BuildScattered, FindsTheEdgesOfHubsAndOfLooseTriangles) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    expect_as_described(in_random_order(disk(12 + seed), seed), int(seed % 4));
    expect_as_described(in_random_order(bipyramid(12 + seed), seed), int(seed % 4));
  }
  const Shape loose = loose_triangles(5000);
  for (const int bits : {2, 8}) {
    expect_as_described(loose, bits);
    expect_as_described(in_random_order(loose), bits);
  }
}

// ---- of the size from which builds choose this way

/// With holes and pinched vertices.
Shape large_grid() {
  Shape shape = triangle_grid(400, 400);
  std::mt19937 random(7);
  std::erase_if(shape.faces, [&](const std::vector<Index>&) { return random() % 50 == 0; });
  return {shape.name, shape.vertices, shape.faces};
}

TEST(BuildScattered, IsChosenForLargeMeshesInNoOrder) {
  const Shape grid = large_grid();
  EXPECT_FALSE(is_scattered(grid));
  EXPECT_FALSE(is_scattered(with_random_names(grid)));  // most share a vertex with the next
  EXPECT_TRUE(is_scattered(in_random_order(grid)));
  EXPECT_FALSE(is_scattered(in_random_order(triangle_grid(300, 300))));
}

TEST(BuildScattered, IsNotChosenWhereTrianglesAreNearTheNextByNumber) {
  EXPECT_FALSE(is_scattered(loose_triangles(60'000)));
  EXPECT_TRUE(is_scattered(in_random_order(loose_triangles(60'000))));
}

// As of a mesh whose triangles were divided in four: each fourth of them is far from the next. They
// are so many that evenly spaced samples would all be such fourths.
TEST(BuildScattered, IsNotChosenWhereThreeOfFourTrianglesShareAVertexWithTheNext) {
  const Index quarters = 20 * 1024;
  const Index vertices = 8 * quarters;
  std::vector<std::vector<Index>> faces;
  for (Index v = 0; v < vertices; v += 8) {
    for (Index i = 0; i < 4; ++i) faces.push_back({v + i, v + i + 1, v + i + 2});
  }
  const Shape strips = with_random_names({"strips", vertices, std::move(faces)});
  EXPECT_FALSE(is_scattered(strips));
  EXPECT_TRUE(is_scattered(in_random_order(strips)));
}

TEST(BuildScattered, IsNotChosenAroundAVertexOfHighValence) {
  EXPECT_FALSE(is_scattered(in_random_order(bipyramid(200'000))));
}

TEST(BuildScattered, MakesTheMeshThatTheContractDescribesOfALargeGrid) {
  const Shape shape = in_random_order(with_random_names(large_grid()));
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, shape.polygons(), report));
  expect_valid(mesh, shape.name);
  expect_same(mesh, reference_build(shape), shape.name);
}

TEST(BuildScattered, RefusesALargeGridWithOneFaceTwice) {
  const Shape grid = in_random_order(with_random_names(large_grid()));
  std::vector<std::vector<Index>> faces = grid.faces;
  faces.push_back(faces[12'345]);
  const Shape shape{grid.name, grid.vertices, std::move(faces)};
  Mesh mesh;
  BuildReport report;
  ASSERT_FALSE(build_from_polygons(mesh, shape.polygons(), report));
  EXPECT_EQ(report.problems[0].code, "duplicate-face");
  EXPECT_EQ(mesh.vertex_slots(), 0U);
}

}  // namespace
}  // namespace halfedge::test
