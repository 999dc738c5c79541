#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using Corners = std::vector<Index>;

/// The corners of each live face, from its smallest on: what doesn't depend on where a face begins.
std::vector<Corners> faces_of(const Mesh& mesh) {
  std::vector<Corners> faces;
  for (const Face f : mesh.faces()) {
    Corners corners;
    for (const Vertex v : mesh.face_vertices_ccw(f)) corners.push_back(v.index());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.push_back(corners);
  }
  return faces;
}

Mesh dual_of(const Mesh& mesh) {
  Mesh out;
  const Result<DualMaps> maps = dual(mesh, out);
  EXPECT_TRUE(maps.ok()) << (maps ? "" : maps.error().message);
  EXPECT_FALSE(has_errors(validate(out)));
  return out;
}

Mesh shape(const Result<PolygonSoup>& polygons) { return shapes::mesh_of(polygons).value(); }

struct Numbers {
  Index vertices, edges, faces, degree;
  friend bool operator==(const Numbers&, const Numbers&) = default;
};

Numbers numbers_of(const Mesh& mesh) {
  const Index degree = mesh.degree(Face(0));
  for (const Face f : mesh.faces()) EXPECT_EQ(mesh.degree(f), degree);
  return {mesh.vertex_count(), mesh.edge_count(), mesh.face_count(), degree};
}

TEST(Dual, ExchangesTheRegularSolids) {
  EXPECT_EQ(numbers_of(dual_of(shape(shapes::tetrahedron()))), (Numbers{4, 6, 4, 3}));
  EXPECT_EQ(numbers_of(dual_of(shape(shapes::cube()))), (Numbers{6, 12, 8, 3}));
  EXPECT_EQ(numbers_of(dual_of(shape(shapes::octahedron()))), (Numbers{8, 12, 6, 4}));
  EXPECT_EQ(numbers_of(dual_of(shape(shapes::icosahedron()))), (Numbers{20, 30, 12, 5}));
  EXPECT_EQ(numbers_of(dual_of(shape(shapes::dodecahedron()))), (Numbers{12, 30, 20, 3}));
}

TEST(Dual, OfTheDualOfAClosedMeshIsTheMesh) {
  const Result<PolygonSoup> closed[] = {
      shapes::tetrahedron(), shapes::cube(),
      shapes::icosahedron(), shapes::prism(5),
      shapes::torus(5, 4),   shapes::uv_sphere(7, 5),
      shapes::ico_sphere(2), shapes::torus(4, 3, shapes::Faces::kTriangles),
      shapes::cone(6)};
  for (const Result<PolygonSoup>& polygons : closed) {
    const Mesh mesh = shape(polygons);
    const Mesh once = dual_of(mesh);
    EXPECT_EQ(once.vertex_count(), mesh.face_count());
    EXPECT_EQ(once.face_count(), mesh.vertex_count());
    EXPECT_EQ(once.edge_count(), mesh.edge_count());
    EXPECT_EQ(faces_of(dual_of(once)), faces_of(mesh));
  }
}

TEST(Dual, HasItsVerticesInTheCentroidsAndItsFacesAroundTheVertices) {
  const Mesh mesh = shape(shapes::grid(3, 3, shapes::Faces::kQuads, 3, 3));
  Mesh out;
  const DualMaps maps = dual(mesh, out).value();
  EXPECT_EQ(out.vertex_count(), 9U);
  EXPECT_EQ(out.face_count(), 4U);
  EXPECT_EQ(out.position(Vertex(0)), (Point{-1, -1, 0}));
  EXPECT_EQ(out.position(Vertex(5)), (Point{1, 0, 0}));
  EXPECT_EQ(faces_of(out),
            (std::vector<Corners>{{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}}));
  for (const Face f : mesh.faces()) EXPECT_EQ(maps.faces[f.index()], f.index());
  const Index expected[] = {kNone, kNone, kNone, kNone, kNone, 0,     1,     kNone,
                            kNone, 2,     3,     kNone, kNone, kNone, kNone, kNone};
  EXPECT_TRUE(std::equal(std::begin(expected), std::end(expected), maps.vertices.begin()));
}

TEST(Dual, LeavesOutWhatIsDeleted) {
  Mesh mesh = shape(shapes::octahedron());
  const Vertex lost = mesh.new_vertex();
  ASSERT_TRUE(append(mesh, shape(shapes::cube())).ok());
  mesh.release(lost);
  Mesh out;
  const DualMaps maps = dual(mesh, out).value();
  EXPECT_EQ(out.vertex_count(), 14U);
  EXPECT_EQ(maps.vertices[lost.index()], kNone);
  EXPECT_EQ(maps.vertices[lost.index() + 1], 6U);
  EXPECT_EQ(maps.faces[8], 8U);
}

TEST(Dual, CanReplaceTheMesh) {
  Mesh mesh = shape(shapes::cube());
  ASSERT_TRUE(dual(mesh, mesh).ok());
  EXPECT_EQ(numbers_of(mesh), (Numbers{6, 12, 8, 3}));
  BasicMesh<kWithoutPrev> lean;
  ASSERT_TRUE(dual(mesh, lean).ok());
  ASSERT_TRUE(dual(lean, mesh).ok());
  EXPECT_EQ(numbers_of(mesh), (Numbers{6, 12, 8, 3}));
}

TEST(Dual, OfABoundaryHasNoFacesThere) {
  const Mesh out = dual_of(reference_build(triangle()));
  EXPECT_EQ(out.vertex_count(), 1U);
  EXPECT_EQ(out.face_count(), 0U);
  EXPECT_EQ(dual_of(Mesh{}).vertex_count(), 0U);
  EXPECT_EQ(dual_of(reference_build(with_isolated_vertices())).vertex_count(), 1U);
  EXPECT_EQ(dual_of(reference_build(disk(7))).face_count(), 1U);
}

Error refusal_of(const Mesh& mesh) {
  Mesh out = shape(shapes::cube());
  const Result<void> checked = check_dual(mesh);
  const Result<DualMaps> refused = dual(mesh, out);
  EXPECT_FALSE(refused.ok());
  EXPECT_EQ(checked.error().message, refused.error().message);
  EXPECT_EQ(checked.error().code, refused.error().code);
  EXPECT_EQ(checked.error().witness, refused.error().witness);
  EXPECT_EQ(out.face_count(), 6U);
  return refused ? Error{} : refused.error();
}

TEST(Dual, RefusesWhatWouldBeNoPolygonMesh) {
  const Error low = refusal_of(reference_build(pillow()));
  EXPECT_EQ(low.code, "degree-below-three");
  EXPECT_EQ(low.message,
            "Vertex 0 has valence 2: its face in the dual would have as many corners, expected 3 "
            "or more.");
  EXPECT_EQ(low.witness.vertices, (std::vector<Index>{0}));

  // A sphere with a belt of two hexagons, 0 1 2 6 5 4 and 2 3 0 4 7 6, and fans above and below.
  Mesh belt = reference_build({"belt",
                               10,
                               {{0, 1, 2, 6, 5, 4},
                                {2, 3, 0, 4, 7, 6},
                                {4, 5, 8},
                                {5, 6, 8},
                                {6, 7, 8},
                                {7, 4, 8},
                                {1, 0, 9},
                                {2, 1, 9},
                                {3, 2, 9},
                                {0, 3, 9}}});
  const Edge left = belt.find_edge(Vertex(0), Vertex(4));
  const Edge right = belt.find_edge(Vertex(2), Vertex(6));
  const Error twice = refusal_of(belt);
  EXPECT_EQ(twice.code, "duplicate-edge") << twice.message;
  std::vector<Index> shared = twice.witness.edges;
  std::sort(shared.begin(), shared.end());
  EXPECT_EQ(shared,
            (std::vector<Index>{std::min(left, right).index(), std::max(left, right).index()}));
  EXPECT_EQ(twice.witness.faces, (std::vector<Index>{0, 1}));

  ASSERT_TRUE(decorator::join_face(belt, belt.edge_halfedge(left)).ok());
  const Error same = refusal_of(belt);
  EXPECT_EQ(same.code, "same-face-twice") << same.message;
  EXPECT_EQ(same.witness.edges, (std::vector<Index>{right.index()}));

  // A quad of which two corners across from each other lie inside, the others on the boundary.
  const Error pinched = refusal_of(
      reference_build({"kite", 6, {{0, 1, 2, 3}, {0, 3, 4}, {0, 4, 1}, {2, 1, 5}, {2, 5, 3}}}));
  EXPECT_EQ(pinched.code, "pinched-vertex") << pinched.message;
  EXPECT_EQ(pinched.witness.faces, (std::vector<Index>{0}));
}

TEST(Dual, IsCheckedOfAConstMesh) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = reference_build(shape);
    Mesh out;
    EXPECT_EQ(check_dual(mesh).ok(), dual(mesh, out).ok());
  }
  BasicMesh<kWithoutPrev> lean;
  EXPECT_TRUE(append(lean, reference_build(cube())).ok());
  EXPECT_TRUE(check_dual(lean));
}

TEST(Dual, OfACorruptMeshIsAnErrorOrAMesh) {
  std::mt19937 random(5);
  int errors = 0;
  for (int round = 0; round < 3000; ++round) {
    Mesh mesh = shape(round % 2 == 0 ? shapes::torus(5, 4) : shapes::grid(4, 3));
    Links& links = mesh.mutable_links();
    Array<Index>* const arrays[] = {&links.next, &links.to_vertex,       &links.prev,
                                    &links.face, &links.vertex_halfedge, &links.face_halfedge};
    for (int i = 0; i < 2; ++i) {
      Array<Index>& array = *arrays[random() % 6];
      const Index values[] = {kNone, kDeleted, Index(random()), Index(random() % 60), 0};
      array[random() % array.size()] = values[random() % 5];
    }
    Mesh out;
    const Result<void> can = check_dual(mesh);
    const Result<DualMaps> maps = dual(mesh, out);
    ASSERT_EQ(can.ok(), maps.ok());
    if (maps) {
      EXPECT_FALSE(has_errors(validate(out)));
    } else {
      EXPECT_EQ(can.error().message, maps.error().message);
      ++errors;
    }
  }
  EXPECT_GT(errors, 1000);
}

}  // namespace
}  // namespace halfedge::test
