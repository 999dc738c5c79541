#pragma once

#include <halfedge/build/build.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/random_polygons.h"

namespace halfedge::test {

/// What an operation should leave, as lists of polygons: made by hand, independent of links.
using PolygonList = std::vector<std::vector<Index>>;

inline std::vector<Index> polygon_of(const Mesh& mesh, Face f) {
  return corners_of(mesh, mesh.face_halfedge(f));
}

inline PolygonList polygons_of(const Mesh& mesh) {
  PolygonList all;
  for (const Face f : mesh.faces()) all.push_back(polygon_of(mesh, f));
  return all;
}

/// Each polygon beginning with its smallest vertex, in order: equal means the same faces.
inline PolygonList canonical(PolygonList polygons) {
  for (std::vector<Index>& polygon : polygons) {
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  }
  std::sort(polygons.begin(), polygons.end());
  return polygons;
}

inline std::set<std::pair<Index, Index>> edges_of(const PolygonList& polygons) {
  std::set<std::pair<Index, Index>> edges;
  for (const std::vector<Index>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      edges.insert(std::minmax(polygon[i], polygon[(i + 1) % polygon.size()]));
    }
  }
  return edges;
}

/// Whether these polygons are a mesh: no edge with two faces on one side, no fan closed beside
/// others, no vertex twice in a face.
inline bool is_mesh(const PolygonList& polygons) {
  Index vertices = 0;
  for (const std::vector<Index>& polygon : polygons) {
    const std::set<Index> different(polygon.begin(), polygon.end());
    if (polygon.size() < 3 || different.size() != polygon.size()) return false;
    vertices = std::max(vertices, *different.rbegin() + 1);
  }
  const Shape shape("", vertices, polygons);
  Mesh mesh;
  BuildReport report;
  return build_from_polygons(mesh, shape.polygons(), report) && !has_errors(validate(mesh));
}

/// Valid for every purpose.
inline void expect_valid_mesh(const Mesh& mesh) {
  const std::vector<Problem> problems = validate(mesh);
  for (const Problem& problem : problems) {
    EXPECT_NE(problem.severity, Severity::kError) << problem.message;
  }
  EXPECT_TRUE(Invariants(mesh).hold());
}

/// Meshes of each topology, regular and random, with attributes and history.
inline std::vector<std::pair<std::string, Mesh>> meshes_to_sweep(std::uint32_t seeds) {
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < seeds; ++seed) shapes.push_back(random_polygons(seed));
  std::vector<std::pair<std::string, Mesh>> all;
  for (const Shape& shape : shapes) {
    Mesh mesh = reference_build(shape);
    add_attributes_of_all_kinds(mesh);
    all.emplace_back(shape.name, std::move(mesh));
  }
  return all;
}

/// Runs an operation on a copy with history: it must agree with its check, leave a valid mesh or
/// everything as it was, and be undone and redone exactly. Returns the changed mesh, or that
/// before.
template <class Check, class Operation>
Mesh try_operation(const Mesh& before, const Check& check, const Operation& operation, bool& done) {
  Mesh mesh = copy_of(before);
  EXPECT_TRUE(mesh.enable_history());
  const Snapshot snapshot(mesh);
  const Result<void> can = check(std::as_const(mesh));
  const auto result = operation(mesh);
  done = result.ok();
  EXPECT_EQ(can.ok(), result.ok());
  if (!result.ok()) {
    expect_refused(result, can.ok() ? "" : can.error().code, mesh, snapshot);
    return mesh;
  }
  expect_valid_mesh(mesh);
  const Snapshot after(mesh);
  mesh.end_step();
  const bool is_changed = !(after == snapshot);
  EXPECT_EQ(mesh.undo(), is_changed);
  EXPECT_TRUE(Snapshot(mesh) == snapshot);
  EXPECT_EQ(mesh.redo(), is_changed);
  EXPECT_TRUE(Snapshot(mesh) == after);
  return mesh;
}

}  // namespace halfedge::test
