#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/repair/repair.h>
#include <halfedge/repair/transfer.h>

#include <cstddef>
#include <cstdlib>
#include <utility>

#include "support/limited_memory.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

#if defined(HALFEDGE_CAN_LIMIT_MEMORY)

// A soup with something for every step.
Shape damaged_grid() {
  Shape grid = triangle_grid(150, 150);
  for (std::size_t f = 0; f < grid.faces.size(); f += 7) {
    std::swap(grid.faces[f][0], grid.faces[f][1]);
  }
  for (std::size_t f = 0; f < 20'000; f += 11) grid.faces.push_back(grid.faces[f]);
  for (Index v = 0; v + 1000 < grid.vertices; v += 13) grid.faces.push_back({v, v + 1, v + 900});
  return {"damaged grid", grid.vertices, grid.faces};
}

[[noreturn]] void repair_with_more_and_more_memory() {
  const Shape shape = damaged_grid();
  constexpr std::size_t kStep = std::size_t{256} << 10U;
  const std::size_t in_use = use_up_memory();
  for (int failures = 0;; ++failures) {
    if (!limit_address_space(in_use + kStep * std::size_t(failures))) std::_Exit(2);
    Mesh mesh;
    RepairReport report;
    if (build_from_soup(mesh, shape.polygons(), {.weld = 1e-9}, report)) {
      std::_Exit(failures > 20 ? 0 : 3);
    }
    if (report.problems.size() != 1 || report.problems[0].code != "out-of-memory") std::_Exit(4);
    if (mesh.vertex_slots() != 0 || !report.face_map.empty()) std::_Exit(5);
  }
}

TEST(RepairMemoryDeathTest, WhereverMemoryEndsTheRepairEndsInAnError) {
  EXPECT_EXIT(repair_with_more_and_more_memory(), testing::ExitedWithCode(0), "");
}

/// A column of twos for each corner of the grid, which needs a look at each face to be filled in.
SoupAttribute column_of_corners(const Shape& shape) {
  SoupAttribute column;
  column.name = "two";
  column.item = SoupItem::kCorner;
  column.type = Scalar::kUint8;
  if (!column.values.resize(3 * shape.faces.size(), std::byte{2})) std::_Exit(2);
  return column;
}

[[noreturn]] void transfer_with_more_and_more_memory() {
  const Shape shape = triangle_grid(150, 150);
  const Polygons soup = shape.polygons();
  Mesh mesh;
  BuildReport report;
  if (!build_from_polygons(mesh, soup, report)) std::_Exit(2);
  constexpr std::size_t kStep = std::size_t{16} << 10U;
  for (int failures = 0;; ++failures) {
    SoupAttribute column = column_of_corners(shape);
    leave_memory(kStep * std::size_t(failures));
    const bool done = add_attributes(mesh, soup, nullptr, {&column, 1}).ok();
    if (!limit_address_space(RLIM_INFINITY)) std::_Exit(2);
    const Attribute* const added = mesh.find_attribute(ItemKind::kHalfedge, "two");
    if ((added != nullptr) != done) std::_Exit(3);
    if (!done) continue;
    for (const Halfedge h : mesh.halfedges()) {
      if (added->get(h.index(), 0) != 2) std::_Exit(4);
    }
    std::_Exit(failures > 8 ? 0 : 5);
  }
}

TEST(RepairMemoryDeathTest, AColumnThatCannotBeFilledInIsNotThere) {
  EXPECT_EXIT(transfer_with_more_and_more_memory(), testing::ExitedWithCode(0), "");
}

#else

TEST(RepairMemoryDeathTest, AColumnThatCannotBeFilledInIsNotThere) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}

TEST(RepairMemoryDeathTest, WhereverMemoryEndsTheRepairEndsInAnError) {
  GTEST_SKIP() << "memory can be limited on Linux only, and not under AddressSanitizer";
}

#endif

}  // namespace
}  // namespace halfedge::test
