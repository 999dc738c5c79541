#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/repair/repair.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/repairing.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

// Each face with vertices of its own.
Shape torn_apart(const Shape& shape) {
  std::vector<float> positions;
  std::vector<std::vector<Index>> faces;
  for (const std::vector<Index>& face : shape.faces) {
    faces.emplace_back();
    for (const Index v : face) {
      faces.back().push_back(Index(positions.size() / 3));
      positions.insert(positions.end(), &shape.positions[3 * std::size_t{v}],
                       &shape.positions[3 * std::size_t{v}] + 3);
    }
  }
  Shape torn(shape.name, Index(positions.size() / 3), faces);
  torn.positions = positions;
  return torn;
}

Repaired welded(const Shape& shape, double tolerance) {
  Repaired result(shape.polygons(), {.weld = tolerance});
  expect_sound(shape.polygons(), result);
  return result;
}

Shape points(const std::vector<std::array<float, 3>>& positions) {
  Shape shape("points", 0, {});
  for (const auto& p : positions) shape.positions.insert(shape.positions.end(), p.begin(), p.end());
  return shape;
}

TEST(Weld, MakesAMeshOfASoup) {
  for (const Shape& shape : {cube(), torus(5, 6), mixed_polygons(), disk(9)}) {
    const Shape soup = torn_apart(shape);
    EXPECT_EQ(Repaired(soup.polygons()).mesh.vertex_count(), soup.vertices) << "kept apart";
    const Repaired result = welded(soup, 0);
    EXPECT_EQ(result.mesh.vertex_count(), shape.vertices);
    EXPECT_EQ(result.mesh.edge_count(), Repaired(shape.polygons()).mesh.edge_count());
    EXPECT_EQ(result.report.count(RepairCode::kCoincidentPosition), soup.vertices - shape.vertices);
  }
  const Repaired result = welded(torn_apart(tetrahedron()), 0);
  EXPECT_EQ(result.report.summary, "8 vertices welded to others.");
  EXPECT_EQ(result.messages(),
            std::vector<std::string>{"coincident-position: 8 vertices were welded to another at "
                                     "the same position: 3, 4, 6, 7, 8, 9, 10, 11."});
}

TEST(Weld, JoinsZeroAndMinusZero) {
  Repaired result(points({{0, 1, 2}, {-0.0F, 1, 2}}).polygons(), {.weld = 0});
  EXPECT_EQ(result.mesh.vertex_count(), 1U);
}

TEST(Weld, JoinsOnlyWhatIsCloserThanTheTolerance) {
  const auto count = [](const std::vector<std::array<float, 3>>& positions, double tolerance) {
    return Repaired(points(positions).polygons(), {.weld = tolerance}).mesh.vertex_count();
  };
  EXPECT_EQ(count({{0, 0, 0}, {0.5F, 0, 0}}, 0.5), 2U);
  EXPECT_EQ(count({{0, 0, 0}, {0.5F, 0, 0}}, 0.5000001), 1U);
  // Rounding to a grid would part these.
  EXPECT_EQ(count({{0.999F, 0.999F, -0.001F}, {1.001F, 1.001F, 0.001F}}, 0.01), 1U);
  EXPECT_EQ(count({{1e30F, 0, 0}, {1e30F, 1e-30F, 0}}, 1e-20), 1U);
  EXPECT_EQ(count({{1e30F, 0, 0}, {std::nextafter(1e30F, 2e30F), 0, 0}}, 1e-20), 2U);
  EXPECT_EQ(count({{-1, 0, 0}, {1, 0, 0}, {3e38F, -3e38F, 0}}, 1e300), 1U);
  EXPECT_EQ(count({{0, 0, 0}, {std::numeric_limits<float>::denorm_min(), 0, 0}}, 1e-320), 2U);
  // A unit grid, at tolerance 1.
  std::vector<std::array<float, 3>> grid;
  for (int i = 0; i < 1000; ++i) {
    grid.push_back({float(i % 10), float(i / 10 % 10), float(i / 100)});
  }
  EXPECT_EQ(count(grid, 1), 1000U);
}

TEST(Weld, CutsChains) {
  // Each is close to the next only; the groups begin at the smallest position.
  const Shape chain = points({{1.6F, 0, 0}, {0, 0, 0}, {0.8F, 0, 0}, {2.4F, 0, 0}});
  const Repaired result(chain.polygons(), {.weld = 1});
  EXPECT_EQ(result.mesh.vertex_count(), 2U);
  EXPECT_EQ(result.origins(), (std::vector<Index>{0, 1}));
  EXPECT_EQ(result.report.vertex_map[2], 1U);
  EXPECT_EQ(result.report.vertex_map[3], 0U);
}

TEST(Weld, SaysWhichFacesItMadeVanish) {
  Shape shape = triangle();
  shape.positions = {0, 0, 0, 0.1F, 0, 0, 0, 1, 0};
  const Repaired result = welded(shape, 0.5);
  EXPECT_EQ(result.mesh.face_count(), 0U);
  EXPECT_EQ(result.messages()[0],
            "repeated-vertex: Face 0 uses vertices 0 and 1, which were welded, and encloses "
            "nothing: it was left out.");
}

// Against all pairs: no two that are joined are as far apart as the tolerance; where being close is
// transitive, all that are close are joined; the order of vertices has no effect on the groups.
TEST(Weld, AgreesWithAllPairs) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const float tolerance = 0.02F * float(1 + seed % 10);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    std::vector<std::array<float, 3>> positions;
    for (int i = 0; i < 150; ++i) {
      positions.push_back(
          {coordinate(random), coordinate(random), seed % 2 == 0 ? 0 : coordinate(random)});
      if (random() % 3 == 0) positions.push_back(positions[random() % positions.size()]);
    }
    const auto distance = [&](std::size_t a, std::size_t b) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += std::pow(double{positions[a][k]} - double{positions[b][k]}, 2);
      }
      return std::sqrt(sum);
    };
    const Repaired result(points(positions).polygons(), {.weld = double{tolerance}});
    const Array<Index>& map = result.report.vertex_map;
    std::vector<std::vector<std::size_t>> close(positions.size());
    for (std::size_t a = 0; a < positions.size(); ++a) {
      for (std::size_t b = 0; b < positions.size(); ++b) {
        const double apart = distance(a, b);
        if (map[a] == map[b]) {
          EXPECT_LT(apart, double{tolerance});
        }
        if (apart < double{tolerance}) close[a].push_back(b);
      }
    }
    for (std::size_t a = 0; a < positions.size(); ++a) {
      const bool is_transitive = std::all_of(close[a].begin(), close[a].end(),
                                             [&](std::size_t b) { return close[b] == close[a]; });
      if (!is_transitive) continue;
      for (const std::size_t b : close[a]) EXPECT_EQ(map[a], map[b]);
    }

    std::vector<std::size_t> order(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    std::vector<std::array<float, 3>> shuffled;
    for (const std::size_t i : order) shuffled.push_back(positions[i]);
    const Repaired other(points(shuffled).polygons(), {.weld = double{tolerance}});
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Point p = other.mesh.position(Vertex(other.report.vertex_map[i]));
      EXPECT_EQ(p, result.mesh.position(Vertex(map[order[i]])));
    }
  }
}

}  // namespace
}  // namespace halfedge::test
