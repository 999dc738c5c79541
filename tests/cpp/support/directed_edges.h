#pragma once

// Meshes of Directed Edges, and their comparison with full meshes of the same triangles.

#include <gtest/gtest.h>
#include <halfedge/directed_edges/build.h>
#include <halfedge/validate/validate.h>

#include <string>
#include <utility>
#include <vector>

#include "support/shapes.h"

namespace halfedge::test {

/// Each face as a fan of triangles around its first corner.
inline Shape triangulated(const Shape& shape) {
  std::vector<std::vector<Index>> faces;
  for (const std::vector<Index>& face : shape.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) faces.push_back({face[0], face[i - 1], face[i]});
  }
  return {shape.name, shape.vertices, std::move(faces)};
}

/// The mesh of these triangles.
inline DirectedEdgesMesh built(const Shape& shape) {
  DirectedEdgesMesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_triangles(mesh, shape.polygons(), report)) << report.problems[0].message;
  return mesh;
}

/// That both have the same items, and that all circulators in both directions and all queries give
/// the same, element for element.
void expect_same(const DirectedEdgesMesh& compact, const Mesh& full);

void expect_same_links(const DirectedEdges& a, const DirectedEdges& b);

/// That both builders make the same of these triangles, and both conversions, too.
void expect_equivalent(const Polygons& triangles);

/// The first of the problems; none if there is no error among them.
std::string first_problem(const std::vector<Problem>& problems);

}  // namespace halfedge::test
