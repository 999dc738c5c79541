#pragma once

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/random_polygons.h"

namespace halfedge::test {

/// Faces as lists of vertices.
using Polys = std::vector<std::vector<Index>>;

/// Each from its smallest vertex on, in order: equal for the same faces.
inline Polys in_order(Polys faces) {
  for (std::vector<Index>& face : faces) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

inline Polys polys_of(const Mesh& mesh) {
  Polys faces;
  for (const Face f : mesh.faces()) faces.push_back(corners_of(mesh, mesh.face_halfedge(f)));
  return in_order(std::move(faces));
}

/// The number of edges that the strict builder makes of these faces, if it accepts them.
inline std::optional<Index> buildable(Index vertices, const Polys& faces) {
  Mesh mesh;
  BuildReport report;
  const Shape shape("", vertices, faces);
  if (!build_from_polygons(mesh, shape.polygons(), report)) return {};
  return mesh.edge_count();
}

/// One mesh of each topology, with attributes and history.
inline std::vector<std::pair<std::string, Mesh>> meshes_to_sweep(std::uint32_t random_ones = 8) {
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < random_ones; ++seed) shapes.push_back(random_polygons(seed));
  std::vector<std::pair<std::string, Mesh>> meshes;
  for (const Shape& shape : shapes) {
    if (shape.faces.size() > 60) continue;  // what is checked takes quadratic time
    Mesh mesh = reference_build(shape);
    add_attributes_of_all_kinds(mesh);
    meshes.emplace_back(shape.name, std::move(mesh));
  }
  return meshes;
}

/// That `apply` makes the same of a mesh without prev as of one with it.
template <class Apply>
void expect_same_without_prev(const Shape& shape, const Apply& apply) {
  BasicMesh<kWithoutPrev> light;
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(light, shape.polygons(), report));
  ASSERT_TRUE(build_from_polygons(mesh, shape.polygons(), report));
  apply(light);
  apply(mesh);
  EXPECT_TRUE(std::equal(light.links().next.begin(), light.links().next.end(),
                         mesh.links().next.begin(), mesh.links().next.end()));
  EXPECT_TRUE(std::equal(light.positions().begin(), light.positions().end(),
                         mesh.positions().begin(), mesh.positions().end()));
}

/// Whether `operate`, a function of a mesh, succeeds on a copy of `mesh`, which becomes `after`,
/// just if `check` says so; a success leaves a valid mesh and can be undone and redone exactly, a
/// refusal changes nothing.
template <class Check, class Operate>
bool holds_contract(const Mesh& mesh, const Check& check, const Operate& operate, Mesh& after) {
  after = copy_of(mesh);
  EXPECT_TRUE(after.enable_history());
  const Snapshot before(after);
  const auto can = check(std::as_const(after));
  const auto done = operate(after);
  EXPECT_EQ(can.ok(), done.ok()) << (done ? can.error().message : done.error().message);
  if (!done) {
    EXPECT_EQ(can.error().code, done.error().code);
    expect_refused(done, done.error().code, after, before);
    return false;
  }
  const std::vector<Problem> problems = validate(after);
  EXPECT_FALSE(has_errors(problems)) << problems[0].message;
  EXPECT_TRUE(Invariants(after).hold());
  const Snapshot changed(after);
  after.end_step();
  const bool has_changed = !(changed == before);
  EXPECT_EQ(after.undo(), has_changed);
  EXPECT_TRUE(Snapshot(after) == before);
  EXPECT_EQ(after.redo(), has_changed);
  EXPECT_TRUE(Snapshot(after) == changed);
  return true;
}

}  // namespace halfedge::test
