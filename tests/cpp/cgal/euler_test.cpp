// The operations on faces beside CGAL's Euler functions on its Surface_mesh, item by item of many
// meshes: what both do is the same; where they do more, it leaves no mesh.

// CGAL before ours: its templates call a function `halfedge`, and must not find our namespace.
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <gtest/gtest.h>
#include <halfedge/operations/add_face.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/dissolve.h>
#include <halfedge/operations/holes.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/split_face.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cgal/surface_mesh.h"

namespace halfedge::test {
namespace {

template <class Each>
void for_each_mesh(const Each& each) {
  for (auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    each(std::as_const(mesh));
  }
}

TEST(CgalEuler, SplitsFacesAlikeButJoinsVerticesTwice) {
  int done = 0;
  int twice = 0;
  for_each_mesh([&](const Mesh& mesh) {
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.is_boundary(h)) continue;
      for (const Halfedge g : mesh.loop_ccw(h)) {
        if (g == h || mesh.next(h) == g || mesh.next(g) == h) continue;
        Mesh ours = copy_of(mesh);
        Theirs theirs = mirror(mesh);
        const Result<Edge> edge = operations::insert_edge(ours, h, g);
        const TheirHalfedge d = Euler::split_face(theirs_of(h), theirs_of(g), theirs);
        if (edge) {
          ++done;
          expect_same(ours, theirs);
          EXPECT_EQ(edge.value().index(), Index(theirs.edge(d)));
          EXPECT_EQ(ours.face(ours.edge_halfedge(edge.value())).index(), Index(theirs.face(d)));
          continue;
        }
        ++twice;
        EXPECT_EQ(edge.error().code, "edge-exists");
        expect_no_mesh(theirs);
      }
    }
  });
  EXPECT_GT(done, 100);
  EXPECT_GT(twice, 0);
}

TEST(CgalEuler, JoinsFacesAlikeButSomeThatLeaveNoMesh) {
  int done = 0;
  std::map<std::string_view, int> refused;
  for_each_mesh([&](const Mesh& mesh) {
    for (const Edge e : mesh.edges()) {
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      Halfedge h = mesh.edge_halfedge(e);
      if (mesh.is_boundary(mesh.opposite(h))) h = mesh.opposite(h);
      const Result<Face> joined = operations::remove_edge(ours, e);
      Euler::join_face(theirs_of(h), theirs);
      if (joined) {
        ++done;
        expect_same(ours, theirs);
      } else {
        ++refused[joined.error().code];
        expect_no_mesh(theirs);
      }
    }
  });
  EXPECT_GT(done, 100);
  EXPECT_EQ(refused.size(), 3U);  // edge-without-face, faces-share-edges, faces-share-vertex
}

TEST(CgalEuler, AddsAndRemovesCentersAlike) {
  int done = 0;
  for_each_mesh([&](const Mesh& mesh) {
    for (const Face f : mesh.faces()) {
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      ASSERT_TRUE(operations::split_face(ours, f));
      (void)Euler::add_center_vertex(theirs_of(mesh.face_halfedge(f)), theirs);
      expect_same(ours, theirs);
    }
    for (const Vertex v : mesh.vertices()) {
      if (mesh.is_boundary(v)) continue;
      Mesh ours = copy_of(mesh);
      if (!operations::dissolve_vertex(ours, v)) continue;
      ++done;
      Theirs theirs = mirror(mesh);
      const Halfedge in = mesh.opposite(mesh.vertex_halfedge(v));
      (void)Euler::remove_center_vertex(theirs_of(in), theirs);
      expect_same(ours, theirs);
    }
  });
  EXPECT_GT(done, 50);
}

TEST(CgalEuler, MakesAndFillsHolesAlikeButThoseThatPassAVertexTwice) {
  int made = 0;
  int filled = 0;
  int refused = 0;
  for_each_mesh([&](const Mesh& mesh) {
    for (const Face f : mesh.faces()) {
      Mesh ours = copy_of(mesh);
      const Result<Halfedge> hole = operations::make_hole(ours, f);
      if (!hole) continue;
      ++made;
      Theirs theirs = mirror(mesh);
      Euler::make_hole(theirs_of(mesh.face_halfedge(f)), theirs);
      expect_same(ours, theirs);
    }
    for (const Halfedge h : mesh.halfedges()) {
      if (!mesh.is_boundary(h)) continue;
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      const Result<Face> face = operations::fill_hole(ours, h);
      Euler::fill_hole(theirs_of(h), theirs);
      if (face) {
        ++filled;
        expect_same(ours, theirs);
      } else {
        ++refused;
        EXPECT_EQ(face.error().code, "repeated-vertex");
        expect_no_mesh(theirs);
      }
    }
  });
  EXPECT_GT(made, 100);
  EXPECT_GT(filled, 100);
  EXPECT_GT(refused, 0);
}

TEST(CgalEuler, RemovesFacesAlike) {
  for_each_mesh([&](const Mesh& mesh) {
    for (const Face f : mesh.faces()) {
      SCOPED_TRACE(f.index());
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      ASSERT_TRUE(operations::delete_face(ours, f));
      Euler::remove_face(theirs_of(mesh.face_halfedge(f)), theirs);
      expect_same(ours, theirs);
    }
  });
}

/// Corners along edges of the mesh as a rule, so that much can go wrong.
std::vector<Vertex> random_corners(const Mesh& mesh, std::mt19937& random) {
  const auto below = [&](Index count) { return Index(random() % count); };
  std::vector<Vertex> corners;
  Vertex v(below(mesh.vertex_slots()));
  for (Index degree = 3 + below(3); degree > 0; --degree) {
    corners.push_back(v);
    Halfedge out = mesh.vertex_halfedge(v);
    if (out.valid() && below(4) > 0) {
      for (Index turns = below(4); turns > 0; --turns) out = mesh.rotate_cw(out);
      v = mesh.to_vertex(out);
    } else {
      v = Vertex(below(mesh.vertex_slots()));
    }
  }
  return corners;
}

std::vector<TheirVertex> theirs_of(const std::vector<Vertex>& corners) {
  std::vector<TheirVertex> theirs;
  for (const Vertex v : corners) theirs.push_back(TheirVertex(v.index()));
  return theirs;
}

/// Whether rotating around each vertex reaches all that lead there.
bool all_are_reached(const Theirs& mesh) {
  std::size_t reached = 0;
  for (const TheirVertex v : mesh.vertices()) {
    if (mesh.halfedge(v) != Theirs::null_halfedge()) reached += mesh.degree(v);
  }
  return reached == mesh.number_of_halfedges();
}

// They differ in one thing. A face that would close one of several fans of a vertex, after which no
// rotation reaches the others, is refused by us; can_add_face allows it, add_face now refuses it,
// now does it.
TEST(CgalEuler, AddsFacesAlike) {
  int added = 0;
  int unreachable = 0;
  int promised = 0;
  std::uint32_t seed = 0;
  for_each_mesh([&](const Mesh& mesh) {
    if (mesh.vertex_slots() == 0) return;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed++);
    for (int i = 0; i < 200; ++i) {
      const std::vector<Vertex> corners = random_corners(mesh, random);
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      const bool can = Euler::can_add_face(theirs_of(corners), theirs);
      const Result<Face> face = operations::add_face(ours, corners);
      const TheirFace their_face = Euler::add_face(theirs_of(corners), theirs);
      if (face) {
        ++added;
        EXPECT_TRUE(can);
        expect_same(ours, theirs);
        EXPECT_TRUE(all_are_reached(theirs));
      } else if (their_face != Theirs::null_face()) {
        ++unreachable;
        EXPECT_EQ(face.error().code, "pinched-vertex");
        EXPECT_FALSE(all_are_reached(theirs));
      } else {
        promised += can ? 1 : 0;
      }
    }
  });
  EXPECT_GT(added, 200);
  EXPECT_GT(unreachable, 10);
  EXPECT_GT(promised, 0);
}

TEST(CgalEuler, AddsTheFacesOfAMeshInAnyOrder) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Shape shape = random_polygons(seed);
    SCOPED_TRACE(shape.name);
    std::mt19937 random(seed);
    std::shuffle(shape.faces.begin(), shape.faces.end(), random);
    Mesh ours;
    Theirs theirs;
    for (Index v = 0; v < shape.vertices; ++v) {
      (void)ours.add_vertex({});
      theirs.add_vertex();
    }
    for (const std::vector<Index>& face : shape.faces) {
      std::vector<Vertex> corners;
      for (const Index v : face) corners.push_back(Vertex(v));
      ASSERT_TRUE(operations::add_face(ours, corners));
      ASSERT_NE(Euler::add_face(theirs_of(corners), theirs), Theirs::null_face());
    }
    expect_same(ours, theirs);
  }
}

}  // namespace
}  // namespace halfedge::test
