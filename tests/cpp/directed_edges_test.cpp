// Directed Edges against the full mesh: the same circulators and numbers, in 64 bytes a vertex.

#include "support/directed_edges.h"

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "support/data_files.h"
#include "support/random_polygons.h"

namespace halfedge::test {
namespace {

TEST(DirectedEdges, NumbersHalfedgesByTheirFacesAndTheBoundaryAfterThem) {
  const DirectedEdgesMesh mesh = built({"two triangles", 4, {{0, 1, 2}, {2, 1, 3}}});
  using Ends = std::pair<Index, Index>;
  const auto ends = [&](Index h) {
    return Ends(mesh.from_vertex(Halfedge(h)).index(), mesh.to_vertex(Halfedge(h)).index());
  };
  EXPECT_EQ(ends(0), Ends(2, 0));
  EXPECT_EQ(ends(1), Ends(0, 1));
  EXPECT_EQ(ends(2), Ends(1, 2));
  EXPECT_EQ(ends(3), Ends(3, 2));
  EXPECT_EQ(mesh.halfedge_count(), 10U);
  EXPECT_EQ(mesh.boundary_halfedge_count(), 4U);
  EXPECT_EQ(ends(6), Ends(0, 2));  // in the order of their opposites
  EXPECT_EQ(ends(7), Ends(1, 0));
  EXPECT_EQ(mesh.face(Halfedge(6)), Face{});
  EXPECT_EQ(mesh.face(Halfedge(5)), Face(1));
  EXPECT_EQ(mesh.prev(Halfedge(3)), Halfedge(5));
  EXPECT_EQ(mesh.next(Halfedge(5)), Halfedge(3));
  EXPECT_EQ(mesh.next(Halfedge(6)), mesh.find_halfedge(Vertex(2), Vertex(3)));
}

TEST(DirectedEdges, AnEdgeHasTheIndexOfItsSmallerHalfedge) {
  const DirectedEdgesMesh mesh = built({"two triangles", 4, {{0, 1, 2}, {2, 1, 3}}});
  std::vector<Index> edges;
  for (const Edge e : mesh.edges()) {
    edges.push_back(e.index());
    EXPECT_LT(mesh.edge_halfedge(e, 0), mesh.edge_halfedge(e, 1));
    EXPECT_EQ(mesh.edge(mesh.edge_halfedge(e, 0)), e);
    EXPECT_EQ(mesh.edge(mesh.edge_halfedge(e, 1)), e);
  }
  EXPECT_EQ(edges, (std::vector<Index>{0, 1, 2, 3, 5}));
  EXPECT_EQ(mesh.edge_count(), 5U);
  EXPECT_EQ(mesh.edge_slots(), 6U);
  EXPECT_TRUE(mesh.is_deleted(Edge(4)));
  EXPECT_FALSE(mesh.is_live(Edge(6)));
}

TEST(DirectedEdges, TakeSixtyFourBytesAVertexOnAClosedMesh) {
  const DirectedEdgesMesh mesh = built(in_random_order(triangulated(torus(40, 30))));
  const DirectedLinks& links = mesh.links();
  std::size_t bytes = mesh.positions().size_bytes();
  for (const Array<Index>* array : {&links.opposite, &links.to_vertex, &links.boundary_next,
                                    &links.boundary_prev, &links.vertex_halfedge}) {
    EXPECT_EQ(array->capacity(), array->size());
    bytes += array->capacity() * sizeof(Index);
  }
  EXPECT_EQ(bytes, 64U * mesh.vertex_count());
}

TEST(DirectedEdges, GiveTheSameAsTheFullMeshOnEveryShape) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_equivalent(triangulated(shape).polygons());
    expect_equivalent(in_random_order(triangulated(shape)).polygons());
  }
}

TEST(DirectedEdges, GiveTheSameAsTheFullMeshOnRandomTriangleMeshes) {
  int pinched_vertices = 0;
  int isolated_vertices = 0;
  for (std::uint32_t seed = 0; seed < 400 && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Shape shape = triangulated(random_polygons(seed));
    BuildReport report;
    Mesh full;
    // Cutting a face can run along an edge there is.
    if (!build_from_polygons(full, shape.polygons(), report)) continue;
    for (const Vertex v : full.vertices()) {
      pinched_vertices += full.is_manifold(v) ? 0 : 1;
      isolated_vertices += full.is_isolated(v) ? 1 : 0;
    }
    expect_equivalent(shape.polygons());
  }
  EXPECT_GT(pinched_vertices, 100);
  EXPECT_GT(isolated_vertices, 100);
}

TEST(DirectedEdges, GiveTheSameAsTheFullMeshOnTheCollection) {
  HALFEDGE_NEEDS_DATA();
  constexpr std::size_t kMaxFaces = 5000;  // or it takes minutes under the sanitizers
  std::size_t checked = 0;
  for (const auto& path : data_files("good", {".obj", ".off"})) {
    SCOPED_TRACE(path.filename());
    const Result<ParsedFile> file = parse_file(path);
    if (!file || file.value().soup.view().face_count() > kMaxFaces) continue;
    const Polygons polygons = file.value().soup.view();
    if (std::any_of(polygons.sizes.begin(), polygons.sizes.end(),
                    [](Index size) { return size != 3; })) {
      continue;
    }
    expect_equivalent(polygons);
    ++checked;
  }
  EXPECT_GE(checked, 20U);
}

TEST(DirectedEdges, GiveTheSameAsTheFullMeshAroundVerticesOfHighValence) {
  expect_equivalent(disk(1000).polygons());
  expect_equivalent(in_random_order(disk(1000)).polygons());
  expect_equivalent(in_random_order(bipyramid(1000)).polygons());
  expect_equivalent(in_random_order(pinched(500)).polygons());
}

}  // namespace
}  // namespace halfedge::test
