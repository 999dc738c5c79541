#include <gtest/gtest.h>
#include <halfedge/directed_edges/build.h>
#include <halfedge/directed_edges/convert.h>

#include <cstdlib>

#include "support/limited_memory.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

#if defined(HALFEDGE_CAN_LIMIT_MEMORY)

// Exits with 0 if each build and conversion that memory didn't suffice for ended in an error.
[[noreturn]] void build_with_more_and_more_memory(const Shape& shape) {
  constexpr std::size_t kStep = std::size_t{1} << 20U;
  const std::size_t in_use = use_up_memory();
  for (int failures = 0;; ++failures) {
    if (!limit_address_space(in_use + kStep * std::size_t(failures))) std::_Exit(2);
    DirectedEdgesMesh mesh;
    Mesh full;
    BuildReport report;
    if (build_from_triangles(mesh, shape.polygons(), report)) {
      const Result<void> converted = to_mesh(mesh, full);
      const Result<void> back = converted ? from_mesh(full, mesh) : Result<void>{};
      if (converted && back) std::_Exit(failures > 20 ? 0 : 3);
      const Error& error = (converted ? back : converted).error();
      if (error.code != "out-of-memory") std::_Exit(4);
      if ((converted ? mesh.vertex_count() : full.vertex_slots()) != 0) std::_Exit(5);
    } else if (report.problem_count != 1 || report.problems[0].code != "out-of-memory" ||
               mesh.vertex_count() != 0) {
      std::_Exit(6);
    }
  }
}

TEST(DirectedEdgesMemoryDeathTest, WhereverMemoryEndsTheBuildEndsInAnError) {
  const Shape shape = triangle_grid(400, 400);
  EXPECT_EXIT(build_with_more_and_more_memory(shape), testing::ExitedWithCode(0), "");
}

#endif

}  // namespace
}  // namespace halfedge::test
