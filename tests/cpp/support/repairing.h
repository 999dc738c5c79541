#pragma once

#include <gtest/gtest.h>
#include <halfedge/repair/repair.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace halfedge::test {

struct Repaired {
  Mesh mesh;
  RepairReport report;

  Repaired(const Polygons& polygons, const RepairOptions& options = {}) {
    EXPECT_TRUE(build_from_soup(mesh, polygons, options, report))
        << (report.problems.empty() ? "" : report.problems[0].message);
  }

  [[nodiscard]] std::vector<std::vector<Index>> faces() const {
    std::vector<std::vector<Index>> list;
    for (const Face f : mesh.faces()) {
      list.emplace_back();
      for (const Vertex v : mesh.face_vertices_ccw(f)) list.back().push_back(v.index());
    }
    return list;
  }
  [[nodiscard]] std::vector<Index> origins() const {
    return {report.vertex_origin.begin(), report.vertex_origin.end()};
  }
  [[nodiscard]] std::vector<std::string> messages() const {
    std::vector<std::string> list;
    for (const Error& problem : report.problems) {
      list.push_back(std::string(problem.code) + ": " + problem.message);
    }
    return list;
  }
};

inline std::vector<Problem> errors_of(const Mesh& mesh) {
  std::vector<Problem> errors;
  for (const Problem& problem : validate(mesh)) {
    if (problem.severity == Severity::kError) errors.push_back(problem);
  }
  return errors;
}

/// What must hold of every repair: the mesh is valid at level 4; the maps fit it and the input;
/// each face is there as it was, or there is a verdict that says what became of it.
inline void expect_sound(const Polygons& polygons, const Repaired& repaired) {
  const Mesh& mesh = repaired.mesh;
  const RepairReport& report = repaired.report;
  const std::vector<Problem> errors = errors_of(mesh);
  ASSERT_TRUE(errors.empty()) << errors[0].message;
  ASSERT_EQ(report.vertex_map.size(), polygons.vertex_count());
  ASSERT_EQ(report.vertex_origin.size(), mesh.vertex_slots());
  ASSERT_EQ(report.face_map.size(), polygons.face_count());
  for (const Vertex v : mesh.vertices()) {
    const Index origin = report.vertex_origin[v.index()];
    ASSERT_LT(origin, polygons.vertex_count());
    const Point p = mesh.position(v);
    EXPECT_TRUE(std::equal(&p.x, &p.x + 3, &polygons.positions[3 * std::size_t{origin}]));
    EXPECT_LE(report.vertex_map[origin], v.index()) << "the first vertex comes first";
  }

  std::vector<FaceVerdict> verdicts(polygons.face_count());
  for (const FaceVerdict& verdict : report.verdicts) {
    ASSERT_LT(verdict.face, verdicts.size());
    EXPECT_NE(verdict.codes, 0);
    EXPECT_EQ(verdict.kept, report.face_map[verdict.face] != kNone);
    verdicts[verdict.face] = verdict;
  }
  Index next = 0;
  std::size_t begin = 0;
  for (Index f = 0; f < polygons.face_count(); ++f) {
    const std::size_t size = polygons.sizes.empty() ? 3 : polygons.sizes[f];
    std::vector<Index> expected(polygons.corners.begin() + std::ptrdiff_t(begin),
                                polygons.corners.begin() + std::ptrdiff_t(begin + size));
    begin += size;
    if (report.face_map[f] == kNone) {
      EXPECT_NE(verdicts[f].codes, 0) << "face " << f << " was lost in silence";
      continue;
    }
    EXPECT_EQ(report.face_map[f], next++) << "faces keep their order";
    if (verdicts[f].has(RepairCode::kRepeatedVertex)) continue;
    std::vector<Index> corners;
    for (const Vertex v : mesh.face_vertices_ccw(Face(report.face_map[f]))) {
      corners.push_back(report.vertex_origin[v.index()]);
    }
    if (verdicts[f].has(RepairCode::kOppositeOrientation)) {
      std::reverse(expected.begin() + 1, expected.end());
    }
    ASSERT_EQ(corners.size(), expected.size()) << "face " << f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index welded = report.vertex_map[expected[i]];
      ASSERT_NE(welded, kNone);
      EXPECT_EQ(corners[i], report.vertex_origin[welded]) << "corner " << i << " of face " << f;
    }
  }
  EXPECT_EQ(next, mesh.face_count());
}

/// The faces by what doesn't depend on any order: the positions of their corners in rank, and which
/// copy of the vertex there each has; from the smallest on.
inline std::multiset<std::vector<std::pair<Index, Index>>> shape_of(const Repaired& repaired) {
  const Mesh& mesh = repaired.mesh;
  std::vector<Index> order;
  for (const Vertex v : mesh.vertices()) order.push_back(v.index());
  const auto point = [&](Index v) {
    const Point p = mesh.position(Vertex(v));
    return std::array<float, 3>{p.x, p.y, p.z};
  };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return point(a) != point(b) ? point(a) < point(b) : a < b; });
  std::vector<std::pair<Index, Index>> label(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_copy = i > 0 && point(order[i]) == point(order[i - 1]);
    label[order[i]] = is_copy ? std::pair(label[order[i - 1]].first, label[order[i - 1]].second + 1)
                              : std::pair(Index(i), Index{0});
  }
  std::multiset<std::vector<std::pair<Index, Index>>> shape;
  for (const std::vector<Index>& face : repaired.faces()) {
    std::vector<std::pair<Index, Index>> labels;
    for (const Index v : face) labels.push_back(label[v]);
    std::rotate(labels.begin(), std::min_element(labels.begin(), labels.end()), labels.end());
    shape.insert(labels);
  }
  return shape;
}

}  // namespace halfedge::test
