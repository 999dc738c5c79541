// The operations of the decorator on whole faces, loops, boundaries and components.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/decorator/decorator.h>

#include <array>
#include <string>
#include <vector>

#include "support/complexes.h"
#include "support/random_polygons.h"

namespace halfedge::test {
namespace {

using namespace decorator;
using Corners = std::vector<Index>;
using Difference = std::vector<std::int64_t>;

Halfedge between(const Mesh& mesh, Index from, Index to) {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  EXPECT_TRUE(h.valid()) << from << " -> " << to;
  return h;
}

TEST(DecoratorCenter, MakesTrianglesAroundANewVertex) {
  Mesh mesh = reference_build(cube());
  const LiveItems before(mesh);
  const Halfedge h = between(mesh, 4, 5);
  for (const Index v : {4U, 5U, 6U, 7U}) mesh.set_position(Vertex(v), {float(v), 1, 2});
  const Face f = mesh.face(h);
  const Halfedge k = create_center_vertex(mesh, h).value();
  EXPECT_EQ(mesh.next(h), k);
  EXPECT_EQ(mesh.to_vertex(k), Vertex(8));
  EXPECT_EQ(mesh.face(k), f);
  EXPECT_EQ(mesh.position(Vertex(8)), (Point{5.5F, 1, 2}));
  EXPECT_EQ(mesh.valence(Vertex(8)), 4U);
  EXPECT_EQ(mesh.face_count(), 9U);
  for (const Face around : mesh.vertex_faces_ccw(Vertex(8))) EXPECT_EQ(mesh.degree(around), 3U);
  EXPECT_TRUE(validate(mesh).empty());
  expect_valid_complex(mesh);

  EXPECT_EQ(erase_center_vertex(mesh, k).value(), h);
  EXPECT_TRUE(LiveItems(mesh) == before);
  expect_valid_complex(mesh);
}

TEST(DecoratorCenter, IsTheSameInRoomThatIsThere) {
  // A triangle takes a shorter way there, unless history or free slots have to be looked after.
  for (const auto& [name, mesh] : all_complexes()) {
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.is_boundary(h)) continue;
      SCOPED_TRACE(name + ", halfedge " + std::to_string(h.index()));
      Mesh tight = copy_of(mesh);
      const Halfedge k = create_center_vertex(tight, h).value();

      Mesh roomy = copy_of(mesh);
      ASSERT_TRUE(
          roomy.reserve(mesh.vertex_slots() + 9, mesh.edge_slots() + 9, mesh.face_slots() + 9));
      const std::uint64_t version = roomy.version();
      EXPECT_EQ(create_center_vertex(roomy, h).value(), k);
      EXPECT_TRUE(Snapshot(roomy) == Snapshot(tight));
      EXPECT_NE(roomy.version(), version);

      Mesh noted = copy_of(roomy);
      ASSERT_TRUE(noted.enable_history());
      ASSERT_TRUE(erase_center_vertex(noted, k).ok());
      noted.end_step();
      EXPECT_EQ(create_center_vertex(noted, h).value(), k);  // in the slots that became free
      EXPECT_TRUE(LiveItems(noted) == LiveItems(tight));
      noted.end_step();
      ASSERT_TRUE(noted.undo() && noted.undo());
      EXPECT_TRUE(Snapshot(noted) == Snapshot(roomy));
    }
  }
}

TEST(DecoratorCenter, WorksInFacesOfOneAndTwoCorners) {
  Mesh loop = loop_complex();
  const Halfedge k = create_center_vertex(loop, Halfedge(0)).value();
  EXPECT_EQ(Counts(loop).since(Counts(loop_complex())), (Difference{1, 1, 0}));
  expect_valid_complex(loop);
  EXPECT_EQ(erase_center_vertex(loop, k).value(), Halfedge(0));
  EXPECT_TRUE(LiveItems(loop) == LiveItems(loop_complex()));

  Mesh segment = segment_complex();
  const Halfedge spoke = create_center_vertex(segment, Halfedge(0)).value();
  EXPECT_EQ(Counts(segment).since(Counts(segment_complex())), (Difference{1, 2, 1}));
  expect_valid_complex(segment);
  EXPECT_EQ(erase_center_vertex(segment, spoke).value(), Halfedge(0));
  EXPECT_TRUE(LiveItems(segment) == LiveItems(segment_complex()));
}

TEST(DecoratorCenter, ErasesAVertexWithTwoEdgesToOneNeighbour) {
  // Two spokes to the same corner have a face of two corners between them.
  Mesh mesh = reference_build(tetrahedron());
  const Halfedge h = between(mesh, 0, 3);
  const Halfedge d = split_face(mesh, mesh.prev(mesh.opposite(h)), mesh.opposite(h)).value();
  ASSERT_EQ(mesh.valence(Vertex(3)), 4U);
  for (const Halfedge spoke : {mesh.opposite(d), d, h}) {
    if (mesh.to_vertex(spoke) != Vertex(3)) continue;
    Mesh copy = copy_of(mesh);
    const Halfedge rim = erase_center_vertex(copy, spoke).value();
    EXPECT_EQ(corners_of(copy, rim).size(), 3U);
    EXPECT_EQ(copy.face_count(), 2U);
    EXPECT_EQ(copy.to_vertex(rim), Vertex(0));
    expect_valid_complex(copy);
  }
}

TEST(DecoratorCenter, SaysWhyItCannot) {
  Mesh mesh = reference_build(disk(5));
  const Snapshot before(mesh);
  expect_refused(create_center_vertex(mesh, between(mesh, 2, 1)), "boundary-halfedge", mesh,
                 before);
  expect_refused(create_center_vertex(mesh, Halfedge(77)), "not-a-halfedge", mesh, before);
  expect_refused(erase_center_vertex(mesh, between(mesh, 0, 1)), "boundary-vertex", mesh, before);
  expect_refused(erase_center_vertex(mesh, Halfedge(77)), "not-a-halfedge", mesh, before);
  Mesh loop = loop_complex();
  expect_refused(erase_center_vertex(loop, Halfedge(0)), "loop-edge", loop, Snapshot(loop));
  Mesh segment = segment_complex();
  expect_refused(erase_center_vertex(segment, Halfedge(0)), "last-edge", segment,
                 Snapshot(segment));
  ASSERT_TRUE(split_edge(segment, Halfedge(0)).ok());
  expect_refused(erase_center_vertex(segment, segment.prev(Halfedge(0))), "repeated-vertex",
                 segment, Snapshot(segment));
}

TEST(DecoratorSplitLoop, CutsATorusOpenIntoASphere) {
  Mesh mesh = reference_build(torus(3, 4));
  mesh.set_position(Vertex(1), {7, 8, 9});
  const LiveItems before(mesh);
  const Counts counts(mesh);
  ASSERT_EQ(counts.genus(), 1);
  const Halfedge h = between(mesh, 0, 1);
  const Halfedge i = between(mesh, 1, 2);
  const Halfedge j = between(mesh, 2, 0);
  const Halfedge returned = split_loop(mesh, h, i, j).value();
  EXPECT_EQ(Counts(mesh).since(counts), (Difference{3, 3, 2}));
  EXPECT_EQ(Counts(mesh).genus(), 0);
  EXPECT_EQ(mesh.next(h), i);
  EXPECT_EQ(mesh.next(i), j);
  EXPECT_EQ(mesh.next(j), h);
  EXPECT_EQ(corners_of(mesh, returned).size(), 3U);
  EXPECT_EQ(mesh.position(mesh.from_vertex(returned)), (Point{7, 8, 9}));
  EXPECT_TRUE(validate(mesh).empty());
  expect_valid_complex(mesh);

  EXPECT_EQ(join_loop(mesh, h, returned).value(), h);
  EXPECT_TRUE(LiveItems(mesh) == before);
  expect_valid_complex(mesh);
}

TEST(DecoratorSplitLoop, CutsASphereInTwoAlongTheSidesOfAFaceOrAnyCycle) {
  Mesh mesh = reference_build(cube());
  const Halfedge h = between(mesh, 4, 5);
  std::vector<Halfedge> face;
  for (const Halfedge on_loop : mesh.loop_ccw(h)) face.push_back(on_loop);
  const LiveItems before(mesh);
  const Halfedge returned = split_loop(mesh, face).value();
  EXPECT_EQ(Counts(mesh).components, 2);
  EXPECT_EQ(Counts(mesh).genus(), 0);
  expect_valid_complex(mesh);
  EXPECT_EQ(join_loop(mesh, h, returned).value(), h);
  EXPECT_TRUE(LiveItems(mesh) == before);

  // Around two faces.
  std::vector<Halfedge> cycle;
  const Corners corners = {4, 0, 1, 2, 6, 5};
  for (std::size_t i = 0; i < 6; ++i) {
    cycle.push_back(between(mesh, corners[i], corners[(i + 1) % 6]));
  }
  const Halfedge other = split_loop(mesh, cycle).value();
  EXPECT_EQ(Counts(mesh).components, 2);
  EXPECT_EQ(Counts(mesh).vertices, 14);
  expect_valid_complex(mesh);
  EXPECT_EQ(join_loop(mesh, cycle[0], other).value(), cycle[0]);
  EXPECT_TRUE(LiveItems(mesh) == before);
}

TEST(DecoratorSplitLoop, CutsAlongALoopEdgeAndAlongABoundary) {
  Mesh loop = loop_complex();
  const LiveItems before(loop);
  const std::array<Halfedge, 1> cycle = {Halfedge(0)};
  const Halfedge returned = split_loop(loop, cycle).value();
  EXPECT_EQ(Counts(loop).components, 2);
  expect_valid_complex(loop);
  ASSERT_TRUE(join_loop(loop, Halfedge(0), returned).ok());
  EXPECT_TRUE(LiveItems(loop) == before);

  // Along a boundary loop: the surface is closed, the loop goes to a face of its own.
  Mesh mesh = reference_build(triangle());
  const Halfedge h = between(mesh, 1, 0);
  const LiveItems open(mesh);
  const Halfedge closed = split_loop(mesh, h, mesh.next(h), mesh.prev(h)).value();
  EXPECT_FALSE(mesh.is_boundary(h));
  EXPECT_TRUE(mesh.is_boundary(mesh.opposite(closed)));
  EXPECT_EQ(Counts(mesh).components, 2);
  expect_valid_complex(mesh);
  ASSERT_TRUE(join_loop(mesh, h, closed).ok());
  EXPECT_TRUE(LiveItems(mesh) == open);
  expect_valid_complex(mesh);
}

TEST(DecoratorSplitLoop, SaysWhyItCannot) {
  Mesh mesh = reference_build(tetrahedron());
  const Snapshot before(mesh);
  const Halfedge h = between(mesh, 0, 1);
  const std::vector<Halfedge> none;
  expect_refused(split_loop(mesh, none), "not-a-cycle", mesh, before);
  expect_refused(split_loop(mesh, h, h, h), "not-a-cycle", mesh, before);
  expect_refused(split_loop(mesh, std::array{h, mesh.opposite(h)}), "not-a-cycle", mesh, before);
  expect_refused(split_loop(mesh, h, Halfedge(99), h), "not-a-halfedge", mesh, before);
  const std::vector<Halfedge> eight = {between(mesh, 0, 1), between(mesh, 1, 2),
                                       between(mesh, 2, 0), between(mesh, 0, 3),
                                       between(mesh, 3, 2), between(mesh, 2, 0)};
  expect_refused(split_loop(mesh, eight), "repeated-vertex", mesh, before);
}

TEST(DecoratorJoinLoop, JoinsTwoSpheresAndAddsAHandle) {
  Mesh mesh = reference_build(two_tori());
  const Counts before(mesh);
  ASSERT_EQ(before.genus(), 2);
  // Any halfedge of the second loop may come to lie on h.
  const Halfedge h = mesh.face_halfedge(Face(5));
  const Halfedge g = mesh.next(mesh.face_halfedge(Face(20)));
  const Vertex from = mesh.from_vertex(h);
  EXPECT_EQ(join_loop(mesh, h, g).value(), h);
  EXPECT_EQ(Counts(mesh).since(before), (Difference{-4, -4, -2}));
  EXPECT_EQ(Counts(mesh).components, 1);
  EXPECT_EQ(Counts(mesh).genus(), 2);
  EXPECT_EQ(mesh.from_vertex(h), from);
  EXPECT_EQ(mesh.valence(from), 6U);
  EXPECT_FALSE(mesh.is_live(Face(5)));
  EXPECT_FALSE(mesh.is_live(Face(20)));
  expect_valid_complex(mesh);
  // Two faces of the one component.
  Mesh grid = reference_build(torus(6, 6));
  ASSERT_TRUE(join_loop(grid, grid.face_halfedge(Face(0)), grid.face_halfedge(Face(21))).ok());
  EXPECT_EQ(Counts(grid).genus(), 2);
  EXPECT_TRUE(validate(grid).empty());
  expect_valid_complex(grid);
}

TEST(DecoratorJoinLoop, GluesBoundaryLoops) {
  // A tube of squares, open at both ends, becomes a torus.
  Mesh mesh = reference_build(torus(4, 5));
  std::vector<Halfedge> cycle = {between(mesh, 0, 1), between(mesh, 1, 2), between(mesh, 2, 3),
                                 between(mesh, 3, 0)};
  const Halfedge other = split_loop(mesh, cycle).value();
  ASSERT_TRUE(make_hole(mesh, cycle[0]).ok());
  ASSERT_TRUE(make_hole(mesh, other).ok());
  ASSERT_EQ(boundary_loops(mesh).value().size(), 2U);
  ASSERT_TRUE(join_loop(mesh, cycle[0], other).ok());
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(genus(mesh).value(), 1);
  expect_valid_complex(mesh);
}

TEST(DecoratorJoinLoop, SaysWhyItCannot) {
  Mesh mesh = reference_build(two_components());  // a tetrahedron and a triangle
  const Snapshot before(mesh);
  const Halfedge h = between(mesh, 0, 1);
  const Halfedge g = between(mesh, 4, 5);
  expect_refused(join_loop(mesh, h, mesh.next(h)), "same-loop", mesh, before);
  expect_refused(join_loop(mesh, h, mesh.opposite(h)), "repeated-vertex", mesh, before);
  expect_refused(join_loop(mesh, h, Halfedge(99)), "not-a-halfedge", mesh, before);
  EXPECT_TRUE(check_join_loop(mesh, h, g).ok());

  Mesh annulus_and_face = reference_build(annulus(5));
  const Snapshot annulus_before(annulus_and_face);
  expect_refused(
      join_loop(annulus_and_face, between(annulus_and_face, 0, 1), between(annulus_and_face, 0, 5)),
      "different-degrees", annulus_and_face, annulus_before);

  const Shape pair{"two triangles", 6, {{0, 1, 2}, {3, 4, 5}}};
  Mesh triangles = reference_build(pair);
  expect_refused(join_loop(triangles, between(triangles, 0, 1), between(triangles, 3, 4)),
                 "edge-without-face", triangles, Snapshot(triangles));
  Mesh segments = segment_complex();
  ASSERT_TRUE(make_segment(segments).ok());
  expect_refused(join_loop(segments, Halfedge(0), Halfedge(2)), "last-edge", segments,
                 Snapshot(segments));
}

TEST(DecoratorBoundary, GetsAFaceWithOneNewEdge) {
  Mesh mesh = reference_build(quad_grid(2, 1));  // 0 1 2 above 3 4 5
  const Halfedge h = between(mesh, 1, 0);
  const Halfedge g = between(mesh, 0, 3);
  const LiveItems before(mesh);
  const Halfedge d = add_face_to_boundary(mesh, h, g).value();
  EXPECT_EQ(mesh.from_vertex(d), Vertex(3));
  EXPECT_EQ(mesh.to_vertex(d), Vertex(0));
  EXPECT_EQ(mesh.prev(d), g);
  EXPECT_EQ(mesh.next(h), mesh.opposite(d));
  EXPECT_EQ(corners_of(mesh, d), (Corners{0, 3}));
  expect_valid_complex(mesh);
  EXPECT_EQ(join_face(mesh, mesh.opposite(d)).value(), h);
  EXPECT_TRUE(LiveItems(mesh) == before);
  expect_valid_complex(mesh);
  ASSERT_TRUE(add_face_to_boundary(mesh, h, g).ok());
  ASSERT_TRUE(erase_face(mesh, d).ok());
  EXPECT_TRUE(LiveItems(mesh) == before);
  expect_valid_complex(mesh);

  // The whole loop, but for a loop edge.
  const Halfedge loop = add_face_to_boundary(mesh, h, h).value();
  EXPECT_EQ(mesh.next(mesh.opposite(loop)), mesh.opposite(loop));
  EXPECT_EQ(corners_of(mesh, h).size(), 7U);
  EXPECT_TRUE(mesh.is_boundary(Vertex(0)));
  EXPECT_FALSE(mesh.is_boundary(Vertex(1)));
  expect_valid_complex(mesh);
}

TEST(DecoratorBoundary, GetsAFaceWithANewVertex) {
  Mesh mesh = reference_build(quad_grid(2, 1));
  mesh.set_position(Vertex(3), {0, 4, 0});
  mesh.set_position(Vertex(0), {2, 0, 0});
  const LiveItems before(mesh);
  const Halfedge h = between(mesh, 1, 0);
  const Halfedge g = between(mesh, 0, 3);
  const Halfedge k = add_vertex_and_face_to_boundary(mesh, h, g).value();
  EXPECT_EQ(mesh.next(g), k);
  EXPECT_EQ(mesh.to_vertex(k), Vertex(6));
  EXPECT_EQ(mesh.position(Vertex(6)), (Point{1, 2, 0}));
  EXPECT_EQ(corners_of(mesh, k), (Corners{6, 0, 3}));
  EXPECT_FALSE(has_errors(validate(mesh)));
  expect_valid_complex(mesh);
  ASSERT_TRUE(erase_face(mesh, k).ok());
  EXPECT_TRUE(LiveItems(mesh) == before);
  expect_valid_complex(mesh);

  const Snapshot unchanged(mesh);
  const Halfedge inside = mesh.opposite(h);
  expect_refused(add_face_to_boundary(mesh, h, inside), "not-a-boundary-halfedge", mesh, unchanged);
  expect_refused(add_vertex_and_face_to_boundary(mesh, inside, g), "not-a-boundary-halfedge", mesh,
                 unchanged);
  expect_refused(add_face_to_boundary(mesh, h, Halfedge(99)), "not-a-halfedge", mesh, unchanged);
  Mesh ring = reference_build(annulus(4));
  expect_refused(add_face_to_boundary(ring, between(ring, 0, 1), between(ring, 5, 4)),
                 "different-loops", ring, Snapshot(ring));
}

TEST(DecoratorEraseFace, TakesEdgesAndVerticesAlong) {
  Mesh mesh = reference_build(quad_grid(2, 1));
  const Face f = mesh.face(between(mesh, 0, 1));
  ASSERT_TRUE(erase_face(mesh, between(mesh, 0, 1)).ok());
  EXPECT_FALSE(mesh.is_live(f));
  EXPECT_EQ(mesh.vertex_count(), 4U);
  EXPECT_EQ(mesh.edge_count(), 4U);
  EXPECT_FALSE(mesh.is_live(Vertex(0)));
  EXPECT_FALSE(mesh.is_live(Vertex(3)));
  EXPECT_TRUE(mesh.is_boundary(between(mesh, 1, 4)));
  expect_valid_complex(mesh);
  expect_refused(erase_face(mesh, between(mesh, 1, 4)), "boundary-halfedge", mesh, Snapshot(mesh));
  expect_refused(erase_face(mesh, Halfedge{}), "not-a-halfedge", mesh, Snapshot(mesh));
  ASSERT_TRUE(erase_face(mesh, between(mesh, 4, 1)).ok());
  EXPECT_EQ(mesh.vertex_count(), 0U);
  EXPECT_EQ(mesh.edge_count(), 0U);
  EXPECT_EQ(mesh.face_count(), 0U);

  Mesh fans = reference_build(pinched(3));  // one fan goes, the others stay joined
  ASSERT_TRUE(erase_face(fans, between(fans, 0, 3)).ok());
  EXPECT_EQ(fans.valence(Vertex(0)), 4U);
  expect_valid_complex(fans);

  for (Mesh* complex : {new Mesh(segment_complex()), new Mesh(loop_complex())}) {
    while (complex->face_count() > 0) {
      const Face first = *complex->faces().begin();
      ASSERT_TRUE(erase_face(*complex, complex->face_halfedge(first)).ok());
      expect_valid_complex(*complex);
    }
    EXPECT_EQ(complex->edge_count(), 0U);
    EXPECT_EQ(complex->vertex_count(), 0U);
    delete complex;
  }
}

TEST(DecoratorComponents, AreErased) {
  Mesh mesh = reference_build(two_components());
  EXPECT_EQ(erase_connected_component(mesh, between(mesh, 5, 4)).value(), 3U);
  EXPECT_EQ(mesh.vertex_count(), 4U);
  EXPECT_EQ(mesh.face_count(), 4U);
  EXPECT_EQ(mesh.edge_count(), 6U);
  EXPECT_TRUE(validate(mesh).empty());
  expect_refused(erase_connected_component(mesh, Halfedge(99)), "not-a-halfedge", mesh,
                 Snapshot(mesh));
  EXPECT_EQ(erase_connected_component(mesh, between(mesh, 0, 1)).value(), 6U);
  EXPECT_EQ(mesh.vertex_count() + mesh.edge_count() + mesh.face_count(), 0U);

  Mesh fans = reference_build(pinched(5));  // joined at one vertex only
  EXPECT_EQ(erase_connected_component(fans, between(fans, 1, 2)).value(), 15U);
  EXPECT_EQ(fans.vertex_count(), 0U);
}

TEST(DecoratorComponents, TheLargestAreKept) {
  Mesh mesh = reference_build(two_components());  // 4 and 3 vertices
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(mesh.new_vertex().valid());
  ASSERT_TRUE(make_loop(mesh).ok());
  ASSERT_TRUE(make_segment(mesh).ok());
  Mesh all = copy_of(mesh);
  EXPECT_EQ(keep_largest_connected_components(all, 9).value(), 0U);
  EXPECT_EQ(all.vertex_count(), 10U);  // but for the isolated vertices
  EXPECT_EQ(keep_largest_connected_components(mesh, 2).value(), 2U);
  EXPECT_EQ(mesh.vertex_count(), 7U);
  EXPECT_TRUE(validate(mesh).empty());
  EXPECT_EQ(keep_largest_connected_components(mesh, 1).value(), 1U);
  EXPECT_TRUE(mesh.is_live(Vertex(0)));
  EXPECT_FALSE(mesh.is_live(Vertex(4)));
  EXPECT_EQ(keep_largest_connected_components(mesh, 0).value(), 1U);
  EXPECT_EQ(mesh.vertex_count() + mesh.edge_count() + mesh.face_count(), 0U);
}

TEST(DecoratorInsideOut, ReversesEveryLoop) {
  for (auto& [name, mesh] : all_complexes()) {
    SCOPED_TRACE(name);
    const Mesh before = copy_of(mesh);
    const Snapshot arrays(mesh);
    ASSERT_TRUE(inside_out(mesh).ok());
    expect_valid_complex(mesh);
    for (const Halfedge h : mesh.halfedges()) {
      EXPECT_EQ(mesh.next(h), before.prev(h));
      EXPECT_EQ(mesh.to_vertex(h), before.from_vertex(h));
      EXPECT_EQ(mesh.face(h), before.face(h));
    }
    EXPECT_EQ(has_errors(validate(mesh)), has_errors(validate(before)));
    ASSERT_TRUE(inside_out(mesh).ok());
    EXPECT_TRUE(Snapshot(mesh) == arrays);
  }
}

TEST(DecoratorNormalize, PutsBoundaryEdgesLast) {
  std::size_t with_boundary = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = reference_build(random_polygons(seed));
    while (seed % 3 == 0 && mesh.face_count() > 20) {  // some deleted slots
      ASSERT_TRUE(erase_face(mesh, mesh.face_halfedge(*mesh.faces().begin())).ok());
    }
    const Mesh before = copy_of(mesh);
    const BoundaryOrder order = normalize_boundary(mesh).value();
    EXPECT_TRUE(is_boundary_normalized(mesh));
    EXPECT_FALSE(has_errors(validate(mesh)));
    EXPECT_TRUE(Invariants(mesh).hold());

    Matching<View<Mesh>, View<Mesh>>::Matched matched;
    Index boundary = 0;
    Index last = 0;  // the order of the others stays
    for (const Halfedge h : before.halfedges()) {
      const Halfedge to = order.new_halfedge[h.index()];
      matched.emplace_back(h.index(), to.index());
      boundary += before.is_boundary(h) ? 1 : 0;
      if (before.is_boundary(before.edge(h))) continue;
      EXPECT_GE(to.index(), last);
      last = to.index();
    }
    Matching same(View{before}, View{std::as_const(mesh)});
    EXPECT_EQ(same.run(matched), "");
    for (const auto& [v, w] : same.vertices()) EXPECT_EQ(v, w);
    for (const auto& [f, g] : same.faces()) EXPECT_EQ(f, g);
    EXPECT_EQ(order.boundary_halfedges, boundary);
    EXPECT_EQ(order.boundary_edges, boundary);
    EXPECT_EQ(order.first_boundary_edge.valid(), boundary > 0);
    for (const Edge e : mesh.edges()) {
      EXPECT_EQ(mesh.is_boundary(e), boundary > 0 && e >= order.first_boundary_edge);
    }
    for (Index h = 0; h < before.halfedge_slots(); ++h) {
      EXPECT_EQ(order.new_halfedge[h].valid(), before.is_live(Halfedge(h)));
    }
    with_boundary += boundary > 0 ? 1 : 0;
    const Snapshot normalized(mesh);
    ASSERT_TRUE(normalize_boundary(mesh).ok());
    EXPECT_TRUE(Snapshot(mesh) == normalized);
  }
  EXPECT_GT(with_boundary, 30U);
  EXPECT_FALSE(is_boundary_normalized(reference_build(quad_grid(2, 1))));
}

}  // namespace
}  // namespace halfedge::test
