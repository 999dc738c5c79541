#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/decorator/center.h>
#include <halfedge/decorator/faces.h>
#include <halfedge/decorator/vertices.h>
#include <halfedge/operations/distinct.h>
#include <halfedge/operations/fans.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/requirements.h>

namespace halfedge::operations {

/// Whether dissolve_vertex(v) can be done: else
/// - not-a-vertex; isolated-vertex; pinched-vertex
/// - degree-below-three or repeated-vertex, of the face that would be
/// - edge-exists, of a boundary vertex whose neighbours along the boundary are joined already
/// - out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_dissolve_vertex(const Mesh& mesh, Vertex v) {
  if (Result<void> live = check_live(mesh, v); !live) return live;
  if (mesh.is_isolated(v)) return is_isolated_vertex(v);
  const Halfedge anchor = mesh.vertex_halfedge(v);
  const bool on_boundary = mesh.is_boundary(anchor);
  if (on_boundary) {
    if (const Halfedge other = internal::next_gap(mesh, anchor); other.valid()) {
      return is_pinched_vertex(v, anchor, other);
    }
  }

  Array<Vertex> corners;
  bool fits = true;
  Halfedge in = mesh.opposite(anchor);
  do {
    // Face after face clockwise, each without the spoke that it shares with the following one.
    for (Halfedge h = mesh.next(mesh.next(in)); h != in; h = mesh.next(h)) {
      fits = fits && corners.push_back(mesh.to_vertex(h));
    }
    in = mesh.next_on_vertex(in);
  } while (!mesh.is_boundary(in) && in != mesh.opposite(anchor));
  if (on_boundary) fits = fits && corners.push_back(mesh.from_vertex(in));
  if (!fits) return refusals::no_memory("the corners of the joined face");

  const Index degree = Index(corners.size());
  if (degree < 3) return degree_below_three(degree, corners.span(), v);
  Result<Vertex> repeated = internal::find_repeated(corners.span());
  if (!repeated) return repeated;
  if (repeated.value().valid()) return repeated_vertex(repeated.value());
  if (on_boundary) {
    const Vertex a = mesh.to_vertex(anchor);
    const Vertex b = mesh.from_vertex(in);
    if (const Edge existing = mesh.find_edge(a, b); existing.valid()) {
      return edge_exists(a, b, existing);
    }
  }
  return {};
}

/// Removes a vertex; all faces around it become one. On a boundary, where they form one fan, its
/// two boundary edges become one. (CGAL: Euler::remove_center_vertex, of an interior vertex)
///
///     * ------- *        * ------- *        * ------- *        * ------- *
///     | `.   .´ |        |         |        | `.   .´ |        |         |
///     |    v    |   =>   |         |        * -- v -- *   =>   * ------- *
///     | .´   `. |        |         |
///     * ------- *        * ------- *
///
/// A vertex with two edges in the interior takes both with it; `remove_vertex_on_edge` takes only
/// the vertex.
///
/// attributes: those of the face that stays, opposite(vertex_halfedge(v)) lies in it, and of the
///             halfedges that stay, stay
/// returns: the joined face
/// cost: O(sum of the degrees of the faces), O(d log d) of d corners; where prev isn't stored,
///       O(valence^2) besides
/// inverse: split_face(returned), if the faces were triangles around an interior vertex
/// errors: those of check_dissolve_vertex
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> dissolve_vertex(Mesh& mesh, Vertex v) {
  if (Result<void> can = check_dissolve_vertex(mesh, v); !can) return can;
  const Halfedge in = mesh.opposite(mesh.vertex_halfedge(v));
  const Face f = mesh.face(in);
  if (!mesh.is_boundary(v)) {
    (void)decorator::erase_center_vertex(mesh, in);  // its requirements are fewer
    return f;
  }
  for (;;) {
    const Halfedge spoke = mesh.next(in);
    if (mesh.is_boundary(mesh.opposite(spoke))) break;
    (void)decorator::join_face(mesh, spoke);  // two faces at the spoke: can't fail
  }
  (void)decorator::join_edge(mesh, in);  // two edges are left: can't fail
  return f;
}

namespace internal {

/// Whether `out` and one more edge are all that leave their vertex.
template <class Mesh>
[[nodiscard]] bool has_valence_two(const Mesh& mesh, Halfedge out) {
  const Halfedge other = mesh.rotate_cw(out);
  return other != out && mesh.rotate_cw(other) == out;
}

/// The edges in a row around an edge that its two faces share, with vertices of valence two
/// between.
struct SharedEdges {
  Halfedge first;  // on the side that was asked for
  Index count = 1;
};

/// Of a ring of them only the edge of `h`: there would be nothing left of the faces.
template <class Mesh>
[[nodiscard]] SharedEdges shared_edges_around(const Mesh& mesh, Halfedge h) {
  SharedEdges shared{.first = h};
  while (has_valence_two(mesh, shared.first)) {
    shared.first = mesh.opposite(mesh.rotate_cw(shared.first));
    ++shared.count;
    if (shared.first == h) return {.first = h, .count = 1};
  }
  for (Halfedge last = mesh.next(h); has_valence_two(mesh, last); last = mesh.next(last)) {
    ++shared.count;
  }
  return shared;
}

/// Removes the vertex that `out` leaves if it has two edges and its neighbours aren't joined, as
/// they are beside a triangle.
template <class Mesh>
void straighten(Mesh& mesh, Halfedge out) {
  if (!has_valence_two(mesh, out)) return;
  const Vertex a = mesh.to_vertex(out);
  const Vertex b = mesh.to_vertex(mesh.rotate_cw(out));
  if (!mesh.find_edge(a, b).valid()) (void)decorator::join_edge(mesh, mesh.opposite(out));
}

}  // namespace internal

/// Whether dissolve_edge(e) can be done: else not-an-edge; boundary-edge; loop-edge;
/// faces-share-edges or faces-share-vertex, if the two faces have more in common than `e` and what
/// it goes on in; out-of-memory.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_dissolve_edge(const Mesh& mesh, Edge e) {
  if (Result<void> live = check_live(mesh, e); !live) return live;
  const Halfedge h = mesh.edge_halfedge(e);
  if (mesh.is_boundary(e)) return is_boundary_edge(e, mesh.is_boundary(h) ? h : mesh.opposite(h));
  if (mesh.from_vertex(h) == mesh.to_vertex(h)) {
    return refusals::is_loop_edge(h, mesh.to_vertex(h));
  }
  const internal::SharedEdges shared = internal::shared_edges_around(mesh, h);
  return internal::check_join_along(mesh, shared.first, shared.count);
}

/// Makes one face of the two beside an edge, as modellers mean it: the edge goes, and so do
/// - the edges that it goes on in, where the faces share those too with vertices of valence two
///   between them; and these vertices;
/// - its ends, if they have valence two afterwards: their two edges become one, unless that would
///   join neighbours a second time.
/// (Blender: Dissolve Edges. `remove_edge` takes the edge only.)
///
///     * ----- a ----- *        * ------------- *
///     |       |       |        |               |
///     |       e       |   =>   |               |
///     |       |       |        |               |
///     * ----- b ----- *        * ------------- *
///
/// attributes: those of the face and the halfedges that stay, stay
/// returns: the joined face, that of edge_halfedge(e, 0)
/// cost: O(sum of the valences along one of the faces). inverse: none in general
/// errors: those of check_dissolve_edge
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> dissolve_edge(Mesh& mesh, Edge e) {
  using namespace internal;
  if (Result<void> can = check_dissolve_edge(mesh, e); !can) return can;
  const Halfedge h = mesh.edge_halfedge(e);
  const Halfedge o = mesh.opposite(h);
  const Face f = mesh.face(h);
  for (const Halfedge side : {h, o}) {
    while (has_valence_two(mesh, side)) {
      (void)decorator::join_edge(mesh, mesh.opposite(mesh.rotate_cw(side)));  // can't fail
    }
  }
  const Halfedge ends[] = {mesh.next(o), mesh.next(h)};  // other edges that leave them
  (void)decorator::join_face(mesh, h);                   // two faces, and no edge else: can't fail
  // Both ends can be those of one more edge, which is gone then if it lay between them; in a
  // degenerate complex both can be one, where all edges of a face were shared.
  for (const Halfedge end : ends) {
    if (!mesh.is_deleted(end)) straighten(mesh, end);
  }
  return f;
}

}  // namespace halfedge::operations
