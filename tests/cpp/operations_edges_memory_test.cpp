// Where memory ends, the operations on edges and vertices say so and change nothing; what only
// deletes needs none.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/flip.h>
#include <halfedge/operations/split_edge.h>
#include <halfedge/operations/split_vertex.h>

#include <cstdlib>

#include "support/limited_memory.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using namespace operations;

[[noreturn]] void operate_without_memory() {
  const Shape shape = triangle_grid(150, 150);
  Mesh mesh;
  BuildReport report;
  if (!build_from_polygons(mesh, shape.polygons(), report)) std::_Exit(2);
  const Vertex inside(151 * 75 + 75);
  const Halfedge hl = mesh.vertex_halfedge(inside);
  const Halfedge hr = mesh.rotate_cw(mesh.rotate_cw(hl));
  use_up_memory();
  for (Index i = 0; i < mesh.edge_slots(); ++i) {
    if (split_edge(mesh, Edge(i)).ok()) continue;  // until the arrays are full
    const std::uint64_t version = mesh.version();
    const auto fails = [&](const auto& outcome) {
      return !outcome.ok() && outcome.error().code == "out-of-memory" && mesh.version() == version;
    };
    if (!fails(split_edge(mesh, Edge(i)))) std::_Exit(3);
    if (!fails(split_vertex(mesh, hl, hr))) std::_Exit(4);
    // An edge may fit where three don't.
    Result<Vertex> inserted = insert_vertex_on_edge(mesh, Edge(i));
    while (inserted.ok()) inserted = insert_vertex_on_edge(mesh, Edge(i));
    const std::uint64_t full = mesh.version();
    if (insert_vertex_on_edge(mesh, Edge(i)).ok() || mesh.version() != full) std::_Exit(5);
    if (inserted.error().code != "out-of-memory") std::_Exit(6);
    bool is_flipped = false;
    bool is_collapsed = false;
    for (Index e = i + 1; e < mesh.edge_slots() && !is_collapsed; ++e) {
      is_flipped = is_flipped || flip_edge(mesh, Edge(e)).ok();
      is_collapsed = is_flipped && collapse(mesh, mesh.edge_halfedge(Edge(e))).ok();
    }
    leave(is_collapsed && split_edge(mesh, Edge(i)).ok());  // in the slots that are free now
  }
  std::_Exit(7);
}

TEST(OperationsOnEdgesMemoryDeathTest, WhatDoesNotFitChangesNothing) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(operate_without_memory(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace halfedge::test
