// Wherever memory ends, an error comes back and nothing is lost. The address space is limited in a
// process of its own, since no allocation is so large that a machine is sure to refuse it.

#include <gtest/gtest.h>
#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "support/limited_memory.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

bool same(const Links& a, const Links& b) {
  const auto equal = [](const Array<Index>& x, const Array<Index>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end());
  };
  return equal(a.next, b.next) && equal(a.prev, b.prev) && equal(a.to_vertex, b.to_vertex) &&
         equal(a.face, b.face) && equal(a.vertex_halfedge, b.vertex_halfedge) &&
         equal(a.face_halfedge, b.face_halfedge);
}

[[noreturn]] void add_items_without_memory() {
  Mesh mesh = reference_build(cube());
  const Mesh before = reference_build(cube());
  use_up_memory();
  if (mesh.reserve(1U << 20U, 0, 0) || mesh.reserve(0, 1U << 20U, 0) ||
      mesh.reserve(0, 0, 1U << 20U) || !same(mesh.links(), before.links())) {
    std::_Exit(3);
  }
  Index vertices = 0;
  while (mesh.add_vertex({1, 2, 3}).valid()) ++vertices;
  if (mesh.vertex_count() != 8 + vertices || mesh.positions().size() != 3 * mesh.vertex_slots()) {
    std::_Exit(4);
  }
  Index edges = 0;
  while (mesh.new_edge(Vertex(0), Vertex(1)).valid()) ++edges;
  if (mesh.edge_count() != 12 + edges || mesh.links().face.size() != mesh.halfedge_slots()) {
    std::_Exit(5);
  }
  Index faces = 0;
  while (mesh.new_face(Halfedge(0)).valid()) ++faces;
  leave(mesh.face_count() == 6 + faces && mesh.position(Vertex(7)) == before.position(Vertex(7)));
}

TEST(MemoryDeathTest, ItemsThatDoNotFitAreEmptyHandles) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(add_items_without_memory(), testing::ExitedWithCode(0), "");
}

[[noreturn]] void assign_without_memory() {
  const Mesh large = reference_build(quad_grid(150, 150));
  Mesh copy = reference_build(cube());
  use_up_memory();
  leave(!copy.assign(large) && copy.vertex_slots() == 0 && copy.positions().empty() &&
        validate(copy).empty());
}

TEST(MemoryDeathTest, ACopyThatDoesNotFitIsEmpty) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(assign_without_memory(), testing::ExitedWithCode(0), "");
}

[[noreturn]] void query_without_memory() {
  const Mesh mesh = reference_build(quad_grid(300, 300));
  std::vector<Index> all(mesh.vertex_slots());
  Adjacency result;
  use_up_memory();
  const auto fails = [](const auto& outcome) {
    return !outcome.ok() && outcome.error().code == "out-of-memory" &&
           outcome.error().message.rfind("There is not enough memory", 0) == 0;
  };
  if (!fails(adjacency(mesh, Ring::kVertexFaces, Direction::kCcw, result))) std::_Exit(3);
  if (!result.offsets.empty() || !result.items.empty()) std::_Exit(4);
  if (!fails(adjacency(mesh, Ring::kVertexFaces, Direction::kCcw, all, result))) std::_Exit(5);
  if (!fails(boundary_loops(mesh)) || !fails(connected_components(mesh)) || !fails(genus(mesh))) {
    std::_Exit(6);
  }
  const auto left_out = [&mesh](int level) {
    const std::vector<Problem> problems = validate(mesh, level);
    return std::count_if(problems.begin(), problems.end(), [](const Problem& problem) {
      return problem.code == "out-of-memory" && problem.severity == Severity::kError;
    });
  };
  const auto of_links = left_out(kMaxValidationLevel);
  leave(of_links > 0 && left_out(kGeometryLevel) > of_links);
}

TEST(MemoryDeathTest, QueriesThatDoNotFitSaySo) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(query_without_memory(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace halfedge::test
