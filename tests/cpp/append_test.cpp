#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/copies.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

TEST(Append, CopiesLiveItemsAndLeavesTheOthersAlone) {
  std::uint32_t seed = 0;
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
    Mesh mesh = with_gaps(random_polygons(seed), seed + 100);
    const Mesh other = with_gaps(shape, seed++);
    const Mesh before = copy_of(mesh);
    EXPECT_TRUE(check_append(before, other));
    const CompactMaps maps = append(mesh, other).value();
    EXPECT_FALSE(has_errors(validate(mesh, 2)));
    EXPECT_EQ(mesh.vertex_count(), before.vertex_count() + other.vertex_count());
    EXPECT_EQ(mesh.edge_count(), before.edge_count() + other.edge_count());
    EXPECT_EQ(mesh.face_count(), before.face_count() + other.face_count());
    expect_copy(mesh, other, maps);
    for (Index v = 0; v < other.vertex_slots(); ++v) {
      EXPECT_EQ(maps.vertices[v] == kNone, other.is_deleted(Vertex(v)));
    }
    for (const Halfedge h : before.halfedges()) {
      ASSERT_EQ(mesh.next(h), before.next(h));
      ASSERT_EQ(mesh.face(h), before.face(h));
      ASSERT_EQ(mesh.to_vertex(h), before.to_vertex(h));
    }
    for (const Vertex v : before.vertices()) {
      ASSERT_EQ(mesh.vertex_halfedge(v), before.vertex_halfedge(v));
      ASSERT_EQ(mesh.position(v), before.position(v));
    }
  }
}

TEST(Append, OfAMeshToItselfDoublesIt) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = with_gaps(torus(5, 4, 1), seed);
    const Mesh before = copy_of(mesh);
    const CompactMaps maps = append(mesh, mesh).value();
    EXPECT_FALSE(has_errors(validate(mesh, 2)));
    EXPECT_EQ(mesh.edge_count(), 2 * before.edge_count());
    EXPECT_EQ(mesh.vertex_count(), 2 * before.vertex_count());
    EXPECT_EQ(mesh.face_count(), 2 * before.face_count());
    expect_copy(mesh, before, maps);
    expect_copy(mesh, before, [&] {  // the original is still there
      CompactMaps same;
      EXPECT_TRUE(same.vertices.resize(before.vertex_slots()));
      EXPECT_TRUE(same.edges.resize(before.edge_slots()));
      EXPECT_TRUE(same.faces.resize(before.face_slots()));
      for (Array<Index>* map : {&same.vertices, &same.edges, &same.faces}) {
        for (Index i = 0; i < map->size(); ++i) (*map)[i] = i;
      }
      return same;
    }());
  }
}

TEST(Append, WorksAcrossStorageOptions) {
  const Mesh whole = with_gaps(cube(), 3);
  BasicMesh<kWithoutPrev> lean;
  const CompactMaps maps = append(lean, whole).value();
  expect_copy(lean, whole, maps);
  Mesh again;
  expect_copy(again, lean, [&] { return append(again, lean).value(); }());
}

TEST(Append, IsOneStepOfHistoryAndIsTakenBackExactly) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = with_gaps(torus(5, 4, 1), seed);
    const Mesh other = with_gaps(mixed_polygons(), seed);
    ASSERT_TRUE(mesh.enable_history());
    const Snapshot before(mesh);
    ASSERT_TRUE(append(mesh, seed % 2 == 0 ? other : mesh).ok());
    mesh.end_step();
    const Snapshot after(mesh);
    EXPECT_EQ(mesh.history()->undo_count(), 1U);
    ASSERT_TRUE(mesh.undo());
    EXPECT_EQ(Snapshot(mesh), before);
    ASSERT_TRUE(mesh.redo());
    EXPECT_EQ(Snapshot(mesh), after);
  }
}

TEST(Append, CopiesTheAttributesThatBothHave) {
  Mesh mesh = reference_build(cube());
  Mesh other = reference_build(tetrahedron());
  const double grey[] = {0.5};
  const auto add = [](Mesh& to, ItemKind kind, const char* name, Scalar type, Index components,
                      std::span<const double> value = {}) {
    Attribute* const added =
        to.add_attribute(kind, name,
                         {.type = type, .components = components, .default_value = value})
            .value();
    return added;
  };
  Attribute* const colour = add(mesh, ItemKind::kVertex, "colour", Scalar::kFloat32, 1, grey);
  Attribute* const uv = add(mesh, ItemKind::kHalfedge, "uv", Scalar::kFloat32, 2);
  Attribute* const label = add(mesh, ItemKind::kFace, "label", Scalar::kUint8, 1);
  Attribute* const weight = add(mesh, ItemKind::kEdge, "weight", Scalar::kFloat64, 1);
  Attribute* const other_colour = add(other, ItemKind::kVertex, "colour", Scalar::kFloat64, 1);
  Attribute* const other_uv = add(other, ItemKind::kHalfedge, "uv", Scalar::kFloat32, 2);
  Attribute* const other_label = add(other, ItemKind::kFace, "label", Scalar::kUint8, 1);
  Attribute* const other_weight = add(other, ItemKind::kEdge, "weight", Scalar::kFloat64, 1);
  add(other, ItemKind::kEdge, "only here", Scalar::kInt16, 1);
  for (const Vertex v : other.vertices()) other.set_attribute(*other_colour, v, 0, 9);
  for (const Halfedge h : other.halfedges()) {
    other.set_attribute(*other_uv, h, 0, h.index());
    other.set_attribute(*other_uv, h, 1, 100 + h.index());
  }
  for (const Face f : other.faces()) other.set_attribute(*other_label, f, 0, 7 + f.index());
  for (const Edge e : other.edges()) other.set_attribute(*other_weight, e, 0, 0.1 + e.index());

  const CompactMaps maps = append(mesh, other).value();
  for (const Halfedge h : other.halfedges()) {
    EXPECT_EQ(uv->get(maps(h).index(), 0), h.index());
    EXPECT_EQ(uv->get(maps(h).index(), 1), 100 + h.index());
  }
  for (const Face f : other.faces()) EXPECT_EQ(label->get(maps(f).index(), 0), 7 + f.index());
  for (const Edge e : other.edges()) EXPECT_EQ(weight->get(maps(e).index(), 0), 0.1 + e.index());
  // Another type: not the same attribute.
  for (const Vertex v : other.vertices()) EXPECT_EQ(colour->get(maps(v).index(), 0), 0.5);
  EXPECT_EQ(mesh.find_attribute(ItemKind::kEdge, "only here"), nullptr);
  EXPECT_EQ(label->get(0, 0), 0);
}

TEST(Append, OfManyIsAmortised) {
  Mesh mesh;
  const Mesh one = reference_build(tetrahedron());
  std::size_t moves = 0;
  const Index* at = nullptr;
  for (int i = 0; i < 20000; ++i) {
    ASSERT_TRUE(append(mesh, one).ok());
    if (mesh.links().next.data() != at) ++moves;
    at = mesh.links().next.data();
  }
  EXPECT_EQ(mesh.face_count(), 80000U);
  EXPECT_LT(moves, 60U);
  EXPECT_TRUE(validate(mesh).empty());
}

TEST(Append, RefusesACorruptMeshAndChangesNothing) {
  std::mt19937 random(1);
  Mesh mesh = with_gaps(torus(5, 4, 1), 1);
  const Snapshot before(mesh);
  int refused = 0;
  for (int round = 0; round < 500; ++round) {
    Mesh other = with_gaps(cube(), 2);
    Links& links = other.mutable_links();
    Array<Index>* const arrays[] = {&links.next, &links.to_vertex, &links.face,
                                    &links.vertex_halfedge, &links.face_halfedge};
    Array<Index>& array = *arrays[random() % 5];
    const Index i = Index(random() % array.size());
    if (is_deleted_link(array[i])) continue;
    array[i] = Index(random() % 3 == 0 ? kDeleted : random() | 0x1000);
    const std::uint64_t version = mesh.version();
    const Result<void> can = check_append(mesh, other);
    const Result<CompactMaps> maps = append(mesh, other);
    ASSERT_EQ(can.ok(), maps.ok());
    if (maps.ok()) {  // what was deleted is an item that nothing refers to
      mesh = with_gaps(torus(5, 4, 1), 1);
      continue;
    }
    EXPECT_EQ(maps.error().code, "corrupt-connectivity");
    EXPECT_EQ(can.error().message, maps.error().message);
    EXPECT_EQ(mesh.version(), version);
    ASSERT_EQ(Snapshot(mesh), before);
    ++refused;
  }
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace halfedge::test
