#include <gtest/gtest.h>
#include <halfedge/directed_edges/build.h>

#include "support/directed_edges.h"
#include "support/scaling.h"

namespace halfedge::test {
namespace {

TEST(DirectedEdgesScale, FansOfAHundredThousandTriangles) {
  for (const auto& make : {disk, bipyramid, pinched}) {
    expect_no_quadratic_step(
        100'000, [&](Index n) { return in_random_order(make(n)); },
        [](const Shape& shape) {
          DirectedEdgesMesh mesh;
          BuildReport report;
          EXPECT_TRUE(build_from_triangles(mesh, shape.polygons(), report));
        });
  }
}

}  // namespace
}  // namespace halfedge::test
