#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/operations/requirements.h>
#include <halfedge/operations/surgery_refusals.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace halfedge::operations {

namespace internal {

/// The halfedges that lead to the same vertex as `in`, but for itself, lead to `v`.
template <class Mesh>
void lead_others_to(Mesh& mesh, Halfedge in, Vertex v) {
  for (Halfedge h = mesh.next_on_vertex(in); h != in; h = mesh.next_on_vertex(h)) {
    mesh.set_to_vertex(h, v);
  }
}

/// cut, of an edge inside; ends that aren't on the boundary stay one vertex, both if need be.
/// pre: there is room for two vertices and an edge
template <class Mesh>
Halfedge cut_edge(Mesh& mesh, Halfedge h) {
  using namespace steps;
  const Halfedge o = mesh.opposite(h);
  const Vertex a = mesh.from_vertex(h);
  const Vertex b = mesh.to_vertex(h);
  // Around b, clockwise from h: the last halfedge without a face, and the one before o in its face.
  Halfedge last_at_b;
  Halfedge before = h;
  while (mesh.next(before) != o) {
    before = mesh.next_on_vertex(before);
    if (mesh.is_boundary(before)) last_at_b = before;
  }
  // Around a, clockwise from o: the first without a face.
  Halfedge first_at_a = mesh.next_on_vertex(o);
  while (!mesh.is_boundary(first_at_a) && first_at_a != o) {
    first_at_a = mesh.next_on_vertex(first_at_a);
  }
  if (first_at_a == o) first_at_a = {};

  const Vertex b_copy = last_at_b.valid() ? copy_vertex(mesh, b) : b;
  const Vertex a_copy = first_at_a.valid() ? copy_vertex(mesh, a) : a;
  const Halfedge copy = new_edge_like(mesh, b_copy, a_copy, o);  // takes the place of o
  const Halfedge g = mesh.opposite(copy);
  const Face f = mesh.face(o);
  mesh.link(before, copy);
  mesh.link(copy, mesh.next(o));
  mesh.set_face(copy, f);
  mesh.set_face(o, Face{});
  replace_in_face(mesh, f, o, copy);

  // Links `in` to `out`, neither of which has a face: by way of the boundary loop of `last`, which
  // leads to the same vertex, if it isn't empty.
  const auto open_end = [&mesh](Halfedge in, Halfedge last, Halfedge out) {
    if (!last.valid()) return mesh.link(in, out);
    mesh.link(in, mesh.next(last));
    mesh.link(last, out);
  };
  open_end(g, last_at_b, o);
  mesh.set_vertex_halfedge(b, o);
  if (b_copy != b) {
    mesh.set_vertex_halfedge(b_copy, mesh.next(g));
    lead_others_to(mesh, g, b_copy);
  }
  open_end(o, first_at_a, g);
  mesh.set_vertex_halfedge(a_copy, g);  // a, if it isn't the same, keeps its anchor: along the rim
  if (a_copy != a) lead_others_to(mesh, copy, a_copy);
  return g;
}

/// Whether `h` is a live halfedge of an edge with two ends and faces on both sides.
template <class Mesh>
[[nodiscard]] Result<void> check_inner_edge(const Mesh& mesh, Halfedge h) {
  if (Result<void> live = check_live(mesh, h); !live) return live;
  if (mesh.from_vertex(h) == mesh.to_vertex(h)) {
    return refusals::is_loop_edge(h, mesh.to_vertex(h));
  }
  for (const Halfedge side : {h, mesh.opposite(h)}) {
    if (mesh.is_boundary(side)) return is_boundary_edge(mesh.edge(h), side);
  }
  return {};
}

/// An edge of a list, and where in the list it is.
struct ListedEdge {
  Edge edge = {};
  Index place = 0;
};

/// Edges to be cut, by their indices, and how many vertices that will make.
struct Cuts {
  Array<ListedEdge> edges;
  Index new_vertices = 0;
};

/// errors: those of check_cut_edges
template <class Mesh>
[[nodiscard]] Result<Cuts> plan_cuts(const Mesh& mesh, std::span<const Edge> edges) {
  Cuts cuts;
  Array<Vertex> inside;  // the ends that are, once for each of their edges
  for (const Edge e : edges) {
    if (Result<void> live = check_live(mesh, e); !live) return live;
    const Halfedge h = mesh.edge_halfedge(e);
    if (Result<void> can = check_inner_edge(mesh, h); !can) return can;
    bool fits = cuts.edges.push_back({e, Index(cuts.edges.size())});
    for (const Vertex end : {mesh.from_vertex(h), mesh.to_vertex(h)}) {
      if (mesh.is_boundary(end)) {
        ++cuts.new_vertices;
      } else {
        fits = fits && inside.push_back(end);
      }
    }
    if (!fits) return refusals::no_memory("the list of edges");
  }

  introsort(cuts.edges, [](const ListedEdge& a, const ListedEdge& b) { return a.edge < b.edge; });
  for (std::size_t i = 1; i < cuts.edges.size(); ++i) {
    if (cuts.edges[i - 1].edge == cuts.edges[i].edge) return repeated_in_list(cuts.edges[i].edge);
  }
  // A vertex inside becomes as many as it has edges to be cut, or stays one if that is one.
  introsort(inside);
  const auto stays_one = [&](Vertex v) {
    if (mesh.is_boundary(v)) return false;
    const auto first = std::lower_bound(inside.begin(), inside.end(), v);
    return first + 1 == inside.end() || first[1] != v;
  };
  for (const Edge e : edges) {
    const Vertex a = mesh.from_vertex(mesh.edge_halfedge(e));
    const Vertex b = mesh.to_vertex(mesh.edge_halfedge(e));
    if (stays_one(a) && stays_one(b)) return no_open_end(e, a, b);
  }
  for (std::size_t i = 1; i < inside.size(); ++i) {
    if (inside[i - 1] == inside[i]) ++cuts.new_vertices;
  }
  return cuts;
}

}  // namespace internal

/// Whether cut(h) can be done: else not-a-halfedge; loop-edge; boundary-edge; no-boundary-end, if
/// neither end lies on the boundary: the two edges would both join the same vertices.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_cut(const Mesh& mesh, Halfedge h) {
  if (Result<void> can = internal::check_inner_edge(mesh, h); !can) return can;
  const Vertex a = mesh.from_vertex(h);
  const Vertex b = mesh.to_vertex(h);
  if (mesh.is_boundary(a) || mesh.is_boundary(b)) return {};
  return no_boundary_end(mesh.edge(h), a, b);
}

/// Makes two edges on the boundary of one inside: that of `h` keeps the face of h, a copy of it
/// gets the other. Each end that lies on the boundary becomes two vertices; the copy belongs to the
/// faces on the right of h, up to the boundary. An end inside stays one. (The drawing is at glue.)
///
/// attributes: those of the copies are copied
/// returns: g, the new halfedge without a face, which leads the same way as h
/// cost: O(valence of both ends). inverse: glue(opposite(h), g)
/// errors: those of check_cut, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Halfedge> cut(Mesh& mesh, Halfedge h) {
  if (Result<void> can = check_cut(mesh, h); !can) return can;
  if (!steps::make_room(mesh, 2, 1, 0)) {
    return refusals::no_memory("an edge and its ends");
  }
  return internal::cut_edge(mesh, h);
}

/// Whether cut_path(path) can be done: else not-a-path, if it is empty, a halfedge doesn't begin
/// where the one before it ends, or an edge occurs twice; not-a-halfedge; loop-edge; boundary-edge;
/// no-boundary-end, if it is one edge without any; out-of-memory. cost: O(n log n)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_cut_path(const Mesh& mesh, std::span<const Halfedge> path) {
  if (path.empty()) return empty_path();
  Array<Edge> edges;
  for (const Halfedge h : path) {
    if (Result<void> can = internal::check_inner_edge(mesh, h); !can) return can;
    if (!edges.push_back(mesh.edge(h))) return refusals::no_memory("the path");
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vertex end = mesh.to_vertex(path[i]);
    const Vertex begin = mesh.from_vertex(path[i + 1]);
    if (end != begin) return not_consecutive(path[i], end, path[i + 1], begin);
  }
  const Edge repeated = sort_and_find_repeated(edges.span());
  if (repeated.valid()) return repeated_on_path(repeated);
  return path.size() == 1 ? check_cut(mesh, path[0]) : Result<void>{};
}

/// Cuts the surface open along a path of edges, which may end where it began. The edges of the path
/// keep the faces on its left; copies get those on its right, with copies of the vertices it passes
/// and of its ends, if these lie on the boundary. Inside it leaves a slit: a boundary loop of twice
/// as many halfedges.
///
///      * ---0--> * ---1--> *              *---0--> * ---1--> *         path = 0, 1
///                                 =>      |                  |
///       the faces below                    ` ----> *' ----> ´           copies below
///
/// attributes: those of the copies are copied
/// returns: the copy without a face of the last halfedge of the path
/// cost: O(n log n + sum of the valences along the path)
/// inverse: glue_path(opposite(last of the path), returned, n), if it passes no vertex on the
///          boundary, and none twice; of a path that ends where it began, inside, join_loop of the
///          same two
/// errors: those of check_cut_path, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Halfedge> cut_path(Mesh& mesh, std::span<const Halfedge> path) {
  if (Result<void> can = check_cut_path(mesh, path); !can) return can;
  const std::size_t n = path.size();
  if (n > kMaxSlots / 2 || !steps::make_room(mesh, Index(2 * n), Index(n), 0)) {
    return refusals::no_memory("a copy of the path");
  }
  Halfedge copy;
  for (const Halfedge h : path) copy = internal::cut_edge(mesh, h);
  return copy;
}

/// Whether cut_edges(edges) can be done: else not-an-edge; loop-edge; boundary-edge; repeated-edge,
/// if one is listed twice; no-boundary-end, if an edge has no end on the boundary, nor one that
/// another edge of the list shares: both copies would join the same vertices; out-of-memory.
/// cost: O(n log n)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_cut_edges(const Mesh& mesh, std::span<const Edge> edges) {
  return internal::plan_cuts(mesh, edges).failure();
}

/// Cuts the surface open along all of these edges, which may form any graph: paths, trees, cycles,
/// crossings, in one piece or several. The mesh that comes out is the same, numbers included, in
/// whichever order they are listed. An empty list changes nothing.
///
///            |                        |   |
///            0                        |   |
///      --1-- * --2--      =>      ----*   *----      0, 1 and 2 are cut, the fourth isn't
///            |
///            |                    ------*------
///                                       |
///
/// An edge e keeps the face of edge_halfedge(e), its copy gets the other. Around a vertex inside,
/// the faces from one of these edges to the next get a vertex of their own; if it has only one such
/// edge it stays one vertex, where the slit ends. On the boundary, so do the faces between it and
/// an edge. Of a pinched vertex, one part of each fan stays at it, with the fans that aren't cut.
///
/// attributes: those of the copies are copied
/// returns: in the order of the list, for each edge e the halfedge of its copy that has no face; it
///          leads the same way as edge_halfedge(e)
/// cost: O(n log n + sum over the edges of the valences of their ends)
/// inverse: glue_path or join_loop along the boundaries that this makes
/// errors: those of check_cut_edges, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Array<Halfedge>> cut_edges(Mesh& mesh, std::span<const Edge> edges) {
  Result<internal::Cuts> planned = internal::plan_cuts(mesh, edges);
  if (!planned) return std::move(planned).failure();
  const internal::Cuts& cuts = planned.value();
  Array<Halfedge> copies;
  if (!copies.resize(edges.size()) ||
      !steps::make_room(mesh, cuts.new_vertices, Index(edges.size()), 0)) {
    return refusals::no_memory("copies of the edges");
  }
  for (const auto& [e, place] : cuts.edges) {
    copies[place] = internal::cut_edge(mesh, mesh.edge_halfedge(e));
  }
  return copies;
}

}  // namespace halfedge::operations
