#include <gtest/gtest.h>
#include <halfedge/repair/repair.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "support/repairing.h"
#include "support/scaling.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

template <class MakeShape>
void expect_linear(const MakeShape& make, Index large_size, const RepairOptions& options = {}) {
  const Shape sample = make(large_size / 10);
  expect_sound(sample.polygons(), Repaired(sample.polygons(), options));
  const Shape large = make(large_size);
  expect_sound(large.polygons(), Repaired(large.polygons(), options));
  expect_no_quadratic_step(large_size, make, [&options](const Shape& shape) {
    const Repaired result(shape.polygons(), options);
  });
}

using Lists = std::vector<std::vector<Index>>;

TEST(RepairScale, FacesOnOneEdge) {
  expect_linear(
      [](Index n) {
        Lists faces;
        for (Index i = 0; i < n; ++i) {
          faces.push_back(i % 3 == 0 ? std::vector<Index>{1, 0, 2 + i}
                                     : std::vector<Index>{0, 1, 2 + i});
        }
        return Shape{"faces on one edge", n + 2, faces};
      },
      20'000);
}

TEST(RepairScale, ClosedFansAtOneVertex) {
  expect_linear(
      [](Index n) {
        Lists faces;
        for (Index a = 1; a < 3 * n; a += 3) {
          faces.insert(faces.end(),
                       {{0, a, a + 1}, {0, a + 1, a + 2}, {0, a + 2, a}, {a, a + 2, a + 1}});
        }
        return Shape{"closed fans", 3 * n + 1, faces};
      },
      10'000);
}

TEST(RepairScale, AVertexOfHighValenceWithFins) {
  expect_linear(
      [](Index n) {
        Lists faces = disk(n).faces;
        for (Index i = 0; i < n; ++i) faces.push_back({0, 1 + i, n + 1 + i});
        for (Index i = 0; i < n; i += 3) std::swap(faces[i][0], faces[i][1]);
        return Shape{"fan with fins", 2 * n + 1, faces};
      },
      20'000);
}

TEST(RepairScale, DuplicatesOfOneFace) {
  expect_linear([](Index n) { return Shape{"duplicates", 3, Lists(n, {2, 0, 1})}; }, 50'000);
}

TEST(RepairScale, LargeFaces) {
  expect_linear(
      [](Index n) {
        std::vector<Index> face(n);
        std::iota(face.begin(), face.end(), 0U);
        std::vector<Index> twice = face;
        twice.insert(twice.end(), face.begin(), face.end());
        std::vector<Index> there_and_back = face;
        there_and_back.insert(there_and_back.end(), face.rbegin(), face.rend());
        return Shape{"large faces", n, {face, face, twice, there_and_back, std::vector<Index>(n)}};
      },
      100'000);
}

TEST(RepairScale, LargeFacesThatShareTheirSides) {
  expect_linear(
      [](Index n) {
        std::vector<Index> face(n);
        std::iota(face.begin(), face.end(), 0U);
        Lists faces(3, face);
        for (Index i = 0; i < 3; ++i) faces[i].push_back(n + i);
        return Shape{"large faces that share their sides", n + 3, faces};
      },
      20'000);
}

TEST(RepairScale, AOneSidedStrip) {
  expect_linear(
      [](Index n) {
        Lists faces;
        for (Index i = 0; i + 1 < n; ++i) {
          faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
          if (i % 5 < 2) std::reverse(faces.back().begin(), faces.back().end());
        }
        faces.push_back({2 * n - 2, 1, 0, 2 * n - 1});
        return Shape{"Moebius strip", 2 * n, faces};
      },
      20'000);
}

// All in one cell, all at one position, and in a line with cells of one vertex or of many.
TEST(RepairScale, WeldingAtAnyTolerance) {
  const auto line = [](Index n) { return Shape{"line", n, {}}; };
  const auto cloud = [](Index n) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> coordinate(0, 1);
    Shape shape("cloud", n, {});
    for (float& x : shape.positions) x = coordinate(random);
    return shape;
  };
  for (const double tolerance : {0.0, 1e-5, 1e-2, 0.3, 1e10}) {
    SCOPED_TRACE(tolerance);
    expect_linear(line, 20'000, {.weld = tolerance});
    expect_linear(cloud, 20'000, {.weld = tolerance});
  }
  expect_linear(
      [](Index n) {
        Shape shape("one position", n, {});
        std::fill(shape.positions.begin(), shape.positions.end(), 1.0F);
        return shape;
      },
      50'000, {.weld = 0});
}

}  // namespace
}  // namespace halfedge::test
