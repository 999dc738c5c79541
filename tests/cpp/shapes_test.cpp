#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace halfedge::test {
namespace {

using namespace halfedge::shapes;

struct Expected {
  Index vertices, edges, faces;
  std::int64_t euler;  // 2 for a sphere
  std::size_t loops;   // boundary loops
  std::map<Index, Index> degrees;
};

struct Case {
  std::string name;
  Result<PolygonSoup> shape;
  Expected expected;
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  const auto add = [&](std::string name, Result<PolygonSoup> shape, Expected expected) {
    cases.push_back({std::move(name), std::move(shape), std::move(expected)});
  };
  add("tetrahedron", tetrahedron(), {4, 6, 4, 2, 0, {{3, 4}}});
  add("cube", cube(), {8, 12, 6, 2, 0, {{4, 6}}});
  add("octahedron", octahedron(), {6, 12, 8, 2, 0, {{3, 8}}});
  add("icosahedron", icosahedron(), {12, 30, 20, 2, 0, {{3, 20}}});
  add("dodecahedron", dodecahedron(), {20, 30, 12, 2, 0, {{5, 12}}});
  add("prism(3)", prism(3), {6, 9, 5, 2, 0, {{3, 2}, {4, 3}}});
  add("prism(7)", prism(7), {14, 21, 9, 2, 0, {{7, 2}, {4, 7}}});
  add("cone(4)", cone(4), {5, 8, 5, 2, 0, {{3, 4}, {4, 1}}});
  add("cone(9), fan", cone(9, Caps::kFans), {11, 27, 18, 2, 0, {{3, 18}}});
  add("cone(9), open", cone(9, Caps::kOpen), {10, 18, 9, 1, 1, {{3, 9}}});
  add("cylinder(8)", cylinder(8), {16, 24, 10, 2, 0, {{4, 8}, {8, 2}}});
  add("cylinder(8, 3), fans", cylinder(8, 3, Caps::kFans), {34, 72, 40, 2, 0, {{3, 16}, {4, 24}}});
  add("cylinder(8, 3), open", cylinder(8, 3, Caps::kOpen), {32, 56, 24, 0, 2, {{4, 24}}});
  add("cylinder(5, 2), open triangles", cylinder(5, 2, Caps::kOpen, Faces::kTriangles),
      {15, 35, 20, 0, 2, {{3, 20}}});
  add("grid(1, 1)", grid(1, 1), {4, 4, 1, 1, 1, {{4, 1}}});
  add("grid(4, 3)", grid(4, 3), {20, 31, 12, 1, 1, {{4, 12}}});
  add("grid(4, 3), triangles", grid(4, 3, Faces::kTriangles), {20, 43, 24, 1, 1, {{3, 24}}});
  add("torus(3, 3)", torus(3, 3), {9, 18, 9, 0, 0, {{4, 9}}});
  add("torus(12, 5)", torus(12, 5), {60, 120, 60, 0, 0, {{4, 60}}});
  add("torus(12, 5), triangles", torus(12, 5, Faces::kTriangles), {60, 180, 120, 0, 0, {{3, 120}}});
  add("uv_sphere(3, 2)", uv_sphere(3, 2), {5, 9, 6, 2, 0, {{3, 6}}});
  add("uv_sphere(10, 6)", uv_sphere(10, 6), {52, 110, 60, 2, 0, {{3, 20}, {4, 40}}});
  add("uv_sphere(10, 6), triangles", uv_sphere(10, 6, Faces::kTriangles),
      {52, 150, 100, 2, 0, {{3, 100}}});
  add("ico_sphere(0)", ico_sphere(0), {12, 30, 20, 2, 0, {{3, 20}}});
  add("ico_sphere(1)", ico_sphere(1), {42, 120, 80, 2, 0, {{3, 80}}});
  add("ico_sphere(4)", ico_sphere(4), {2562, 7680, 5120, 2, 0, {{3, 5120}}});
  return cases;
}

std::array<double, 3> coordinates(const Mesh& mesh, Vertex v) {
  const Point p = mesh.position(v);
  return {double{p.x}, double{p.y}, double{p.z}};
}

/// Six times the volume between the faces and the origin, as fans: positive if they face outwards.
double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (const Face f : mesh.faces()) {
    std::vector<std::array<double, 3>> p;
    for (const Vertex v : mesh.face_vertices_ccw(f)) p.push_back(coordinates(mesh, v));
    for (std::size_t i = 2; i < p.size(); ++i) {
      const auto &a = p[0], &b = p[i - 1], &c = p[i];
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return sum / 6;
}

double length_of(const std::array<double, 3>& p) {
  return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

Mesh mesh_or_fail(const Result<PolygonSoup>& shape) {
  Result<Mesh> mesh = mesh_of(shape);
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : mesh.error().message);
  return mesh ? std::move(mesh.value()) : Mesh{};
}

TEST(Shapes, AreValidMeshesOfTheItemsTheyPromise) {
  for (const Case& c : all_cases()) {
    SCOPED_TRACE(c.name);
    const Mesh mesh = mesh_or_fail(c.shape);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(mesh.vertex_count(), c.expected.vertices);
    EXPECT_EQ(mesh.edge_count(), c.expected.edges);
    EXPECT_EQ(mesh.face_count(), c.expected.faces);
    EXPECT_EQ(euler_characteristic(mesh), c.expected.euler);
    EXPECT_EQ(boundary_loops(mesh).value().size(), c.expected.loops);
    EXPECT_EQ(connected_components(mesh).value().list.size(), 1U);
    std::map<Index, Index> degrees;
    for (const Face f : mesh.faces()) ++degrees[mesh.degree(f)];
    EXPECT_EQ(degrees, c.expected.degrees);
  }
}

TEST(Shapes, FaceOutwards) {
  for (const Case& c : all_cases()) {
    SCOPED_TRACE(c.name);
    if (c.expected.loops > 0) continue;
    EXPECT_GT(volume_of(mesh_or_fail(c.shape)), 0.1);
  }
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(volume_of(mesh_or_fail(cube(2))), 8, 1e-6);
  EXPECT_NEAR(volume_of(mesh_or_fail(ico_sphere(5))), 4 * pi / 3, 0.01);
  EXPECT_NEAR(volume_of(mesh_or_fail(uv_sphere(200, 100))), 4 * pi / 3, 0.01);
  EXPECT_NEAR(volume_of(mesh_or_fail(cylinder(200, 3, Caps::kFans, Faces::kQuads, 2, 3))), 12 * pi,
              0.02);
  EXPECT_NEAR(volume_of(mesh_or_fail(cone(200, Caps::kPolygons, 2, 3))), 4 * pi, 0.01);
  EXPECT_NEAR(volume_of(mesh_or_fail(torus(200, 200, Faces::kQuads, 2, 0.5))), pi * pi, 0.02);
  // Open ones: their sides face away from the axis, and the grid faces +z.
  const Mesh sides = mesh_or_fail(cylinder(6, 2, Caps::kOpen));
  EXPECT_GT(volume_of(sides), 0.1);
  const Mesh sheet = mesh_or_fail(grid(1, 1));
  std::vector<Point> corners;
  for (const Vertex v : sheet.face_vertices_ccw(Face(0))) corners.push_back(sheet.position(v));
  const std::vector<Point> expected = {
      {-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
  EXPECT_EQ(corners, expected);
}

TEST(Shapes, OfOneRadiusLieOnThatSphere) {
  const auto expect_radius = [](const Result<PolygonSoup>& shape, double radius) {
    const Mesh mesh = mesh_or_fail(shape);
    for (const Vertex v : mesh.vertices()) {
      ASSERT_NEAR(length_of(coordinates(mesh, v)), radius, 1e-6 * radius);
    }
  };
  expect_radius(tetrahedron(), 1);
  expect_radius(octahedron(3), 3);
  expect_radius(icosahedron(0.5), 0.5);
  expect_radius(dodecahedron(2), 2);
  expect_radius(uv_sphere(13, 9, Faces::kQuads, 7), 7);
  expect_radius(ico_sphere(3, 1e-3), 1e-3);
}

TEST(Shapes, ThatAreRegularHaveEdgesOfOneLength) {
  const Result<PolygonSoup> regular[] = {tetrahedron(), cube(), octahedron(), icosahedron(),
                                         dodecahedron()};
  for (const Result<PolygonSoup>& shape : regular) {
    const Mesh mesh = mesh_or_fail(shape);
    std::map<long, int> lengths;  // in 1e-5
    for (const Edge e : mesh.edges()) {
      const auto a = coordinates(mesh, mesh.to_vertex(mesh.edge_halfedge(e, 0)));
      const auto b = coordinates(mesh, mesh.to_vertex(mesh.edge_halfedge(e, 1)));
      ++lengths[std::lround(1e5 * length_of({a[0] - b[0], a[1] - b[1], a[2] - b[2]}))];
    }
    EXPECT_EQ(lengths.size(), 1U);
  }
}

TEST(Shapes, AreExactAtQuarterTurns) {
  const Mesh mesh = mesh_or_fail(prism(12, 1, 2));
  EXPECT_EQ(mesh.position(Vertex(0)), (Point{1, -1, 0}));
  EXPECT_EQ(mesh.position(Vertex(3)), (Point{0, -1, -1}));
  EXPECT_EQ(mesh.position(Vertex(6)), (Point{-1, -1, 0}));
  EXPECT_EQ(mesh.position(Vertex(9)), (Point{0, -1, 1}));
  for (Index i = 0; i < 12; ++i) {
    const auto [x, y, z] = coordinates(mesh, Vertex(i));
    EXPECT_NEAR(x, std::cos(i * std::acos(-1.0) / 6), 1e-7) << i;
    EXPECT_NEAR(z, -std::sin(i * std::acos(-1.0) / 6), 1e-7) << i;
  }
}

TEST(Shapes, NumberTheGridRowByRow) {
  const Mesh mesh = mesh_or_fail(grid(4, 2, Faces::kQuads, 4, 2));
  EXPECT_EQ(mesh.position(Vertex(1 * 5 + 3)), (Point{1, 0, 0}));
  const Face f(1 * 4 + 2);
  std::vector<Index> corners;
  for (const Vertex v : mesh.face_vertices_ccw(f)) corners.push_back(v.index());
  EXPECT_EQ(corners, (std::vector<Index>{7, 8, 13, 12}));
}

TEST(Shapes, RefuseWhatIsNone) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::pair<Result<PolygonSoup>, std::string> refused[] = {
      {prism(2), "a prism has 2 sides, expected 3 or more"},
      {cone(0), "a cone has 0 segments, expected 3 or more"},
      {cylinder(2), "a cylinder has 2 segments, expected 3 or more"},
      {cylinder(3, 0), "a cylinder has 0 rings, expected 1 or more"},
      {grid(0, 1), "a grid has 0 columns, expected 1 or more"},
      {grid(1, 0), "a grid has 0 rows, expected 1 or more"},
      {torus(2, 3), "a torus has 2 rings, expected 3 or more"},
      {torus(3, 2), "a torus has 2 sides, expected 3 or more"},
      {uv_sphere(2, 2), "a uv-sphere has 2 segments, expected 3 or more"},
      {uv_sphere(3, 1), "a uv-sphere has 1 ring, expected 2 or more"},
      {octahedron(0), "A length of an octahedron is 0, expected a positive number"},
      {cube(-1), "A length of a cube is -1, expected a positive number"},
      {torus(3, 3, Faces::kQuads, 1, infinity), "A length of a torus is inf, expected a positive"},
      {torus(3, 3, Faces::kQuads, 2e38, 2e38), "A length of a torus is 4e+38, expected a positive"},
      {ico_sphere(0, std::nan("")), "A length of an ico-sphere is nan, expected a positive"},
  };
  for (const auto& [shape, sentence] : refused) {
    ASSERT_FALSE(shape.ok()) << sentence;
    EXPECT_EQ(shape.error().code, "bad-argument");
    EXPECT_EQ(shape.error().message.substr(0, sentence.size()), sentence);
    EXPECT_FALSE(mesh_of(shape).ok());
  }
}

TEST(Shapes, RefuseWhatIsTooLarge) {
  EXPECT_EQ(ico_sphere(13).error().code, "too-large");
  EXPECT_EQ(grid(1U << 16U, 1U << 16U).error().code, "too-large");
  EXPECT_EQ(grid(kNone, kNone).error().code, "too-large");
  EXPECT_EQ(torus(kNone, 3).error().code, "too-large");
  EXPECT_EQ(cylinder(kNone, kNone).error().code, "too-large");
  EXPECT_EQ(uv_sphere(kNone, kNone).error().code, "too-large");
  EXPECT_EQ(cone(kNone).error().code, "too-large");
  EXPECT_EQ(prism(kNone).error().code, "too-large");
}

TEST(Shapes, NameCountsThatNoNumberOf64BitsHolds) {
  const auto told = [](const Result<PolygonSoup>& shape) {
    const std::string& message = shape.error().message;
    return message.substr(0, message.find(" has "));
  };
  EXPECT_EQ(told(grid(65536, 65536)), "a grid of 4295098369 vertices and 4294967296 faces");
  EXPECT_EQ(told(grid(kNone, kNone)), "a grid of 1.84467e+19 vertices and 1.84467e+19 faces");
  EXPECT_EQ(told(torus(kNone, kNone, Faces::kTriangles)),
            "a torus of 1.84467e+19 vertices and 3.68935e+19 faces");
}

}  // namespace
}  // namespace halfedge::test
