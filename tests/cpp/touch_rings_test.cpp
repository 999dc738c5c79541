#include <gtest/gtest.h>
#include <halfedge/algorithms/touch_rings.h>
#include <halfedge/build/build.h>
#include <halfedge/mesh.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge {
namespace {

using test::reference_build;

constexpr Ring kAroundVertices[] = {Ring::kVertexVertices, Ring::kVertexOutgoing,
                                    Ring::kVertexIncoming, Ring::kVertexEdges, Ring::kVertexFaces};
constexpr Ring kAroundFaces[] = {Ring::kFaceVertices, Ring::kFaceHalfedges, Ring::kFaceEdges,
                                 Ring::kFaceFaces};
constexpr Ring kAroundEdges[] = {Ring::kEdgeVertices, Ring::kEdgeHalfedges, Ring::kEdgeFaces};
constexpr Direction kBoth[] = {Direction::kCcw, Direction::kCw};

// Edges grouped by vertex, as all meshes but those of tests have them.
Mesh built(const test::Shape& shape) {
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, shape.polygons(), report));
  return mesh;
}

std::vector<RingLayout> layouts_of(const Mesh& mesh) {
  std::vector<RingLayout> layouts;
  for (const Direction direction : kBoth) {
    for (const Ring ring : kAroundVertices) {
      layouts.push_back(layout_of(RawLinks(mesh), ring, direction));
    }
    for (const Ring ring : kAroundFaces) {
      layouts.push_back(layout_of(RawLinks(mesh), ring, direction));
    }
  }
  return layouts;
}

template <class Range>
std::vector<Index> collect(const Range& range) {
  std::vector<Index> list;
  for (const Halfedge h : range) list.push_back(h.index());
  return list;
}

// The lap that begins at the stored halfedge itself.
std::vector<Index> lap(const RingLayout& rings, Index centre) {
  std::vector<Index> list;
  Index h = rings.firsts[centre];
  do {
    list.push_back(h);
    h = rings.steps[h ^ rings.before] ^ rings.after;
  } while (h != rings.firsts[centre]);
  return list;
}

// The circulators that begin one step on from it end there.
std::vector<Index> from_its_end(std::vector<Index> list) {
  list.insert(list.begin(), list.back());
  list.pop_back();
  return list;
}

TEST(TouchRings, WalksAsTheCirculatorsDo) {
  const Mesh mesh = reference_build(test::mixed_polygons());
  const RawLinks links(mesh);
  for (const Vertex v : mesh.vertices()) {
    for (const Ring ring : kAroundVertices) {
      EXPECT_EQ(lap(layout_of(links, ring, Direction::kCw), v.index()),
                collect(mesh.outgoing_cw(v)));
      EXPECT_EQ(lap(layout_of(links, ring, Direction::kCcw), v.index()),
                from_its_end(collect(mesh.outgoing_ccw(v))));
    }
  }
  for (const Face f : mesh.faces()) {
    for (const Ring ring : kAroundFaces) {
      EXPECT_EQ(lap(layout_of(links, ring, Direction::kCcw), f.index()),
                collect(mesh.face_halfedges_ccw(f)));
      EXPECT_EQ(lap(layout_of(links, ring, Direction::kCw), f.index()),
                from_its_end(collect(mesh.face_halfedges_cw(f))));
    }
  }
}

TEST(TouchRings, ReadsTheArrayOfWhatTheRingShows) {
  const Mesh mesh = reference_build(test::tetrahedron());
  const RawLinks links(mesh);
  for (const Direction direction : kBoth) {
    for (const Ring ring : {Ring::kVertexVertices, Ring::kFaceVertices}) {
      EXPECT_EQ(layout_of(links, ring, direction).items, mesh.links().to_vertex.data());
    }
    for (const Ring ring : {Ring::kVertexFaces, Ring::kFaceFaces}) {
      EXPECT_EQ(layout_of(links, ring, direction).items, mesh.links().face.data());
    }
    for (const Ring ring : {Ring::kVertexOutgoing, Ring::kVertexEdges, Ring::kFaceHalfedges}) {
      const RingLayout rings = layout_of(links, ring, direction);
      EXPECT_EQ(rings.items, rings.steps);
    }
  }
}

TEST(TouchRings, TellsAMeshInNoOrderFromOneInOrder) {
  const test::Shape grid = test::triangle_grid(200, 200);
  const Mesh in_order = built(grid);
  for (const RingLayout& rings : layouts_of(in_order)) EXPECT_FALSE(are_scattered(rings));
  const Mesh in_none = built(test::with_random_names(test::in_random_order(grid)));
  for (const RingLayout& rings : layouts_of(in_none)) EXPECT_TRUE(are_scattered(rings));
  for (const Ring ring : kAroundEdges) {
    EXPECT_FALSE(are_scattered(layout_of(RawLinks(in_none), ring, Direction::kCcw)));
  }
  const Mesh empty;
  for (const RingLayout& rings : layouts_of(empty)) EXPECT_FALSE(are_scattered(rings));
}

// Every 256th of its vertices lies at its left end, whose edges are numbered after all others.
TEST(TouchRings, DoesNotTakeTheBoundaryOfAGridForAllOfIt) {
  const Mesh mesh = built(test::triangle_grid(127, 127));
  ASSERT_EQ(mesh.vertex_count(), 64 * 256);
  for (const RingLayout& rings : layouts_of(mesh)) EXPECT_FALSE(are_scattered(rings));
}

// Under the sanitizers this fails if a word out of the arrays is read.
TEST(TouchRings, StaysWithinTheArraysWhateverTheseHold) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = reference_build(test::triangle_grid(9, 9));
    Links& links = mesh.mutable_links();
    const Index last = mesh.halfedge_slots() - 1;
    for (Array<Index>* array :
         {&links.next, &links.prev, &links.vertex_halfedge, &links.face_halfedge}) {
      for (Index& link : *array) {
        const Index wrong[] = {kNone, kDeleted, kDeleted - 1, last, last + 1, last + 2, link};
        if (random() % 4 == 0) link = wrong[random() % 7];
      }
    }
    for (const RingLayout& rings : layouts_of(mesh)) {
      for (Index i = 0; i < rings.centres; ++i) touch_rings(rings, i);
      (void)are_scattered(rings);
    }
  }
}

}  // namespace
}  // namespace halfedge
