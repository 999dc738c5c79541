#pragma once

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/mesh.h>

#include "support/shapes.h"

namespace halfedge::test {

/// The mesh of a shape, as the builder makes it.
template <class AnyMesh = Mesh>
AnyMesh built(const Shape& shape) {
  AnyMesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, shape.polygons(), report)) << shape.name;
  return mesh;
}

}  // namespace halfedge::test
