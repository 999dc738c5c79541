// What each operation of the decorator makes, exactly, and what it refuses.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/decorator/decorator.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "support/complexes.h"

namespace halfedge::test {
namespace {

using namespace decorator;
using Corners = std::vector<Index>;

Halfedge between(const Mesh& mesh, Index from, Index to) {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  EXPECT_TRUE(h.valid()) << from << " -> " << to;
  return h;
}

// The corners of each face, each list beginning with its smallest; sorted.
std::vector<Corners> faces_of(const Mesh& mesh) {
  std::vector<Corners> faces;
  for (const Face f : mesh.faces()) {
    Corners corners = corners_of(mesh, mesh.face_halfedge(f));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.push_back(corners);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<Corners> edges_of(const Mesh& mesh) {
  std::vector<Corners> edges;
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e);
    edges.push_back({mesh.from_vertex(h).index(), mesh.to_vertex(h).index()});
    std::sort(edges.back().begin(), edges.back().end());
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

TEST(DecoratorLoop, IsOneVertexTwoHalfedgesTwoFaces) {
  Mesh mesh;
  const Halfedge h = make_loop(mesh).value();
  const Halfedge o = mesh.opposite(h);
  EXPECT_EQ(mesh.vertex_count(), 1U);
  EXPECT_EQ(mesh.halfedge_count(), 2U);
  EXPECT_EQ(mesh.face_count(), 2U);
  for (const Halfedge side : {h, o}) {
    EXPECT_EQ(mesh.next(side), side);
    EXPECT_EQ(mesh.prev(side), side);
    EXPECT_EQ(mesh.to_vertex(side), Vertex(0));
    EXPECT_EQ(mesh.face_halfedge(mesh.face(side)), side);
  }
  EXPECT_NE(mesh.face(h), mesh.face(o));
  EXPECT_EQ(mesh.vertex_halfedge(Vertex(0)), h);
  EXPECT_EQ(mesh.valence(Vertex(0)), 2U);
  EXPECT_EQ(mesh.position(Vertex(0)), Point{});
  expect_valid_complex(mesh);
  EXPECT_TRUE(has_errors(validate(mesh, 4)));
  EXPECT_EQ(genus(mesh).value(), 0);
}

TEST(DecoratorSegment, IsTwoVerticesTwoHalfedgesOneFace) {
  Mesh mesh;
  const Halfedge h = make_segment(mesh).value();
  const Halfedge o = mesh.opposite(h);
  EXPECT_EQ(mesh.vertex_count(), 2U);
  EXPECT_EQ(mesh.halfedge_count(), 2U);
  EXPECT_EQ(mesh.face_count(), 1U);
  EXPECT_EQ(mesh.next(h), o);
  EXPECT_EQ(mesh.next(o), h);
  EXPECT_EQ(mesh.prev(h), o);
  EXPECT_EQ(mesh.face(h), mesh.face(o));
  EXPECT_NE(mesh.to_vertex(h), mesh.to_vertex(o));
  EXPECT_EQ(mesh.vertex_halfedge(mesh.from_vertex(h)), h);
  EXPECT_EQ(mesh.vertex_halfedge(mesh.to_vertex(h)), o);
  expect_valid_complex(mesh);
  EXPECT_TRUE(has_errors(validate(mesh, 4)));
  EXPECT_EQ(genus(mesh).value(), 0);
}

TEST(DecoratorFace, SplitsAQuadAlongItsDiagonal) {
  Mesh mesh = reference_build(quad_grid(1, 1));  // 0 1 3 2
  const Halfedge h = between(mesh, 0, 1);
  const Halfedge g = between(mesh, 3, 2);
  const Face f = mesh.face(h);
  const Halfedge d = split_face(mesh, h, g).value();
  EXPECT_EQ(mesh.from_vertex(d), Vertex(1));
  EXPECT_EQ(mesh.to_vertex(d), Vertex(2));
  EXPECT_EQ(mesh.next(h), d);
  EXPECT_EQ(mesh.next(g), mesh.opposite(d));
  EXPECT_EQ(mesh.face(d), f);
  EXPECT_EQ(faces_of(mesh), (std::vector<Corners>{{0, 1, 2}, {1, 3, 2}}));
  expect_valid_complex(mesh);

  EXPECT_EQ(join_face(mesh, d).value(), h);
  EXPECT_EQ(faces_of(mesh), (std::vector<Corners>{{0, 1, 3, 2}}));
  expect_valid_complex(mesh);
}

TEST(DecoratorFace, SplitsOffALoopAndAFaceOfTwoCorners) {
  Mesh mesh = reference_build(tetrahedron());
  const Halfedge h = between(mesh, 0, 1);
  const Halfedge d = split_face(mesh, h, h).value();
  EXPECT_EQ(mesh.next(mesh.opposite(d)), mesh.opposite(d));
  EXPECT_EQ(corners_of(mesh, h), (Corners{1, 1, 2, 0}));
  expect_valid_complex(mesh);
  const Halfedge bridge = split_face(mesh, h, d).value();
  EXPECT_EQ(corners_of(mesh, mesh.opposite(bridge)).size(), 2U);
  expect_valid_complex(mesh);
  EXPECT_EQ(join_face(mesh, bridge).value(), h);
  // The loop's own face, asked for from inside, takes over its neighbour.
  const Face inner = mesh.face(mesh.opposite(d));
  EXPECT_EQ(join_face(mesh, mesh.opposite(d)).value(), h);
  EXPECT_EQ(mesh.face(h), inner);
  EXPECT_EQ(mesh.face_count(), 4U);
  expect_valid_complex(mesh);
}

TEST(DecoratorFace, JoinsWithAHoleOnEitherSide) {
  Mesh mesh = reference_build(tetrahedron());
  const Halfedge h = between(mesh, 0, 1);
  ASSERT_TRUE(make_hole(mesh, h).ok());
  Mesh filled = copy_of(mesh);
  // The hole grows over the edge, by the face behind it.
  ASSERT_TRUE(join_face(mesh, h).ok());
  EXPECT_EQ(faces_of(mesh), (std::vector<Corners>{{0, 2, 3}, {1, 3, 2}}));
  for (Index v = 0; v < 4; ++v) EXPECT_TRUE(mesh.is_boundary(Vertex(v)));
  expect_valid_complex(mesh);
  // The face behind the edge grows over the hole.
  ASSERT_TRUE(join_face(filled, filled.opposite(h)).ok());
  EXPECT_EQ(faces_of(filled), (std::vector<Corners>{{0, 2, 3}, {0, 3, 1, 2}, {1, 3, 2}}));
  EXPECT_TRUE(is_closed(filled));
  for (Index v = 0; v < 4; ++v) EXPECT_FALSE(filled.is_boundary(Vertex(v)));
  expect_valid_complex(filled);
}

TEST(DecoratorFace, SaysWhyItCannotSplit) {
  Mesh mesh = reference_build(quad_grid(2, 1));
  const Snapshot before(mesh);
  const Halfedge h = between(mesh, 0, 1);
  const Halfedge boundary = between(mesh, 1, 0);
  expect_refused(split_face(mesh, h, boundary), "boundary-halfedge", mesh, before);
  expect_refused(split_face(mesh, h, between(mesh, 1, 2)), "different-loops", mesh, before);
  expect_refused(split_face(mesh, Halfedge{}, h), "not-a-halfedge", mesh, before);
  expect_refused(split_face(mesh, h, Halfedge(99)), "not-a-halfedge", mesh, before);
  EXPECT_EQ(split_face(mesh, h, Halfedge(99)).error().message,
            "Halfedge 99 is not in this mesh, expected an index below 14.");
  EXPECT_EQ(split_face(mesh, h, boundary).error().witness.halfedges, Corners{boundary.index()});
}

TEST(DecoratorFace, SaysWhyItCannotJoin) {
  Mesh grid = reference_build(quad_grid(2, 1));
  const Snapshot before(grid);
  // The outer side of a face with other boundary edges: these would have no face at all.
  const Halfedge outside = between(grid, 1, 0);
  expect_refused(join_face(grid, outside), "edge-without-face", grid, before);
  EXPECT_EQ(join_face(grid, outside).error().witness.edges.size(), 1U);

  Mesh loop = loop_complex();
  expect_refused(join_face(loop, Halfedge(0)), "last-edge", loop, Snapshot(loop));
  Mesh segment = segment_complex();
  expect_refused(join_face(segment, Halfedge(0)), "same-loop", segment, Snapshot(segment));
  expect_refused(join_face(segment, Halfedge(7)), "not-a-halfedge", segment, Snapshot(segment));
}

TEST(DecoratorHole, OpensAndFillsAFace) {
  Mesh mesh = reference_build(cube());
  const Halfedge h = between(mesh, 4, 5);
  const LiveItems closed(mesh);
  EXPECT_EQ(make_hole(mesh, h).value(), h);
  EXPECT_EQ(mesh.face_count(), 5U);
  EXPECT_EQ(mesh.edge_count(), 12U);
  EXPECT_EQ(boundary_loops(mesh).value().size(), 1U);
  for (const Index v : {4U, 5U, 6U, 7U}) EXPECT_TRUE(mesh.is_boundary(Vertex(v)));
  for (const Index v : {0U, 1U, 2U, 3U}) EXPECT_FALSE(mesh.is_boundary(Vertex(v)));
  expect_valid_complex(mesh);

  const Snapshot open(mesh);
  expect_refused(make_hole(mesh, h), "boundary-halfedge", mesh, open);
  expect_refused(make_hole(mesh, between(mesh, 0, 1)), "edge-without-face", mesh, open);
  expect_refused(fill_hole(mesh, mesh.opposite(h)), "not-a-boundary-halfedge", mesh, open);
  expect_refused(fill_hole(mesh, Halfedge(99)), "not-a-halfedge", mesh, open);

  EXPECT_EQ(fill_hole(mesh, h).value(), h);
  EXPECT_TRUE(LiveItems(mesh) == closed);
  for (const Vertex v : mesh.vertices()) EXPECT_FALSE(mesh.is_boundary(v));
  expect_valid_complex(mesh);

  Mesh segment = segment_complex();  // its face has the edge on both sides
  expect_refused(make_hole(segment, Halfedge(0)), "edge-without-face", segment, Snapshot(segment));
}

TEST(DecoratorHole, FillsOneOfTwoHolesThatTouch) {
  Mesh mesh = reference_build(pinched(3));
  ASSERT_EQ(boundary_loops(mesh).value().size(), 1U);
  Mesh torus_with_holes = reference_build(torus(4, 4));
  // Faces 0 and 5 share one vertex.
  const Halfedge h = torus_with_holes.face_halfedge(Face(0));
  const Halfedge g = torus_with_holes.face_halfedge(Face(5));
  ASSERT_TRUE(make_hole(torus_with_holes, h).ok());
  ASSERT_TRUE(make_hole(torus_with_holes, g).ok());
  expect_valid_complex(torus_with_holes);
  ASSERT_TRUE(fill_hole(torus_with_holes, h).ok());
  expect_valid_complex(torus_with_holes);  // the anchor of the shared vertex is on the other hole
  ASSERT_TRUE(fill_hole(torus_with_holes, g).ok());
  expect_valid_complex(torus_with_holes);
}

TEST(DecoratorVertex, SplitsAndJoins) {
  Mesh mesh = reference_build(disk(6));
  mesh.set_position(Vertex(0), {1, 2, 3});
  // Clockwise after 1 -> 0 the edges to 6, 5 and 4 come.
  const Halfedge h = between(mesh, 1, 0);
  const Halfedge g = between(mesh, 4, 0);
  const Halfedge d = split_vertex(mesh, h, g).value();
  EXPECT_EQ(mesh.from_vertex(d), Vertex(7));
  EXPECT_EQ(mesh.to_vertex(d), Vertex(0));
  EXPECT_EQ(mesh.next(h), mesh.opposite(d));
  EXPECT_EQ(mesh.next(g), d);
  EXPECT_EQ(mesh.position(Vertex(7)), (Point{1, 2, 3}));
  EXPECT_EQ(faces_of(mesh),
            (std::vector<Corners>{
                {0, 1, 2}, {0, 2, 3}, {0, 3, 4, 7}, {0, 7, 6, 1}, {4, 5, 7}, {5, 6, 7}}));
  expect_valid_complex(mesh);
  EXPECT_EQ(join_vertex(mesh, d).value(), h);
  EXPECT_EQ(mesh.valence(Vertex(0)), 6U);
  expect_valid_complex(mesh);
}

TEST(DecoratorVertex, JoinsTwoVerticesOfTheBoundaryAcrossAnInnerEdge) {
  Mesh mesh = reference_build(quad_grid(2, 1));
  ASSERT_TRUE(join_vertex(mesh, between(mesh, 1, 4)).ok());
  EXPECT_EQ(faces_of(mesh), (std::vector<Corners>{{0, 4, 3}, {2, 5, 4}}));
  EXPECT_FALSE(mesh.is_manifold(Vertex(4)));
  EXPECT_TRUE(mesh.is_boundary(Vertex(4)));
  EXPECT_FALSE(mesh.is_live(Vertex(1)));
  expect_valid_complex(mesh);
}

TEST(DecoratorVertex, SaysWhyItCannotSplitOrJoin) {
  Mesh mesh = reference_build(quad_grid(2, 1));
  const Snapshot before(mesh);
  const Halfedge out = between(mesh, 1, 0);
  expect_refused(split_vertex(mesh, out, between(mesh, 4, 1)), "different-vertices", mesh, before);
  expect_refused(split_vertex(mesh, out, out), "edge-without-face", mesh, before);
  expect_refused(insert_tip(mesh, out), "edge-without-face", mesh, before);
  expect_refused(split_vertex(mesh, out, Halfedge(14)), "not-a-halfedge", mesh, before);
  expect_refused(join_vertex(mesh, Halfedge{}), "not-a-halfedge", mesh, before);
  Mesh loop = loop_complex();
  expect_refused(join_vertex(loop, Halfedge(1)), "loop-edge", loop, Snapshot(loop));
  Mesh segment = segment_complex();
  expect_refused(join_vertex(segment, Halfedge(1)), "last-edge", segment, Snapshot(segment));
}

TEST(DecoratorEdge, SplitsAndJoins) {
  Mesh mesh = reference_build(quad_grid(1, 1));
  mesh.set_position(Vertex(0), {1, 0, 4});
  mesh.set_position(Vertex(1), {2, 1, 0});
  const LiveItems before(mesh);
  const Halfedge h = between(mesh, 0, 1);
  const Halfedge k = split_edge(mesh, h).value();
  EXPECT_EQ(mesh.next(k), h);
  EXPECT_EQ(mesh.to_vertex(k), Vertex(4));
  EXPECT_EQ(mesh.valence(Vertex(4)), 2U);
  EXPECT_EQ(mesh.position(Vertex(4)), (Point{1.5F, 0.5F, 2}));
  EXPECT_TRUE(mesh.is_boundary(Vertex(4)));
  EXPECT_EQ(faces_of(mesh), (std::vector<Corners>{{0, 4, 1, 3, 2}}));
  EXPECT_EQ(edges_of(mesh), (std::vector<Corners>{{0, 2}, {0, 4}, {1, 3}, {1, 4}, {2, 3}}));
  expect_valid_complex(mesh);
  EXPECT_EQ(join_edge(mesh, k).value(), h);
  EXPECT_TRUE(LiveItems(mesh) == before);
  expect_valid_complex(mesh);
  // The same, seen from the boundary.
  const Halfedge outside = split_edge(mesh, mesh.opposite(h)).value();
  EXPECT_TRUE(mesh.is_boundary(Vertex(4)));
  expect_valid_complex(mesh);
  EXPECT_EQ(join_edge(mesh, outside).value(), mesh.opposite(h));
  EXPECT_TRUE(LiveItems(mesh) == before);
}

TEST(DecoratorEdge, SplitsALoopAndASegmentAtBothEnds) {
  Mesh loop = loop_complex();
  const Halfedge k = split_edge(loop, Halfedge(0)).value();
  EXPECT_EQ(corners_of(loop, k), (Corners{1, 0}));
  EXPECT_EQ(corners_of(loop, loop.opposite(k)), (Corners{0, 1}));
  expect_valid_complex(loop);
  EXPECT_EQ(join_edge(loop, k).value(), Halfedge(0));
  EXPECT_TRUE(LiveItems(loop) == LiveItems(loop_complex()));

  for (const Index h : {0U, 1U}) {
    Mesh segment = segment_complex();
    const Vertex from = segment.from_vertex(Halfedge(h));
    const Halfedge first = split_edge(segment, Halfedge(h)).value();
    EXPECT_EQ(segment.from_vertex(first), from);
    EXPECT_EQ(segment.next(first), Halfedge(h));
    EXPECT_EQ(segment.valence(from), 1U);
    EXPECT_EQ(segment.valence(Vertex(2)), 2U);
    expect_valid_complex(segment);
    EXPECT_EQ(join_edge(segment, first).value(), Halfedge(h));
    EXPECT_TRUE(LiveItems(segment) == LiveItems(segment_complex()));
  }
}

TEST(DecoratorEdge, SaysWhyItCannotJoin) {
  Mesh mesh = reference_build(quad_grid(2, 1));
  const Snapshot before(mesh);
  expect_refused(join_edge(mesh, between(mesh, 0, 1)), "not-valence-two", mesh, before);
  EXPECT_EQ(join_edge(mesh, between(mesh, 0, 1)).error().message,
            "Vertex 1 has valence 3, expected 2.");
  expect_refused(join_edge(mesh, Halfedge(14)), "not-a-halfedge", mesh, before);
  expect_refused(split_edge(mesh, Halfedge(14)), "not-a-halfedge", mesh, before);
  Mesh segment = segment_complex();
  expect_refused(join_edge(segment, Halfedge(0)), "not-valence-two", segment, Snapshot(segment));
  Mesh loop = loop_complex();
  expect_refused(join_edge(loop, Halfedge(0)), "loop-edge", loop, Snapshot(loop));
}

TEST(DecoratorTip, IsInsertedAndErased) {
  Mesh mesh = reference_build(tetrahedron());
  const LiveItems before(mesh);
  const Halfedge h = between(mesh, 0, 1);
  const Halfedge tip = insert_tip(mesh, h).value();
  EXPECT_EQ(mesh.next(h), tip);
  EXPECT_EQ(mesh.next(tip), mesh.opposite(tip));
  EXPECT_EQ(mesh.from_vertex(tip), Vertex(1));
  EXPECT_EQ(mesh.to_vertex(tip), Vertex(4));
  EXPECT_EQ(mesh.position(Vertex(4)), mesh.position(Vertex(1)));
  EXPECT_EQ(corners_of(mesh, h), (Corners{1, 4, 1, 2, 0}));
  expect_valid_complex(mesh);

  const Snapshot with_tip(mesh);
  expect_refused(erase_tip(mesh, h), "not-a-tip", mesh, with_tip);
  expect_refused(erase_tip(mesh, Halfedge(99)), "not-a-halfedge", mesh, with_tip);
  Mesh other = copy_of(mesh);
  EXPECT_EQ(erase_tip(mesh, tip).value(), h);
  EXPECT_TRUE(LiveItems(mesh) == before);
  expect_valid_complex(mesh);
  // Contracted the other way, the end takes the place of the vertex it hung on.
  EXPECT_EQ(join_vertex(other, tip).value(), h);
  EXPECT_EQ(corners_of(other, h), (Corners{4, 2, 0}));
  expect_valid_complex(other);

  Mesh segment = segment_complex();
  expect_refused(erase_tip(segment, Halfedge(0)), "last-edge", segment, Snapshot(segment));
}

TEST(DecoratorFlip, TurnsTheDiagonalCounterClockwise) {
  const Shape square{"square", 4, {{0, 1, 2}, {0, 2, 3}}};
  Mesh mesh = reference_build(square);
  const LiveItems before(mesh);
  const Halfedge h = between(mesh, 0, 2);
  EXPECT_EQ(flip_edge(mesh, h).value(), h);
  EXPECT_EQ(mesh.from_vertex(h), Vertex(1));
  EXPECT_EQ(mesh.to_vertex(h), Vertex(3));
  EXPECT_EQ(faces_of(mesh), (std::vector<Corners>{{0, 1, 3}, {1, 2, 3}}));
  expect_valid_complex(mesh);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(flip_edge(mesh, h).ok());
  EXPECT_TRUE(LiveItems(mesh) == before);
  expect_valid_complex(mesh);
}

TEST(DecoratorFlip, SaysWhyItCannot) {
  Mesh mesh = reference_build(mixed_polygons());
  const Snapshot before(mesh);
  expect_refused(flip_edge(mesh, between(mesh, 1, 6)), "boundary-halfedge", mesh, before);
  expect_refused(flip_edge(mesh, between(mesh, 6, 1)), "boundary-halfedge", mesh, before);
  expect_refused(flip_edge(mesh, between(mesh, 0, 2)), "not-a-triangle", mesh, before);
  expect_refused(flip_edge(mesh, between(mesh, 2, 0)), "not-a-triangle", mesh, before);
  EXPECT_NE(flip_edge(mesh, between(mesh, 2, 0)).error().message.find("degree 4, expected 3"),
            std::string::npos);
  expect_refused(flip_edge(mesh, Halfedge(999)), "not-a-halfedge", mesh, before);
  Mesh loop = loop_complex();
  expect_refused(flip_edge(loop, Halfedge(0)), "not-a-triangle", loop, Snapshot(loop));
  Mesh spike = loop_complex();  // its outer face is the loop, and an edge to and fro
  const Halfedge tip = insert_tip(spike, Halfedge(0)).value();
  ASSERT_EQ(corners_of(spike, tip).size(), 3U);
  expect_refused(flip_edge(spike, tip), "same-loop", spike, Snapshot(spike));
}

}  // namespace
}  // namespace halfedge::test
