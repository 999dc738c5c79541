// What `validate` says of where the vertices lie.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/mend/mend.h>
#include <halfedge/operations/append.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/shapes/shapes.h>
#include <halfedge/validate/validate.h>

#include <limits>
#include <string>
#include <vector>

namespace halfedge {
namespace {

using Findings = std::vector<std::string>;
using shapes::mesh_of;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// "severity code kind index" of each problem, of which all are of geometry.
Findings found_in(const Mesh& mesh) {
  Findings findings;
  for (const Problem& problem : validate(mesh, kGeometryLevel)) {
    findings.push_back(std::string(name_of(problem.severity)) + " " + std::string(problem.code) +
                       " " + name_of(problem.kind) + " " + std::to_string(problem.index));
  }
  EXPECT_EQ(validate(mesh, kMaxValidationLevel).size(), 0U);
  return findings;
}
std::string first_message(const Mesh& mesh) {
  const std::vector<Problem> problems = validate(mesh, kGeometryLevel);
  return problems.empty() ? "" : problems[0].message;
}
Mesh cube() { return mesh_of(shapes::cube(2)).value(); }

TEST(ValidateGeometry, FindsNothingWrongWithGoodShapes) {
  for (const auto& shape :
       {shapes::cube(), shapes::dodecahedron(), shapes::ico_sphere(3, 1e-20), shapes::torus(9, 7),
        shapes::grid(5, 4), shapes::uv_sphere(12, 6, shapes::Faces::kQuads, 1e18)}) {
    EXPECT_EQ(found_in(mesh_of(shape).value()), Findings());
  }
  EXPECT_EQ(found_in(Mesh()), Findings());
}

TEST(ValidateGeometry, NonFinitePosition) {
  Mesh mesh = cube();
  mesh.set_position(Vertex(3), {1, kNan, 2});
  EXPECT_EQ(found_in(mesh), Findings{"error non-finite-position vertex 3"});
  EXPECT_EQ(first_message(mesh), "Vertex 3 lies at (1, nan, 2), expected finite numbers.");
  mesh.set_position(Vertex(3), {1, 1, std::numeric_limits<float>::infinity()});
  EXPECT_EQ(found_in(mesh), Findings{"error non-finite-position vertex 3"});
  EXPECT_TRUE(has_errors(validate(mesh, kGeometryLevel)));
}

TEST(ValidateGeometry, ZeroLengthEdge) {
  Mesh mesh = cube();
  const Halfedge h = mesh.edge_halfedge(Edge(4));
  mesh.set_position(mesh.to_vertex(h), mesh.position(mesh.from_vertex(h)));
  EXPECT_EQ(found_in(mesh), Findings{"warning zero-length-edge edge 4"});
  EXPECT_FALSE(has_errors(validate(mesh, kGeometryLevel)));

  Mesh triangles = mesh_of(shapes::octahedron()).value();
  const Halfedge g = triangles.edge_halfedge(Edge(0));
  triangles.set_position(triangles.to_vertex(g), triangles.position(triangles.from_vertex(g)));
  EXPECT_EQ(found_in(triangles), Findings{"warning zero-length-edge edge 0"});
}

TEST(ValidateGeometry, DegenerateFace) {
  // The corner 3 of the last triangle lies on its opposite side.
  Mesh mesh;
  BuildReport report;
  const float positions[] = {0, 0, 0, 2, 0, 0, 1, 1, 0, 1, 0, 0};
  const Index corners[] = {0, 1, 2, 1, 0, 3};
  ASSERT_TRUE(build_from_polygons(mesh, {positions, {}, corners}, report));
  EXPECT_EQ(found_in(mesh), Findings{"warning degenerate-face face 1"});
  EXPECT_EQ(first_message(mesh), "Face 1 has no area to speak of: it is 2 long and 0 wide.");
  mesh.set_position(Vertex(3), {1, -1e-7F, 0});
  EXPECT_EQ(found_in(mesh), Findings{"warning degenerate-face face 1"});
  mesh.set_position(Vertex(3), {1, -1e-5F, 0});
  EXPECT_EQ(found_in(mesh), Findings());
}

TEST(ValidateGeometry, DegenerateFaceWhoseSidesCross) {
  Mesh mesh;
  BuildReport report;
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const Index sizes[] = {4};
  const Index corners[] = {0, 1, 2, 3};
  ASSERT_TRUE(build_from_polygons(mesh, {positions, sizes, corners}, report));
  EXPECT_EQ(found_in(mesh), Findings{"warning degenerate-face face 0"});
  EXPECT_NE(first_message(mesh).find("wide, but its sides cross."), std::string::npos);
}

TEST(ValidateGeometry, CoincidentVertices) {
  Mesh mesh = cube();
  ASSERT_TRUE(append(mesh, cube()));
  EXPECT_EQ(found_in(mesh).size(), 8U);
  EXPECT_EQ(found_in(mesh)[5], "warning coincident-vertices vertex 13");
  EXPECT_EQ(first_message(mesh).substr(0, 9), "Vertex 8 ");
  // What is deleted lies nowhere.
  for (Index f = 6; f < 12; ++f) ASSERT_TRUE(operations::delete_face(mesh, Face(f)));
  EXPECT_EQ(found_in(mesh), Findings());
}

TEST(ValidateGeometry, TellsVerticesThatAreJoinedFromOthersInTheirPlace) {
  Mesh mesh = cube();
  const Halfedge h = mesh.edge_halfedge(Edge(0));
  const Point place = mesh.position(mesh.from_vertex(h));
  mesh.set_position(mesh.to_vertex(h), place);
  ASSERT_TRUE(append(mesh, cube()));
  // Of eight places the two of this edge are one: the copy meets seven, and one alone.
  std::size_t coincident = 0;
  for (const std::string& finding : found_in(mesh)) {
    coincident += finding.starts_with("warning coincident-vertices") ? 1U : 0U;
  }
  EXPECT_EQ(coincident, 7U);
}

TEST(ValidateGeometry, FindsWhatRemoveDegenerateFacesRemoves) {
  Mesh mesh = mesh_of(shapes::grid(6, 6, shapes::Faces::kTriangles)).value();
  for (const Index v : {10U, 24U, 30U}) {
    mesh.set_position(Vertex(v), mesh.position(Vertex(v + 1)));
  }
  EXPECT_EQ(found_in(mesh).size(), 3U);
  ASSERT_TRUE(mend::remove_degenerate_faces(mesh));
  EXPECT_EQ(found_in(mesh), Findings());
}

TEST(ValidateGeometry, IsLeftOutWhereLinksAreBroken) {
  Mesh mesh = cube();
  mesh.set_position(Vertex(0), {kNan, 0, 0});
  mesh.set_to_vertex(Halfedge(0), Vertex(7));
  for (const Problem& problem : validate(mesh, kGeometryLevel)) {
    EXPECT_NE(problem.code, "non-finite-position");
  }
  mesh.mutable_positions().clear();
  EXPECT_EQ(validate(mesh, kGeometryLevel)[0].code, "array-size");
}

TEST(ValidateGeometry, ReadsMeshesThatLeaveLinksOut) {
  BasicMesh<kPrevAtRunTime> mesh;
  mesh.choose_prev(false);
  BuildReport report;
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 0, 0};
  const Index corners[] = {0, 1, 2};
  ASSERT_TRUE(build_from_polygons(mesh, {positions, {}, corners}, report));
  ASSERT_EQ(validate(mesh, kGeometryLevel).size(), 1U);
  EXPECT_EQ(validate(mesh, kGeometryLevel)[0].code, "zero-length-edge");
}

}  // namespace
}  // namespace halfedge
