#pragma once

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/mesh.h>

#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <vector>

/// What must come out where a mesh is cut along a set of edges, told corner by corner.
namespace halfedge::test {

/// The halfedges of each face, by the index of the face.
inline std::map<Index, std::vector<Halfedge>> loops_of(const Mesh& mesh) {
  std::map<Index, std::vector<Halfedge>> loops;
  for (const Face f : mesh.faces()) {
    for (const Halfedge h : mesh.loop_ccw(mesh.face_halfedge(f))) loops[f.index()].push_back(h);
  }
  return loops;
}

/// By halfedge with a face, which stands for the corner where it ends: the same number for the
/// corners at a vertex that hang together across edges that aren't cut.
inline std::vector<Index> fans_without(const Mesh& mesh, const std::set<Edge>& cut) {
  std::vector<Index> fan(mesh.halfedge_slots());
  std::iota(fan.begin(), fan.end(), Index{0});
  const auto find = [&](Index at) {
    while (fan[at] != at) at = fan[at];
    return at;
  };
  std::map<Halfedge, Halfedge> before;
  for (const auto& [f, loop] : loops_of(mesh)) {
    for (std::size_t i = 0; i < loop.size(); ++i) before[loop[(i + 1) % loop.size()]] = loop[i];
  }
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e, 0);
    const Halfedge o = mesh.edge_halfedge(e, 1);
    if (cut.count(e) > 0 || before.count(h) == 0 || before.count(o) == 0) continue;
    fan[find(h.index())] = find(before[o].index());
    fan[find(o.index())] = find(before[h].index());
  }
  for (Index& at : fan) at = find(at);
  return fan;
}

/// The code that cut_edges must return, or "done".
inline std::string_view expected_code(const Mesh& mesh, const std::vector<Edge>& edges) {
  for (const Edge e : edges) {
    if (!mesh.is_live(e)) return "not-an-edge";
    const Halfedge h = mesh.edge_halfedge(e);
    if (mesh.from_vertex(h) == mesh.to_vertex(h)) return "loop-edge";
    if (mesh.is_boundary(e)) return "boundary-edge";
  }
  const std::set<Edge> cut(edges.begin(), edges.end());
  if (cut.size() < edges.size()) return "repeated-edge";
  const std::vector<Index> fans = fans_without(mesh, cut);
  for (const Edge e : edges) {  // with the same fans on both sides, two would join two vertices
    const Halfedge h = mesh.edge_halfedge(e, 0);
    const Halfedge o = mesh.edge_halfedge(e, 1);
    if (fans[h.index()] == fans[mesh.prev(o).index()] &&
        fans[o.index()] == fans[mesh.prev(h).index()]) {
      return "no-boundary-end";
    }
  }
  return "done";
}

/// By vertex of the mesh that was cut: the one that it was.
using Origins = std::map<Index, Index>;

/// That `after` is `before`, cut along these edges: each fan of corners is a vertex, except that at
/// a pinched vertex one part of each of its fans stays there; an edge is shared unless it was cut.
inline Origins expect_is_cut(const Mesh& before, const Mesh& after, const std::set<Edge>& cut) {
  const std::vector<Index> parts = fans_without(before, cut);
  const std::vector<Index> fans = fans_without(before, {});
  const std::map<Index, std::vector<Halfedge>> loops = loops_of(before);
  const std::map<Index, std::vector<Halfedge>> loops_after = loops_of(after);
  EXPECT_EQ(loops.size(), loops_after.size());

  Origins origins;
  std::map<Index, Index> vertex_of;               // by part
  std::map<Index, std::multiset<Index>> fans_at;  // by vertex: the fans that its parts are of
  std::map<Index, std::set<Index>> fans_before;   // by vertex as it was
  std::map<Index, std::set<Index>> parts_before;
  for (const auto& [f, loop] : loops) {
    const auto found = loops_after.find(f);
    if (found == loops_after.end() || found->second.size() != loop.size()) {
      ADD_FAILURE() << "face " << f << " has changed";
      return origins;
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Halfedge h = loop[i];
      const Halfedge h_after = found->second[i];
      const Vertex v = before.to_vertex(h);
      const Vertex w = after.to_vertex(h_after);
      const Index part = parts[h.index()];
      const auto [vertex, is_new] = vertex_of.emplace(part, w.index());
      EXPECT_EQ(vertex->second, w.index()) << "one part of a fan has two vertices";
      if (is_new) fans_at[w.index()].insert(fans[h.index()]);
      EXPECT_EQ(origins.emplace(w.index(), v.index()).first->second, v.index());
      fans_before[v.index()].insert(fans[h.index()]);
      parts_before[v.index()].insert(part);
      EXPECT_EQ(before.position(v), after.position(w));

      if (cut.count(Mesh::edge(h)) > 0) {
        EXPECT_TRUE(after.is_boundary(Mesh::opposite(h_after)));
      } else {
        EXPECT_EQ(h_after, h);
        EXPECT_EQ(after.face(Mesh::opposite(h)), before.face(Mesh::opposite(h)));
      }
    }
  }

  std::int64_t vertices = 0;
  for (const Vertex v : before.vertices()) {
    vertices += parts_before.count(v.index()) == 0
                    ? 1
                    : std::int64_t(1 + parts_before[v.index()].size()) -
                          std::int64_t(fans_before[v.index()].size());
    EXPECT_TRUE(after.is_live(v));
    EXPECT_EQ(after.is_isolated(v), before.is_isolated(v));
    EXPECT_EQ(origins.count(v.index()), parts_before.count(v.index()));
  }
  EXPECT_EQ(euler_characteristic(after), vertices - std::int64_t(before.edge_count() + cut.size()) +
                                             std::int64_t(before.face_count()));
  EXPECT_EQ(std::int64_t(after.vertex_count()), vertices);
  for (const auto& [w, at] : fans_at) {
    const std::size_t whole = fans_before[origins[w]].size();
    EXPECT_TRUE(at.size() == 1 || (at.size() == whole && origins[w] == w)) << "vertex " << w;
    EXPECT_EQ(std::set<Index>(at.begin(), at.end()).size(), at.size()) << "vertex " << w;
  }
  return origins;
}

/// That an item has the attributes of another before, or the default where the policy says so.
inline void expect_copied(const Mesh& before, const Mesh& after, ItemKind kind, Index copy,
                          Index item) {
  for (const auto& column : after.attributes().of(kind)) {
    const Attribute& old = *before.attributes().find(kind, column->name());
    const bool is_default = column->on_split() == OnSplit::kDefault && copy != item;
    for (Index i = 0; i < column->components(); ++i) {
      EXPECT_EQ(column->get(copy, i), is_default ? 0 : old.get(item, i))
          << name_of(kind) << " " << copy << ", " << column->name();
    }
  }
}

/// What cut_edges returns, and the attributes of all that is there.
inline void expect_copies(const Mesh& before, const Mesh& after, Origins origins,
                          const std::vector<Edge>& edges, const std::vector<Halfedge>& copies) {
  ASSERT_EQ(copies.size(), edges.size());
  std::set<Edge> new_edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Halfedge h = before.edge_halfedge(edges[i]);
    const Halfedge o = Mesh::opposite(h);
    const Halfedge g = copies[i];
    ASSERT_TRUE(after.is_live(g));
    EXPECT_FALSE(before.is_live(Mesh::edge(g)));
    EXPECT_TRUE(new_edges.insert(Mesh::edge(g)).second);
    EXPECT_TRUE(after.is_boundary(g) && after.is_boundary(o));
    EXPECT_EQ(after.face(h), before.face(h));
    EXPECT_EQ(after.face(Mesh::opposite(g)), before.face(o));
    EXPECT_EQ(origins[after.to_vertex(g).index()], before.to_vertex(h).index());
    EXPECT_EQ(origins[after.from_vertex(g).index()], before.from_vertex(h).index());
    expect_copied(before, after, ItemKind::kHalfedge, g.index(), h.index());
    expect_copied(before, after, ItemKind::kHalfedge, g.index() ^ 1U, o.index());
    expect_copied(before, after, ItemKind::kEdge, Mesh::edge(g).index(), edges[i].index());
  }
  for (const auto& [w, v] : origins) expect_copied(before, after, ItemKind::kVertex, w, v);
  for (const Edge e : before.edges()) {
    expect_copied(before, after, ItemKind::kEdge, e.index(), e.index());
    for (const Index side : {0U, 1U}) {
      const Index h = before.edge_halfedge(e, side).index();
      expect_copied(before, after, ItemKind::kHalfedge, h, h);
    }
  }
  for (const Face f : before.faces()) {
    expect_copied(before, after, ItemKind::kFace, f.index(), f.index());
  }
}

}  // namespace halfedge::test
