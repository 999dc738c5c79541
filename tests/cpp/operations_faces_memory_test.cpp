// Where memory ends, the operations on faces say so and change nothing; deleting needs none.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/operations/add_face.h>
#include <halfedge/operations/components.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/dissolve.h>
#include <halfedge/operations/holes.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/split_face.h>

#include <cstdlib>
#include <vector>

#include "support/built.h"
#include "support/limited_memory.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using namespace operations;

constexpr Index kMany = 100'000;

/// Two polygons back to back, and as many vertices again without a face.
Mesh pillow_of_many_corners() {
  std::vector<std::vector<Index>> faces(2);
  for (Index v = 0; v < kMany; ++v) faces[0].push_back(v);
  faces[1].assign(faces[0].rbegin(), faces[0].rend());
  return built({"", 2 * kMany, faces});
}

/// A ring of triangles, each of which shares one vertex with the next.
Mesh ring_of_triangles() {
  std::vector<std::vector<Index>> faces;
  for (Index v = 0; v < kMany; v += 2) faces.push_back({v, v + 1, (v + 2) % kMany});
  return built({"", kMany, faces});
}

[[noreturn]] void operate_without_memory() {
  Mesh pillow = pillow_of_many_corners();
  Mesh ring = ring_of_triangles();
  std::vector<Vertex> isolated;
  for (Index v = kMany; v < 2 * kMany; ++v) isolated.push_back(Vertex(v));
  Halfedge rim = ring.edge_halfedge(Edge(0));
  while (!ring.is_boundary(rim)) rim = ring.opposite(rim);
  use_up_memory();
  const std::uint64_t versions[] = {pillow.version(), ring.version()};
  const auto fails = [&](const auto& outcome) {
    return !outcome.ok() && outcome.error().code == "out-of-memory" &&
           pillow.version() == versions[0] && ring.version() == versions[1];
  };
  if (!fails(check_add_face(pillow, isolated))) std::_Exit(2);
  if (!fails(add_face(pillow, isolated))) std::_Exit(3);
  if (!fails(split_face(pillow, Face(0)))) std::_Exit(4);
  if (!fails(remove_edge(pillow, Edge(7)))) std::_Exit(5);
  if (!fails(dissolve_edge(pillow, Edge(7)))) std::_Exit(6);
  if (!fails(dissolve_vertex(pillow, Vertex(7)))) std::_Exit(7);
  if (!fails(delete_component(pillow, Face(0)))) std::_Exit(8);
  if (!fails(keep_largest_components(pillow, 1))) std::_Exit(9);
  if (!fails(fill_hole(ring, rim))) std::_Exit(10);
  if (!fails(insert_edge(ring, rim, ring.prev(ring.prev(ring.prev(rim)))))) std::_Exit(11);

  // Small ones fail as soon as the arrays are full.
  for (std::size_t i = 0; i + 3 <= isolated.size(); i += 3) {
    const Index faces = pillow.face_slots();
    const Index edges = pillow.edge_slots();
    const std::uint64_t version = pillow.version();
    const Result<Face> added = add_face(pillow, {&isolated[i], 3});
    if (added.ok()) continue;
    if (added.error().code != "out-of-memory" || pillow.version() != version ||
        pillow.face_slots() != faces || pillow.edge_slots() != edges ||
        !pillow.is_isolated(isolated[i])) {
      std::_Exit(12);
    }
    const bool are_deleted =
        delete_vertex(pillow, Vertex(0)).ok() && delete_edge(ring, Edge(0)).ok() &&
        delete_face(ring, *ring.faces().begin()).ok() && delete_isolated_vertices(pillow) > 0;
    leave(are_deleted && !pillow.is_live(Vertex(0)) && !ring.is_live(Edge(0)));
  }
  std::_Exit(13);
}

TEST(OperationsOnFacesMemoryDeathTest, WhatDoesNotFitChangesNothing) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(operate_without_memory(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace halfedge::test
