// Operations on the complexes that have loops, or faces on both sides of an edge: they do what they
// can, or refuse, and leave no link broken.

#include <gtest/gtest.h>
#include <halfedge/decorator/decorator.h>
#include <halfedge/operations/operations.h>
#include <halfedge/validate/validate.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "random/operation.h"
#include "random/sequence.h"
#include "support/complexes.h"

namespace halfedge::test {
namespace {

using Change = std::function<std::string(Mesh&)>;

std::string code_of(const auto& result) {
  return std::string(result ? "done" : result.error().code);
}

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

/// A triangle, and at its vertex 0 a loop edge inside of the face: returns the loop, whose opposite
/// has a face of one corner.
Halfedge add_triangle_with_loop(Mesh& mesh) {
  std::vector<Vertex> corners;
  for (const float x : {0.0F, 1.0F, 2.0F}) corners.push_back(mesh.add_vertex({x, x * x, 0}));
  const Face f = operations::add_face(mesh, corners).value();
  const Halfedge into_0 = mesh.face_halfedge(f);
  return decorator::split_face(mesh, into_0, into_0).value();
}

template <class Check, class Run>
void expect_refuses(Mesh& mesh, const char* code, const Check& check, const Run& run) {
  const Snapshot before(mesh);
  const Result<void> can = check();
  ASSERT_FALSE(can.ok());
  EXPECT_EQ(can.error().code, code) << can.error().message;
  expect_refused(run(), code, mesh, before);
}

TEST(DegenerateComplexes, ALoopEdgeIsNotCutNorBeveledNorCollapsed) {
  namespace ops = operations;
  for (const Index side : {0U, 1U}) {
    Mesh mesh;
    const Edge e = mesh.edge(add_triangle_with_loop(mesh));
    const Halfedge h = mesh.edge_halfedge(e, side);
    const std::vector<Halfedge> path{h, h};
    expect_refuses(
        mesh, "loop-edge", [&] { return ops::check_cut(mesh, h); },
        [&] { return ops::cut(mesh, h); });
    expect_refuses(
        mesh, "loop-edge", [&] { return ops::check_cut_path(mesh, path); },
        [&] { return ops::cut_path(mesh, path); });
    const std::vector<Edge> edges{e, e};
    expect_refuses(
        mesh, "loop-edge", [&] { return ops::check_cut_edges(mesh, edges); },
        [&] { return ops::cut_edges(mesh, edges); });
    expect_refuses(
        mesh, "loop-edge", [&] { return ops::check_bevel_edge(mesh, e, 0.5); },
        [&] { return ops::bevel_edge(mesh, e, 0.5); });
    expect_refuses(
        mesh, "loop-edge", [&] { return ops::check_collapse(mesh, h); },
        [&] { return ops::collapse(mesh, h); });
  }
}

TEST(DegenerateComplexes, AnEdgeBesideATriangleWithALoopEdgeIsNotCollapsed) {
  namespace ops = operations;
  for (const bool at_end : {false, true}) {
    Mesh mesh;
    const Halfedge h = decorator::make_loop(mesh).value();
    const Halfedge k = decorator::split_edge(mesh, h).value();  // faces of two corners
    const Halfedge into = at_end ? h : k;
    ASSERT_TRUE(decorator::split_face(mesh, into, into));
    ASSERT_EQ(mesh.degree(mesh.face(h)), 3U);
    for (const Halfedge side : {h, mesh.opposite(h), k, mesh.opposite(k)}) {
      expect_refuses(
          mesh, "loop-edge",
          [&] { return ops::check_collapse(mesh, side, ops::LinkCondition::kPermissive); },
          [&] { return ops::collapse(mesh, side, {}, ops::LinkCondition::kPermissive); });
    }
  }
}

TEST(DegenerateComplexes, TheLastEdgeOfALoopIsNotRemoved) {
  Mesh mesh = make_degenerate("loop");
  expect_refuses(
      mesh, "last-edge", [&] { return operations::check_remove_edge(mesh, Edge(0)); },
      [&] { return operations::remove_edge(mesh, Edge(0)); });
}

TEST(DegenerateComplexes, AFaceOfOneCornerIsNotCutLikeATriangle) {
  Mesh mesh = make_degenerate("loop");
  ASSERT_TRUE(operations::split_edge(mesh, Edge(0)));
  EXPECT_EQ(mesh.face_count(), 2U);
  EXPECT_EQ(mesh.edge_count(), 2U);
  expect_valid_complex(mesh);
}

TEST(DegenerateComplexes, AFaceThatHangsAtOneVertexIsDissolvedWithAllItsEdges) {
  Mesh mesh;
  const Halfedge loop = add_triangle_with_loop(mesh);
  const Face f = mesh.face(loop);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(decorator::split_edge(mesh, loop));
  ASSERT_EQ(mesh.degree(f), 6U);
  ASSERT_TRUE(operations::dissolve_edge(mesh, mesh.edge(loop)));
  EXPECT_EQ(mesh.face_count(), 1U);
  EXPECT_EQ(mesh.edge_count(), 3U);
  EXPECT_EQ(mesh.vertex_count(), 3U);
  expect_valid_complex(mesh);
}

TEST(DegenerateComplexes, AFaceOfOneCornerIsSplitAndThatIsDoneAgain) {
  Mesh mesh = make_degenerate("loop");
  ASSERT_TRUE(mesh.enable_history());
  ASSERT_TRUE(operations::split_face(mesh, Face(0)));  // adds no face
  mesh.end_step();
  const Snapshot after(mesh);
  ASSERT_TRUE(mesh.undo());
  ASSERT_TRUE(mesh.redo());
  EXPECT_TRUE(Snapshot(mesh) == after);
}

/// One of the steps that make complexes degenerate, of the combinatorial layer.
void make_more_degenerate(Mesh& mesh, Draw& draw) {
  namespace dec = decorator;
  const Halfedge h = draw.halfedge(mesh);
  const Halfedge g = draw.on_loop_of(mesh, h);
  switch (draw.below(10)) {
    case 0:
      return (void)dec::make_loop(mesh);
    case 1:
      return (void)dec::make_segment(mesh);
    case 2:
    case 3:
      return (void)dec::split_face(mesh, h, g);
    case 4:
      return (void)dec::split_vertex(mesh, h, mesh.is_live(h) ? mesh.next_on_vertex(h) : g);
    case 5:
      return (void)dec::split_edge(mesh, h);
    case 6:
      return (void)dec::insert_tip(mesh, h);
    case 7:
      return (void)dec::join_vertex(mesh, h);
    case 8:
      return (void)dec::make_hole(mesh, h);
    default:
      return (void)dec::add_face_to_boundary(mesh, h, g);
  }
}

TEST(DegenerateComplexes, StayValidInRandomSequencesAndCanBeTakenBack) {
  const Operations& all = all_operations();
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Draw draw(seed);
    Mesh mesh = make_degenerate(seed % 2 == 0 ? "loop" : "path");
    if (seed % 3 == 0) add_attributes_of_all_kinds(mesh);
    ASSERT_TRUE(mesh.enable_history());
    const Snapshot start(mesh);
    for (int step = 0; step < 50; ++step) {
      if (mesh.edge_count() < 3 || (mesh.edge_count() < 40 && draw.one_in(2))) {
        make_more_degenerate(mesh, draw);
        mesh.end_step();
        continue;
      }
      const Operation& op = all[draw.below(all.size())];
      if (mesh.edge_count() > 60 && op.growth == Growth::kGrows) continue;
      Call call;
      op.draw(mesh, draw, call);
      SCOPED_TRACE("step " + std::to_string(step) + ": " + to_string(op, call));
      const Snapshot before(mesh);
      const Result<void> can = op.check(mesh, call);
      const Result<void> done = op.run(mesh, call);
      mesh.end_step();
      ASSERT_EQ(can.ok(), done.ok()) << (can.ok() ? done : can).error().message;
      if (!done.ok()) expect_refused(done, can.error().code, mesh, before);
      expect_valid_complex(mesh);
      if (HasFailure()) return;
    }
    while (mesh.undo()) continue;
    EXPECT_TRUE(Snapshot(mesh) == start);
  }
}

}  // namespace
}  // namespace halfedge::test
