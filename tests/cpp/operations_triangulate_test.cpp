// Faces cut into triangles.

#include <gtest/gtest.h>
#include <halfedge/operations/triangulate.h>

#include <algorithm>
#include <map>
#include <random>
#include <string_view>
#include <vector>

#include "support/polygon_lists.h"

namespace halfedge::test {
namespace {

using namespace operations;

std::set<std::pair<Index, Index>> edges_of(const Mesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e);
    edges.insert(std::minmax(mesh.from_vertex(h).index(), mesh.to_vertex(h).index()));
  }
  return edges;
}

// Positions that make all faces of these shapes what they are meant to be are not needed: the
// shapes lie on a curve. What counts is that the triangles of a face have its corners and its
// boundary.
void expect_cut(const Mesh& before, const Mesh& after, Index added) {
  Index expected = 0;
  for (const Face f : before.faces()) expected += before.degree(f) - 3;
  EXPECT_EQ(added, expected);
  EXPECT_EQ(after.face_count(), before.face_count() + added);
  EXPECT_EQ(after.edge_count(), before.edge_count() + added);
  EXPECT_EQ(after.vertex_count(), before.vertex_count());
  for (const Face f : after.faces()) EXPECT_EQ(after.degree(f), 3U);
  EXPECT_EQ(edges_of(after).size(), after.edge_count());
  for (const Halfedge h : before.halfedges()) {
    EXPECT_EQ(after.to_vertex(h), before.to_vertex(h));
    EXPECT_EQ(after.is_boundary(h), before.is_boundary(h));
  }
}

TEST(Triangulate, SweepOverAllFacesAndMeshes) {
  std::map<std::string_view, int> outcomes;
  for (const auto& [name, mesh] : meshes_to_sweep(25)) {
    SCOPED_TRACE(name);
    bool done = false;
    const Mesh all = try_operation(
        mesh, [](const Mesh& m) { return check_triangulate(m); },
        [](Mesh& m) { return triangulate(m); }, done);
    ++outcomes[done ? "done" : check_triangulate(mesh).error().code];
    if (done) expect_cut(mesh, all, all.face_count() - mesh.face_count());
    for (const Face f : mesh.faces()) {
      if (f.index() > 30) break;
      const Mesh one = try_operation(
          mesh, [&](const Mesh& m) { return check_triangulate(m, f); },
          [&](Mesh& m) { return triangulate(m, f); }, done);
      ++outcomes[done ? "one" : check_triangulate(mesh, f).error().code];
      if (!done) continue;
      EXPECT_EQ(one.degree(f), 3U);
      EXPECT_EQ(one.face_count(), mesh.face_count() + mesh.degree(f) - 3);
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(outcomes["done"], 35);
  EXPECT_GT(outcomes["one"], 500);
}

Mesh mesh_of(Polys polygons, const std::vector<Point>& points) {
  Shape shape("", Index(points.size()), std::move(polygons));
  for (std::size_t v = 0; v < points.size(); ++v) {
    shape.positions[3 * v] = points[v].x;
    shape.positions[3 * v + 1] = points[v].y;
    shape.positions[3 * v + 2] = points[v].z;
  }
  return reference_build(shape);
}

const std::vector<Point> kLShape = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                    {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

TEST(Triangulate, AConcaveFaceByItsInnerDiagonals) {
  Mesh mesh = mesh_of({{0, 1, 2, 3, 4, 5}}, kLShape);
  add_attributes_of_all_kinds(mesh);
  const Mesh before = copy_of(mesh);
  EXPECT_EQ(triangulate(mesh, Face(0)).value(), 3U);
  EXPECT_EQ(in_order(polygons_of(mesh)), in_order({{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}));
  // Faces have the values of the face, but for those whose policy is the default, corners keep
  // theirs, new corners have those of the corner they are part of.
  for (const auto& column : mesh.attributes().of(ItemKind::kFace)) {
    if (column->on_split() == OnSplit::kDefault) continue;
    for (const Face f : mesh.faces()) EXPECT_EQ(column->get(f.index(), 0), column->get(0, 0));
  }
  std::map<Index, Index> corner;  // by vertex: the halfedge that led there before
  for (const Halfedge h : before.face_halfedges_ccw(Face(0)))
    corner[before.to_vertex(h).index()] = h.index();
  for (const auto& column : mesh.attributes().of(ItemKind::kHalfedge)) {
    if (!column->belongs_to_corners()) continue;
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.is_boundary(h)) continue;
      EXPECT_EQ(column->get(h.index(), 0), column->get(corner[mesh.to_vertex(h).index()], 0));
    }
  }
}

TEST(Triangulate, BothSidesOfAQuadGetDifferentDiagonals) {
  const std::vector<Point> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Mesh mesh = mesh_of({{0, 1, 2, 3}, {3, 2, 1, 0}}, square);
  EXPECT_EQ(triangulate(mesh).value(), 2U);
  expect_valid_mesh(mesh);
  EXPECT_EQ(edges_of(mesh).size(), 6U);
}

TEST(Triangulate, RefusesWhereAllDiagonalsExistAlready) {
  // A quad with a tetrahedron's other edges above it: both its diagonals are edges.
  Mesh mesh = mesh_of({{0, 1, 2, 3}, {0, 2, 4}, {1, 3, 5}},
                      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}});
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  for (const bool one : {true, false}) {
    const Result<Index> refused = one ? triangulate(mesh, Face(0)) : triangulate(mesh);
    expect_refused(refused, "no-triangulation", mesh, before);
    const Witness& witness = refused.error().witness;
    ASSERT_EQ(witness.edges.size(), 1U);
    EXPECT_EQ(witness.faces, std::vector<Index>{0});
    const Halfedge h = mesh.edge_halfedge(Edge(witness.edges[0]));
    const std::set<Index> ends = {mesh.from_vertex(h).index(), mesh.to_vertex(h).index()};
    EXPECT_EQ(ends, (std::set<Index>{witness.vertices[0], witness.vertices[1]}));
    EXPECT_TRUE(ends == (std::set<Index>{0, 2}) || ends == (std::set<Index>{1, 3}));
  }
  expect_refused(triangulate(mesh, Face(9)), "not-a-face", mesh, before);
  expect_refused(triangulate(mesh, Face{}), "not-a-face", mesh, before);
}

TEST(Triangulate, RefusesWhereOnlyOneDiagonalIsInsideAndExists) {
  Mesh mesh =
      mesh_of({{0, 1, 2, 3}, {2, 0, 4}}, {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}, {9, 9, 9}});
  const Snapshot before(mesh);
  const Result<Index> refused = triangulate(mesh, Face(0));
  expect_refused(refused, "no-triangulation", mesh, before);
  EXPECT_EQ(refused.error().witness.edges,
            std::vector<Index>{mesh.find_edge(Vertex(0), Vertex(2)).index()});
}

TEST(Triangulate, RefusesWhereAnotherFaceNeedsTheSameDiagonal) {
  // Two darts with the same four corners, back to back: both need 0-2.
  Mesh mesh = mesh_of({{0, 1, 2, 3}, {3, 2, 1, 0}}, {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});
  const Snapshot before(mesh);
  const Result<Index> refused = triangulate(mesh);
  expect_refused(refused, "no-triangulation", mesh, before);
  EXPECT_TRUE(refused.error().witness.edges.empty());
  EXPECT_EQ(refused.error().witness.faces, std::vector<Index>{1});
}

/// Closed surfaces of two discs of a few faces each, over the same corners: front and back share so
/// many that a diagonal of one face may be the only one of another.
Mesh random_pillow(std::mt19937& random) {
  const Index n = 6 + Index(random() % 5);
  std::vector<std::vector<Index>> faces;
  for (const bool is_front : {true, false}) {
    std::vector<Index> left(n);
    for (Index i = 0; i < n; ++i) left[i] = is_front ? i : n - 1 - i;
    std::rotate(left.begin(), left.begin() + std::ptrdiff_t(random() % n), left.end());
    while (left.size() > 5) {  // a quad at an end
      faces.push_back({left[0], left[1], left[2], left[3]});
      left.erase(left.begin() + 1, left.begin() + 3);
      std::rotate(left.begin(), left.begin() + std::ptrdiff_t(random() % left.size()), left.end());
    }
    faces.push_back(left);
  }
  std::ranges::shuffle(faces, random);
  Mesh mesh;
  BuildReport report;
  const Shape pillow("pillow", n, faces);
  if (!build_from_polygons(mesh, pillow.polygons(), report)) return {};
  std::uniform_real_distribution<float> anywhere(0, 1);
  for (const Vertex v : mesh.vertices()) {
    mesh.set_position(v, {anywhere(random), anywhere(random), 0.1F * anywhere(random)});
  }
  return mesh;
}

TEST(Triangulate, GivesAFacePrecedenceThatAnotherWouldLeaveNoWay) {
  // A pentagon, whose shortest diagonal is 0-2, and a dart that has no other way inside.
  Mesh mesh = mesh_of({{0, 1, 2, 3, 4}, {2, 1, 0, 5}},
                      {{0, 0, 0}, {1, -0.5F, 0}, {2, 0, 0}, {2, 6, 0}, {0, 6, 0}, {-2, 0.8F, 0}});
  {
    Mesh alone =
        mesh_of({{0, 1, 2, 3, 4}}, {{0, 0, 0}, {1, -0.5F, 0}, {2, 0, 0}, {2, 6, 0}, {0, 6, 0}});
    ASSERT_TRUE(triangulate(alone).ok());
    ASSERT_TRUE(alone.find_edge(Vertex(0), Vertex(2)).valid());
  }
  EXPECT_EQ(triangulate(mesh).value(), 3U);
  expect_valid_mesh(mesh);
  const Edge diagonal = mesh.find_edge(Vertex(0), Vertex(2));
  ASSERT_TRUE(diagonal.valid());  // between the triangles of the dart
  std::set<Index> tips;
  for (const Index side : {0U, 1U}) {
    tips.insert(mesh.to_vertex(mesh.next(mesh.edge_halfedge(diagonal, side))).index());
  }
  EXPECT_EQ(tips, (std::set<Index>{1, 5}));
}

TEST(Triangulate, CutsAllFacesOfPillowsOrNone) {
  int refused = 0;
  int cut = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh = random_pillow(random);
    if (mesh.face_count() == 0) continue;
    SCOPED_TRACE(seed);
    Mesh before;
    ASSERT_TRUE(before.assign(mesh));
    const bool can = check_triangulate(mesh).ok();
    const Result<Index> added = triangulate(mesh);
    ASSERT_EQ(added.ok(), can);
    if (!can) {
      ++refused;
      continue;
    }
    ++cut;
    expect_cut(before, mesh, added.value());
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(cut, 1600);  // without precedence 1,460
  EXPECT_GT(refused, 0);
}

TEST(Triangulate, WithoutPrevAndWithoutPositions) {
  BasicMesh<kWithoutPrev> light;
  Mesh mesh = reference_build(mixed_polygons());
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(light, mixed_polygons().polygons(), report));
  EXPECT_EQ(triangulate(light).value(), triangulate(mesh).value());
  EXPECT_FALSE(has_errors(validate(light)));
  Connectivity bare;
  ASSERT_TRUE(bare.assign(reference_build(mixed_polygons())));
  EXPECT_EQ(triangulate(bare).value(), 6U);
  EXPECT_FALSE(has_errors(validate(bare)));
}

TEST(Triangulate, TakesSlotsThatWereDeleted) {
  Mesh mesh = reference_build(quad_grid(3, 3));
  add_attributes_of_all_kinds(mesh);
  ASSERT_TRUE(decorator::make_hole(mesh, mesh.face_halfedge(Face(4))).ok());
  EXPECT_EQ(triangulate(mesh).value(), 8U);
  EXPECT_EQ(mesh.face_slots(), 16U);
  expect_valid_mesh(mesh);
}

}  // namespace
}  // namespace halfedge::test
