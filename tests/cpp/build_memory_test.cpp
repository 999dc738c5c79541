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
// in an error with this sentence, there were many of them, and the mesh has so many edges then.
[[noreturn]] void build_with_more_and_more_memory(const Shape& shape, const char* sentence,
                                                  Index edges) {
  constexpr std::size_t kStep = std::size_t{1} << 18U;
  const std::size_t in_use = use_up_memory();
  for (int failures = 0;; ++failures) {
    if (!limit_address_space(in_use + kStep * std::size_t(failures))) std::_Exit(2);
    Mesh mesh;
    BuildReport report;
    if (build_from_polygons(mesh, shape.polygons(), report)) {
      std::_Exit(mesh.edge_count() != edges ? 7 : failures > 20 ? 0 : 3);
    }
    if (report.problem_count != 1 || report.problems[0].code != "out-of-memory") std::_Exit(4);
    if (report.problems[0].message != sentence) std::_Exit(5);
    if (mesh.vertex_slots() != 0) std::_Exit(6);
  }
}

constexpr const char* kNotEnoughForGrid =
    "There is not enough memory for a mesh of 251001 vertices and 500000 faces.";

TEST(BuildMemoryDeathTest, WhereverMemoryEndsTheBuildEndsInAnError) {
  const Shape shape = triangle_grid(500, 500);
  EXPECT_EXIT(build_with_more_and_more_memory(shape, kNotEnoughForGrid, 751'000),
              testing::ExitedWithCode(0), "");
}

TEST(BuildMemoryDeathTest, TheSameForFacesInRandomOrder) {
  const Shape shape = in_random_order(triangle_grid(500, 500));
  EXPECT_EXIT(build_with_more_and_more_memory(shape, kNotEnoughForGrid, 751'000),
              testing::ExitedWithCode(0), "");
}

// Each has an edge for which its group has no places: all arrays are made larger once more.
TEST(BuildMemoryDeathTest, TheSameForLooseTriangles) {
  const Shape shape = loose_triangles(200'000);
  EXPECT_EXIT(
      build_with_more_and_more_memory(
          shape, "There is not enough memory for a mesh of 600000 vertices and 200000 faces.",
          600'000),
      testing::ExitedWithCode(0), "");
}

#else

TEST(BuildMemoryDeathTest, TheSameForFacesInRandomOrder) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}
TEST(BuildMemoryDeathTest, TheSameForLooseTriangles) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}
TEST(BuildMemoryDeathTest, WhereverMemoryEndsTheBuildEndsInAnError) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}

#endif

}  // namespace
}  // namespace halfedge::test
