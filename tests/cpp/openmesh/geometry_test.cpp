// What OpenMesh calculates of normals, lengths, angles and middles, in double precision too.

// g++ 12 takes what OpenMesh gives for a default, which it never reads, for a mistake.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/build/build.h>
#include <halfedge/geometry/geometry.h>
#include <halfedge/io/parse.h>
#include <halfedge/shapes/shapes.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "openmesh/theirs.h"
#include "support/data_files.h"
#include "support/placed.h"
#include "support/random_polygons.h"

namespace halfedge::test {
namespace {

using Theirs = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

Vector vector_of(const OpenMesh::Vec3d& a) { return {a[0], a[1], a[2]}; }
double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }
OpenMesh::VertexHandle theirs_of(Vertex v) { return OpenMesh::VertexHandle(int(v.index())); }
OpenMesh::FaceHandle theirs_of(Face f) { return OpenMesh::FaceHandle(int(f.index())); }

// The same faces, in the same order. False if OpenMesh can't add them one by one in this order.
bool mirror(const Mesh& ours, Theirs& theirs) {
  const QuietLog quiet;
  for (const Vertex v : ours.vertices()) {
    const Vector p = test::vector_of(ours, v);
    theirs.add_vertex({p[0], p[1], p[2]});
  }
  for (const Face f : ours.faces()) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (const Vertex v : ours.face_vertices_ccw(f)) corners.push_back(theirs_of(v));
    if (!theirs.add_face(corners).is_valid()) return false;
  }
  return true;
}

class Beside {
 public:
  Beside(const Mesh& ours, const Theirs& theirs) : ours_(ours), theirs_(theirs) {
    for (const Vertex v : ours.vertices()) {
      for (const double coordinate : test::vector_of(ours, v)) {
        size_ = std::max(size_, std::abs(coordinate));
      }
    }
  }

  // OpenMesh rounds what it finds far from the origin as that is far: `size_` times 1e-15 in
  // lengths. In angles, that weighs as much as the face is small. It takes the arc cosine, which
  // has half of the digits near 0 and pi.
  void compare() {
    for (const Face f : ours_.faces()) compare_face(f);
    for (const Edge e : ours_.edges()) compare_edge(e);
    for (const Halfedge h : ours_.halfedges()) compare_corner(h);
    if (!is_triangle_mesh(ours_)) return;
    for (const Vertex v : ours_.vertices()) compare_vertex(v);
  }
  [[nodiscard]] std::size_t compared() const { return compared_; }

 private:
  void expect_near(const Vector& ours, const OpenMesh::Vec3d& theirs, double tolerance) {
    EXPECT_LE(length(ours - vector_of(theirs)), tolerance);
    ++compared_;
  }
  void expect_near(double ours, double theirs, double tolerance) {
    EXPECT_NEAR(ours, theirs, tolerance);
    ++compared_;
  }
  [[nodiscard]] OpenMesh::HalfedgeHandle theirs_of(Halfedge h) const {
    return theirs_.find_halfedge(test::theirs_of(ours_.from_vertex(h)),
                                 test::theirs_of(ours_.to_vertex(h)));
  }

  void compare_face(Face f) {
    expect_near(geometry::face_centroid(ours_, f), theirs_.calc_face_centroid(test::theirs_of(f)),
                1e-14 * size_);
    const double area = geometry::face_area(ours_, f);
    if (area == 0) return;
    expect_near(geometry::face_normal(ours_, f), theirs_.calc_face_normal(test::theirs_of(f)),
                1e-14 + 1e-15 * ours_.degree(f) * size_ * size_ / area);
  }
  void compare_edge(Edge e) {
    const OpenMesh::EdgeHandle t = theirs_.edge_handle(theirs_of(ours_.edge_halfedge(e)));
    expect_near(geometry::edge_length(ours_, e), theirs_.calc_edge_length(t), 1e-14 * size_);
    expect_near(geometry::edge_midpoint(ours_, e), theirs_.calc_edge_midpoint(t), 1e-14 * size_);
    // It looks at two sides of each face.
    const auto is_triangle = [&](Face f) { return ours_.degree(f) == 3; };
    for (const Face f : ours_.edge_faces(e)) {
      if (!is_triangle(f)) return;
    }
    expect_near(geometry::dihedral_angle(ours_, e), theirs_.calc_dihedral_angle(t), 1e-7);
  }
  // It sees no reflex corners.
  void compare_corner(Halfedge h) {
    if (ours_.is_boundary(h)) return;
    const double angle = geometry::corner_angle(ours_, h);
    expect_near(std::min(angle, 2 * std::numbers::pi - angle),
                theirs_.calc_sector_angle(theirs_of(h)), 1e-7);
  }
  // calc_vertex_normal counts all faces alike; this one adds cross products. Between the fans of a
  // pinched vertex it takes sides that don't belong together.
  void compare_vertex(Vertex v) {
    if (!ours_.is_manifold(v)) return;
    const Vector normal = geometry::vertex_normal(ours_, v);
    if (normal == Vector{}) return;
    OpenMesh::Vec3d theirs;
    theirs_.calc_vertex_normal_correct(test::theirs_of(v), theirs);
    expect_near(normal, theirs, 1e-9);
  }

  const Mesh& ours_;
  const Theirs& theirs_;
  double size_ = 0;
  std::size_t compared_ = 0;
};

// How many numbers were compared.
std::size_t compare(const Mesh& ours) {
  Theirs theirs;
  if (!mirror(ours, theirs)) return 0;
  Beside beside(ours, theirs);
  beside.compare();
  return beside.compared();
}

TEST(OpenMeshGeometry, IsTheSameOfShapes) {
  for (const auto& shape : {shapes::cube(1), shapes::dodecahedron(), shapes::torus(9, 7),
                            shapes::cone(7), shapes::grid(4, 3), shapes::ico_sphere(3)}) {
    const Mesh mesh = shapes::mesh_of(shape).value();
    EXPECT_GT(compare(mesh), mesh.edge_count());
  }
  EXPECT_GT(compare(l_prism()), 0U);
}

TEST(OpenMeshGeometry, OfACubeHasTheSameVertexNormals) {
  const Mesh ours = shapes::mesh_of(shapes::cube(1)).value();
  Theirs theirs;
  ASSERT_TRUE(mirror(ours, theirs));
  theirs.request_face_normals();
  theirs.update_face_normals();
  for (const Vertex v : ours.vertices()) {
    const Vector normal = geometry::vertex_normal(ours, v);
    EXPECT_LE(length(normal - vector_of(theirs.calc_vertex_normal(theirs_of(v)))), 1e-15);
  }
}

TEST(OpenMeshGeometry, IsTheSameOfRandomMeshes) {
  std::size_t compared = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    compared += compare(built(scattered(random_polygons(seed), seed)));
    compared += compare(scattered_triangles(random_polygons(seed), seed));
  }
  EXPECT_GT(compared, 10000U);
}

TEST(OpenMeshGeometry, IsTheSameOfTheMeshCollection) {
  HALFEDGE_NEEDS_DATA();
  std::size_t meshes = 0;
  for (const auto& path : data_files("good", {".obj", ".off", ".ply", ".stl"})) {
    SCOPED_TRACE(path.filename().string());
    const Result<ParsedFile> file = parse_file(path);
    Mesh mesh;
    BuildReport report;
    if (!file.ok() || !build_from_polygons(mesh, file.value().soup.view(), report)) continue;
    if (mesh.face_count() < 30000) meshes += compare(mesh) > 0 ? 1U : 0U;
  }
  EXPECT_GT(meshes, 80U);
}

}  // namespace
}  // namespace halfedge::test
