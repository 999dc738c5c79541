#pragma once

#include <gtest/gtest.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace halfedge::test {

/// A halfedge by its ends, which doesn't depend on how edges are numbered.
using Ends = std::pair<Index, Index>;

inline Ends ends_of(const Mesh& mesh, Halfedge h) {
  if (!h.valid()) return {kNone, kNone};
  return {mesh.from_vertex(h).index(), mesh.to_vertex(h).index()};
}

/// A mesh, except for the numbering of its edges: two meshes are the same if these are equal.
struct Canonical {
  struct Side {
    Ends ends;
    Ends next;
    Ends prev;
    Index face = kNone;

    friend bool operator==(const Side&, const Side&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Side& side) {
      return out << side.ends.first << ">" << side.ends.second << " face " << int(side.face)
                 << " next " << side.next.first << ">" << side.next.second;
    }
  };

  std::vector<Side> sides;    // by their ends
  std::vector<Ends> anchors;  // by vertex
  std::vector<Ends> firsts;   // by face
  std::vector<Point> positions;

  explicit Canonical(const Mesh& mesh) {
    for (const Halfedge h : mesh.halfedges()) {
      sides.push_back({ends_of(mesh, h), ends_of(mesh, mesh.next(h)), ends_of(mesh, mesh.prev(h)),
                       mesh.face(h).index()});
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.ends < b.ends; });
    for (const Vertex v : mesh.vertices()) {
      anchors.push_back(ends_of(mesh, mesh.vertex_halfedge(v)));
      positions.push_back(mesh.position(v));
    }
    for (const Face f : mesh.faces()) firsts.push_back(ends_of(mesh, mesh.face_halfedge(f)));
  }
};

inline void expect_same(const Mesh& mesh, const Mesh& expected, const std::string& name) {
  const Canonical a(mesh);
  const Canonical b(expected);
  EXPECT_EQ(a.sides, b.sides) << name;
  EXPECT_EQ(a.anchors, b.anchors) << name;
  EXPECT_EQ(a.firsts, b.firsts) << name;
  EXPECT_EQ(a.positions, b.positions) << name;
}

}  // namespace halfedge::test
