#pragma once

#include <halfedge/decorator/edit.h>
#include <halfedge/sentence.h>

namespace halfedge::decorator {

/// Whether split_vertex(h, g) can be done: else not-a-halfedge; different-vertices;
/// edge-without-face, if neither has a face.
template <Editable Mesh>
[[nodiscard]] Result<void> check_split_vertex(const Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  for (const Halfedge given : {h, g}) {
    if (Result<void> live = check_live(mesh, given); !live) return live;
  }
  if (mesh.to_vertex(h) != mesh.to_vertex(g)) {
    return refusal("different-vertices",
                   sentence::of("{} leads to {} and {} to {}, expected one vertex", h,
                                mesh.to_vertex(h), g, mesh.to_vertex(g)),
                   halfedges_of({h, g}));
  }
  if (is_boundary(mesh, h) && is_boundary(mesh, g)) {
    return refusal("edge-without-face",
                   sentence::of("the new edge would have no face on either side: neither {} nor {} "
                                "has one, expected one at least",
                                h, g),
                   halfedges_of({h, g}));
  }
  return {};
}

/// A new vertex beside the vertex v that `h` and `g` lead to, joined to it by a new edge; it takes
/// over the edges clockwise after h, up to and with g. No face is new: those of h and g gain a
/// corner. (CGAL: split_vertex)
///
///           n                         n
///           |                         |
///   --h---> v <--g---     =>          w <--g---
///           |                       d |            d leads from w down to v
///           s                 --h---> v
///                                     |
///                                     s
///
/// next(h) == opposite(d), next(g) == d. With g == h nothing is taken over: an edge that ends in
/// the new vertex enters the corner of h (insert_tip).
///
/// pre: to_vertex(h) == to_vertex(g), one of them has a face
/// returns: d, from the new vertex, which lies where v does and has its attributes, to v
/// cost: O(valence). inverse: join_vertex(d), which returns h
/// errors: those of check_split_vertex, out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> split_vertex(Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  if (Result<void> can = check_split_vertex(mesh, h, g); !can) return can;
  if (!make_room(mesh, 1, 1, 0)) return no_memory("a vertex and an edge");
  const Vertex v = mesh.to_vertex(h);
  const Vertex w = copy_vertex(mesh, v);
  const Halfedge d = mesh.new_edge(w, v);
  const Halfedge o = mesh.opposite(d);
  insert_halfedge(mesh, d, g);
  insert_halfedge(mesh, o, h);
  for (Halfedge in = mesh.next_on_vertex(o); in != o; in = mesh.next_on_vertex(in)) {
    mesh.set_to_vertex(in, w);
  }
  mend_anchor(mesh, d);
  mend_anchor(mesh, o);
  return d;
}

/// Whether join_vertex(h) can be done: else not-a-halfedge; loop-edge; last-edge, if h is a
/// segment.
template <Editable Mesh>
[[nodiscard]] Result<void> check_join_vertex(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  if (mesh.from_vertex(h) == mesh.to_vertex(h)) return is_loop_edge(h, mesh.to_vertex(h));
  const Halfedge o = mesh.opposite(h);
  if (mesh.next(h) == o && mesh.next(o) == h) {
    return last_edge(h, sentence::of("{} and the face around the edge", mesh.to_vertex(h)));
  }
  return {};
}

/// Contracts the edge of `h`: from_vertex(h) disappears into to_vertex(h), the faces on both sides
/// lose a corner; they stay, even with two or one. (CGAL: join_vertex; the drawing is at
/// split_vertex)
///
/// pre: the edge has two different ends, and isn't a segment
/// returns: what was prev(opposite(h)), or prev(h) if the edge ended in to_vertex(h)
/// cost: O(valence of both ends). inverse: split_vertex(prev(opposite(h)), prev(h))
/// errors: those of check_join_vertex
template <Editable Mesh>
requires DeletesVertices<Mesh>
[[nodiscard]] Result<Halfedge> join_vertex(Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> can = check_join_vertex(mesh, h); !can) return can;
  const Halfedge o = mesh.opposite(h);
  const Vertex kept = mesh.to_vertex(h);
  const Vertex gone = mesh.from_vertex(h);
  const Halfedge before_h = mesh.prev(h);
  const Halfedge before_o = mesh.prev(o);
  const Halfedge after_h = mesh.next(h);
  const Halfedge after_o = mesh.next(o);
  const bool is_tip = after_h == o;       // kept has no other edge
  const bool is_gone_tip = after_o == h;  // gone has no other edge
  const Halfedge returned = is_tip ? before_h : before_o;
  const Halfedge leaving = is_tip ? after_o : after_h;

  for (Halfedge in = mesh.next_on_vertex(o); in != o; in = mesh.next_on_vertex(in)) {
    mesh.set_to_vertex(in, kept);
  }
  replace_in_face(mesh, face_of(mesh, h), h, is_gone_tip ? after_h : before_h);
  replace_in_face(mesh, face_of(mesh, o), o, is_tip ? after_o : before_o);
  if (is_tip) {
    mesh.link(before_h, after_o);
  } else if (is_gone_tip) {
    mesh.link(before_o, after_h);
  } else {
    mesh.link(before_h, after_h);
    mesh.link(before_o, after_o);
  }
  mesh.release(mesh.edge(h));
  mesh.release(gone);
  mend_anchor(mesh, leaving);
  return returned;
}

/// Whether split_edge(h) can be done: else not-a-halfedge.
template <Editable Mesh>
[[nodiscard]] Result<void> check_split_edge(const Mesh& mesh, Halfedge h) {
  return internal::check_live(mesh, h);
}

namespace internal {

/// split_edge, all checks done.
/// pre: there is room for a vertex and an edge
template <class Mesh>
[[nodiscard]] Halfedge halve_edge(Mesh& mesh, Halfedge h, double t) {
  const Halfedge o = mesh.opposite(h);
  const Vertex u = mesh.from_vertex(h);
  const Halfedge before_h = mesh.prev(h);
  const Halfedge after_o = mesh.next(o);
  const bool is_tip = before_h == o;  // u has no other edge
  const Vertex w = new_vertex_between(mesh, u, mesh.to_vertex(h), t);
  const Halfedge k = mesh.new_unlinked_edge(u, w);
  copy_edge(mesh, k, h);
  const Halfedge k_opposite = mesh.opposite(k);
  mesh.blend_corners(k, before_h, h, t);
  mesh.blend_corners(o, o, mesh.prev(o), t);
  const auto writer = mesh.writer();
  writer.set_to_vertex(o, w);
  writer.link(k, h);
  writer.link(o, k_opposite);
  if (is_tip) {
    writer.link(k_opposite, k);
  } else {
    writer.link(before_h, k);
    writer.link(k_opposite, after_o);
  }
  writer.set_face(k, face_of(mesh, h));
  writer.set_face(k_opposite, face_of(mesh, o));
  replace_anchor(mesh, u, h, k);
  set_anchor(mesh, w, is_boundary(mesh, o) ? k_opposite : h);
  return k;
}

}  // namespace internal

/// A new vertex of valence two on the edge of `h`; the loops on both sides gain a corner.
/// (CGAL's Polyhedron: split_edge)
///
///       u ------------- h -----------> v
///       u ----- k ----> w ---- h ----> v       next(k) == h
///
/// returns: k, which leads to the new vertex, at (1 - t) u + t v. k has the attributes of the old
///          edge, w and its corners are interpolated.
/// cost: O(1), and finding prev(h) where it isn't stored. inverse: join_edge(k), which returns h
/// errors: not-a-halfedge, out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> split_edge(Mesh& mesh, Halfedge h, double t = 0.5) {
  using namespace internal;
  if (Result<void> can = check_split_edge(mesh, h); !can) return can;
  if (!make_room(mesh, 1, 1, 0)) return no_memory("a vertex and an edge");
  return halve_edge(mesh, h, t);
}

/// Whether join_edge(k) can be done: else not-a-halfedge, loop-edge, not-valence-two.
template <Editable Mesh>
[[nodiscard]] Result<void> check_join_edge(const Mesh& mesh, Halfedge k) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, k); !live) return live;
  const Vertex w = mesh.to_vertex(k);
  if (mesh.from_vertex(k) == w) return is_loop_edge(k, w);
  const Halfedge other = mesh.next_on_vertex(k);
  if (other != k && mesh.next_on_vertex(other) == k) return {};
  Index valence = 0;
  Halfedge in = k;
  do {
    ++valence;
    in = mesh.next_on_vertex(in);
  } while (in != k);
  return refusal("not-valence-two", sentence::of("{} has valence {}, expected 2", w, valence),
                 {.vertices = {w.index()}});
}

/// Removes the vertex to_vertex(k), which has valence two, and the edge of `k`: next(k) then begins
/// where k did. (CGAL: join_vertex; the drawing is at split_edge)
///
/// pre: to_vertex(k) has valence two, and k isn't a loop edge
/// attributes: the edge of next(k) keeps its own; so do the corners at both of its ends now
/// returns: what was next(k). cost: O(1), and finding prev where it isn't stored
/// inverse: split_edge(returned)
/// errors: those of check_join_edge
template <Editable Mesh>
requires DeletesVertices<Mesh>
[[nodiscard]] Result<Halfedge> join_edge(Mesh& mesh, Halfedge k) {
  using namespace internal;
  if (Result<void> can = check_join_edge(mesh, k); !can) return can;
  const Halfedge k_opposite = mesh.opposite(k);
  const Halfedge h = mesh.next(k);
  const Halfedge o = mesh.opposite(h);
  const Vertex u = mesh.from_vertex(k);
  const Vertex w = mesh.to_vertex(k);
  const Halfedge before_k = mesh.prev(k);
  const Halfedge after_k_opposite = mesh.next(k_opposite);
  mesh.copy_corner(o, k_opposite);
  if (before_k == k_opposite) {  // u has no other edge
    mesh.link(o, h);
  } else {
    mesh.link(before_k, h);
    mesh.link(o, after_k_opposite);
  }
  mesh.set_to_vertex(o, u);
  replace_in_face(mesh, face_of(mesh, k), k, h);
  replace_in_face(mesh, face_of(mesh, k_opposite), k_opposite, o);
  replace_anchor(mesh, u, k, h);
  mesh.release(mesh.edge(k));
  mesh.release(w);
  return h;
}

/// An edge that ends in a new vertex, in the corner between `h` and next(h): split_vertex(h, h).
///
/// pre: h has a face
/// returns: the halfedge to the new vertex, which lies where to_vertex(h) does; it is next(h)
/// cost: O(valence). inverse: erase_tip(next(h)), which returns h
/// errors: not-a-halfedge, edge-without-face, out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> insert_tip(Mesh& mesh, Halfedge h) {
  Result<Halfedge> edge = split_vertex(mesh, h, h);
  if (!edge) return edge;
  return mesh.opposite(edge.value());
}

/// Whether erase_tip(h) can be done: else not-a-halfedge; not-a-tip, if to_vertex(h) has other
/// edges; last-edge, if h is a segment.
template <Editable Mesh>
[[nodiscard]] Result<void> check_erase_tip(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  if (mesh.next(h) != mesh.opposite(h)) {
    return refusal(
        "not-a-tip",
        sentence::of("{}, where {} leads, has other edges, expected none", mesh.to_vertex(h), h),
        {.vertices = {mesh.to_vertex(h).index()}, .halfedges = {h.index()}});
  }
  return check_join_vertex(mesh, h);
}

/// Removes an edge and the vertex to_vertex(h) that it ends in.
///
/// pre: to_vertex(h) has no other edge, from_vertex(h) has
/// returns: what was prev(h). cost: O(valence of from_vertex(h)). inverse: insert_tip(prev(h))
/// errors: those of check_erase_tip
template <Editable Mesh>
requires DeletesVertices<Mesh>
[[nodiscard]] Result<Halfedge> erase_tip(Mesh& mesh, Halfedge h) {
  if (Result<void> can = check_erase_tip(mesh, h); !can) return can;
  return join_vertex(mesh, mesh.opposite(h));
}

}  // namespace halfedge::decorator
