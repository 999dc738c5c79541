// Edges collapsed, flipped and split, and vertices split, beside OpenMesh's functions of these
// names: the same decision of every halfedge of many meshes, and the same faces afterwards.

#include <gtest/gtest.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/flip.h>
#include <halfedge/operations/split_edge.h>
#include <halfedge/operations/split_vertex.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "openmesh/theirs.h"
#include "support/sweep.h"

namespace halfedge::test {
namespace {

using operations::LinkCondition;
using Triangles = OpenMesh::TriMesh_ArrayKernelT<>;
using AnyPolygons = OpenMesh::PolyMesh_ArrayKernelT<>;

/// The same mesh with the same numbers of vertices and faces.
template <class Theirs>
Theirs mirror(const Mesh& mesh) {
  Theirs theirs;
  theirs.request_vertex_status();
  theirs.request_halfedge_status();
  theirs.request_edge_status();
  theirs.request_face_status();
  for (Index v = 0; v < mesh.vertex_slots(); ++v) theirs.add_vertex({0, 0, 0});
  for (const Face f : mesh.faces()) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (const Vertex v : mesh.face_vertices_ccw(f)) corners.emplace_back(int(v.index()));
    EXPECT_TRUE(theirs.add_face(corners).is_valid());
  }
  return theirs;
}

template <class Theirs>
OpenMesh::HalfedgeHandle theirs_of(const Theirs& theirs, const Mesh& mesh, Halfedge h) {
  return theirs.find_halfedge(OpenMesh::VertexHandle(int(mesh.from_vertex(h).index())),
                              OpenMesh::VertexHandle(int(mesh.to_vertex(h).index())));
}

bool is_triangle_mesh(const Mesh& mesh) {
  for (const Face f : mesh.faces()) {
    if (mesh.degree(f) != 3) return false;
  }
  return true;
}

/// Meshes to sweep, and each of them of triangles: split at the faces' centres, or as they are.
template <class Each>
void for_each_mesh(const Each& each) {
  for (auto& [name, mesh] : meshes_to_sweep(12)) {
    SCOPED_TRACE(name);
    each(std::as_const(mesh));
    if (is_triangle_mesh(mesh)) continue;
    Mesh triangles = copy_of(mesh);
    for (const Face f : mesh.faces()) {
      ASSERT_TRUE(decorator::create_center_vertex(triangles, mesh.face_halfedge(f)).ok());
    }
    SCOPED_TRACE("of triangles");
    each(std::as_const(triangles));
    for (const Edge e : mesh.edges()) (void)operations::flip_edge(triangles, e);
    SCOPED_TRACE("flipped");
    each(std::as_const(triangles));
  }
}

template <class Theirs>
void expect_same(const Mesh& ours, Theirs& theirs) {
  EXPECT_EQ(polys_of(ours), their_polys(theirs));
  theirs.garbage_collection();
  EXPECT_EQ(ours.vertex_count(), theirs.n_vertices());
  EXPECT_EQ(ours.edge_count(), theirs.n_edges());
  EXPECT_EQ(ours.face_count(), theirs.n_faces());
}

using Tally = std::map<std::string_view, int>;

/// Collapses each halfedge in both. Counts what was done, and the codes of what we refuse alone.
template <class Theirs>
void compare_collapses(const Mesh& mesh, Tally& tally) {
  Theirs theirs = mirror<Theirs>(mesh);
  for (const Halfedge h : mesh.halfedges()) {
    SCOPED_TRACE(std::to_string(mesh.from_vertex(h).index()) + " into " +
                 std::to_string(mesh.to_vertex(h).index()));
    const Result<void> can = operations::check_collapse(mesh, h, LinkCondition::kPermissive);
    if (!theirs.is_collapse_ok(theirs_of(theirs, mesh, h))) {
      EXPECT_FALSE(can.ok());
      ++tally["refused by both"];
      continue;
    }
    if (!can) {
      ++tally[can.error().code];
      continue;
    }
    ++tally["done"];
    Mesh ours = copy_of(mesh);
    ASSERT_TRUE(operations::collapse(ours, h, {}, LinkCondition::kPermissive).ok());
    Theirs collapsed = theirs;
    collapsed.collapse(theirs_of(theirs, mesh, h));
    expect_same(ours, collapsed);
  }
}

TEST(OpenMeshCollapse, DecidesAndLeavesTheSameOfTriangles) {
  Tally tally;
  for_each_mesh([&](const Mesh& mesh) {
    if (is_triangle_mesh(mesh)) compare_collapses<Triangles>(mesh, tally);
  });
  EXPECT_GT(tally["done"], 1000);
  EXPECT_GT(tally["refused by both"], 300);
  EXPECT_EQ(tally.size(), 2U) << "no difference";
}

TEST(OpenMeshCollapse, OfPolygonsOverlooksAFaceThatHasBothEnds) {
  Tally tally;
  for_each_mesh([&](const Mesh& mesh) { compare_collapses<AnyPolygons>(mesh, tally); });
  EXPECT_GT(tally["done"], 1000);
  EXPECT_GT(tally["refused by both"], 300);
  EXPECT_GT(tally["repeated-vertex"], 0);
  EXPECT_EQ(tally.size(), 3U);
}

TEST(OpenMeshFlip, DecidesAndLeavesTheSame) {
  int done = 0;
  int refused = 0;
  for_each_mesh([&](const Mesh& mesh) {
    if (!is_triangle_mesh(mesh)) return;
    const Triangles theirs = mirror<Triangles>(mesh);
    for (const Edge e : mesh.edges()) {
      const Halfedge h = mesh.edge_halfedge(e);
      const OpenMesh::EdgeHandle their_e = theirs.edge_handle(theirs_of(theirs, mesh, h));
      Mesh ours = copy_of(mesh);
      const bool is_flipped = operations::flip_edge(ours, e).ok();
      ASSERT_EQ(is_flipped, theirs.is_flip_ok(their_e));
      ++(is_flipped ? done : refused);
      if (!is_flipped) continue;
      Triangles flipped = theirs;
      flipped.flip(their_e);
      expect_same(ours, flipped);
    }
  });
  EXPECT_GT(done, 500);
  EXPECT_GT(refused, 100);
}

TEST(OpenMeshSplit, LeavesTheSameOfTriangles) {
  int done = 0;
  for_each_mesh([&](const Mesh& mesh) {
    if (!is_triangle_mesh(mesh)) return;
    const Triangles theirs = mirror<Triangles>(mesh);
    for (const Edge e : mesh.edges()) {
      Mesh ours = copy_of(mesh);
      if (!operations::split_edge(ours, e).ok()) continue;  // pillows, of which it makes none
      ++done;
      Triangles split = theirs;
      const auto w = split.add_vertex({0, 0, 0});
      split.split(split.edge_handle(theirs_of(theirs, mesh, mesh.edge_halfedge(e))), w);
      expect_same(ours, split);
    }
  });
  EXPECT_GT(done, 500);
}

TEST(OpenMeshVertexSplit, LeavesTheSameInsideOfTriangles) {
  int done = 0;
  for_each_mesh([&](const Mesh& mesh) {
    if (!is_triangle_mesh(mesh) || mesh.face_count() > 50) return;  // quadratic
    const Triangles theirs = mirror<Triangles>(mesh);
    for (const Halfedge hl : mesh.halfedges()) {
      const Vertex v = mesh.from_vertex(hl);
      if (mesh.is_boundary(v)) continue;  // it takes the boundary for one of the sides
      for (const Halfedge hr : mesh.outgoing_cw(v)) {
        if (hr == hl) continue;
        ++done;
        Mesh ours = copy_of(mesh);
        ASSERT_TRUE(operations::split_vertex(ours, hl, hr).ok());
        Triangles split = theirs;
        const auto w = split.add_vertex({0, 0, 0});
        const auto end = [&](Halfedge h) {
          return OpenMesh::VertexHandle(int(mesh.to_vertex(h).index()));
        };
        split.vertex_split(w, OpenMesh::VertexHandle(int(v.index())), end(hl), end(hr));
        expect_same(ours, split);
      }
    }
  });
  EXPECT_GT(done, 1000);
}

}  // namespace
}  // namespace halfedge::test
