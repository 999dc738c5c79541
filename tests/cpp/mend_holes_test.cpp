// Filling holes.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/io/parse.h>
#include <halfedge/repair/repair.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "support/data_files.h"
#include "support/mending.h"

namespace halfedge::test {
namespace {

using mend::Code;

auto fill_with(mend::FillOptions options) {
  return [=](auto& mesh) { return mend::fill_holes(mesh, options); };
}
const auto fill = fill_with({});

std::array<double, 3> normal_of(const Mesh& mesh, Face f) {
  const std::vector<Index> corners = corners_of(mesh, mesh.face_halfedge(f));
  std::array<double, 3> sum{};
  const Point o = mesh.position(Vertex(corners[0]));
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Point a = mesh.position(Vertex(corners[i - 1]));
    const Point b = mesh.position(Vertex(corners[i]));
    const double u[] = {a.x - o.x, a.y - o.y, a.z - o.z};
    const double v[] = {b.x - o.x, b.y - o.y, b.z - o.z};
    sum[0] += u[1] * v[2] - u[2] * v[1];
    sum[1] += u[2] * v[0] - u[0] * v[2];
    sum[2] += u[0] * v[1] - u[1] * v[0];
  }
  const double size = std::hypot(sum[0], sum[1], sum[2]);
  return {sum[0] / size, sum[1] / size, sum[2] / size};
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const Face f : mesh.faces()) {
    const std::vector<Index> corners = corners_of(mesh, mesh.face_halfedge(f));
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Point o = mesh.position(Vertex(corners[0]));
      const Point a = mesh.position(Vertex(corners[i - 1]));
      const Point b = mesh.position(Vertex(corners[i]));
      const double u[] = {a.x - o.x, a.y - o.y, a.z - o.z};
      const double v[] = {b.x - o.x, b.y - o.y, b.z - o.z};
      area += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                         u[0] * v[1] - u[1] * v[0]) /
              2;
    }
  }
  return area;
}

/// The largest angle, in degrees, between the normals of one of these faces and a neighbour.
double sharpest_at(const Mesh& mesh, const Array<Index>& faces) {
  double least = 1;
  for (const Index f : faces) {
    const std::array<double, 3> n = normal_of(mesh, Face(f));
    for (const Halfedge h : mesh.face_halfedges_ccw(Face(f))) {
      const Face g = mesh.face(mesh.opposite(h));
      if (!g.valid()) continue;
      const std::array<double, 3> m = normal_of(mesh, g);
      least = std::min(least, n[0] * m[0] + n[1] * m[1] + n[2] * m[2]);
    }
  }
  return std::acos(std::clamp(least, -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// The faces within `rings` edges of a vertex go.
void punch(Mesh& mesh, Vertex centre, int rings) {
  std::vector<Vertex> inside = {centre};
  for (std::size_t i = 0; rings > 1; --rings) {
    for (const std::size_t end = inside.size(); i < end; ++i) {
      for (const Vertex v : mesh.vertex_vertices_ccw(inside[i])) {
        if (std::find(inside.begin(), inside.end(), v) == inside.end()) inside.push_back(v);
      }
    }
  }
  for (const Vertex v : inside) {
    if (mesh.is_live(v)) (void)operations::delete_vertex(mesh, v);
  }
}

std::size_t count_loops(const Mesh& mesh) { return boundary_loops(mesh).value().size(); }

TEST(FillHoles, PutsAFaceBackThatWasDeleted) {
  Mesh mesh = shapes::mesh_of(shapes::icosahedron()).value();
  ASSERT_TRUE(operations::delete_face(mesh, Face(7)));
  const mend::Report report = mended(mesh, fill);
  EXPECT_EQ(counts_of(mesh), (std::array<Index, 3>{12, 30, 20}));
  EXPECT_EQ(report.summary, "1 hole filled.");
  ASSERT_EQ(report.faces.size(), 1U);
  EXPECT_EQ(report.faces[0], 7U);
  EXPECT_TRUE(is_closed(mesh));
}

TEST(FillHoles, ClosesACylinderAtBothEnds) {
  for (const Index n : {3U, 4U, 12U, 199U, 200U, 201U, 700U}) {
    SCOPED_TRACE(n);
    Mesh mesh = shapes::mesh_of(shapes::cylinder(n, 2, shapes::Caps::kOpen)).value();
    const double sides = area_of(mesh);
    const mend::Report report = mended(mesh, fill);
    EXPECT_EQ(report.count(Code::kFilledHole), 2U) << report.summary;
    EXPECT_EQ(report.faces.size(), 2 * (n - 2));
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_EQ(euler_characteristic(mesh), 2);
    EXPECT_NEAR(sharpest_at(mesh, report.faces), 90, 0.1);
    const double cap = n * std::sin(2 * std::numbers::pi / n) / 2;
    EXPECT_NEAR(area_of(mesh), sides + 2 * cap, 1e-4) << "no triangle lies on another";
  }
}

TEST(FillHoles, FillsAConcaveOutlineInAPlaneWithoutFolds) {
  // A sheet with a hole like a comb, whose teeth a fan from any corner would cross.
  for (const Index teeth : {3U, 12U, 45U, 150U}) {
    SCOPED_TRACE(teeth);
    const Index width = 4 * teeth + 3;
    Mesh mesh =
        shapes::mesh_of(shapes::grid(width, 9, shapes::Faces::kQuads, float(width), 9)).value();
    const double area = area_of(mesh);
    const auto remove = [&](Index column, Index row) {
      ASSERT_TRUE(operations::delete_face(mesh, Face(row * width + column)));
    };
    for (Index x = 1; x + 1 < width; ++x) remove(x, 1);
    for (Index t = 0; t < teeth; ++t) {
      for (Index y = 2; y < 8; ++y) {
        remove(2 + 4 * t, y);
        remove(3 + 4 * t, y);
      }
    }
    ASSERT_EQ(count_loops(mesh), 2U);
    const mend::Report report = mended(mesh, fill_with({.max_angle = 10}));
    EXPECT_EQ(report.count(Code::kFilledHole), 1U) << report.summary;
    EXPECT_EQ(report.count(Code::kFoldingHole), 1U) << "the outline";
    EXPECT_NEAR(area_of(mesh), area, 1e-3);
    EXPECT_LT(sharpest_at(mesh, report.faces), 0.1);
  }
}

TEST(FillHoles, LeavesTheOutlineOfASheetAndALoneTriangle) {
  Mesh mesh = shapes::mesh_of(shapes::grid(5, 4)).value();
  const mend::Report report = mended(mesh, fill);
  EXPECT_EQ(report.summary, "1 hole left whose filling would fold over.");
  EXPECT_EQ(report.problems[0].code, "folding-hole");
  EXPECT_NE(report.problems[0].message.find("of 18 edges, would be filled with a fold of 180 "
                                            "degrees, expected 160 at most"),
            std::string::npos)
      << report.problems[0].message;
  EXPECT_EQ(mesh.face_count(), 20U);

  Mesh single = reference_build(triangle());
  EXPECT_EQ(mended(single, fill).count(Code::kFoldingHole), 1U);
  EXPECT_EQ(mended(single, fill_with({.max_angle = 180})).count(Code::kFilledHole), 1U);
  EXPECT_EQ(counts_of(single), (std::array<Index, 3>{3, 3, 2}));
}

// Of a loop of four the one diagonal folds by 165 degrees, the other by 151: in steps of 30 alike.
TEST(FillHoles, FillsWhateverItCanWithinTheAngle) {
  const Mesh open = mesh_of({{-1, -2, -3},
                             {-4, -2, 1},
                             {-3, 4, 4},
                             {0, -1, 2},
                             {-4, 4, 0},
                             {1, 0, 4},
                             {2, 2, 4},
                             {4, 4, 3}},
                            {{1, 0, 4}, {2, 1, 5}, {3, 2, 6}, {0, 3, 7}});
  for (const double max_angle : {150.0, 152.0, 160.0, 164.0, 170.0}) {
    SCOPED_TRACE(max_angle);
    Mesh mesh = copy_of(open);
    const mend::Report report = mended(mesh, fill_with({.max_edges = 4, .max_angle = max_angle}));
    EXPECT_EQ(report.count(Code::kFilledHole), max_angle > 151 ? 1U : 0U) << report.summary;
    if (report.count(Code::kFilledHole) == 0) continue;
    EXPECT_LE(sharpest_at(mesh, report.faces), max_angle);
  }
}

// Not valid at level 4, but what can be read from bytes.
TEST(FillHoles, LeavesLoopsOfOneAndTwoEdges) {
  for (const std::size_t edges : {1U, 2U}) {
    Mesh mesh = loop_complex();
    if (edges == 2) {
      ASSERT_TRUE(decorator::split_edge(mesh, Halfedge(0)));
    }
    ASSERT_TRUE(decorator::make_hole(mesh, Halfedge(1)));
    const std::array<Index, 3> before = counts_of(mesh);
    const Result<mend::Report> report = mend::fill_holes(mesh);
    ASSERT_TRUE(report);
    EXPECT_EQ(report.value().summary, "1 hole left that can't be filled.");
    EXPECT_EQ(report.value().problems[0].message,
              "The boundary loop of halfedge 1, of " +
                  std::string(edges == 1 ? "1 edge" : "2 edges") +
                  ", can't be filled: a face has three corners at least.");
    EXPECT_EQ(counts_of(mesh), before);
  }
}

TEST(FillHoles, LeavesLargerHolesThanAskedFor) {
  Mesh mesh = shapes::mesh_of(shapes::cylinder(8, 1, shapes::Caps::kOpen)).value();
  const mend::Report report = mended(mesh, fill_with({.max_edges = 7}));
  EXPECT_EQ(report.summary, "2 larger holes left.");
  EXPECT_EQ(report.problems[0].message,
            "The boundary loop of halfedge " +
                std::to_string(report.problems[0].witness.halfedges[0]) +
                ", of 8 edges, is larger than asked for, expected 7 at most.");
  EXPECT_EQ(mended(mesh, fill_with({.max_edges = 8})).summary, "2 holes filled.");
}

// Four corners, of which two that are opposite are joined on the other side: only the other
// diagonal is allowed, although it is the longer one.
TEST(FillHoles, JoinsNoTwoVerticesASecondTime) {
  const std::vector<Point> points = {{0, -1, 0}, {3, 0, 0},  {0, 1, 0},
                                     {-3, 0, 0}, {0, 0, -2}, {0, 0, -9}};
  // 0 and 2 are joined below, by the edge of two triangles.
  Mesh mesh = mesh_of(points, {{1, 0, 4}, {2, 1, 4}, {3, 2, 5}, {0, 3, 5}, {0, 2, 4}, {2, 0, 5}});
  ASSERT_EQ(count_loops(mesh), 1U);
  ASSERT_TRUE(mesh.find_edge(Vertex(0), Vertex(2)).valid());
  const mend::Report report = mended(mesh, fill_with({.max_angle = 180}));
  EXPECT_EQ(report.count(Code::kFilledHole), 1U);
  EXPECT_TRUE(mesh.find_edge(Vertex(1), Vertex(3)).valid());
  EXPECT_EQ(euler_characteristic(mesh), 2);
}

// The torus of seven vertices, each of which is joined to all others: so are those around one that
// is deleted.
TEST(FillHoles, SaysWhereNoTriangulationIsAllowed) {
  std::vector<Point> points;
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < 7; ++i) {
    points.push_back({std::cos(float(i)), std::sin(float(i)), float(i * i % 5)});
    faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  Mesh mesh = mesh_of(points, faces);
  ASSERT_EQ(euler_characteristic(mesh), 0);
  ASSERT_TRUE(operations::delete_vertex(mesh, Vertex(4)));
  ASSERT_EQ(count_loops(mesh), 1U);
  const std::array<Index, 3> before = counts_of(mesh);
  const mend::Report report = mended(mesh, fill_with({.max_angle = 180}));
  EXPECT_EQ(counts_of(mesh), before);
  EXPECT_EQ(report.summary, "1 hole left that can't be filled.");
  EXPECT_EQ(report.problems[0].code, "unfillable-hole");
  EXPECT_NE(report.problems[0].message.find("of 6 edges, can't be filled: each triangulation found "
                                            "joins vertices that are joined already"),
            std::string::npos)
      << report.problems[0].message;
}

TEST(FillHoles, FillsWhatAPinchedVertexDivides) {
  // Two deleted faces of a torus that touch in a vertex: one loop that passes it twice, or two.
  Mesh mesh = shapes::mesh_of(shapes::torus(8, 6)).value();
  ASSERT_TRUE(operations::delete_face(mesh, Face(9)));
  ASSERT_TRUE(operations::delete_face(mesh, Face(16)));
  std::size_t pinched = 0;
  for (const Vertex v : mesh.vertices()) pinched += mesh.is_manifold(v) ? 0 : 1;
  EXPECT_EQ(pinched, 1U);
  EXPECT_EQ(count_loops(mesh), 2U);
  const mend::Report report = mended(mesh, fill);
  EXPECT_EQ(report.problems.size(), 0U);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(euler_characteristic(mesh), 0);
}

TEST(FillHoles, GivesNewFacesTheDefaultAttributes) {
  Mesh mesh = shapes::mesh_of(shapes::icosahedron()).value();
  ASSERT_TRUE(operations::delete_vertex(mesh, Vertex(3)));
  const mend::Report report = mended(mesh, fill);
  ASSERT_EQ(report.faces.size(), 3U);
  for (const auto& column : mesh.attributes().of(ItemKind::kFace)) {
    for (const Index f : report.faces) EXPECT_EQ(column->get(f, 0), 0) << column->name();
  }
}

// The search for the hole of 9 edges misses a filling within the angle. The hole of 3 edges, which
// is filled later, joins two of its vertices: now the search finds one.
TEST(FillHoles, LeavesNothingThatASecondCallFills) {
  constexpr Point kPoints[] = {
      {0.81f, -1.44f, 0.43f},  {0.94f, -1.24f, -0.01f}, {-0.18f, -1.07f, -0.34f},
      {0.45f, -0.29f, 0.99f},  {-0.55f, -1.1f, -0.19f}, {0.52f, -0.43f, 0.31f},
      {0.11f, -0.36f, -0.19f}, {0.34f, -0.5f, -0.4f},   {-0.11f, -0.58f, -0.41f},
      {0.26f, -1.35f, -0.33f}, {0.44f, -0.77f, -0.39f}, {0.29f, -0.29f, -0.99f},
      {0.19f, -1.15f, 0.06f},  {0.25f, -0.85f, -0.32f}, {0.56f, -1.41f, 0.45f},
      {0.31f, 0.33f, -0.35f},  {0.3f, -0.62f, 0.71f}};
  constexpr Index kFaces[][3] = {{0, 1, 2},  {1, 3, 4},    {4, 5, 6},   {7, 8, 9},   {6, 10, 8},
                                 {7, 9, 11}, {12, 11, 13}, {0, 12, 14}, {13, 15, 16}};
  Mesh mesh;
  for (const Point& p : kPoints) (void)mesh.add_vertex(p);
  for (const auto& [a, b, c] : kFaces) {
    const std::array corners = {Vertex(a), Vertex(b), Vertex(c)};
    ASSERT_TRUE(operations::add_face(mesh, corners));
  }
  const mend::Report first = mended(mesh, fill);
  const mend::Report second = mended(mesh, fill);
  EXPECT_EQ(second.count(Code::kFilledHole), 0U) << second.summary;
  EXPECT_EQ(first.summary, "2 holes filled.");
  EXPECT_EQ(first.problems.size(), 0U);
  EXPECT_LE(sharpest_at(mesh, first.faces), 160);
}

TEST(FillHoles, LeavesPositionsThatAreNoNumbers) {
  Mesh mesh = shapes::mesh_of(shapes::cylinder(5, 1, shapes::Caps::kOpen)).value();
  mesh.set_position(Vertex(0), {0, std::nanf(""), 0});
  const Result<mend::Report> report = mend::fill_holes(mesh);
  ASSERT_TRUE(report);
  EXPECT_EQ(report.value().count(Code::kUnfillableHole), 1U);
  EXPECT_EQ(report.value().count(Code::kFilledHole), 1U);
}

TEST(FillHoles, ClosesRandomHolesInASphereWithoutFolds) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = shapes::mesh_of(shapes::ico_sphere(4)).value();
    for (int i = 0; i < 8; ++i) {
      const Vertex v(Index(random() % mesh.vertex_slots()));
      if (mesh.is_live(v)) punch(mesh, v, 1 + int(random() % 2));
    }
    ASSERT_TRUE(mend::split_pinched_vertices(mesh));
    ASSERT_TRUE(mend::drop_small_components(mesh, {.area = 0.5}));
    const std::size_t holes = count_loops(mesh);
    ASSERT_GT(holes, 3U);
    const mend::Report report = mended(mesh, fill);
    EXPECT_EQ(report.count(Code::kFilledHole), holes) << report.summary;
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_EQ(euler_characteristic(mesh), 2);
    const double sharpest = sharpest_at(mesh, report.faces);
    EXPECT_LT(sharpest, 15);
  }
}

TEST(FillHoles, ClosesHolesPunchedIntoTheCollection) {
  HALFEDGE_NEEDS_DATA();
  std::size_t closed = 0;
  for (const auto& path : data_files("good", {".off", ".obj", ".ply"})) {
    if (std::filesystem::file_size(path) > 400'000) continue;
    const Result<ParsedFile> file = parse_file(path);
    if (!file) continue;
    Mesh mesh;
    RepairReport soup;
    ASSERT_TRUE(build_from_soup(mesh, file.value().soup.view(), {}, soup));
    if (!is_closed(mesh) || mesh.face_count() < 500) continue;
    const std::int64_t chi = euler_characteristic(mesh);
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(path.filename().string() + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      Mesh punched = copy_of(mesh);
      for (int i = 0; i < 5; ++i) {
        const Vertex v(Index(random() % punched.vertex_slots()));
        if (punched.is_live(v) && !punched.is_isolated(v)) {
          ASSERT_TRUE(operations::delete_vertex(punched, v));
        }
      }
      ASSERT_TRUE(mend::split_pinched_vertices(punched));
      Result<mend::Report> report = mend::fill_holes(punched, {.max_angle = 180});
      ASSERT_TRUE(report);
      expect_sound(punched);
      if (report.value().count(Code::kUnfillableHole) > 0) continue;
      EXPECT_TRUE(is_closed(punched));
      if (connected_components(punched).value().list.size() ==
          connected_components(mesh).value().list.size()) {
        EXPECT_EQ(euler_characteristic(punched), chi);
      }
      ++closed;
    }
  }
  EXPECT_GE(closed, 30U);
}

TEST(FillHoles, RefusesAnAngle) {
  for (const double angle : {std::nan(""), -1.0, 181.0}) {
    Mesh mesh;
    const Result<mend::Report> report = mend::fill_holes(mesh, {.max_angle = angle});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, "bad-angle");
  }
}

}  // namespace
}  // namespace halfedge::test
