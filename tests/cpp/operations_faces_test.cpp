// Operations on faces and edges in place: holes, edges across faces, centres, dissolving.

#include <gtest/gtest.h>
#include <halfedge/operations/dissolve.h>
#include <halfedge/operations/holes.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/split_face.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/sweep.h"

namespace halfedge::test {
namespace {

using namespace operations;
using Corners = std::vector<Index>;

std::vector<std::string> codes_of(const std::set<std::string>& codes) {
  return {codes.begin(), codes.end()};
}

Polys without(Polys faces, const std::vector<Corners>& gone) {
  for (const Corners& face : in_order(gone)) {
    faces.erase(std::find(faces.begin(), faces.end(), face));
  }
  return faces;
}

/// The corners of the face of `h`, from to_vertex(h) round to from_vertex(h).
Corners loop_from(const Mesh& mesh, Halfedge h) { return corners_of(mesh, h); }

TEST(SweepMakeHole, IsAllowedJustWhereEachEdgeKeepsAFace) {
  std::set<std::string> codes;
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Face f : mesh.faces()) {
      SCOPED_TRACE(f.index());
      Mesh after;
      const bool done = holds_contract(
          mesh, [&](const Mesh& m) { return check_make_hole(m, f); },
          [&](Mesh& m) { return make_hole(m, f); }, after);
      EXPECT_EQ(done, !mesh.is_boundary(f));
      if (!done) {
        codes.insert(check_make_hole(mesh, f).error().code);
        continue;
      }
      const Corners corners = loop_from(mesh, mesh.face_halfedge(f));
      EXPECT_EQ(polys_of(after), without(polys_of(mesh), {corners}));
      EXPECT_EQ(after.edge_count(), mesh.edge_count());
      ASSERT_TRUE(fill_hole(after, mesh.face_halfedge(f)));
      EXPECT_TRUE(LiveItems(after) == LiveItems(mesh));
    }
  }
  EXPECT_EQ(codes_of(codes), (std::vector<std::string>{"edge-without-face"}));
}

TEST(SweepFillHole, IsAllowedJustWhereTheBuilderTakesTheFace) {
  std::set<std::string> codes;
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Halfedge h : mesh.halfedges()) {
      SCOPED_TRACE(h.index());
      Mesh after;
      const bool done = holds_contract(
          mesh, [&](const Mesh& m) { return check_fill_hole(m, h); },
          [&](Mesh& m) { return fill_hole(m, h); }, after);
      const Corners corners = loop_from(mesh, h);
      Polys expected = polys_of(mesh);
      expected.push_back(corners);
      const bool is_allowed =
          mesh.is_boundary(h) && buildable(mesh.vertex_slots(), expected) == mesh.edge_count();
      EXPECT_EQ(done, is_allowed);
      if (!done) {
        codes.insert(check_fill_hole(mesh, h).error().code);
        continue;
      }
      EXPECT_EQ(polys_of(after), in_order(expected));
      const Face f = after.face(h);
      EXPECT_EQ(after.face_halfedge(f), h);
      if (!check_make_hole(after, f)) continue;
      EXPECT_EQ(make_hole(after, f).value(), h);
      EXPECT_TRUE(LiveItems(after) == LiveItems(mesh));
    }
  }
  EXPECT_EQ(codes_of(codes),
            (std::vector<std::string>{"not-a-boundary-halfedge", "repeated-vertex"}));
}

TEST(SweepInsertEdge, IsAllowedJustWhereTheBuilderTakesTheFaces) {
  std::set<std::string> codes;
  for (auto& [name, mesh] : meshes_to_sweep(5)) {
    SCOPED_TRACE(name);
    if (mesh.halfedge_slots() > 150) continue;
    for (const Halfedge h : mesh.halfedges()) {
      std::vector<Halfedge> others{Halfedge(0)};  // most often of another loop
      for (const Halfedge on_loop : mesh.loop_ccw(h)) others.push_back(on_loop);
      for (const Halfedge g : others) {
        SCOPED_TRACE("insert_edge(" + std::to_string(h.index()) + ", " + std::to_string(g.index()) +
                     ")");
        Mesh after;
        const bool done = holds_contract(
            mesh, [&](const Mesh& m) { return check_insert_edge(m, h, g); },
            [&](Mesh& m) { return insert_edge(m, h, g); }, after);

        // By hand: the loop from to(h) on, up to to(g); and from there back.
        Corners loop = loop_from(mesh, h);
        const bool is_one_loop = decorator::internal::is_one_loop(mesh, h, g);
        std::size_t cut = 0;
        for (Halfedge at = h; is_one_loop && at != g; at = mesh.next(at)) ++cut;
        Polys expected = polys_of(mesh);
        Corners kept{loop.begin() + std::ptrdiff_t(cut), loop.end()};
        kept.push_back(loop[0]);
        if (!mesh.is_boundary(h)) {
          expected = without(expected, {loop});
          expected.push_back(kept);
        }
        expected.push_back({loop.begin(), loop.begin() + std::ptrdiff_t(cut) + 1});
        const bool is_allowed = is_one_loop && kept.size() > 2 &&
                                buildable(mesh.vertex_slots(), expected) == mesh.edge_count() + 1;
        EXPECT_EQ(done, is_allowed);
        if (!done) {
          codes.insert(check_insert_edge(mesh, h, g).error().code);
          continue;
        }
        EXPECT_EQ(polys_of(after), in_order(expected));
        const Edge e = mesh.edge(after.next(h));
        EXPECT_EQ(after.from_vertex(after.next(h)), mesh.to_vertex(h));
        EXPECT_EQ(after.to_vertex(after.next(h)), mesh.to_vertex(g));
        EXPECT_EQ(after.face(h), mesh.face(h));
        EXPECT_NE(after.face(g), mesh.face(h));
        if (!mesh.is_boundary(h)) {
          ASSERT_TRUE(remove_edge(after, e));
        } else if (!remove_edge(after, e)) {
          continue;
        }
        EXPECT_TRUE(LiveItems(after) == LiveItems(mesh));
      }
    }
  }
  EXPECT_EQ(codes_of(codes),
            (std::vector<std::string>{"adjacent-corners", "different-loops", "edge-exists",
                                      "repeated-vertex", "same-corner"}));
}

/// The face that the two faces of `h` become without its edge.
Corners joined_at(const Mesh& mesh, Halfedge h) {
  Corners left = loop_from(mesh, h);                  // to(h) .. from(h)
  Corners right = loop_from(mesh, mesh.opposite(h));  // from(h) .. to(h)
  left.insert(left.end(), right.begin() + 1, right.end() - 1);
  return left;
}

TEST(SweepRemoveEdge, IsAllowedJustWhereTheBuilderTakesTheJoinedFace) {
  std::set<std::string> codes;
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Edge e : mesh.edges()) {
      SCOPED_TRACE(e.index());
      Mesh after;
      const bool done = holds_contract(
          mesh, [&](const Mesh& m) { return check_remove_edge(m, e); },
          [&](Mesh& m) { return remove_edge(m, e); }, after);
      Halfedge h = mesh.edge_halfedge(e);
      if (mesh.is_boundary(mesh.opposite(h))) h = mesh.opposite(h);
      const Corners removed = loop_from(mesh, mesh.opposite(h));
      Polys expected = without(polys_of(mesh), {removed});
      if (!mesh.is_boundary(h)) {
        expected = without(expected, {loop_from(mesh, h)});
        expected.push_back(joined_at(mesh, h));
      }
      EXPECT_EQ(done, buildable(mesh.vertex_slots(), expected) == mesh.edge_count() - 1);
      if (!done) {
        codes.insert(check_remove_edge(mesh, e).error().code);
        continue;
      }
      EXPECT_EQ(polys_of(after), in_order(expected));
      EXPECT_FALSE(after.is_live(e));
      EXPECT_EQ(after.face(mesh.prev(h)), mesh.face(h));
      ASSERT_EQ(insert_edge(after, mesh.prev(h), mesh.prev(mesh.opposite(h))).value(), e);
      EXPECT_EQ(polys_of(after), polys_of(mesh));
      EXPECT_EQ(after.face(mesh.prev(h)), mesh.face(h));
    }
  }
  EXPECT_EQ(codes_of(codes), (std::vector<std::string>{"edge-without-face", "faces-share-edges",
                                                       "faces-share-vertex"}));
}

TEST(SweepSplitFace, MakesTrianglesThatDissolvingTheirVertexTakesBack) {
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Face f : mesh.faces()) {
      Mesh after;
      const Point at{1, 2, 3};
      ASSERT_TRUE(holds_contract(
          mesh, [&](const Mesh& m) { return check_split_face(m, f); },
          [&](Mesh& m) { return split_face(m, f, at); }, after));
      const Corners corners = loop_from(mesh, mesh.face_halfedge(f));
      Polys expected = without(polys_of(mesh), {corners});
      const Index c = mesh.vertex_slots();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        expected.push_back({corners[i], corners[(i + 1) % corners.size()], c});
      }
      EXPECT_EQ(polys_of(after), in_order(expected));
      EXPECT_EQ(after.position(Vertex(c)), at);
      EXPECT_EQ(after.face(after.opposite(after.vertex_halfedge(Vertex(c)))), f);
      EXPECT_EQ(dissolve_vertex(after, Vertex(c)).value(), f);
      EXPECT_TRUE(LiveItems(after) == LiveItems(mesh));
    }
  }
}

TEST(SweepDissolveVertex, IsAllowedJustWhereTheBuilderTakesTheJoinedFace) {
  std::set<std::string> codes;
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Vertex v : mesh.vertices()) {
      SCOPED_TRACE(v.index());
      Mesh after;
      const bool done = holds_contract(
          mesh, [&](const Mesh& m) { return check_dissolve_vertex(m, v); },
          [&](Mesh& m) { return dissolve_vertex(m, v); }, after);
      // By hand: the paths of the faces around v, one after the other.
      Polys around;
      Corners joined;
      bool is_open = mesh.is_boundary(v);
      for (const Halfedge out : mesh.outgoing_cw(v)) {
        if (mesh.is_boundary(out)) continue;
        Corners corners = loop_from(mesh, out);
        around.push_back(corners);
        corners.pop_back();                                                  // v
        if (!joined.empty() && corners.back() != joined[0]) joined.clear();  // another fan
        if (!joined.empty()) corners.pop_back();
        joined.insert(joined.begin(), corners.begin(), corners.end());
      }
      bool is_allowed = !mesh.is_isolated(v) && mesh.is_manifold(v);
      if (is_allowed && !is_open) joined.pop_back();
      Polys expected = without(polys_of(mesh), around);
      expected.push_back(joined);
      const Index lost = mesh.valence(v) - (is_open ? 1 : 0);
      is_allowed =
          is_allowed && buildable(mesh.vertex_slots(), expected) == mesh.edge_count() - lost;
      EXPECT_EQ(done, is_allowed);
      if (!done) {
        codes.insert(check_dissolve_vertex(mesh, v).error().code);
        continue;
      }
      EXPECT_EQ(polys_of(after), in_order(expected));
      EXPECT_FALSE(after.is_live(v));
    }
  }
  EXPECT_EQ(codes_of(codes),
            (std::vector<std::string>{"degree-below-three", "edge-exists", "isolated-vertex",
                                      "pinched-vertex", "repeated-vertex"}));
}

/// What edges there are, as pairs of vertices.
std::set<std::pair<Index, Index>> edges_of(const Polys& faces) {
  std::set<std::pair<Index, Index>> edges;
  for (const Corners& face : faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      edges.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
    }
  }
  return edges;
}

Corners neighbours_of(const Polys& faces, Index v) {
  Corners neighbours;
  for (const auto& [a, b] : edges_of(faces)) {
    if (a == v) neighbours.push_back(b);
    if (b == v) neighbours.push_back(a);
  }
  return neighbours;
}

/// The faces without edge a-b, on the left of which `left` is, and what goes with it; or no faces.
Polys dissolved(Polys faces, Corners left, Corners right, Index a, Index b) {
  const Polys before = faces;
  faces = without(faces, {left, right});
  const auto begin_at = [](Corners& face, Index v) {
    std::rotate(face.begin(), std::find(face.begin(), face.end(), v), face.end());
  };
  begin_at(left, b);   // b .. a
  begin_at(right, a);  // a .. b
  while (neighbours_of(before, b).size() == 2) {
    if (left.size() == 2 || right.size() == 2) return {};  // a ring
    left.erase(left.begin());
    right.pop_back();
    b = left.front();
    if (right.back() != b) return {};
  }
  while (neighbours_of(before, a).size() == 2) {
    left.pop_back();
    right.erase(right.begin());
    a = right.front();
    if (left.back() != a) return {};
  }
  for (std::size_t i = 1; i + 1 < left.size(); ++i) {
    if (std::find(right.begin(), right.end(), left[i]) != right.end()) return {};
  }
  if (left.size() == 2 && right.size() == 2) return {};
  left.insert(left.end(), right.begin() + 1, right.end() - 1);
  faces.push_back(left);
  for (const Index end : {a, b}) {
    const Corners neighbours = neighbours_of(faces, end);
    if (neighbours.size() != 2) continue;
    if (edges_of(faces).count(std::minmax(neighbours[0], neighbours[1])) > 0) continue;
    for (Corners& face : faces) face.erase(std::remove(face.begin(), face.end(), end), face.end());
  }
  return faces;
}

/// Meshes with chains of vertices of valence two, besides the others.
std::vector<std::pair<std::string, Mesh>> meshes_with_chains() {
  std::vector<std::pair<std::string, Mesh>> meshes = meshes_to_sweep(5);
  for (auto& [name, mesh] : meshes) {
    if (mesh.edge_count() > 40) continue;
    for (Index i = 0; i < mesh.edge_count(); i += 3) {
      for (int times = 0; times < 2; ++times) {
        EXPECT_TRUE(decorator::split_edge(mesh, Halfedge(2 * i + 1)).ok());
      }
    }
    if (mesh.face_count() > 3) {
      // Leaves a vertex of valence two beside a triangle: its neighbours are joined.
      for (const Edge e : mesh.edges()) {
        if (remove_edge(mesh, e)) break;
      }
    }
  }
  return meshes;
}

TEST(SweepDissolveEdge, TakesTheWholeSeamAndItsEnds) {
  std::set<std::string> codes;
  for (const bool with_chains : {false, true}) {
    for (auto& [name, mesh] : with_chains ? meshes_with_chains() : meshes_to_sweep()) {
      SCOPED_TRACE(name);
      for (const Edge e : mesh.edges()) {
        SCOPED_TRACE(e.index());
        Mesh after;
        const bool done = holds_contract(
            mesh, [&](const Mesh& m) { return check_dissolve_edge(m, e); },
            [&](Mesh& m) { return dissolve_edge(m, e); }, after);
        const Halfedge h = mesh.edge_halfedge(e);
        Polys expected;
        if (!mesh.is_boundary(e)) {
          expected =
              dissolved(polys_of(mesh), loop_from(mesh, h), loop_from(mesh, mesh.opposite(h)),
                        mesh.from_vertex(h).index(), mesh.to_vertex(h).index());
        }
        EXPECT_EQ(done, !expected.empty());
        if (!done) {
          codes.insert(check_dissolve_edge(mesh, e).error().code);
          continue;
        }
        EXPECT_EQ(polys_of(after), in_order(expected));
        EXPECT_FALSE(after.is_live(e));
        EXPECT_TRUE(after.is_live(mesh.face(h)));
      }
    }
  }
  EXPECT_EQ(codes_of(codes),
            (std::vector<std::string>{"boundary-edge", "faces-share-edges", "faces-share-vertex"}));
}

// ---- refusals and their witnesses -----------------------------------------------------------

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
  refuses(mesh, dissolve(1), "degree-below-three", {.vertices = {4, 2}});
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

// ---- positions and attributes ---------------------------------------------------------------

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
