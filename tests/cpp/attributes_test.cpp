#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

Attribute& add(Mesh& mesh, ItemKind kind, const std::string& name,
               const AttributeOptions& options = {}) {
  const Result<Attribute*> column = mesh.add_attribute(kind, name, options);
  EXPECT_TRUE(column.ok());
  return *column.value();
}

TEST(Attributes, HaveTheirDefaultInEverySlotOldAndNew) {
  Mesh mesh = reference_build(tetrahedron());
  const double red[] = {255, 0, 300};  // beyond what a byte holds
  Attribute& color = add(mesh, ItemKind::kVertex, "color",
                         {.type = Scalar::kUint8, .components = 3, .default_value = red});
  ASSERT_EQ(color.values<std::uint8_t>().size(), 12U);
  const Vertex v = mesh.add_vertex({1, 2, 3});
  for (const Vertex each : mesh.vertices()) {
    EXPECT_EQ(color.get(each.index(), 0), 255);
    EXPECT_EQ(color.get(each.index(), 2), 255) << "kept in the range of the type";
  }
  mesh.set_attribute(color, v, 1, 77.4);
  EXPECT_EQ(color.get(v.index(), 1), 77);
  mesh.release(v);
  EXPECT_EQ(mesh.add_vertex({}), v);
  EXPECT_EQ(color.get(v.index(), 1), 0) << "a recycled slot begins anew";
}

TEST(Attributes, AreFoundByKindAndName) {
  Mesh mesh = reference_build(tetrahedron());
  Attribute& weight = add(mesh, ItemKind::kEdge, "weight");
  EXPECT_EQ(mesh.find_attribute(ItemKind::kEdge, "weight"), &weight);
  EXPECT_EQ(mesh.find_attribute(ItemKind::kFace, "weight"), nullptr);
  const Attribute* read_only = std::as_const(mesh).find_attribute(ItemKind::kEdge, "weight");
  EXPECT_EQ(read_only, &weight);
  EXPECT_TRUE(mesh.remove_attribute(ItemKind::kEdge, "weight"));
  EXPECT_FALSE(mesh.remove_attribute(ItemKind::kEdge, "weight"));
  EXPECT_FALSE(mesh.attributes().has_any());
}

TEST(Attributes, AreAsConstAsTheirMesh) {
  Mesh mesh = reference_build(tetrahedron());
  Attribute& weight = add(mesh, ItemKind::kEdge, "weight");
  const auto& read_only = mesh.attributes().of(ItemKind::kEdge)[0];
  static_assert(std::is_same_v<decltype(*read_only), const Attribute&>);
  static_assert(std::is_same_v<decltype(read_only.get()), const Attribute*>);
  static_assert(std::is_same_v<decltype(read_only->bytes()), std::span<const std::byte>>);
  for (Attributes::Column& column : mesh.columns(ItemKind::kEdge)) column->values<float>()[2] = 5;
  EXPECT_EQ(weight.get(2, 0), 5);
  EXPECT_EQ(read_only->get(2, 0), 5);
}

TEST(Attributes, AreRefusedWithASentence) {
  Mesh mesh = reference_build(tetrahedron());
  add(mesh, ItemKind::kFace, "group");
  const auto code_of = [&](ItemKind kind, const char* name, const AttributeOptions& options) {
    const Result<Attribute*> refused = mesh.add_attribute(kind, name, options);
    return refused ? "added" : refused.error().code;
  };
  const double two[] = {1, 2};
  EXPECT_EQ(code_of(ItemKind::kFace, "group", {}), "attribute-exists");
  EXPECT_EQ(code_of(ItemKind::kFace, "", {}), "bad-attribute");
  EXPECT_EQ(code_of(ItemKind::kMesh, "name", {}), "bad-attribute");
  EXPECT_EQ(code_of(ItemKind::kFace, "none", {.components = 0}), "bad-attribute");
  EXPECT_EQ(code_of(ItemKind::kFace, "many", {.components = 17}), "bad-attribute");
  EXPECT_EQ(code_of(ItemKind::kFace, "two", {.default_value = two}), "bad-attribute");
  EXPECT_EQ(code_of(ItemKind::kFace, "stamp", {.type = Scalar::kUint32, .is_generation = true}),
            "bad-attribute");
  EXPECT_EQ(code_of(ItemKind::kFace, "", {.type = Scalar::kInt8, .is_generation = true}),
            "bad-attribute");
  EXPECT_EQ(mesh.attributes().of(ItemKind::kFace).size(), 1U);
}

TEST(Attributes, OfTheMeshItselfAreNotFound) {
  Mesh mesh = reference_build(tetrahedron());
  add(mesh, ItemKind::kFace, "name");
  EXPECT_TRUE(mesh.remove_attribute(ItemKind::kFace, "name"));
  EXPECT_TRUE(mesh.attributes().of(ItemKind::kMesh).empty());
  EXPECT_EQ(mesh.find_attribute(ItemKind::kMesh, "name"), nullptr);
  EXPECT_FALSE(mesh.remove_attribute(ItemKind::kMesh, "name"));
}

TEST(Attributes, OfANewItemAreWhatThePolicySays) {
  Mesh mesh = reference_build(tetrahedron());
  Attribute& mean = add(mesh, ItemKind::kVertex, "mean");
  Attribute& rounded = add(mesh, ItemKind::kVertex, "rounded", {.type = Scalar::kInt8});
  Attribute& normal =
      add(mesh, ItemKind::kVertex, "normal", {.components = 2, .on_split = OnSplit::kNormalize});
  Attribute& copied = add(mesh, ItemKind::kVertex, "copied", {.on_split = OnSplit::kCopy});
  const double seven[] = {7};
  Attribute& fresh = add(mesh, ItemKind::kVertex, "fresh",
                         {.on_split = OnSplit::kDefault, .default_value = seven});
  const Vertex a = mesh.from_vertex(Halfedge(0));
  const Vertex b = mesh.to_vertex(Halfedge(0));
  for (Attribute* column : {&mean, &rounded, &copied, &fresh}) {
    mesh.set_attribute(*column, a, 0, 10);
    mesh.set_attribute(*column, b, 0, 21);
  }
  mesh.set_attribute(normal, a, 0, 1);
  mesh.set_attribute(normal, b, 1, 1);

  const Result<Halfedge> half = decorator::split_edge(mesh, Halfedge(0), 0.25);
  ASSERT_TRUE(half);
  const Index w = mesh.to_vertex(half.value()).index();
  EXPECT_FLOAT_EQ(float(mean.get(w, 0)), 12.75F);
  EXPECT_EQ(rounded.get(w, 0), 13);
  EXPECT_NEAR(normal.get(w, 0), 3 / std::sqrt(10), 1e-6);
  EXPECT_NEAR(normal.get(w, 1), 1 / std::sqrt(10), 1e-6);
  EXPECT_EQ(copied.get(w, 0), 10) << "the nearer end";
  EXPECT_EQ(fresh.get(w, 0), 7);
}

TEST(Attributes, OfHalvesOfAnEdgeAreThoseOfTheEdgeAndOfItsCorners) {
  Mesh mesh = reference_build(triangle_grid(1, 1));
  Attribute& crease = add(mesh, ItemKind::kEdge, "crease", {.on_split = OnSplit::kCopy});
  Attribute& flow = add(mesh, ItemKind::kHalfedge, "flow", {.on_split = OnSplit::kCopy});
  Attribute& uv = add(mesh, ItemKind::kHalfedge, "uv");
  for (const Halfedge h : mesh.halfedges()) {
    mesh.set_attribute(flow, h, 0, h.index());
    mesh.set_attribute(uv, h, 0, 100 * h.index());
  }
  const Halfedge h(0);
  const Halfedge o(1);
  mesh.set_attribute(crease, mesh.edge(h), 0, 5);
  const double uv_before_h = uv.get(mesh.prev(h).index(), 0);
  const double uv_before_o = uv.get(mesh.prev(o).index(), 0);

  const Result<Halfedge> half = decorator::split_edge(mesh, h, 0.5);
  ASSERT_TRUE(half);
  const Halfedge k = half.value();
  EXPECT_EQ(crease.get(mesh.edge(k).index(), 0), 5);
  EXPECT_EQ(flow.get(k.index(), 0), 0);
  EXPECT_EQ(flow.get(mesh.opposite(k).index(), 0), 1);
  EXPECT_EQ(flow.get(o.index(), 0), 1);
  EXPECT_EQ(uv.get(h.index(), 0), 0) << "the corner at the end stays";
  EXPECT_EQ(uv.get(mesh.opposite(k).index(), 0), 100) << "the corner at the beginning too";
  EXPECT_EQ(uv.get(k.index(), 0), uv_before_h / 2) << "of the corners of one face";
  EXPECT_EQ(uv.get(o.index(), 0), (100 + uv_before_o) / 2) << "and of the other";
}

TEST(Attributes, MoveWithTheirItemsWhenTheMeshIsCompacted) {
  Mesh mesh = reference_build(torus(5, 4));
  Attribute& label = add(mesh, ItemKind::kHalfedge, "label", {.type = Scalar::kUint16});
  Attribute& wide = add(mesh, ItemKind::kFace, "wide", {.type = Scalar::kFloat64, .components = 3});
  for (const Halfedge h : mesh.halfedges()) mesh.set_attribute(label, h, 0, h.index());
  for (const Face f : mesh.faces()) mesh.set_attribute(wide, f, 2, f.index());
  ASSERT_TRUE(decorator::erase_center_vertex(mesh, Halfedge(4)));
  ASSERT_TRUE(mesh.enable_history());
  const Snapshot before(mesh);
  Mesh original = copy_of(mesh);
  const Result<CompactMaps> maps = compact(mesh);
  ASSERT_TRUE(maps);
  for (const Halfedge h : original.halfedges()) {
    EXPECT_EQ(label.get(maps.value()(h).index(), 0), h.index());
  }
  for (const Face f : original.faces()) EXPECT_EQ(wide.get(maps.value()(f).index(), 2), f.index());
  const Snapshot after(mesh);
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());
  EXPECT_EQ(Snapshot(mesh), before);
  ASSERT_TRUE(mesh.redo());
  EXPECT_EQ(Snapshot(mesh), after);
}

TEST(Attributes, OfAnyWidthAreNotedInRunsWhenTheMeshIsCompacted) {
  const auto compacted = [](Mesh& mesh) {
    EXPECT_TRUE(decorator::erase_center_vertex(mesh, Halfedge(4)));
    EXPECT_TRUE(mesh.enable_history());
    const Snapshot before(mesh);
    EXPECT_TRUE(compact(mesh));
    const Snapshot after(mesh);
    mesh.end_step();
    const std::size_t bytes = mesh.history()->bytes();
    EXPECT_TRUE(mesh.undo());
    EXPECT_EQ(Snapshot(mesh), before);
    EXPECT_TRUE(mesh.redo());
    EXPECT_EQ(Snapshot(mesh), after);
    return bytes;
  };
  Mesh bare = reference_build(torus(31, 17));
  const std::size_t bytes_without = compacted(bare);
  for (const Scalar type : {Scalar::kInt8, Scalar::kUint16, Scalar::kFloat32, Scalar::kFloat64}) {
    for (Index components = 1; components <= Attribute::kMaxComponents; ++components) {
      SCOPED_TRACE(testing::Message() << components << " of " << name_of(type));
      Mesh mesh = reference_build(torus(31, 17));
      Attribute& values =
          add(mesh, ItemKind::kFace, "values", {.type = type, .components = components});
      for (const Face f : mesh.faces()) {
        for (Index i = 0; i < components; ++i) {
          mesh.set_attribute(values, f, i, (7 * f.index() + 11 * i) % 127);
        }
      }
      const std::size_t bytes = values.bytes().size();
      // Beside the values, what is between runs, and at the end of a chunk.
      EXPECT_LE(compacted(mesh), bytes_without + bytes + bytes / 8 + 320);
    }
  }
}

TEST(Attributes, AreCopiedMovedAndConvertedWithTheMesh) {
  Mesh mesh = reference_build(torus(4, 3));
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  Mesh copy = copy_of(mesh);
  EXPECT_EQ(Snapshot(copy), before);
  copy.set_attribute(*copy.find_attribute(ItemKind::kVertex, "copy"), Vertex(0), 0, 99);
  EXPECT_EQ(Snapshot(mesh), before) << "a copy has columns of its own";
  const Mesh moved = std::move(mesh);
  EXPECT_EQ(Snapshot(moved), before);
  EXPECT_FALSE(mesh.attributes().has_any());  // NOLINT(bugprone-use-after-move): it is empty

  Mesh whole = copy_of(moved);
  BasicMesh<kWithoutPrev> without_prev;
  ASSERT_TRUE(convert(std::move(whole), without_prev));
  ASSERT_TRUE(convert(std::move(without_prev), whole));
  EXPECT_EQ(Snapshot(whole), before);
}

TEST(Attributes, StayDefinedWhenTheMeshIsClearedOrBuiltAnew) {
  Mesh mesh = reference_build(tetrahedron());
  Attribute& weight = add(mesh, ItemKind::kEdge, "weight");
  mesh.clear();
  EXPECT_EQ(weight.slots(), 0U);
  const Shape shape = torus(4, 3);
  const std::vector<float> positions(3 * shape.vertices);
  std::vector<Index> sizes;
  std::vector<Index> corners;
  for (const std::vector<Index>& face : shape.faces) {
    sizes.push_back(Index(face.size()));
    corners.insert(corners.end(), face.begin(), face.end());
  }
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, {positions, sizes, corners}, report));
  EXPECT_EQ(weight.slots(), mesh.edge_slots());
}

TEST(Attributes, ThatAreRemovedAreSkippedByUndo) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_history());
  add(mesh, ItemKind::kVertex, "gone");
  const Snapshot with_column(mesh);
  ASSERT_TRUE(decorator::split_edge(mesh, Halfedge(0)));
  mesh.end_step();
  ASSERT_TRUE(mesh.remove_attribute(ItemKind::kVertex, "gone"));
  Attribute& late = add(mesh, ItemKind::kVertex, "gone");
  ASSERT_TRUE(mesh.undo());
  EXPECT_EQ(late.slots(), 4U);
  EXPECT_EQ(Snapshot(mesh), with_column);
}

TEST(Attributes, OfAMeshThatIsChangedEndWhatCouldBeRedone) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_history());
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(decorator::split_edge(mesh, Halfedge(0)));
  ASSERT_TRUE(mesh.undo());
  add(mesh, ItemKind::kHalfedge, "late");  // has no room for the items that redo would bring back
  EXPECT_FALSE(mesh.redo());
}

// ---- what operations of the decorator carry along ---------------------------------------------

/// Two triangles, each corner of which knows its vertex, and each edge its ends.
Mesh labelled_square() {
  Mesh mesh = reference_build(Shape{"square", 4, {{0, 1, 2}, {2, 1, 3}}});
  Attribute* const tips = mesh.add_attribute(ItemKind::kHalfedge, "tip").value();
  Attribute* const ends = mesh.add_attribute(ItemKind::kEdge, "ends").value();
  for (const Halfedge h : mesh.halfedges())
    tips->set(h.index(), 0, mesh.to_vertex(h).index(), nullptr);
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e);
    const auto [low, high] = std::minmax({mesh.from_vertex(h).index(), mesh.to_vertex(h).index()});
    ends->set(e.index(), 0, 10 * low + high, nullptr);
  }
  return mesh;
}

TEST(Attributes, FollowTheEdgesThatAreNumberedAnew) {
  Mesh mesh = labelled_square();
  ASSERT_FALSE(decorator::is_boundary_normalized(mesh));
  ASSERT_TRUE(decorator::normalize_boundary(mesh));
  const Attribute* const tips = mesh.find_attribute(ItemKind::kHalfedge, "tip");
  const Attribute* const ends = mesh.find_attribute(ItemKind::kEdge, "ends");
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_EQ(tips->get(h.index(), 0), mesh.to_vertex(h).index());
  }
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e);
    const auto [low, high] = std::minmax({mesh.from_vertex(h).index(), mesh.to_vertex(h).index()});
    EXPECT_EQ(ends->get(e.index(), 0), 10 * low + high);
  }
}

TEST(Attributes, OfCornersFollowAnEdgeThatTheDecoratorFlips) {
  Mesh mesh = labelled_square();
  const Halfedge h = mesh.find_halfedge(Vertex(1), Vertex(2));
  ASSERT_TRUE(decorator::flip_edge(mesh, h));
  const Attribute* const tips = mesh.find_attribute(ItemKind::kHalfedge, "tip");
  for (const Face f : mesh.faces()) {
    for (const Halfedge side : mesh.face_halfedges_ccw(f)) {
      EXPECT_EQ(tips->get(side.index(), 0), mesh.to_vertex(side).index()) << side.index();
    }
  }
}

TEST(Attributes, KeepTheLengthOfAMeshWhoseFacesAreDerived) {
  Mesh mesh = reference_build(tetrahedron());
  BasicMesh<kWithoutFaces> bare;
  ASSERT_TRUE(convert(std::move(mesh), bare));
  ASSERT_TRUE(bare.add_attribute(ItemKind::kFace, "area"));
  ASSERT_TRUE(bare.add_attribute(ItemKind::kVertex, "weight"));
  Mesh back;
  ASSERT_TRUE(convert(std::move(bare), back));
  ASSERT_EQ(back.face_slots(), 4U);
  Attribute* const area = back.find_attribute(ItemKind::kFace, "area");
  ASSERT_NE(area, nullptr);
  EXPECT_EQ(area->slots(), 4U);
  back.set_attribute(*area, Face(3), 0, 5);
  EXPECT_EQ(area->get(3, 0), 5);
  BasicMesh<kWithoutFaces> again;
  ASSERT_TRUE(convert(std::move(back), again));
  EXPECT_EQ(again.find_attribute(ItemKind::kFace, "area")->slots(), 0U);
  EXPECT_EQ(again.find_attribute(ItemKind::kVertex, "weight")->slots(), 4U);
}

template <Storage kStored>
void expect_builds_to_keep_columns() {
  BasicMesh<kStored> mesh;
  Attribute* const weight = mesh.add_attribute(ItemKind::kVertex, "weight").value();
  ASSERT_TRUE(mesh.enable_generations());
  constexpr float kPositions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  constexpr Index kCorners[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const Polygons closed{kPositions, {}, kCorners};
  BuildReport built;
  ASSERT_TRUE(build_from_polygons(mesh, closed, built));
  EXPECT_EQ(mesh.find_attribute(ItemKind::kVertex, "weight"), weight);
  EXPECT_EQ(weight->slots(), mesh.vertex_slots());
  const Index before = mesh.generation(Vertex(0));
  RepairReport repaired;
  ASSERT_TRUE(build_from_soup(mesh, closed, {}, repaired));
  EXPECT_EQ(mesh.find_attribute(ItemKind::kVertex, "weight"), weight);
  EXPECT_EQ(weight->slots(), mesh.vertex_slots());
  EXPECT_NE(mesh.generation(Vertex(0)), before);
  const Index nowhere[] = {0, 1, 9};
  const Polygons broken{kPositions, {}, nowhere};
  EXPECT_FALSE(build_from_polygons(mesh, broken, built));
  EXPECT_EQ(mesh.find_attribute(ItemKind::kVertex, "weight"), weight);
  EXPECT_EQ(weight->slots(), 0U);
}

TEST(Attributes, StayWhereAMeshIsBuiltAnew) {
  expect_builds_to_keep_columns<Mesh::kStorage>();
  expect_builds_to_keep_columns<kWithoutPrev>();
  expect_builds_to_keep_columns<kWithoutFaces>();
  expect_builds_to_keep_columns<Storage{.vertex_halfedge = false}>();
}

TEST(Attributes, AreRemovedByTheirOwnNames) {
  Mesh mesh = reference_build(tetrahedron());
  const std::string long_name(40, 'x');  // on the heap
  for (const char last : {'a', 'b', 'c', 'd'}) add(mesh, ItemKind::kVertex, long_name + last);
  const auto name_of_column = [&](std::size_t i) -> const std::string& {
    return mesh.attributes().of(ItemKind::kVertex)[i]->name();
  };
  EXPECT_TRUE(mesh.remove_attribute(ItemKind::kVertex, name_of_column(1)));
  EXPECT_TRUE(mesh.remove_attribute(ItemKind::kVertex, name_of_column(0)));
  ASSERT_EQ(mesh.attributes().of(ItemKind::kVertex).size(), 2U);
  EXPECT_EQ(name_of_column(0), long_name + 'c');
  EXPECT_EQ(name_of_column(1), long_name + 'd');
  EXPECT_FALSE(mesh.remove_attribute(ItemKind::kVertex, "none"));
  EXPECT_FALSE(mesh.remove_attribute(ItemKind::kFace, long_name + 'c'));
}

}  // namespace
}  // namespace halfedge::test
