// Each kind of damage by itself: what is made of it, and what is said.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/repair/repair.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/repairing.h"
#include "support/shapes.h"
#include "support/text_file.h"

namespace halfedge::test {
namespace {

using Lists = std::vector<std::vector<Index>>;
using Strings = std::vector<std::string>;

// The codes that a strict build refuses a shape with.
Strings refusals(const Polygons& polygons) {
  Mesh mesh;
  BuildReport report;
  EXPECT_FALSE(build_from_polygons(mesh, polygons, report));
  Strings codes;
  for (const Error& problem : report.problems) codes.emplace_back(problem.code);
  return codes;
}

Repaired repaired(const Shape& shape, const RepairOptions& options = {}) {
  Repaired result(shape.polygons(), options);
  expect_sound(shape.polygons(), result);
  return result;
}

void expect_verdicts(const Repaired& result,
                     const std::vector<std::pair<Index, RepairCode>>& expected) {
  std::vector<std::pair<Index, RepairCode>> found;
  for (const FaceVerdict& verdict : result.report.verdicts) {
    for (std::size_t code = 0; code < kRepairCodeCount; ++code) {
      if (verdict.has(RepairCode(code))) found.emplace_back(verdict.face, RepairCode(code));
    }
  }
  EXPECT_EQ(found, expected);
}

TEST(Repair, ChangesNothingInAManifold) {
  for (const Shape& shape :
       {tetrahedron(), cube(), pillow(), disk(7), annulus(5), torus(4, 5), torus(4, 5, 2),
        mixed_polygons(), with_isolated_vertices(), two_components(), pinched(3)}) {
    SCOPED_TRACE(shape.name);
    const Repaired result = repaired(shape);
    Mesh strict;
    BuildReport report;
    ASSERT_TRUE(build_from_polygons(strict, shape.polygons(), report));
    EXPECT_TRUE(std::equal(strict.links().next.begin(), strict.links().next.end(),
                           result.mesh.links().next.begin()));
    EXPECT_TRUE(std::equal(strict.links().vertex_halfedge.begin(),
                           strict.links().vertex_halfedge.end(),
                           result.mesh.links().vertex_halfedge.begin()));
    EXPECT_EQ(result.faces(), shape.faces);
    EXPECT_TRUE(result.report.verdicts.empty());
    std::vector<Index> identity(shape.vertices);
    std::iota(identity.begin(), identity.end(), 0U);
    EXPECT_EQ(result.origins(), identity);
  }
  EXPECT_EQ(repaired(cube()).report.summary, "Nothing to repair.");
  EXPECT_TRUE(repaired(cube()).report.problems.empty());
}

TEST(Repair, LeavesOutFacesWithAnIndexOutOfRange) {
  const Shape shape("", 4, {{0, 1, 2}, {0, 2, 4}, {0, 2, 3}, {1, 0, 0xFFFF'FFFF}});
  EXPECT_EQ(refusals(shape.polygons()), Strings(2, "index-out-of-range"));
  const Repaired result = repaired(shape);
  EXPECT_EQ(result.faces(), (Lists{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(result.messages(),
            (Strings{"index-out-of-range: Face 1 uses vertex 4, but the last one is 3: it was "
                     "left out.",
                     "index-out-of-range: Face 3 uses vertex 4294967295, but the last one is "
                     "3: it was left out."}));
  EXPECT_EQ(result.report.problems[0].witness.vertices, std::vector<Index>{4});
  EXPECT_EQ(result.report.problems[0].witness.faces, std::vector<Index>{1});
  EXPECT_EQ(result.report.summary, "2 faces with an index out of range left out.");
  expect_verdicts(result, {{1, RepairCode::kIndexOutOfRange}, {3, RepairCode::kIndexOutOfRange}});
}

TEST(Repair, NamesVerticesAsTheyWereGiven) {
  const Shape shape("", 3, {{0, 1, 2}, {1, 0, 0x8000'0000}, {1, 2, 0xFFFF'FFFE}, {3, 0, 1}});
  const auto named = [&](bool has_negative) {
    Polygons polygons = shape.polygons();
    polygons.has_negative = has_negative;
    Strings names;
    for (const std::string& message : Repaired(polygons).messages()) {
      const std::size_t begin = message.find("vertex ");
      names.push_back(message.substr(begin, message.find(',') - begin));
    }
    return names;
  };
  EXPECT_EQ(named(false), (Strings{"vertex 2147483648", "vertex 4294967294", "vertex 3"}));
  EXPECT_EQ(named(true), (Strings{"vertex -2147483648", "vertex -2", "vertex 3"}));
}

TEST(Repair, NamesVerticesAsTheyAreInAFile) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar ";
  const std::string points = "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  const std::string strips =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n" +
      points;
  const std::pair<std::string, const char*> files[] = {
      {ply + "int vertex_indices\n" + points + "3 0 1 -7\n", "vertex -7,"},
      {ply + "uint vertex_indices\n" + points + "3 0 1 4294967289\n", "vertex 4294967289,"},
      {ply + "float vertex_indices\n" + points + "3 0 1 1e10\n", "vertex 1e10,"},
      {ply + "int vertex_indices\n" + points + "4 0 9 5000000000 1\n", "vertex 9,"},
      {strips + "3 0 1 -7\n", "vertex -7,"},
      {strips + "4 2 5000000000 0 1\n", "vertex 5000000000,"},
      {"OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99999999999999999999\n",
       "vertex 99999999999999999999,"},
      {"OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -5000000000\n", "vertex -5000000000,"},
      {"OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -7\n", "vertex -7,"},
      {"OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 4294967289\n", "vertex 4294967289,"},
      // Counted from 0, as all that a report tells of: four before the first one.
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -7\n", "vertex -4,"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967290\n", "vertex 4294967289,"}};
  for (const auto& [text, name] : files) {
    const Result<ParsedFile> file = parse(bytes_of(text), std::nullopt, {.for_repair = true});
    ASSERT_TRUE(file) << file.error().message;
    const Strings messages = Repaired(file.value().soup.view()).messages();
    ASSERT_FALSE(messages.empty()) << text;
    EXPECT_NE(messages[0].find(name), std::string::npos) << messages[0];
  }
}

TEST(Repair, NamesTheMissingVertexOfEachFaceAsItIsInAFile) {
  // Two triangles of one strip, and a face behind.
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
      "element face 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
      "4 0 5000000000 1 2\n3 -2 4294967294 6000000000\n";
  const Result<ParsedFile> file = parse(bytes_of(text), std::nullopt, {.for_repair = true});
  ASSERT_TRUE(file) << file.error().message;
  const Strings messages = Repaired(file.value().soup.view()).messages();
  ASSERT_GE(messages.size(), 3U);
  EXPECT_NE(messages[0].find("Face 0 uses vertex 5000000000,"), std::string::npos) << messages[0];
  EXPECT_NE(messages[1].find("Face 1 uses vertex 5000000000,"), std::string::npos) << messages[1];
  EXPECT_NE(messages[2].find("Face 2 uses vertex -2,"), std::string::npos) << messages[2];
}

TEST(Repair, LeavesOutPositionsThatAreNotFiniteAndTheirFaces) {
  Shape shape("", 5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  shape.positions[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusals(shape.polygons()), Strings{"non-finite-position"});
  const Repaired result = repaired(shape);
  EXPECT_EQ(result.faces(), (Lists{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(result.origins(), (std::vector<Index>{0, 2, 3, 4}));
  EXPECT_EQ(result.report.vertex_map[1], kNone);
  EXPECT_EQ(result.report.problems[0].witness.vertices, std::vector<Index>{1});
  EXPECT_EQ(result.report.summary,
            "1 vertex without a finite position left out, 1 face that used it left out.");
  expect_verdicts(result, {{0, RepairCode::kNonFinitePosition}});
}

TEST(Repair, LeavesOutFacesWithFewerThanThreeCorners) {
  const Shape shape("", 4, {{0, 1, 2}, {}, {0}, {2, 3}, {0, 2, 3}});
  EXPECT_EQ(refusals(shape.polygons()), Strings(3, "degree-below-three"));
  const Repaired result = repaired(shape);
  EXPECT_EQ(result.faces(), (Lists{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(result.messages()[2],
            "degree-below-three: Face 3 has 2 corners; a face needs at least 3: it was left out.");
  EXPECT_EQ(result.report.summary, "3 faces with fewer than 3 corners left out.");
}

TEST(Repair, SimplifiesFacesThatRepeatAVertex) {
  const Shape shape("", 6,
                    {{0, 0, 1, 2},          // twice in a row
                     {1, 3, 2, 1},          // where it ends
                     {2, 3, 4, 3},          // there and back
                     {0, 1, 0},             // nothing
                     {5, 5, 5},             // nothing
                     {4, 3, 5, 4, 3, 5}});  // two rounds
  EXPECT_EQ(refusals(shape.polygons()), Strings(8, "repeated-vertex"));
  const Repaired result = repaired(shape);
  EXPECT_EQ(result.faces(), (Lists{{0, 1, 2}, {1, 3, 2}, {4, 3, 5}}));
  EXPECT_EQ(result.report.count(RepairCode::kRepeatedVertex), 6U);
  EXPECT_EQ(result.messages()[0],
            "repeated-vertex: Face 0 uses vertex 0 more than once: 1 corner of it was left out.");
  EXPECT_EQ(result.messages()[3],
            "repeated-vertex: Face 3 uses vertex 0 more than once, and encloses nothing: it was "
            "left out.");
  EXPECT_EQ(result.report.summary,
            "3 faces that used a vertex twice left out, 3 faces that used a vertex twice "
            "simplified.");
}

TEST(Repair, DoublesAVertexToWhichAFaceComesBack) {
  // A square with a square hole, and a bridge 0-4 between them, used in both directions.
  const Shape shape("", 9, {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}, {1, 0, 8}, {2, 1, 8}});
  EXPECT_EQ(refusals(shape.polygons()), Strings(2, "repeated-vertex"));
  const Repaired result = repaired(shape);
  EXPECT_EQ(result.mesh.face_count(), 3U);
  EXPECT_EQ(result.mesh.degree(Face(0)), 10U);
  EXPECT_EQ(result.mesh.vertex_count(), 12U);  // vertex 0 also for face 1
  // Where no vertex is doubled, neighbours stay joined.
  EXPECT_TRUE(result.mesh.find_halfedge(Vertex(1), Vertex(2)).valid());
  EXPECT_FALSE(result.mesh.is_boundary(result.mesh.find_halfedge(Vertex(2), Vertex(1))));
  EXPECT_EQ(result.messages(),
            Strings{"repeated-vertex: Face 0 uses vertex 0 more than once: that vertex was "
                    "doubled."});
}

TEST(Repair, KeepsOneOfDuplicateFaces) {
  Shape shape = tetrahedron();
  shape.faces.push_back({2, 0, 1});  // rotated
  shape.faces.push_back({0, 2, 1});  // turned over
  shape.faces.push_back({3, 2, 1});  // face 3, rotated
  const Shape damaged("", 4, shape.faces);
  EXPECT_EQ(refusals(damaged.polygons()), Strings(3, "duplicate-face"));
  const Repaired result = repaired(damaged);
  EXPECT_EQ(result.faces(), tetrahedron().faces);
  EXPECT_EQ(result.mesh.vertex_count(), 4U);
  EXPECT_EQ(result.report.summary, "3 duplicate faces left out.");
  EXPECT_EQ(result.messages()[0],
            "duplicate-face: Face 0 has the vertices of face 4, which was left out.");
  EXPECT_EQ(result.report.problems[0].witness.faces, (std::vector<Index>{0, 4}));
}

TEST(Repair, KeepsOneSideOfADoubleSidedSheet) {
  const Shape sheet = triangle_grid(4, 3);
  Lists faces = sheet.faces;
  for (const std::vector<Index>& face : sheet.faces) faces.emplace_back(face.rbegin(), face.rend());
  const Repaired result = repaired({"", sheet.vertices, faces});
  EXPECT_EQ(result.mesh.face_count(), sheet.faces.size());
  EXPECT_EQ(result.mesh.vertex_count(), sheet.vertices);
  EXPECT_EQ(boundary_loops(result.mesh).value().size(), 1U);
}

TEST(Repair, TurnsTheMinorityOver) {
  Shape shape = cube();
  std::reverse(shape.faces[2].begin(), shape.faces[2].end());
  std::reverse(shape.faces[5].begin(), shape.faces[5].end());
  const Shape damaged("", 8, shape.faces);
  EXPECT_EQ(refusals(damaged.polygons())[0], "opposite-orientation");
  const Repaired result = repaired(damaged);
  EXPECT_EQ(result.report.summary, "2 faces turned over.");
  Strings messages = result.messages();
  std::sort(messages.begin(), messages.end());
  EXPECT_EQ(messages,
            (Strings{"opposite-orientation: Face 2 was turned over, to agree with its neighbours.",
                     "opposite-orientation: Face 5 was turned over, to agree with its "
                     "neighbours."}));
  expect_verdicts(result,
                  {{2, RepairCode::kOppositeOrientation}, {5, RepairCode::kOppositeOrientation}});
  EXPECT_TRUE(is_closed(result.mesh));
  EXPECT_EQ(result.mesh.vertex_count(), 8U);
  EXPECT_EQ(result.faces()[0], cube().faces[0]);
}

TEST(Repair, TurnsFacesOutwardWhereVotesAreEqual) {
  Shape shape = tetrahedron();
  for (const auto& turned : {std::pair(0, 1), std::pair(2, 3)}) {
    Shape damaged("", 4, shape.faces);
    damaged.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (const int f : {turned.first, turned.second}) {
      std::swap(damaged.corners[std::size_t(3 * f) + 1], damaged.corners[std::size_t(3 * f) + 2]);
    }
    const Repaired result = repaired(damaged);
    EXPECT_TRUE(is_closed(result.mesh));
    // Face 0 lies in the plane z = 0: outward is downward.
    EXPECT_TRUE(result.faces()[0] == (std::vector<Index>{0, 2, 1}));
  }
}

// `count` quads around a strip whose ends are joined after half a turn.
Shape moebius(Index count) {
  Lists faces;
  for (Index i = 0; i < count; ++i) {
    const Index a = 2 * i;
    const bool last = i + 1 == count;
    faces.push_back({a, last ? 1 : a + 2, last ? 0 : a + 3, a + 1});
  }
  return {"", 2 * count, faces};
}

TEST(Repair, CutsAMoebiusStripAcross) {
  const Shape shape = moebius(9);
  EXPECT_EQ(refusals(shape.polygons()), Strings{"opposite-orientation"});
  const Repaired result = repaired(shape);
  EXPECT_EQ(result.report.summary, "1 edge of one-sided surfaces cut, 2 vertices added as copies.");
  EXPECT_EQ(result.mesh.face_count(), 9U);
  EXPECT_EQ(result.mesh.vertex_count(), 20U);
  EXPECT_EQ(euler_characteristic(result.mesh), 1);
  EXPECT_EQ(result.messages()[0],
            "non-orientable: Edge 0-1 between faces 0 and 8 was cut: the surface is one-sided "
            "there.");
}

TEST(Repair, FindsAShortCutThroughAKleinBottleWhateverItsFacesSay) {
  constexpr Index kColumns = 12;
  constexpr Index kRows = 5;
  Lists faces;
  for (Index x = 0; x < kColumns; ++x) {
    for (Index y = 0; y < kRows; ++y) {
      const auto at = [&](Index i, Index j) {
        j %= kRows;
        return i == kColumns ? (kRows - j) % kRows : i * kRows + j;
      };
      faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
      if ((x * 7 + y * 3) % 5 < 2) std::reverse(faces.back().begin(), faces.back().end());
    }
  }
  const Repaired result = repaired({"", kColumns * kRows, faces});
  EXPECT_EQ(result.report.count(RepairCode::kNonOrientable), kRows);
  EXPECT_EQ(boundary_loops(result.mesh).value().size(), 2U);
}

TEST(Repair, SeparatesTwoSolidsThatShareAnEdge) {
  Shape shape("", 6,
              {{0, 2, 1},
               {0, 1, 3},
               {1, 2, 3},
               {2, 0, 3},  //
               {0, 1, 4},
               {0, 5, 1},
               {1, 5, 4},
               {5, 0, 4}});
  EXPECT_EQ(refusals(shape.polygons())[0], "edge-with-many-faces");
  const Repaired result = repaired(shape);
  EXPECT_EQ(connected_components(result.mesh).value().list.size(), 2U);
  EXPECT_TRUE(is_closed(result.mesh));
  EXPECT_EQ(result.mesh.vertex_count(), 8U);
  EXPECT_EQ(result.messages(),
            Strings{"edge-with-many-faces: Edge 0-1 is used by 4 faces (0, 1, 4, 5): it was "
                    "doubled, so that no copy has more than 2."});
  EXPECT_EQ(result.report.summary,
            "1 edge with more than two faces cut, 2 vertices added as copies.");
  EXPECT_EQ(result.report.problems[0].witness.vertices, (std::vector<Index>{0, 1}));
}

TEST(Repair, PairsByAngleWhereSolidsShareARowOfEdges) {
  // Two boxes of two cells each, which meet at the row 0-1-2 of edges: seen along it, one lies in
  // the first quadrant, one in the third.
  Lists faces;
  std::vector<float> positions;
  const auto vertex = [&](float x, float y, float z) {
    for (Index v = 0; 3 * v < positions.size(); ++v) {
      if (positions[3 * v] == x && positions[3 * v + 1] == y && positions[3 * v + 2] == z) return v;
    }
    positions.insert(positions.end(), {x, y, z});
    return Index(positions.size() / 3 - 1);
  };
  for (const float side : {1.0F, -1.0F}) {
    for (const float z : {0.0F, 1.0F}) {
      const std::vector<Index> low{vertex(0, 0, z), vertex(side, 0, z), vertex(side, side, z),
                                   vertex(0, side, z)};
      const std::vector<Index> high{vertex(0, 0, z + 1), vertex(side, 0, z + 1),
                                    vertex(side, side, z + 1), vertex(0, side, z + 1)};
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        faces.push_back({low[i], low[j], high[j], high[i]});
      }
      if (z == 0) {
        faces.emplace_back(low.rbegin(), low.rend());
      } else {
        faces.push_back(high);
      }
    }
  }
  Shape shape("", Index(positions.size() / 3), faces);
  shape.positions = positions;
  const Repaired result = repaired(shape);
  EXPECT_EQ(result.report.count(RepairCode::kEdgeWithManyFaces), 2U);
  EXPECT_TRUE(is_closed(result.mesh));
  EXPECT_EQ(connected_components(result.mesh).value().list.size(), 2U);
  EXPECT_EQ(result.mesh.vertex_count(), shape.vertices + 3);
}

TEST(Repair, CutsAFinOff) {
  Lists faces = tetrahedron().faces;
  faces.push_back({0, 1, 4});
  const Repaired result = repaired({"", 5, faces});
  EXPECT_EQ(connected_components(result.mesh).value().list.size(), 2U);
  EXPECT_EQ(boundary_loops(result.mesh).value().size(), 1U);
  EXPECT_EQ(result.mesh.vertex_count(), 7U);
  expect_verdicts(result, {{0, RepairCode::kEdgeWithManyFaces},
                           {2, RepairCode::kEdgeWithManyFaces},
                           {4, RepairCode::kEdgeWithManyFaces}});
}

TEST(Repair, GivesEachClosedFanOfAVertexACopy) {
  // Two tetrahedra with the vertex 0 in common, and an open fan there.
  const Shape shape("", 9,
                    {{0, 1, 2},
                     {0, 2, 3},
                     {0, 3, 1},
                     {1, 3, 2},  //
                     {0, 4, 5},
                     {0, 5, 6},
                     {0, 6, 4},
                     {4, 6, 5},
                     {0, 7, 8}});
  EXPECT_EQ(refusals(shape.polygons()), Strings{"pinched-vertex"});
  const Repaired result = repaired(shape);
  EXPECT_EQ(connected_components(result.mesh).value().list.size(), 3U);
  EXPECT_EQ(result.mesh.vertex_count(), 11U);
  EXPECT_EQ(result.report.vertex_map[0], 0U);
  EXPECT_EQ(result.report.vertex_origin[9], 0U);
  EXPECT_EQ(result.report.vertex_origin[10], 0U);
  EXPECT_EQ(result.report.count(RepairCode::kPinchedVertex), 1U);
  EXPECT_EQ(result.report.summary, "1 pinched vertex split, 2 vertices added as copies.");
}

TEST(Repair, LeavesOutIsolatedVerticesIfAsked) {
  const Shape shape = with_isolated_vertices();
  const Repaired kept = repaired(shape);
  EXPECT_EQ(kept.mesh.vertex_count(), shape.vertices);
  EXPECT_EQ(kept.messages(), Strings{"isolated-vertex: 3 vertices have no faces: 0, 3, 5."});
  EXPECT_EQ(kept.report.summary, "Nothing to repair, 3 vertices without faces kept.");
  const Repaired dropped = repaired(shape, {.drop_isolated = true});
  EXPECT_EQ(dropped.faces(), (Lists{{0, 1, 2}}));
  EXPECT_EQ(dropped.origins(), (std::vector<Index>{1, 2, 4}));
  EXPECT_EQ(dropped.report.vertex_map[0], kNone);
  EXPECT_EQ(dropped.report.vertex_map[4], 2U);
  EXPECT_EQ(dropped.report.problems[0].witness.vertices, (std::vector<Index>{0, 3, 5}));
  EXPECT_EQ(dropped.messages(),
            Strings{"isolated-vertex: 3 vertices have no faces, and were left out: 0, 3, 5."});
  const Repaired single = repaired({"", 4, {{0, 1, 2}}}, {.drop_isolated = true});
  EXPECT_EQ(single.messages(),
            Strings{"isolated-vertex: 1 vertex has no faces, and was left out: 3."});
}

TEST(Repair, RefusesArraysThatCantBeRead) {
  const std::vector<float> positions(9);
  const std::vector<Index> corners{0, 1, 2, 0};
  Mesh mesh;
  RepairReport report;
  EXPECT_FALSE(build_from_soup(mesh, {positions, {}, corners}, {}, report));
  ASSERT_EQ(report.problems.size(), 1U);
  EXPECT_EQ(report.problems[0].code, "bad-size");
  for (const double tolerance : {-1.0, std::nan(""), 1.0 / 0.0}) {
    EXPECT_FALSE(build_from_soup(mesh, triangle().polygons(), {.weld = tolerance}, report));
    EXPECT_EQ(report.problems[0].code, "bad-tolerance");
  }
  const std::size_t too_many = std::size_t{kMaxSlots} + 1;
  EXPECT_FALSE(build_from_soup(mesh, {positions, {}, {corners.data(), 3 * too_many}}, {}, report));
  EXPECT_EQ(report.problems[0].code, "too-large");
}

TEST(Repair, LeavesOutLinksThatTheMeshDoesNotStore) {
  BasicMesh<kWithoutPrev> mesh;
  RepairReport report;
  ASSERT_TRUE(build_from_soup(mesh, tetrahedron().polygons(), {}, report));
  EXPECT_EQ(mesh.face_count(), 4U);
  EXPECT_TRUE(validate(mesh).empty());
}

}  // namespace
}  // namespace halfedge::test
