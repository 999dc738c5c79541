// Where edges can be collapsed and vertices split, what that leaves, and why else it is refused.

#include <gtest/gtest.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/split_vertex.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/collapsing.h"
#include "support/complexes.h"
#include "support/face_lists.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"

namespace halfedge::test {
namespace {

using operations::check_collapse;
using operations::collapse;
using operations::is_collapse_ok;
using operations::LinkCondition;
using operations::split_vertex;
using operations::SplitSide;
using operations::SplitSides;

Shape bipyramid() {
  return {"bipyramid", 5, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
}
/// A ring of six triangles between two boundary loops of three.
Shape triangle_annulus() {
  return {
      "triangle annulus", 6, {{0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}}};
}
/// A tetrahedron with a vertex on the edge that vertices 2 and 3 had: a pillow of quads is left
/// without the edge 0-1.
Shape tetrahedron_with_five_vertices() {
  return {"tetrahedron with a vertex on an edge",
          5,
          {{0, 1, 2}, {1, 0, 3}, {0, 2, 4, 3}, {1, 3, 4, 2}}};
}
Shape quad_pillow() { return {"quad pillow", 4, {{0, 1, 2, 3}, {3, 2, 1, 0}}}; }
/// A quad, two triangles: without the edge 0-1 a pillow of triangles is left.
Shape folded_quad() { return {"folded quad", 4, {{0, 1, 2, 3}, {1, 0, 3}, {1, 3, 2}}}; }

std::vector<Shape> shapes_to_collapse() {
  std::vector<Shape> shapes = all_shapes();
  for (Shape& shape :
       std::vector<Shape>{octahedron(), bipyramid(), two_triangles(), triangle_annulus(),
                          tetrahedron_with_five_vertices(), quad_pillow(), folded_quad()}) {
    shapes.push_back(shape);
  }
  for (std::uint32_t seed = 0; seed < 12; ++seed) shapes.push_back(random_polygons(seed));
  return shapes;
}

/// What a collapse should leave: `a` replaced by `b`, triangles that had both without.
Polys collapsed(const Polys& faces, Index a, Index b) {
  Polys result;
  for (std::vector<Index> face : faces) {
    std::replace(face.begin(), face.end(), a, b);
    face.erase(std::unique(face.begin(), face.end()), face.end());
    if (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() > 2) result.push_back(face);
  }
  return in_order(result);
}

bool has_pillow(const Polys& faces) {
  std::set<std::set<Index>> seen;
  for (const std::vector<Index>& face : faces) {
    if (!seen.insert(std::set<Index>(face.begin(), face.end())).second) return true;
  }
  return false;
}

/// The decision by hand: the list that is left must be a manifold with as many edges and fans as
/// there should be.
bool may_collapse(const Polys& before, Index a, Index b, LinkCondition condition) {
  const Polys after = collapsed(before, a, b);
  const std::size_t triangles = before.size() - after.size();
  if (edges_of(after).size() + 1 + triangles != edges_of(before).size()) return false;
  const std::size_t fans = count_fans(after);
  if (fans + 1 != count_fans(before)) return false;
  return condition == LinkCondition::kPermissive || !has_pillow(after);
}

SplitSides sides_of(const Mesh& mesh, Halfedge h) {
  const auto side = [&](Halfedge of) {
    const bool is_triangle = !mesh.is_boundary(of) && mesh.degree(mesh.face(of)) == 3;
    return is_triangle ? SplitSide::kTriangle : SplitSide::kCorner;
  };
  return {side(h), side(mesh.opposite(h))};
}

Index count_collapsible(const Shape& shape, LinkCondition condition = LinkCondition::kStrict) {
  const Mesh mesh = reference_build(shape);
  Index count = 0;
  for (const Halfedge h : mesh.halfedges()) count += is_collapse_ok(mesh, h, condition) ? 1 : 0;
  return count;
}

// ---- the table of allowed collapses ---------------------------------------------------------

TEST(Collapse, IsAllowedAsOftenAsInOpenMesh) {
  EXPECT_EQ(count_collapsible(octahedron()), 24U);
  EXPECT_EQ(count_collapsible(two_triangles()), 8U);
  EXPECT_EQ(count_collapsible(triangle()), 0U);
  EXPECT_EQ(count_collapsible(pillow()), 0U);
  EXPECT_EQ(count_collapsible(pinched(2)), 0U);
  EXPECT_EQ(count_collapsible(triangle_annulus()), 0U);
  EXPECT_EQ(count_collapsible(bipyramid()), 12U);
  EXPECT_EQ(count_collapsible(triangle_grid(2, 2)), 28U);
  EXPECT_EQ(count_collapsible(tetrahedron(), LinkCondition::kPermissive), 12U);
  EXPECT_EQ(count_collapsible(tetrahedron()), 0U);
}

// ---- every halfedge of many meshes ----------------------------------------------------------

TEST(Collapse, DecidesAndDoesWhatListsOfFacesSay) {
  std::size_t done = 0;
  for (const Shape& shape : shapes_to_collapse()) {
    SCOPED_TRACE(shape.name);
    Mesh original = reference_build(shape);
    add_attributes_of_all_kinds(original);
    const Polys before = polys_of(original);
    for (const Halfedge h : original.halfedges()) {
      const Index a = original.from_vertex(h).index();
      const Index b = original.to_vertex(h).index();
      SCOPED_TRACE(std::to_string(a) + " into " + std::to_string(b));
      for (const LinkCondition condition : {LinkCondition::kPermissive, LinkCondition::kStrict}) {
        const bool expected = may_collapse(before, a, b, condition);
        ASSERT_EQ(is_collapse_ok(original, h, condition), expected);
        if (expected && condition == LinkCondition::kStrict) continue;  // done above
        Mesh mesh;
        ASSERT_EQ(holds_contract(
                      original, [&](const Mesh& m) { return check_collapse(m, h, condition); },
                      [&](Mesh& m) { return collapse(m, h, {}, condition); }, mesh),
                  expected);
        if (!expected) continue;
        ++done;
        ASSERT_TRUE(mesh.is_deleted(Vertex(a)));
        ASSERT_EQ(polys_of(mesh), collapsed(before, a, b));
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(done, 500U);
}

TEST(Collapse, KeepsTheEdgesAtTheVertexThatStays) {
  for (const Shape& shape : shapes_to_collapse()) {
    const Mesh original = reference_build(shape);
    for (const Halfedge h : original.halfedges()) {
      Mesh mesh = copy_of(original);
      if (!collapse(mesh, h).ok()) continue;
      for (const Edge e : original.edges()) {
        const bool at_b =
            original.to_vertex(original.edge_halfedge(e, 0)) == original.to_vertex(h) ||
            original.to_vertex(original.edge_halfedge(e, 1)) == original.to_vertex(h);
        ASSERT_EQ(mesh.is_live(e) || !at_b, e != original.edge(h)) << shape.name;
      }
    }
  }
}

TEST(Collapse, IsUndoneBySplitVertex) {
  for (const Shape& shape : shapes_to_collapse()) {
    SCOPED_TRACE(shape.name);
    const Mesh original = reference_build(shape);
    for (const Halfedge h : original.halfedges()) {
      if (!is_collapse_ok(original, h, LinkCondition::kPermissive)) continue;
      const Halfedge hl = original.next(h);
      const Halfedge hr = original.opposite(original.prev(original.opposite(h)));
      const SplitSides sides = sides_of(original, h);
      Mesh mesh = copy_of(original);
      ASSERT_TRUE(collapse(mesh, h, {}, LinkCondition::kPermissive).ok());
      const Result<Vertex> again = split_vertex(mesh, hl, hr, {}, sides);
      ASSERT_TRUE(again.ok()) << again.error().message;
      EXPECT_EQ(again.value(), original.from_vertex(h));
      EXPECT_EQ(polys_of(mesh), polys_of(original));
      EXPECT_FALSE(has_errors(validate(mesh)));
      if (HasFailure()) return;
    }
  }
}

TEST(SplitVertex, IsUndoneByCollapseWhereverItIsAllowed) {
  std::size_t done = 0;
  for (const Shape& shape : shapes_to_collapse()) {
    if (shape.faces.size() > 14) continue;  // cubic
    SCOPED_TRACE(shape.name);
    Mesh original = reference_build(shape);
    add_attributes_of_all_kinds(original);
    for (const Halfedge hl : original.halfedges()) {
      const Vertex v = original.from_vertex(hl);
      for (const Halfedge hr : original.outgoing_cw(v)) {
        for (int i = 0; i < 9; ++i) {
          const SplitSides sides{SplitSide(i % 3), SplitSide(i / 3)};
          Mesh mesh;
          if (!holds_contract(
                  original, [&](const Mesh& m) { return check_split_vertex(m, hl, hr, sides); },
                  [&](Mesh& m) { return split_vertex(m, hl, hr, {}, sides); }, mesh)) {
            continue;
          }
          ++done;
          const Vertex w(original.vertex_slots());
          const Halfedge back = mesh.find_halfedge(w, v);
          ASSERT_TRUE(back.valid());
          // Halfedges strictly between hl and hr leave the new vertex, others don't.
          for (Halfedge g = original.rotate_cw(hr); g != hl; g = original.rotate_cw(g)) {
            EXPECT_EQ(mesh.from_vertex(g), w);
          }
          EXPECT_EQ(mesh.from_vertex(hl), v);
          EXPECT_EQ(mesh.from_vertex(hr), v);
          EXPECT_EQ(sides_of(mesh, back).left == SplitSide::kTriangle,
                    sides.left == SplitSide::kTriangle ||
                        (sides.left == SplitSide::kDefault && !original.is_boundary(hl)))
              << i;
          if (original.is_manifold(v)) {
            const Result<Vertex> kept = collapse(mesh, back, {}, LinkCondition::kPermissive);
            ASSERT_TRUE(kept.ok()) << kept.error().message;
            EXPECT_EQ(kept.value(), v);
            EXPECT_EQ(polys_of(mesh), polys_of(original));
            EXPECT_EQ(LiveItems(mesh).faces, LiveItems(original).faces);
          }
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(done, 2000U);
}

// ---- refusals -------------------------------------------------------------------------------

/// The error of a collapse of the halfedge between two vertices, which must change nothing.
Error refusal_of(const Shape& shape, Index from, Index to) {
  Mesh mesh = reference_build(shape);
  add_attributes_of_all_kinds(mesh);
  EXPECT_TRUE(mesh.enable_history());
  const Snapshot before(mesh);
  const Result<Vertex> result = collapse(mesh, halfedge(mesh, from, to), Point{1, 2, 3});
  EXPECT_FALSE(result.ok());
  if (result.ok()) return {};
  expect_refused(result, result.error().code, mesh, before);
  EXPECT_EQ(check_collapse(mesh, halfedge(mesh, from, to)).error().message, result.error().message);
  EXPECT_EQ(mesh.history()->undo_count(), 0U);
  return result.error();
}

Index edge(const Shape& shape, Index from, Index to) {
  const Mesh mesh = reference_build(shape);
  return mesh.edge(halfedge(mesh, from, to)).index();
}

TEST(Collapse, RefusesAHalfedgeThatIsNotThere) {
  Mesh mesh = reference_build(triangle_grid(2, 2));
  const Halfedge h(6);
  ASSERT_TRUE(collapse(mesh, Halfedge(0)).ok());
  const Snapshot before(mesh);
  expect_refused(collapse(mesh, Halfedge(0)), "not-a-halfedge", mesh, before);
  expect_refused(collapse(mesh, Halfedge(999)), "not-a-halfedge", mesh, before);
  expect_refused(collapse(mesh, Halfedge{}), "not-a-halfedge", mesh, before);
  EXPECT_TRUE(mesh.is_live(h));
}

TEST(Collapse, RefusesToPinchTheBoundary) {
  const Error error = refusal_of(two_triangles(), 0, 2);
  EXPECT_EQ(error.code, "boundary-vertices");
  EXPECT_EQ(error.witness, (Witness{.vertices = {0, 2}, .edges = {edge(two_triangles(), 0, 2)}}));
}

TEST(Collapse, RefusesTrianglesOnTheSameCorners) {
  const Error error = refusal_of(pillow(), 0, 1);
  EXPECT_EQ(error.code, "same-vertex");
  EXPECT_EQ(error.witness, (Witness{.vertices = {2}, .edges = {edge(pillow(), 0, 1)}}));
}

TEST(Collapse, RefusesToLeaveAnEdgeWithoutFace) {
  for (const auto& [from, to] : {std::pair<Index, Index>{0, 1}, {1, 0}}) {
    const Error error = refusal_of(triangle(), from, to);
    EXPECT_EQ(error.code, "edge-without-face");
    std::vector<Index> edges = {edge(triangle(), 1, 2), edge(triangle(), 2, 0)};
    std::vector<Index> witness = error.witness.edges;
    std::sort(witness.begin(), witness.end());
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(witness, edges);
    EXPECT_EQ(error.witness.faces, std::vector<Index>{0});
  }
}

TEST(Collapse, NamesTheExtraNeighbourAndItsEdges) {
  // The equator of the bipyramid is a triangle without a face.
  const Error error = refusal_of(bipyramid(), 0, 1);
  EXPECT_EQ(error.code, "common-neighbour");
  EXPECT_EQ(error.witness, (Witness{.vertices = {2},
                                    .edges = {edge(bipyramid(), 0, 2), edge(bipyramid(), 1, 2)}}));
}

TEST(Collapse, NamesTheFaceThatHasBothEnds) {
  // A hexagon that has both ends of an edge at opposite corners, on a closed mesh.
  const Shape closed{"hexagon across",
                     8,
                     {{0, 2, 4, 1, 5, 3},
                      {0, 1, 6},
                      {1, 0, 7},
                      {0, 6, 2},
                      {6, 4, 2},
                      {6, 1, 4},
                      {0, 3, 7},
                      {7, 3, 5},
                      {7, 5, 1}}};
  const Error across = refusal_of(closed, 0, 1);
  EXPECT_EQ(across.code, "repeated-vertex");
  EXPECT_EQ(across.witness, (Witness{.vertices = {0, 1}, .faces = {0}}));
}

TEST(Collapse, NamesTheFacesThatWouldFold) {
  const Error tetra = refusal_of(tetrahedron(), 0, 1);  // 0 1 2, 0 2 3, 0 3 1, 1 3 2
  EXPECT_EQ(tetra.code, "leaves-pillow");
  EXPECT_EQ(tetra.witness, (Witness{.edges = {edge(tetrahedron(), 0, 1)}, .faces = {1, 3}}));
  EXPECT_EQ(refusal_of(tetrahedron_with_five_vertices(), 0, 1).code, "leaves-pillow");
  EXPECT_EQ(refusal_of(quad_pillow(), 0, 1).code, "leaves-pillow");
  EXPECT_EQ(refusal_of(folded_quad(), 0, 1).code, "leaves-pillow");
  EXPECT_EQ(refusal_of(folded_quad(), 1, 0).code, "leaves-pillow");
}

TEST(Collapse, FindsACommonNeighbourAmongHundreds) {
  // Two hubs joined by an edge, each with its own fan, and one neighbour in common far away from
  // the edge: a triangle without a face.
  for (const Index common : {0U, 1U}) {
    std::vector<std::vector<Index>> faces;
    const Index sides = 200;
    for (Index i = 0; i < sides; ++i) faces.push_back({0, 2 + i, 2 + (i + 1) % sides});
    faces.erase(faces.begin() + 100);  // between 102 and 103
    // Beside that gap the second hub, 1.
    faces.push_back({0, 102, 1});
    faces.push_back({0, 1, 103});
    if (common == 1) faces.push_back({1, 102, 202}), faces.push_back({1, 202, 20});
    const Shape shape{"hubs", 203, faces};
    if (common == 1) {
      const Error error = refusal_of(shape, 0, 1);
      EXPECT_EQ(error.code, "common-neighbour");
      EXPECT_EQ(error.witness.vertices, std::vector<Index>{20});
    } else {
      EXPECT_TRUE(check_collapse(reference_build(shape), halfedge(reference_build(shape), 0, 1)));
    }
  }
}

TEST(SplitVertex, RefusesWithAWitness) {
  Mesh mesh = reference_build(mixed_polygons());
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  const Halfedge h01 = halfedge(mesh, 0, 1);
  const Halfedge h02 = halfedge(mesh, 0, 2);
  const Halfedge h12 = halfedge(mesh, 1, 2);
  const Halfedge h17 = halfedge(mesh, 1, 7);
  const Halfedge h71 = mesh.opposite(h17);
  const auto error_of = [&](Halfedge hl, Halfedge hr, const char* code, SplitSides sides = {}) {
    const Result<Vertex> result = split_vertex(mesh, hl, hr, {}, sides);
    expect_refused(result, code, mesh, before);
    return result.ok() ? Error{} : result.error();
  };
  constexpr SplitSides kCorners{SplitSide::kCorner, SplitSide::kCorner};
  constexpr SplitSides kTriangles{SplitSide::kTriangle, SplitSide::kTriangle};
  EXPECT_EQ(error_of(h01, Halfedge(500), "not-a-halfedge").witness.halfedges[0], 500U);
  EXPECT_EQ(error_of(Halfedge(500), h01, "not-a-halfedge").witness.halfedges[0], 500U);
  EXPECT_EQ(error_of(h01, h12, "different-vertices").witness,
            (Witness{.vertices = {0, 1}, .halfedges = {h01.index(), h12.index()}}));
  EXPECT_EQ(error_of(h01, h01, "same-vertex", kTriangles).witness,
            (Witness{.vertices = {1}, .halfedges = {h01.index()}}));
  // From 0-1 counter-clockwise to 0-2 lies the triangle 0 1 2.
  EXPECT_EQ(error_of(h01, h02, "nothing-between", kCorners).witness,
            (Witness{.vertices = {}, .halfedges = {h01.index(), h02.index()}}));
  // 1-7 bounds the hexagon; 6-1 and 1-7 lie on the boundary.
  const Halfedge h16 = mesh.is_boundary(h17) ? Halfedge{} : halfedge(mesh, 1, 6);
  ASSERT_TRUE(mesh.is_boundary(h71) && mesh.is_boundary(h16));
  EXPECT_EQ(error_of(h16, h17, "nothing-between").witness.halfedges,
            (std::vector<Index>{h16.index(), h17.index()}));
}

TEST(SplitVertex, RefusesAnEdgeThatWouldHaveTheBoundaryOnBothSides) {
  Mesh mesh = reference_build(pinched(2));  // 0 1 2 and 0 3 4
  const Snapshot before(mesh);
  const Halfedge first = mesh.vertex_halfedge(Vertex(0));
  Halfedge second = mesh.rotate_cw(first);
  while (!mesh.is_boundary(second)) second = mesh.rotate_cw(second);
  const Halfedge hr = mesh.opposite(mesh.prev(second));
  ASSERT_TRUE(mesh.is_boundary(first) && mesh.is_boundary(mesh.opposite(hr)));
  const Result<Vertex> result = split_vertex(mesh, first, hr);
  expect_refused(result, "edge-without-face", mesh, before);
  EXPECT_EQ(result.error().witness,
            (Witness{.vertices = {0}, .halfedges = {first.index(), hr.index()}}));
}

// Where one end has hundreds of neighbours, those of the other end are asked: with a chord across a
// disk from some vertices, and a wheel on the other side whose hub may have fewer or more.
TEST(Collapse, FindsCommonNeighboursOfAVertexOfHighValence) {
  std::vector<Shape> shapes;
  Shape chords = disk(200);
  std::vector<std::vector<Index>> faces = chords.faces;
  for (Index v = 5; v < 80; v += 10) faces.push_back({v, 200 - v, 200 + v});
  shapes.emplace_back("disk with chords", 300, faces);
  for (const Index other : {30U, 69U, 100U, 140U}) {
    faces = disk(100).faces;
    for (Index i = 0; i < other; ++i) {
      const Index v = 1 + i % 100;
      const Index w = 1 + (i + 1) % 100;
      if (i < 100) faces.push_back({w, v, 101});
    }
    for (Index i = 100; i < other; ++i) faces.push_back({101, 102 + 2 * i, 103 + 2 * i});
    if (other > 100) faces.erase(faces.begin() + 100);
    shapes.emplace_back("disk on " + std::to_string(other), 400, faces);
  }
  std::size_t blocked = 0;
  std::size_t allowed = 0;
  for (const Shape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = reference_build(shape);
    for (const Halfedge h : mesh.halfedges()) {
      const Vertex a = mesh.from_vertex(h);
      const Vertex b = mesh.to_vertex(h);
      const auto is_apex = [&](Vertex v) {
        for (const Halfedge side : {h, mesh.opposite(h)}) {
          if (!mesh.is_boundary(side) && mesh.to_vertex(mesh.next(side)) == v) return true;
        }
        return false;
      };
      std::set<Index> common;
      for (const Vertex v : mesh.vertex_vertices_ccw(a)) {
        if (mesh.find_edge(v, b).valid() && !is_apex(v)) common.insert(v.index());
      }
      const Result<void> can = check_collapse(mesh, h);
      EXPECT_EQ(is_collapse_ok(mesh, h), can.ok());
      if (can) {
        EXPECT_TRUE(common.empty()) << h.index();
        ++allowed;
      } else if (can.error().code == "common-neighbour") {
        EXPECT_EQ(common.count(can.error().witness.vertices[0]), 1U) << h.index();
        ++blocked;
      }
    }
  }
  EXPECT_GT(allowed, 500U);
  EXPECT_GT(blocked, 30U);
}

}  // namespace
}  // namespace halfedge::test
