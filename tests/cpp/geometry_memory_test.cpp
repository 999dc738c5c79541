// Where memory ends, what takes some says so.

#include <gtest/gtest.h>
#include <halfedge/geometry/geometry.h>
#include <halfedge/shapes/shapes.h>

#include <cstdlib>

#include "support/limited_memory.h"

namespace halfedge::test {
namespace {

template <class T>
bool is_out_of_memory(const Result<T>& result) {
  return !result.ok() && result.error().code == "out-of-memory";
}

[[noreturn]] void measure_without_memory() {
  const Mesh open = shapes::mesh_of(shapes::grid(100, 100)).value();
  const Mesh closed = shapes::mesh_of(shapes::torus(100, 100)).value();
  use_up_memory();
  if (!is_out_of_memory(geometry::face_normals(open))) std::_Exit(2);
  if (!is_out_of_memory(geometry::vertex_normals(open))) std::_Exit(3);
  if (!is_out_of_memory(geometry::volume(open))) std::_Exit(4);
  leave(geometry::volume(closed).ok());
}

TEST(GeometryDeathTest, WithoutMemoryIsAnError) {
  HALFEDGE_NEEDS_A_MEMORY_LIMIT();
  EXPECT_EXIT(measure_without_memory(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace halfedge::test
