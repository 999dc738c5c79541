#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "support/scaling.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

constexpr Index kLarge = 200'000;

template <class MakeShape>
void expect_linear(const MakeShape& make, bool builds, Index large_size = kLarge) {
  expect_no_quadratic_step(large_size, make, [builds](const Shape& shape) {
    Mesh mesh;
    BuildReport report;
    EXPECT_EQ(build_from_polygons(mesh, shape.polygons(), report), builds) << shape.name;
  });
}

Shape faces_on_one_edge(Index count) {
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < count; ++i) faces.push_back({0, 1, 2 + i});
  return {"faces on one edge", count + 2, std::move(faces)};
}

TEST(BuildScale, AFanAroundOneVertexIsLinear) {
  expect_linear(disk, true);
  expect_linear([](Index n) { return in_random_order(disk(n)); }, true, 100'000);
}

TEST(BuildScale, ABipyramidIsLinear) {
  expect_linear(bipyramid, true, 100'000);
  expect_linear([](Index n) { return in_random_order(bipyramid(n)); }, true, 50'000);
}

TEST(BuildScale, FansAtAPinchedVertexAreAlmostLinear) { expect_linear(pinched, true, 100'000); }

TEST(BuildScale, LargeFacesAreLinear) {
  const auto two_large_faces = [](Index n) {
    std::vector<Index> front(n);
    std::iota(front.begin(), front.end(), 0U);
    return Shape{"two large faces", n, {front, {front.rbegin(), front.rend()}}};
  };
  expect_linear(two_large_faces, true);
}

TEST(BuildScale, TheReasonsOfARefusalAreFoundInAlmostLinearTime) {
  const auto repeats = [](Index n) {
    return Shape{"repeats", 3, std::vector<std::vector<Index>>(n, {2, 0, 1})};
  };
  const auto one_bad_face = [](Index n) {
    return Shape{"one bad face", 3, {std::vector<Index>(n, 1)}};
  };
  expect_linear(faces_on_one_edge, false, 50'000);
  expect_linear(repeats, false, 50'000);
  expect_linear(one_bad_face, false, 50'000);
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
