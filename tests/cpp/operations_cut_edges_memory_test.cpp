// Where memory ends, cutting a set of edges says so and changes nothing, at whichever of its steps.

#include <gtest/gtest.h>
#include <halfedge/operations/cut.h>
#include <halfedge/shapes/shapes.h>
#include <halfedge/validate/validate.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "support/complexes.h"
#include "support/limited_memory.h"

namespace halfedge::test {
namespace {

#if defined(HALFEDGE_CAN_LIMIT_MEMORY)

[[noreturn]] void cut_with_more_and_more_memory() {
  const Mesh start = shapes::mesh_of(shapes::torus(60, 60)).value();
  const Snapshot before(start);
  std::vector<Edge> edges;
  for (const Edge e : start.edges()) edges.push_back(e);
  std::set<std::string> messages;
  bool can_before = false;
  constexpr std::size_t kStep = std::size_t{32} << 10U;
  for (std::size_t failures = 0, more = 0;; ++failures, more += kStep * (1 + failures / 8)) {
    Mesh mesh = copy_of(start);
    const std::uint64_t version = mesh.version();
    PiecesForErrors pieces;
    if (!limit_address_space(address_space_in_use() + more)) std::_Exit(2);
    pieces.give_back();
    const Result<void> can = operations::check_cut_edges(mesh, edges);
    const Result<Array<Halfedge>> copies = operations::cut_edges(mesh, edges);
    stop_limiting_memory();
    if (!can && can.error().code != "out-of-memory") std::_Exit(3);
    if (can_before && !can) std::_Exit(4);
    can_before = can.ok();
    if (copies) {
      if (has_errors(validate(mesh)) || mesh.vertex_count() != 4 * mesh.face_count()) std::_Exit(5);
      leave(can.ok() && messages.size() == 2);  // neither the list nor the copies fitted at first
    }
    if (copies.error().code != "out-of-memory") std::_Exit(6);
    if (mesh.version() != version || !(Snapshot(mesh) == before)) std::_Exit(7);
    messages.insert(copies.error().message);
  }
}

TEST(CutEdgesMemoryDeathTest, WhatDoesNotFitChangesNothing) {
  EXPECT_EXIT(cut_with_more_and_more_memory(), testing::ExitedWithCode(0), "");
}

#else

TEST(CutEdgesMemoryDeathTest, WhatDoesNotFitChangesNothing) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}

#endif

}  // namespace
}  // namespace halfedge::test
