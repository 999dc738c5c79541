#pragma once

#include <gtest/gtest.h>

#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {

inline Shape octahedron() {
  return {"octahedron",
          6,
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}};
}

inline Shape two_triangles() { return {"two triangles", 4, {{0, 1, 2}, {0, 2, 3}}}; }

/// The halfedge from one vertex to another.
inline Halfedge halfedge(const Mesh& mesh, Index from, Index to) {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  EXPECT_TRUE(h.valid()) << "from " << from << " to " << to;
  return h;
}

}  // namespace halfedge::test
