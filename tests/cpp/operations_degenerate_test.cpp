// Operations on the complexes that have loops, or faces on both sides of an edge: they do what they
// can, or refuse, and leave no link broken.

#include <gtest/gtest.h>
#include <halfedge/decorator/decorator.h>
#include <halfedge/operations/operations.h>
#include <halfedge/validate/validate.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace halfedge::test {
namespace {

using Change = std::function<std::string(Mesh&)>;

std::string code_of(const auto& result) { return result ? "done" : result.error().code; }

Mesh make_degenerate(const std::string& name) {
  Mesh mesh;
  if (name == "loop") {
    EXPECT_TRUE(decorator::make_loop(mesh));
    return mesh;
  }
  const Halfedge h = decorator::make_segment(mesh).value();
  if (name == "path") EXPECT_TRUE(decorator::split_edge(mesh, h));
  return mesh;
}

/// All changes that there are to try, with what each of them came to.
std::set<std::string> outcomes_of(const std::string& name, const Change& change) {
  Mesh mesh = make_degenerate(name);
  const std::string outcome = change(mesh);
  const std::vector<Problem> problems = validate(mesh, 3);
  EXPECT_TRUE(problems.empty()) << name << ", " << outcome << ": " << problems.front().message;
  return {outcome};
}

std::set<std::string> try_all(const std::string& name) {
  namespace ops = operations;
  const Mesh whole = make_degenerate(name);
  std::set<std::string> outcomes;
  const auto attempt = [&](const char* what, const Change& change) {
    for (const std::string& outcome : outcomes_of(name, change)) {
      outcomes.insert(std::string(what) + ": " + outcome);
    }
  };
  attempt("triangulate", [](Mesh& mesh) { return code_of(ops::triangulate(mesh)); });
  for (const Face f : whole.faces()) {
    attempt("triangulate a face", [=](Mesh& mesh) { return code_of(ops::triangulate(mesh, f)); });
    attempt("delete_face", [=](Mesh& mesh) { return code_of(ops::delete_face(mesh, f)); });
    attempt("make_hole", [=](Mesh& mesh) { return code_of(ops::make_hole(mesh, f)); });
  }
  for (const Vertex v : whole.vertices()) {
    attempt("delete_vertex", [=](Mesh& mesh) { return code_of(ops::delete_vertex(mesh, v)); });
    attempt("dissolve_vertex", [=](Mesh& mesh) { return code_of(ops::dissolve_vertex(mesh, v)); });
  }
  for (const Edge e : whole.edges()) {
    attempt("delete_edge", [=](Mesh& mesh) { return code_of(ops::delete_edge(mesh, e)); });
    attempt("dissolve_edge", [=](Mesh& mesh) { return code_of(ops::dissolve_edge(mesh, e)); });
    attempt("flip_edge", [=](Mesh& mesh) { return code_of(ops::flip_edge(mesh, e)); });
  }
  for (const Halfedge h : whole.halfedges()) {
    for (const auto condition : {ops::LinkCondition::kStrict, ops::LinkCondition::kPermissive}) {
      attempt("collapse",
              [=](Mesh& mesh) { return code_of(ops::collapse(mesh, h, {}, condition)); });
    }
    for (const Halfedge g : whole.halfedges()) {
      attempt("split_vertex", [=](Mesh& mesh) { return code_of(ops::split_vertex(mesh, h, g)); });
    }
  }
  return outcomes;
}

bool has(const std::set<std::string>& outcomes, const std::string& outcome) {
  return outcomes.count(outcome) > 0;
}

TEST(DegenerateComplexes, ALoop) {
  const std::set<std::string> outcomes = try_all("loop");
  EXPECT_TRUE(has(outcomes, "triangulate: done"));
  EXPECT_TRUE(has(outcomes, "dissolve_edge: loop-edge"));
  EXPECT_TRUE(has(outcomes, "split_vertex: loop-edge"));
}

TEST(DegenerateComplexes, ASegment) {
  const std::set<std::string> outcomes = try_all("segment");
  EXPECT_TRUE(has(outcomes, "triangulate: done"));
  for (const char* what : {"delete_face", "delete_edge", "delete_vertex", "collapse"}) {
    EXPECT_TRUE(has(outcomes, std::string(what) + ": same-loop")) << what;
  }
}

TEST(DegenerateComplexes, APathOfTwoEdges) {
  const std::set<std::string> outcomes = try_all("path");
  for (const char* what : {"delete_face", "delete_edge", "delete_vertex", "collapse"}) {
    EXPECT_TRUE(has(outcomes, std::string(what) + ": same-loop")) << what;
    EXPECT_FALSE(has(outcomes, std::string(what) + ": done")) << what;
  }
}

}  // namespace
}  // namespace halfedge::test
