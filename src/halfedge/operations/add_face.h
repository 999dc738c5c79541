#pragma once

#include <halfedge/connectivity/lone_fans.h>
#include <halfedge/operations/distinct.h>
#include <halfedge/operations/fans.h>
#include <halfedge/operations/requirements.h>

#include <cstddef>
#include <initializer_list>
#include <span>

namespace halfedge::operations {

namespace internal {

/// Whether the face of `h`, and with `is_reversed` that of opposite(h), read against its direction,
/// has these corners, of which `h` leads from number `at` to the next.
template <class Mesh>
[[nodiscard]] bool has_corners(const Mesh& mesh, Halfedge h, std::span<const Vertex> corners,
                               std::size_t at, bool is_reversed) {
  const Halfedge first = is_reversed ? mesh.opposite(h) : h;
  if (mesh.is_boundary(first)) return false;
  const std::size_t step = is_reversed ? corners.size() - 1 : 1;
  std::size_t corner = is_reversed ? at : (at + 1) % corners.size();
  Halfedge on_loop = first;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (mesh.to_vertex(on_loop) != corners[corner]) return false;
    corner = (corner + step) % corners.size();
    on_loop = mesh.next(on_loop);
  }
  return on_loop == first;
}

/// Why no face can lie on the left of `h`, which has one: it would lead from corner `at` to the
/// next.
template <class Mesh>
[[nodiscard]] Failure side_is_taken(const Mesh& mesh, Halfedge h, std::span<const Vertex> corners,
                                    std::size_t at) {
  for (const bool is_reversed : {false, true}) {
    if (!has_corners(mesh, h, corners, at, is_reversed)) continue;
    return duplicate_face(mesh.face(is_reversed ? mesh.opposite(h) : h), is_reversed);
  }
  const Edge e = mesh.edge(h);
  if (!mesh.is_boundary(e)) {
    return edge_with_many_faces(e, mesh.face(h), mesh.face(mesh.opposite(h)));
  }
  return opposite_orientation(e, mesh.face(h), mesh.from_vertex(h), mesh.to_vertex(h));
}

/// Whether a face can fill the corner at `v` between `in` and `out`, boundary halfedges, or empty
/// if they are new: not if some faces are then closed around `v` and others are not among them.
template <class Mesh>
[[nodiscard]] Result<void> check_corner(const Mesh& mesh, Vertex v, Halfedge in, Halfedge out) {
  if (!in.valid() && !out.valid() && !mesh.is_boundary(v)) {
    return closed_beside_another(v, mesh.face(mesh.vertex_halfedge(v)), Face{});
  }
  if (!in.valid() || !out.valid() || mesh.next(in) == out) return {};
  if (end_of_fan(mesh, out) != in) return {};
  return closed_beside_another(v, mesh.face(mesh.opposite(in)),
                               mesh.face(mesh.opposite(mesh.next(in))));
}

/// Whether add_face can be done: else its refusals. If so, how many of the sides are new edges.
template <class Mesh>
[[nodiscard]] Result<Index> check_and_count_new_edges(const Mesh& mesh,
                                                      std::span<const Vertex> corners) {
  const std::size_t degree = corners.size();
  for (const Vertex v : corners) {
    if (Result<void> live = check_live(mesh, v); !live) return live;
  }
  if (degree < 3) return degree_below_three(Index(degree), corners);
  Result<Vertex> repeated = find_repeated(corners);
  if (!repeated) return repeated;
  if (repeated.value().valid()) return repeated_vertex(repeated.value());

  Index new_edges = 0;
  const Halfedge last = mesh.find_halfedge(corners[degree - 1], corners[0]);
  if (last.valid() && !mesh.is_boundary(last))
    return side_is_taken(mesh, last, corners, degree - 1);
  Halfedge in = last;
  for (std::size_t i = 0; i < degree; ++i) {
    const Halfedge out = i + 1 == degree ? last : mesh.find_halfedge(corners[i], corners[i + 1]);
    if (out.valid() && !mesh.is_boundary(out)) return side_is_taken(mesh, out, corners, i);
    new_edges += out.valid() ? 0U : 1U;
    if (Result<void> can = check_corner(mesh, corners[i], in, out); !can) return can;
    in = out;
  }
  return new_edges;
}

/// Puts a fan, from `first` to `end`, in its place in the orbit of its vertex: fans are in the
/// order of the vertices that their first halfedges lead to, as the builder has them. `start` is
/// the first halfedge of another fan.
template <class Mesh>
void insert_fan(Mesh& mesh, Halfedge first, Halfedge end, Halfedge start) {
  Halfedge before;
  Index rank_before = 0;
  Index rank = 0;
  Halfedge out = start;
  do {
    // The fan with the largest vertex below that of `first` comes before it, else the largest of
    // all: both are the largest in a count that begins, and ends, at the vertex of `first`.
    if (mesh.is_boundary(out)) rank = mesh.to_vertex(out).index() - mesh.to_vertex(first).index();
    const Halfedge in = mesh.opposite(out);
    if (mesh.is_boundary(in) && (!before.valid() || rank > rank_before)) {
      before = in;
      rank_before = rank;
    }
    out = mesh.next(in);
  } while (out != start);
  mesh.link(end, mesh.next(before));
  mesh.link(before, first);
}

/// A side of a face to be, from one corner to the next.
struct Side {
  Halfedge halfedge;
  bool is_new = false;
};

/// end_of_fan, of a fan at `v`; without a walk if it is known to be the only one, and known as that
/// afterwards if the walk was long.
template <class Mesh>
[[nodiscard]] Halfedge find_end_of_fan(Mesh& mesh, Vertex v, Halfedge first) {
  LoneFans& lone = mesh.lone_fans();
  if (const Halfedge end = lone.end_at(v); end.valid()) return end;
  Index faces = 0;
  Halfedge in = mesh.opposite(first);
  for (; !mesh.is_boundary(in); ++faces) in = mesh.next_on_vertex(in);
  if (faces > LoneFans::kShort && mesh.next(in) == first) lone.add(v, in);
  return in;
}

/// next(in) = out at the vertex that lies between them, where fans change places for that. Only
/// `next` of halfedges that lead to this vertex is written, so that the corners of a face don't
/// disturb each other; faces are still those from before.
template <class Mesh>
void link_corner(Mesh& mesh, const Side& in, const Side& out) {
  const Vertex v = mesh.from_vertex(out.halfedge);
  const Halfedge first = mesh.opposite(in.halfedge);  // of the fan of the new face, if `in` is new
  const Halfedge end = mesh.opposite(out.halfedge);   // the same if `out` is new
  if (in.is_new && out.is_new) {
    if (mesh.is_isolated(v)) {
      mesh.link(end, first);
    } else {
      mesh.lone_fans().change(v, Halfedge{});
      insert_fan(mesh, first, end, mesh.vertex_halfedge(v));
    }
  } else if (out.is_new) {
    mesh.link(end, mesh.next(in.halfedge));
    mesh.lone_fans().change(v, end);
  } else if (in.is_new) {
    const Halfedge end_of_out = find_end_of_fan(mesh, v, out.halfedge);
    const Halfedge after = mesh.next(end_of_out);
    if (after == out.halfedge) {  // it is the only fan
      mesh.link(end_of_out, first);
    } else {
      mesh.link(mesh.prev(out.halfedge), after);
      insert_fan(mesh, first, end_of_out, after);
    }
  } else if (const Halfedge between = mesh.next(in.halfedge); between != out.halfedge) {
    // The fan that begins at `out` moves to the one that ends in `in`, before those between them.
    const Halfedge end_of_out = end_of_fan(mesh, out.halfedge);
    mesh.link(mesh.prev(out.halfedge), mesh.next(end_of_out));
    mesh.link(end_of_out, between);
  }
  mesh.link(in.halfedge, out.halfedge);
}

/// Invariants 4 and 5 at the vertex between `in` and `out`, of the new face, as the builder has
/// them: the anchor is the boundary halfedge to the smallest vertex; else that in the last face.
template <class Mesh>
void choose_anchor(Mesh& mesh, Halfedge in, Halfedge out) {
  const Vertex v = mesh.to_vertex(in);
  const Halfedge anchor = mesh.vertex_halfedge(v);
  const Halfedge first = mesh.opposite(in);  // the only new boundary halfedge, if it is one
  Halfedge chosen = out;
  if (anchor.valid() && mesh.is_boundary(anchor)) {
    const bool is_smaller = mesh.to_vertex(first) < mesh.to_vertex(anchor);
    chosen = mesh.is_boundary(first) && is_smaller ? first : anchor;
  } else if (mesh.lone_fans().end_at(v).valid()) {
    // The only fan, if it isn't closed, begins at `first`.
    if (mesh.is_boundary(first)) chosen = first;
  } else {
    for (Halfedge h = mesh.rotate_cw(out); h != out; h = mesh.rotate_cw(h)) {
      if (!mesh.is_boundary(h)) continue;
      if (chosen == out || mesh.to_vertex(h) < mesh.to_vertex(chosen)) chosen = h;
    }
  }
  if (chosen != anchor) mesh.set_vertex_halfedge(v, chosen);
}

}  // namespace internal

/// Whether add_face(corners) can be done: else
/// - not-a-vertex; degree-below-three; repeated-vertex
/// - duplicate-face; edge-with-many-faces; opposite-orientation, if a neighbour runs along an edge
///   in the direction in which the new face would
/// - pinched-vertex, if the faces around a vertex would be closed, or are, and others aren't
///   among them
/// - out-of-memory, of a face with many corners
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_add_face(const Mesh& mesh, std::span<const Vertex> corners) {
  Result<Index> new_edges = internal::check_and_count_new_edges(mesh, corners);
  if (!new_edges) return new_edges;
  return {};
}
/// check_add_face(mesh, {a, b, c})
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_add_face(const Mesh& mesh, std::initializer_list<Vertex> corners) {
  return check_add_face(mesh, std::span<const Vertex>(corners.begin(), corners.size()));
}

/// A face with these corners, counter-clockwise; the edges between them that don't exist yet are
/// new. (OpenMesh: add_face; CGAL: Surface_mesh::add_face, Euler::add_face)
///
/// The faces of a mesh that can be built can be added one after the other, in any order, and are
/// then what `build_from_polygons` makes of them, but for the numbering of edges. For where faces
/// meet at a vertex without a common edge, their fans change places around it as they must; and
/// faces that are closed around a vertex, and refuse another, would do so in the end as well.
///
/// attributes: the face and new edges have the defaults
/// returns: the face; to_vertex(face_halfedge(f)) is the first corner
/// cost: amortised O(d log d) of d corners, for each side the smaller valence of its ends, and
///       O(valence) for a corner with several fans of faces. So faces around one vertex take linear
///       time if each but the first has a neighbour there already, and the square of their number
///       in random order. That a vertex has one fan is known from a walk round it: of the last four
///       with many faces, until anything but add_face and add_vertex changes the connectivity.
/// inverse: delete_face, with isolated vertices kept if corners were isolated, up to the order of
///          fans around pinched vertices
/// errors: those of check_add_face, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> add_face(Mesh& mesh, std::span<const Vertex> corners) {
  using namespace internal;
  Result<Index> new_edges = check_and_count_new_edges(mesh, corners);
  if (!new_edges) return new_edges;
  if (!steps::make_room(mesh, 0, new_edges.value(), 1)) {
    return refusals::no_memory("a face and its edges");
  }
  LoneFans& lone = mesh.lone_fans();
  lone.start_at(mesh.version());
  const auto side = [&](Vertex from, Vertex to) {
    const Halfedge found = mesh.find_halfedge(from, to);
    return found.valid() ? Side{found} : Side{mesh.new_edge(from, to), true};
  };
  const Side last = side(corners.back(), corners.front());
  Side in = last;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Side out = i + 1 == corners.size() ? last : side(corners[i], corners[i + 1]);
    link_corner(mesh, in, out);
    in = out;
  }
  steps::make_face(mesh, last.halfedge);
  for (Halfedge h = last.halfedge;;) {
    const Halfedge after = mesh.next(h);
    choose_anchor(mesh, h, after);
    h = after;
    if (h == last.halfedge) break;
  }
  lone.keep_at(mesh.version());
  return mesh.face(last.halfedge);
}
/// add_face(mesh, {a, b, c})
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> add_face(Mesh& mesh, std::initializer_list<Vertex> corners) {
  return add_face(mesh, std::span<const Vertex>(corners.begin(), corners.size()));
}

}  // namespace halfedge::operations
