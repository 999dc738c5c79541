#pragma once

#include <halfedge/decorator/edit.h>
#include <halfedge/sentence.h>

namespace halfedge::decorator {

/// Whether split_face(h, g) can be done: else not-a-halfedge, boundary-halfedge, different-loops.
template <Editable Mesh>
[[nodiscard]] Result<void> check_split_face(const Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  for (const Halfedge given : {h, g}) {
    if (Result<void> live = check_live(mesh, given); !live) return live;
    if (is_boundary(mesh, given)) return on_boundary(given);
  }
  if (!is_one_loop(mesh, h, g)) return in_different_loops(h, g);
  return {};
}

/// A new edge from to_vertex(h) to to_vertex(g) through their face. (CGAL: split_face)
///
///      ---h---> * ------>           ---h---> * ------>
///     |                  |         |         |    d'  |
///     |        f         |    =>   |    f   d|        |     d' = opposite(d)
///      <------- * <---g--           <------- * <---g--
///
/// next(h) == d, next(g) == opposite(d). With g == h the new edge is a loop edge, and its new face
/// has this one corner; with g == next(h) the new face has two.
///
/// pre: h and g are halfedges of one face, or the same one
/// returns: d. Its face is the old one, f; that of opposite(d), with g in it, is new, and has the
///          attributes of f.
/// cost: O(halfedges of the new face). inverse: join_face(d), which returns h
/// errors: those of check_split_face, out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> split_face(Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  if (Result<void> can = check_split_face(mesh, h, g); !can) return can;
  if (!make_room(mesh, 0, 1, 1)) return no_memory("an edge and a face");
  const Face f = face_of(mesh, h);
  const Halfedge d = mesh.new_edge(mesh.to_vertex(h), mesh.to_vertex(g));
  steps::insert_tip(mesh, d, g);
  steps::insert_tip(mesh, mesh.opposite(d), h);
  set_face(mesh, d, f);
  make_face(mesh, mesh.opposite(d), f);
  mend_face(mesh, f, d);
  return d;
}

/// Whether join_face(h) can be done: else not-a-halfedge; same-loop, if one face lies on both
/// sides; last-edge; edge-without-face, if h has no face and another edge of the face that
/// disappears has none on its other side either.
template <Editable Mesh>
[[nodiscard]] Result<void> check_join_face(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  const Halfedge o = mesh.opposite(h);
  if (is_one_loop(mesh, h, o)) return in_same_loop(h, o);
  if (mesh.next(h) == h && mesh.next(o) == o) return last_edge(h, "the joined face");
  if (is_boundary(mesh, h) && !is_boundary(mesh, o)) {
    for (Halfedge on_loop = mesh.next(o); on_loop != o; on_loop = mesh.next(on_loop)) {
      const Halfedge other = mesh.opposite(on_loop);
      if (is_boundary(mesh, other) || face_of(mesh, other) == face_of(mesh, o)) {
        return edge_without_face(on_loop, sentence::of("once {} is removed", face_of(mesh, o)));
      }
    }
  }
  return {};
}

/// Removes the edge of `h`, and the face of opposite(h), whose other halfedges get the face of `h`.
/// Either side may be a boundary loop instead: join_face(h) with a boundary halfedge h opens the
/// face behind the edge, with a boundary halfedge opposite(h) it fills that loop.
/// (CGAL: join_face; the drawing is at split_face)
///
/// pre: different loops on the two sides
/// returns: prev(h), or prev(opposite(h)) if h was a loop of one
/// cost: O(halfedges of the face removed); where a boundary is involved, of both loops, and
///       O(valence) for each vertex of them
/// inverse: split_face(prev(h), prev(opposite(h)))
/// errors: those of check_join_face
template <Editable Mesh>
requires DeletesFaces<Mesh>
[[nodiscard]] Result<Halfedge> join_face(Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> can = check_join_face(mesh, h); !can) return can;
  const Halfedge o = mesh.opposite(h);
  const Halfedge before_h = mesh.prev(h);
  const Halfedge before_o = mesh.prev(o);
  const Face kept = face_of(mesh, h);
  const Face gone = face_of(mesh, o);
  const Halfedge returned = before_h == h ? before_o : before_h;

  for (Halfedge other = mesh.next(o); other != o; other = mesh.next(other)) {
    set_face(mesh, other, kept);
  }
  erase_edge(mesh, h);
  replace_in_face(mesh, kept, h, returned);
  release_face(mesh, gone);
  if (!kept.valid() || !gone.valid()) mend_anchors_of_loop(mesh, returned);
  return returned;
}

/// Whether make_hole(h) can be done: else not-a-halfedge; boundary-halfedge; edge-without-face, if
/// an edge of the face has no other face.
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] Result<void> check_make_hole(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  if (is_boundary(mesh, h)) return on_boundary(h);
  for (const Halfedge on_loop : mesh.loop_ccw(h)) {
    const Halfedge other = mesh.opposite(on_loop);
    if (is_boundary(mesh, other) || mesh.face(other) == mesh.face(h)) {
      return edge_without_face(on_loop, sentence::of("once {} is removed", mesh.face(h)));
    }
  }
  return {};
}

/// Removes the face of `h`: its edges stay, its loop becomes a boundary loop. (CGAL: make_hole)
///
/// pre: h has a face, each edge of which has another face on its other side
/// returns: h. cost: O(degree). inverse: fill_hole(h)
/// errors: those of check_make_hole
template <Editable Mesh>
requires StoresFaces<Mesh> && StoresFaceHalfedges<Mesh>
[[nodiscard]] Result<Halfedge> make_hole(Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> can = check_make_hole(mesh, h); !can) return can;
  mesh.release(mesh.face(h));
  set_face_of_loop(mesh, h, Face{});
  if constexpr (StoresAnchors<Mesh>) {
    for (Halfedge on_loop = h;;) {
      const Vertex v = mesh.from_vertex(on_loop);
      if (!mesh.is_boundary(v)) mesh.set_vertex_halfedge(v, on_loop);
      on_loop = mesh.next(on_loop);
      if (on_loop == h) break;
    }
  }
  return h;
}

/// Whether fill_hole(h) can be done: else not-a-halfedge, not-a-boundary-halfedge.
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] Result<void> check_fill_hole(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  if (!is_boundary(mesh, h)) return off_boundary(h, mesh.face(h));
  return {};
}

/// A new face on the boundary loop of `h`. (CGAL: fill_hole)
///
/// pre: h has no face
/// returns: h. cost: O(sum of the valences along the loop). inverse: make_hole(h)
/// errors: those of check_fill_hole, out-of-memory
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] Result<Halfedge> fill_hole(Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> can = check_fill_hole(mesh, h); !can) return can;
  if (!make_room(mesh, 0, 0, 1)) return no_memory("a face");
  make_face(mesh, h);
  mend_anchors_of_loop(mesh, h);
  return h;
}

}  // namespace halfedge::decorator
