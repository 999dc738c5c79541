#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/operations/append.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/validate/validate.h>

#include <string>
#include <utility>
#include <vector>

#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using Findings = std::vector<std::string>;

// "code kind index" of each problem, in order.
Findings found_in(const Mesh& mesh, int level = kMaxValidationLevel) {
  Findings findings;
  for (const Problem& problem : validate(mesh, level)) {
    const std::string index = problem.index == kNone ? "-" : std::to_string(problem.index);
    findings.push_back(std::string(problem.code) + " " + name_of(problem.kind) + " " + index);
  }
  return findings;
}

// That the problems are exactly these, and none of them is found below `level`.
void expect_found(const Mesh& mesh, int level, const Findings& expected) {
  EXPECT_EQ(found_in(mesh), expected);
  EXPECT_EQ(found_in(mesh, level), expected);
  if (level > 0) {
    EXPECT_EQ(found_in(mesh, level - 1), Findings{});
  }
}

std::string first_message(const Mesh& mesh) {
  const std::vector<Problem> problems = validate(mesh);
  return problems.empty() ? "" : problems[0].message;
}

Halfedge halfedge_between(const Mesh& mesh, Index from, Index to) {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  EXPECT_TRUE(h.valid()) << from << " -> " << to;
  return h;
}

std::string name(Halfedge h) { return "halfedge " + std::to_string(h.index()); }

// A closed mesh from its edges (from, to) and the loops of its faces, so that several edges may
// join two vertices. Edge e has the halfedges 2e and 2e + 1.
Mesh from_loops(Index vertices, const std::vector<std::pair<Index, Index>>& edges,
                const std::vector<std::vector<Index>>& loops) {
  Mesh mesh;
  for (Index v = 0; v < vertices; ++v) (void)mesh.new_vertex();
  for (const auto& [from, to] : edges) {
    const Halfedge h = mesh.new_edge(Vertex(from), Vertex(to));
    mesh.set_vertex_halfedge(Vertex(from), h);
    mesh.set_vertex_halfedge(Vertex(to), mesh.opposite(h));
  }
  for (const std::vector<Index>& loop : loops) {
    const Face f = mesh.new_face(Halfedge(loop.back()));
    for (std::size_t i = 0; i < loop.size(); ++i) {
      mesh.set_face(Halfedge(loop[i]), f);
      mesh.link(Halfedge(loop[i]), Halfedge(loop[(i + 1) % loop.size()]));
    }
  }
  return mesh;
}

// Two tetrahedra side by side, the second on the vertices 4 to 7.
Mesh two_tetrahedra() {
  std::vector<std::vector<Index>> faces = tetrahedron().faces;
  for (const std::vector<Index>& face : tetrahedron().faces) {
    faces.push_back({face[0] + 4, face[1] + 4, face[2] + 4});
  }
  return reference_build({"two tetrahedra", 8, faces});
}

// Two triangles, the second on the vertices 3 to 5.
Shape two_triangles() { return {"two triangles", 6, {{0, 1, 2}, {3, 4, 5}}}; }

// One of two_triangles() taken out, last in first out: its slots are on the free lists.
Mesh one_triangle_deleted() {
  Mesh mesh = reference_build(two_triangles());
  mesh.release(Face(1));
  for (const Index e : {3U, 4U, 5U}) mesh.release(Edge(e));
  for (const Index v : {3U, 4U, 5U}) mesh.release(Vertex(v));
  return mesh;
}

TEST(Validate, FindsNothingWrongWithAnyShape) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const std::vector<Problem> problems = validate(reference_build(shape));
    EXPECT_FALSE(has_errors(problems)) << problems[0].message;
    const bool odd = shape.name == pinched(2).name || shape.name == with_isolated_vertices().name;
    EXPECT_EQ(problems.empty(), !odd);
  }
  EXPECT_EQ(found_in(one_triangle_deleted()), Findings{});
}

// Four triangles around two edges that both join 0 and 1.
Mesh two_edges_between_two_vertices() {
  return from_loops(4, {{0, 1}, {0, 1}, {1, 2}, {2, 0}, {1, 3}, {3, 0}},
                    {{0, 4, 6}, {1, 11, 9}, {2, 8, 10}, {3, 7, 5}});
}

// Adds an edge to a new vertex inside of the face, which then visits its foot twice.
void add_spike(Mesh& mesh, Face f) {
  const Halfedge h = mesh.face_halfedge(f);
  const Halfedge next = mesh.next(h);
  const Vertex tip = mesh.new_vertex();
  const Halfedge out = mesh.new_edge(mesh.to_vertex(h), tip);
  mesh.link(h, out);
  mesh.link(mesh.opposite(out), next);
  mesh.set_face(out, f);
  mesh.set_face(mesh.opposite(out), f);
  mesh.set_vertex_halfedge(tip, mesh.opposite(out));
}

TEST(Validate, ArraySize) {
  const char* names[] = {"Prev", "To_vertex", "Face"};
  for (int i = 0; i < 3; ++i) {
    Mesh mesh = reference_build(tetrahedron());
    Links& links = mesh.mutable_links();
    Array<Index>* arrays[] = {&links.prev, &links.to_vertex, &links.face};
    ASSERT_TRUE(arrays[i]->resize(i == 1 ? 13 : 11, 0));
    expect_found(mesh, 0, {"array-size mesh -"});
    EXPECT_EQ(first_message(mesh).substr(0, std::string(names[i]).size()), names[i]);
  }

  Mesh odd = reference_build(tetrahedron());
  Links& links = odd.mutable_links();
  for (Array<Index>* array : {&links.next, &links.prev, &links.to_vertex, &links.face}) {
    ASSERT_TRUE(array->resize(11));
  }
  expect_found(odd, 0, {"array-size mesh -"});
  EXPECT_EQ(first_message(odd),
            "Next has 11 entries, expected an even number: the two halfedges of an edge lie side "
            "by side.");

  Mesh positions = reference_build(tetrahedron());
  ASSERT_TRUE(positions.mutable_positions().resize(11));
  expect_found(positions, 0, {"array-size mesh -"});
  EXPECT_EQ(first_message(positions),
            "Positions has 11 floats, expected 12: three for each vertex slot.");
  positions.set_face_halfedge(Face(2), Halfedge{});
  expect_found(positions, 0, {"array-size mesh -", "empty-link face 2"});
}

TEST(Validate, FreeListWithAnotherCount) {
  Mesh mesh = reference_build(with_isolated_vertices());
  mesh.mutable_links().vertex_halfedge[3] = kDeleted;
  expect_found(mesh, 0, {"free-list vertex -"});
  EXPECT_EQ(first_message(mesh),
            "The chain of deleted vertex slots should have 0 entries, but 1 slots are marked as "
            "deleted.");
}

TEST(Validate, FreeListThatEndsEarly) {
  Mesh mesh = one_triangle_deleted();
  mesh.mutable_links().vertex_halfedge[4] = kDeleted;
  expect_found(mesh, 0, {"free-list vertex -"});
  EXPECT_EQ(first_message(mesh),
            "The chain of deleted vertex slots ends after 2 of 3 deleted slots.");
}

TEST(Validate, FreeListThatRunsInACircle) {
  Mesh mesh = one_triangle_deleted();
  mesh.mutable_links().next[6] = kDeleted - 1 - 5;  // from edge 3 back to edge 5
  expect_found(mesh, 0, {"free-list edge 5"});
  EXPECT_EQ(first_message(mesh),
            "The chain of deleted edge slots runs in a circle through slot 5.");
}

TEST(Validate, FreeListThatLeadsToALiveSlot) {
  Mesh mesh = one_triangle_deleted();
  mesh.mutable_links().next[8] = kDeleted - 1 - 1;
  expect_found(mesh, 0, {"free-list edge 1"});
}

TEST(Validate, FreeListThatLeadsOutOfRange) {
  Mesh mesh = one_triangle_deleted();
  mesh.mutable_links().face_halfedge[1] = kDeleted - 1 - 7;
  expect_found(mesh, 0, {"free-list face -"});
  EXPECT_EQ(first_message(mesh), "The chain of deleted face slots leads to slot 7 of 2.");
}

TEST(Validate, HalfDeletedEdge) {
  for (const Index side : {0U, 1U}) {
    for (const auto links : {&Links::prev, &Links::to_vertex, &Links::face}) {
      Mesh mesh = reference_build(tetrahedron());
      (mesh.mutable_links().*links)[4 + side] = kDeleted;
      expect_found(mesh, 0, {"half-deleted-edge edge 2"});
    }
  }
  Mesh mesh = one_triangle_deleted();
  mesh.mutable_links().prev[9] = 0;
  expect_found(mesh, 0, {"half-deleted-edge edge 4"});
  EXPECT_EQ(first_message(mesh),
            "Edge 4 is half deleted: 7 of the 8 links of its halfedges are marked as deleted, "
            "expected all or none.");
}

TEST(Validate, EmptyLink) {
  const std::pair<Array<Index> Links::*, const char*> cases[] = {
      {&Links::next, "The next of halfedge 5 is empty, expected a halfedge."},
      {&Links::prev, "The prev of halfedge 5 is empty, expected a halfedge."},
      {&Links::to_vertex, "The to-vertex of halfedge 5 is empty, expected a vertex."}};
  for (const auto& [links, message] : cases) {
    Mesh mesh = reference_build(tetrahedron());
    (mesh.mutable_links().*links)[5] = kNone;
    expect_found(mesh, 0, {"empty-link halfedge 5"});
    EXPECT_EQ(first_message(mesh), message);
  }
  Mesh mesh = reference_build(tetrahedron());
  mesh.set_face_halfedge(Face(2), Halfedge{});
  expect_found(mesh, 0, {"empty-link face 2"});
}

TEST(Validate, IndexOutOfRange) {
  const std::pair<Array<Index> Links::*, Index> cases[] = {
      {&Links::next, 12}, {&Links::prev, 12}, {&Links::to_vertex, 4}, {&Links::face, 4}};
  for (const auto& [links, value] : cases) {
    Mesh mesh = reference_build(tetrahedron());
    (mesh.mutable_links().*links)[5] = value;
    expect_found(mesh, 0, {"index-out-of-range halfedge 5"});
  }
  Mesh mesh = reference_build(tetrahedron());
  mesh.set_vertex_halfedge(Vertex(3), Halfedge(0x7FFF'FFFF));
  mesh.set_face_halfedge(Face(1), Halfedge(12));
  expect_found(mesh, 0, {"index-out-of-range vertex 3", "index-out-of-range face 1"});
  EXPECT_EQ(first_message(mesh),
            "The anchor of vertex 3 is halfedge 2147483647, expected less than 12.");
}

TEST(Validate, DeletedReference) {
  const std::pair<Array<Index> Links::*, Index> cases[] = {
      {&Links::next, 7}, {&Links::prev, 7}, {&Links::to_vertex, 4}, {&Links::face, 1}};
  for (const auto& [links, value] : cases) {
    Mesh mesh = one_triangle_deleted();
    (mesh.mutable_links().*links)[0] = value;
    expect_found(mesh, 0, {"deleted-reference halfedge 0"});
  }
  Mesh mesh = one_triangle_deleted();
  mesh.set_vertex_halfedge(Vertex(0), Halfedge(7));
  mesh.set_face_halfedge(Face(0), Halfedge(8));
  expect_found(mesh, 0, {"deleted-reference vertex 0", "deleted-reference face 0"});
  EXPECT_EQ(first_message(mesh), "The anchor of vertex 0 is halfedge 7, which is deleted.");
}

TEST(Validate, NextPrevMismatch) {
  Mesh mesh = reference_build(two_triangles());
  const Halfedge h = halfedge_between(mesh, 0, 1);
  const Halfedge n = halfedge_between(mesh, 1, 2);
  const Halfedge other = halfedge_between(mesh, 3, 4);
  mesh.mutable_links().prev[n.index()] = other.index();
  expect_found(mesh, 0, {"next-prev-mismatch " + name(h)});
  EXPECT_EQ(first_message(mesh),
            "The next of " + name(h) + " is " + name(n) + ", whose prev is " + name(other) + ".");
}

TEST(Validate, MissingAnchor) {
  Mesh mesh = reference_build(with_isolated_vertices());
  mesh.set_vertex_halfedge(Vertex(2), Halfedge{});
  expect_found(mesh, 0, {"missing-anchor vertex 2"});
}

TEST(Validate, AnchorElsewhere) {
  Mesh mesh = reference_build(tetrahedron());
  const Halfedge anchor = mesh.vertex_halfedge(Vertex(2));
  mesh.set_vertex_halfedge(Vertex(0), anchor);
  expect_found(mesh, 0, {"anchor-elsewhere vertex 0"});
  EXPECT_EQ(first_message(mesh),
            "The anchor of vertex 0 is " + name(anchor) + ", which leaves vertex 2.");

  Mesh isolated = reference_build(with_isolated_vertices());
  isolated.set_vertex_halfedge(Vertex(0), isolated.vertex_halfedge(Vertex(1)));
  expect_found(isolated, 0, {"anchor-elsewhere vertex 0"});
}

TEST(Validate, FaceHalfedgeElsewhere) {
  Mesh mesh = reference_build(two_triangles());
  mesh.set_face_halfedge(Face(0), mesh.face_halfedge(Face(1)));
  expect_found(mesh, 0, {"face-halfedge-elsewhere face 0"});
  mesh.set_face_halfedge(Face(0), halfedge_between(mesh, 1, 0));  // a boundary halfedge
  expect_found(mesh, 0, {"face-halfedge-elsewhere face 0"});
}

TEST(Validate, ToFromMismatch) {
  // 0 -> 1 is made to lead to 3, so its opposite leaves 3: both ends of the edge tear.
  Mesh mesh = reference_build(two_triangles());
  const Halfedge h = halfedge_between(mesh, 0, 1);
  const Halfedge before_opposite = mesh.prev(mesh.opposite(h));
  ASSERT_NE(mesh.vertex_halfedge(Vertex(1)), before_opposite);
  mesh.set_vertex_halfedge(Vertex(1), halfedge_between(mesh, 1, 2));
  mesh.set_to_vertex(h, Vertex(3));
  expect_found(mesh, 1,
               {"to-from-mismatch " + name(h), "to-from-mismatch " + name(before_opposite)});
  EXPECT_EQ(first_message(mesh), "Halfedge " + std::to_string(h.index()) +
                                     " leads to vertex 3, but its next, " +
                                     name(halfedge_between(mesh, 1, 2)) + ", leaves vertex 1.");
}

TEST(Validate, FaceMismatch) {
  Mesh mesh = reference_build(two_triangles());
  const Halfedge h = halfedge_between(mesh, 1, 2);
  const Halfedge before = halfedge_between(mesh, 0, 1);
  ASSERT_NE(mesh.face_halfedge(Face(0)), h);
  mesh.set_face(h, Face(1));
  expect_found(mesh, 1, {"face-mismatch " + name(before), "face-mismatch " + name(h)});
  EXPECT_EQ(first_message(mesh), "Halfedge " + std::to_string(before.index()) +
                                     " lies in face 0, but its next, " + name(h) +
                                     ", lies in face 1.");
}

TEST(Validate, UnreachableHalfedge) {
  // Two solids that touch at a vertex: two orbits at vertex 0, one of them without the anchor.
  Mesh mesh = two_tetrahedra();
  Findings expected;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.from_vertex(h) == Vertex(4)) {
      expected.push_back("unreachable-halfedge " + name(h));
    }
  }
  for (Index& to : mesh.mutable_links().to_vertex) to = to == 4 ? 0 : to;
  mesh.release(Vertex(4));
  EXPECT_EQ(expected.size(), 3U);
  expect_found(mesh, 2, expected);
}

TEST(Validate, FaceWithManyLoops) {
  Mesh mesh = reference_build(two_triangles());
  for (Index& face : mesh.mutable_links().face) face = face == 1 ? 0 : face;
  mesh.release(Face(1));
  expect_found(mesh, 3, {"face-with-many-loops face 0"});
}

TEST(Validate, InteriorAnchor) {
  Mesh mesh = reference_build(triangle());
  const Halfedge anchor = halfedge_between(mesh, 1, 2);
  mesh.set_vertex_halfedge(Vertex(1), anchor);
  expect_found(mesh, 3, {"interior-anchor vertex 1"});
  EXPECT_EQ(first_message(mesh), "The anchor of vertex 1 is " + name(anchor) +
                                     ", which has a face, although the boundary halfedge " +
                                     std::to_string(halfedge_between(mesh, 1, 0).index()) +
                                     " leaves it.");
}

TEST(Validate, InteriorAnchorIsReportedOnceForAllFansOfAVertex) {
  Mesh mesh = reference_build(pinched(3));
  mesh.set_vertex_halfedge(Vertex(0), halfedge_between(mesh, 0, 1));
  expect_found(mesh, 3, {"interior-anchor vertex 0"});
}

TEST(Validate, EdgeWithoutFace) {
  Mesh mesh = from_loops(2, {{0, 1}}, {});
  expect_found(mesh, 3, {"edge-without-face edge 0"});
}

TEST(Validate, DegreeBelowThree) {
  // A face between two edges with the same ends: it can't be without a duplicate halfedge.
  const Mesh mesh = from_loops(3, {{0, 1}, {0, 1}, {1, 2}, {2, 0}}, {{0, 3}, {2, 4, 6}, {1, 7, 5}});
  expect_found(mesh, 4, {"degree-below-three face 0", "duplicate-halfedge halfedge 0"});
  EXPECT_EQ(first_message(mesh), "Face 0 has 2 corners, expected three or more.");
}

TEST(Validate, RepeatedVertex) {
  // A hexagon that visits vertex 0 twice, and a triangle in each of the two gaps.
  const Mesh mesh =
      reference_build({"pinched hexagon", 5, {{0, 1, 2, 0, 3, 4}, {0, 2, 1}, {0, 4, 3}}});
  expect_found(mesh, 4, {"repeated-vertex face 0"});
  EXPECT_EQ(first_message(mesh), "Face 0 has vertex 0 at more than one corner.");
}

TEST(Validate, DuplicateHalfedge) {
  const Mesh mesh = two_edges_between_two_vertices();
  const Findings findings = found_in(mesh);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_TRUE(findings[0] == "duplicate-halfedge halfedge 0" ||
              findings[0] == "duplicate-halfedge halfedge 2");
  expect_found(mesh, 4, findings);
}

TEST(Validate, SameFaceTwice) {
  Mesh mesh = reference_build(tetrahedron());
  add_spike(mesh, Face(0));
  expect_found(mesh, 4, {"repeated-vertex face 0", "same-face-twice edge 6"});
}

TEST(Validate, FindsTheSameInALargeMeshInNoOrder) {
  const Shape shape = with_random_names(in_random_order(triangle_grid(127, 127)));
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, shape.polygons(), report));
  const Index edges = mesh.edge_count();
  for (const Index f : {0U, 64U, 65U}) ASSERT_TRUE(operations::delete_face(mesh, Face(f)));
  EXPECT_EQ(found_in(mesh), Findings{});
  add_spike(mesh, Face(20000));
  ASSERT_TRUE(append(mesh, two_edges_between_two_vertices()));
  Findings findings = found_in(mesh);
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_EQ(findings[0], "repeated-vertex face 20000");
  EXPECT_EQ(findings[1].substr(0, 27), "duplicate-halfedge halfedge");
  EXPECT_EQ(findings[2], "same-face-twice edge " + std::to_string(edges));
}

TEST(Validate, PinchedVertexIsAWarning) {
  const Mesh mesh = reference_build(pinched(3));
  expect_found(mesh, 4, {"pinched-vertex vertex 0"});
  EXPECT_EQ(validate(mesh)[0].severity, Severity::kWarning);
  EXPECT_FALSE(has_errors(validate(mesh)));
}

TEST(Validate, IsolatedVertexIsInformation) {
  const Mesh mesh = reference_build(with_isolated_vertices());
  expect_found(
      mesh, 4,
      {"isolated-vertex vertex 0", "isolated-vertex vertex 3", "isolated-vertex vertex 5"});
  EXPECT_EQ(validate(mesh)[0].severity, Severity::kInfo);
  EXPECT_FALSE(has_errors(validate(mesh)));
}

TEST(Validate, AcceptsTheDegenerateComplexesBelowLevelFour) {
  const Mesh loop = from_loops(1, {{0, 0}}, {{0}, {1}});
  expect_found(
      loop, 4,
      {"degree-below-three face 0", "degree-below-three face 1", "duplicate-halfedge halfedge 0"});
  EXPECT_EQ(first_message(loop), "Face 0 has 1 corner, expected three or more.");

  const Mesh segment = from_loops(2, {{0, 1}}, {{0, 1}});
  expect_found(segment, 4, {"degree-below-three face 0", "same-face-twice edge 0"});
}

TEST(Validate, CountsTheProblemsThatItDoesNotList) {
  Mesh mesh;
  for (std::size_t i = 0; i < kMaxProblemsPerCode; ++i) (void)mesh.new_vertex();
  EXPECT_EQ(validate(mesh).size(), kMaxProblemsPerCode);
  (void)mesh.new_vertex();
  (void)mesh.new_vertex();
  const std::vector<Problem> problems = validate(mesh);
  ASSERT_EQ(problems.size(), kMaxProblemsPerCode + 1);
  EXPECT_EQ(problems.back().code, "isolated-vertex");
  EXPECT_EQ(problems.back().severity, Severity::kInfo);
  EXPECT_EQ(problems.back().kind, ItemKind::kMesh);
  EXPECT_EQ(problems.back().message, "And 2 more problems with this code.");
}

TEST(Validate, ChecksAConnectivityWithoutPositions) {
  Connectivity segment;
  const Vertex a = segment.new_vertex();
  const Vertex b = segment.new_vertex();
  const Halfedge h = segment.new_edge(a, b);
  segment.set_vertex_halfedge(a, h);
  segment.set_vertex_halfedge(b, segment.opposite(h));
  ASSERT_EQ(validate(segment).size(), 1U);
  EXPECT_EQ(validate(segment)[0].code, "edge-without-face");
}

}  // namespace
}  // namespace halfedge::test
