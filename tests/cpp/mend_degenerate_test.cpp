// Removing faces without area, and edges without length.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/operations/append.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/mending.h"

namespace halfedge::test {
namespace {

using mend::Code;

auto remove_with(double tolerance) {
  return [=](auto& mesh) {
    return mend::remove_degenerate_faces(mesh, mend::DegenerateOptions{.tolerance = tolerance});
  };
}
const auto remove_thin = remove_with(0);

using Counts3 = std::array<Index, 3>;

double distance(Point a, Point b) {
  return std::hypot(double{a.x} - double{b.x}, double{a.y} - double{b.y},
                    double{a.z} - double{b.z});
}

double area_of(const Mesh& mesh, Face f) {
  const std::vector<Index> corners = corners_of(mesh, mesh.face_halfedge(f));
  const Point o = mesh.position(Vertex(corners[0]));
  double x = 0;
  double y = 0;
  double z = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Point a = mesh.position(Vertex(corners[i - 1]));
    const Point b = mesh.position(Vertex(corners[i]));
    const double u[] = {double{a.x} - o.x, double{a.y} - o.y, double{a.z} - o.z};
    const double v[] = {double{b.x} - o.x, double{b.y} - o.y, double{b.z} - o.z};
    x += u[1] * v[2] - u[2] * v[1];
    y += u[2] * v[0] - u[0] * v[2];
    z += u[0] * v[1] - u[1] * v[0];
  }
  return std::hypot(x, y, z) / 2;
}

double total_area(const Mesh& mesh) {
  double sum = 0;
  for (const Face f : mesh.faces()) sum += area_of(mesh, f);
  return sum;
}

/// Each face is as wide as floats can tell, each edge has a length.
void expect_no_degenerates(const Mesh& mesh) {
  for (const Edge e : mesh.edges()) {
    EXPECT_GT(distance(mesh.position(mesh.to_vertex(mesh.edge_halfedge(e, 0))),
                       mesh.position(mesh.to_vertex(mesh.edge_halfedge(e, 1)))),
              0);
  }
  for (const Face f : mesh.faces()) {
    double longest = 0;
    for (const Halfedge h : mesh.face_halfedges_ccw(f)) {
      longest = std::max(
          longest, distance(mesh.position(mesh.from_vertex(h)), mesh.position(mesh.to_vertex(h))));
    }
    EXPECT_GT(2 * area_of(mesh, f), 1e-6 * longest * longest) << "face " << f.index();
  }
}

TEST(RemoveDegenerateFaces, CollapsesANeedle) {
  // Two vertices of a sheet in one place: two of its faces have no area.
  Mesh mesh = shapes::mesh_of(shapes::grid(3, 3, shapes::Faces::kTriangles)).value();
  ASSERT_EQ(counts_of(mesh), (Counts3{16, 33, 18}));
  mesh.set_position(Vertex(5), mesh.position(Vertex(6)));
  const double area = total_area(mesh);
  const mend::Report report = mended(mesh, remove_thin);
  EXPECT_EQ(counts_of(mesh), (Counts3{15, 30, 16}));
  EXPECT_EQ(report.summary, "1 edge collapsed.");
  EXPECT_EQ(report.vertices.size(), 1U);
  EXPECT_NEAR(total_area(mesh), area, 1e-6);
  expect_no_degenerates(mesh);
}

TEST(RemoveDegenerateFaces, FlipsTheLongSideOfACap) {
  // 2 lies on the side from 0 to 1.
  Mesh mesh = mesh_of({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {2, -2, 0}, {2, 3, 0}},
                      {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 4}});
  const mend::Report report = mended(mesh, remove_thin);
  EXPECT_EQ(report.summary, "1 edge flipped.");
  EXPECT_EQ(counts_of(mesh), (Counts3{5, 8, 4}));
  EXPECT_TRUE(mesh.find_edge(Vertex(2), Vertex(3)).valid());
  EXPECT_EQ(report.edges[0], mesh.find_edge(Vertex(2), Vertex(3)).index());
  EXPECT_NEAR(total_area(mesh), 10, 1e-6);
  expect_no_degenerates(mesh);
}

TEST(RemoveDegenerateFaces, MakesTheCornerOfACapOneOfALargerFace) {
  Mesh mesh = mesh_of({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {0, -2, 0}, {4, -2, 0}, {2, 3, 0}},
                      {{0, 1, 2}, {1, 0, 3, 4}, {2, 1, 5}, {0, 2, 5}});
  const mend::Report report = mended(mesh, remove_thin);
  EXPECT_EQ(report.summary, "1 face joined with a neighbour.");
  EXPECT_EQ(counts_of(mesh), (Counts3{6, 8, 3}));
  ASSERT_EQ(report.faces.size(), 1U);
  EXPECT_EQ(mesh.degree(Face(report.faces[0])), 5U);
}

TEST(RemoveDegenerateFaces, DeletesACapOnTheBoundary) {
  Mesh mesh =
      mesh_of({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {2, 3, 0}}, {{0, 1, 2}, {2, 1, 3}, {0, 2, 3}});
  const mend::Report report = mended(mesh, remove_thin);
  EXPECT_EQ(report.summary, "1 face on the boundary removed.");
  EXPECT_EQ(counts_of(mesh), (Counts3{4, 5, 2}));
  EXPECT_TRUE(mesh.is_boundary(Vertex(2)));
}

TEST(RemoveDegenerateFaces, LeavesACapWhoseLossWouldPinchAVertex) {
  // 2 lies on the boundary as well: there is a gap between the two faces above.
  Mesh mesh = mesh_of({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {0, 3, 0}, {3, 3, 0}},
                      {{0, 1, 2}, {2, 1, 4}, {0, 2, 3}});
  const mend::Report report = mended(mesh, remove_thin);
  EXPECT_EQ(report.summary, "1 face without area left.");
  EXPECT_EQ(counts_of(mesh), (Counts3{5, 7, 3}));
  EXPECT_EQ(report.problems[0].code, "degenerate-face");
  EXPECT_EQ(report.problems[0].message,
            "Face 0 is 4 long and 0 wide but can't be removed: Vertex 2 would be pinched.");
  EXPECT_EQ(report.problems[0].witness.faces, (std::vector<Index>{0}));
}

TEST(RemoveDegenerateFaces, DeletesATriangleThatHangsByAShortEdge) {
  const std::vector<std::vector<Point>> lone = {{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                                                {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}};
  for (const std::vector<Point>& corners : lone) {
    Mesh mesh = mesh_of(corners, {{0, 1, 2}});
    const mend::Report report = mended(mesh, remove_thin);
    EXPECT_EQ(report.summary, "1 face on the boundary removed.");
    EXPECT_EQ(counts_of(mesh), (Counts3{0, 0, 0}));
  }
  // Beside another one, which keeps the edge.
  Mesh mesh =
      mesh_of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}}, {{0, 1, 2}, {1, 0, 4, 3}});
  const mend::Report report = mended(mesh, remove_thin);
  EXPECT_TRUE(report.problems.empty());
  for (const Face f : mesh.faces()) EXPECT_GT(area_of(mesh, f), 0);
}

TEST(RemoveDegenerateFaces, CutsUpALargerFaceOnALine) {
  // A quad whose corners lie on one side of a square, between that and a square below.
  Mesh mesh = mesh_of(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 2, 0}, {3, 2, 0}, {0, -2, 0}, {3, -2, 0}},
      {{0, 3, 2, 1}, {0, 1, 2, 3, 5, 4}, {3, 0, 6, 7}});
  const double area = 12;
  const mend::Report report = mended(mesh, remove_thin);
  EXPECT_EQ(report.count(Code::kTriangulatedFace), 1U) << report.summary;
  EXPECT_EQ(report.count(Code::kDegenerateFace), 0U) << report.summary;
  EXPECT_EQ(counts_of(mesh), (Counts3{8, 9, 2}));
  EXPECT_NEAR(total_area(mesh), area, 1e-6);
  expect_no_degenerates(mesh);
}

TEST(RemoveDegenerateFaces, SaysWhyAnEdgeCannotBeCollapsed) {
  // The ends of an edge between two faces have a third common neighbour.
  Mesh mesh = shapes::mesh_of(shapes::tetrahedron()).value();
  mesh.set_position(Vertex(1), mesh.position(Vertex(0)));
  const mend::Report report = mended(mesh, remove_thin);
  EXPECT_EQ(counts_of(mesh), (Counts3{4, 6, 4}));
  EXPECT_EQ(report.count(Code::kZeroLengthEdge), 1U);
  EXPECT_EQ(report.count(Code::kDegenerateFace), 2U);
  EXPECT_EQ(report.problems[0].code, "zero-length-edge");
  EXPECT_NE(report.problems[0].message.find("has a length of 0 but can't be collapsed: Without"),
            std::string::npos)
      << report.problems[0].message;
}

// Flips that undo each other: the two faces of a quad are thin whichever diagonal they have.
TEST(RemoveDegenerateFaces, EndsWhereNoDiagonalHelps) {
  for (const double tolerance : {1.0, 0.0}) {
    SCOPED_TRACE(tolerance);
    std::vector<Point> points;
    std::vector<std::vector<Index>> faces;
    for (const float x : {0.0F, 1000.0F}) {
      const Index a = Index(points.size());
      const Point apex = tolerance > 0 ? Point{1.05F + x, 0.95F, 0} : Point{0.85e-5F, 0.95e-5F, x};
      const Point other = tolerance > 0 ? Point{0.5F + x, -8, 0} : Point{-0.5F, -8, x};
      const float origin = tolerance > 0 ? x : 0;
      const float z = tolerance > 0 ? 0 : x;
      points.insert(points.end(), {{origin, 0, z}, {origin + 10, 0, z}, apex, other});
      faces.insert(faces.end(), {{a, a + 1, a + 2}, {a + 1, a, a + 3}});
    }
    Mesh mesh = mesh_of(points, faces);
    const mend::Report report = mended(mesh, remove_with(tolerance));
    EXPECT_EQ(report.count(Code::kFlippedEdge), 2U) << report.summary;
    EXPECT_EQ(report.count(Code::kDegenerateFace), 2U) << report.summary;
    ASSERT_EQ(report.problems.size(), 2U);
    EXPECT_NE(report.problems[0].message.find("would be no wider"), std::string::npos)
        << report.problems[0].message;
  }
}

TEST(RemoveDegenerateFaces, LeavesWhatIsFine) {
  for (const Result<PolygonSoup>& shape :
       {shapes::ico_sphere(3), shapes::torus(9, 7), shapes::dodecahedron(),
        shapes::cone(40, shapes::Caps::kPolygons, 1, 1000)}) {
    Mesh mesh = shapes::mesh_of(shape).value();
    EXPECT_EQ(mended(mesh, remove_thin).summary, "Nothing to repair.");
  }
}

TEST(RemoveDegenerateFaces, CollapsesEdgesWithinTheTolerance) {
  Mesh mesh = shapes::mesh_of(shapes::grid(20, 20, shapes::Faces::kTriangles, 20, 20)).value();
  for (const Index v : {45U, 110U, 330U}) {
    Point p = mesh.position(Vertex(v));
    p.x += 0.99F;  // almost to the next
    mesh.set_position(Vertex(v), p);
  }
  Mesh strict = copy_of(mesh);
  EXPECT_EQ(mended(strict, remove_thin).summary, "Nothing to repair.");
  EXPECT_EQ(mended(mesh, remove_with(0.02)).summary, "3 edges collapsed.");
  EXPECT_EQ(mesh.vertex_count(), 438U);
  EXPECT_NEAR(total_area(mesh), 400, 1e-3) << "nothing has folded over";
}

TEST(RemoveDegenerateFaces, TakesNoUnknownPositionForALine) {
  Mesh mesh = shapes::mesh_of(shapes::icosahedron()).value();
  mesh.set_position(Vertex(0), {std::nanf(""), 0, 0});
  const Result<mend::Report> report = mend::remove_degenerate_faces(mesh);
  ASSERT_TRUE(report);
  EXPECT_EQ(report.value().summary, "Nothing to repair.");
}

// Vertices inserted on edges, with triangles between that have no area; and such that lie in the
// same place as others.
TEST(RemoveDegenerateFaces, ClearsRandomOnesOffClosedMeshes) {
  std::size_t caps = 0;
  std::size_t needles = 0;
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = shapes::mesh_of(seed % 2 == 0 ? shapes::ico_sphere(2)
                                              : shapes::torus(9, 7, shapes::Faces::kTriangles))
                    .value();
    const int chi = euler_characteristic(mesh);
    const double area = total_area(mesh);
    for (int i = 0; i < 20; ++i) {
      const Edge e(Index(random() % mesh.edge_slots()));
      if (!mesh.is_live(e)) continue;
      if (random() % 2 == 0) {
        // A cap: the middle of an edge between an edge and its face.
        const Halfedge h = mesh.edge_halfedge(e);
        const Point a = mesh.position(mesh.from_vertex(h));
        const Point b = mesh.position(mesh.to_vertex(h));
        const Point middle = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
        ASSERT_TRUE(operations::split_face(mesh, mesh.face(h), middle));
      } else {
        const Vertex from = mesh.to_vertex(mesh.edge_halfedge(e, 0));
        ASSERT_TRUE(operations::split_edge(mesh, e, mesh.position(from)));
      }
    }
    const mend::Report report = mended(mesh, remove_thin);
    caps += report.count(Code::kFlippedEdge);
    needles += report.count(Code::kCollapsedEdge);
    EXPECT_EQ(report.problems.size(), 0U) << report.problems[0].message << " " << report.summary;
    EXPECT_EQ(euler_characteristic(mesh), chi);
    EXPECT_NEAR(total_area(mesh), area, 1e-3 * area);
    if (report.problems.size() == 0) expect_no_degenerates(mesh);
  }
  EXPECT_GT(caps, 100U);
  EXPECT_GT(needles, 100U);
}

/// How many triangles are no wider than the tolerance, and edges no longer.
std::array<std::size_t, 2> count_thin_and_short(const Mesh& mesh, double tolerance) {
  std::array<std::size_t, 2> counts{};
  for (const Face f : mesh.faces()) {
    EXPECT_EQ(mesh.degree(f), 3U);
    double longest = 0;
    for (const Halfedge h : mesh.face_halfedges_ccw(f)) {
      longest = std::max(
          longest, distance(mesh.position(mesh.from_vertex(h)), mesh.position(mesh.to_vertex(h))));
    }
    const double width = longest > 0 ? 2 * area_of(mesh, f) / longest : 0;
    counts[0] += width <= std::max(tolerance, 1e-6 * longest) ? 1 : 0;
  }
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e);
    counts[1] +=
        distance(mesh.position(mesh.from_vertex(h)), mesh.position(mesh.to_vertex(h))) <= tolerance
            ? 1
            : 0;
  }
  return counts;
}

// Of triangles with corners anywhere many are slivers, whatever is done.
TEST(RemoveDegenerateFaces, ListsAllSliversThatStay) {
  std::size_t stay = 0;
  std::size_t removed = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = shapes::mesh_of(seed % 2 == 0 ? shapes::ico_sphere(2)
                                              : shapes::grid(9, 9, shapes::Faces::kTriangles, 2, 2))
                    .value();
    const float jitter = 0.05F * float(1 + seed % 7);
    std::uniform_real_distribution<float> offset(-jitter, jitter);
    for (const Vertex v : mesh.vertices()) {
      const Point p = mesh.position(v);
      mesh.set_position(v, {p.x + offset(random), p.y + offset(random), p.z});
    }
    const double tolerance = 0.02 * (1 + seed % 5);
    const std::size_t before = count_thin_and_short(mesh, tolerance)[0];
    const mend::Report report = mended(mesh, remove_with(tolerance));
    const auto [thin, edges] = count_thin_and_short(mesh, tolerance);
    EXPECT_EQ(report.count(Code::kDegenerateFace), thin) << report.summary;
    EXPECT_EQ(report.count(Code::kZeroLengthEdge), edges) << report.summary;
    EXPECT_LE(thin, before);
    stay += thin;
    removed += before - thin;
  }
  EXPECT_GT(stay, 10U);
  EXPECT_GT(removed, 100U);
}

TEST(RemoveDegenerateFaces, RefusesATolerance) {
  for (const double tolerance : {std::nan(""), -1.0, std::numeric_limits<double>::infinity()}) {
    Mesh mesh = shapes::mesh_of(shapes::cube()).value();
    const Result<mend::Report> report = remove_with(tolerance)(mesh);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, "bad-tolerance");
    EXPECT_EQ(mesh.face_count(), 6U);
  }
}

}  // namespace
}  // namespace halfedge::test
