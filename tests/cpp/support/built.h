#pragma once

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <string>

#include "support/shapes.h"

namespace halfedge::test {

/// The mesh of a shape, as the builder makes it.
template <class AnyMesh = Mesh>
AnyMesh built(const Shape& shape) {
  AnyMesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, shape.polygons(), report)) << shape.name;
  EXPECT_EQ(report.problem_count, 0U) << shape.name;
  EXPECT_TRUE(report.problems.empty()) << shape.name;
  return mesh;
}

/// That nothing is wrong with it; what is only told about is fine.
inline void expect_valid(const Mesh& mesh, const std::string& name) {
  for (const Problem& problem : validate(mesh)) {
    if (problem.severity == Severity::kError) ADD_FAILURE() << name << ": " << problem.message;
  }
}

}  // namespace halfedge::test
