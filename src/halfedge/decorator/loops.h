#pragma once

#include <halfedge/decorator/edit.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <array>
#include <cstddef>
#include <span>

namespace halfedge::decorator {

/// Whether split_loop(cycle) can be done: else not-a-halfedge; not-a-cycle, if a halfedge doesn't
/// begin where the one before it ends, if there is none, or if it goes to and fro on one edge;
/// repeated-vertex; out-of-memory. cost: O(n log n)
template <Editable Mesh>
[[nodiscard]] Result<void> check_split_loop(const Mesh& mesh, std::span<const Halfedge> cycle) {
  using namespace internal;
  if (cycle.empty())
    return refusal("not-a-cycle", "the cycle is empty, expected one halfedge or more");
  Array<Vertex> vertices;
  for (const Halfedge h : cycle) {
    if (Result<void> live = check_live(mesh, h); !live) return live;
    if (!vertices.push_back(mesh.to_vertex(h))) return no_memory("the vertices of the cycle");
  }
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Halfedge h = cycle[i];
    const Halfedge following = cycle[(i + 1) % cycle.size()];
    if (mesh.to_vertex(h) != mesh.from_vertex(following)) {
      return refusal("not-a-cycle",
                     sentence::of("{} leads to {}, but the next in the cycle, {}, leaves {}", h,
                                  mesh.to_vertex(h), following, mesh.from_vertex(following)),
                     halfedges_of({h, following}));
    }
    if (following == mesh.opposite(h)) {
      return refusal(
          "not-a-cycle",
          sentence::of("{} and {} are the two sides of one edge, expected different edges", h,
                       following),
          halfedges_of({h, following}));
    }
  }
  if (const Vertex repeated = sort_and_find_repeated(vertices.span()); repeated.valid()) {
    return refusal(
        "repeated-vertex",
        sentence::of("the cycle passes {} more than once, expected different vertices", repeated),
        {.vertices = {repeated.index()}});
  }
  return {};
}

/// Cuts the surface open along a cycle of n halfedges and closes both ends with a face of degree n:
/// one on the left of the cycle itself, one on the right of a copy of it, which takes its place on
/// the side that was on its left. If the cycle separates the surface this makes two components of
/// it; if not, it takes away a handle. (CGAL: split_loop, for n = 3)
///
///        left of the cycle               left of the cycle
///     --c[0]--> --c[1]-->        =>     --c'[0]--> --c'[1]-->    new vertices, edges
///          right of it                  . . . . . . . . . . .    two new faces
///                                       --c[0]--> ---c[1]-->
///                                          right of it
///
/// Copies of vertices lie where the vertices do; they and the copies of edges have the same
/// attributes.
///
/// pre: from_vertex(cycle[i + 1]) == to_vertex(cycle[i]), all vertices and edges different
/// returns: opposite(c'[0]), a halfedge of the second new face; the first is that of cycle[0]
/// cost: O(sum of the valences along the cycle + n log n)
/// inverse: join_loop(cycle[0], returned)
/// errors: those of check_split_loop, out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> split_loop(Mesh& mesh, std::span<const Halfedge> cycle) {
  using namespace internal;
  if (Result<void> can = check_split_loop(mesh, cycle); !can) return can;
  const std::size_t n = cycle.size();
  struct Cut {
    Halfedge copy;    // c'[i]
    Halfedge before;  // prev(c[i]) and next(c[i])
    Halfedge after;
    Vertex vertex;  // the copy of to_vertex(c[i])
  };
  Array<Cut> cuts;
  if (!cuts.resize(n, Cut{}) || !make_room(mesh, Index(n), Index(n), 2)) {
    return no_memory("a copy of the cycle");
  }

  for (std::size_t i = 0; i < n; ++i) {
    const Halfedge following = cycle[(i + 1) % n];
    cuts[i].vertex = copy_vertex(mesh, mesh.to_vertex(cycle[i]));
    cuts[i].after = mesh.next(cycle[i]);
    Halfedge in = cycle[i];
    while (mesh.next(in) != following) {  // the edges on the left of the cycle, clockwise
      in = mesh.next_on_vertex(in);
      mesh.set_to_vertex(in, cuts[i].vertex);
    }
    cuts[(i + 1) % n].before = in;
  }
  for (std::size_t i = 0; i < n; ++i) {
    cuts[i].copy = new_edge_like(mesh, cuts[(i + n - 1) % n].vertex, cuts[i].vertex, cycle[i]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    if (cuts[i].after == cycle[j]) {
      mesh.link(cuts[i].copy, cuts[j].copy);
    } else {
      mesh.link(cuts[i].copy, cuts[i].after);
      mesh.link(cuts[j].before, cuts[j].copy);
    }
    mesh.link(cycle[i], cycle[j]);
    mesh.link(mesh.opposite(cuts[j].copy), mesh.opposite(cuts[i].copy));
    set_face(mesh, cuts[i].copy, face_of(mesh, cycle[i]));
    replace_in_face(mesh, face_of(mesh, cycle[i]), cycle[i], cuts[i].copy);
  }
  make_face(mesh, cycle[0]);
  make_face(mesh, mesh.opposite(cuts[0].copy));
  for (std::size_t i = 0; i < n; ++i) {
    mend_anchor(mesh, mesh.opposite(cycle[i]));
    mend_anchor(mesh, cuts[(i + 1) % n].copy);
  }
  return mesh.opposite(cuts[0].copy);
}

/// The same for the cycle h, i, j.
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> split_loop(Mesh& mesh, Halfedge h, Halfedge i, Halfedge j) {
  return split_loop(mesh, std::array<Halfedge, 3>{h, i, j});
}

namespace internal {

/// Whether `h` and `g` lie in two loops of as many halfedges whose vertices are all different.
template <Editable Mesh>
[[nodiscard]] Result<void> check_two_loops(const Mesh& mesh, Halfedge h, Halfedge g) {
  Array<Vertex> vertices;
  for (const Halfedge given : {h, g}) {
    if (Result<void> live = check_live(mesh, given); !live) return live;
  }
  if (is_one_loop(mesh, h, g)) return in_same_loop(h, g);
  std::size_t degrees[] = {0, 0};
  for (const int side : {0, 1}) {
    for (const Halfedge on_loop : mesh.loop_ccw(side == 0 ? h : g)) {
      if (!vertices.push_back(mesh.to_vertex(on_loop)))
        return no_memory("the vertices of the loops");
      ++degrees[side];
    }
  }
  if (degrees[0] != degrees[1]) {
    return refusal(
        "different-degrees",
        sentence::of("the loop of {} has {} halfedges and that of {} has {}, expected as many", h,
                     degrees[0], g, degrees[1]),
        halfedges_of({h, g}));
  }
  if (const Vertex repeated = sort_and_find_repeated(vertices.span()); repeated.valid()) {
    return refusal(
        "repeated-vertex",
        sentence::of("{} occurs twice in the loops of {} and {}, expected different vertices",
                     repeated, h, g),
        {.vertices = {repeated.index()}, .halfedges = {h.index(), g.index()}});
  }
  return {};
}

}  // namespace internal

/// Whether join_loop(h, g) can be done: else not-a-halfedge; same-loop; different-degrees;
/// repeated-vertex, if a vertex occurs twice in the two loops; edge-without-face; last-edge, of a
/// segment; out-of-memory. cost: O(n log n) of loops of n halfedges
template <Editable Mesh>
[[nodiscard]] Result<void> check_join_loop(const Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  if (Result<void> can = check_two_loops(mesh, h, g); !can) return can;
  for (const Halfedge given : {h, g}) {
    if (mesh.next(given) == mesh.opposite(given) && mesh.next(mesh.next(given)) == given) {
      return last_edge(given, "its two ends");
    }
  }
  Halfedge on_h = h;
  Halfedge on_g = g;  // its loop runs the other way
  do {
    if (is_boundary(mesh, mesh.opposite(on_h)) && is_boundary(mesh, mesh.opposite(on_g))) {
      return edge_without_face(on_h, sentence::of("once it is glued to {}", mesh.edge(on_g)));
    }
    on_h = mesh.prev(on_h);
    on_g = mesh.next(on_g);
  } while (on_g != g);
  return {};
}

/// Glues the loop of `h` to that of `g`, which runs the other way: the edge of h to that of g,
/// next(h) to prev(g), and so on. The faces of both loops disappear, if they have any, and the
/// vertices and edges of the loop of g. Where the two lie in one component this adds a handle;
/// where not, it makes one component of two. (CGAL: join_loop; the drawing is at split_loop)
///
/// pre: different loops of n halfedges each with 2 n different vertices
/// returns: h. cost: O(sum of the valences along both loops + n log n)
/// inverse: split_loop(h, next(h), ...), where next is that from before
/// errors: those of check_join_loop, out-of-memory
template <Editable Mesh>
requires DeletesFaces<Mesh> && DeletesVertices<Mesh>
[[nodiscard]] Result<Halfedge> join_loop(Mesh& mesh, Halfedge h, Halfedge g) {
  using namespace internal;
  if (Result<void> can = check_join_loop(mesh, h, g); !can) return can;
  struct Seam {
    Halfedge kept = {};    // on the loop of h
    Halfedge outer = {};   // opposite the halfedge on the loop of g, whose place `kept` takes
    Halfedge before = {};  // prev(outer) and next(outer)
    Halfedge after = {};
    Vertex gone = {};  // to_vertex(outer)
  };
  Array<Seam> seams;
  for (const Halfedge on_loop : mesh.loop_ccw(h)) {
    if (!seams.push_back({.kept = on_loop})) return no_memory("the seam");
  }
  const std::size_t n = seams.size();
  Halfedge on_g = g;
  for (std::size_t i = 0; i < n; ++i) {
    seams[(n - i) % n].outer = mesh.opposite(on_g);
    on_g = mesh.next(on_g);
  }

  for (std::size_t i = 0; i < n; ++i) {
    Seam& following = seams[(i + 1) % n];
    seams[i].after = mesh.next(seams[i].outer);
    Halfedge in = seams[i].outer;
    const Vertex kept = mesh.to_vertex(seams[i].kept);
    seams[i].gone = mesh.to_vertex(in);
    do {
      if (mesh.next(in) == following.outer) following.before = in;
      mesh.set_to_vertex(in, kept);
      in = mesh.next_on_vertex(in);
    } while (in != seams[i].outer);
  }
  // Last in, first out: what is made first by split_loop is released last.
  release_face(mesh, face_of(mesh, g));
  release_face(mesh, face_of(mesh, h));
  for (std::size_t i = 0; i < n; ++i) {
    const Seam& seam = seams[i];
    const Seam& following = seams[(i + 1) % n];
    if (seam.after != following.outer) {
      mesh.link(seam.kept, seam.after);
      mesh.link(following.before, following.kept);
    }
    set_face(mesh, seam.kept, face_of(mesh, seam.outer));
    mesh.copy_corner(seam.kept, seam.outer);
    replace_in_face(mesh, face_of(mesh, seam.outer), seam.outer, seam.kept);
  }
  for (std::size_t i = n; i-- > 0;) {
    mesh.release(mesh.edge(seams[i].outer));
    mesh.release(seams[i].gone);
  }
  for (const Seam& seam : seams) mend_anchor(mesh, seam.kept);
  return h;
}

}  // namespace halfedge::decorator
