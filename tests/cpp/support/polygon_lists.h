#pragma once

#include <set>
#include <utility>
#include <vector>

#include "support/face_lists.h"
#include "support/sweep.h"

namespace halfedge::test {

/// From to_vertex(face_halfedge(f)) on.
inline std::vector<Index> polygon_of(const Mesh& mesh, Face f) {
  return corners_of(mesh, mesh.face_halfedge(f));
}

/// In the order of the faces.
inline Polys polygons_of(const Mesh& mesh) {
  Polys all;
  for (const Face f : mesh.faces()) all.push_back(polygon_of(mesh, f));
  return all;
}

/// Whether these faces are a mesh: no edge with two faces on one side, no fan closed beside
/// others, no vertex twice in a face.
inline bool is_mesh(const Polys& faces) {
  Index vertices = 0;
  for (const std::vector<Index>& face : faces) {
    const std::set<Index> different(face.begin(), face.end());
    if (face.size() < 3 || different.size() != face.size()) return false;
    vertices = std::max(vertices, *different.rbegin() + 1);
  }
  return buildable(vertices, faces).has_value();
}

/// Valid for every purpose.
inline void expect_valid_mesh(const Mesh& mesh) {
  for (const Problem& problem : validate(mesh)) {
    EXPECT_NE(problem.severity, Severity::kError) << problem.message;
  }
  EXPECT_TRUE(Invariants(mesh).hold());
}

/// As holds_contract; returns the mesh afterwards.
template <class Check, class Operate>
Mesh try_operation(const Mesh& mesh, const Check& check, const Operate& operate, bool& done) {
  Mesh after;
  done = holds_contract(mesh, check, operate, after);
  return after;
}

}  // namespace halfedge::test
