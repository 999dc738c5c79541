#pragma once

#include <gtest/gtest.h>
#include <halfedge/mesh.h>

#include <algorithm>

namespace halfedge::test {

/// Whether two ranges, of whichever types, have the same elements in the same order.
inline bool same(const auto& a, const auto& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// The links and positions of a mesh that may store no prev are those of one that does; prev itself
/// is not looked at.
inline void expect_same_but_prev(const Mesh& mesh, const auto& other) {
  EXPECT_TRUE(same(mesh.links().next, other.links().next));
  EXPECT_TRUE(same(mesh.links().to_vertex, other.links().to_vertex));
  EXPECT_TRUE(same(mesh.links().face, other.links().face));
  EXPECT_TRUE(same(mesh.links().vertex_halfedge, other.links().vertex_halfedge));
  EXPECT_TRUE(same(mesh.links().face_halfedge, other.links().face_halfedge));
  EXPECT_TRUE(same(mesh.positions(), other.positions()));
}

}  // namespace halfedge::test
