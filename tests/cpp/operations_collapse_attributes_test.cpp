// Positions and attributes where edges are collapsed and vertices split.

#include <gtest/gtest.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/split_vertex.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "support/collapsing.h"
#include "support/complexes.h"
#include "support/face_lists.h"

namespace halfedge::test {
namespace {

using operations::collapse;
using operations::split_vertex;
using operations::SplitSide;
using operations::SplitSides;

constexpr AttributeOptions kNumber{.type = Scalar::kFloat64};

Attribute& add_number(Mesh& mesh, ItemKind kind, const char* name, OnSplit policy) {
  AttributeOptions options = kNumber;
  options.on_split = policy;
  return *mesh.add_attribute(kind, name, options).value();
}

TEST(Collapse, LeavesTheVertexWhereItIsOrBlendsAtThePosition) {
  Mesh mesh = reference_build(octahedron());
  Attribute& heat = add_number(mesh, ItemKind::kVertex, "heat", OnSplit::kInterpolate);
  Attribute& label = add_number(mesh, ItemKind::kVertex, "label", OnSplit::kCopy);
  Attribute& mark = add_number(mesh, ItemKind::kVertex, "mark", OnSplit::kDefault);
  for (Attribute* column : {&heat, &label, &mark}) {
    for (Index v = 0; v < 6; ++v) column->set(v, 0, 10 * v, nullptr);
  }
  const Halfedge h = halfedge(mesh, 1, 2);
  const struct {
    std::optional<Point> position;
    Point expected;
    double heat, label;
  } cases[] = {{{}, {2, 0, 0}, 20, 20},
               {Point{1.25F, 3, 0}, {1.25F, 3, 0}, 12.5, 10},
               {Point{1.75F, -3, 0}, {1.75F, -3, 0}, 17.5, 20},
               {Point{-7, 0, 0}, {-7, 0, 0}, 10, 10},
               {Point{9, 0, 0}, {9, 0, 0}, 20, 20}};
  for (const auto& each : cases) {
    Mesh copy = copy_of(mesh);
    copy.set_position(Vertex(1), {1, 0, 0});
    copy.set_position(Vertex(2), {2, 0, 0});
    ASSERT_TRUE(collapse(copy, h, each.position).ok());
    EXPECT_EQ(copy.position(Vertex(2)), each.expected);
    EXPECT_EQ(copy.find_attribute(ItemKind::kVertex, "heat")->get(2, 0), each.heat);
    EXPECT_EQ(copy.find_attribute(ItemKind::kVertex, "label")->get(2, 0), each.label);
    EXPECT_EQ(copy.find_attribute(ItemKind::kVertex, "mark")->get(2, 0), 20);
  }
}

TEST(Collapse, MovesTheCornersOfEachSideOfASeam) {
  // The edge 1-2 of an octahedron is a seam between the charts of 0 (values v) and of 5 (100 + v).
  Mesh mesh = reference_build(octahedron());
  Attribute& uv = add_number(mesh, ItemKind::kHalfedge, "uv", OnSplit::kInterpolate);
  Attribute& own = add_number(mesh, ItemKind::kHalfedge, "own", OnSplit::kCopy);
  const auto chart = [](Face f) { return f.index() < 4 ? 0.0 : 100.0; };
  for (const Halfedge h : mesh.halfedges()) {
    uv.set(h.index(), 0, chart(mesh.face(h)) + mesh.to_vertex(h).index(), nullptr);
    own.set(h.index(), 0, h.index(), nullptr);
  }
  const Halfedge odd = mesh.opposite(halfedge(mesh, 1, 4));  // one corner belongs to neither
  uv.set(odd.index(), 0, 50, nullptr);
  mesh.set_position(Vertex(1), {1, 0, 0});
  mesh.set_position(Vertex(2), {2, 0, 0});
  const Vertex two(2);
  for (const bool moves : {false, true}) {
    Mesh copy = copy_of(mesh);
    const auto position = moves ? std::optional<Point>(Point{1.5F, 0, 0}) : std::nullopt;
    ASSERT_TRUE(collapse(copy, halfedge(mesh, 1, 2), position).ok());
    const Attribute& after = *copy.find_attribute(ItemKind::kHalfedge, "uv");
    for (const Halfedge h : copy.halfedges()) {
      const double at = copy.to_vertex(h) == two && moves ? 1.5 : copy.to_vertex(h).index();
      const double expected = h == odd ? 50 : chart(copy.face(h)) + at;
      EXPECT_EQ(after.get(h.index(), 0), expected) << h.index();
      EXPECT_EQ(copy.find_attribute(ItemKind::kHalfedge, "own")->get(h.index(), 0), h.index());
    }
  }
}

TEST(Collapse, LeavesEachCornerToTheFaceItLiesIn) {
  // A chart for each face: no corner at 1 has the value of one beside the edge.
  Mesh mesh = reference_build(octahedron());
  Attribute& uv = add_number(mesh, ItemKind::kHalfedge, "uv", OnSplit::kInterpolate);
  for (const Halfedge h : mesh.halfedges()) {
    uv.set(h.index(), 0, 10 * mesh.face(h).index() + mesh.to_vertex(h).index(), nullptr);
  }
  const Mesh before = copy_of(mesh);
  ASSERT_TRUE(collapse(mesh, halfedge(mesh, 1, 2)).ok());
  for (const Halfedge h : mesh.halfedges()) {
    const std::vector<Index> corners = corners_of(before, before.face_halfedge(mesh.face(h)));
    const bool had_1 = std::count(corners.begin(), corners.end(), 1U) > 0;
    const Index v = had_1 && mesh.to_vertex(h) == Vertex(2) ? 1 : mesh.to_vertex(h).index();
    EXPECT_EQ(uv.get(h.index(), 0), 10 * mesh.face(h).index() + v) << h.index();
  }
}

TEST(SplitVertex, GivesNewItemsTheAttributesBesideThem) {
  Mesh mesh = reference_build(octahedron());
  add_attributes_of_all_kinds(mesh);
  Attribute& uv = add_number(mesh, ItemKind::kHalfedge, "uv", OnSplit::kInterpolate);
  for (const Halfedge h : mesh.halfedges()) {
    uv.set(h.index(), 0, 10 * mesh.face(h).index() + mesh.to_vertex(h).index(), nullptr);
  }
  const Halfedge hl = halfedge(mesh, 0, 1);
  const Halfedge hr = halfedge(mesh, 0, 3);
  const Halfedge moved = halfedge(mesh, 0, 2);
  const Face left = mesh.face(hl);
  const Face right = mesh.face(mesh.opposite(hr));
  const Mesh before = copy_of(mesh);
  const Vertex w = split_vertex(mesh, hl, hr).value();
  EXPECT_EQ(mesh.position(w), before.position(Vertex(0)));
  EXPECT_EQ(mesh.from_vertex(moved), w);

  const Halfedge up = halfedge(mesh, w.index(), 0);
  const Halfedge at_left = halfedge(mesh, w.index(), 1);
  const Halfedge at_right = halfedge(mesh, w.index(), 3);
  EXPECT_EQ(mesh.face(at_left), left) << "the old face lies beyond the new edge";
  EXPECT_EQ(mesh.face(mesh.opposite(at_right)), right);
  EXPECT_EQ(polys_of(mesh), in_order({{0, 1, 6},
                                      {6, 1, 2},
                                      {6, 2, 3},
                                      {0, 6, 3},
                                      {0, 3, 4},
                                      {0, 4, 1},
                                      {5, 2, 1},
                                      {5, 3, 2},
                                      {5, 4, 3},
                                      {5, 1, 4}}));
  const auto same = [&](ItemKind kind, Index item, Index of, std::size_t column) {
    const Attribute& now = *mesh.attributes().of(kind)[column];
    const Attribute& old = *before.attributes().of(kind)[column];
    bool all = true;
    for (Index i = 0; i < now.components(); ++i) all = all && now.get(item, i) == old.get(of, i);
    return all;
  };
  for (const std::size_t column : {0U, 1U, 2U}) {
    EXPECT_TRUE(same(ItemKind::kVertex, w.index(), 0, column));
    EXPECT_TRUE(same(ItemKind::kFace, mesh.face(up).index(), left.index(), column));
    EXPECT_TRUE(same(ItemKind::kFace, mesh.face(mesh.opposite(up)).index(), right.index(), column));
    EXPECT_TRUE(same(ItemKind::kEdge, mesh.edge(at_left).index(), mesh.edge(hl).index(), column));
    EXPECT_TRUE(same(ItemKind::kEdge, mesh.edge(at_right).index(), mesh.edge(hr).index(), column));
  }
  EXPECT_TRUE(same(ItemKind::kHalfedge, at_left.index(), hl.index(), 2));
  EXPECT_TRUE(same(ItemKind::kHalfedge, at_right.index(), hr.index(), 2));
  EXPECT_EQ(mesh.attributes().of(ItemKind::kEdge)[0]->get(mesh.edge(up).index(), 0), 0);
  EXPECT_EQ(mesh.attributes().of(ItemKind::kFace)[3]->get(mesh.face(up).index(), 0), 0);
  // Each corner has a value of the face that it was cut from.
  const Attribute& now = *mesh.find_attribute(ItemKind::kHalfedge, "uv");
  for (const Halfedge h : mesh.halfedges()) {
    const Face f = mesh.face(h) == mesh.face(up)                  ? left
                   : mesh.face(h) == mesh.face(mesh.opposite(up)) ? right
                                                                  : mesh.face(h);
    const Index v = mesh.to_vertex(h) == w ? 0 : mesh.to_vertex(h).index();
    EXPECT_EQ(now.get(h.index(), 0), 10 * f.index() + v) << h.index();
  }
}

TEST(SplitVertex, FillsTheBoundaryWithTrianglesIfAsked) {
  // At vertex 0 of two triangles: one triangle on each side, beyond the boundary.
  Mesh mesh = reference_build(two_triangles());  // 0 1 2, 0 2 3
  Attribute& uv = add_number(mesh, ItemKind::kHalfedge, "uv", OnSplit::kInterpolate);
  for (const Halfedge h : mesh.halfedges()) {
    const double face = mesh.is_boundary(h) ? 999 : 10.0 * mesh.face(h).index();
    uv.set(h.index(), 0, face + mesh.to_vertex(h).index(), nullptr);
  }
  Attribute& name = add_number(mesh, ItemKind::kFace, "name", OnSplit::kCopy);
  name.set(0, 0, 7, nullptr);
  name.set(1, 0, 8, nullptr);
  const Halfedge hl = halfedge(mesh, 0, 3);  // on the boundary
  const Halfedge hr = halfedge(mesh, 0, 1);
  ASSERT_TRUE(mesh.is_boundary(hl) && mesh.is_boundary(mesh.opposite(hr)));
  const SplitSides triangles{SplitSide::kTriangle, SplitSide::kTriangle};
  const Vertex w = split_vertex(mesh, hl, hr, Point{5, 6, 7}, triangles).value();
  EXPECT_EQ(mesh.position(w), (Point{5, 6, 7}));
  EXPECT_EQ(polys_of(mesh), in_order({{0, 1, 2}, {0, 2, 3}, {4, 0, 3}, {0, 4, 1}}));
  EXPECT_FALSE(has_errors(validate(mesh)));
  const Halfedge up = halfedge(mesh, 4, 0);
  const Attribute& names = *mesh.find_attribute(ItemKind::kFace, "name");
  EXPECT_EQ(names.get(mesh.face(up).index(), 0), 8);
  EXPECT_EQ(names.get(mesh.face(mesh.opposite(up)).index(), 0), 7);
  const Attribute& corners = *mesh.find_attribute(ItemKind::kHalfedge, "uv");
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) continue;
    const Index v = mesh.to_vertex(h) == w ? 0 : mesh.to_vertex(h).index();
    const bool in_second = mesh.face(h) == Face(1) || mesh.face(h) == mesh.face(up);
    EXPECT_EQ(corners.get(h.index(), 0), (in_second ? 10 : 0) + v) << h.index();
  }
}

}  // namespace
}  // namespace halfedge::test
