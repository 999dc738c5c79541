#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "support/random_polygons.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

BuildReport refusal(const Polygons& polygons) {
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, triangle().polygons(), report));
  EXPECT_FALSE(build_from_polygons(mesh, polygons, report));
  EXPECT_EQ(mesh.vertex_slots() + mesh.halfedge_slots() + mesh.face_slots(), 0U);
  EXPECT_TRUE(mesh.positions().empty());
  EXPECT_EQ(report.problems.size(), std::min(report.problem_count, BuildReport::kMaxListed));
  return report;
}

struct Expected {
  std::string code;
  std::string message;
  std::vector<Index> vertices;
  std::vector<Index> faces;
};

void expect_problems(const Polygons& polygons, const std::vector<Expected>& expected) {
  const BuildReport report = refusal(polygons);
  ASSERT_EQ(report.problem_count, expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Error& problem = report.problems[i];
    EXPECT_EQ(problem.code, expected[i].code);
    EXPECT_EQ(problem.message, expected[i].message);
    EXPECT_EQ(problem.witness.vertices, expected[i].vertices) << problem.message;
    EXPECT_EQ(problem.witness.faces, expected[i].faces) << problem.message;
    EXPECT_TRUE(problem.witness.halfedges.empty());
    EXPECT_TRUE(problem.witness.edges.empty());
  }
}

void expect_problems(Index vertices, const std::vector<std::vector<Index>>& faces,
                     const std::vector<Expected>& expected) {
  expect_problems(Shape{"", vertices, faces}.polygons(), expected);
}

// ---- the arrays

TEST(BuildRefusal, OfPositionsThatAreNotThreeForEachVertex) {
  const std::vector<float> positions(10);
  expect_problems({positions, {}, {}},
                  {{"bad-size",
                    "The positions array has 10 numbers; expected a multiple of 3, three for each "
                    "vertex.",
                    {},
                    {}}});
}

TEST(BuildRefusal, OfTrianglesThatLackACorner) {
  const std::vector<float> positions(9);
  const std::vector<Index> corners{0, 1, 2, 0};
  expect_problems({positions, {}, corners},
                  {{"bad-size",
                    "The triangles array has 4 corners; expected a multiple of 3, three for each "
                    "triangle.",
                    {},
                    {}}});
}

TEST(BuildRefusal, OfSizesThatDoNotAddUpToTheCorners) {
  const std::vector<float> positions(12);
  const std::vector<Index> sizes{3, 4};
  const std::vector<Index> corners{0, 1, 2, 0, 2, 3};
  expect_problems(
      {positions, sizes, corners},
      {{"bad-size", "The face sizes add up to 7 corners, but the corners array has 6.", {}, {}}});
  // Sums that are right modulo 2^32 are wrong.
  const std::vector<Index> wrapping{0xFFFF'FFFF, 7};
  expect_problems({positions, wrapping, corners},
                  {{"bad-size",
                    "The face sizes add up to 4294967302 corners, but the corners array has 6.",
                    {},
                    {}}});
}

TEST(BuildRefusal, OfMoreItemsThanIndicesCanTell) {
  // Spans too long to exist: refused before anything is read.
  const std::vector<float> positions(9);
  const std::vector<Index> corners{0, 1, 2};
  const std::size_t too_many = std::size_t{kMaxSlots} + 1;
  expect_problems({positions, {}, {corners.data(), 3 * too_many}},
                  {{"too-large",
                    "The input has 6442450941 corners; a mesh can have at most 2147483646.",
                    {},
                    {}}});
  expect_problems({{positions.data(), 3 * too_many}, {}, corners},
                  {{"too-large",
                    "The input has 2147483647 vertices; a mesh can have at most 2147483646.",
                    {},
                    {}}});
}

// ---- one face or vertex by itself

TEST(BuildRefusal, OfAPositionThatIsNotFinite) {
  Shape shape = tetrahedron();
  shape.positions[4] = std::numeric_limits<float>::quiet_NaN();
  shape.positions[9] = -std::numeric_limits<float>::infinity();
  shape.positions[10] = 0.5F;
  shape.positions[11] = 2;
  const BuildReport report = refusal(shape.polygons());
  ASSERT_EQ(report.problem_count, 2U);
  EXPECT_EQ(report.problems[0].code, "non-finite-position");
  EXPECT_EQ(report.problems[0].witness.vertices, std::vector<Index>{1});
  EXPECT_EQ(report.problems[1].message,
            "Vertex 3 is at (-inf, 0.5, 2); expected three finite numbers.");
  EXPECT_EQ(report.problems[1].witness.vertices, std::vector<Index>{3});
}

TEST(BuildRefusal, OfAnIndexOutOfRange) {
  expect_problems(5, {{0, 1, 2}, {0, 5, 3}, {4, 3, 0xFFFF'FFFF}},
                  {{"index-out-of-range", "Face 1 uses vertex 5, but the last one is 4.", {5}, {1}},
                   {"index-out-of-range",
                    "Face 2 uses vertex 4294967295, but the last one is 4.",
                    {0xFFFF'FFFF},
                    {2}}});
  expect_problems(
      0, {{0, 1, 2}},
      {{"index-out-of-range", "Face 0 uses vertex 0, but there are no vertices.", {0}, {0}},
       {"index-out-of-range", "Face 0 uses vertex 1, but there are no vertices.", {1}, {0}},
       {"index-out-of-range", "Face 0 uses vertex 2, but there are no vertices.", {2}, {0}}});
}

TEST(BuildRefusal, OfAFaceWithTwoCornersOrFewer) {
  expect_problems(
      3, {{0, 1, 2}, {1, 2}, {0}, {}},
      {{"degree-below-three", "Face 1 has 2 corners; a face needs at least 3.", {1, 2}, {1}},
       {"degree-below-three", "Face 2 has 1 corner; a face needs at least 3.", {0}, {2}},
       {"degree-below-three", "Face 3 has 0 corners; a face needs at least 3.", {}, {3}}});
}

TEST(BuildRefusal, OfAFaceWithARepeatedVertex) {
  // Neighbouring corners, and corners with others between them.
  expect_problems(
      6, {{3, 1, 1}, {0, 2, 0, 4, 5}, {2, 2, 2}},
      {{"repeated-vertex",
        "Face 0 uses vertex 1 at 2 corners (its corners are 3, 1, 1); a face may use a "
        "vertex once.",
        {1},
        {0}},
       {"repeated-vertex",
        "Face 1 uses vertex 0 at 2 corners (its corners are 0, 2, 0, 4, 5); a face may use a "
        "vertex once.",
        {0},
        {1}},
       {"repeated-vertex",
        "Face 2 uses vertex 2 at 3 corners (its corners are 2, 2, 2); a face may use a "
        "vertex once.",
        {2},
        {2}}});
  expect_problems(
      4, {{0, 1, 2, 3, 1}},
      {{"repeated-vertex",
        "Face 0 uses vertex 1 at 2 corners (its corners are 0, 1, 2, 3, 1); a face may use "
        "a vertex once.",
        {1},
        {0}}});
}

// ---- faces between each other

TEST(BuildRefusal, OfAnEdgeWithThreeFaces) {
  expect_problems(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}},
                  {{"edge-with-many-faces",
                    "Edge 0-1 is used by 3 faces (0, 1, 2); a manifold edge has at most 2.",
                    {0, 1},
                    {0, 1, 2}}});
}

TEST(BuildRefusal, OfAnEdgeWithATenthFaceNamesEightAndKeepsTheRestAsWitness) {
  std::vector<std::vector<Index>> faces;
  std::vector<Index> all;
  for (Index i = 0; i < 10; ++i) {
    faces.push_back({0, 1, 2 + i});
    all.push_back(i);
  }
  expect_problems(
      12, faces,
      {{"edge-with-many-faces",
        "Edge 0-1 is used by 10 faces (0, 1, 2, 3, 4, 5, 6, 7 and others); a manifold edge has "
        "at most 2.",
        {0, 1},
        all}});
}

TEST(BuildRefusal, OfANeighbourWithTheOppositeOrientation) {
  expect_problems(6, {{0, 1, 2}, {1, 3, 2}, {4, 3, 1}, {5, 0, 1}},
                  {{"opposite-orientation",
                    "Faces 0 and 3 both run from vertex 0 to vertex 1; neighbours must run along "
                    "their edge in opposite directions.",
                    {0, 1},
                    {0, 3}}});
}

TEST(BuildRefusal, OfAMoebiusStrip) {
  // Five quads around; the last is joined to the first with a half turn.
  expect_problems(10, {{0, 2, 3, 1}, {2, 4, 5, 3}, {4, 6, 7, 5}, {6, 8, 9, 7}, {8, 1, 0, 9}},
                  {{"opposite-orientation",
                    "Faces 0 and 4 both run from vertex 1 to vertex 0; neighbours must run along "
                    "their edge in opposite directions.",
                    {1, 0},
                    {0, 4}}});
}

TEST(BuildRefusal, OfARepeatedFace) {
  for (const std::vector<Index>& repeat : {std::vector<Index>{0, 2, 3}, {2, 3, 0}, {3, 0, 2}}) {
    const std::string corners = std::to_string(repeat[0]) + ", " + std::to_string(repeat[1]) +
                                ", " + std::to_string(repeat[2]);
    expect_problems(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, repeat},
                    {{"duplicate-face",
                      "Face 4 repeats face 1: both have the vertices " + corners + ".",
                      repeat,
                      {1, 4}}});
  }
}

TEST(BuildRefusal, OfAFaceRepeatedTurnedOver) {
  expect_problems(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {3, 2, 0}},
                  {{"duplicate-face",
                    "Face 4 repeats face 1 turned over: both have the vertices 3, 2, 0.",
                    {3, 2, 0},
                    {1, 4}}});
}

TEST(BuildRefusal, OfARepeatedPolygonButNotOfOneWithTheSameVerticesInAnotherOrder) {
  expect_problems(4, {{0, 1, 2, 3}, {2, 3, 0, 1}},
                  {{"duplicate-face",
                    "Face 1 repeats face 0: both have the vertices 2, 3, 0, 1.",
                    {2, 3, 0, 1},
                    {0, 1}}});
  const BuildReport report = refusal(Shape{"", 4, {{0, 1, 2, 3}, {0, 1, 3, 2}}}.polygons());
  ASSERT_EQ(report.problem_count, 1U);
  EXPECT_EQ(report.problems[0].code, "opposite-orientation");
}

TEST(BuildRefusal, NamesARepeatedFaceAndTheEdgeThatIsWrongWithoutItToo) {
  expect_problems(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 2, 0}},
                  {{"duplicate-face",
                    "Face 3 repeats face 0: both have the vertices 1, 2, 0.",
                    {1, 2, 0},
                    {0, 3}},
                   {"edge-with-many-faces",
                    "Edge 0-1 is used by 4 faces (0, 1, 2, 3); a manifold edge has at most 2.",
                    {0, 1},
                    {0, 1, 2, 3}}});
}

// ---- vertices

TEST(BuildRefusal, OfTwoTetrahedraThatShareAVertex) {
  expect_problems(
      7,
      {{0, 1, 2},
       {0, 2, 3},
       {0, 3, 1},
       {1, 3, 2},  //
       {4, 0, 5},
       {0, 4, 6},
       {0, 6, 5},
       {4, 5, 6}},
      {{"pinched-vertex",
        "Vertex 0 joins 2 separate fans of faces (beginning with faces 0, 4), 2 of them "
        "closed; a vertex with a closed fan can have no other.",
        {0},
        {0, 4}}});
}

TEST(BuildRefusal, OfAnOpenFanBesideAClosedOne) {
  expect_problems(
      6, {{4, 0, 5}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}},
      {{"pinched-vertex",
        "Vertex 0 joins 2 separate fans of faces (beginning with faces 0, 1), 1 of them "
        "closed; a vertex with a closed fan can have no other.",
        {0},
        {0, 1}}});
}

TEST(BuildRefusal, OfTwoPillowsThatShareAVertex) {
  expect_problems(
      5, {{0, 1, 2}, {2, 1, 0}, {0, 3, 4}, {4, 3, 0}},
      {{"pinched-vertex",
        "Vertex 0 joins 2 separate fans of faces (beginning with faces 0, 2), 2 of them "
        "closed; a vertex with a closed fan can have no other.",
        {0},
        {0, 2}}});
}

// ---- many at once

// Numbers are looked at two at a time; a triangle has nine.
TEST(BuildRefusal, FindsANumberThatIsntFiniteInAnyPlace) {
  using Limits = std::numeric_limits<float>;
  for (std::size_t place = 0; place < 9; ++place) {
    for (const float number : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
      Shape shape = triangle();
      shape.positions[place] = number;
      const BuildReport report = refusal(shape.polygons());
      ASSERT_EQ(report.problem_count, 1U) << place;
      EXPECT_EQ(report.problems[0].code, "non-finite-position");
      EXPECT_EQ(report.problems[0].witness.vertices, std::vector<Index>{Index(place / 3)});
    }
    Shape shape = triangle();
    shape.positions[place] = Limits::lowest();
    Mesh mesh;
    BuildReport report;
    EXPECT_TRUE(build_from_polygons(mesh, shape.polygons(), report)) << place;
  }
}

TEST(BuildRefusal, ListsProblemsOfAllKindsInOrder) {
  Shape shape{"", 8, {{0, 1, 2}, {3, 4}, {1, 0, 5}, {0, 1, 6}, {2, 9, 2}, {7, 2, 1}, {7, 1, 2}}};
  shape.positions[0] = std::numeric_limits<float>::infinity();
  const BuildReport report = refusal(shape.polygons());
  std::vector<std::string_view> codes;
  for (const Error& problem : report.problems) codes.push_back(problem.code);
  EXPECT_EQ(codes, (std::vector<std::string_view>{"non-finite-position", "degree-below-three",
                                                  "repeated-vertex", "index-out-of-range",
                                                  "duplicate-face", "edge-with-many-faces"}));
}

TEST(BuildRefusal, CountsAllProblemsButListsAThousand) {
  const std::vector<std::vector<Index>> faces(2001, {0, 1, 2});
  const BuildReport report = refusal(Shape{"", 3, faces}.polygons());
  EXPECT_EQ(report.problem_count, 2000U);
  EXPECT_EQ(report.problems.size(), 1000U);
  EXPECT_EQ(report.problems.back().witness.faces, (std::vector<Index>{0, 1000}));
}

// One wrong face among good ones is found wherever it is.
TEST(BuildRefusal, FindsTheOneWrongFaceInRandomPolygons) {
  std::map<std::string, int> found;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Shape shape = random_polygons(seed);
    if (shape.faces.empty()) continue;
    std::mt19937 random(seed);
    const std::size_t victim = random() % shape.faces.size();
    std::vector<std::vector<Index>> faces = shape.faces;
    const Index wrong = Index(faces.size());
    std::vector<Index> face = faces[victim];
    const std::size_t start = random() % face.size();
    std::rotate(face.begin(), face.begin() + std::ptrdiff_t(start), face.end());
    faces.push_back(face);
    const BuildReport report = refusal(Shape{shape.name, shape.vertices, faces}.polygons());
    ASSERT_EQ(report.problem_count, 1U) << shape.name;
    EXPECT_EQ(report.problems[0].code, "duplicate-face") << shape.name;
    EXPECT_EQ(report.problems[0].witness.faces, (std::vector<Index>{Index(victim), wrong}))
        << shape.name;
  }
}

// Whatever the indices, the answer is a valid mesh or a reason. The sanitizers watch.
TEST(BuildRefusal, OfGarbageNeverCrashesAndAlwaysHasAReason) {
  int built = 0;
  int refused = 0;
  for (std::uint32_t seed = 0; seed < 5'000; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t count) { return std::size_t(random()) % count; };
    const Index vertices = Index(below(9));
    const bool triangles = below(3) == 0;
    const bool sane = below(4) != 0;
    std::vector<Index> sizes;
    std::vector<Index> corners;
    for (std::size_t faces = below(7); faces > 0; --faces) {
      const Index size = triangles ? 3 : Index(sane ? 3 + below(3) : below(6));
      if (!triangles) sizes.push_back(size);
      const std::size_t start = below(vertices + std::size_t{1});
      for (Index i = 0; i < size; ++i) {
        const std::size_t index = sane ? (start + i + below(2) * 2) : below(vertices + 2U);
        corners.push_back(Index(sane && vertices > 0 ? index % vertices : index));
      }
    }
    if (below(50) == 0) corners.push_back(0);
    std::vector<float> positions(3 * std::size_t{vertices} + (below(100) == 0 ? 1 : 0), 0.0F);
    if (below(100) == 0 && vertices > 0) positions[0] = std::numeric_limits<float>::infinity();

    Mesh mesh;
    BuildReport report;
    if (build_from_polygons(mesh, {positions, sizes, corners}, report)) {
      ++built;
      EXPECT_EQ(report.problem_count, 0U) << "seed " << seed;
      EXPECT_FALSE(has_errors(validate(mesh))) << "seed " << seed;
      EXPECT_EQ(mesh.face_count(), triangles ? corners.size() / 3 : sizes.size());
    } else {
      ++refused;
      ASSERT_GT(report.problem_count, 0U) << "seed " << seed;
      EXPECT_EQ(mesh.vertex_slots(), 0U);
    }
  }
  EXPECT_GT(built, 500) << "the garbage is too bad to reach the end of the builder";
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace halfedge::test
