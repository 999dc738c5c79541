#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/operations.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

Mesh with_history(const Shape& shape, HistoryLimits limits = {}) {
  Mesh mesh = reference_build(shape);
  add_attributes_of_all_kinds(mesh);
  EXPECT_TRUE(mesh.enable_history(limits));
  return mesh;
}

std::vector<Shape> shapes_of_all_kinds() {
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < 6; ++seed) shapes.push_back(random_polygons(seed));
  return shapes;
}

/// Moves a vertex, or deletes and makes items, or applies an operation of the decorator, at random.
bool change_something(Mesh& mesh, RandomCalls& random) {
  if (random.below(8) == 0 && mesh.vertex_slots() > 0) {
    const Vertex v(Index(random.below(mesh.vertex_slots())));
    mesh.set_position(v, {float(random.below(9)), 1, 2});
    return true;
  }
  if (random.below(50) == 0) return compact(mesh).ok();
  const auto result = apply(mesh, random.next(mesh));
  return result.has_value() && result->ok();
}

// ---- exactness ------------------------------------------------------------------------------

TEST(History, GoesBackAndForthThroughRandomChangesToTheLastWord) {
  std::uint32_t seed = 0;
  for (const Shape& shape : shapes_of_all_kinds()) {
    SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
    Mesh mesh = with_history(shape);
    RandomCalls random(seed++, 60);
    std::vector<Snapshot> states{Snapshot(mesh)};
    for (int i = 0; i < 300; ++i) {
      const bool changed = change_something(mesh, random);
      mesh.end_step();
      const Snapshot now(mesh);
      if (changed && !(now == states.back())) states.push_back(now);
      // Half of the time take a few steps back, and some of them forth; then go on from there.
      if (random.below(10) == 0) {
        for (std::size_t back = random.below(5); back > 0 && states.size() > 1; --back) {
          ASSERT_TRUE(mesh.undo());
          if (Snapshot(mesh) == states.back()) continue;  // a step that changed no word
          states.pop_back();
          ASSERT_EQ(Snapshot(mesh), states.back());
        }
      }
      ASSERT_EQ(Snapshot(mesh), states.back());
    }
    const std::size_t steps = mesh.history()->undo_count();
    EXPECT_GT(steps, 50U);
    const Snapshot last(mesh);
    while (mesh.undo()) {
    }
    ASSERT_EQ(Snapshot(mesh), states.front());
    EXPECT_FALSE(has_errors(validate(mesh)));
    for (std::size_t i = 0; i < steps; ++i) ASSERT_TRUE(mesh.redo());
    ASSERT_EQ(Snapshot(mesh), last);
  }
}

TEST(History, TakesBackEachStepExactly) {
  Mesh mesh = with_history(torus(5, 4, 1));
  RandomCalls random(7, 60);
  std::vector<Snapshot> states;
  for (int i = 0; i < 400; ++i) {
    const Snapshot before(mesh);
    const std::size_t steps = mesh.history()->undo_count();
    (void)change_something(mesh, random);
    mesh.end_step();
    if (mesh.history()->undo_count() > steps) states.push_back(before);
  }
  ASSERT_EQ(mesh.history()->undo_count(), states.size());
  for (; !states.empty(); states.pop_back()) {
    const Snapshot after(mesh);
    ASSERT_TRUE(mesh.undo());
    ASSERT_EQ(Snapshot(mesh), states.back());
    ASSERT_TRUE(mesh.redo());
    ASSERT_EQ(Snapshot(mesh), after);
    ASSERT_TRUE(mesh.undo());
  }
  EXPECT_FALSE(mesh.undo());
}

TEST(History, GoesBackAndForthThroughStepsOfManyChanges) {
  std::uint32_t seed = 100;
  for (const Shape& shape : shapes_of_all_kinds()) {
    SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
    Mesh mesh = with_history(shape);
    RandomCalls random(seed++, 60);
    std::vector<Snapshot> states{Snapshot(mesh)};
    for (int step = 0; step < 60; ++step) {
      // Items that are new in a step are deleted in it, their slots taken again, and compacted.
      for (std::size_t changes = 1 + random.below(30); changes > 0; --changes) {
        (void)change_something(mesh, random);
      }
      const std::size_t steps = mesh.history()->undo_count();
      mesh.end_step();
      if (mesh.history()->undo_count() > steps) states.push_back(Snapshot(mesh));
    }
    ASSERT_GT(states.size(), 40U);
    for (int times = 0; times < 2; ++times) {
      for (std::size_t i = states.size() - 1; i-- > 0;) {
        ASSERT_TRUE(mesh.undo());
        ASSERT_EQ(Snapshot(mesh), states[i]) << "after undo, state " << i;
      }
      for (std::size_t i = 1; i < states.size(); ++i) {
        ASSERT_TRUE(mesh.redo());
        ASSERT_EQ(Snapshot(mesh), states[i]) << "after redo, state " << i;
      }
    }
  }
}

TEST(History, NeedsNoNotesOfWhatNewItemsHold) {
  Mesh mesh = reference_build(tetrahedron());
  ASSERT_TRUE(mesh.enable_history());
  const Snapshot before(mesh);
  ASSERT_TRUE(operations::split_face(mesh, Face(0)));
  mesh.end_step();
  // Sizes of three arrays, and the links of three sides.
  EXPECT_EQ(mesh.history()->bytes(), 3 * 8 + 3 * 16);
  const Snapshot after(mesh);
  ASSERT_TRUE(mesh.undo());
  EXPECT_EQ(Snapshot(mesh), before);
  ASSERT_TRUE(mesh.redo());
  EXPECT_EQ(Snapshot(mesh), after);
}

TEST(History, NotesADeletedEdgeInOnePlaceOfItsChunk) {
  // So many steps that edges fall on each place of a chunk of notes.
  Mesh mesh = reference_build(quad_grid(40, 40));
  ASSERT_TRUE(mesh.enable_history());
  const Snapshot before(mesh);
  std::size_t moved = 0;
  for (Index f = 0; f < mesh.face_slots(); ++f) {
    const Vertex v = mesh.to_vertex(mesh.face_halfedge(Face(f)));
    for (Index i = 0; i < f % 3; ++i) mesh.set_position(v, {float(++moved), 0, 0});
    ASSERT_TRUE(operations::delete_face(mesh, Face(f)));
    mesh.end_step();
  }
  const Snapshot after(mesh);
  while (mesh.undo()) {
  }
  ASSERT_EQ(Snapshot(mesh), before);
  while (mesh.redo()) {
  }
  ASSERT_EQ(Snapshot(mesh), after);
}

TEST(History, BringsItemsBackUnderTheirHandles) {
  Mesh mesh = with_history(tetrahedron());
  const Face f = mesh.face(Halfedge(0));
  const Result<Halfedge> spoke = decorator::create_center_vertex(mesh, Halfedge(0));
  ASSERT_TRUE(spoke);
  const Vertex centre = mesh.to_vertex(spoke.value());
  mesh.set_position(centre, {5, 6, 7});
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());
  EXPECT_FALSE(mesh.is_live(centre));
  EXPECT_EQ(mesh.face_count(), 4U);
  EXPECT_EQ(mesh.degree(f), 3U);
  ASSERT_TRUE(mesh.redo());
  EXPECT_TRUE(mesh.is_live(centre));
  EXPECT_EQ(mesh.position(centre), (Point{5, 6, 7}));
  EXPECT_EQ(mesh.valence(centre), 3U);
}

// ---- steps ----------------------------------------------------------------------------------

TEST(History, GroupsWhatIsWrittenBetweenTheEndsOfSteps) {
  Mesh mesh = with_history(triangle());
  const Snapshot before(mesh);
  mesh.set_position(Vertex(0), {1, 1, 1});
  mesh.set_position(Vertex(1), {2, 2, 2});
  mesh.end_step();
  mesh.end_step();  // nothing was written: no step
  EXPECT_EQ(mesh.history()->undo_count(), 1U);
  mesh.set_position(Vertex(2), {3, 3, 3});
  EXPECT_TRUE(mesh.undo()) << "an open step ends where it is taken back";
  EXPECT_TRUE(mesh.undo());
  EXPECT_EQ(Snapshot(mesh), before);
  EXPECT_FALSE(mesh.undo());
  EXPECT_EQ(mesh.history()->redo_count(), 2U);
}

TEST(History, ForgetsWhatWasUndoneWhenSomethingNewIsWritten) {
  Mesh mesh = with_history(triangle());
  for (const float x : {1.0F, 2.0F, 3.0F}) {
    mesh.set_position(Vertex(0), {x, 0, 0});
    mesh.end_step();
  }
  ASSERT_TRUE(mesh.undo());
  ASSERT_TRUE(mesh.undo());
  mesh.set_position(Vertex(0), {9, 0, 0});
  mesh.end_step();
  EXPECT_FALSE(mesh.redo());
  EXPECT_EQ(mesh.history()->undo_count(), 2U);
  ASSERT_TRUE(mesh.undo());
  EXPECT_EQ(mesh.position(Vertex(0)).x, 1);
}

TEST(History, KeepsAtMostSoManySteps) {
  Mesh mesh = with_history(triangle(), {.steps = 3});
  for (int i = 1; i <= 10; ++i) {
    mesh.set_position(Vertex(0), {float(i), 0, 0});
    mesh.end_step();
  }
  EXPECT_EQ(mesh.history()->undo_count(), 3U);
  while (mesh.undo()) {
  }
  EXPECT_EQ(mesh.position(Vertex(0)).x, 7);
  while (mesh.redo()) {
  }
  EXPECT_EQ(mesh.position(Vertex(0)).x, 10);
}

TEST(History, KeepsAtMostSoManyBytesButTheLastStepInAnyCase) {
  constexpr std::size_t kStep = 16;
  Mesh mesh = with_history(triangle(), {.bytes = 4 * kStep});
  for (int i = 1; i <= 10; ++i) {
    mesh.set_position(Vertex(0), {float(i), 0, 0});
    mesh.end_step();
    EXPECT_LE(mesh.history()->bytes(), 4 * kStep);
  }
  EXPECT_EQ(mesh.history()->undo_count(), 4U);
  for (int i = 0; i < 20; ++i) mesh.set_position(Vertex(1), {float(i), 0, 0});
  mesh.end_step();
  EXPECT_EQ(mesh.history()->undo_count(), 1U);
  EXPECT_EQ(mesh.history()->bytes(), 20 * kStep);
}

TEST(History, StaysLinearOverALongTimeOfForgetting) {
  Mesh mesh = with_history(triangle(), {.steps = 100});
  for (int i = 1; i <= 100'000; ++i) {
    mesh.set_position(Vertex(0), {float(i), 0, 0});
    mesh.end_step();
  }
  EXPECT_EQ(mesh.history()->undo_count(), 100U);
  EXPECT_EQ(mesh.history()->bytes(), 100 * 16);
  for (int i = 99'999; i >= 99'900; --i) {
    ASSERT_TRUE(mesh.undo());
    ASSERT_EQ(mesh.position(Vertex(0)).x, float(i));
  }
  EXPECT_FALSE(mesh.undo());
}

TEST(History, ForgetsWhatLiesBeyondNewLimits) {
  Mesh mesh = with_history(triangle());
  const auto take_steps = [&](int from, int to) {
    for (int i = from; i <= to; ++i) {
      mesh.set_position(Vertex(0), {float(i), 0, 0});
      mesh.end_step();
    }
  };
  take_steps(1, 10);
  ASSERT_TRUE(mesh.undo());
  ASSERT_TRUE(mesh.undo());
  mesh.limit_history({.steps = 3});
  EXPECT_EQ(mesh.history()->undo_count(), 3U);
  EXPECT_EQ(mesh.history()->redo_count(), 0U);
  take_steps(9, 20);
  EXPECT_EQ(mesh.history()->undo_count(), 3U);
  while (mesh.undo()) {
  }
  EXPECT_EQ(mesh.position(Vertex(0)).x, 17);
}

TEST(History, ForgetsNoStepForOneUnderwayThatIsTakenBack) {
  for (const HistoryLimits limits : {HistoryLimits{.steps = 2}, HistoryLimits{.bytes = 80}}) {
    Mesh mesh = with_history(triangle(), limits);
    for (const float x : {1.0F, 2.0F}) {
      mesh.set_position(Vertex(0), {x, 0, 0});
      mesh.end_step();
    }
    ASSERT_EQ(mesh.history()->undo_count(), 2U);
    for (const float x : {3.0F, 4.0F, 5.0F}) mesh.set_position(Vertex(0), {x, 0, 0});
    ASSERT_TRUE(mesh.undo());
    EXPECT_EQ(mesh.history()->undo_count(), 2U);
    ASSERT_TRUE(mesh.undo());
    ASSERT_TRUE(mesh.undo());
    EXPECT_EQ(mesh.position(Vertex(0)).x, 0);
  }
}

TEST(History, BeginsAnewOnceItIsForgotten) {
  Mesh mesh = with_history(triangle());
  mesh.set_position(Vertex(0), {1, 1, 1});
  mesh.end_step();
  mesh.forget_history();
  EXPECT_EQ(mesh.history()->bytes(), 0U);
  EXPECT_FALSE(mesh.undo());
  ASSERT_TRUE(mesh.add_vertex({1, 2, 3}).valid());
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());  // keeps what the vertex was, for redo
  mesh.forget_history();
  EXPECT_EQ(mesh.history()->bytes(), 0U);
  mesh.set_position(Vertex(0), {2, 2, 2});
  mesh.end_step();
  EXPECT_EQ(mesh.history()->bytes(), 16);
  ASSERT_TRUE(mesh.undo());
  EXPECT_EQ(mesh.position(Vertex(0)), (Point{1, 1, 1}));
  EXPECT_FALSE(mesh.undo());
}

TEST(History, KeepsNothingOfWhatCanNoLongerBeRedone) {
  Mesh mesh = with_history(triangle());
  ASSERT_TRUE(mesh.add_vertex({1, 2, 3}).valid());
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());  // keeps what the vertex was
  mesh.set_position(Vertex(0), {2, 2, 2});
  mesh.end_step();
  EXPECT_FALSE(mesh.redo());
  EXPECT_EQ(mesh.history()->bytes(), 16U) << "one position";
}

// ---- what it leaves alone -------------------------------------------------------------------

TEST(History, IsOffByDefault) {
  Mesh mesh = reference_build(triangle());
  mesh.set_position(Vertex(0), {1, 1, 1});
  mesh.end_step();
  EXPECT_EQ(mesh.history(), nullptr);
  EXPECT_FALSE(mesh.undo());
  EXPECT_FALSE(mesh.redo());
}

TEST(History, IsForgottenWhenTheWholeMeshIsReplaced) {
  const auto forgets = [](auto&& replace) {
    Mesh mesh = with_history(tetrahedron());
    mesh.set_position(Vertex(0), {1, 1, 1});
    mesh.end_step();
    replace(mesh);
    return mesh.history() != nullptr && mesh.history()->undo_count() == 0 && !mesh.undo();
  };
  EXPECT_TRUE(forgets([](Mesh& mesh) { mesh.clear(); }));
  EXPECT_TRUE(forgets([](Mesh& mesh) { (void)mesh.mutable_links(); }));
  EXPECT_TRUE(forgets([](Mesh& mesh) {
    const Mesh other = reference_build(cube());
    EXPECT_TRUE(mesh.assign(other));
  }));
  EXPECT_TRUE(forgets([](Mesh& mesh) {
    const Shape shape = cube();
    BuildReport report;
    EXPECT_TRUE(build_from_polygons(mesh, shape.polygons(), report));
  }));
  EXPECT_TRUE(forgets([](Mesh& mesh) { EXPECT_TRUE(convert(reference_build(cube()), mesh)); }));
}

TEST(History, MovesWithTheMeshAndIsNotCopied) {
  Mesh mesh = with_history(triangle());
  mesh.set_position(Vertex(0), {1, 1, 1});
  mesh.end_step();
  Mesh copy;
  ASSERT_TRUE(copy.assign(mesh));
  EXPECT_EQ(copy.history(), nullptr);
  Mesh moved = std::move(mesh);
  ASSERT_TRUE(moved.undo());
  EXPECT_EQ(moved.position(Vertex(0)), (Point{0, 0, 0}));
}

TEST(History, ARefusedOperationMakesNoStep) {
  Mesh mesh = with_history(tetrahedron());
  ASSERT_FALSE(decorator::split_face(mesh, Halfedge(0), Halfedge(1)));
  mesh.end_step();
  EXPECT_EQ(mesh.history()->undo_count(), 0U);
}

TEST(History, ARefusedAttributeLeavesWhatCanBeRedone) {
  Mesh mesh = with_history(triangle());
  ASSERT_TRUE(mesh.add_attribute(ItemKind::kEdge, "generation"));
  mesh.set_position(Vertex(0), {1, 1, 1});
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());
  EXPECT_EQ(mesh.add_attribute(ItemKind::kEdge, "generation").error().code, "attribute-exists");
  EXPECT_EQ(mesh.find_attribute(ItemKind::kVertex, "generation"), nullptr);
  ASSERT_TRUE(mesh.redo());
  EXPECT_EQ(mesh.position(Vertex(0)), (Point{1, 1, 1}));
  ASSERT_TRUE(mesh.undo());
  ASSERT_TRUE(mesh.add_attribute(ItemKind::kFace, "of the state that was gone back to"));
  EXPECT_FALSE(mesh.redo());
}

TEST(History, CompactingWithoutGapsIsNoStep) {
  Mesh mesh = with_history(tetrahedron());
  mesh.set_position(Vertex(0), {1, 1, 1});
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());
  const std::uint64_t version = mesh.version();
  const std::size_t bytes = mesh.history()->bytes();
  const Result<CompactMaps> maps = compact(mesh);
  ASSERT_TRUE(maps);
  EXPECT_EQ(maps.value()(Halfedge(5)), Halfedge(5));
  EXPECT_EQ(mesh.version(), version);
  EXPECT_FALSE(mesh.history()->has_open_step());
  EXPECT_EQ(mesh.history()->bytes(), bytes);
  ASSERT_TRUE(mesh.redo());
  EXPECT_EQ(mesh.position(Vertex(0)), (Point{1, 1, 1}));
}

TEST(History, UndoInvalidatesCirculators) {
  Mesh mesh = with_history(triangle());
  mesh.set_position(Vertex(0), {1, 1, 1});
  mesh.end_step();
  const std::uint64_t version = mesh.version();
  ASSERT_TRUE(mesh.undo());
  EXPECT_NE(mesh.version(), version);
}

}  // namespace
}  // namespace halfedge::test
