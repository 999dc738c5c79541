#include <gtest/gtest.h>
#include <halfedge/halfedge.h>
#include <halfedge/operations/append.h>
#include <halfedge/operations/dual.h>

#include <utility>
#include <vector>

#include "support/operations.h"
#include "support/reference_build.h"
#include "support/same_but_prev.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using Chosen = BasicMesh<kPrevAtRunTime>;

Chosen chosen(const Shape& shape, bool stores_prev) {
  Chosen mesh;
  mesh.choose_prev(stores_prev);
  Mesh whole = reference_build(shape);
  EXPECT_TRUE(convert(std::move(whole), mesh).ok());
  return mesh;
}

std::vector<Index> prevs_of(const auto& mesh) {
  std::vector<Index> prevs;
  for (const Halfedge h : mesh.halfedges()) prevs.push_back(mesh.prev(h).index());
  return prevs;
}

void expect_same(const Mesh& mesh, const Chosen& other) {
  expect_same_but_prev(mesh, other);
  EXPECT_EQ(prevs_of(mesh), prevs_of(other));
  if (other.stores_prev()) {
    EXPECT_TRUE(same(mesh.links().prev, other.links().prev));
  } else {
    EXPECT_TRUE(other.links().prev.empty());
  }
}

class ChosenPrev : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(StoredOrNot, ChosenPrev, testing::Bool());

TEST(PrevAtRunTime, IsStoredUnlessChosenOtherwise) {
  Chosen mesh;
  EXPECT_TRUE(mesh.stores_prev());
  mesh.choose_prev(false);
  EXPECT_FALSE(mesh.stores_prev());
  EXPECT_FALSE(mesh.storage().prev);
  EXPECT_TRUE(Mesh().stores_prev());
  EXPECT_FALSE(BasicMesh<kWithoutPrev>().stores_prev());
}

// What was undone has words for as many arrays as there were.
TEST_P(ChosenPrev, IsNotRedoneAfterAnotherChoice) {
  Chosen mesh;
  mesh.choose_prev(GetParam());
  ASSERT_TRUE(mesh.enable_history());
  const Vertex a = mesh.add_vertex({0, 0, 0});
  const Vertex b = mesh.add_vertex({1, 0, 0});
  const Vertex c = mesh.add_vertex({0, 1, 0});
  ASSERT_TRUE(operations::add_face(mesh, {a, b, c}));
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());
  mesh.choose_prev(GetParam());
  ASSERT_TRUE(mesh.redo()) << "the same choice";
  EXPECT_EQ(mesh.face_count(), 1U);
  ASSERT_TRUE(mesh.undo());
  mesh.choose_prev(!GetParam());
  EXPECT_FALSE(mesh.redo());
  EXPECT_FALSE(has_errors(validate(mesh)));
}

TEST_P(ChosenPrev, IsBuiltAsChosen) {
  for (const Shape& shape : {cube(), torus(5, 4), disk(7), mixed_polygons()}) {
    const Mesh whole = reference_build(shape);
    expect_same(whole, chosen(shape, GetParam()));

    Chosen built;
    built.choose_prev(GetParam());
    BuildReport report;
    const PolygonSoup soup = std::move(shapes::torus(6, 4)).value();
    ASSERT_TRUE(build_from_polygons(built, soup.view(), report));
    Mesh expected;
    ASSERT_TRUE(build_from_polygons(expected, soup.view(), report));
    expect_same(expected, built);
  }
}

TEST_P(ChosenPrev, StaysAsChosenThroughOperationsAndUndo) {
  Mesh whole = reference_build(torus(4, 3));
  Chosen mesh = chosen(torus(4, 3), GetParam());
  ASSERT_TRUE(mesh.enable_history());
  RandomCalls random(7, 40);
  for (int i = 0; i < 400; ++i) {
    const DecoratorCall call = random.next(whole);
    const auto expected = apply(whole, call);
    const auto result = apply(mesh, call);
    ASSERT_EQ(result->ok(), expected->ok());
    mesh.end_step();
  }
  expect_same(whole, mesh);
  EXPECT_FALSE(has_errors(validate(mesh, 3)));
  while (mesh.undo()) {
  }
  expect_same(reference_build(torus(4, 3)), mesh);
  while (mesh.redo()) {
  }
  expect_same(whole, mesh);

  ASSERT_TRUE(compact(whole).ok());
  ASSERT_TRUE(compact(mesh).ok());
  expect_same(whole, mesh);
}

TEST_P(ChosenPrev, GoesWithTheMesh) {
  const Mesh whole = reference_build(cube());
  Chosen mesh = chosen(cube(), GetParam());
  Chosen copy;
  copy.choose_prev(!GetParam());
  ASSERT_TRUE(copy.assign(mesh));
  expect_same(whole, copy);
  Chosen moved = std::move(mesh);
  expect_same(whole, moved);
  EXPECT_EQ(moved.stores_prev(), GetParam());

  const Result<Array<std::uint8_t>> bytes = to_bytes(moved);
  ASSERT_TRUE(bytes.ok());
  Chosen read;
  read.choose_prev(!GetParam());
  ASSERT_TRUE(from_bytes(bytes.value().span(), read).ok());
  EXPECT_EQ(read.stores_prev(), GetParam());
  expect_same(whole, read);

  Mesh back;
  ASSERT_TRUE(convert(std::move(read), back).ok());
  expect_same(back, moved);
}

TEST_P(ChosenPrev, IsWrittenByWholeMeshOperations) {
  Mesh twice = reference_build(cube());
  ASSERT_TRUE(append(twice, reference_build(cube())).ok());
  Chosen mesh = chosen(cube(), GetParam());
  ASSERT_TRUE(append(mesh, chosen(cube(), !GetParam())).ok());
  expect_same(twice, mesh);

  Mesh expected;
  ASSERT_TRUE(dual(twice, expected).ok());
  Chosen out;
  out.choose_prev(GetParam());
  ASSERT_TRUE(dual(mesh, out).ok());
  expect_same(expected, out);
}

// What validate follows where prev is stored is what is stored.
TEST(PrevAtRunTime, ABrokenOneIsFound) {
  Chosen mesh = chosen(cube(), true);
  EXPECT_TRUE(validate(mesh).empty());
  mesh.mutable_links().prev[3] = mesh.links().prev[5];
  ASSERT_FALSE(validate(mesh).empty());
  EXPECT_EQ(validate(mesh).front().code, "next-prev-mismatch");
}

}  // namespace
}  // namespace halfedge::test
