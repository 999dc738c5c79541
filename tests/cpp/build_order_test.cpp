#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/build/order.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/reorder.h>
#include <halfedge/shapes/shapes.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support/large_torus.h"

// What a build finds out of the order of a mesh. It only decides how long a build takes, so that no
// other test could tell.

namespace halfedge::test {
namespace {

TEST(BuildOrder, TellsRowsOfTrianglesFromRandomOrder) {
  const Triangles torus = large_torus(300);
  EXPECT_TRUE(lie_in_rows(torus.polygons()));
  EXPECT_FALSE(lie_at_random(torus.polygons()));

  const Triangles mixed = shuffled(torus, 1);
  EXPECT_FALSE(lie_in_rows(mixed.polygons()));
  EXPECT_TRUE(lie_at_random(mixed.polygons()));
}

TEST(BuildOrder, FindsRowsOfQuadsAndAroundAHub) {
  const PolygonSoup quads = shapes::torus(300, 300, shapes::Faces::kQuads).value();
  EXPECT_TRUE(lie_in_rows(quads.view()));

  Triangles hub;
  const Index valence = 20'000;
  hub.positions.resize(3 * (valence + std::size_t{2}));
  for (Index i = 1; i <= valence; ++i) {
    const Index next = i % valence + 1;
    hub.corners.insert(hub.corners.end(), {0, i, next, valence + 1, next, i});
  }
  EXPECT_TRUE(lie_in_rows(hub.polygons()));
}

// Builds of these take longer if memory isn't asked for ahead.
TEST(BuildOrder, TellsRowsFromTheOrderOfACurve) {
  for (const Index size : {100U, 300U}) {
    const PolygonSoup torus = shapes::torus(size, size, shapes::Faces::kTriangles).value();
    Mesh mesh;
    BuildReport report;
    ASSERT_TRUE(build_from_polygons(mesh, torus.view(), report));
    ASSERT_TRUE(reorder(mesh).ok());
    std::vector<Index> corners;
    for (const Face f : mesh.faces()) {
      for (const Vertex v : mesh.face_vertices_ccw(f)) corners.push_back(v.index());
    }
    const Polygons along_curve{mesh.positions(), {}, corners};
    EXPECT_FALSE(lie_in_rows(along_curve)) << size;
    EXPECT_FALSE(lie_at_random(along_curve)) << size;
  }
}

// Every fourth 40 faces of the rows have changed places with others far away.
TEST(BuildOrder, TakesNoMeshForRowsWhoseFacesLieApartOftenEnough) {
  const Triangles torus = large_torus(300);
  Triangles apart{torus.positions, torus.corners};
  const std::size_t half = apart.corners.size() / 6 * 3;
  for (std::size_t corner = 0; corner + 120 <= half; corner += 480) {
    std::swap_ranges(&apart.corners[corner], &apart.corners[corner + 120],
                     &apart.corners[half + corner]);
  }
  EXPECT_FALSE(lie_in_rows(apart.polygons()));
  EXPECT_FALSE(lie_at_random(apart.polygons()));
}

TEST(BuildOrder, TakesFewFacesForRows) {
  for (const Index size : {0U, 3U, 6U, 99U}) {
    const std::vector<Index> corners(size);
    EXPECT_TRUE(lie_in_rows({{}, {}, corners}));
    EXPECT_FALSE(lie_at_random({{}, {}, corners}));
  }
}

}  // namespace
}  // namespace halfedge::test
