#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <ctime>
#include <numeric>
#include <string>
#include <vector>

#include "support/shapes.h"

namespace halfedge::test {
namespace {

constexpr Index kLarge = 200'000;

// Ten times the input may take ten times as long and a few times more, for the caches and the
// logarithm; a quadratic step takes a hundred times as long.
constexpr double kFarFromQuadratic = 50;

// In seconds of the processor, so that whatever else the machine does is not measured.
double fastest_of_two(const Shape& shape, bool builds) {
  double fastest = 1e30;
  for (int round = 0; round < 2; ++round) {
    Mesh mesh;
    BuildReport report;
    const std::clock_t start = std::clock();
    EXPECT_EQ(build_from_polygons(mesh, shape.polygons(), report), builds) << shape.name;
    fastest = std::min(fastest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return fastest;
}

template <class MakeShape>
void expect_no_quadratic_step(const MakeShape& make, bool builds, Index large_size = kLarge) {
  const double small = fastest_of_two(make(large_size / 10), builds);
  const double large = fastest_of_two(make(large_size), builds);
  EXPECT_LT(large, kFarFromQuadratic * small) << small << " s, " << large << " s";
}

Shape faces_on_one_edge(Index count) {
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < count; ++i) faces.push_back({0, 1, 2 + i});
  return {"faces on one edge", count + 2, std::move(faces)};
}

TEST(BuildScale, AFanAroundOneVertexIsLinear) {
  expect_no_quadratic_step(disk, true);
  expect_no_quadratic_step([](Index n) { return in_random_order(disk(n)); }, true, 100'000);
}

TEST(BuildScale, ABipyramidIsLinear) {
  expect_no_quadratic_step(bipyramid, true, 100'000);
  expect_no_quadratic_step([](Index n) { return in_random_order(bipyramid(n)); }, true, 50'000);
}

TEST(BuildScale, FansAtAPinchedVertexAreAlmostLinear) {
  expect_no_quadratic_step(pinched, true, 100'000);
}

TEST(BuildScale, LargeFacesAreLinear) {
  const auto two_large_faces = [](Index n) {
    std::vector<Index> front(n);
    std::iota(front.begin(), front.end(), 0U);
    return Shape{"two large faces", n, {front, {front.rbegin(), front.rend()}}};
  };
  expect_no_quadratic_step(two_large_faces, true);
}

TEST(BuildScale, TheReasonsOfARefusalAreFoundInAlmostLinearTime) {
  const auto repeats = [](Index n) {
    return Shape{"repeats", 3, std::vector<std::vector<Index>>(n, {2, 0, 1})};
  };
  const auto one_bad_face = [](Index n) {
    return Shape{"one bad face", 3, {std::vector<Index>(n, 1)}};
  };
  expect_no_quadratic_step(faces_on_one_edge, false, 50'000);
  expect_no_quadratic_step(repeats, false, 50'000);
  expect_no_quadratic_step(one_bad_face, false, 50'000);
}

TEST(BuildScale, AFanOfTwoHundredThousandTrianglesIsValid) {
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, in_random_order(bipyramid(kLarge)).polygons(), report));
  EXPECT_EQ(mesh.valence(Vertex(0)), kLarge);
  EXPECT_EQ(mesh.valence(Vertex(kLarge + 1)), kLarge);
  EXPECT_TRUE(validate(mesh).empty());
}

}  // namespace
}  // namespace halfedge::test
