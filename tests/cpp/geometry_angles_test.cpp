// Angles of corners and edges, and the curvature that they tell.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/geometry/geometry.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/orientation.h>
#include <halfedge/shapes/shapes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "support/built.h"
#include "support/placed.h"
#include "support/random_polygons.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using geometry::angle_defect;
using geometry::corner_angle;
using geometry::cotan_weight;
using geometry::dihedral_angle;
using shapes::mesh_of;
using std::numbers::pi;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Of face 0 at vertex v.
double angle_at(const Mesh& mesh, Index v) {
  for (const Halfedge h : mesh.face_halfedges_ccw(Face(0))) {
    if (mesh.to_vertex(h) == Vertex(v)) return corner_angle(mesh, h);
  }
  return -1;
}

// ---- corners -----------------------------------------------------------------------------------

TEST(CornerAngle, OfKnownShapes) {
  const Mesh square = face_at({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  for (Index v = 0; v < 4; ++v) EXPECT_EQ(angle_at(square, v), pi / 2);
  const Mesh triangle = face_at({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}});
  EXPECT_EQ(angle_at(triangle, 0), pi / 2);
  EXPECT_EQ(angle_at(triangle, 1), pi / 4);
  EXPECT_EQ(angle_at(triangle, 2), pi / 4);
  // The third corner of this one lies on the way.
  const Mesh straight = face_at({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(angle_at(straight, 1), pi);
}

TEST(CornerAngle, IsMoreThanPiAtAReflexCorner) {
  const Mesh letter = l_prism();
  for (const Face f : {Face(0), Face(1)}) {
    for (const Halfedge h : letter.face_halfedges_ccw(f)) {
      const Index v = letter.to_vertex(h).index() % 6;
      EXPECT_EQ(corner_angle(letter, h), v == 3 ? 3 * pi / 2 : pi / 2);
    }
  }
  const Mesh arrow = face_at({{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}});
  EXPECT_EQ(angle_at(arrow, 3), 3 * pi / 2);
}

TEST(CornerAngle, OfFlatPolygonsAddUp) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Index n = 4 + seed % 20;
    Mesh mesh = face_at(star_shaped(n, seed));
    double sum = 0;
    bool has_reflex = false;
    for (Index v = 0; v < n; ++v) {
      sum += angle_at(mesh, v);
      has_reflex = has_reflex || angle_at(mesh, v) > pi;
    }
    EXPECT_NEAR(sum, (n - 2) * pi, 1e-6);
    EXPECT_TRUE(has_reflex || n <= 12);
    // Seen from behind the same corners are reflex.
    const double before = angle_at(mesh, 1);
    ASSERT_TRUE(operations::reverse(mesh));
    EXPECT_NEAR(angle_at(mesh, 1), before, 1e-14);
  }
}

TEST(CornerAngle, OfAWarpedFace) {
  const Mesh mesh = face_at({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}});
  EXPECT_EQ(angle_at(mesh, 0), pi / 2);
  EXPECT_EQ(angle_at(mesh, 1), pi / 2);
  EXPECT_NEAR(angle_at(mesh, 2), pi / 3, 1e-15);
  EXPECT_EQ(angle_at(mesh, 3), pi / 2);
}

TEST(CornerAngle, IsNothingOnTheBoundaryAndBesideASideWithoutLength) {
  const Mesh mesh = face_at({{-1, -1, -1}, {-1, -1, -1}, {-2, -3, -4}, {-5, 1, 1}});
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_TRUE(!mesh.is_boundary(h) || corner_angle(mesh, h) == 0);
  }
  EXPECT_EQ(angle_at(mesh, 0), 0);
  EXPECT_EQ(angle_at(mesh, 1), 0);
  EXPECT_GT(angle_at(mesh, 2), 0);
  const Mesh point = face_at({{1, 1, 1}, {1, 1, 1}, {0, 0, 0}});
  EXPECT_EQ(angle_at(point, 0), 0);
  EXPECT_EQ(angle_at(point, 1), 0);
  EXPECT_EQ(angle_at(point, 2), 0);
  EXPECT_TRUE(std::isnan(angle_at(face_at({{kNan, 1, 1}, {1, 1, 1}, {0, 0, 0}}), 0)));
}

TEST(CornerAngle, OfFacesWithoutAreaHasNoReflexCorner) {
  const Mesh line = face_at({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}});
  EXPECT_EQ(angle_at(line, 0), 0);
  EXPECT_EQ(angle_at(line, 1), pi);
  EXPECT_EQ(angle_at(line, 2), 0);
  const Mesh crossed = face_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  for (Index v = 0; v < 4; ++v) EXPECT_NEAR(angle_at(crossed, v), pi / 4, 1e-15);
}

TEST(CornerAngle, OfThinTrianglesIsNeverReflex) {
  std::mt19937 random(5);
  const auto between = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  for (int i = 0; i < 2000; ++i) {
    // Three points of a line, so near to each other and so far that their differences are rounded.
    std::vector<Point> corners;
    const Point a = {float(between(-99, 99)), float(between(-99, 99)), float(between(1, 99))};
    for (const int exponent : {0, -50, 4}) {
      const float t = std::ldexp(float(between(1, 9)), exponent);
      corners.push_back({a.x * t, a.y * t, a.z * t});
    }
    const Mesh mesh = face_at(corners);
    double sum = 0;
    for (Index v = 0; v < 3; ++v) {
      EXPECT_LE(angle_at(mesh, v), pi);
      sum += angle_at(mesh, v);
    }
    EXPECT_NEAR(sum, pi, 1e-12);
  }
}

TEST(CornerAngle, IsTheSameFarFromTheOriginAndAtAnySize) {
  Mesh mesh = l_prism();
  std::vector<double> expected;
  for (const Halfedge h : mesh.halfedges()) expected.push_back(corner_angle(mesh, h));
  const auto expect_same = [&] {
    for (const Halfedge h : mesh.halfedges()) {
      EXPECT_EQ(corner_angle(mesh, h), expected[h.index()]);
    }
  };
  translate(mesh, {1e6F, -1e6F, 1e6F});
  expect_same();
  translate(mesh, {-1e6F, 1e6F, -1e6F});
  for (const int exponent : {120, -240}) {
    scale(mesh, std::ldexp(1.0F, exponent / 2));
    scale(mesh, std::ldexp(1.0F, exponent - exponent / 2));
    expect_same();
  }
}

// ---- edges -------------------------------------------------------------------------------------

TEST(DihedralAngle, IsPositiveWhereTheSurfaceIsConvex) {
  Mesh cube = mesh_of(shapes::cube(1)).value();
  for (const Edge e : cube.edges()) EXPECT_EQ(dihedral_angle(cube, e), pi / 2);
  ASSERT_TRUE(operations::reverse(cube));
  for (const Edge e : cube.edges()) EXPECT_EQ(dihedral_angle(cube, e), -pi / 2);

  const Mesh tetrahedron = mesh_of(shapes::tetrahedron()).value();
  for (const Edge e : tetrahedron.edges()) {
    EXPECT_NEAR(dihedral_angle(tetrahedron, e), pi - std::acos(1.0 / 3), 1e-6);
  }
  const Mesh dodecahedron = mesh_of(shapes::dodecahedron()).value();
  for (const Edge e : dodecahedron.edges()) {
    EXPECT_NEAR(dihedral_angle(dodecahedron, e), pi - std::acos(-1 / std::sqrt(5)), 1e-6);
  }

  const Mesh letter = l_prism();
  for (const Edge e : letter.edges()) {
    const bool is_inner = e == letter.find_edge(Vertex(3), Vertex(9));
    EXPECT_EQ(dihedral_angle(letter, e), is_inner ? -pi / 2 : pi / 2);
  }
}

// Two triangles at the edge from vertex 0 to vertex 1; it goes the other way in the second.
std::vector<Mesh> hinge(Point left, Point right, Point end = {0, 1, 0}) {
  std::vector<Mesh> both;
  for (const auto& faces : {std::vector<std::vector<Index>>{{0, 1, 2}, {1, 0, 3}},
                            std::vector<std::vector<Index>>{{1, 0, 3}, {0, 1, 2}}}) {
    Mesh mesh = built(Shape{"a hinge", 4, faces});
    const std::vector<Point> places = {{0, 0, 0}, end, left, right};
    for (Index v = 0; v < 4; ++v) mesh.set_position(Vertex(v), places[v]);
    both.push_back(std::move(mesh));
  }
  return both;
}
double dihedral_at_hinge(const Mesh& mesh) {
  return dihedral_angle(mesh, mesh.find_edge(Vertex(0), Vertex(1)));
}

TEST(DihedralAngle, IsTheAngleByWhichAHingeIsTurned) {
  for (int degrees = -179; degrees <= 179; ++degrees) {
    const double angle = degrees * pi / 180;
    // The right one bends down, away from the normal, where the angle is positive.
    const Point right = {float(2 * std::cos(angle)), 0.25F, float(-2 * std::sin(angle))};
    for (const Mesh& mesh : hinge({-1, 0.5, 0}, right)) {
      EXPECT_NEAR(dihedral_at_hinge(mesh), angle, 1e-6);
    }
  }
  for (const Mesh& mesh : hinge({-1, 0.5, 0}, {3, 0.25, 0})) EXPECT_EQ(dihedral_at_hinge(mesh), 0);
}

TEST(DihedralAngle, IsPiAndNeverMinusPiWhereFacesLieOnEachOther) {
  for (const Mesh& mesh : hinge({-1, 0.5, 0}, {-3, 0.25, 0})) {
    EXPECT_EQ(dihedral_at_hinge(mesh), pi);
  }
  // So they do here, but for the rounding of the normals.
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(-50, 50);
  const auto point = [&] {
    return Point{float(any(random)), float(any(random)), float(any(random))};
  };
  for (int i = 0; i < 1000; ++i) {
    const Point end = point();
    const Point left = point();
    const Point right = {3 * left.x + 2 * end.x, 3 * left.y + 2 * end.y, 3 * left.z + 2 * end.z};
    for (const Mesh& mesh : hinge(left, right, end)) {
      EXPECT_EQ(dihedral_at_hinge(mesh), geometry::area(mesh) > 0 ? pi : 0);
    }
  }
}

TEST(DihedralAngle, IsNothingOnTheBoundaryAndBesideAFaceWithoutArea) {
  const Mesh open = face_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  for (const Edge e : open.edges()) EXPECT_EQ(dihedral_angle(open, e), 0);
  // The other normal points to each octant: its dot product with zeros is -0 in one of them.
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float z : {-1.0F, 1.0F}) {
        const Point end = {x, -y, 0};
        const Point on_line = {2 * x, -2 * y, 0};
        // Their normals are 2 (yz, xz, xy), and its opposite.
        for (const Point corner : {Point{x, y, -2 * z}, Point{-x, -y, 2 * z}}) {
          for (const Mesh& mesh : hinge(corner, on_line, end)) {
            EXPECT_EQ(dihedral_at_hinge(mesh), 0);
          }
          for (const Mesh& mesh : hinge(on_line, corner, end)) {
            EXPECT_EQ(dihedral_at_hinge(mesh), 0);
          }
        }
      }
    }
  }
  for (const Mesh& mesh : hinge({-1, 0, 0}, {kNan, 0, 0})) EXPECT_EQ(dihedral_at_hinge(mesh), 0);
}

TEST(DihedralAngle, OfAnEdgeWithoutLengthHasNoSign) {
  // Two quads that share a side without length.
  Mesh mesh = built(Shape{"two quads", 6, {{0, 1, 2, 3}, {1, 0, 4, 5}}});
  const std::vector<Point> places = {{0, 0, 0},  {0, 0, 0},  {-1, 1, 0},
                                     {-1, 0, 0}, {0, 0, -1}, {0, 1, -1}};
  for (Index v = 0; v < 6; ++v) mesh.set_position(Vertex(v), places[v]);
  EXPECT_EQ(dihedral_at_hinge(mesh), pi / 2);
  for (const Mesh& point : hinge({-1, 0.5, 0}, {1, 0, 0}, {0, 0, 0})) {
    EXPECT_EQ(dihedral_at_hinge(point), 0);
  }
}

TEST(CotanWeight, OfKnownShapes) {
  // A unit square and its diagonal.
  const Mesh square = built(placed({"a square", 4, {{0, 1, 2}, {0, 2, 3}}},
                                   {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  const auto weight = [](const Mesh& mesh, Index a, Index b) {
    return cotan_weight(mesh, mesh.find_edge(Vertex(a), Vertex(b)));
  };
  EXPECT_EQ(weight(square, 0, 2), 0);
  EXPECT_EQ(weight(square, 0, 1), 0.5);
  EXPECT_EQ(weight(square, 3, 0), 0.5);

  const Mesh octahedron = mesh_of(shapes::octahedron()).value();
  for (const Edge e : octahedron.edges()) {
    EXPECT_NEAR(cotan_weight(octahedron, e), 1 / std::sqrt(3), 1e-6);
  }
  // An obtuse angle, of 135 degrees, counts negative.
  const Mesh obtuse = face_at({{0, 0, 0}, {1, 0, 0}, {-1, 1, 0}});
  EXPECT_NEAR(weight(obtuse, 1, 2), -0.5, 1e-15);

  for (const Mesh& mesh : hinge({-1, 0, 0}, {0, 3, 0})) EXPECT_EQ(weight(mesh, 0, 1), 0.5);
  const Mesh line = face_at({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}});
  for (const Edge e : line.edges()) EXPECT_EQ(cotan_weight(line, e), 0);
  const Mesh nowhere = face_at({{0, 0, 0}, {kNan, 1, 1}, {3, 2, 3}});
  for (const Edge e : nowhere.edges()) EXPECT_EQ(cotan_weight(nowhere, e), 0);
}

TEST(CotanWeight, TimesSquaredLengthsIsTwiceTheArea) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh mesh = scattered_triangles(random_polygons(seed), seed);
    double energy = 0;
    for (const Edge e : mesh.edges()) {
      const double length = geometry::edge_length(mesh, e);
      energy += cotan_weight(mesh, e) * length * length;
    }
    EXPECT_NEAR(energy, 2 * geometry::area(mesh), 1e-9 * geometry::area(mesh));
  }
}

#if !defined(NDEBUG)
TEST(CotanWeightDeathTest, AssertsTriangles) {
  const Mesh cube = mesh_of(shapes::cube(1)).value();
  EXPECT_DEATH((void)cotan_weight(cube, Edge(0)), "between triangles");
}
#endif

// ---- vertices ----------------------------------------------------------------------------------

TEST(AngleDefect, OfKnownShapes) {
  const Mesh cube = mesh_of(shapes::cube(1)).value();
  for (const Vertex v : cube.vertices()) EXPECT_NEAR(angle_defect(cube, v), pi / 2, 1e-15);
  const Mesh octahedron = mesh_of(shapes::octahedron()).value();
  for (const Vertex v : octahedron.vertices()) {
    EXPECT_NEAR(angle_defect(octahedron, v), 2 * pi / 3, 1e-6);
  }
  EXPECT_EQ(angle_defect(built(with_isolated_vertices()), Vertex(0)), 2 * pi);
}

TEST(AngleDefect, OfAFlatGridIsThatOfItsRim) {
  for (const auto faces : {shapes::Faces::kQuads, shapes::Faces::kTriangles}) {
    const Mesh grid = mesh_of(shapes::grid(4, 4, faces)).value();
    for (const Vertex v : grid.vertices()) {
      const bool is_corner = grid.is_boundary(v) && std::abs(grid.position(v).x) == 0.5F &&
                             std::abs(grid.position(v).y) == 0.5F;
      EXPECT_NEAR(angle_defect(grid, v), is_corner ? pi / 2 : 0, 1e-15);
    }
  }
}

TEST(AngleDefect, OfAPinchedVertexCountsEachOfItsGaps) {
  // Right angles.
  const Mesh mesh =
      built(placed(pinched(2), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}));
  EXPECT_NEAR(angle_defect(mesh, Vertex(0)), -pi, 1e-15);
  EXPECT_NEAR(angle_defect(mesh, Vertex(1)), pi - pi / 4, 1e-15);
}

TEST(AngleDefect, OfAllVerticesOfTrianglesIsTheEulerCharacteristic) {
  std::vector<Mesh> meshes;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    meshes.push_back(scattered_triangles(random_polygons(seed), seed));
    if (seed % 3 != 0) continue;
    // With more holes, more pinched vertices, and deleted slots.
    Mesh& mesh = meshes.back();
    for (Index f = seed % 7; f < mesh.face_slots(); f += 5) {
      ASSERT_TRUE(operations::delete_face(mesh, Face(f)));
    }
  }
  for (const Shape& shape : all_shapes()) {
    meshes.push_back(scattered_triangles(shape, 9));
  }
  std::size_t pinched_vertices = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    SCOPED_TRACE("mesh " + std::to_string(i) + ", seeds below 100 first");
    double sum = 0;
    for (const Vertex v : meshes[i].vertices()) {
      sum += angle_defect(meshes[i], v);
      pinched_vertices += meshes[i].is_manifold(v) ? 0U : 1U;
    }
    EXPECT_NEAR(sum, 2 * pi * double(euler_characteristic(meshes[i])), 1e-10);
  }
  EXPECT_GT(pinched_vertices, 100U);
}

}  // namespace
}  // namespace halfedge::test
