#pragma once

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/connectivity/convert.h>
#include <halfedge/mend/mend.h>
#include <halfedge/shapes/shapes.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "random/checks.h"
#include "support/complexes.h"

namespace halfedge::test {

/// Polygons by points and corners; a mesh of them, as the strict builder has it.
inline Mesh mesh_of(const std::vector<Point>& points,
                    const std::vector<std::vector<Index>>& faces) {
  Shape shape("", Index(points.size()), faces);
  for (std::size_t v = 0; v < points.size(); ++v) {
    std::copy(&points[v].x, &points[v].x + 3, &shape.positions[3 * v]);
  }
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, shape.polygons(), report))
      << (report.problems.empty() ? "" : report.problems[0].message);
  return mesh;
}

/// The same faces, of which no two share a vertex.
inline Mesh soup_of(const Mesh& mesh) {
  std::vector<Point> points;
  std::vector<std::vector<Index>> faces;
  for (const Face f : mesh.faces()) {
    faces.emplace_back();
    for (const Vertex v : mesh.face_vertices_ccw(f)) {
      faces.back().push_back(Index(points.size()));
      points.push_back(mesh.position(v));
    }
  }
  return mesh_of(points, faces);
}

/// No errors at level 4, and finite values.
inline void expect_sound(const Mesh& mesh) {
  const std::vector<Problem> problems = validate(mesh);
  EXPECT_FALSE(has_errors(problems)) << problems[0].message;
  if (mesh.edge_slots() < 200) {
    EXPECT_TRUE(Invariants(mesh).hold());
  }
}

/// The report after `repair`, a function of a mesh of any storage, which becomes what it makes of
/// it; that this is valid at level 4, can be undone and redone to the last byte, and is the same
/// where prev isn't stored; that new items have attributes.
template <class Repair>
mend::Report mended(Mesh& mesh, const Repair& repair) {
  Mesh whole = copy_of(mesh);
  if (!whole.attributes().has_any()) add_attributes_of_all_kinds(whole);
  BasicMesh<kWithoutPrev> light;
  EXPECT_TRUE(bool(convert(copy_of(whole), light)));
  EXPECT_TRUE(whole.enable_history());
  const Snapshot before(whole);

  Result<mend::Report> done = repair(whole);
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  if (!done) return {};
  expect_sound(whole);
  expect_defined_values(whole);
  const Snapshot after(whole);
  whole.end_step();
  const bool has_changed = !(after == before);
  EXPECT_EQ(whole.undo(), has_changed);
  EXPECT_FALSE(whole.undo()) << "more than one step";
  EXPECT_TRUE(Snapshot(whole) == before);
  EXPECT_EQ(whole.redo(), has_changed);
  EXPECT_TRUE(Snapshot(whole) == after);

  const Result<mend::Report> again = repair(light);
  EXPECT_TRUE(again) << (again ? "" : again.error().message);
  EXPECT_TRUE(after.equals_but_prev(Snapshot(light)));
  const std::vector<Problem> problems_of_light = validate(light);
  EXPECT_FALSE(has_errors(problems_of_light)) << problems_of_light[0].message;
  EXPECT_EQ(again.value().summary, done.value().summary);

  mend::Report report = std::move(done).value();
  const std::string& summary = report.summary;
  EXPECT_TRUE(!summary.empty() && summary.back() == '.') << summary;
  for (const Error& problem : report.problems) {
    EXPECT_GT(problem.message.size(), 30U) << problem.message;
    EXPECT_EQ(problem.message.back(), '.') << problem.message;
  }
  for (const Index v : report.vertices) EXPECT_TRUE(whole.is_live(Vertex(v)));
  for (const Index e : report.edges) EXPECT_TRUE(whole.is_live(Edge(e)));
  for (const Index f : report.faces) {
    EXPECT_EQ(whole.is_live(Face(f)), report.count(mend::Code::kDroppedComponent) == 0);
  }
  mesh = std::move(whole);
  return report;
}

/// V, E, F.
inline std::array<Index, 3> counts_of(const Mesh& mesh) {
  return {mesh.vertex_count(), mesh.edge_count(), mesh.face_count()};
}

}  // namespace halfedge::test
