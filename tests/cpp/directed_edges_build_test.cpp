// What the builder of Directed Edges refuses, as that of the full mesh does, and how it uses
// memory.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/directed_edges/convert.h>
#include <halfedge/directed_edges/validate.h>

#include <cmath>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/directed_edges.h"

namespace halfedge::test {
namespace {

// Each of these breaks one rule; indices are as in the shapes they come from.
std::vector<Shape> refused_shapes() {
  std::vector<Shape> shapes = {
      {"three faces on an edge", 5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}},
      {"three faces on an edge, last one down", 5, {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}},
      {"two sides up", 4, {{0, 1, 2}, {0, 1, 3}}},
      {"two sides down", 4, {{1, 0, 2}, {1, 0, 3}}},
      {"two pairs of sides", 6, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 0, 5}}},
      {"a face twice", 3, {{0, 1, 2}, {1, 2, 0}}},
      {"a Moebius strip", 6, {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 3, 5}, {3, 0, 5}}},
      {"a repeated vertex", 3, {{0, 1, 1}}},
      {"a vertex that isn't there", 3, {{0, 1, 3}}},
      {"a vertex far out of range", 3, {{0, 1, 0xFFFFFFFF}}},
      {"two corners", 3, {{0, 1}}},
      {"two closed fans at a vertex",
       7,
       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}}},
      {"a closed and an open fan at a vertex",
       6,
       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}}},
  };
  // Sides that repeat where groups are large.
  for (const std::vector<Index>& extra :
       {std::vector<Index>{0, 7, 101}, {7, 0, 101}, {0, 101, 7}}) {
    Shape large = disk(100);
    large.faces.push_back(extra);
    shapes.push_back({"a disk and one more face", 102, large.faces});
  }
  return shapes;
}

void expect_same_refusal(const Polygons& polygons) {
  Mesh full;
  BuildReport expected;
  ASSERT_FALSE(build_from_polygons(full, polygons, expected));
  DirectedEdgesMesh compact = built(tetrahedron());
  BuildReport report;
  ASSERT_FALSE(build_from_triangles(compact, polygons, report));
  EXPECT_EQ(compact.vertex_count(), 0U);
  EXPECT_EQ(compact.halfedge_count(), 0U);
  EXPECT_TRUE(compact.positions().empty());
  ASSERT_EQ(report.problem_count, expected.problem_count);
  ASSERT_EQ(report.problems.size(), expected.problems.size());
  for (std::size_t i = 0; i < report.problems.size(); ++i) {
    EXPECT_EQ(report.problems[i].code, expected.problems[i].code);
    EXPECT_EQ(report.problems[i].message, expected.problems[i].message);
    EXPECT_EQ(report.problems[i].witness, expected.problems[i].witness);
  }
}

TEST(DirectedEdgesBuild, RefuseWhatTheFullMeshRefusesInTheSameWords) {
  for (const Shape& shape : refused_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_same_refusal(shape.polygons());
    expect_same_refusal(in_random_order(shape).polygons());
  }
  Shape not_finite = triangle();
  not_finite.positions[4] = std::nanf("");
  expect_same_refusal(not_finite.polygons());
  const Shape shape = triangle();
  expect_same_refusal({std::span(shape.positions).first(8), {}, shape.corners});
  expect_same_refusal({shape.positions, {}, std::span(shape.corners).first(2)});
}

TEST(DirectedEdgesBuild, RefuseRandomTrianglesAsTheFullMeshDoes) {
  int refused = 0;
  int accepted = 0;
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<std::vector<Index>> faces(1 + random() % 6);
    for (std::vector<Index>& face : faces) {
      for (int i = 0; i < 3; ++i) face.push_back(Index(random() % 7));
    }
    const Shape shape{"random", 7, std::move(faces)};
    Mesh full;
    BuildReport report;
    if (build_from_polygons(full, shape.polygons(), report)) {
      expect_equivalent(shape.polygons());
      ++accepted;
    } else {
      expect_same_refusal(shape.polygons());
      ++refused;
    }
  }
  EXPECT_GT(accepted, 300);
  EXPECT_GT(refused, 300);
}

TEST(DirectedEdgesBuild, AFaceThatIsNoTriangleIsNamed) {
  DirectedEdgesMesh mesh;
  BuildReport report;
  const Shape shape = mixed_polygons();
  ASSERT_FALSE(build_from_triangles(mesh, shape.polygons(), report));
  ASSERT_EQ(report.problem_count, 3U);
  EXPECT_EQ(report.problems[0].code, "not-a-triangle");
  EXPECT_EQ(report.problems[0].message,
            "Face 1 has 4 corners; Directed Edges hold triangles only.");
  EXPECT_EQ(report.problems[0].witness, (Witness{.vertices = {0, 2, 3, 4}, .faces = {1}}));

  Mesh full;
  ASSERT_TRUE(build_from_polygons(full, shape.polygons(), report));
  const Result<void> result = from_mesh(full, mesh);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, "not-a-triangle");
  EXPECT_EQ(result.error().message, "Face 1 has 4 corners; Directed Edges hold triangles only.");
  EXPECT_EQ(mesh.vertex_count(), 0U);
}

TEST(DirectedEdgesBuild, ABuildInUsedMemoryIsTheSame) {
  DirectedEdgesMesh mesh = built(triangulated(torus(30, 30)));
  BuildReport report;
  const Shape smaller = in_random_order(triangle_grid(9, 9));
  const std::uint64_t version = mesh.version();
  ASSERT_TRUE(build_from_triangles(mesh, smaller.polygons(), report));
  EXPECT_NE(mesh.version(), version);
  expect_same_links(mesh, built(smaller));
  EXPECT_EQ(first_problem(validate(mesh)), "");

  DirectedEdgesMesh copy;
  ASSERT_TRUE(copy.assign(mesh));
  expect_same_links(copy, mesh);
  DirectedEdgesMesh moved;
  moved = std::move(copy);
  expect_same_links(moved, mesh);
  EXPECT_EQ(copy.face_count(), 0U);  // NOLINT(bugprone-use-after-move): what it is left as
}

}  // namespace
}  // namespace halfedge::test
