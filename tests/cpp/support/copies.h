#pragma once

#include <gtest/gtest.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/mesh.h>

#include "support/operations.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {

/// A mesh with deleted slots of all kinds in between: some faces and edges are joined away.
inline Mesh with_gaps(const Shape& shape, std::uint32_t seed) {
  Mesh mesh = reference_build(shape);
  RandomCalls random(seed, 30);
  for (int i = 0; i < 60; ++i) (void)apply(mesh, random.next(mesh));
  const Vertex lost = mesh.new_vertex();
  (void)mesh.new_vertex();
  mesh.release(lost);
  return mesh;
}

/// That all live items of `other` have a copy where the maps say, with the same links and
/// positions.
template <class Copy, class Other>
void expect_copy(const Copy& mesh, const Other& other, const CompactMaps& maps) {
  for (const Vertex v : other.vertices()) {
    const Halfedge anchor = other.vertex_halfedge(v);
    ASSERT_EQ(mesh.vertex_halfedge(maps(v)), anchor.valid() ? maps(anchor) : Halfedge{});
    ASSERT_EQ(mesh.position(maps(v)), other.position(v));
  }
  for (const Halfedge h : other.halfedges()) {
    ASSERT_EQ(mesh.next(maps(h)), maps(other.next(h)));
    ASSERT_EQ(mesh.prev(maps(h)), maps(other.prev(h)));
    ASSERT_EQ(mesh.to_vertex(maps(h)), maps(other.to_vertex(h)));
    ASSERT_EQ(mesh.face(maps(h)), other.is_boundary(h) ? Face{} : maps(other.face(h)));
    ASSERT_EQ(mesh.opposite(maps(h)), maps(other.opposite(h)));
  }
  for (const Face f : other.faces()) {
    ASSERT_EQ(mesh.face_halfedge(maps(f)), maps(other.face_halfedge(f)));
  }
}

}  // namespace halfedge::test
