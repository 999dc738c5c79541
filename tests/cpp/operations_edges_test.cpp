// Operations on one edge: flip, a vertex on it, split.

#include <gtest/gtest.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/flip.h>
#include <halfedge/operations/split_edge.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/face_lists.h"
#include "support/sweep.h"

namespace halfedge::test {
namespace {

using namespace operations;
using Corners = std::vector<Index>;

Halfedge halfedge(const Mesh& mesh, Index from, Index to) {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  EXPECT_TRUE(h.valid()) << "from " << from << " to " << to;
  return h;
}

Edge edge(const Mesh& mesh, Index from, Index to) { return mesh.edge(halfedge(mesh, from, to)); }

Shape octahedron() {
  return {"octahedron",
          6,
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}};
}
Shape bipyramid() {
  return {"bipyramid", 5, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
}
Shape two_triangles() { return {"two triangles", 4, {{0, 1, 2}, {0, 2, 3}}}; }

std::vector<std::pair<std::string, Mesh>> meshes() {
  std::vector<std::pair<std::string, Mesh>> all = meshes_to_sweep();
  for (const Shape& shape : {octahedron(), bipyramid(), two_triangles()}) {
    Mesh mesh = reference_build(shape);
    add_attributes_of_all_kinds(mesh);
    all.emplace_back(shape.name, std::move(mesh));
  }
  return all;
}

/// The error of an operation on a mesh with attributes and history, which must change nothing.
template <class Operate>
Error refusal_of(const Shape& shape, const Operate& operate) {
  Mesh mesh = reference_build(shape);
  add_attributes_of_all_kinds(mesh);
  EXPECT_TRUE(mesh.enable_history());
  const Snapshot before(mesh);
  const auto result = operate(mesh);
  EXPECT_FALSE(result.ok());
  if (result.ok()) return {};
  expect_refused(result, result.error().code, mesh, before);
  return result.error();
}

Corners replaced(const Corners& face, Index gone, Index instead) {
  Corners result = face;
  std::replace(result.begin(), result.end(), gone, instead);
  return result;
}

/// The faces with `w` between `u` and `v` wherever they follow each other.
Polys with_vertex_between(Polys faces, Index u, Index v, Index w) {
  for (Corners& face : faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::set<Index> ends = {face[i], face[(i + 1) % face.size()]};
      if (ends != std::set<Index>{u, v}) continue;
      face.insert(face.begin() + std::ptrdiff_t(i) + 1, w);
      break;
    }
  }
  return in_order(faces);
}

/// The same, with the triangles there cut in two.
Polys split_at(const Polys& faces, Index u, Index v, Index w) {
  Polys result;
  for (const Corners& face : faces) {
    const bool has_both =
        std::count(face.begin(), face.end(), u) > 0 && std::count(face.begin(), face.end(), v) > 0;
    if (face.size() == 3 && has_both) {
      result.push_back(replaced(face, u, w));
      result.push_back(replaced(face, v, w));
    } else {
      result.push_back(face);
    }
  }
  return with_vertex_between(result, u, v, w);
}

// ---- flip -----------------------------------------------------------------------------------

Index count_flippable(const Shape& shape) {
  const Mesh mesh = reference_build(shape);
  Index count = 0;
  for (const Edge e : mesh.edges()) count += check_flip_edge(mesh, e) ? 1 : 0;
  return count;
}

TEST(FlipEdge, IsAllowedAsOftenAsInOpenMesh) {
  EXPECT_EQ(count_flippable(octahedron()), 12U);
  EXPECT_EQ(count_flippable(two_triangles()), 1U);
  EXPECT_EQ(count_flippable(triangle()), 0U);
  EXPECT_EQ(count_flippable(pillow()), 0U);
  EXPECT_EQ(count_flippable(pinched(2)), 0U);
  EXPECT_EQ(count_flippable(bipyramid()), 3U);
  EXPECT_EQ(count_flippable(triangle_grid(2, 2)), 8U);
  EXPECT_EQ(count_flippable(tetrahedron()), 0U);
}

TEST(FlipEdge, DecidesAndDoesWhatListsOfFacesSay) {
  std::size_t done = 0;
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const Polys faces = polys_of(mesh);
    for (const Edge e : mesh.edges()) {
      SCOPED_TRACE(e.index());
      const Halfedge h = mesh.edge_halfedge(e);
      const Halfedge o = mesh.opposite(h);
      const Index u = mesh.from_vertex(h).index();
      const Index v = mesh.to_vertex(h).index();
      std::optional<Polys> expected;
      if (!mesh.is_boundary(e) && mesh.degree(mesh.face(h)) == 3 &&
          mesh.degree(mesh.face(o)) == 3) {
        const Index a = mesh.to_vertex(mesh.next(h)).index();
        const Index b = mesh.to_vertex(mesh.next(o)).index();
        Polys after = faces;
        after.erase(std::find(after.begin(), after.end(), in_order({{u, v, a}})[0]));
        after.erase(std::find(after.begin(), after.end(), in_order({{v, u, b}})[0]));
        after.push_back({b, a, u});
        after.push_back({a, b, v});
        // As many edges as before: the new one is no other one's double.
        if (count_fans(after) > 0 && edges_of(after).size() == edges_of(faces).size() &&
            mesh.find_edge(Vertex(a), Vertex(b)) == Edge{}) {
          expected = in_order(after);
        }
      }
      Mesh after;
      const bool is_done = holds_contract(
          mesh, [&](const Mesh& m) { return check_flip_edge(m, e); },
          [&](Mesh& m) { return flip_edge(m, e); }, after);
      ASSERT_EQ(is_done, expected.has_value());
      if (!is_done) continue;
      ++done;
      EXPECT_EQ(polys_of(after), *expected);
      EXPECT_EQ(after.to_vertex(h), mesh.to_vertex(mesh.next(h))) << "counter-clockwise";
      EXPECT_EQ(after.face(h), mesh.face(h));
      for (int i = 0; i < 3; ++i) ASSERT_TRUE(flip_edge(after, e));
      EXPECT_TRUE(LiveItems(after) == LiveItems(mesh));
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(done, 60U);
}

TEST(FlipEdge, RefusesWithAWitness) {
  const auto flip = [](Index from, Index to) {
    return [=](Mesh& mesh) { return flip_edge(mesh, edge(mesh, from, to)); };
  };
  const auto index = [](const Shape& shape, Index from, Index to) {
    return edge(reference_build(shape), from, to).index();
  };
  EXPECT_EQ(refusal_of(triangle(), [](Mesh& m) { return flip_edge(m, Edge(3)); }).code,
            "not-an-edge");
  const Error boundary = refusal_of(two_triangles(), flip(0, 1));
  EXPECT_EQ(boundary.code, "boundary-edge");
  EXPECT_EQ(boundary.witness.edges, Corners{index(two_triangles(), 0, 1)});
  const Mesh two = reference_build(two_triangles());
  EXPECT_EQ(boundary.witness.halfedges, Corners{halfedge(two, 1, 0).index()});
  const Error quad = refusal_of(mixed_polygons(), flip(0, 2));  // triangle 0 1 2, quad 0 2 3 4
  EXPECT_EQ(quad.code, "not-a-triangle");
  EXPECT_EQ(quad.witness.faces, Corners{1});
  const Error same = refusal_of(pillow(), flip(0, 1));
  EXPECT_EQ(same.code, "same-vertex");
  EXPECT_EQ(same.witness, (Witness{.vertices = {2}, .edges = {index(pillow(), 0, 1)}}));
  const Error exists = refusal_of(tetrahedron(), flip(0, 1));  // 2 and 3 are joined
  EXPECT_EQ(exists.code, "edge-exists");
  EXPECT_EQ(exists.witness, (Witness{.vertices = {2, 3}, .edges = {index(tetrahedron(), 2, 3)}}));
}

TEST(FlipEdge, DividesTheCornersAtItsNewEnds) {
  Mesh mesh = reference_build(two_triangles());  // 0 1 2, 0 2 3
  Attribute& uv = *mesh.add_attribute(ItemKind::kHalfedge, "uv").value();
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) continue;
    uv.set(h.index(), 0, 10 * mesh.face(h).index() + mesh.to_vertex(h).index(), nullptr);
  }
  const Halfedge h = halfedge(mesh, 0, 2);  // in the face 0 2 3
  ASSERT_TRUE(flip_edge(mesh, mesh.edge(h)));
  const Halfedge o = mesh.opposite(h);
  // 1 belonged to the first face only, 3 to the second only; 0 and 2 keep one of their two.
  for (const Halfedge on_loop : mesh.loop_ccw(h)) {
    const Index v = mesh.to_vertex(on_loop).index();
    EXPECT_EQ(uv.get(on_loop.index(), 0), v == 1 ? 1 : 10 + v);
  }
  for (const Halfedge on_loop : mesh.loop_ccw(o)) {
    const Index v = mesh.to_vertex(on_loop).index();
    EXPECT_EQ(uv.get(on_loop.index(), 0), v == 3 ? 13 : v);
  }
}

// ---- a vertex on an edge --------------------------------------------------------------------

TEST(InsertVertexOnEdge, GivesBothFacesACornerAndIsUndoneExactly) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    for (const Edge e : mesh.edges()) {
      const Vertex u = mesh.from_vertex(mesh.edge_halfedge(e));
      const Vertex v = mesh.to_vertex(mesh.edge_halfedge(e));
      Mesh after;
      ASSERT_TRUE(holds_contract(
          mesh, [&](const Mesh& m) { return check_insert_vertex_on_edge(m, e); },
          [&](Mesh& m) { return insert_vertex_on_edge(m, e); }, after));
      const Vertex w(mesh.vertex_slots());
      EXPECT_EQ(polys_of(after),
                with_vertex_between(polys_of(mesh), u.index(), v.index(), w.index()));
      EXPECT_EQ(after.from_vertex(after.edge_halfedge(e)), w) << "the old edge is the half at v";
      EXPECT_EQ(after.to_vertex(after.edge_halfedge(e)), v);
      EXPECT_EQ(after.position(w), steps::blend(mesh.position(u), mesh.position(v), 0.5));
      const Result<Edge> left = remove_vertex_on_edge(after, w);
      ASSERT_TRUE(left.ok()) << left.error().message;
      EXPECT_EQ(left.value(), e);
      EXPECT_TRUE(LiveItems(after) == LiveItems(mesh));
      EXPECT_FALSE(has_errors(validate(after)));
      if (HasFailure()) return;
    }
  }
}

TEST(InsertVertexOnEdge, TakesValuesFromThePointOfTheEdgeThatIsClosest) {
  Mesh mesh = reference_build(triangle());
  Attribute& heat = *mesh.add_attribute(ItemKind::kVertex, "heat").value();
  Attribute& uv = *mesh.add_attribute(ItemKind::kHalfedge, "uv").value();
  const Edge e = edge(mesh, 0, 1);
  const Halfedge h = mesh.edge_halfedge(e);
  const Vertex u = mesh.from_vertex(h);
  const Vertex v = mesh.to_vertex(h);
  mesh.set_position(u, {1, 1, 1});
  mesh.set_position(v, {5, 1, 1});
  heat.set(u.index(), 0, 100, nullptr);
  heat.set(v.index(), 0, 200, nullptr);
  uv.set(mesh.prev(h).index(), 0, 10, nullptr);
  uv.set(h.index(), 0, 20, nullptr);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const struct {
    std::optional<Point> position;
    double t;
  } cases[] = {{{}, 0.5},
               {Point{2, 9, -9}, 0.25},
               {Point{-3, 0, 0}, 0},
               {Point{8, 2, 2}, 1},
               {Point{nan, 0, 0}, 0.5}};
  for (const auto& each : cases) {
    Mesh copy = copy_of(mesh);
    const Vertex w = insert_vertex_on_edge(copy, e, each.position).value();
    EXPECT_FLOAT_EQ(float(copy.find_attribute(ItemKind::kVertex, "heat")->get(w.index(), 0)),
                    float(100 + 100 * each.t));
    const Halfedge to_w = halfedge(copy, u.index(), w.index());
    EXPECT_FLOAT_EQ(float(copy.find_attribute(ItemKind::kHalfedge, "uv")->get(to_w.index(), 0)),
                    float(10 + 10 * each.t));
    if (each.t == 0.5) continue;
    EXPECT_EQ(copy.position(w), *each.position);
  }
  mesh.set_position(v, {1, 1, 1});  // an edge of no length
  const Vertex w = insert_vertex_on_edge(mesh, e, Point{4, 4, 4}).value();
  EXPECT_EQ(mesh.find_attribute(ItemKind::kVertex, "heat")->get(w.index(), 0), 150);
  EXPECT_EQ(mesh.position(w), (Point{4, 4, 4}));
}

TEST(RemoveVertexOnEdge, DecidesAndDoesWhatListsOfFacesSay) {
  std::size_t done = 0;
  std::set<std::string_view> codes;
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    for (const Vertex v : mesh.vertices()) {
      SCOPED_TRACE(v.index());
      Polys expected;
      bool is_polygonal = true;
      for (Corners face : polys_of(mesh)) {
        face.erase(std::remove(face.begin(), face.end(), v.index()), face.end());
        is_polygonal = is_polygonal && face.size() > 2;
        expected.push_back(face);
      }
      const bool can = !mesh.is_isolated(v) && mesh.valence(v) == 2 && is_polygonal &&
                       edges_of(expected).size() + 1 == mesh.edge_count();
      Mesh after;
      const bool is_done = holds_contract(
          mesh, [&](const Mesh& m) { return check_remove_vertex_on_edge(m, v); },
          [&](Mesh& m) { return remove_vertex_on_edge(m, v); }, after);
      ASSERT_EQ(is_done, can);
      if (!is_done) {
        codes.insert(check_remove_vertex_on_edge(mesh, v).error().code);
        continue;
      }
      ++done;
      EXPECT_EQ(polys_of(after), in_order(expected));
      EXPECT_TRUE(after.is_deleted(v));
    }
  }
  EXPECT_GT(done, 10U);
  EXPECT_EQ(codes,
            (std::set<std::string_view>{"not-valence-two", "degree-below-three", "edge-exists"}));
}

TEST(RemoveVertexOnEdge, RefusesWithAWitness) {
  const auto remove = [](Index v) {
    return [=](Mesh& mesh) { return remove_vertex_on_edge(mesh, Vertex(v)); };
  };
  EXPECT_EQ(refusal_of(triangle(), remove(3)).code, "not-a-vertex");
  const Error isolated = refusal_of(with_isolated_vertices(), remove(0));
  EXPECT_EQ(isolated.code, "not-valence-two");
  EXPECT_EQ(isolated.witness.vertices, Corners{0});
  EXPECT_NE(isolated.message.find("valence 0"), std::string::npos);
  EXPECT_NE(refusal_of(octahedron(), remove(4)).message.find("valence 4"), std::string::npos);
  const Error corner = refusal_of(two_triangles(), remove(3));
  EXPECT_EQ(corner.code, "degree-below-three");
  EXPECT_EQ(corner.witness, (Witness{.vertices = {3}, .faces = {1}}));
  // Quads on both sides of 0-1-2, whose ends a triangle joins.
  const Shape joined{"joined", 6, {{0, 1, 2, 3}, {2, 1, 0, 4}, {0, 3, 5}, {0, 2, 4}, {0, 5, 2}}};
  const Error exists = refusal_of(joined, remove(1));
  EXPECT_EQ(exists.code, "edge-exists");
  Corners ends = exists.witness.vertices;
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(ends, (Corners{0, 2}));
  EXPECT_EQ(exists.witness.edges, Corners{edge(reference_build(joined), 0, 2).index()});
}

TEST(RemoveVertexOnEdge, KeepsTheEdgeOfLowerIndexAndTheCornersAtBothEnds) {
  for (const bool first : {true, false}) {
    Mesh mesh = reference_build(cube());
    Attribute& uv = *mesh.add_attribute(ItemKind::kHalfedge, "uv").value();
    for (const Halfedge h : mesh.halfedges()) uv.set(h.index(), 0, h.index(), nullptr);
    const Edge e(5);
    const Vertex w = insert_vertex_on_edge(mesh, e).value();
    // Again on one of the halves, so that the lower edge lies on either side.
    const Vertex x = insert_vertex_on_edge(mesh, first ? e : Edge(12)).value();
    const Edge kept = remove_vertex_on_edge(mesh, first ? w : x).value();
    EXPECT_EQ(kept, Edge(12));
    EXPECT_EQ(remove_vertex_on_edge(mesh, first ? x : w).value(), e);
    for (const Halfedge h : mesh.halfedges()) EXPECT_EQ(uv.get(h.index(), 0), h.index());
  }
}

// ---- split ----------------------------------------------------------------------------------

TEST(SplitEdge, CutsTheTrianglesAndIsUndoneByCollapse) {
  std::size_t done = 0;
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    for (const Edge e : mesh.edges()) {
      SCOPED_TRACE(e.index());
      const Halfedge h = mesh.edge_halfedge(e);
      const Vertex u = mesh.from_vertex(h);
      const Vertex v = mesh.to_vertex(h);
      const Vertex w(mesh.vertex_slots());
      const Polys expected = split_at(polys_of(mesh), u.index(), v.index(), w.index());
      Mesh after;
      const bool is_done = holds_contract(
          mesh, [&](const Mesh& m) { return check_split_edge(m, e); },
          [&](Mesh& m) { return split_edge(m, e); }, after);
      ASSERT_EQ(is_done, count_fans(expected) > 0);
      if (!is_done) continue;
      ++done;
      EXPECT_EQ(polys_of(after), expected);
      EXPECT_EQ(after.from_vertex(h), w);
      EXPECT_EQ(after.to_vertex(h), v);
      EXPECT_EQ(after.face(h), mesh.face(h)) << "the faces at v keep their indices";
      EXPECT_EQ(after.face(after.opposite(h)), mesh.face(mesh.opposite(h)));
      for (const Vertex end : {u, v}) {
        Mesh back = copy_of(after);
        const Result<Vertex> kept =
            collapse(back, halfedge(back, w.index(), end.index()), {}, LinkCondition::kPermissive);
        ASSERT_TRUE(kept.ok()) << kept.error().message;
        EXPECT_EQ(polys_of(back), polys_of(mesh));
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(done, 300U);
}

TEST(SplitEdge, RefusesWithAWitness) {
  EXPECT_EQ(refusal_of(triangle(), [](Mesh& m) { return split_edge(m, Edge(3)); }).code,
            "not-an-edge");
  EXPECT_EQ(refusal_of(triangle(), [](Mesh& m) { return insert_vertex_on_edge(m, Edge()); }).code,
            "not-an-edge");
  const Error same = refusal_of(pillow(), [](Mesh& m) { return split_edge(m, edge(m, 0, 1)); });
  EXPECT_EQ(same.code, "same-vertex");
  EXPECT_EQ(same.witness,
            (Witness{.vertices = {2}, .edges = {edge(reference_build(pillow()), 0, 1).index()}}));
}

TEST(SplitEdge, GivesNewItemsTheAttributesBesideThem) {
  Mesh mesh = reference_build(two_triangles());  // 0 1 2, 0 2 3
  AttributeOptions copied;
  copied.on_split = OnSplit::kCopy;
  Attribute& crease = *mesh.add_attribute(ItemKind::kEdge, "crease", copied).value();
  Attribute& group = *mesh.add_attribute(ItemKind::kFace, "group", copied).value();
  Attribute& uv = *mesh.add_attribute(ItemKind::kHalfedge, "uv").value();
  for (const Edge e : mesh.edges()) crease.set(e.index(), 0, 1 + e.index(), nullptr);
  for (const Face f : mesh.faces()) group.set(f.index(), 0, 5 + f.index(), nullptr);
  const Point at[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto value = [](Point p) { return 100 * p.x + 10 * p.y; };  // linear: stays so
  for (const Vertex v : mesh.vertices()) mesh.set_position(v, at[v.index()]);
  for (const Halfedge h : mesh.halfedges()) {
    const double chart = mesh.is_boundary(h) ? 0 : 1000 * mesh.face(h).index();
    uv.set(h.index(), 0, chart + double{value(at[mesh.to_vertex(h).index()])}, nullptr);
  }
  const Edge e = edge(mesh, 0, 2);
  const Vertex w = split_edge(mesh, e, Point{0.25F, 0.25F, 1}).value();
  EXPECT_EQ(mesh.position(w), (Point{0.25F, 0.25F, 1}));
  const Index of_e = 1 + e.index();
  EXPECT_EQ(crease.get(edge(mesh, 0, w.index()).index(), 0), of_e);
  EXPECT_EQ(crease.get(edge(mesh, 2, w.index()).index(), 0), of_e);
  EXPECT_EQ(crease.get(edge(mesh, 1, w.index()).index(), 0), 0) << "a cut has the default";
  EXPECT_EQ(crease.get(edge(mesh, 3, w.index()).index(), 0), 0);
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) continue;
    const Corners face = corners_of(mesh, h);
    const bool is_second = std::count(face.begin(), face.end(), 3U) > 0;
    EXPECT_EQ(group.get(mesh.face(h).index(), 0), is_second ? 6 : 5);
    const double expected =
        (is_second ? 1000 : 0) + double{value(mesh.position(mesh.to_vertex(h)))};
    EXPECT_EQ(uv.get(h.index(), 0), expected) << h.index();
  }
}

}  // namespace
}  // namespace halfedge::test
