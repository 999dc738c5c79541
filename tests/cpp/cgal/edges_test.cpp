// Edges collapsed, flipped and split, and vertices split, beside CGAL's Euler functions on its
// Surface_mesh: what both do is the same; where they do more, it leaves no mesh.

// CGAL before ours: its templates call a function `halfedge`, and must not find our namespace.
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <gtest/gtest.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/flip.h>
#include <halfedge/operations/split_edge.h>
#include <halfedge/operations/split_vertex.h>

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "cgal/surface_mesh.h"

namespace halfedge::test {
namespace {

bool is_triangle_mesh(const Mesh& mesh) {
  for (const Face f : mesh.faces()) {
    if (mesh.degree(f) != 3) return false;
  }
  return true;
}

/// The meshes to sweep of triangles, and the others with their faces split at the centres.
template <class Each>
void for_each_triangle_mesh(const Each& each) {
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    Mesh triangles = copy_of(mesh);
    if (!is_triangle_mesh(mesh)) {
      for (const Face f : mesh.faces()) {
        ASSERT_TRUE(decorator::create_center_vertex(triangles, mesh.face_halfedge(f)).ok());
      }
    }
    each(std::as_const(triangles));
  }
}

TEST(CgalCollapse, HasTheSameLinkCondition) {
  int allowed = 0;
  int refused = 0;
  for_each_triangle_mesh([&](const Mesh& mesh) {
    const Theirs theirs = mirror(mesh);
    for (const Edge e : mesh.edges()) {
      const bool is_allowed = Euler::does_satisfy_link_condition(
          Theirs::Edge_index(theirs_of(mesh.edge_halfedge(e))), theirs);
      for (const Index side : {0U, 1U}) {
        EXPECT_EQ(operations::is_collapse_ok(mesh, mesh.edge_halfedge(e, side)), is_allowed);
      }
      ++(is_allowed ? allowed : refused);
    }
  });
  EXPECT_GT(allowed, 500);
  EXPECT_GT(refused, 50);
}

TEST(CgalCollapse, LeavesTheSame) {
  int done = 0;
  for_each_triangle_mesh([&](const Mesh& mesh) {
    for (const Halfedge h : mesh.halfedges()) {
      Theirs theirs = mirror(mesh);
      const TheirVertex kept_by_them = [&] {
        if (!operations::is_collapse_ok(mesh, h)) return TheirVertex();
        return Euler::collapse_edge(Theirs::Edge_index(theirs_of(h)), theirs);
      }();
      if (kept_by_them == TheirVertex()) continue;
      ++done;
      // Which end stays is theirs to choose at the boundary, and that of the edge's side 0 inside.
      const bool is_other = Index(kept_by_them) != mesh.to_vertex(h).index();
      Mesh ours = copy_of(mesh);
      ASSERT_TRUE(operations::collapse(ours, is_other ? mesh.opposite(h) : h).ok());
      expect_same(ours, theirs);
    }
  });
  EXPECT_GT(done, 500);
}

TEST(CgalFlip, LeavesTheSameButFlipsOntoEdgesToo) {
  int done = 0;
  std::map<std::string_view, int> refused;
  for_each_triangle_mesh([&](const Mesh& mesh) {
    for (const Edge e : mesh.edges()) {
      if (mesh.is_boundary(e)) continue;  // asserted by CGAL
      const Halfedge h = mesh.edge_halfedge(e);
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      const Result<Edge> flipped = operations::flip_edge(ours, e);
      Euler::flip_edge(theirs_of(h), theirs);
      if (flipped) {
        ++done;
        expect_same(ours, theirs);
      } else {
        ++refused[flipped.error().code];
        expect_no_mesh(theirs);
      }
    }
  });
  EXPECT_GT(done, 300);
  EXPECT_EQ(refused.size(), 2U);  // edge-exists, same-vertex
}

TEST(CgalSplitVertex, LeavesTheSameWithoutTriangles) {
  using operations::SplitSide;
  const operations::SplitSides corners{SplitSide::kCorner, SplitSide::kCorner};
  int done = 0;
  std::map<std::string_view, int> refused;
  for (auto& [name, mesh] : meshes_to_sweep(2)) {
    SCOPED_TRACE(name);
    for (const Halfedge hl : mesh.halfedges()) {
      for (const Halfedge hr : mesh.outgoing_cw(mesh.from_vertex(hl))) {
        Mesh ours = copy_of(mesh);
        const Result<Vertex> w = operations::split_vertex(ours, hl, hr, {}, corners);
        if (!w && w.error().code == "nothing-between") continue;  // asserted by CGAL
        Theirs theirs = mirror(mesh);
        const TheirHalfedge up =
            Euler::split_vertex(theirs_of(mesh.opposite(hr)), theirs_of(mesh.prev(hl)), theirs);
        if (w) {
          ++done;
          expect_same(ours, theirs);
          EXPECT_EQ(Index(source(up, theirs)), w.value().index());
        } else {
          ++refused[w.error().code];
          expect_no_mesh(theirs);
        }
      }
    }
  }
  EXPECT_GT(done, 500);
  EXPECT_EQ(refused.size(), 1U);  // edge-without-face
}

TEST(CgalSplitEdge, LeavesTheSameOnBothSides) {
  for (auto& [name, mesh] : meshes_to_sweep(2)) {
    SCOPED_TRACE(name);
    for (const Edge e : mesh.edges()) {
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      const Result<Vertex> w = operations::insert_vertex_on_edge(ours, e);
      const TheirHalfedge half = Euler::split_edge(theirs_of(mesh.edge_halfedge(e)), theirs);
      ASSERT_TRUE(w.ok());
      expect_same(ours, theirs);
      EXPECT_EQ(Index(target(half, theirs)), w.value().index());
    }
  }
}

}  // namespace
}  // namespace halfedge::test
