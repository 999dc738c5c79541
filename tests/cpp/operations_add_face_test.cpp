#include <gtest/gtest.h>
#include <halfedge/io/parse.h>
#include <halfedge/operations/add_face.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "support/canonical.h"
#include "support/data_files.h"
#include "support/sweep.h"

namespace halfedge::test {
namespace {

using operations::add_face;
using operations::check_add_face;

std::vector<Vertex> handles(const std::vector<Index>& corners) {
  std::vector<Vertex> vertices;
  for (const Index v : corners) vertices.push_back(Vertex(v));
  return vertices;
}

template <class AnyMesh>
void add_vertices(AnyMesh& mesh, const Polygons& polygons) {
  for (std::size_t v = 0; v < polygons.vertex_count(); ++v) {
    const float* p = &polygons.positions[3 * v];
    ASSERT_TRUE(mesh.add_vertex({p[0], p[1], p[2]}).valid());
  }
}

// Equal but for the numbering of edges, and the anchors of vertices that are not on a boundary.
void expect_same(const Mesh& added, const Mesh& built) {
  const Canonical a(added);
  const Canonical b(built);
  EXPECT_EQ(a.sides, b.sides);
  EXPECT_EQ(a.firsts, b.firsts);
  for (const Vertex v : built.vertices()) {
    ASSERT_EQ(added.is_boundary(v), built.is_boundary(v));
    if (built.is_boundary(v)) {
      EXPECT_EQ(a.anchors[v.index()], b.anchors[v.index()]);
    }
  }
}

/// Adds the faces in a random order, validating after each if `often`; then compares with the
/// builder, given the faces in that order.
void add_in_random_order(Shape shape, std::mt19937& random, bool often) {
  for (std::vector<Index>& face : shape.faces) {
    std::rotate(face.begin(), face.begin() + std::ptrdiff_t(random() % face.size()), face.end());
  }
  std::shuffle(shape.faces.begin(), shape.faces.end(), random);
  const Shape shuffled(shape.name, shape.vertices, shape.faces);
  Mesh mesh;
  add_vertices(mesh, shuffled.polygons());
  for (std::size_t i = 0; i < shuffled.faces.size(); ++i) {
    const Result<Face> f = add_face(mesh, handles(shuffled.faces[i]));
    ASSERT_TRUE(f) << f.error().message;
    ASSERT_EQ(f.value().index(), i);
    ASSERT_EQ(mesh.to_vertex(mesh.face_halfedge(f.value())).index(), shuffled.faces[i][0]);
    if (often) {
      ASSERT_FALSE(has_errors(validate(mesh))) << validate(mesh)[0].message;
      ASSERT_TRUE(Invariants(mesh).hold());
    }
  }
  ASSERT_FALSE(has_errors(validate(mesh)));
  expect_same(mesh, reference_build(shuffled));
}

TEST(AddFace, MakesWhatTheBuilderMakesInAnyOrder) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("order " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::vector<Shape> shapes = all_shapes();
    const Shape& shape = shapes[seed % shapes.size()];
    SCOPED_TRACE(shape.name);
    add_in_random_order(shape, random, seed < 40);
    if (HasFatalFailure()) return;
  }
}

TEST(AddFace, MakesWhatTheBuilderMakesOfRandomPolygons) {
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    const Shape shape = random_polygons(seed);
    SCOPED_TRACE(shape.name);
    std::mt19937 random(seed);
    add_in_random_order(shape, random, seed < 4);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace halfedge::test
