// Meshes made of nothing, of other meshes and of bytes, where memory ends: an error comes back, and
// nothing has changed.

#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/limited_memory.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

template <class T>
bool is_out_of_memory(const Result<T>& result) {
  return !result.ok() && result.error().code == "out-of-memory";
}

[[noreturn]] void make_without_memory() {
  Mesh mesh = reference_build(quad_grid(300, 300));
  const Snapshot before(mesh);
  const Result<Array<std::uint8_t>> bytes = to_bytes(mesh);
  const std::vector<Index> some = {0, 5};
  const Mesh prism = shapes::mesh_of(shapes::prism(100000)).value();
  const std::vector<Index> base = {100000};
  Mesh empty;
  use_up_memory();
  if (!is_out_of_memory(shapes::grid(900, 900))) std::_Exit(2);
  if (!is_out_of_memory(shapes::ico_sphere(8))) std::_Exit(3);
  if (!is_out_of_memory(append(mesh, mesh))) std::_Exit(4);
  if (!is_out_of_memory(append(empty, mesh))) std::_Exit(5);
  if (!is_out_of_memory(dual(mesh, empty))) std::_Exit(6);
  if (!is_out_of_memory(extract(mesh, some, empty))) std::_Exit(11);
  if (!is_out_of_memory(to_bytes(mesh))) std::_Exit(7);
  if (!is_out_of_memory(from_bytes(bytes.value().span(), empty))) std::_Exit(8);
  if (!is_out_of_memory(k_ring(mesh, some, kNone))) std::_Exit(9);
  if (!is_out_of_memory(star(mesh, {.faces = some}))) std::_Exit(10);
  if (!is_out_of_memory(to_triangles(mesh))) std::_Exit(11);
  if (!is_out_of_memory(to_triangles(prism, base))) std::_Exit(12);
  // Whatever of this was done in part is gone.
  leave(empty.vertex_slots() == 0 && mesh.halfedge_slots() == before.links[0].size() &&
        std::equal(before.links[0].begin(), before.links[0].end(), mesh.links().next.begin()));
}

TEST(MakingDeathTest, WithoutMemoryIsAnErrorAndChangesNothing) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(make_without_memory(), testing::ExitedWithCode(0), "");
}

#if defined(HALFEDGE_CAN_LIMIT_MEMORY)

// A face of many corners, whose triangles take memory in many places.
[[noreturn]] void cut_with_more_and_more_memory() {
  constexpr Index kCorners = 20000;
  const Mesh prism = shapes::mesh_of(shapes::prism(kCorners)).value();
  const std::vector<Index> base = {kCorners};
  constexpr std::size_t kStep = std::size_t{16} << 10U;
  for (int failures = 0;; ++failures) {
    leave_memory(kStep * std::size_t(failures));
    const Result<TriangleList> triangles = to_triangles(prism, base);
    stop_limiting_memory();
    if (!triangles && is_out_of_memory(triangles)) continue;
    leave(triangles.ok() && triangles.value().faces.size() == kCorners - 2 && failures > 8);
  }
}

TEST(MakingDeathTest, TrianglesComeWholeOrNotAtAll) {
  EXPECT_EXIT(cut_with_more_and_more_memory(), testing::ExitedWithCode(0), "");
}

// Faces that the new type derives need room in the attributes of faces, too.
[[noreturn]] void derive_faces_with_more_and_more_memory() {
  constexpr Index kLoops = 5000;
  constexpr std::size_t kStep = std::size_t{16} << 10U;
  for (int failures = 0;; ++failures) {
    BasicConnectivity<kWithoutFaces> from;
    for (Index i = 0; i < kLoops; ++i) (void)decorator::make_loop(from);
    if (!from.add_attribute(ItemKind::kFace, "color", {.components = 16})) std::_Exit(3);
    BasicConnectivity<Storage{.face = false}> to;
    leave_memory(kStep * std::size_t(failures));
    const Result<void> converted = convert(std::move(from), to);
    stop_limiting_memory();
    if (is_out_of_memory(converted) && from.edge_count() == kLoops) continue;
    leave(converted.ok() && to.face_slots() == 2 * kLoops && failures > 8 &&
          to.find_attribute(ItemKind::kFace, "color")->slots() == 2 * kLoops);
  }
}

TEST(MakingDeathTest, DerivedFacesComeWithTheirAttributesOrNotAtAll) {
  EXPECT_EXIT(derive_faces_with_more_and_more_memory(), testing::ExitedWithCode(0), "");
}

#endif

}  // namespace
}  // namespace halfedge::test
