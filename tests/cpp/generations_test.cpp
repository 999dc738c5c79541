#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

TEST(Generations, TellTheItemsOfOneSlotApart) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_history());
  ASSERT_TRUE(mesh.enable_generations());
  ASSERT_TRUE(mesh.enable_generations()) << "they are there, and stay";
  const Halfedge spoke = decorator::create_center_vertex(mesh, Halfedge(0)).value();
  mesh.end_step();
  const Vertex v = mesh.to_vertex(spoke);
  const Index first = mesh.generation(v);
  const Index first_of_spoke = mesh.generation(spoke);
  const Halfedge before = decorator::erase_center_vertex(mesh, spoke).value();
  mesh.end_step();
  const Halfedge again = decorator::create_center_vertex(mesh, before).value();
  mesh.end_step();
  ASSERT_EQ(mesh.to_vertex(again), v);
  const Index second = mesh.generation(v);
  EXPECT_NE(second, first);

  ASSERT_TRUE(mesh.undo());
  ASSERT_TRUE(mesh.undo());
  EXPECT_EQ(mesh.generation(v), first) << "the same vertex is back";
  EXPECT_EQ(mesh.generation(spoke), first_of_spoke);
  ASSERT_TRUE(decorator::erase_center_vertex(mesh, spoke));
  ASSERT_EQ(mesh.add_vertex({}), v);
  EXPECT_NE(mesh.generation(v), first);
  EXPECT_NE(mesh.generation(v), second) << "another vertex than that which was undone";
}

TEST(Generations, SwitchedOnForgetAllStepsButTheOneUnderway) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_history());
  for (const float x : {1.0F, 2.0F, 3.0F}) {
    mesh.set_position(Vertex(0), {x, 0, 0});
    mesh.end_step();
  }
  ASSERT_TRUE(mesh.undo());
  ASSERT_TRUE(mesh.undo());
  mesh.set_position(Vertex(0), {4, 0, 0});
  ASSERT_TRUE(mesh.enable_generations());
  EXPECT_EQ(mesh.history()->undo_count(), 0U);
  EXPECT_EQ(mesh.history()->redo_count(), 0U);
  EXPECT_TRUE(mesh.history()->has_open_step());
  EXPECT_EQ(mesh.history()->bytes(), 16U) << "one position";
  ASSERT_TRUE(mesh.undo());
  EXPECT_EQ(mesh.position(Vertex(0)).x, 1);
  EXPECT_FALSE(mesh.undo());
  EXPECT_EQ(mesh.position(Vertex(0)).x, 1);
}

TEST(Generations, OfItemsThatAreMadeAgainAreTheirOwn) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_history());
  ASSERT_TRUE(mesh.enable_generations());
  const Halfedge spoke = decorator::create_center_vertex(mesh, Halfedge(0)).value();
  const Vertex v = mesh.to_vertex(spoke);
  const Face f = mesh.face(spoke);
  const Index of_vertex = mesh.generation(v);
  const Index of_spoke = mesh.generation(spoke);
  const Index of_face = mesh.generation(f);
  mesh.end_step();
  ASSERT_TRUE(compact(mesh));  // items made from now on begin with another generation
  mesh.end_step();
  while (mesh.undo()) {
  }
  ASSERT_TRUE(mesh.redo());
  EXPECT_EQ(mesh.generation(v), of_vertex);
  EXPECT_EQ(mesh.generation(spoke), of_spoke);
  EXPECT_EQ(mesh.generation(f), of_face);
}

TEST(Generations, TellApartWhatTookThePlaceOfSomethingUndone) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_history());
  ASSERT_TRUE(mesh.enable_generations());
  const Vertex v = mesh.add_vertex({});
  const Index undone = mesh.generation(v);
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());
  ASSERT_EQ(mesh.add_vertex({}), v);
  EXPECT_NE(mesh.generation(v), undone);
}

TEST(Generations, TellApartWhatTookTheSlotOfSomethingUndone) {
  Mesh mesh = reference_build(triangle_grid(1, 1));
  ASSERT_TRUE(mesh.enable_history());
  ASSERT_TRUE(mesh.enable_generations());
  ASSERT_TRUE(operations::delete_face(mesh, Face(1)));
  mesh.end_step();

  // A vertex, an edge and a face, each in the slot of a deleted one. Returns their stamps.
  const auto make = [&] {
    const Vertex v = mesh.add_vertex({});
    const Halfedge h = mesh.opposite(mesh.face_halfedge(Face(0)));
    const Result<Face> f = operations::add_face(mesh, {mesh.from_vertex(h), mesh.to_vertex(h), v});
    EXPECT_TRUE(f);
    EXPECT_EQ(f.value(), Face(1));
    EXPECT_EQ(mesh.vertex_slots(), 4U);
    EXPECT_EQ(mesh.edge_slots(), 5U);
    mesh.end_step();
    return std::vector<Index>{mesh.generation(v), mesh.generation(mesh.vertex_halfedge(v)),
                              mesh.generation(f.value())};
  };
  const std::vector<Index> undone = make();
  ASSERT_TRUE(mesh.undo());
  const std::vector<Index> next = make();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NE(next[i], undone[i]) << i;
}

TEST(Generations, TellApartWhatTookThePlaceOfSomethingUndoneOnceThereIsNoHistory) {
  for (const bool copies : {false, true}) {
    Mesh mesh = reference_build(tetrahedron());
    ASSERT_TRUE(mesh.enable_history());
    ASSERT_TRUE(mesh.enable_generations());
    const Vertex v = mesh.add_vertex({});
    mesh.end_generations();  // as whatever renumbers items does
    const Index undone = mesh.generation(v);
    mesh.end_step();
    ASSERT_TRUE(mesh.undo());
    Mesh copy;
    if (copies) {
      ASSERT_TRUE(copy.assign(mesh));
    } else {
      mesh.disable_history();
    }
    Mesh& next = copies ? copy : mesh;
    ASSERT_EQ(next.add_vertex({}), v);
    EXPECT_NE(next.generation(v), undone);
  }
}

TEST(Generations, HaveNoNameThatAttributesCouldHave) {
  Mesh mesh = reference_build(tetrahedron());
  Attribute& own =
      *mesh.add_attribute(ItemKind::kVertex, "generation", {.type = Scalar::kUint32}).value();
  own.set(0, 0, 77, nullptr);
  ASSERT_TRUE(mesh.enable_generations());
  Mesh other = reference_build(triangle());
  ASSERT_TRUE(other.enable_generations());
  ASSERT_TRUE(append(mesh, other));
  EXPECT_EQ(own.get(0, 0), 77);
  EXPECT_EQ(own.get(4, 0), 0) << "the default, as the other mesh has no such attribute";
  EXPECT_EQ(mesh.add_attribute(ItemKind::kFace, "", {}).error().code, "bad-attribute");
}

TEST(Generations, ForgetTheStepsFromBeforeTheyWereEnabled) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_history());
  ASSERT_TRUE(operations::delete_vertex(mesh, Vertex(0)));
  mesh.end_step();
  ASSERT_TRUE(compact(mesh));
  mesh.end_step();
  mesh.set_position(Vertex(0), {1, 2, 3});  // of a step that isn't over
  ASSERT_TRUE(mesh.enable_generations());
  const Index stamp = mesh.generation(Vertex(1));
  ASSERT_TRUE(mesh.undo());
  EXPECT_NE(mesh.position(Vertex(0)), (Point{1, 2, 3}));
  EXPECT_FALSE(mesh.undo()) << "vertex 1 was another one then";
  EXPECT_EQ(mesh.generation(Vertex(1)), stamp);

  ASSERT_TRUE(mesh.redo());
  mesh.end_step();
  EXPECT_EQ(mesh.position(Vertex(0)), (Point{1, 2, 3}));
  ASSERT_TRUE(mesh.undo());
  EXPECT_FALSE(has_errors(validate(mesh)));
}

TEST(Generations, EndWhenTheyAreTurnedOff) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_generations());
  const Index before = mesh.generation(Face(0));
  mesh.disable_generations();
  EXPECT_FALSE(mesh.has_generations());
  EXPECT_EQ(mesh.generation(Face(0)), 0U);
  ASSERT_TRUE(mesh.enable_generations());
  EXPECT_NE(mesh.generation(Face(0)), before);
}

TEST(Generations, EndWhenTheMeshIsCompacted) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_generations());
  const Index before = mesh.generation(Face(0));
  ASSERT_TRUE(compact(mesh));
  EXPECT_EQ(mesh.generation(Face(0)), before) << "without gaps nothing moves";

  ASSERT_TRUE(operations::delete_face(mesh, Face(3)));
  ASSERT_TRUE(compact(mesh));
  EXPECT_NE(mesh.generation(Face(0)), before);
  EXPECT_EQ(mesh.generation(Vertex(1)), mesh.generation(Edge(1)));
}

TEST(Generations, EndWhereAnotherMeshIsCopiedOver) {
  Mesh other = reference_build(quad_grid(3, 3));
  ASSERT_TRUE(other.enable_generations());
  Mesh copy;
  ASSERT_TRUE(copy.assign(other));
  EXPECT_EQ(copy.generation(Face(0)), other.generation(Face(0)))
      << "of which nothing is known here";

  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_generations());
  const Index before = mesh.generation(Face(0));
  ASSERT_EQ(before, other.generation(Face(0)));
  ASSERT_TRUE(mesh.assign(other));
  const Index after = mesh.generation(Face(0));
  EXPECT_NE(after, before);
  ASSERT_TRUE(mesh.assign(mesh));
  EXPECT_EQ(mesh.generation(Face(0)), after);
  ASSERT_TRUE(mesh.assign(other));
  EXPECT_NE(mesh.generation(Face(0)), after);
}

// What `replace` puts in the place of a mesh has no stamp that its items had.
template <class Replace>
void expect_new_generations(const Replace& replace) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_generations());
  const Index before = mesh.generation(Face(0));
  replace(mesh);
  ASSERT_TRUE(mesh.enable_generations());
  EXPECT_NE(mesh.generation(Face(0)), before);
}

TEST(Generations, EndWhereAnotherMeshIsMovedOver) {
  Mesh other = reference_build(quad_grid(3, 3));
  ASSERT_TRUE(other.enable_generations());
  const Index theirs = other.generation(Face(0));
  Mesh moved;
  moved = std::move(other);
  EXPECT_EQ(moved.generation(Face(0)), theirs) << "of which nothing is known here";
  const Mesh constructed(std::move(moved));
  EXPECT_EQ(constructed.generation(Face(0)), theirs);

  expect_new_generations([](Mesh& mesh) { mesh = reference_build(quad_grid(3, 3)); });
  expect_new_generations([](Mesh& mesh) {
    Mesh grid = reference_build(quad_grid(3, 3));
    ASSERT_TRUE(grid.enable_generations());
    mesh = std::move(grid);
  });
}

TEST(Generations, EndWhereAMeshIsMovedAway) {
  expect_new_generations([](Mesh& mesh) {
    const Mesh away = std::move(mesh);
    ASSERT_TRUE(mesh.assign(reference_build(quad_grid(3, 3))));  // NOLINT: a moved mesh is empty
  });
}

TEST(Generations, EndWherePartOfAMeshIsExtracted) {
  expect_new_generations([](Mesh& mesh) {
    const std::vector<Index> faces = {1, 2};
    ASSERT_TRUE(extract(mesh, faces, mesh));
    EXPECT_FALSE(mesh.has_generations());
  });
}

TEST(Generations, EndWhereAMeshIsConvertedOver) {
  expect_new_generations([](Mesh& mesh) {
    BasicMesh<kWithoutPrev> other;
    ASSERT_TRUE(convert(reference_build(quad_grid(3, 3)), other));
    ASSERT_TRUE(other.enable_generations());
    ASSERT_TRUE(convert(std::move(other), mesh));
  });
}

TEST(Generations, EndWhereEdgesAreRenumbered) {
  Mesh mesh = reference_build(quad_grid(3, 3));
  ASSERT_TRUE(mesh.enable_generations());
  const Index before = mesh.generation(Edge(0));
  ASSERT_TRUE(decorator::normalize_boundary(mesh));
  EXPECT_NE(mesh.generation(Edge(0)), before);
}

}  // namespace
}  // namespace halfedge::test
