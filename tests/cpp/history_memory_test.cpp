// History needs memory that nobody asked for. Where that ends, what the caller wanted is done all
// the same; steps that can't be taken back any more are forgotten, never taken back by half.

#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "support/complexes.h"
#include "support/limited_memory.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

Mesh with_history(const Shape& shape) {
  Mesh mesh = reference_build(shape);
  if (!mesh.enable_history()) std::_Exit(2);
  return mesh;
}

/// What a process says if `holds` doesn't: the number of the expectation.
void expect(bool holds, int number) {
  if (!holds) std::_Exit(number);
}

/// Not even small blocks are left.
void use_up_all_memory() {
  use_up_memory();
  for (std::size_t size = 8192; size >= 64; size /= 2) {
    while (void* block = std::malloc(size)) *static_cast<volatile char*>(block) = 1;
  }
}

void move_all(Mesh& mesh, float by) {
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    const Point p = mesh.position(Vertex(v));
    mesh.set_position(Vertex(v), {p.x + by, p.y, p.z});
  }
}

// A note that finds no room: all steps are gone, and what was noted of the one underway.
[[noreturn]] void lose_a_step() {
  Mesh mesh = with_history(quad_grid(400, 400));
  mesh.set_position(Vertex(7), {1, 1, 1});
  mesh.end_step();
  expect(mesh.history()->undo_count() == 1, 3);
  use_up_memory();
  move_all(mesh, 1);  // 2.6 MB of notes
  expect(mesh.position(Vertex(7)) == Point{2, 1, 1}, 4);
  expect(mesh.history()->undo_count() == 0, 9);  // at once, which makes room
  // What is written once the notes are lost is noted again, and must not pass for a whole step.
  mesh.set_position(Vertex(7), {3, 3, 3});
  mesh.end_step();
  expect(mesh.history()->undo_count() == 0 && mesh.history()->bytes() == 0, 5);
  expect(!mesh.undo() && mesh.position(Vertex(7)) == Point{3, 3, 3}, 6);
  // History goes on with the next step, for which there is room again.
  mesh.set_position(Vertex(7), {4, 4, 4});
  mesh.end_step();
  expect(mesh.undo() && mesh.position(Vertex(7)) == Point{3, 3, 3}, 7);
  expect(mesh.redo() && mesh.position(Vertex(7)) == Point{4, 4, 4}, 8);
  stop_limiting_memory();
  leave(!has_errors(validate(mesh)));
}

TEST(HistoryMemoryDeathTest, AStepThatCannotBeNotedIsForgottenWithThoseBefore) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(lose_a_step(), testing::ExitedWithCode(0), "");
}

// The same while edges are deleted, which take nine words at once.
[[noreturn]] void lose_a_step_of_deletions() {
  Mesh mesh = with_history(quad_grid(300, 300));
  use_up_memory();
  for (Index f = 0; f < mesh.face_slots(); ++f) {
    if (!operations::delete_face(mesh, Face(f)).ok()) std::_Exit(3);
  }
  mesh.end_step();
  expect(mesh.face_count() == 0 && mesh.edge_count() == 0, 4);
  expect(mesh.history()->undo_count() == 0 && !mesh.undo(), 5);
  stop_limiting_memory();
  leave(!has_errors(validate(mesh)));
}

TEST(HistoryMemoryDeathTest, DeletionsThatCannotBeNotedAreDoneAllTheSame) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(lose_a_step_of_deletions(), testing::ExitedWithCode(0), "");
}

// A deleted edge that is the last note of its step, for which there is no room behind the others.
[[noreturn]] void delete_an_edge_without_memory() {
  Mesh mesh = with_history(tetrahedron());
  // 4092 words, of 4096 that are in one place.
  for (int i = 0; i < 1023; ++i) mesh.set_position(Vertex(0), {float(i), 0, 0});
  mesh.end_step();
  use_up_all_memory();
  mesh.release(Edge(0));
  mesh.end_step();
  leave(mesh.history()->undo_count() == 0 && !mesh.undo() && !mesh.is_live(Edge(0)));
}

TEST(HistoryMemoryDeathTest, ADeletedEdgeThatCannotBeNotedIsForgottenToo) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(delete_an_edge_without_memory(), testing::ExitedWithCode(0), "");
}

// A step whose notes have room, but not its end: the places of so many ends are full.
[[noreturn]] void end_a_step_without_memory() {
  constexpr int kChunk = 1024;
  Mesh mesh = with_history(tetrahedron());
  mesh.set_position(Vertex(1), {1, 1, 1});  // so that the chunks of notes end elsewhere
  for (int i = 0; i < kChunk; ++i) {
    mesh.set_position(Vertex(0), {float(i), 0, 0});
    mesh.end_step();
  }
  expect(mesh.history()->undo_count() == kChunk, 3);
  use_up_all_memory();
  mesh.set_position(Vertex(0), {-1, 0, 0});
  expect(mesh.history()->undo_count() == kChunk && mesh.history()->has_open_step(), 4);
  mesh.end_step();
  expect(mesh.history()->undo_count() == 0 && mesh.history()->bytes() == 0, 5);
  expect(!mesh.undo() && mesh.position(Vertex(0)).x == -1, 6);
  mesh.set_position(Vertex(0), {-2, 0, 0});
  mesh.end_step();
  leave(mesh.history()->undo_count() == 1 && mesh.undo() && mesh.position(Vertex(0)).x == -1);
}

TEST(HistoryMemoryDeathTest, AStepWhoseEndCannotBeNotedIsForgottenWithThoseBefore) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(end_a_step_without_memory(), testing::ExitedWithCode(0), "");
}

// Undo keeps what was in the slots that it drops. Where there is no room for that it undoes all the
// same, exactly, and there is nothing to redo.
[[noreturn]] void undo_without_memory() {
  Mesh mesh = with_history(tetrahedron());
  const Snapshot before(mesh);
  for (int i = 0; i < 20'000; ++i) expect(mesh.add_vertex({1, 2, 3}).valid(), 3);
  mesh.end_step();
  mesh.set_position(Vertex(5'000), {9, 9, 9});
  mesh.end_step();
  expect(mesh.undo() && mesh.history()->redo_count() == 1, 4);
  use_up_memory();
  expect(mesh.undo(), 5);
  expect(mesh.history()->redo_count() == 0 && !mesh.redo(), 6);
  expect(Snapshot(mesh) == before, 7);
  // The next step can be undone and redone: what it drops is little.
  expect(mesh.add_vertex({4, 5, 6}).valid(), 8);
  mesh.end_step();
  expect(mesh.undo() && Snapshot(mesh) == before, 9);
  expect(mesh.redo() && mesh.position(Vertex(4)) == Point{4, 5, 6}, 10);
  leave(!mesh.redo());
}

TEST(HistoryMemoryDeathTest, WhatIsUndoneWithoutRoomForRedoCannotBeRedone) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(undo_without_memory(), testing::ExitedWithCode(0), "");
}

// The maps are what can fail in compact, and all that is planned in reorder: nothing was noted
// before.
[[noreturn]] void renumber_without_memory(Result<CompactMaps> (*renumber)(Mesh&)) {
  Mesh mesh = with_history(quad_grid(150, 150));
  if (!operations::delete_face(mesh, Face(0)).ok()) std::_Exit(2);
  mesh.end_step();
  mesh.set_position(Vertex(7), {1, 1, 1});
  mesh.end_step();
  expect(mesh.undo() && mesh.history()->redo_count() == 1, 3);
  const std::size_t bytes = mesh.history()->bytes();
  use_up_memory();
  const Result<CompactMaps> maps = renumber(mesh);
  expect(!maps && maps.error().code == "out-of-memory", 4);
  expect(!mesh.history()->has_open_step() && mesh.history()->bytes() == bytes, 5);
  leave(mesh.redo() && mesh.position(Vertex(7)) == Point{1, 1, 1});
}

TEST(HistoryMemoryDeathTest, ACompactionThatDoesNotFitLeavesHistoryAlone) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(renumber_without_memory(compact), testing::ExitedWithCode(0), "");
}

TEST(HistoryMemoryDeathTest, AReorderingThatDoesNotFitLeavesHistoryAlone) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(renumber_without_memory(reorder), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(renumber_without_memory(reorder_breadth_first), testing::ExitedWithCode(0), "");
}

// The order of so few vertices fits, but no copy of this column of their halfedges.
[[noreturn]] void reorder_without_room_for_a_column() {
  Mesh mesh = reference_build(quad_grid(6, 6));
  std::reverse(mesh.mutable_positions().begin(), mesh.mutable_positions().end());
  expect(mesh.add_attribute(ItemKind::kHalfedge, "wide",
                            {.type = Scalar::kFloat64, .components = Attribute::kMaxComponents})
             .ok(),
         3);
  expect(mesh.enable_history(), 4);
  const Snapshot before(mesh);
  use_up_memory();
  const Result<CompactMaps> maps = reorder(mesh);
  expect(!maps && maps.error().code == "out-of-memory", 5);
  const bool has_changed = mesh.history()->has_open_step();
  stop_limiting_memory();
  leave(!has_changed && Snapshot(mesh) == before);
}

TEST(HistoryMemoryDeathTest, AReorderingThatDoesNotFitAtItsEndChangesNothing) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(reorder_without_room_for_a_column(), testing::ExitedWithCode(0), "");
}

// After compact a column made for what is left has to have room for what undo brings back.
[[noreturn]] void undo_a_compaction_without_memory() {
  Mesh mesh = with_history(quad_grid(400, 400));
  for (Index f = 100; f < mesh.face_slots(); ++f) {
    if (!operations::delete_face(mesh, Face(f)).ok()) std::_Exit(2);
  }
  expect(compact(mesh).ok() && mesh.face_count() == 100, 3);
  mesh.end_step();
  const double seven[] = {7};
  const Result<Attribute*> label =
      mesh.add_attribute(ItemKind::kFace, "label", {.default_value = seven});
  expect(label.ok(), 4);
  use_up_all_memory();
  expect(mesh.undo() && mesh.face_count() == 160'000, 5);
  leave(label.value()->get(159'999, 0) == 7);
}

TEST(HistoryMemoryDeathTest, AttributesHaveRoomForWhatUndoBringsBack) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(undo_a_compaction_without_memory(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace halfedge::test
