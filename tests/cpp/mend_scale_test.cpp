// Repairs of large inputs that are chosen to be slow: each takes about linear time.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/operations/append.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/mending.h"
#include "support/scaling.h"

namespace halfedge::test {
namespace {

using Lists = std::vector<std::vector<Index>>;

/// That the repair does so much, which its summary says, and nothing else.
void expect_summary(const Result<mend::Report>& report, const std::string& summary) {
  ASSERT_TRUE(report);
  EXPECT_EQ(report.value().summary, summary);
}

// A strip of quads whose upper vertices coincide.
TEST(MendScale, APoleThatIsNotMerged) {
  const auto strip = [](Index n) {
    std::vector<Point> points(n + 1, Point{0, 1, 0});
    Lists faces;
    for (Index i = 0; i < n; ++i) faces.push_back({n + 1 + i, n + 2 + i, i + 1, i});
    for (Index i = 0; i <= n; ++i) {
      const double angle = 6.0 * i / n;
      points.push_back({float(std::cos(angle)), 0, float(std::sin(angle))});
    }
    return mesh_of(points, faces);
  };
  expect_no_quadratic_step(20'000, strip, [](Mesh& mesh) {
    const std::string edges = std::to_string(mesh.face_count());
    expect_summary(mend::remove_degenerate_faces(mesh), edges + " edges collapsed.");
  });
}

}  // namespace
}  // namespace halfedge::test
