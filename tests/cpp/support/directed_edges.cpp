#include "support/directed_edges.h"

#include <halfedge/build/build.h>
#include <halfedge/directed_edges/convert.h>
#include <halfedge/directed_edges/validate.h>

#include "support/same_but_prev.h"

namespace halfedge::test {
namespace {

using Item = std::pair<Index, Index>;

// Items by what doesn't depend on how halfedges and edges are numbered.
template <class Mesh>
Item shown(const Mesh&, Vertex v) {
  return {v.index(), 0};
}
template <class Mesh>
Item shown(const Mesh&, Face f) {
  return {f.index(), 0};
}
template <class Mesh>
Item shown(const Mesh& mesh, Halfedge h) {
  if (!h.valid()) return {kNone, kNone};
  return {mesh.from_vertex(h).index(), mesh.to_vertex(h).index()};
}
template <class Mesh>
Item shown(const Mesh& mesh, Edge e) {
  const Item ends = shown(mesh, mesh.edge_halfedge(e, 0));
  return std::minmax(ends.first, ends.second);
}

using Items = std::vector<Item>;

template <class Mesh, class Range>
Items items(const Mesh& mesh, const Range& range) {
  Items list;
  for (const auto item : range) list.push_back(shown(mesh, item));
  return list;
}

// Which of its halfedges is side 0 of an edge is a matter of numbering.
Items sorted(Items list) {
  std::sort(list.begin(), list.end());
  return list;
}

template <class Mesh>
std::vector<Items> around(const Mesh& mesh, Vertex v) {
  std::vector<Items> lists = {
      items(mesh, mesh.outgoing_cw(v)),        items(mesh, mesh.outgoing_ccw(v)),
      items(mesh, mesh.incoming_cw(v)),        items(mesh, mesh.incoming_ccw(v)),
      items(mesh, mesh.vertex_vertices_cw(v)), items(mesh, mesh.vertex_vertices_ccw(v)),
      items(mesh, mesh.vertex_edges_cw(v)),    items(mesh, mesh.vertex_edges_ccw(v)),
      items(mesh, mesh.vertex_faces_cw(v)),    items(mesh, mesh.vertex_faces_ccw(v))};
  if (mesh.is_isolated(v)) return lists;
  const Halfedge start = mesh.rotate_cw(mesh.vertex_halfedge(v));
  lists.push_back(items(mesh, mesh.outgoing_cw(v, start)));
  lists.push_back(items(mesh, mesh.vertex_faces_ccw(v, start)));
  lists.push_back({{mesh.valence(v), mesh.is_boundary(v)}, {mesh.is_manifold(v), 0}});
  return lists;
}

template <class Mesh>
std::vector<Items> around(const Mesh& mesh, Face f) {
  const Halfedge start = mesh.next(mesh.face_halfedge(f));
  return {items(mesh, mesh.face_halfedges_ccw(f)),      items(mesh, mesh.face_halfedges_cw(f)),
          items(mesh, mesh.face_vertices_ccw(f)),       items(mesh, mesh.face_vertices_cw(f)),
          items(mesh, mesh.face_edges_ccw(f)),          items(mesh, mesh.face_edges_cw(f)),
          items(mesh, mesh.face_faces_ccw(f)),          items(mesh, mesh.face_faces_cw(f)),
          items(mesh, mesh.face_vertices_cw(f, start)), {{mesh.degree(f), mesh.is_boundary(f)}}};
}

template <class Mesh>
std::vector<Items> at(const Mesh& mesh, Halfedge h) {
  const Edge e = mesh.edge(h);
  return {items(mesh, mesh.loop_ccw(h)),
          items(mesh, mesh.loop_cw(h)),
          sorted(items(mesh, mesh.edge_halfedges(e))),
          sorted(items(mesh, mesh.edge_vertices(e))),
          sorted(items(mesh, mesh.edge_faces(e))),
          {shown(mesh, mesh.opposite(h)), shown(mesh, mesh.next_on_vertex(h)),
           shown(mesh, mesh.prev_on_vertex(h)), shown(mesh, mesh.rotate_ccw(h)),
           shown(mesh, mesh.face(h)), shown(mesh, e)},
          {{mesh.is_boundary(h), mesh.is_boundary(e)}}};
}

template <class Mesh>
std::vector<Item> all_edges(const Mesh& mesh) {
  return sorted(items(mesh, mesh.edges()));
}

}  // namespace

void expect_same(const DirectedEdgesMesh& compact, const Mesh& full) {
  ASSERT_EQ(compact.vertex_count(), full.vertex_count());
  ASSERT_EQ(compact.halfedge_count(), full.halfedge_count());
  ASSERT_EQ(compact.edge_count(), full.edge_count());
  ASSERT_EQ(compact.face_count(), full.face_count());
  ASSERT_TRUE(same(compact.positions(), full.positions()));
  ASSERT_EQ(all_edges(compact), all_edges(full));
  for (const Vertex v : full.vertices()) {
    ASSERT_EQ(around(compact, v), around(full, v)) << "vertex " << v.index();
  }
  for (const Face f : full.faces()) {
    ASSERT_EQ(around(compact, f), around(full, f)) << "face " << f.index();
  }
  for (const Halfedge h : compact.halfedges()) {
    const Halfedge other = full.find_halfedge(compact.from_vertex(h), compact.to_vertex(h));
    ASSERT_TRUE(other.valid());
    ASSERT_EQ(compact.find_halfedge(compact.from_vertex(h), compact.to_vertex(h)), h);
    ASSERT_EQ(at(compact, h), at(full, other)) << "halfedge " << h.index();
  }
}

void expect_same_links(const DirectedEdges& a, const DirectedEdges& b) {
  EXPECT_EQ(a.links().sides, b.links().sides);
  EXPECT_TRUE(same(a.links().opposite, b.links().opposite));
  EXPECT_TRUE(same(a.links().to_vertex, b.links().to_vertex));
  EXPECT_TRUE(same(a.links().boundary_next, b.links().boundary_next));
  EXPECT_TRUE(same(a.links().boundary_prev, b.links().boundary_prev));
  EXPECT_TRUE(same(a.links().vertex_halfedge, b.links().vertex_halfedge));
}

std::string first_problem(const std::vector<Problem>& problems) {
  return has_errors(problems) ? problems.front().message : "";
}

void expect_equivalent(const Polygons& triangles) {
  BuildReport report;
  Mesh full;
  ASSERT_TRUE(build_from_polygons(full, triangles, report)) << report.problems[0].message;
  DirectedEdgesMesh compact;
  ASSERT_TRUE(build_from_triangles(compact, triangles, report)) << report.problems[0].message;
  EXPECT_EQ(first_problem(validate(compact)), "");
  expect_same(compact, full);

  Mesh converted;
  ASSERT_TRUE(to_mesh(compact, converted));
  EXPECT_EQ(first_problem(validate(converted)), "");
  expect_same_but_prev(converted, full);
  EXPECT_TRUE(same(converted.links().prev, full.links().prev));

  DirectedEdgesMesh back;
  const Result<void> result = from_mesh(full, back);
  ASSERT_TRUE(result) << result.error().message;
  expect_same_links(back, compact);
  EXPECT_TRUE(same(back.positions(), compact.positions()));
}

}  // namespace halfedge::test
