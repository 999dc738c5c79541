#include <gtest/gtest.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/split_vertex.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/face_lists.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using operations::check_collapse;
using operations::collapse;
using operations::is_collapse_ok;
using operations::LinkCondition;
using operations::split_vertex;
using operations::SplitSide;
using operations::SplitSides;

Shape octahedron() {
  return {"octahedron",
          6,
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}};
}
Shape bipyramid() {
  return {"bipyramid", 5, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
}
Shape two_triangles() { return {"two triangles", 4, {{0, 1, 2}, {0, 2, 3}}}; }
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
FaceList collapsed(const FaceList& faces, Index a, Index b) {
  FaceList result;
  for (std::vector<Index> face : faces) {
    std::replace(face.begin(), face.end(), a, b);
    face.erase(std::unique(face.begin(), face.end()), face.end());
    if (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() > 2) result.push_back(face);
  }
  return in_order(result);
}

bool has_pillow(const FaceList& faces) {
  std::set<std::set<Index>> seen;
  for (const std::vector<Index>& face : faces) {
    if (!seen.insert(std::set<Index>(face.begin(), face.end())).second) return true;
  }
  return false;
}

/// The decision by hand: the list that is left must be a manifold with as many edges and fans as
/// there should be.
bool may_collapse(const FaceList& before, Index a, Index b, LinkCondition condition) {
  const FaceList after = collapsed(before, a, b);
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
  for (const Shape& shape : shapes_to_collapse()) {
    SCOPED_TRACE(shape.name);
    const Mesh original = reference_build(shape);
    const FaceList before = face_list(original);
    for (const LinkCondition condition : {LinkCondition::kStrict, LinkCondition::kPermissive}) {
      for (const Halfedge h : original.halfedges()) {
        const Index a = original.from_vertex(h).index();
        const Index b = original.to_vertex(h).index();
        SCOPED_TRACE(std::to_string(a) + " into " + std::to_string(b));
        const bool expected = may_collapse(before, a, b, condition);
        ASSERT_EQ(is_collapse_ok(original, h, condition), expected);
        ASSERT_EQ(check_collapse(original, h, condition).ok(), expected);
        Mesh mesh = copy_of(original);
        const Result<Vertex> survivor = collapse(mesh, h, {}, condition);
        ASSERT_EQ(survivor.ok(), expected);
        if (!expected) {
          ASSERT_TRUE(Snapshot(mesh) == Snapshot(original));
          continue;
        }
        EXPECT_EQ(survivor.value(), Vertex(b));
        EXPECT_TRUE(mesh.is_deleted(Vertex(a)));
        EXPECT_EQ(face_list(mesh), collapsed(before, a, b));
        expect_valid_mesh(mesh);
        if (HasFailure()) return;
      }
    }
  }
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
      EXPECT_EQ(face_list(mesh), face_list(original));
      expect_valid_mesh(mesh);
      if (HasFailure()) return;
    }
  }
}

TEST(SplitVertex, IsUndoneByCollapseWhereverItIsAllowed) {
  std::size_t done = 0;
  for (const Shape& shape : shapes_to_collapse()) {
    if (shape.faces.size() > 20) continue;  // cubic
    SCOPED_TRACE(shape.name);
    const Mesh original = reference_build(shape);
    for (const Halfedge hl : original.halfedges()) {
      const Vertex v = original.from_vertex(hl);
      for (const Halfedge hr : original.outgoing_cw(v)) {
        for (int i = 0; i < 9; ++i) {
          const SplitSides sides{SplitSide(i % 3), SplitSide(i / 3)};
          Mesh mesh = copy_of(original);
          const bool can = check_split_vertex(mesh, hl, hr, sides).ok();
          const Result<Vertex> w = split_vertex(mesh, hl, hr, {}, sides);
          ASSERT_EQ(w.ok(), can);
          if (!can) {
            ASSERT_TRUE(Snapshot(mesh) == Snapshot(original));
            continue;
          }
          ++done;
          expect_valid_mesh(mesh);
          const Halfedge back = mesh.find_halfedge(w.value(), v);
          ASSERT_TRUE(back.valid());
          // Halfedges strictly between hl and hr leave the new vertex, others don't.
          for (Halfedge g = original.rotate_cw(hr); g != hl; g = original.rotate_cw(g)) {
            EXPECT_EQ(mesh.from_vertex(g), w.value());
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
            EXPECT_EQ(face_list(mesh), face_list(original));
            EXPECT_EQ(LiveItems(mesh).faces, LiveItems(original).faces);
          }
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(done, 2000U);
}

}  // namespace
}  // namespace halfedge::test
