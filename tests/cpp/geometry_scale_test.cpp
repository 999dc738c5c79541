// Normals of a mesh with huge faces.

#include <gtest/gtest.h>
#include <halfedge/geometry/normals.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/built.h"
#include "support/placed.h"
#include "support/scaling.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

// Two polygons back to back.
Mesh coin(Index n) {
  std::vector<std::vector<Index>> faces(2);
  std::vector<Point> points;
  for (Index i = 0; i < n; ++i) {
    faces[0].push_back(i);
    faces[1].push_back(n - 1 - i);
    const double angle = 2 * std::numbers::pi * i / n;
    points.push_back({float(std::cos(angle)), float(std::sin(angle)), 0});
  }
  return built(placed(Shape("coin", n, faces), points));
}

// Where sums cancel out, or aren't finite, each face is looked at twice, and not once from each of
// its corners.
TEST(GeometryScale, NormalsOfVerticesOfHugeFaces) {
  for (const float height : {0.0F, std::numeric_limits<float>::quiet_NaN()}) {
    SCOPED_TRACE(height);
    const auto make = [&](Index n) {
      Mesh mesh = coin(n);
      mesh.set_position(Vertex(0), {1, 0, height});
      return mesh;
    };
    expect_no_quadratic_step(30'000, make, [](const Mesh& mesh) {
      const Array<Point> normals = geometry::vertex_normals(mesh).value();
      EXPECT_TRUE(std::ranges::all_of(normals, [](Point p) { return p == Point(); }));
    });
  }
}

}  // namespace
}  // namespace halfedge::test
