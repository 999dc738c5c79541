// Manifolds that were damaged in many ways at once.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/repair/repair.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/invariants.h"
#include "support/random_polygons.h"
#include "support/repairing.h"

namespace halfedge::test {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t count) { return std::size_t(random()) % count; }

// All kinds of damage, or but one of them.
Shape damaged(std::uint32_t seed) {
  Random random(seed);
  Shape shape = random_polygons(seed);
  std::vector<std::vector<Index>> faces = shape.faces;
  std::vector<float> positions = shape.positions;
  const std::size_t only = below(random, 14);
  const auto hits = [&](std::size_t kind) {
    if (only != kind && only < 8) return std::size_t{0};
    return below(random, 2 + faces.size() / 4);
  };
  const auto any_face = [&]() -> std::vector<Index>& { return faces[below(random, faces.size())]; };
  const auto any_vertex = [&] { return Index(below(random, positions.size() / 3)); };
  if (faces.empty()) faces.push_back({0, 1, 2});

  for (std::size_t n = hits(0); n > 0; --n) {
    std::vector<Index>& face = any_face();
    std::reverse(face.begin(), face.end());
  }
  for (std::size_t n = hits(1); n > 0; --n) {
    std::vector<Index> copy = any_face();
    if (copy.empty()) continue;
    std::rotate(copy.begin(), copy.begin() + std::ptrdiff_t(below(random, copy.size())),
                copy.end());
    if (below(random, 2) == 0) std::reverse(copy.begin(), copy.end());
    faces.push_back(copy);
  }
  for (std::size_t n = hits(2); n > 0; --n) {
    faces.push_back({any_vertex(), any_vertex(), any_vertex()});
  }
  for (std::size_t n = std::min<std::size_t>(hits(3), 4); n > 0; --n) {
    const Index from = any_vertex();
    const Index to = any_vertex();
    for (std::vector<Index>& face : faces) std::replace(face.begin(), face.end(), from, to);
  }
  for (std::size_t n = hits(4); n > 0; --n) {
    std::vector<Index>& face = any_face();
    if (face.empty()) continue;
    face.insert(face.begin() + std::ptrdiff_t(below(random, face.size())),
                face[below(random, face.size())]);
  }
  for (std::size_t n = std::min<std::size_t>(hits(5), 3); n > 0; --n) {
    std::vector<Index>& face = any_face();
    if (below(random, 2) == 0) {
      face.resize(below(random, 3));
    } else if (!face.empty()) {
      face[0] = Index(positions.size() / 3 + below(random, 2));
    }
  }
  for (std::size_t n = std::min<std::size_t>(hits(6), 2); n > 0; --n) {
    positions[below(random, positions.size())] = std::numeric_limits<float>::quiet_NaN();
  }
  for (std::size_t n = hits(7); n > 0; --n) {
    std::vector<Index>& face = any_face();
    if (face.empty()) continue;
    Index& corner = face[below(random, face.size())];
    if (corner >= positions.size() / 3) continue;
    const std::vector<float> p(positions.begin() + 3 * std::ptrdiff_t{corner},
                               positions.begin() + 3 * std::ptrdiff_t{corner} + 3);
    corner = Index(positions.size() / 3);
    positions.insert(positions.end(), p.begin(), p.end());
  }
  Shape result("seed " + std::to_string(seed), Index(positions.size() / 3), faces);
  result.positions = positions;
  return result;
}

Shape with_faces_shuffled(const Shape& shape, Random& random) {
  std::vector<std::vector<Index>> faces = shape.faces;
  std::shuffle(faces.begin(), faces.end(), random);
  Shape result(shape.name, shape.vertices, faces);
  result.positions = shape.positions;
  return result;
}

// Of vertices that exist.
Shape with_vertices_shuffled(const Shape& shape, Random& random) {
  std::vector<Index> name(shape.vertices);
  for (Index v = 0; v < shape.vertices; ++v) name[v] = v;
  std::shuffle(name.begin(), name.end(), random);
  std::vector<std::vector<Index>> faces = shape.faces;
  for (std::vector<Index>& face : faces) {
    for (Index& v : face) v = v < shape.vertices ? name[v] : v;
  }
  Shape result(shape.name, shape.vertices, faces);
  for (Index v = 0; v < shape.vertices; ++v) {
    std::copy(shape.positions.begin() + 3 * std::ptrdiff_t{v},
              shape.positions.begin() + 3 * std::ptrdiff_t{v} + 3,
              result.positions.begin() + 3 * std::ptrdiff_t{name[v]});
  }
  return result;
}

class RandomSoup : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomSoup, BecomesAValidMeshAndLosesNothingInSilence) {
  std::size_t repaired = 0;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Shape shape = damaged(GetParam() * 1000 + i);
    SCOPED_TRACE(shape.name);
    for (const RepairOptions& options : {RepairOptions{}, RepairOptions{.weld = 0},
                                         RepairOptions{.weld = 0.02, .drop_isolated = true}}) {
      const Repaired result(shape.polygons(), options);
      expect_sound(shape.polygons(), result);
      EXPECT_TRUE(Invariants(result.mesh).hold());
      Mesh strict;
      BuildReport report;
      if (build_from_polygons(strict, shape.polygons(), report)) {
        EXPECT_TRUE(options.weld || result.report.verdicts.empty());
      } else {
        ++repaired;
        EXPECT_NE(result.report.summary, "Nothing to repair.");
      }
      // What it has made is a manifold to the strict builder, and to itself.
      std::vector<std::vector<Index>> faces = result.faces();
      const Shape again("", result.mesh.vertex_count(), faces);
      EXPECT_TRUE(build_from_polygons(strict, again.polygons(), report));
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(repaired, 60U) << "too little damage to test with";
}

TEST_P(RandomSoup, HasTheSameShapeInAnyOrder) {
  for (std::uint32_t i = 0; i < 60; ++i) {
    const std::uint32_t seed = GetParam() * 1000 + 500 + i;
    const Shape shape = damaged(seed);
    SCOPED_TRACE(shape.name);
    Random random(seed);
    // Vertices at one position that stay apart have no order but their own.
    const Repaired apart(shape.polygons());
    const Repaired apart_shuffled(with_faces_shuffled(shape, random).polygons());
    EXPECT_EQ(shape_of(apart), shape_of(apart_shuffled));
    EXPECT_EQ(apart.origins(), apart_shuffled.origins());
    for (const double tolerance : {0.0, 0.02}) {
      const RepairOptions options{.weld = tolerance};
      const Repaired welded(shape.polygons(), options);
      const Shape shuffled = with_vertices_shuffled(with_faces_shuffled(shape, random), random);
      EXPECT_EQ(shape_of(welded), shape_of(Repaired(shuffled.polygons(), options)));
    }
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSoup, testing::Range(1U, 9U));

// Nothing at all is right with these.
TEST(RandomTriangles, BecomeAValidMeshInAnyOrder) {
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Index vertices = Index(4 + below(random, 9));
    std::vector<std::vector<Index>> faces(4 + below(random, 60));
    for (std::vector<Index>& face : faces) {
      face.resize(3 + (seed % 3 == 0 ? below(random, 4) : 0));
      for (Index& v : face) v = Index(below(random, vertices));
    }
    const Shape shape("", vertices, faces);
    const Repaired result(shape.polygons());
    expect_sound(shape.polygons(), result);
    EXPECT_TRUE(Invariants(result.mesh).hold());
    const Repaired shuffled(with_faces_shuffled(shape, random).polygons());
    EXPECT_EQ(shape_of(result), shape_of(shuffled));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace halfedge::test
