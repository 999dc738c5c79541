// Conversions between Directed Edges and meshes that no builder has made.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/directed_edges/convert.h>
#include <halfedge/directed_edges/validate.h>

#include <random>
#include <vector>

#include "support/directed_edges.h"

namespace halfedge::test {
namespace {

TEST(DirectedEdgesConvert, KeepsAnchorsAndFirstHalfedges) {
  Mesh full;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(full, triangulated(torus(4, 4)).polygons(), report));
  for (const Vertex v : full.vertices()) {
    full.set_vertex_halfedge(v, full.rotate_cw(full.vertex_halfedge(v)));
  }
  for (const Face f : full.faces()) full.set_face_halfedge(f, full.prev(full.face_halfedge(f)));
  DirectedEdgesMesh compact;
  ASSERT_TRUE(from_mesh(full, compact));
  expect_same(compact, full);
  Mesh back;
  ASSERT_TRUE(to_mesh(compact, back));
  expect_same(compact, back);
}

TEST(DirectedEdgesConvert, TakesAMeshWithoutPrev) {
  const Shape shape = in_random_order(triangle_grid(5, 4));
  BasicMesh<kWithoutPrev> without;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(without, shape.polygons(), report));
  DirectedEdgesMesh compact;
  ASSERT_TRUE(from_mesh(without, compact));
  expect_same_links(compact, built(shape));
}

TEST(DirectedEdgesConvert, RefusesAMeshWithDeletedItems) {
  Mesh full;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(full, with_isolated_vertices().polygons(), report));
  full.release(Vertex(3));
  DirectedEdgesMesh compact;
  const Result<void> result = from_mesh(full, compact);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, "deleted-item");
  EXPECT_EQ(result.error().message,
            "Vertex 3 is deleted; Directed Edges have no deleted items: compact the mesh first.");
}

TEST(DirectedEdgesConvert, OfCorruptMeshesEndsInAnErrorOrAMesh) {
  int errors = 0;
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    std::mt19937 random(seed);
    Mesh full;
    BuildReport report;
    ASSERT_TRUE(build_from_polygons(full, triangle_grid(2, 2).polygons(), report));
    Links& links = full.mutable_links();
    const std::vector<Array<Index>*> arrays = {
        &links.next,         &links.prev, &links.to_vertex, &links.face, &links.vertex_halfedge,
        &links.face_halfedge};
    for (int i = 0; i < 2; ++i) {
      Array<Index>& array = *arrays[random() % arrays.size()];
      array[random() % array.size()] = random() % 4 == 0 ? Index(random()) : Index(random() % 40);
    }
    DirectedEdgesMesh compact;
    const Result<void> result = from_mesh(full, compact);
    errors += result ? 0 : 1;
    (void)validate(compact);
  }
  EXPECT_GT(errors, 1000);
}

}  // namespace
}  // namespace halfedge::test
