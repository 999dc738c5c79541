#pragma once

#include <halfedge/operations/requirements.h>
#include <halfedge/operations/surgery_refusals.h>
#include <halfedge/sort.h>

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
  using namespace decorator::internal;
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
    return decorator::internal::is_loop_edge(h, mesh.to_vertex(h));
  }
  for (const Halfedge side : {h, mesh.opposite(h)}) {
    if (mesh.is_boundary(side)) return is_boundary_edge(mesh.edge(h), side);
  }
  return {};
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
  if (Result<void> can = check_cut(mesh, h); !can) return can.error();
  if (!decorator::internal::make_room(mesh, 2, 1, 0)) {
    return decorator::internal::no_memory("an edge and its ends");
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
    if (!edges.push_back(mesh.edge(h))) return decorator::internal::no_memory("the path");
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
  if (Result<void> can = check_cut_path(mesh, path); !can) return can.error();
  const std::size_t n = path.size();
  if (n > kMaxSlots / 2 || !decorator::internal::make_room(mesh, Index(2 * n), Index(n), 0)) {
    return decorator::internal::no_memory("a copy of the path");
  }
  Halfedge copy;
  for (const Halfedge h : path) copy = internal::cut_edge(mesh, h);
  return copy;
}

}  // namespace halfedge::operations
