// Lengths, areas, volumes, middles and boxes.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/geometry/measures.h>
#include <halfedge/operations/append.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/dual.h>
#include <halfedge/operations/orientation.h>
#include <halfedge/operations/split_edge.h>
#include <halfedge/operations/split_face.h>
#include <halfedge/operations/triangulate.h>
#include <halfedge/shapes/shapes.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/built.h"
#include "support/placed.h"
#include "support/random_polygons.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using geometry::area;
using geometry::bounding_box;
using geometry::Box;
using geometry::edge_length;
using geometry::edge_midpoint;
using geometry::face_area;
using geometry::face_centroid;
using geometry::vertex_area;
using geometry::volume;
using shapes::mesh_of;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Point rounded(const Vector& a) { return {float(a[0]), float(a[1]), float(a[2])}; }

// ---- edges -------------------------------------------------------------------------------------

TEST(EdgeLength, IsTheDistanceOfTheEnds) {
  const Mesh mesh = face_at({{1, 2, 3}, {4, 6, 3}, {1, 2, 4}});
  EXPECT_EQ(edge_length(mesh, mesh.find_edge(Vertex(0), Vertex(1))), 5);
  EXPECT_EQ(edge_length(mesh, mesh.find_edge(Vertex(1), Vertex(2))), std::sqrt(26.0));
  EXPECT_EQ(edge_length(mesh, mesh.find_edge(Vertex(2), Vertex(0))), 1);
  const Mesh cube = mesh_of(shapes::cube(3)).value();
  for (const Edge e : cube.edges()) EXPECT_EQ(edge_length(cube, e), 3);
  const Mesh point = face_at({{7, 7, 7}, {7, 7, 7}, {7, 8, 7}});
  EXPECT_EQ(edge_length(point, point.find_edge(Vertex(0), Vertex(1))), 0);
}

TEST(EdgeLength, FitsWhereItsSquareFitsNoFloat) {
  const Mesh large = face_at({{-2e38F, 0, 0}, {2e38F, 0, 0}, {0, 3e38F, 0}});
  const double expected = 2 * double{2e38F};
  EXPECT_NEAR(edge_length(large, large.find_edge(Vertex(0), Vertex(1))) / expected, 1, 1e-15);
  const Mesh small = face_at({{0, 0, 0}, {1e-45F, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(edge_length(small, small.find_edge(Vertex(0), Vertex(1))), double{1e-45F});
}

TEST(EdgeMidpoint, IsWhereAnEdgeIsSplit) {
  const Mesh mesh = face_at({{1, 2, 3}, {4, 6, -3}, {1, 2, 4}});
  EXPECT_EQ(edge_midpoint(mesh, mesh.find_edge(Vertex(0), Vertex(1))), (Vector{2.5, 4, 0}));
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh random = built(scattered(random_polygons(seed), seed));
    const Index edges = random.edge_slots();
    for (Index e = 0; e < edges; ++e) {
      const Vector middle = edge_midpoint(random, Edge(e));
      const Vertex v = operations::split_edge(random, Edge(e)).value();
      EXPECT_EQ(random.position(v), rounded(middle));
    }
  }
}

// ---- faces -------------------------------------------------------------------------------------

TEST(FaceArea, OfFlatPolygonsIsExact) {
  EXPECT_EQ(face_area(face_at({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), Face(0)), 1);
  EXPECT_EQ(face_area(face_at({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}), Face(0)), 6);
  EXPECT_EQ(face_area(face_at({{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}}), Face(0)), 1);
  EXPECT_EQ(face_area(l_prism(), Face(0)), 3);
  EXPECT_EQ(face_area(l_prism(), Face(2)), 4);
  EXPECT_NEAR(face_area(face_at({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), Face(0)), std::sqrt(3) / 2,
              1e-15);
  EXPECT_EQ(
      face_area(face_at({{1e6F, 1e6F, -1e6F}, {1e6F + 3, 1e6F, -1e6F}, {1e6F, 1e6F, 4 - 1e6F}}),
                Face(0)),
      6);
}

TEST(FaceArea, OfWarpedFacesIsThatOfTheLargestProjection) {
  // The diagonals are (1, 1, 1) and (-1, 1, 0).
  const Mesh mesh = face_at({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}});
  EXPECT_NEAR(face_area(mesh, Face(0)), std::sqrt(6) / 2, 1e-15);
}

TEST(FaceArea, IsNothingWhereSidesCrossOrLieOnALine) {
  EXPECT_EQ(face_area(face_at({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}), Face(0)), 0);
  EXPECT_EQ(face_area(face_at({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), Face(0)), 0);
  EXPECT_TRUE(std::isnan(face_area(face_at({{0, 0, kNan}, {1, 0, 0}, {0, 1, 0}}), Face(0))));
}

TEST(FaceCentroid, IsWhereSplitFaceAndDualPutTheirVertices) {
  const Mesh triangle = face_at({{0, 0, 0}, {3, 0, 0}, {0, 6, 9}});
  EXPECT_EQ(face_centroid(triangle, Face(0)), (Vector{1, 2, 3}));
  // Not the centre of gravity: corners count, areas don't.
  EXPECT_EQ(face_centroid(l_prism(), Face(1)), (Vector{1, 1, 2}));
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = built(scattered(random_polygons(seed), seed));
    for (Index f = 0, faces = mesh.face_slots(); f < faces; ++f) {
      const Point centroid = rounded(face_centroid(mesh, Face(f)));
      EXPECT_EQ(mesh.position(operations::split_face(mesh, Face(f)).value()), centroid);
    }
  }
  const Mesh sphere = mesh_of(shapes::ico_sphere(2)).value();
  Mesh its_dual;
  ASSERT_TRUE(dual(sphere, its_dual));
  for (const Face f : sphere.faces()) {
    EXPECT_EQ(its_dual.position(Vertex(f.index())), rounded(face_centroid(sphere, f)));
  }
}

// ---- vertices ----------------------------------------------------------------------------------

TEST(VertexArea, IsAShareOfTheFaces) {
  const Mesh cube = mesh_of(shapes::cube(2)).value();
  for (const Vertex v : cube.vertices()) EXPECT_EQ(vertex_area(cube, v), 3);
  const Mesh triangle = face_at({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  for (const Vertex v : triangle.vertices()) EXPECT_EQ(vertex_area(triangle, v), 2);
  const Mesh isolated = built(with_isolated_vertices());
  EXPECT_EQ(vertex_area(isolated, Vertex(0)), 0);
  EXPECT_GT(vertex_area(isolated, Vertex(1)), 0);
  // A quad of area 4 and a triangle of area 1/2.
  const Mesh both = built(placed({"both", 5, {{0, 1, 2, 3}, {1, 0, 4}}},
                                 {{0, 0, 0}, {1, 0, 0}, {1, 4, 0}, {0, 4, 0}, {0, 0, 1}}));
  EXPECT_NEAR(vertex_area(both, Vertex(0)), 4 / 4.0 + 1 / 6.0, 1e-15);
  EXPECT_EQ(vertex_area(both, Vertex(2)), 1);
}

TEST(VertexArea, AddUpToThatOfTheMesh) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = built(scattered(random_polygons(seed), seed));
    for (Index f = 0; seed % 2 == 0 && f < mesh.face_slots(); f += 5) {
      ASSERT_TRUE(operations::delete_face(mesh, Face(f)));
    }
    double sum = 0;
    for (const Vertex v : mesh.vertices()) sum += vertex_area(mesh, v);
    EXPECT_NEAR(sum, area(mesh), 1e-12 * area(mesh));
  }
}

// ---- the whole ---------------------------------------------------------------------------------

TEST(Area, OfShapes) {
  EXPECT_EQ(area(mesh_of(shapes::cube(2)).value()), 24);
  EXPECT_EQ(area(l_prism()), 2 * 3 + 2 * 8);
  const double side = 2 * std::sqrt(2.0 / 3);
  EXPECT_NEAR(area(mesh_of(shapes::tetrahedron()).value()), std::sqrt(3) * side * side, 1e-6);
  EXPECT_EQ(area(Mesh()), 0);
  EXPECT_EQ(area(built(with_isolated_vertices())),
            face_area(built(with_isolated_vertices()), Face(0)));

  Mesh cube = mesh_of(shapes::cube(1)).value();
  ASSERT_TRUE(operations::delete_face(cube, Face(2)));
  EXPECT_EQ(area(cube), 5);
}

TEST(Volume, OfShapes) {
  EXPECT_EQ(volume(mesh_of(shapes::cube(1)).value()).value(), 1);
  EXPECT_EQ(volume(mesh_of(shapes::cube(2)).value()).value(), 8);
  EXPECT_EQ(volume(l_prism()).value(), 6);
  const double side = 2 * std::sqrt(2.0 / 3);
  EXPECT_NEAR(volume(mesh_of(shapes::tetrahedron()).value()).value(),
              side * side * side / (6 * std::sqrt(2)), 1e-6);
  const double sphere = volume(mesh_of(shapes::ico_sphere(5)).value()).value();
  EXPECT_NEAR(sphere, 4 * std::numbers::pi / 3, 0.01);
  EXPECT_LT(sphere, 4 * std::numbers::pi / 3);
  EXPECT_NEAR(volume(mesh_of(shapes::torus(200, 100)).value()).value(),
              2 * std::numbers::pi * std::numbers::pi * 0.4 * 0.4, 0.01);
  EXPECT_EQ(volume(Mesh()).value(), 0);
  Mesh points;
  EXPECT_TRUE(points.add_vertex({1, 2, 3}).valid());
  EXPECT_EQ(volume(points).value(), 0);
  EXPECT_EQ(volume(built(scattered(pillow(), 3))).value(), 0);
}

TEST(Volume, AddsUpComponentsFarFromEachOther) {
  Mesh mesh = mesh_of(shapes::cube(2)).value();
  translate(mesh, {-1e6F, 0, 1e6F});
  Mesh other = mesh_of(shapes::cube(4)).value();
  translate(other, {1e6F, 1e6F, 0});
  ASSERT_TRUE(append(mesh, other));
  EXPECT_NEAR(volume(mesh).value(), 8 + 64, 1e-7);
}

TEST(Volume, StaysWhereverTheMeshLiesAndTurnsItsSignWithTheMesh) {
  for (const auto& shape : {shapes::cube(2), shapes::dodecahedron(), shapes::torus(7, 5),
                            shapes::cone(5), shapes::ico_sphere(2)}) {
    Mesh mesh = mesh_of(shape).value();
    // So that moving the vertices doesn't round them.
    for (float& coordinate : mesh.mutable_positions()) {
      coordinate = std::round(coordinate * 64) / 64;
    }
    const double there = volume(mesh).value();
    const double its_area = area(mesh);
    EXPECT_GT(there, 0);
    for (const Point by : {Point{100000, 0, 0}, Point{-70000, 50000, 90000}}) {
      translate(mesh, by);
      EXPECT_NEAR(volume(mesh).value(), there, 1e-13 * there);
      EXPECT_NEAR(area(mesh), its_area, 1e-13 * its_area);
      translate(mesh, {-by.x, -by.y, -by.z});
    }
    ASSERT_TRUE(operations::reverse(mesh));
    EXPECT_NEAR(volume(mesh).value(), -there, 1e-13 * there);
    EXPECT_NEAR(area(mesh), its_area, 1e-13 * its_area);
  }
}

TEST(Measures, GrowWithTheMesh) {
  Mesh mesh = built(scattered(torus(6, 6), 4));
  const double length = edge_length(mesh, Edge(3));
  const double its_area = area(mesh);
  const double its_volume = volume(mesh).value();
  scale(mesh, 8);  // a power of two: nothing is rounded
  EXPECT_EQ(edge_length(mesh, Edge(3)), 8 * length);
  EXPECT_EQ(area(mesh), 64 * its_area);
  EXPECT_EQ(volume(mesh).value(), 512 * its_volume);
}

TEST(Volume, OfWarpedFacesIsThatOfTheirTrianglesWithTheCentroid) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = built(scattered(seed % 2 == 0 ? torus(5, 4) : bipyramid(4 + seed), seed));
    const double before = volume(mesh).value();
    for (Index f = 0, faces = mesh.face_slots(); f < faces; ++f) {
      ASSERT_TRUE(operations::split_face(mesh, Face(f)));
    }
    // The new vertices are rounded to floats.
    EXPECT_NEAR(volume(mesh).value(), before, 1e-6);
    // Of triangles: of each the tetrahedron with the origin.
    double sum = 0;
    for (const Face f : mesh.faces()) {
      std::vector<Vector> corners;
      for (const Vertex v : mesh.face_vertices_ccw(f)) corners.push_back(vector_of(mesh, v));
      sum += dot(corners[0], cross(corners[1], corners[2])) / 6;
    }
    EXPECT_NEAR(volume(mesh).value(), sum, 1e-13);
  }
}

TEST(Volume, IsRefusedWhereTheSurfaceIsOpen) {
  const auto refusal = [](const Mesh& mesh) {
    const Result<double> result = volume(mesh);
    EXPECT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, "open-surface");
    const Array<Halfedge> loops = boundary_loops(mesh).value();
    EXPECT_EQ(result.error().witness, (Witness{.halfedges = {loops[0].index()}}));
    return result.error().message;
  };
  EXPECT_EQ(refusal(built(triangle())), "The mesh has 1 boundary loop, expected a closed surface.");
  EXPECT_EQ(refusal(built(annulus(5))),
            "The mesh has 2 boundary loops, expected a closed surface.");
  EXPECT_EQ(refusal(built(pinched(4))), "The mesh has 1 boundary loop, expected a closed surface.");

  Mesh cube = mesh_of(shapes::cube(1)).value();
  ASSERT_TRUE(operations::delete_face(cube, Face(0)));
  EXPECT_EQ(refusal(cube), "The mesh has 1 boundary loop, expected a closed surface.");

  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh mesh = built(random_polygons(seed));
    const std::size_t loops = boundary_loops(mesh).value().size();
    EXPECT_EQ(volume(mesh).ok(), is_closed(mesh));
    if (loops > 1) {
      EXPECT_EQ(refusal(mesh), "The mesh has " + std::to_string(loops) +
                                   " boundary loops, expected a closed surface.");
    }
  }
}

TEST(Volume, OfWhatIsLeftClosed) {
  Mesh mesh = mesh_of(shapes::cube(1)).value();
  ASSERT_TRUE(append(mesh, built(triangle())));
  EXPECT_FALSE(volume(mesh).ok());
  ASSERT_TRUE(operations::delete_face(mesh, Face(6)));
  EXPECT_EQ(volume(mesh).value(), 1);
}

TEST(BoundingBox, IsThatOfAllLiveVertices) {
  EXPECT_FALSE(bounding_box(Mesh()).has_value());
  Mesh mesh = l_prism();
  EXPECT_EQ(bounding_box(mesh), (Box{{0, 0, 0}, {2, 2, 2}}));
  translate(mesh, {-5, -6, -7});
  EXPECT_EQ(bounding_box(mesh), (Box{{-5, -6, -7}, {-3, -4, -5}}));

  const Vertex isolated = mesh.add_vertex({1, -9, -6});
  EXPECT_EQ(bounding_box(mesh), (Box{{-5, -9, -7}, {1, -4, -5}}));
  ASSERT_TRUE(operations::delete_vertex(mesh, isolated));
  EXPECT_EQ(bounding_box(mesh), (Box{{-5, -6, -7}, {-3, -4, -5}}));
  // Corners that are left alone go along.
  for (Index v = 0; v < 12; ++v) (void)operations::delete_vertex(mesh, Vertex(v));
  EXPECT_EQ(mesh.vertex_count(), 0U);
  EXPECT_FALSE(bounding_box(mesh).has_value());

  // What lies nowhere is in no box.
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Mesh mended = face_at({{kNan, 8, 2}, {3, -kInfinity, 5}, {6, 7, kNan}});
  EXPECT_FALSE(bounding_box(mended).has_value());
  mended.set_position(Vertex(1), {3e38F, 3e38F, 3e38F});
  mended.set_position(Vertex(2), {6, 7, 8});
  EXPECT_EQ(bounding_box(mended), (Box{{6, 7, 8}, {3e38F, 3e38F, 3e38F}}));
}

}  // namespace
}  // namespace halfedge::test
