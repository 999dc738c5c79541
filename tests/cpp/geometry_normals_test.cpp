// Normals of faces and of vertices, one by one and all of them.

#include <gtest/gtest.h>
#include <halfedge/decorator/complexes.h>
#include <halfedge/geometry/normals.h>
#include <halfedge/operations/append.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/orientation.h>
#include <halfedge/shapes/shapes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "support/built.h"
#include "support/placed.h"
#include "support/random_polygons.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using geometry::area_vector;
using geometry::face_normal;
using geometry::face_normals;
using geometry::vertex_normal;
using geometry::vertex_normals;
using shapes::mesh_of;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }
void expect_near(const Vector& a, const Vector& b, double tolerance) {
  EXPECT_LE(length(a - b), tolerance)
      << a[0] << " " << a[1] << " " << a[2] << ", expected " << b[0] << " " << b[1] << " " << b[2];
}
Vector unit(const Vector& a) { return {a[0] / length(a), a[1] / length(a), a[2] / length(a)}; }

TEST(FaceNormal, OfSquaresAndTriangles) {
  EXPECT_EQ(face_normal(face_at({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), Face(0)),
            (Vector{0, 0, 1}));
  EXPECT_EQ(face_normal(face_at({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}), Face(0)),
            (Vector{0, 0, -1}));
  EXPECT_EQ(face_normal(face_at({{5, 2, 3}, {5, 6, 3}, {5, 6, 9}}), Face(0)), (Vector{1, 0, 0}));
  EXPECT_EQ(area_vector(face_at({{5, 2, 3}, {5, 6, 3}, {5, 6, 9}}), Face(0)), (Vector{24, 0, 0}));
  expect_near(face_normal(face_at({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), Face(0)), unit({1, 1, 1}),
              1e-15);
}

TEST(FaceNormal, OfConcavePolygons) {
  // Wherever the face begins: also at the reflex corner, and beside it.
  const std::vector<Point> arrow = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  for (std::size_t first = 0; first < 4; ++first) {
    std::vector<Point> corners;
    for (std::size_t i = 0; i < 4; ++i) corners.push_back(arrow[(first + i) % 4]);
    EXPECT_EQ(area_vector(face_at(corners), Face(0)), (Vector{0, 0, 2})) << first;
  }
  const Mesh letter = l_prism();
  EXPECT_EQ(area_vector(letter, Face(0)), (Vector{0, 0, -6}));
  EXPECT_EQ(area_vector(letter, Face(1)), (Vector{0, 0, 6}));
  EXPECT_EQ(face_normal(letter, Face(4)), (Vector{0, 1, 0}));
  EXPECT_EQ(face_normal(letter, Face(5)), (Vector{1, 0, 0}));
}

TEST(FaceNormal, OfAnyQuadIsThatOfItsDiagonals) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh quad = built(scattered(polygon(4), seed));
    const auto at = [&](Index v) { return vector_of(quad, Vertex(v)); };
    const Vector expected = cross(at(2) - at(0), at(3) - at(1));
    expect_near(area_vector(quad, Face(0)), expected, 1e-14);
    expect_near(face_normal(quad, Face(0)), unit(expected), 1e-12);
  }
}

TEST(FaceNormal, IsNewellsSumFarFromTheOriginToo) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Index n = 3 + seed % 9;
    Mesh mesh = built(scattered(polygon(n), seed));
    // So that moving the corners doesn't round them.
    for (float& coordinate : mesh.mutable_positions()) {
      coordinate = std::round(coordinate * 64) / 64;
    }
    Vector expected = {};
    for (Index i = 0; i < n; ++i) {
      const Vector p = vector_of(mesh, Vertex(i));
      const Vector q = vector_of(mesh, Vertex((i + 1) % n));
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3;
        const std::size_t m = (k + 2) % 3;
        expected[k] += (p[l] - q[l]) * (p[m] + q[m]);
      }
    }
    EXPECT_EQ(area_vector(mesh, Face(0)), expected);
    translate(mesh, {100000, -50000, 70000});
    EXPECT_EQ(area_vector(mesh, Face(0)), expected);
  }
  const Mesh far = face_at({{1e6F, -1e6F, 1e6F}, {1e6F + 1, -1e6F, 1e6F}, {1e6F, 1 - 1e6F, 1e6F}});
  EXPECT_EQ(face_normal(far, Face(0)), (Vector{0, 0, 1}));
}

TEST(FaceNormal, IsNothingWhereThereIsNoArea) {
  const Vector none = {};
  EXPECT_EQ(face_normal(face_at({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), Face(0)), none);
  EXPECT_EQ(face_normal(face_at({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}), Face(0)), none);
  // Its two halves cancel out.
  EXPECT_EQ(face_normal(face_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), Face(0)), none);
  EXPECT_EQ(face_normal(face_at({{0, 0, kNan}, {1, 0, 0}, {0, 1, 0}}), Face(0)), none);
  EXPECT_EQ(face_normal(face_at({{0, 0, 0}, {kInfinity, 1, 1}, {1, 2, 3}}), Face(0)), none);
  // A face of one corner.
  Mesh loop;
  const Halfedge h = decorator::make_loop(loop).value();
  const Face f = loop.face(loop.is_boundary(h) ? Mesh::opposite(h) : h);
  EXPECT_EQ(face_normal(loop, f), none);
}

TEST(FaceNormal, IsThereHoweverSmallOrLargeTheFaceIs) {
  for (const float size : {1e-44F, 1e-20F, 1e20F, 3e38F}) {
    const Mesh mesh = face_at({{0, 0, 0}, {size, 0, 0}, {0, 0, size}});
    EXPECT_EQ(face_normal(mesh, Face(0)), (Vector{0, -1, 0})) << size;
    EXPECT_EQ(vertex_normal(mesh, Vertex(1)), (Vector{0, -1, 0})) << size;
  }
}

TEST(AreaVector, IsAsIfOneCornerLayElsewhere) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = built(scattered(polygon(3 + seed % 5), seed));
    const Halfedge h = mesh.face_halfedge(Face(0));
    const Vector there = {0.5, -3, 1.25};
    const Vector expected = geometry::internal::area_vector(mesh, h, there);
    mesh.set_position(mesh.from_vertex(h), {0.5F, -3, 1.25F});
    expect_near(area_vector(mesh, Face(0)), expected, 1e-14);
  }
}

TEST(Normals, LookOutwardsAndTurnOverWithTheMesh) {
  for (const auto& shape : {shapes::cube(), shapes::dodecahedron(), shapes::ico_sphere(2)}) {
    Mesh mesh = mesh_of(shape).value();
    for (const double side : {1, -1}) {
      for (const Vertex v : mesh.vertices()) {
        EXPECT_GT(side * dot(vertex_normal(mesh, v), vector_of(mesh, v)), 0.8 * 0.5);
      }
      for (const Face f : mesh.faces()) {
        const Vertex corner = mesh.to_vertex(mesh.face_halfedge(f));
        EXPECT_GT(side * dot(face_normal(mesh, f), vector_of(mesh, corner)), 0.4);
      }
      ASSERT_TRUE(operations::reverse(mesh));
    }
  }
}

TEST(VertexNormal, OfACubeAreItsDiagonals) {
  const Mesh mesh = mesh_of(shapes::cube(2)).value();
  for (const Vertex v : mesh.vertices()) {
    expect_near(vertex_normal(mesh, v), unit(vector_of(mesh, v)), 1e-15);
  }
}

TEST(VertexNormal, CountsLargeFacesMore) {
  // A triangle of area 1/2 that looks up, and one of area 2 that looks aside.
  const Mesh mesh = built(placed({"a roof", 4, {{0, 1, 2}, {1, 0, 3}}},
                                 {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -4}}));
  EXPECT_EQ(area_vector(mesh, Face(0)), (Vector{0, 0, 1}));
  EXPECT_EQ(area_vector(mesh, Face(1)), (Vector{4, 0, 0}));
  for (const Index both : {0U, 1U}) {
    expect_near(vertex_normal(mesh, Vertex(both)), unit({4, 0, 1}), 1e-15);
  }
  EXPECT_EQ(vertex_normal(mesh, Vertex(2)), (Vector{0, 0, 1}));
  EXPECT_EQ(vertex_normal(mesh, Vertex(3)), (Vector{1, 0, 0}));
}

TEST(VertexNormal, AddsUpAllFansOfAPinchedVertex) {
  const Mesh mesh = built(placed(
      pinched(3), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 0, 2}, {0, 0, -3}, {-3, 0, 0}}));
  expect_near(vertex_normal(mesh, Vertex(0)), unit({4, 9, 1}), 1e-15);
  EXPECT_EQ(vertex_normals(mesh).value()[0].y, float(9 / std::sqrt(98)));
}

TEST(VertexNormal, IsNothingWithoutFacesAndWhereTheyCancelOut) {
  const Vector none = {};
  const Mesh isolated = built(with_isolated_vertices());
  EXPECT_EQ(vertex_normal(isolated, Vertex(0)), none);
  EXPECT_NE(vertex_normal(isolated, Vertex(1)), none);

  // Flat from above and from below.
  const Mesh flat = built(scattered(pillow(), 1));
  for (const Vertex v : flat.vertices()) EXPECT_EQ(vertex_normal(flat, v), none);

  // The same, but for rounding errors: around vertex 0 there and back, between corners that are
  // near and corners that are far.
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh fan = built(scattered(disk(10), seed));
    for (Index i = 1; i < 7; ++i) {
      const Point p = fan.position(Vertex(i));
      const float distance = std::ldexp(1.0F, int(7 * i + seed) % 13 - 6);
      fan.set_position(Vertex(i), {p.x * distance, p.y * distance, p.z * distance});
    }
    for (Index i = 1; i < 5; ++i) fan.set_position(Vertex(11 - i), fan.position(Vertex(1 + i)));
    EXPECT_EQ(vertex_normal(fan, Vertex(0)), none);
    EXPECT_EQ(vertex_normals(fan).value()[0], Point());
    // What is left when they differ is more than that.
    const Point p = fan.position(Vertex(10));
    fan.set_position(Vertex(10), {p.x, p.y, p.z + 1});
    EXPECT_NE(vertex_normal(fan, Vertex(0)), none);
    EXPECT_NE(vertex_normals(fan).value()[0], Point());
  }

  Mesh with_nan = mesh_of(shapes::cube()).value();
  with_nan.set_position(Vertex(0), {0, kNan, 0});
  EXPECT_EQ(vertex_normal(with_nan, Vertex(1)), none);
  EXPECT_NE(vertex_normal(with_nan, Vertex(7)), none);
}

TEST(AllNormals, OfSmallFacesBesideLargeOnes) {
  // A tiny tetrahedron, beside whose faces those of a huge one leave nothing of a double.
  Mesh mesh = mesh_of(shapes::tetrahedron(1e-10)).value();
  ASSERT_TRUE(append(mesh, mesh_of(shapes::tetrahedron(1e10)).value()));
  const Array<Point> normals = vertex_normals(mesh).value();
  for (const Vertex v : mesh.vertices()) {
    expect_near(vector_of(normals[v.index()]), unit(vector_of(mesh, v)), 1e-6);
  }
}

TEST(AllNormals, AreThoseOfEachItemBySlot) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = built(scattered(random_polygons(seed), seed));
    std::mt19937 random(seed);
    for (Index f = 0; seed % 2 == 0 && f < mesh.face_slots(); ++f) {
      if (random() % 4 == 0) (void)operations::delete_face(mesh, Face(f));
    }
    const Array<Point> of_faces = face_normals(mesh).value();
    const Array<Point> of_vertices = vertex_normals(mesh).value();
    ASSERT_EQ(of_faces.size(), mesh.face_slots());
    ASSERT_EQ(of_vertices.size(), mesh.vertex_slots());
    for (Index f = 0; f < mesh.face_slots(); ++f) {
      const bool is_there = !mesh.is_deleted(Face(f));
      const Vector expected = is_there ? face_normal(mesh, Face(f)) : Vector{};
      expect_near(vector_of(of_faces[f]), expected, 1e-7);
    }
    for (Index v = 0; v < mesh.vertex_slots(); ++v) {
      const bool is_there = !mesh.is_deleted(Vertex(v));
      const Vector expected = is_there ? vertex_normal(mesh, Vertex(v)) : Vector{};
      expect_near(vector_of(of_vertices[v]), expected, 1e-6);
    }
    // Into arrays that are there, whatever they hold.
    std::vector<Point> again(mesh.face_slots(), {7, 8, 9});
    face_normals(mesh, std::span(again));
    EXPECT_TRUE(std::ranges::equal(again, of_faces));
    again.assign(mesh.vertex_slots(), {7, 8, 9});
    ASSERT_TRUE(vertex_normals(mesh, std::span(again)));
    EXPECT_TRUE(std::ranges::equal(again, of_vertices));
  }
  EXPECT_TRUE(face_normals(Mesh()).value().empty());
  EXPECT_TRUE(vertex_normals(Mesh()).value().empty());
}

}  // namespace
}  // namespace halfedge::test
