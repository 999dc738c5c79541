// Every type of mesh measures the same, to the last bit, if it has the links to do so.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/directed_edges/convert.h>
#include <halfedge/geometry/geometry.h>

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "support/built.h"
#include "support/placed.h"
#include "support/random_polygons.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using namespace geometry;

// Which items of `mesh` are those of `whole`: the same, but for Directed Edges.
template <class AnyMesh>
struct Matched {
  const AnyMesh& mesh;
  const Mesh& whole;

  [[nodiscard]] Halfedge halfedge(Halfedge of_whole) const {
    if constexpr (std::is_same_v<AnyMesh, DirectedEdgesMesh>) {
      return mesh.find_halfedge(whole.from_vertex(of_whole), whole.to_vertex(of_whole));
    }
    return of_whole;
  }
  [[nodiscard]] Edge edge(Edge of_whole) const {
    return mesh.edge(halfedge(whole.edge_halfedge(of_whole)));
  }
};

#define HALFEDGE_EXPECT_SAME(links, call, call_of_whole) \
  static_assert(requires { call; } == (links));          \
  if constexpr (links) {                                 \
    EXPECT_EQ(call, call_of_whole);                      \
  }                                                      \
  static_assert(true)

template <class AnyMesh>
void expect_same_measures(const AnyMesh& mesh, const Mesh& whole) {
  constexpr bool kFaces = StoresFaces<AnyMesh>;
  constexpr bool kFaceHalfedges = StoresFaceHalfedges<AnyMesh>;
  constexpr bool kAnchors = StoresAnchors<AnyMesh>;
  const Matched<AnyMesh> matched{mesh, whole};
  for (const Face f : whole.faces()) {
    HALFEDGE_EXPECT_SAME(kFaceHalfedges, area_vector(mesh, f), area_vector(whole, f));
    HALFEDGE_EXPECT_SAME(kFaceHalfedges, face_normal(mesh, f), face_normal(whole, f));
    HALFEDGE_EXPECT_SAME(kFaceHalfedges, face_area(mesh, f), face_area(whole, f));
    HALFEDGE_EXPECT_SAME(kFaceHalfedges, face_centroid(mesh, f), face_centroid(whole, f));
  }
  for (const Halfedge h : whole.halfedges()) {
    const Halfedge its = matched.halfedge(h);
    HALFEDGE_EXPECT_SAME(kFaces, corner_angle(mesh, its), corner_angle(whole, h));
  }
  for (const Edge e : whole.edges()) {
    const Edge its = matched.edge(e);
    HALFEDGE_EXPECT_SAME(true, edge_length(mesh, its), edge_length(whole, e));
    HALFEDGE_EXPECT_SAME(true, edge_midpoint(mesh, its), edge_midpoint(whole, e));
    HALFEDGE_EXPECT_SAME(kFaces, dihedral_angle(mesh, its), dihedral_angle(whole, e));
    if (!is_triangle_mesh(whole)) continue;
    HALFEDGE_EXPECT_SAME(kFaces, cotan_weight(mesh, its), cotan_weight(whole, e));
  }
  for (const Vertex v : whole.vertices()) {
    HALFEDGE_EXPECT_SAME(kFaces && kAnchors, vertex_normal(mesh, v), vertex_normal(whole, v));
    HALFEDGE_EXPECT_SAME(kFaces && kAnchors, vertex_area(mesh, v), vertex_area(whole, v));
    HALFEDGE_EXPECT_SAME(kFaces && kAnchors, angle_defect(mesh, v), angle_defect(whole, v));
  }
  const auto list = [](const Result<Array<Point>>& points) {
    return std::vector<Point>(points.value().begin(), points.value().end());
  };
  HALFEDGE_EXPECT_SAME(true, bounding_box(mesh), bounding_box(whole));
  HALFEDGE_EXPECT_SAME(kFaceHalfedges, area(mesh), area(whole));
  HALFEDGE_EXPECT_SAME(kFaceHalfedges, list(face_normals(mesh)), list(face_normals(whole)));
  HALFEDGE_EXPECT_SAME(kFaces && kFaceHalfedges && kAnchors, list(vertex_normals(mesh)),
                       list(vertex_normals(whole)));
  const auto volume_or_refusal = [](const Result<double>& result) {
    return result.ok() ? std::to_string(result.value()) : result.error().message;
  };
  HALFEDGE_EXPECT_SAME(kFaces && kFaceHalfedges, volume_or_refusal(volume(mesh)),
                       volume_or_refusal(volume(whole)));
}

std::vector<Shape> scattered_shapes() {
  std::vector<Shape> shapes;
  for (const Shape& shape : all_shapes()) shapes.push_back(scattered(shape, 8));
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    shapes.push_back(scattered(random_polygons(seed), seed));
  }
  return shapes;
}

template <class AnyMesh>
class GeometryOf : public testing::Test {};
using Variants = testing::Types<BasicMesh<kWithoutPrev>, BasicMesh<kPrevAtRunTime>,
                                BasicMesh<kWithoutAnchors>, BasicMesh<kWithoutFaceHalfedges>,
                                BasicMesh<kWithoutFaces>, BasicMesh<kBareStorage>>;
TYPED_TEST_SUITE(GeometryOf, Variants);

TYPED_TEST(GeometryOf, IsThatOfTheWholeMesh) {
  for (const Shape& shape : scattered_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_same_measures(built<TypeParam>(shape), built(shape));
  }
}

TEST(GeometryOfDirectedEdges, IsThatOfTheWholeMesh) {
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < 20; ++seed) shapes.push_back(random_polygons(seed));
  for (const Shape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    const Mesh whole = scattered_triangles(shape, 6);
    DirectedEdgesMesh mesh;
    ASSERT_TRUE(from_mesh(whole, mesh));
    expect_same_measures(mesh, whole);
  }
}

}  // namespace
}  // namespace halfedge::test
