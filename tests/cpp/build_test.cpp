#include <gtest/gtest.h>
#include <halfedge/build/build.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "support/built.h"
#include "support/canonical.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

std::vector<Ends> outgoing_cw(const Mesh& mesh, Index v) {
  std::vector<Ends> ends;
  for (const Halfedge h : mesh.outgoing_cw(Vertex(v))) ends.push_back(ends_of(mesh, h));
  return ends;
}

TEST(Build, MakesTheMeshThatTheContractDescribesFromEveryShape) {
  for (const Shape& shape : all_shapes()) {
    const Mesh mesh = built(shape);
    expect_valid(mesh, shape.name);
    expect_same(mesh, reference_build(shape), shape.name);
  }
}

TEST(Build, KeepsTheOrderOfVerticesFacesAndCorners) {
  const Shape shape = mixed_polygons();
  const Mesh mesh = built(shape);
  ASSERT_EQ(mesh.vertex_count(), shape.vertices);
  ASSERT_EQ(mesh.face_count(), shape.faces.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> corners;
    for (const Vertex v : mesh.face_vertices_ccw(Face(f))) corners.push_back(v.index());
    EXPECT_EQ(corners, shape.faces[f]);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const float* p = &shape.positions[3 * v];
    EXPECT_EQ(mesh.position(Vertex(v)), (Point{p[0], p[1], p[2]}));
  }
}

TEST(Build, CountsWhatEulerCounts) {
  const auto characteristic = [](const Mesh& mesh) {
    return int(mesh.vertex_count()) - int(mesh.edge_count()) + int(mesh.face_count());
  };
  EXPECT_EQ(characteristic(built(cube())), 2);
  EXPECT_EQ(characteristic(built(pillow())), 2);
  EXPECT_EQ(characteristic(built(torus(5, 4))), 0);
  EXPECT_EQ(characteristic(built(torus(5, 4, 1))), -1);
  EXPECT_EQ(characteristic(built(annulus(5))), 0);
  EXPECT_EQ(characteristic(built(disk(7))), 1);
}

TEST(Build, AnchorsAnInteriorVertexInItsLastFace) {
  const Mesh mesh = built(quad_grid(3, 3));
  // Faces 0, 1, 3, 4 meet at vertex 5; in face 4 = 5 6 10 9 it is followed by 6.
  EXPECT_EQ(outgoing_cw(mesh, 5), (std::vector<Ends>{{5, 6}, {5, 1}, {5, 4}, {5, 9}}));
}

TEST(Build, AnchorsABoundaryVertexOnItsBoundaryHalfedge) {
  const Mesh mesh = built(quad_grid(3, 3));
  EXPECT_EQ(outgoing_cw(mesh, 1), (std::vector<Ends>{{1, 0}, {1, 5}, {1, 2}}));
  EXPECT_TRUE(mesh.is_boundary(mesh.vertex_halfedge(Vertex(1))));
}

TEST(Build, JoinsTheFansOfAPinchedVertexInTheOrderOfTheirBoundaryVertices) {
  // Their boundary halfedges lead from 0 to 5, 2, 8.
  const Shape shape{"three fans", 9, {{0, 3, 7}, {0, 7, 5}, {0, 1, 2}, {0, 4, 6}, {0, 6, 8}}};
  const Mesh mesh = built(shape);
  const std::vector<Ends> expected{{0, 2}, {0, 1}, {0, 5}, {0, 7}, {0, 3}, {0, 8}, {0, 6}, {0, 4}};
  EXPECT_EQ(outgoing_cw(mesh, 0), expected);
  EXPECT_FALSE(mesh.is_manifold(Vertex(0)));
  expect_valid(mesh, shape.name);
}

TEST(Build, JoinsThousandsOfFansAtOneVertex) {
  const Mesh mesh = built(pinched(20'000));
  EXPECT_EQ(mesh.valence(Vertex(0)), 40'000U);
  EXPECT_EQ(mesh.to_vertex(mesh.vertex_halfedge(Vertex(0))), Vertex(2));
  expect_valid(mesh, "20,000 fans");
}

TEST(Build, KeepsIsolatedVertices) {
  const Mesh mesh = built(with_isolated_vertices());
  EXPECT_EQ(mesh.vertex_count(), 6U);
  for (const Index v : {0U, 3U, 5U}) EXPECT_TRUE(mesh.is_isolated(Vertex(v)));
  for (const Index v : {1U, 2U, 4U}) EXPECT_FALSE(mesh.is_isolated(Vertex(v)));
}

TEST(Build, TakesAnEmptyInput) {
  const Mesh mesh = built(no_faces());
  EXPECT_EQ(mesh.vertex_count() + mesh.halfedge_count() + mesh.face_count(), 0U);
}

TEST(Build, GivesTheSameMeshForTrianglesWithAndWithoutSizes) {
  const Shape shape = triangle_grid(6, 5);
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, {shape.positions, {}, shape.corners}, report));
  expect_same(mesh, built(shape), shape.name);
}

TEST(Build, TakesAFaceOfAHundredThousandCorners) {
  std::vector<Index> front(100'000);
  std::iota(front.begin(), front.end(), 0U);
  const std::vector<Index> back(front.rbegin(), front.rend());
  const Mesh mesh = built({"two large faces", 100'000, {front, back}});
  EXPECT_EQ(mesh.degree(Face(1)), 100'000U);
  expect_valid(mesh, "two large faces");
}

TEST(Build, ForgetsWhatTheMeshHeldBefore) {
  Mesh mesh;
  BuildReport report;
  const Shape large = torus(12, 12);
  const Shape small = mixed_polygons();
  ASSERT_TRUE(build_from_polygons(mesh, large.polygons(), report));
  mesh.release(Face(3));
  const std::uint64_t version = mesh.version();
  ASSERT_TRUE(build_from_polygons(mesh, small.polygons(), report));
  expect_same(mesh, reference_build(small), "small after large");
  EXPECT_NE(mesh.version(), version);
  ASSERT_TRUE(build_from_polygons(mesh, large.polygons(), report));
  expect_same(mesh, reference_build(large), "large after small");
}

std::vector<const void*> arrays_of(const Mesh& mesh) {
  const Links& links = mesh.links();
  return {links.next.data(),
          links.prev.data(),
          links.to_vertex.data(),
          links.face.data(),
          links.vertex_halfedge.data(),
          links.face_halfedge.data(),
          mesh.positions().data()};
}

TEST(Build, ReusesTheMemoryOfTheMesh) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Shape shape = random_polygons(seed);
    Mesh mesh = built(shape);
    const std::vector<const void*> before = arrays_of(mesh);
    BuildReport report;
    ASSERT_TRUE(build_from_polygons(mesh, shape.polygons(), report));
    EXPECT_EQ(arrays_of(mesh), before) << shape.name;
  }
}

TEST(Build, TakesNoMoreMemoryThanTheLinksNeed) {
  for (const Shape& shape : {torus(40, 40), triangle_grid(40, 40), pinched(500)}) {
    const Mesh mesh = built(shape);
    const Links& links = mesh.links();
    for (const Array<Index>* array : {&links.next, &links.prev, &links.to_vertex, &links.face}) {
      EXPECT_EQ(array->capacity(), mesh.halfedge_count()) << shape.name;
    }
    EXPECT_EQ(links.vertex_halfedge.capacity(), mesh.vertex_count()) << shape.name;
    EXPECT_EQ(links.face_halfedge.capacity(), mesh.face_count()) << shape.name;
  }
}

TEST(Build, NumbersTheEdgesOfAVertexTogether) {
  const Mesh mesh = built(torus(9, 7));
  Index last = 0;
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e, 0);
    const Index smaller = std::min(mesh.from_vertex(h).index(), mesh.to_vertex(h).index());
    EXPECT_GE(smaller, last) << "edge " << e.index();
    last = smaller;
  }
}

TEST(Build, MakesTheMeshThatTheContractDescribesFromRandomPolygons) {
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const Shape shape = random_polygons(seed);
    const Mesh mesh = built(shape);
    expect_valid(mesh, shape.name);
    expect_same(mesh, reference_build(shape), shape.name);
  }
}

// Fans around a hub whose number is the smallest, the largest or any, each of them open or closed,
// of sizes around the one from which edges are found by hashing.
TEST(Build, MakesTheMeshThatTheContractDescribesAroundVerticesOfHighValence) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const Index valence = Index(12 + random() % 40);
    const Shape whole = disk(valence);
    std::vector<std::vector<Index>> faces;
    for (const std::vector<Index>& face : whole.faces) {
      if (seed % 3 == 0 || random() % 8 != 0) faces.push_back(face);
    }
    if (seed % 2 == 0) {  // a second hub, below
      const std::vector<std::vector<Index>> above = faces;
      for (std::vector<Index> face : above) {
        std::swap(face[1], face[2]);
        face[0] = valence + 1;
        faces.push_back(std::move(face));
      }
    }
    std::vector<Index> number(valence + 2);
    std::iota(number.begin(), number.end(), 0U);
    if (seed % 4 >= 2) std::shuffle(number.begin(), number.end(), random);
    if (seed % 4 == 1) std::swap(number.front(), number.back());
    for (std::vector<Index>& face : faces) {
      for (Index& v : face) v = number[v];
    }
    std::shuffle(faces.begin(), faces.end(), random);
    const Shape shape{"hubs, seed " + std::to_string(seed), valence + 2, std::move(faces)};
    const Mesh mesh = built(shape);
    expect_valid(mesh, shape.name);
    expect_same(mesh, reference_build(shape), shape.name);
  }
}

// Walks around vertices of high valence go on together, some at a time: these are more, and of very
// different lengths.
TEST(Build, FindsTheVertexOfTwoClosedFansAmongManyOfHighValence) {
  std::mt19937 random(1);
  std::vector<Index> hubs;
  std::vector<std::vector<Index>> faces;
  Index vertices = 0;
  for (int i = 0; i < 30; ++i) {
    const Index valence = Index(40 + random() % 300);
    const Shape one = i % 3 == 0 ? bipyramid(valence) : pyramid(valence);
    hubs.push_back(vertices);
    for (std::vector<Index> face : one.faces) {
      for (Index& v : face) v += vertices;
      faces.push_back(std::move(face));
    }
    vertices += one.vertices;
  }
  expect_valid(built({"hubs", vertices, faces}), "hubs");
  for (std::size_t i = 0; i + 1 < hubs.size(); ++i) {
    std::vector<std::vector<Index>> joined = faces;
    for (std::vector<Index>& face : joined)
      std::replace(face.begin(), face.end(), hubs[i + 1], hubs[i]);
    const Shape shape{"two hubs in one", vertices, joined};
    Mesh mesh;
    BuildReport report;
    ASSERT_FALSE(build_from_polygons(mesh, shape.polygons(), report));
    EXPECT_EQ(report.problems[0].code, "pinched-vertex");
    EXPECT_EQ(report.problems[0].witness.vertices, std::vector<Index>{hubs[i]});
  }
}

TEST(Build, MakesRoomForMeshesThatAreAllBoundary) {
  const Shape shape = loose_triangles(5000);
  const Mesh mesh = built(shape);
  EXPECT_EQ(mesh.halfedge_count(), 30'000U);
  expect_valid(mesh, shape.name);
  expect_same(mesh, reference_build(shape), shape.name);
}

// Compares everything that may not depend on the order of faces: not the anchors of interior
// vertices, which are those of the last face.
TEST(Build, DoesNotDependOnTheOrderOfFaces) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const Shape shape = random_polygons(seed);
    const Mesh mesh = built(shape);
    const Canonical expected(mesh);

    std::vector<Index> order(shape.faces.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    std::vector<std::vector<Index>> faces;
    for (const Index f : order) faces.push_back(shape.faces[f]);
    const Mesh reordered = built({shape.name, shape.vertices, faces});
    const Canonical actual(reordered);

    ASSERT_EQ(actual.sides.size(), expected.sides.size()) << shape.name;
    for (std::size_t i = 0; i < actual.sides.size(); ++i) {
      Canonical::Side side = actual.sides[i];
      if (side.face != kNone) side.face = order[side.face];
      EXPECT_EQ(side, expected.sides[i]) << shape.name;
    }
    for (const Vertex v : mesh.vertices()) {
      if (!mesh.is_boundary(v)) continue;
      EXPECT_EQ(actual.anchors[v.index()], expected.anchors[v.index()]) << shape.name;
    }
    for (std::size_t f = 0; f < order.size(); ++f) {
      EXPECT_EQ(actual.firsts[f], expected.firsts[order[f]]) << shape.name;
    }
  }
}

}  // namespace
}  // namespace halfedge::test
