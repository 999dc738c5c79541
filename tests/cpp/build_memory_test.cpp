#include <gtest/gtest.h>
#include <halfedge/build/build.h>

#include <cstddef>
#include <cstdlib>

#include "support/limited_memory.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

#if defined(HALFEDGE_CAN_LIMIT_MEMORY)

// Builds with ever more memory until there is enough. Exits with 0 if each build before that ended
// in an error with a sentence, and there were many of them.
[[noreturn]] void build_with_more_and_more_memory(const Shape& shape) {
  constexpr std::size_t kStep = std::size_t{1} << 18U;
  const std::size_t in_use = use_up_memory();
  for (int failures = 0;; ++failures) {
    if (!limit_address_space(in_use + kStep * std::size_t(failures))) std::_Exit(2);
    Mesh mesh;
    BuildReport report;
    if (build_from_polygons(mesh, shape.polygons(), report)) std::_Exit(failures > 20 ? 0 : 3);
    if (report.problem_count != 1 || report.problems[0].code != "out-of-memory") std::_Exit(4);
    if (report.problems[0].message !=
        "There is not enough memory for a mesh of 251001 vertices and 500000 faces.") {
      std::_Exit(5);
    }
    if (mesh.vertex_slots() != 0) std::_Exit(6);
  }
}

TEST(BuildMemoryDeathTest, WhereverMemoryEndsTheBuildEndsInAnError) {
  const Shape shape = triangle_grid(500, 500);
  EXPECT_EXIT(build_with_more_and_more_memory(shape), testing::ExitedWithCode(0), "");
}

TEST(BuildMemoryDeathTest, TheSameForFacesInRandomOrder) {
  const Shape shape = in_random_order(triangle_grid(500, 500));
  EXPECT_EXIT(build_with_more_and_more_memory(shape), testing::ExitedWithCode(0), "");
}

#else

TEST(BuildMemoryDeathTest, TheSameForFacesInRandomOrder) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}
TEST(BuildMemoryDeathTest, WhereverMemoryEndsTheBuildEndsInAnError) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}

#endif

}  // namespace
}  // namespace halfedge::test
