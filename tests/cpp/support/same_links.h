#pragma once

#include <gtest/gtest.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/links.h>

#include <algorithm>
#include <string>

namespace halfedge::test {

/// Whether both arrays hold the same.
inline bool same(const Array<Index>& a, const Array<Index>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// That all links are the same but `prev`, which not both need to store.
inline void expect_same_links_but_prev(const Links& a, const Links& b, const std::string& name) {
  EXPECT_TRUE(same(a.next, b.next)) << name;
  EXPECT_TRUE(same(a.to_vertex, b.to_vertex)) << name;
  EXPECT_TRUE(same(a.face, b.face)) << name;
  EXPECT_TRUE(same(a.vertex_halfedge, b.vertex_halfedge)) << name;
  EXPECT_TRUE(same(a.face_halfedge, b.face_halfedge)) << name;
}

}  // namespace halfedge::test
