#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/decorator/vertices.h>
#include <halfedge/operations/requirements.h>
#include <halfedge/operations/surgery_refusals.h>

#include <cstddef>
#include <span>

namespace halfedge::operations {

namespace internal {

/// `v` moves to (1 - t) v + t w, with its attributes.
template <class Mesh>
void move_towards(Mesh& mesh, Vertex v, Vertex w, double t) {
  if constexpr (HasPositions<Mesh>) {
    mesh.set_position(v, steps::blend(mesh.position(v), mesh.position(w), t));
  }
  mesh.blend_attributes(v, v, w, t);
}

/// An edge of a vertex that is cut off.
struct Spoke {
  Halfedge in;         // leads to the vertex
  Vertex corner = {};  // where it will lead
  Halfedge side = {};  // from there to the next corner, clockwise
};

/// A corner on each edge of `v`, which itself is the first. Returns a face at `v`.
/// pre: there is room for them
template <class Mesh>
[[nodiscard]] Face place_corners(Mesh& mesh, Vertex v, double amount, Array<Spoke>& spokes) {
  Face like;
  const Halfedge first = mesh.opposite(mesh.vertex_halfedge(v));
  Halfedge in = first;
  do {
    const Vertex corner =
        in == first ? v : steps::new_vertex_between(mesh, v, mesh.from_vertex(in), amount);
    (void)spokes.push_back({.in = in, .corner = corner});
    if (!like.valid()) like = mesh.face(in);
    in = mesh.next_on_vertex(in);
  } while (in != first);
  move_towards(mesh, v, mesh.from_vertex(first), amount);
  return like;
}

/// An edge from each corner to the next. The faces around are still linked as they were, for the
/// corners of theirs to be blended.
template <class Mesh>
void add_sides(Mesh& mesh, double amount, std::span<Spoke> spokes) {
  const std::size_t n = spokes.size();
  for (std::size_t i = 0; i < n; ++i) {
    Spoke& spoke = spokes[i];
    const Spoke& following = spokes[i + 1 == n ? 0 : i + 1];
    spoke.side = mesh.new_edge(spoke.corner, following.corner);
    mesh.blend_corners(spoke.side, spoke.in, mesh.opposite(following.in), amount);
    mesh.blend_corners(spoke.in, spoke.in, mesh.prev(spoke.in), amount);
    mesh.set_face(spoke.side, mesh.face(spoke.in));
  }
}

/// The sides become part of the faces around, and enclose a loop of their own.
template <class Mesh>
void link_sides(Mesh& mesh, std::span<const Spoke> spokes) {
  const std::size_t n = spokes.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Spoke& spoke = spokes[i];
    const Spoke& before = spokes[i == 0 ? n - 1 : i - 1];
    const Spoke& following = spokes[i + 1 == n ? 0 : i + 1];
    // Beside a gap only the face on the other side of the spoke has this corner.
    mesh.copy_corner(mesh.opposite(spoke.side),
                     mesh.is_boundary(spoke.in) ? before.side : spoke.in);
    mesh.link(spoke.in, spoke.side);
    mesh.link(spoke.side, mesh.opposite(following.in));
    mesh.link(mesh.opposite(following.side), mesh.opposite(spoke.side));
    mesh.set_to_vertex(spoke.in, spoke.corner);
  }
}

}  // namespace internal

/// Whether bevel_vertex(v, amount) can be done: else not-a-vertex, valence-below-three,
/// out-of-range.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_bevel_vertex(const Mesh& mesh, Vertex v, double amount) {
  if (Result<void> live = check_live(mesh, v); !live) return live;
  const Index valence = mesh.is_isolated(v) ? 0 : mesh.valence(v);
  if (valence < 3) return valence_below_three(v, valence);
  if (!(0 <= amount && amount <= 1)) return not_a_fraction("amount", amount);
  return {};
}

/// Cuts a vertex off: a polygon takes its place, with a corner on each of its edges, so far along
/// it as `amount` says, from 0, at v, to 1, at the other end. On the boundary, and at a pinched
/// vertex, the sides of the polygon across a gap between faces are boundary edges.
///
///        \     /              \     /
///         \   /                *---*
///     ----- v -----   =>   ---*     *---
///         /   \                *---*
///        /     \              /     \                .
///
/// v stays, as the corner on the edge of vertex_halfedge(v).
///
/// attributes: the corners, of the faces around too, are blended as their positions are; the new
///             face has those of a face at v; new edges have the defaults
/// returns: the new face, of the degree that was the valence of v
/// cost: O(valence), where prev isn't stored O(sum of the degrees)
/// inverse: collapse of all sides of the new face but one; at a pinched vertex, where a collapse
///          would let the boundary meet itself, undo; undo also of the positions and attributes
/// errors: those of check_bevel_vertex, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> bevel_vertex(Mesh& mesh, Vertex v, double amount) {
  if (Result<void> can = check_bevel_vertex(mesh, v, amount); !can) return can;
  const Index n = mesh.valence(v);
  Array<internal::Spoke> spokes;
  if (!spokes.reserve(n) || !steps::make_room(mesh, n - 1, n, 1)) {
    return refusals::no_memory("a face");
  }
  const Face like = internal::place_corners(mesh, v, amount, spokes);
  internal::add_sides(mesh, amount, spokes.span());
  internal::link_sides(mesh, spokes.span());
  steps::make_face(mesh, mesh.opposite(spokes[0].side), like);
  for (const internal::Spoke& spoke : spokes) {
    steps::set_anchor(mesh, spoke.corner,
                      mesh.is_boundary(spoke.side) ? spoke.side : mesh.opposite(spoke.in));
  }
  return mesh.face(mesh.opposite(spokes[0].side));
}

/// Whether bevel_edge(e, amount) can be done: else not-an-edge; loop-edge; boundary-edge;
/// valence-below-three, if both ends have no other edge than one; out-of-range.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_bevel_edge(const Mesh& mesh, Edge e, double amount) {
  if (Result<void> live = check_live(mesh, e); !live) return live;
  const Halfedge h = mesh.edge_halfedge(e);
  if (mesh.from_vertex(h) == mesh.to_vertex(h)) {
    return refusals::is_loop_edge(h, mesh.to_vertex(h));
  }
  Index splits = 0;
  for (const Halfedge side : {h, mesh.opposite(h)}) {
    if (mesh.is_boundary(side)) return is_boundary_edge(e, side);
    if (mesh.next_on_vertex(mesh.next_on_vertex(side)) != side) ++splits;
  }
  if (splits == 0) return both_valences_below_three(e, mesh.from_vertex(h), mesh.to_vertex(h));
  if (!(0 <= amount && amount <= 1)) return not_a_fraction("amount", amount);
  return {};
}

namespace internal {

/// from_vertex(h) moves to (1 - t) from_vertex(h) + t to_vertex(h), with its attributes and
/// corners.
template <class Mesh>
void slide(Mesh& mesh, Halfedge h, double t) {
  if (!mesh.attributes().of(ItemKind::kHalfedge).empty()) {
    const Halfedge o = mesh.opposite(h);
    const Halfedge before_h = mesh.prev(h);
    mesh.move_corners(h, before_h, mesh.prev(o), t, [&](const auto& move) {
      for (Halfedge in = mesh.next_on_vertex(o); in != before_h; in = mesh.next_on_vertex(in)) {
        move(in.index(), Attributes::EdgeEnd::kFrom);
      }
      // Beside a gap there is no side whose value they hold already.
      if (mesh.is_boundary(o)) move(o.index(), Attributes::EdgeEnd::kFrom);
      if (mesh.is_boundary(h)) move(before_h.index(), Attributes::EdgeEnd::kFrom);
    });
  }
  move_towards(mesh, mesh.from_vertex(h), mesh.to_vertex(h), t);
}

/// Where to divide the edges around a vertex that follow each other clockwise from `in` on, up to
/// `end`, which isn't one of them: the last halfedge of the first part. At the first gap between
/// faces if there is one, else in the middle. pre: two of them or more
template <class Mesh>
[[nodiscard]] Halfedge end_of_first_part(const Mesh& mesh, Halfedge in, Halfedge end) {
  Index count = 0;
  for (Halfedge at = in; at != end; at = mesh.next_on_vertex(at)) {
    if (mesh.is_boundary(at)) return at;
    ++count;
  }
  Halfedge middle = in;
  for (Index i = 1; i < count / 2; ++i) middle = mesh.next_on_vertex(middle);
  return middle;
}

}  // namespace internal

/// Replaces an edge by a quad, whose long sides lie in the faces beside it: each end becomes two
/// vertices, joined by a short side, which have moved along the neighbouring sides of these faces,
/// so far as `amount` says.
///
///        \         /            \ ------- /         next to it: the faces of the edge
///         \       /              *-------*
///          * --- *       =>      |       |          the new face
///         /       \              *-------*
///        /         \            / ------- \                           .
///
/// Other edges of an end go to the nearer of the two, half of them to each, or up to a gap between
/// faces. The face there gains a corner; on the boundary the short side lies on it. An end of
/// valence two stays one, where it is; the new face is a triangle then.
///
/// e stays in the face of edge_halfedge(e), with both of its ends.
///
/// attributes: vertices and corners that move are blended as their positions are, but for corners
///             beyond a seam, which keep what they have; the other long side has those of e, the
///             new face those of the face of edge_halfedge(e); short sides have the defaults
/// returns: the new face. cost: O(valence of both ends), and finding prev where it isn't stored
/// inverse: collapse of the short sides; undo also of the positions and attributes
/// errors: those of check_bevel_edge, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> bevel_edge(Mesh& mesh, Edge e, double amount) {
  using namespace refusals;
  using namespace steps;
  if (Result<void> can = check_bevel_edge(mesh, e, amount); !can) return can;
  if (!make_room(mesh, 2, 3, 1)) return no_memory("a face");
  const Halfedge h = mesh.edge_halfedge(e);
  const Halfedge o = mesh.opposite(h);
  const Halfedge before[] = {mesh.prev(h), mesh.prev(o)};  // to a beside h; to b beside o
  const Halfedge after[] = {mesh.next(h), mesh.next(o)};   // from b beside h; from a beside o
  const Vertex a = mesh.from_vertex(h);
  const Vertex b = mesh.to_vertex(h);
  const bool splits_a = mesh.next_on_vertex(mesh.next_on_vertex(o)) != o;
  const bool splits_b = mesh.next_on_vertex(mesh.next_on_vertex(h)) != h;
  const Face of_o = mesh.face(o);

  // A face of two corners between o and g; k is on the side of o.
  const Halfedge k = new_edge_like(mesh, b, a, o);
  const Halfedge g = mesh.opposite(k);
  mesh.link(before[1], k);
  mesh.link(k, after[1]);
  mesh.set_face(k, of_o);
  replace_in_face(mesh, of_o, o, k);
  mesh.link(o, g);
  mesh.link(g, o);
  make_face(mesh, o, mesh.face(h));
  mesh.copy_corner(g, before[1]);
  mesh.copy_corner(o, before[0]);

  // Around b, clockwise: h, its part, the part of before[1], g. Around a: o, k, its part, the rest.
  if (splits_b) {
    const Halfedge last = internal::end_of_first_part(mesh, mesh.next_on_vertex(h), g);
    const Halfedge d = decorator::split_vertex(mesh, last, g).value();
    mesh.copy_corner(d, h);
    internal::slide(mesh, mesh.opposite(before[1]), amount);
    internal::slide(mesh, after[0], amount);
  }
  if (splits_a) {
    const Halfedge last = internal::end_of_first_part(mesh, mesh.next_on_vertex(k), o);
    const Halfedge d = decorator::split_vertex(mesh, o, last).value();
    mesh.copy_corner(mesh.opposite(d), k);
    internal::slide(mesh, after[1], amount);
    internal::slide(mesh, mesh.opposite(before[0]), amount);
  }
  return mesh.face(o);
}

}  // namespace halfedge::operations
