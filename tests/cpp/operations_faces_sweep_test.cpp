// Operations on faces and edges in place, tried everywhere on meshes of all topologies: what each
// allows and does is what the builder makes of the faces that it should leave.

#include <gtest/gtest.h>
#include <halfedge/operations/dissolve.h>
#include <halfedge/operations/holes.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/split_face.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/face_lists.h"
#include "support/sweep.h"

namespace halfedge::test {
namespace {

using namespace operations;
using Corners = std::vector<Index>;

std::vector<std::string> codes_of(const std::set<std::string_view>& codes) {
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
  std::set<std::string_view> codes;
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
  std::set<std::string_view> codes;
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
  std::set<std::string_view> codes;
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
        const bool is_one_loop = steps::is_one_loop(mesh, h, g);
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
  std::set<std::string_view> codes;
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
  std::set<std::string_view> codes;
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
  std::set<std::string_view> codes;
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

}  // namespace
}  // namespace halfedge::test
