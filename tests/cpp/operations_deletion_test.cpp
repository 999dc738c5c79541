// Deletion of faces, edges, vertices and components.

#include <gtest/gtest.h>
#include <halfedge/operations/add_face.h>
#include <halfedge/operations/components.h>
#include <halfedge/operations/deletion.h>

#include <set>
#include <string>
#include <vector>

#include "support/face_lists.h"
#include "support/sweep.h"

namespace halfedge::test {
namespace {

using namespace operations;
using Corners = std::vector<Index>;

constexpr DeleteOptions kKeep{.keep_isolated_vertices = true};

std::set<Index> live_vertices(const Mesh& mesh) {
  std::set<Index> vertices;
  for (const Vertex v : mesh.vertices()) vertices.insert(v.index());
  return vertices;
}

std::set<Index> isolated_vertices(const Mesh& mesh) {
  std::set<Index> vertices;
  for (const Vertex v : mesh.vertices()) {
    if (mesh.is_isolated(v)) vertices.insert(v.index());
  }
  return vertices;
}

/// That `after` is `mesh` without the faces of `gone`, the edges that only these had, and unless
/// they are kept the vertices; `also` is gone in any case.
void expect_without(const Mesh& mesh, const std::set<Face>& gone, Vertex also, bool keeps,
                    const Mesh& after) {
  Polys left;
  std::set<Index> kept = isolated_vertices(mesh);
  for (const Face f : mesh.faces()) {
    if (gone.count(f) > 0) {
      EXPECT_FALSE(after.is_live(f));
      continue;
    }
    left.push_back(corners_of(mesh, mesh.face_halfedge(f)));
    kept.insert(left.back().begin(), left.back().end());
  }
  if (keeps) kept = live_vertices(mesh);
  if (also.valid()) kept.erase(also.index());
  EXPECT_EQ(polys_of(after), in_order(left));
  EXPECT_EQ(after.edge_count(), edges_of(left).size());
  EXPECT_EQ(live_vertices(after), kept);
  // What stays has its number and its links to faces.
  for (const Edge e : mesh.edges()) {
    if (!after.is_live(e)) continue;
    for (const Index side : {0U, 1U}) {
      const Halfedge h = mesh.edge_halfedge(e, side);
      EXPECT_EQ(after.to_vertex(h), mesh.to_vertex(h));
      EXPECT_EQ(after.face(h), gone.count(mesh.face(h)) > 0 ? Face{} : mesh.face(h));
    }
  }
}

template <class Item>
std::set<Face> faces_at(const Mesh& mesh, Item item) {
  std::set<Face> faces;
  if constexpr (std::is_same_v<Item, Face>) {
    faces.insert(item);
  } else if constexpr (std::is_same_v<Item, Edge>) {
    for (const Index side : {0U, 1U}) faces.insert(mesh.face(mesh.edge_halfedge(item, side)));
  } else {
    for (const Face f : mesh.vertex_faces_ccw(item)) faces.insert(f);
  }
  faces.erase(Face{});
  return faces;
}

TEST(DeleteFace, LeavesTheRestOfAnyMesh) {
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Face f : mesh.faces()) {
      SCOPED_TRACE(f.index());
      for (const bool keeps : {false, true}) {
        Mesh after;
        ASSERT_TRUE(holds_contract(
            mesh, [&](const Mesh& m) { return check_delete_face(m, f); },
            [&](Mesh& m) { return delete_face(m, f, {.keep_isolated_vertices = keeps}); }, after));
        expect_without(mesh, faces_at(mesh, f), {}, keeps, after);
        if (!keeps) continue;
        std::vector<Vertex> corners;
        for (const Vertex v : mesh.face_vertices_ccw(f)) corners.push_back(v);
        ASSERT_EQ(add_face(after, corners).value(), f);
        EXPECT_EQ(polys_of(after), polys_of(mesh));
      }
    }
  }
}

TEST(DeleteEdge, LeavesTheRestOfAnyMesh) {
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Edge e : mesh.edges()) {
      SCOPED_TRACE(e.index());
      for (const bool keeps : {false, true}) {
        Mesh after;
        ASSERT_TRUE(holds_contract(
            mesh, [&](const Mesh& m) { return check_delete_edge(m, e); },
            [&](Mesh& m) { return delete_edge(m, e, {.keep_isolated_vertices = keeps}); }, after));
        expect_without(mesh, faces_at(mesh, e), {}, keeps, after);
      }
    }
  }
}

TEST(DeleteVertex, LeavesTheRestOfAnyMesh) {
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Vertex v : mesh.vertices()) {
      SCOPED_TRACE(v.index());
      for (const bool keeps : {false, true}) {
        Mesh after;
        ASSERT_TRUE(holds_contract(
            mesh, [&](const Mesh& m) { return check_delete_vertex(m, v); },
            [&](Mesh& m) { return delete_vertex(m, v, {.keep_isolated_vertices = keeps}); },
            after));
        expect_without(mesh, faces_at(mesh, v), v, keeps, after);
      }
    }
  }
}

TEST(DeleteFace, MakesAndResolvesPinchedVertices) {
  Mesh mesh = reference_build(disk(6));
  ASSERT_TRUE(delete_face(mesh, Face(0)));
  ASSERT_TRUE(mesh.is_manifold(Vertex(0)));
  ASSERT_TRUE(delete_face(mesh, Face(2)));
  EXPECT_FALSE(mesh.is_manifold(Vertex(0)));
  EXPECT_EQ(polys_of(mesh), in_order({{0, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}}));
  ASSERT_TRUE(delete_face(mesh, Face(1)));
  EXPECT_TRUE(mesh.is_manifold(Vertex(0)));
  EXPECT_FALSE(mesh.is_live(Vertex(2)));
  EXPECT_FALSE(mesh.is_live(Vertex(3)));
}

TEST(Delete, SaysWhyItCannot) {
  Mesh mesh = reference_build(cube());
  add_attributes_of_all_kinds(mesh);
  ASSERT_TRUE(delete_vertex(mesh, Vertex(0)));
  const Snapshot before(mesh);
  expect_refused(delete_face(mesh, Face(0)), "not-a-face", mesh, before);
  expect_refused(delete_edge(mesh, Edge(99)), "not-an-edge", mesh, before);
  expect_refused(delete_vertex(mesh, Vertex(0)), "not-a-vertex", mesh, before);
  expect_refused(delete_component(mesh, Vertex(0)), "not-a-vertex", mesh, before);
  expect_refused(delete_component(mesh, Face{}), "not-a-face", mesh, before);
  expect_refused(delete_component(mesh, Edge(99)), "not-an-edge", mesh, before);
  expect_refused(delete_component(mesh, Halfedge(99)), "not-a-halfedge", mesh, before);
  EXPECT_EQ(delete_vertex(mesh, Vertex(0)).error().witness.vertices, (Corners{0}));
  EXPECT_EQ(check_delete_edge(mesh, Edge(99)).error().witness.edges, (Corners{99}));
  EXPECT_EQ(check_delete_face(mesh, Face(0)).error().witness.faces, (Corners{0}));
}

TEST(DeleteIsolatedVertices, CountsThem) {
  Mesh mesh = reference_build(with_isolated_vertices());
  ASSERT_TRUE(mesh.enable_history());
  const Snapshot before(mesh);
  EXPECT_EQ(delete_isolated_vertices(mesh), 3U);
  EXPECT_EQ(live_vertices(mesh), (std::set<Index>{1, 2, 4}));
  EXPECT_TRUE(Invariants(mesh).hold());
  EXPECT_EQ(delete_isolated_vertices(mesh), 0U);
  mesh.end_step();
  ASSERT_TRUE(mesh.undo());
  EXPECT_TRUE(Snapshot(mesh) == before);
  Mesh kept = reference_build(cube());
  ASSERT_TRUE(delete_vertex(kept, Vertex(3), kKeep));
  EXPECT_EQ(delete_isolated_vertices(kept), 0U);
  for (const Index v : {0U, 6U}) ASSERT_TRUE(delete_vertex(kept, Vertex(v), kKeep));
  EXPECT_EQ(kept.face_count(), 0U);
  EXPECT_EQ(delete_isolated_vertices(kept), 5U);
  EXPECT_EQ(kept.vertex_count(), 0U);
}

TEST(DeleteComponent, TakesAllThatIsJoined) {
  for (auto& [name, mesh] : meshes_to_sweep(4)) {
    SCOPED_TRACE(name);
    for (const Vertex v : mesh.vertices()) {
      // By hand: what faces join to v.
      std::set<Index> reached{v.index()};
      std::set<Face> gone;
      for (std::size_t size = 0; size != reached.size();) {
        size = reached.size();
        for (const Face f : mesh.faces()) {
          const Corners corners = corners_of(mesh, mesh.face_halfedge(f));
          bool touches = false;
          for (const Index corner : corners) touches = touches || reached.count(corner) > 0;
          if (!touches) continue;
          gone.insert(f);
          reached.insert(corners.begin(), corners.end());
        }
      }
      Mesh after;
      ASSERT_TRUE(holds_contract(
          mesh, [&](const Mesh& m) { return check_delete_component(m, v); },
          [&](Mesh& m) { return delete_component(m, v); }, after));
      expect_without(mesh, gone, mesh.is_isolated(v) ? v : Vertex{}, false, after);
      if (gone.empty()) continue;
      Mesh other = copy_of(mesh);
      EXPECT_EQ(delete_component(other, *gone.begin()).value(), gone.size());
      EXPECT_TRUE(LiveItems(other) == LiveItems(after));
      other = copy_of(mesh);
      EXPECT_EQ(delete_component(other, mesh.vertex_halfedge(v)).value(), gone.size());
      EXPECT_TRUE(LiveItems(other) == LiveItems(after));
      other = copy_of(mesh);
      EXPECT_EQ(delete_component(other, mesh.edge(mesh.vertex_halfedge(v))).value(), gone.size());
      EXPECT_TRUE(LiveItems(other) == LiveItems(after));
    }
  }
}

TEST(KeepLargestComponents, KeepsTheLargest) {
  const Shape shape{
      "three components and a vertex", 13, {{0, 1, 2}, {3, 4, 5}, {4, 3, 6}, {7, 8, 9, 10, 11}}};
  Mesh mesh = reference_build(shape);
  add_attributes_of_all_kinds(mesh);
  ASSERT_TRUE(mesh.enable_history());
  const Snapshot before(mesh);
  EXPECT_EQ(keep_largest_components(mesh, 2).value(), 1U);
  EXPECT_EQ(polys_of(mesh), in_order({{3, 4, 5}, {4, 3, 6}, {7, 8, 9, 10, 11}}));
  EXPECT_EQ(live_vertices(mesh), (std::set<Index>{3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_TRUE(Invariants(mesh).hold());
  mesh.end_step();
  EXPECT_EQ(keep_largest_components(mesh, 0).value(), 2U);
  EXPECT_EQ(mesh.vertex_count(), 0U);
  EXPECT_EQ(mesh.edge_count(), 0U);
  mesh.end_step();
  while (mesh.undo()) {
  }
  EXPECT_TRUE(Snapshot(mesh) == before);
}

TEST(Delete, WorksWherePrevIsNotStored) {
  BasicMesh<kWithoutPrev> mesh;
  ASSERT_TRUE(convert(reference_build(torus(5, 4)), mesh));
  ASSERT_TRUE(delete_vertex(mesh, Vertex(7)));
  ASSERT_TRUE(delete_edge(mesh, mesh.edge(mesh.vertex_halfedge(Vertex(0)))));
  ASSERT_TRUE(delete_face(mesh, *mesh.faces().begin(), kKeep));
  EXPECT_EQ(delete_isolated_vertices(mesh), 0U);
  EXPECT_EQ(mesh.face_count(), 13U);
  EXPECT_FALSE(has_errors(validate(mesh)));
  EXPECT_EQ(delete_component(mesh, *mesh.faces().begin()).value(), 13U);
  EXPECT_EQ(keep_largest_components(mesh, 1).value(), 0U);
  EXPECT_EQ(mesh.vertex_count(), 0U);
}

}  // namespace
}  // namespace halfedge::test
