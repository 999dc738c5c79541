// Operations on faces and edges in place: why each refuses, and what becomes of positions and
// attributes.

#include <gtest/gtest.h>
#include <halfedge/operations/dissolve.h>
#include <halfedge/operations/holes.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/split_face.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/sweep.h"

namespace halfedge::test {
namespace {

using namespace operations;

/// A mesh of these faces with attributes.
Mesh prepared(const Shape& shape) {
  Mesh mesh = reference_build(shape);
  add_attributes_of_all_kinds(mesh);
  return mesh;
}

Halfedge between(const Mesh& mesh, Index from, Index to) {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  EXPECT_TRUE(h.valid()) << from << " -> " << to;
  return h;
}
Edge edge_between(const Mesh& mesh, Index a, Index b) { return mesh.edge(between(mesh, a, b)); }

/// That `operate` refuses with this code and witness, and changes nothing.
template <class Operate>
void refuses(Mesh& mesh, const Operate& operate, const std::string& code, const Witness& witness) {
  const Snapshot before(mesh);
  const auto result = operate(mesh);
  expect_refused(result, code, mesh, before);
  const Witness& found = result.error().witness;
  EXPECT_EQ(found.vertices, witness.vertices) << result.error().message;
  EXPECT_EQ(found.halfedges, witness.halfedges) << result.error().message;
  EXPECT_EQ(found.edges, witness.edges) << result.error().message;
  EXPECT_EQ(found.faces, witness.faces) << result.error().message;
}

/// The boundary halfedge from `a` to `b`, or from `b` to `a`.
Halfedge boundary_between(const Mesh& mesh, Index a, Index b) {
  const Halfedge h = between(mesh, a, b);
  return mesh.is_boundary(h) ? h : mesh.opposite(h);
}

TEST(MakeHole, SaysWhyItCannot) {
  Mesh mesh = prepared(triangle_grid(2, 2));  // 0 1 4 is its first face
  refuses(mesh, [](Mesh& m) { return make_hole(m, Face(0)); }, "edge-without-face",
          {.edges = {edge_between(mesh, 0, 1).index()}});
  refuses(mesh, [](Mesh& m) { return make_hole(m, Face(9)); }, "not-a-face", {.faces = {9}});
  refuses(mesh, [](Mesh& m) { return make_hole(m, Face{}); }, "not-a-face", {});
}

TEST(FillHole, SaysWhyItCannot) {
  Mesh mesh = prepared(pinched(3));
  const Halfedge h = boundary_between(mesh, 1, 2);
  refuses(mesh, [&](Mesh& m) { return fill_hole(m, h); }, "repeated-vertex", {.vertices = {0}});
  const Halfedge inside = mesh.opposite(h);
  refuses(mesh, [&](Mesh& m) { return fill_hole(m, inside); }, "not-a-boundary-halfedge",
          {.halfedges = {inside.index()}});
  refuses(mesh, [](Mesh& m) { return fill_hole(m, Halfedge(99)); }, "not-a-halfedge",
          {.halfedges = {99}});

  Mesh lens = loop_complex();  // two edges around one face
  ASSERT_TRUE(decorator::split_edge(lens, Halfedge(0)).ok());
  ASSERT_TRUE(decorator::make_hole(lens, Halfedge(1)).ok());
  const Snapshot before(lens);
  expect_refused(fill_hole(lens, Halfedge(1)), "degree-below-three", lens, before);
  EXPECT_EQ(fill_hole(lens, Halfedge(1)).error().witness.vertices.size(), 2U);
}

TEST(InsertEdge, SaysWhyItCannot) {
  Mesh mesh = prepared(mixed_polygons());  // 0 4 5 6 1 is a face, 2 1 7 8 9 10 another
  const Halfedge to_0 = between(mesh, 1, 0);
  const Halfedge to_4 = between(mesh, 0, 4);
  const Halfedge to_5 = between(mesh, 4, 5);
  const Halfedge to_7 = between(mesh, 1, 7);
  const auto insert = [](Halfedge h, Halfedge g) {
    return [=](Mesh& m) { return insert_edge(m, h, g); };
  };
  refuses(mesh, insert(to_0, to_4), "adjacent-corners",
          {.vertices = {0, 4}, .halfedges = {to_4.index()}});
  refuses(mesh, insert(to_4, to_0), "adjacent-corners",
          {.vertices = {0, 4}, .halfedges = {to_4.index()}});
  refuses(mesh, insert(to_5, to_5), "same-corner",
          {.vertices = {5}, .halfedges = {to_5.index(), to_5.index()}});
  refuses(mesh, insert(to_5, to_7), "different-loops", {.halfedges = {to_5.index(), to_7.index()}});
  refuses(mesh, insert(Halfedge(99), to_7), "not-a-halfedge", {.halfedges = {99}});
  refuses(mesh, insert(to_7, Halfedge{}), "not-a-halfedge", {});

  Mesh quads = prepared(Shape("", 5, {{0, 1, 2, 3}, {0, 2, 4}}));
  refuses(quads, insert(between(quads, 3, 0), between(quads, 1, 2)), "edge-exists",
          {.vertices = {0, 2}, .edges = {edge_between(quads, 0, 2).index()}});
  Mesh fans = prepared(pinched(3));
  // From 1 over 0, the fan of 3 and 4, and 0 again: the fans of a pinched vertex in one loop.
  const Halfedge to_1 = boundary_between(fans, 1, 2);
  ASSERT_EQ(fans.to_vertex(to_1), Vertex(1));
  Halfedge over = fans.next(fans.next(to_1));  // 1 -> 0 -> next fan
  while (fans.to_vertex(fans.next(over)) != Vertex(0)) over = fans.next(over);
  over = fans.next(fans.next(over));  // beyond 0 once more
  refuses(fans, insert(to_1, over), "repeated-vertex", {.vertices = {0}});
}

TEST(RemoveEdge, SaysWhyItCannot) {
  const auto remove = [](Edge e) { return [=](Mesh& m) { return remove_edge(m, e); }; };
  Mesh one = prepared(pillow());
  const Edge first = one.edge(one.face_halfedge(Face(0)));
  std::vector<Index> shared;  // from the one to be removed on
  const Halfedge h = one.edge_halfedge(first);
  for (const Halfedge on_loop : one.loop_ccw(h)) shared.push_back(one.edge(on_loop).index());
  refuses(one, remove(first), "faces-share-edges",
          {.edges = shared, .faces = {one.face(h).index(), one.face(one.opposite(h)).index()}});

  // Two quads around a hole: they share 0-1, and vertex 3.
  Mesh ring = prepared(Shape("", 6, {{0, 1, 2, 3}, {1, 0, 4, 3, 5}}));
  const Edge e = edge_between(ring, 0, 1);
  const Halfedge side = ring.edge_halfedge(e);
  refuses(ring, remove(e), "faces-share-vertex",
          {.vertices = {3},
           .faces = {ring.face(side).index(), ring.face(ring.opposite(side)).index()}});
  Mesh triangle_mesh = prepared(triangle());
  const Edge rim = edge_between(triangle_mesh, 0, 1);
  refuses(triangle_mesh, remove(rim), "edge-without-face",
          {.edges = {triangle_mesh
                         .edge(triangle_mesh.next(
                             triangle_mesh.opposite(boundary_between(triangle_mesh, 0, 1))))
                         .index()}});
  refuses(ring, remove(Edge(88)), "not-an-edge", {.edges = {88}});
}

TEST(DissolveVertex, SaysWhyItCannot) {
  const auto dissolve = [](Index v) {
    return [=](Mesh& m) { return dissolve_vertex(m, Vertex(v)); };
  };
  Mesh mesh = prepared(with_isolated_vertices());
  refuses(mesh, dissolve(0), "isolated-vertex", {.vertices = {0}});
  refuses(mesh, dissolve(9), "not-a-vertex", {.vertices = {9}});
  refuses(mesh, dissolve(1), "degree-below-three", {.vertices = {1, 4, 2}});
  Mesh fans = prepared(pinched(2));
  refuses(
      fans, dissolve(0), "pinched-vertex",
      {.vertices = {0}, .halfedges = {between(fans, 0, 2).index(), between(fans, 0, 4).index()}});
}

TEST(DissolveEdge, SaysWhyItCannot) {
  Mesh mesh = prepared(pillow());
  const Halfedge h = mesh.edge_halfedge(Edge(1));
  std::vector<Index> shared;
  for (const Halfedge on_loop : mesh.loop_ccw(h)) shared.push_back(mesh.edge(on_loop).index());
  refuses(mesh, [](Mesh& m) { return dissolve_edge(m, Edge(1)); }, "faces-share-edges",
          {.edges = shared, .faces = {mesh.face(h).index(), mesh.face(mesh.opposite(h)).index()}});
  refuses(mesh, [](Mesh& m) { return dissolve_edge(m, Edge(3)); }, "not-an-edge", {.edges = {3}});
  Mesh one = prepared(triangle());
  const Halfedge outside = boundary_between(one, 0, 1);
  refuses(one, [&](Mesh& m) { return dissolve_edge(m, m.edge(outside)); }, "boundary-edge",
          {.halfedges = {outside.index()}, .edges = {one.edge(outside).index()}});
}

TEST(SplitFace, SaysWhyItCannot) {
  Mesh mesh = prepared(triangle());
  refuses(mesh, [](Mesh& m) { return split_face(m, Face(4)); }, "not-a-face", {.faces = {4}});
}

/// The square 0 1 2 3 in the plane z = 2, of side 2 around the origin.
Mesh square() {
  Mesh mesh = reference_build(Shape("", 4, {{0, 1, 2, 3}}));
  const float xy[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (Index v = 0; v < 4; ++v) mesh.set_position(Vertex(v), {xy[v][0], xy[v][1], 2});
  return mesh;
}

TEST(SplitFace, GivesMeansAndCopies) {
  Mesh mesh = square();
  const auto column = [&](ItemKind kind, const char* name, OnSplit policy) {
    Attribute* added = mesh.add_attribute(kind, name, {.on_split = policy}).value();
    for (Index i = 0; i < mesh.slots(kind); ++i) added->set(i, 0, 10 * i, nullptr);
    return added;
  };
  const Attribute* at_vertex = column(ItemKind::kVertex, "v", OnSplit::kInterpolate);
  const Attribute* at_face = column(ItemKind::kFace, "f", OnSplit::kCopy);
  const Attribute* at_edge = column(ItemKind::kEdge, "e", OnSplit::kCopy);
  Attribute* at_corner = column(ItemKind::kHalfedge, "c", OnSplit::kInterpolate);
  for (const Halfedge h : mesh.loop_ccw(mesh.face_halfedge(Face(0)))) {
    at_corner->set(h.index(), 0, 1 + mesh.to_vertex(h).index(), nullptr);
  }
  mesh.find_attribute(ItemKind::kFace, "f")->set(0, 0, 7, nullptr);
  const Vertex c = split_face(mesh, Face(0)).value();
  EXPECT_EQ(mesh.position(c), (Point{0, 0, 2}));
  EXPECT_EQ(at_vertex->get(c.index(), 0), 15);
  for (const Face f : mesh.faces()) EXPECT_EQ(at_face->get(f.index(), 0), 7);
  for (const Halfedge out : mesh.outgoing_cw(c)) {
    EXPECT_EQ(at_edge->get(mesh.edge(out).index(), 0), 0);
    EXPECT_EQ(at_corner->get(mesh.opposite(out).index(), 0), 2.5);
    EXPECT_EQ(at_corner->get(out.index(), 0), 1 + mesh.to_vertex(out).index());
  }
}

TEST(InsertEdge, DividesCornersIntoTwoAlike) {
  Mesh mesh = square();
  Attribute* corner = mesh.add_attribute(ItemKind::kHalfedge, "c").value();
  Attribute* face = mesh.add_attribute(ItemKind::kFace, "f").value();
  face->set(0, 0, 3, nullptr);
  for (const Halfedge h : mesh.loop_ccw(mesh.face_halfedge(Face(0)))) {
    corner->set(h.index(), 0, 1 + mesh.to_vertex(h).index(), nullptr);
  }
  const Edge e = insert_edge(mesh, between(mesh, 0, 1), between(mesh, 2, 3)).value();
  const Halfedge d = mesh.edge_halfedge(e);
  EXPECT_EQ(mesh.from_vertex(d), Vertex(1));
  EXPECT_EQ(corner->get(d.index(), 0), 4);
  EXPECT_EQ(corner->get(mesh.opposite(d).index(), 0), 2);
  EXPECT_EQ(face->get(1, 0), 3);
  EXPECT_EQ(mesh.face(between(mesh, 2, 3)), Face(1));
}

TEST(Poke, MovesAlongTheNormal) {
  Mesh mesh = square();
  add_attributes_of_all_kinds(mesh);
  Mesh flat = copy_of(mesh);
  Mesh in = copy_of(mesh);
  const Vertex c = poke(mesh, Face(0), 0.5).value();
  EXPECT_EQ(mesh.position(c), (Point{0, 0, 2.5F}));
  EXPECT_EQ(flat.position(poke(flat, Face(0)).value()), (Point{0, 0, 2}));
  EXPECT_EQ(in.position(poke(in, Face(0), -3).value()), (Point{0, 0, -1}));
  EXPECT_EQ(polys_of(mesh), in_order({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));

  Mesh line = square();
  for (Index v = 0; v < 4; ++v) line.set_position(Vertex(v), {float(v), float(v), 1});
  refuses(line, [](Mesh& m) { return poke(m, Face(0), 1); }, "degenerate-face", {.faces = {0}});
  refuses(line, [](Mesh& m) { return poke(m, Face(0), HUGE_VAL); }, "not-finite", {});
  refuses(line, [](Mesh& m) { return poke(m, Face(1), 1); }, "not-a-face", {.faces = {1}});
  EXPECT_TRUE(check_poke(line, Face(0)));
  // A concave face far from the origin: the normal is that of its area.
  Mesh arrow = reference_build(Shape("", 4, {{0, 1, 2, 3}}));
  const float xy[4][2] = {{0, 0}, {4, -4}, {1, 0}, {4, 4}};
  for (Index v = 0; v < 4; ++v) {
    arrow.set_position(Vertex(v), {1000 + xy[v][0], 1000 + xy[v][1], 1000});
  }
  EXPECT_EQ(arrow.position(poke(arrow, Face(0), 8).value()), (Point{1002.25F, 1000, 1008}));
  // A face askew, of which no part of the normal is 0: (1, 2, 2) / 3.
  Mesh askew = reference_build(Shape("", 4, {{0, 1, 2, 3}}));
  const Point corners[4] = {{0, 0, 0}, {2, -2, 1}, {4, -1, -1}, {2, 1, -2}};
  for (Index v = 0; v < 4; ++v) askew.set_position(Vertex(v), corners[v]);
  const Point top = askew.position(poke(askew, Face(0), 3).value());
  EXPECT_FLOAT_EQ(top.x, 2 + 1);
  EXPECT_FLOAT_EQ(top.y, -0.5F + 2);
  EXPECT_FLOAT_EQ(top.z, -0.5F + 2);
}

TEST(OperationsOnFaces, WorkWherePrevIsNotStored) {
  BasicMesh<kWithoutPrev> mesh;
  ASSERT_TRUE(convert(reference_build(cube()), mesh));
  const Vertex c = split_face(mesh, Face(1)).value();
  ASSERT_TRUE(dissolve_vertex(mesh, c));
  ASSERT_TRUE(poke(mesh, Face(1), 1));
  const Halfedge h = mesh.face_halfedge(Face(0));
  const Edge e = insert_edge(mesh, h, mesh.next(mesh.next(h))).value();
  ASSERT_TRUE(remove_edge(mesh, e));
  const Halfedge hole = make_hole(mesh, Face(0)).value();
  ASSERT_TRUE(insert_edge(mesh, hole, mesh.next(mesh.next(hole))));
  EXPECT_FALSE(has_errors(validate(mesh)));
  ASSERT_TRUE(fill_hole(mesh, hole));
  ASSERT_TRUE(dissolve_edge(mesh, mesh.edge(hole)));
  EXPECT_FALSE(has_errors(validate(mesh)));
  EXPECT_EQ(mesh.vertex_count() + mesh.face_count(), mesh.edge_count() + 2);

  BasicMesh<kWithoutPrev> grid;
  ASSERT_TRUE(convert(reference_build(quad_grid(3, 3)), grid));
  ASSERT_TRUE(dissolve_vertex(grid, Vertex(1)));
  ASSERT_TRUE(dissolve_vertex(grid, Vertex(10)));
  EXPECT_EQ(grid.face_count(), 5U);
  EXPECT_FALSE(has_errors(validate(grid)));
  EXPECT_FALSE(has_errors(validate(mesh)));
}

}  // namespace
}  // namespace halfedge::test
