#pragma once

// CGAL before ours: its templates call a function `halfedge`, and must not find our namespace.
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <gtest/gtest.h>
#include <halfedge/mesh.h>

#include <utility>

#include "support/sweep.h"

/// Our meshes as CGAL's Surface_mesh.
namespace halfedge::test {

using Theirs = CGAL::Surface_mesh<int>;
using TheirVertex = Theirs::Vertex_index;
using TheirHalfedge = Theirs::Halfedge_index;
using TheirFace = Theirs::Face_index;
namespace Euler = CGAL::Euler;

inline TheirHalfedge theirs_of(Halfedge h) { return TheirHalfedge(h.index()); }

/// The same mesh, item by item, all of its vertices at one place. pre: no slot of `mesh` is deleted
template <class Surface = Theirs>
Surface mirror(const Mesh& mesh) {
  Surface theirs;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) theirs.add_vertex();
  for (Index e = 0; e < mesh.edge_slots(); ++e) theirs.add_edge();
  for (Index f = 0; f < mesh.face_slots(); ++f) theirs.add_face();
  for (const Halfedge h : mesh.halfedges()) {
    theirs.set_target(theirs_of(h), TheirVertex(mesh.to_vertex(h).index()));
    theirs.set_next(theirs_of(h), theirs_of(mesh.next(h)));
    if (!mesh.is_boundary(h)) theirs.set_face(theirs_of(h), TheirFace(mesh.face(h).index()));
  }
  for (const Vertex v : mesh.vertices()) {
    if (mesh.is_isolated(v)) continue;
    theirs.set_halfedge(TheirVertex(v.index()), theirs_of(mesh.prev(mesh.vertex_halfedge(v))));
  }
  for (const Face f : mesh.faces()) {
    theirs.set_halfedge(TheirFace(f.index()), theirs_of(mesh.face_halfedge(f)));
  }
  return theirs;
}

inline Polys polys_of(const Theirs& mesh) {
  Polys faces;
  for (const TheirFace f : mesh.faces()) {
    faces.emplace_back();
    for (const TheirVertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      faces.back().push_back(Index(v));
    }
  }
  return in_order(std::move(faces));
}

inline void expect_same(const Mesh& ours, const Theirs& theirs) {
  EXPECT_EQ(polys_of(ours), polys_of(theirs));
  EXPECT_EQ(ours.edge_count(), theirs.number_of_edges());
  EXPECT_EQ(ours.vertex_count(), theirs.number_of_vertices());
  EXPECT_TRUE(theirs.is_valid(false));
}

/// That the faces of `theirs` aren't those of a polygon mesh with its edges: what we refuse.
inline void expect_no_mesh(const Theirs& theirs) {
  EXPECT_NE(buildable(Index(theirs.number_of_vertices()), polys_of(theirs)),
            theirs.number_of_edges());
}

}  // namespace halfedge::test
