// Orientations reversed, faces triangulated, cuts glued, beside CGAL's functions on its
// Surface_mesh.

// CGAL before ours: its templates call a function `halfedge`, and must not find our namespace.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>
#include <halfedge/operations/cut.h>
#include <halfedge/operations/glue.h>
#include <halfedge/operations/orientation.h>
#include <halfedge/operations/triangulate.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "cgal/surface_mesh.h"

namespace halfedge::test {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

TEST(CgalSurgery, ReversesAlike) {
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    Theirs theirs = mirror(mesh);
    pmp::reverse_face_orientations(theirs);
    ASSERT_TRUE(operations::reverse(mesh).ok());
    expect_same(mesh, theirs);
    for (const Halfedge h : mesh.halfedges()) {
      EXPECT_EQ(mesh.next(h).index(), Index(theirs.next(theirs_of(h))));
      EXPECT_EQ(mesh.to_vertex(h).index(), Index(theirs.target(theirs_of(h))));
    }
  }
}

// ---- triangulation -----------------------------------------------------------------------------

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using TheirSurface = CGAL::Surface_mesh<Kernel::Point_3>;

// One concave polygon around a point in a tilted plane.
Shape random_polygon(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const Index n = 4 + seed % 40;
  std::vector<Index> corners;
  for (Index i = 0; i < n; ++i) corners.push_back(i);
  Shape shape("polygon", n, {corners});
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * (i + 0.9 * unit(random)) / n;
    const double r = 0.1 + unit(random);
    // Powers of two keep the plane exact.
    const float x = float(std::round(r * std::cos(angle) * 4096) / 4096);
    const float y = float(std::round(r * std::sin(angle) * 4096) / 4096);
    shape.positions[3 * i] = x;
    shape.positions[3 * i + 1] = y;
    shape.positions[3 * i + 2] = 0.5F * x - 0.25F * y;
  }
  return shape;
}

// Twice the area of the triangles as seen from above, and how many look down.
template <class Each>
std::pair<double, int> covered(const Each& each) {
  double sum = 0;
  int flipped = 0;
  each([&](const std::array<std::array<double, 2>, 3>& p) {
    const double area =
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    sum += std::abs(area);
    flipped += area <= 0 ? 1 : 0;
  });
  return {sum, flipped};
}

TEST(CgalSurgery, TriangulatesConcaveFacesAsWell) {
  int shorter = 0;
  for (std::uint32_t seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(seed);
    const Shape shape = random_polygon(seed);
    Mesh ours = reference_build(shape);
    TheirSurface theirs;
    std::vector<TheirSurface::Vertex_index> vertices;
    for (Index v = 0; v < shape.vertices; ++v) {
      const Point p = ours.position(Vertex(v));
      vertices.push_back(theirs.add_vertex(Kernel::Point_3(p.x, p.y, p.z)));
    }
    theirs.add_face(vertices);
    double their_length = 0;
    double our_length = 0;
    ASSERT_TRUE(pmp::triangulate_faces(theirs));
    ASSERT_EQ(operations::triangulate(ours).value() + 1, theirs.number_of_faces());
    const auto [their_area, their_flipped] = covered([&](const auto& add) {
      for (const auto f : theirs.faces()) {
        std::array<std::array<double, 2>, 3> p;
        std::size_t i = 0;
        for (const auto v : theirs.vertices_around_face(theirs.halfedge(f))) {
          p[i++] = {theirs.point(v).x(), theirs.point(v).y()};
        }
        add(p);
      }
    });
    const auto [our_area, our_flipped] = covered([&](const auto& add) {
      for (const Face f : ours.faces()) {
        std::array<std::array<double, 2>, 3> p;
        std::size_t i = 0;
        for (const Vertex v : ours.face_vertices_ccw(f)) {
          p[i++] = {double{ours.position(v).x}, double{ours.position(v).y}};
        }
        add(p);
      }
    });
    EXPECT_EQ(our_flipped, 0);
    EXPECT_EQ(their_flipped, 0);
    EXPECT_NEAR(our_area, their_area, 1e-9 * their_area);
    for (const auto e : theirs.edges()) {
      their_length += std::sqrt(CGAL::to_double(CGAL::squared_distance(
          theirs.point(theirs.vertex(e, 0)), theirs.point(theirs.vertex(e, 1)))));
    }
    for (const Edge e : ours.edges()) {
      const Point a = ours.position(ours.from_vertex(ours.edge_halfedge(e)));
      const Point b = ours.position(ours.to_vertex(ours.edge_halfedge(e)));
      our_length += std::hypot(double{a.x} - double{b.x}, double{a.y} - double{b.y},
                               double{a.z} - double{b.z});
    }
    // Up to 32 corners ours are the shortest diagonals there are; theirs are Delaunay's.
    if (shape.vertices <= 32) {
      EXPECT_LE(our_length, their_length * (1 + 1e-9));
    }
    shorter += our_length < their_length * (1 - 1e-9) ? 1 : 0;
  }
  EXPECT_GT(shorter, 10);
}

TEST(CgalSurgery, StitchesWhatWasCut) {
  // Their stitching looks for boundary edges in the same places: those of a cut.
  Mesh mesh = reference_build(quad_grid(4, 4));
  const Shape shape = quad_grid(4, 4);
  const std::array<Halfedge, 4> path = {
      mesh.find_halfedge(Vertex(2), Vertex(7)), mesh.find_halfedge(Vertex(7), Vertex(12)),
      mesh.find_halfedge(Vertex(12), Vertex(13)), mesh.find_halfedge(Vertex(13), Vertex(14))};
  const Halfedge g = operations::cut_path(mesh, path).value();
  TheirSurface theirs;
  std::vector<TheirSurface::Vertex_index> vertices;
  for (const Vertex v : mesh.vertices()) {
    const Point p = mesh.position(v);
    vertices.push_back(theirs.add_vertex(Kernel::Point_3(p.x, p.y, p.z)));
  }
  for (const Face f : mesh.faces()) {
    std::vector<TheirSurface::Vertex_index> corners;
    for (const Vertex v : mesh.face_vertices_ccw(f)) corners.push_back(vertices[v.index()]);
    theirs.add_face(corners);
  }
  EXPECT_EQ(pmp::stitch_borders(theirs), 4U);
  ASSERT_TRUE(operations::glue_path(mesh, Mesh::opposite(path[3]), g, 4).ok());
  EXPECT_EQ(mesh.edge_count(), theirs.number_of_edges());
  EXPECT_EQ(mesh.vertex_count(), theirs.number_of_vertices());
  EXPECT_EQ(polys_of(mesh), polys_of(reference_build(shape)));
}

}  // namespace
}  // namespace halfedge::test
