// Loops split and joined beside CGAL's Euler functions on its Surface_mesh.

// CGAL before ours: its templates call a function `halfedge`, and must not find our namespace.
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <gtest/gtest.h>
#include <halfedge/operations/loops.h>

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cgal/surface_mesh.h"

namespace halfedge::test {
namespace {

// All cycles of three edges, with six different faces beside them, as CGAL wants.
std::vector<std::array<Halfedge, 3>> cycles_of(const Mesh& mesh) {
  std::vector<std::array<Halfedge, 3>> all;
  for (const Halfedge h : mesh.halfedges()) {
    for (const Halfedge i : mesh.outgoing_cw(mesh.to_vertex(h))) {
      if (mesh.to_vertex(i) == mesh.from_vertex(h)) continue;
      const Halfedge j = mesh.find_halfedge(mesh.to_vertex(i), mesh.from_vertex(h));
      if (!j.valid()) continue;
      std::set<Face> faces;
      for (const Halfedge on_cycle : {h, i, j}) {
        for (const Halfedge side : {on_cycle, Mesh::opposite(on_cycle)}) {
          if (!mesh.is_boundary(side)) faces.insert(mesh.face(side));
        }
      }
      if (faces.size() == 6) all.push_back({h, i, j});
    }
  }
  return all;
}

// Euler::split_loop and Euler::join_loop leave some vertices and faces a halfedge that isn't theirs
// any more.
void mend(Theirs& mesh) {
  for (const TheirHalfedge h : mesh.halfedges()) {
    mesh.set_halfedge(mesh.target(h), h);
    if (!mesh.is_border(h)) mesh.set_halfedge(mesh.face(h), h);
  }
}

TEST(CgalLoops, SplitsAndJoinsLoopsAlike) {
  int count = 0;
  std::vector<std::pair<std::string, Mesh>> meshes = meshes_to_sweep();
  meshes.emplace_back("torus 5 x 3", reference_build(torus(5, 3)));
  for (const auto& [name, mesh] : meshes) {
    SCOPED_TRACE(name);
    for (const auto& cycle : cycles_of(mesh)) {
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      const Result<Halfedge> cap = operations::split_loop(ours, cycle);
      const TheirHalfedge their_cap =
          Euler::split_loop(theirs_of(cycle[0]), theirs_of(cycle[1]), theirs_of(cycle[2]), theirs);
      mend(theirs);
      ASSERT_TRUE(cap.ok());
      ++count;
      EXPECT_EQ(ours.face_count(), theirs.number_of_faces());
      EXPECT_EQ(ours.edge_count(), theirs.number_of_edges());
      EXPECT_EQ(ours.vertex_count(), theirs.number_of_vertices());
      EXPECT_TRUE(theirs.is_valid(false));
      // They may have copied the other side of the cycle: joined again, it is the same mesh.
      ASSERT_TRUE(operations::join_loop(ours, cycle[0], cap.value()).ok());
      Euler::join_loop(theirs_of(cycle[0]), their_cap, theirs);
      EXPECT_EQ(ours.edge_count(), theirs.number_of_edges());
      EXPECT_EQ(polys_of(ours), polys_of(mesh));
      mend(theirs);
      expect_same(ours, theirs);
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(count, 20);
}

// join_loop of CGAL asserts where an edge of the loops has no face on its other side.
bool is_inside(const Mesh& mesh, Halfedge h) {
  for (const Halfedge on_loop : mesh.loop_ccw(h)) {
    if (mesh.is_boundary(Mesh::opposite(on_loop))) return false;
  }
  return true;
}

TEST(CgalLoops, JoinsFacesAlike) {
  int done = 0;
  for (const auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const Face a : mesh.faces()) {
      for (const Face b : mesh.faces()) {
        const Halfedge h = mesh.face_halfedge(a);
        const Halfedge g = mesh.face_halfedge(b);
        Mesh ours = copy_of(mesh);
        if (a.index() % 3 != 0 || !is_inside(mesh, h) || !is_inside(mesh, g)) continue;
        if (!operations::join_loop(ours, h, g).ok()) continue;
        Theirs theirs = mirror(mesh);
        Euler::join_loop(theirs_of(h), theirs_of(g), theirs);
        mend(theirs);
        ++done;
        expect_same(ours, theirs);
        ASSERT_FALSE(HasFailure());
      }
    }
  }
  EXPECT_GT(done, 20);
}

}  // namespace
}  // namespace halfedge::test
