// What CGAL measures: its Polygon_mesh_processing, the functions of its kernel, and its weights.

// CGAL before ours: its templates call a function `halfedge`, and must not find our namespace.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Weights/cotangent_weights.h>
#include <CGAL/centroid.h>
#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/build/build.h>
#include <halfedge/geometry/geometry.h>
#include <halfedge/io/parse.h>
#include <halfedge/operations/triangulate.h>
#include <halfedge/shapes/shapes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "cgal/surface_mesh.h"
#include "support/data_files.h"
#include "support/placed.h"
#include "support/random_polygons.h"

namespace halfedge::test {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using TheirPoint = Kernel::Point_3;
using TheirSurface = CGAL::Surface_mesh<TheirPoint>;
using std::numbers::pi;

double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }
double radians(double degrees) { return degrees * pi / 180; }

class Beside {
 public:
  explicit Beside(const Mesh& ours) : ours_(ours), theirs_(mirror<TheirSurface>(ours)) {
    for (const Vertex v : ours.vertices()) {
      const Vector p = vector_of(ours, v);
      theirs_.point(TheirVertex(v.index())) = {p[0], p[1], p[2]};
      for (const double coordinate : p) size_ = std::max(size_, std::abs(coordinate));
    }
  }

  /// pre: the mesh has but triangles. Where the origin is far, CGAL rounds as that is far.
  void compare() {
    for (const Face f : ours_.faces()) compare_face(f);
    for (const Edge e : ours_.edges()) compare_edge(e);
    for (const Halfedge h : ours_.halfedges()) compare_corner(h);
    compare_whole();
  }

 private:
  [[nodiscard]] TheirPoint at(Vertex v) const { return theirs_.point(TheirVertex(v.index())); }
  [[nodiscard]] Vertex apex(Halfedge h) const { return ours_.to_vertex(ours_.next(h)); }

  void compare_face(Face f) {
    const double area = geometry::face_area(ours_, f);
    EXPECT_NEAR(area, pmp::face_area(TheirFace(f.index()), theirs_), 1e-14 * size_ * size_);
    const Kernel::Vector_3 n = pmp::compute_face_normal(TheirFace(f.index()), theirs_);
    const double rounding = 1e-15 * size_ * size_ / area;
    if (rounding < 1e-3) {
      EXPECT_LE(length(geometry::face_normal(ours_, f) - Vector{n.x(), n.y(), n.z()}),
                1e-14 + rounding);
    }
  }
  void compare_edge(Edge e) {
    const CGAL::SM_Edge_index t = theirs_.edge(theirs_of(ours_.edge_halfedge(e)));
    EXPECT_NEAR(geometry::edge_length(ours_, e), pmp::edge_length(t, theirs_), 1e-14 * size_);
    if (ours_.is_boundary(e)) {
      EXPECT_EQ(geometry::dihedral_angle(ours_, e), 0);
      return;
    }
    const Halfedge h = ours_.edge_halfedge(e, 0);
    const Halfedge g = ours_.edge_halfedge(e, 1);
    const TheirPoint p = at(ours_.from_vertex(h));
    const TheirPoint q = at(ours_.to_vertex(h));
    const TheirPoint r = at(apex(h));
    const TheirPoint s = at(apex(g));
    const double areas = std::min(geometry::face_area(ours_, ours_.face(h)),
                                  geometry::face_area(ours_, ours_.face(g)));
    if (areas < 1e-9 * size_ * size_) return;
    // Theirs is the angle from face to face: straight is 180 degrees, and its sign is that of the
    // tetrahedron. It loses half of its digits where it is small or straight.
    const double between = radians(double(CGAL::approximate_dihedral_angle(p, q, r, s)));
    EXPECT_NEAR(geometry::dihedral_angle(ours_, e), between > 0 ? pi - between : -pi - between,
                1e-6);
    EXPECT_NEAR(geometry::cotan_weight(ours_, e),
                double(CGAL::Weights::cotangent_weight(r, q, s, p)) / 4,
                1e-12 * size_ * size_ / areas);
  }
  void compare_corner(Halfedge h) {
    if (ours_.is_boundary(h)) return;
    const double theirs = double(
        CGAL::approximate_angle(at(ours_.from_vertex(h)), at(ours_.to_vertex(h)), at(apex(h))));
    EXPECT_NEAR(geometry::corner_angle(ours_, h), radians(theirs), 1e-6);
  }
  void compare_whole() {
    const double area = geometry::area(ours_);
    EXPECT_NEAR(area, pmp::area(theirs_), 1e-12 * area + 1e-14 * size_ * size_);
    if (is_closed(ours_)) {
      EXPECT_NEAR(geometry::volume(ours_).value(), pmp::volume(theirs_), 1e-12 * area * size_);
    }
    const geometry::Box ours = geometry::bounding_box(ours_).value();
    const CGAL::Bbox_3 theirs = pmp::bbox(theirs_);
    EXPECT_EQ(vector_of(ours.min), (Vector{theirs.xmin(), theirs.ymin(), theirs.zmin()}));
    EXPECT_EQ(vector_of(ours.max), (Vector{theirs.xmax(), theirs.ymax(), theirs.zmax()}));
  }

  const Mesh& ours_;
  TheirSurface theirs_;
  double size_ = 0;
};

TEST(CgalGeometry, IsTheSameOfShapes) {
  using shapes::Faces;
  for (const auto& shape :
       {shapes::tetrahedron(), shapes::octahedron(), shapes::ico_sphere(3),
        shapes::torus(9, 7, Faces::kTriangles), shapes::grid(4, 3, Faces::kTriangles)}) {
    Beside(shapes::mesh_of(shape).value()).compare();
  }
}

TEST(CgalGeometry, IsTheSameOfRandomMeshes) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Beside(scattered_triangles(random_polygons(seed), seed)).compare();
    Beside(scattered_triangles(torus(5, 4), seed)).compare();
  }
}

TEST(CgalGeometry, OfPolygonsHasTheSameNormalsAndMiddles) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh ours = built(scattered(random_polygons(seed), seed));
    TheirSurface theirs = mirror<TheirSurface>(ours);
    for (const Vertex v : ours.vertices()) {
      const Vector p = vector_of(ours, v);
      theirs.point(TheirVertex(v.index())) = {p[0], p[1], p[2]};
    }
    for (const Face f : ours.faces()) {
      const Kernel::Vector_3 n = pmp::compute_face_normal(TheirFace(f.index()), theirs);
      const Vector normal = geometry::face_normal(ours, f);
      EXPECT_LE(length(normal - Vector{n.x(), n.y(), n.z()}), 1e-14 / geometry::face_area(ours, f));
      std::vector<TheirPoint> corners;
      for (const Vertex v : ours.face_vertices_ccw(f)) {
        corners.push_back(theirs.point(TheirVertex(v.index())));
      }
      const TheirPoint c = CGAL::centroid(corners.begin(), corners.end(), CGAL::Dimension_tag<0>());
      EXPECT_LE(length(geometry::face_centroid(ours, f) - Vector{c.x(), c.y(), c.z()}), 1e-15);
    }
  }
}

TEST(CgalGeometry, IsTheSameOfTheMeshCollection) {
  HALFEDGE_NEEDS_DATA();
  std::size_t meshes = 0;
  for (const auto& path : data_files("good", {".obj", ".off", ".ply", ".stl"})) {
    SCOPED_TRACE(path.filename().string());
    const Result<ParsedFile> file = parse_file(path);
    Mesh mesh;
    BuildReport report;
    if (!file.ok() || !build_from_polygons(mesh, file.value().soup.view(), report)) continue;
    if (mesh.face_count() > 30000) continue;
    for (Index f = 0, faces = mesh.face_slots(); f < faces; ++f) {
      if (mesh.degree(Face(f)) > 3) (void)operations::triangulate(mesh, Face(f));
    }
    Beside(mesh).compare();
    ++meshes;
  }
  EXPECT_GT(meshes, 80U);
}

}  // namespace
}  // namespace halfedge::test
