#pragma once

#include <halfedge/decorator/loops.h>
#include <halfedge/operations/merges.h>
#include <halfedge/operations/requirements.h>
#include <halfedge/operations/surgery_refusals.h>

#include <cstddef>
#include <span>

namespace halfedge::operations {

/// Whether split_loop(cycle) can be done: else not-a-halfedge; not-a-cycle, if a halfedge doesn't
/// begin where the one before it ends, if there is none, or if it goes to and fro on one edge;
/// repeated-vertex; out-of-memory. cost: O(n log n)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_split_loop(const Mesh& mesh, std::span<const Halfedge> cycle) {
  return decorator::check_split_loop(mesh, cycle);
}

/// Cuts the surface open along a cycle of n halfedges and closes both ends with a face of degree n.
/// If the cycle separates the surface this makes two components of it; if not, it cuts a handle.
/// (CGAL: split_loop, for n = 3; the drawing is at decorator::split_loop)
///
/// attributes: copies of vertices and edges, which belong to the left of the cycle, have those they
///             are copied from; the two faces have the defaults
/// returns: a halfedge of the second new face, opposite the copy of cycle[0]; the first new face is
///          that of cycle[0]
/// cost: O(sum of the valences along the cycle + n log n). inverse: join_loop(cycle[0], returned)
/// errors: those of check_split_loop, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Halfedge> split_loop(Mesh& mesh, std::span<const Halfedge> cycle) {
  return decorator::split_loop(mesh, cycle);
}

/// Whether join_loop(h, g) can be done: else not-a-halfedge; same-loop; different-degrees;
/// repeated-vertex, if a vertex occurs twice in the two loops, or a face has two that would become
/// one; edge-without-face; edge-exists, if two that would become one are joined; duplicate-edge, if
/// they are joined to a third; last-edge, of a segment; out-of-memory. cost: as glue_path along the
/// loops
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_join_loop(const Mesh& mesh, Halfedge h, Halfedge g) {
  if (Result<void> can = decorator::check_join_loop(mesh, h, g); !can) return can;
  Array<internal::Merge> merges;
  Halfedge on_g = g;
  for (const Halfedge on_h : mesh.loop_ccw(h)) {
    const Halfedge before_g = mesh.prev(on_g);
    if (!merges.push_back({.kept = mesh.to_vertex(on_h),
                           .gone = mesh.from_vertex(on_g),
                           .kept_edges = {mesh.edge(on_h), mesh.edge(mesh.next(on_h))},
                           .gone_edges = {mesh.edge(on_g), mesh.edge(before_g)}})) {
      return refusals::no_memory("the vertices of the loops");
    }
    on_g = before_g;
  }
  Array<Index> scratch;
  if (!scratch.resize(merges.size())) {
    return refusals::no_memory("the vertices of the loops");
  }
  return internal::check_merges(mesh.links(), merges.span(), scratch.span(), mesh.face(h),
                                mesh.face(g));
}

/// Glues the loop of `h` to that of `g`, which runs the other way: the edge of h to that of g,
/// next(h) to prev(g), and so on. The faces of both loops disappear, if they have any, and the
/// vertices and edges of the loop of g. Where the two lie in one component this adds a handle;
/// where not, it makes one component of two. (CGAL: join_loop; the drawing is at
/// decorator::split_loop)
///
/// attributes: those of the loop of h stay; the corners on it are those of the faces it gets
/// returns: h. cost: as check_join_loop. inverse: split_loop(h, next(h), ...), next as before;
///          of two boundary loops cut_path of the same, or that and make_hole
/// errors: those of check_join_loop, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Halfedge> join_loop(Mesh& mesh, Halfedge h, Halfedge g) {
  if (Result<void> can = check_join_loop(mesh, h, g); !can) return can;
  return decorator::join_loop(mesh, h, g);
}

/// Whether bridge(h, g) can be done: else not-a-halfedge; same-loop; different-degrees;
/// repeated-vertex, if a vertex occurs twice in the two loops; edge-exists, if two that the tube
/// would join are joined; out-of-memory. cost: O(n log n + sum of the valences)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_bridge(const Mesh& mesh, Halfedge h, Halfedge g) {
  if (Result<void> can = decorator::internal::check_two_loops(mesh, h, g); !can) return can;
  Halfedge on_g = g;
  for (const Halfedge on_h : mesh.loop_ccw(h)) {
    const Vertex a = mesh.to_vertex(on_h);
    const Vertex b = mesh.from_vertex(on_g);
    if (const Edge existing = mesh.find_edge(a, b); existing.valid()) {
      return edge_exists(a, b, existing);
    }
    on_g = mesh.prev(on_g);
  }
  return {};
}

/// Joins the loops of `h` and `g`, faces or boundary loops of n edges each, by a tube of n quads,
/// the first between h and g; the two faces, if there are any, disappear. Where the loops lie in
/// one component this adds a handle; where not, it makes one component of two.
///
///      ---h---> *             ---h---> *
///                                ^     |
///                      =>        |     | s         next(h) == s, next(s) == g
///                                |     v
///      <--g---- *             <--g---- *
///
/// attributes: the quads have those of the face of h, else of g, else the defaults, as the n new
///             edges; corners are those that were there
/// returns: s, the new halfedge from to_vertex(h) to from_vertex(g)
/// cost: O(n log n + sum of the valences)
/// inverse: remove_bridge(s), and make_hole where there was no face
/// errors: those of check_bridge, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Halfedge> bridge(Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace refusals;
  using namespace steps;
  if (Result<void> can = check_bridge(mesh, h, g); !can) return can;
  Index n = 0;
  for ([[maybe_unused]] const Halfedge on_loop : mesh.loop_ccw(h)) ++n;
  struct Quad {
    Halfedge h;
    Halfedge g;
    Halfedge spoke = {};  // from to_vertex(h) to from_vertex(g)
  };
  Array<Quad> quads;
  if (!quads.reserve(n) || !make_room(mesh, 0, n, n)) return no_memory("the tube");
  Halfedge on_g = g;
  for (const Halfedge on_h : mesh.loop_ccw(h)) {
    (void)quads.push_back({on_h, on_g});
    on_g = mesh.prev(on_g);
  }

  const Face of_h = mesh.face(h);
  const Face of_g = mesh.face(g);
  const Face like = of_h.valid() ? of_h : of_g;
  for (Quad& quad : quads) {
    quad.spoke = mesh.new_edge(mesh.to_vertex(quad.h), mesh.from_vertex(quad.g));
    // The corner where g begins is that of the loop of g; the one where the next h begins, of h.
    mesh.copy_corner(quad.spoke, mesh.prev(quad.g));
    mesh.copy_corner(mesh.opposite(quad.spoke), quad.h);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Quad& quad = quads[i];
    const Halfedge closing = mesh.opposite(quads[i == 0 ? n - 1 : i - 1].spoke);
    mesh.link(quad.h, quad.spoke);
    mesh.link(quad.spoke, quad.g);
    mesh.link(quad.g, closing);
    mesh.link(closing, quad.h);
  }
  for (const Quad& quad : quads) make_face(mesh, quad.h, like);
  release_face(mesh, of_h);
  release_face(mesh, of_g);
  for (const Quad& quad : quads) {
    mend_anchor(mesh, quad.spoke);
    mend_anchor(mesh, mesh.opposite(quad.spoke));
  }
  return quads[0].spoke;
}

/// Whether remove_bridge(s) can be done: else not-a-halfedge; boundary-edge or not-a-quad, if there
/// is no ring of quads; degree-below-three, if it consists of two; repeated-vertex, if it meets
/// itself; out-of-memory. cost: O(n log n) of n quads
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_remove_bridge(const Mesh& mesh, Halfedge s) {
  if (Result<void> live = check_live(mesh, s); !live) return live;
  Array<Vertex> vertices;
  Halfedge spoke = s;
  do {
    for (const Halfedge side : {spoke, mesh.opposite(spoke)}) {
      if (mesh.is_boundary(side)) return is_boundary_edge(mesh.edge(spoke), side);
    }
    const Face f = mesh.face(spoke);
    if (const Index degree = mesh.degree(f); degree != 4) return not_a_quad(f, degree);
    if (!vertices.push_back(mesh.from_vertex(spoke)) ||
        !vertices.push_back(mesh.to_vertex(spoke))) {
      return refusals::no_memory("the vertices of the ring");
    }
    spoke = mesh.next(mesh.next(mesh.opposite(spoke)));
  } while (spoke != s);
  if (vertices.size() < 6) return ring_too_short(mesh.face(s), mesh.face(mesh.opposite(s)));
  if (const Vertex repeated = sort_and_find_repeated(vertices.span()); repeated.valid()) {
    return repeated_on_ring(mesh.edge(s), repeated);
  }
  return {};
}

/// Removes a ring of quads with the edges between them, of which that of `s` is one, and closes
/// both ends with a face. (The drawing is at bridge.)
///
/// attributes: the two faces have those of the face of s
/// returns: h, which was before s: a halfedge of the first new face; that of the second is what was
///          next(s)
/// cost: O(n log n + sum of the valences) of n quads. inverse: bridge(h, next(s) as before)
/// errors: those of check_remove_bridge, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Halfedge> remove_bridge(Mesh& mesh, Halfedge s) {
  using namespace refusals;
  using namespace steps;
  if (Result<void> can = check_remove_bridge(mesh, s); !can) return can;
  // The two faces take slots of the quads, but their attributes must be there at the same time.
  if (!make_room(mesh, 0, 0, 2)) return no_memory("two faces");
  const Face like = mesh.face(s);
  struct Quad {
    Halfedge h;
    Halfedge spoke;
    Halfedge g;
  };
  Array<Quad> quads;
  Halfedge spoke = s;
  do {
    const Halfedge on_g = mesh.next(spoke);
    if (!quads.push_back({mesh.next(mesh.next(on_g)), spoke, on_g})) return no_memory("the ring");
    spoke = mesh.next(mesh.next(mesh.opposite(spoke)));
  } while (spoke != s);

  for (std::size_t i = 0; i < quads.size(); ++i) {
    const Quad& quad = quads[i];
    const Quad& following = quads[i + 1 == quads.size() ? 0 : i + 1];
    replace_anchor(mesh, mesh.from_vertex(quad.spoke), quad.spoke, following.h);
    replace_anchor(mesh, mesh.to_vertex(quad.spoke), mesh.opposite(quad.spoke), quad.g);
    mesh.link(quad.h, following.h);
    mesh.link(following.g, quad.g);
  }
  for (const Quad& quad : quads) {
    if (const Face f = mesh.face(quad.spoke); f != like) mesh.release(f);
    mesh.release(mesh.edge(quad.spoke));
  }
  make_face(mesh, quads[0].h, like);
  make_face(mesh, quads[0].g, like);
  mesh.release(like);
  return quads[0].h;
}

}  // namespace halfedge::operations
