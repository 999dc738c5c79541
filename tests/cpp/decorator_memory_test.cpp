// Where memory ends, the operations of the decorator say so and change nothing.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/decorator/decorator.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "support/limited_memory.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using namespace decorator;

constexpr Index kCorners = 300'000;

// Two polygons of many corners, so that most operations want a lot of memory at once.
Mesh two_polygons() {
  std::vector<std::vector<Index>> faces(2);
  for (Index v = 0; v < 2 * kCorners; ++v) faces[v / kCorners].push_back(v);
  const Shape shape{"two polygons", 2 * kCorners, faces};
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, shape.polygons(), report));
  return mesh;
}

bool equal(const Mesh& a, const Mesh& b) {
  const auto same = [](const auto& x, const auto& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end());
  };
  return same(a.links().next, b.links().next) && same(a.links().prev, b.links().prev) &&
         same(a.links().to_vertex, b.links().to_vertex) && same(a.links().face, b.links().face) &&
         same(a.links().vertex_halfedge, b.links().vertex_halfedge) &&
         same(a.links().face_halfedge, b.links().face_halfedge) &&
         same(a.positions(), b.positions()) && a.free_edges().count == b.free_edges().count &&
         a.free_vertices().count == b.free_vertices().count &&
         a.free_faces().count == b.free_faces().count;
}

[[noreturn]] void operate_without_memory() {
  Mesh mesh = two_polygons();
  const Mesh before = two_polygons();
  const Halfedge h = mesh.face_halfedge(Face(0));
  const Halfedge g = mesh.face_halfedge(Face(1));
  std::vector<Halfedge> cycle;
  for (const Halfedge on_loop : mesh.loop_ccw(h)) cycle.push_back(on_loop);
  use_up_memory();
  const auto fails = [&](const auto& outcome) {
    return !outcome.ok() && outcome.error().code == "out-of-memory" && equal(mesh, before);
  };
  if (!fails(create_center_vertex(mesh, h))) std::_Exit(3);
  if (!fails(split_loop(mesh, cycle))) std::_Exit(4);
  if (!fails(join_loop(mesh, h, mesh.opposite(g)))) std::_Exit(5);
  if (!fails(erase_face(mesh, h))) std::_Exit(6);
  if (!fails(erase_connected_component(mesh, h))) std::_Exit(7);
  if (!fails(keep_largest_connected_components(mesh, 1))) std::_Exit(8);
  if (!fails(normalize_boundary(mesh))) std::_Exit(9);
  // Small ones fail as soon as the arrays are full.
  for (int i = 0; i < 100'000; ++i) {
    const Index vertices = mesh.vertex_count();
    const Index edges = mesh.edge_count();
    const Index slots = mesh.vertex_slots();
    const Result<Halfedge> split = split_edge(mesh, h);
    if (split.ok()) continue;
    leave(split.error().code == "out-of-memory" && mesh.vertex_count() == vertices &&
          mesh.edge_count() == edges && mesh.vertex_slots() == slots &&
          mesh.next(mesh.prev(h)) == h);
  }
  std::_Exit(10);
}

TEST(DecoratorMemoryDeathTest, WhatDoesNotFitChangesNothing) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(operate_without_memory(), testing::ExitedWithCode(0), "");
}

// The arrays grow by half, so that many operations are not quadratic.
TEST(DecoratorMemory, GrowsInSteps) {
  Mesh mesh;
  const Halfedge h = make_segment(mesh).value();
  std::size_t growths = 0;
  std::size_t capacity = 0;
  for (int i = 0; i < 20'000; ++i) {
    ASSERT_TRUE(split_edge(mesh, h).ok());
    growths += mesh.links().next.capacity() != capacity ? 1 : 0;
    capacity = mesh.links().next.capacity();
    ASSERT_LE(mesh.mutable_positions().capacity(), 6 * std::size_t{mesh.vertex_slots()} + 200);
  }
  EXPECT_LT(growths, 30U);
}

}  // namespace
}  // namespace halfedge::test
