#pragma once

#include <halfedge/operations/fans.h>
#include <halfedge/operations/merges.h>
#include <halfedge/operations/requirements.h>
#include <halfedge/operations/surgery_refusals.h>

#include <array>
#include <cstddef>
#include <span>

namespace halfedge::operations {

namespace internal {

/// How boundary loops run on where `in` ends and `out` begins, once both are glued and gone.
struct Gap {
  Halfedge before[2] = {};
  Halfedge after[2] = {};
};

template <class Mesh>
[[nodiscard]] Gap plan_gap(const Mesh& mesh, Halfedge in, Halfedge out) {
  const Halfedge after = mesh.next(in);
  if (after == out) return {};  // the gap between them closes
  const Halfedge before = mesh.prev(out);
  if (mesh.to_vertex(in) != mesh.from_vertex(out)) return {{before}, {after}};
  // Two fans of a pinched vertex become one, which its other fans follow.
  const Halfedge last = end_of_fan(mesh, out);
  return {{last, before}, {after, mesh.next(last)}};
}

template <class Mesh>
void link_gap(Mesh& mesh, const Gap& gap) {
  for (const int i : {0, 1}) {
    if (gap.before[i].valid()) mesh.link(gap.before[i], gap.after[i]);
  }
}

/// All that leads where `in` does, leads to `kept`.
template <class Mesh>
void set_vertex_of_orbit(Mesh& mesh, Halfedge in, Vertex kept) {
  Halfedge arriving = in;
  do {
    mesh.set_to_vertex(arriving, kept);
    arriving = mesh.next_on_vertex(arriving);
  } while (arriving != in);
}

/// glue, of halfedges that are known to fit.
template <class Mesh>
void glue_edges(Mesh& mesh, Halfedge h, Halfedge g) {
  const Halfedge outer = mesh.opposite(g);  // whose place h takes
  const Halfedge before = mesh.prev(outer);
  const Halfedge after = mesh.next(outer);
  const Gap at_end = plan_gap(mesh, h, g);
  const Gap at_begin = plan_gap(mesh, g, h);
  const Vertex gone[] = {mesh.to_vertex(g), mesh.from_vertex(g)};
  const Vertex kept[] = {mesh.from_vertex(h), mesh.to_vertex(h)};
  if (gone[0] != kept[0]) set_vertex_of_orbit(mesh, g, kept[0]);
  if (gone[1] != kept[1]) set_vertex_of_orbit(mesh, outer, kept[1]);

  link_gap(mesh, at_end);
  link_gap(mesh, at_begin);
  mesh.link(before, h);
  mesh.link(h, after);
  mesh.set_face(h, mesh.face(outer));
  mesh.copy_corner(h, outer);
  steps::replace_in_face(mesh, mesh.face(outer), outer, h);
  mesh.release(mesh.edge(g));
  for (const int i : {0, 1}) {
    if (gone[i] != kept[i]) mesh.release(gone[i]);
  }
  // Where the gap stays open its other side is on the boundary: nothing to be searched for.
  if (at_begin.after[0].valid()) {
    steps::replace_anchor(mesh, kept[0], h, at_begin.after[0]);
  }
  if (at_end.after[0].valid()) {
    steps::replace_anchor(mesh, kept[1], g, at_end.after[0]);
  }
  steps::mend_anchor(mesh, h);
  steps::mend_anchor(mesh, mesh.opposite(h));
}

/// Whether the fans at the vertex where `in` ends and `out` begins, if it is one, can be joined.
template <class Mesh>
[[nodiscard]] Result<void> check_fans(const Mesh& mesh, Halfedge in, Halfedge out) {
  const Vertex v = mesh.to_vertex(in);
  if (v != mesh.from_vertex(out) || mesh.next(in) == out) return {};
  if (end_of_fan(mesh, out) == in) return would_close_fan(v, in, out);
  return {};
}

/// What n edges from h and from g on merge, for check_merges: returns how many merges, at most
/// n + 1, there are in `merges`. pre: from_vertex of the first two differ
template <class Mesh>
[[nodiscard]] std::size_t list_merges(const Mesh& mesh, Halfedge h, Halfedge g, std::size_t n,
                                      std::span<Merge> merges) {
  std::size_t count = 0;
  Merge merge{.kept = mesh.from_vertex(h), .gone = mesh.to_vertex(g)};
  for (std::size_t i = 0; i < n; ++i) {
    merge.kept_edges[1] = mesh.edge(h);
    merge.gone_edges[1] = mesh.edge(g);
    if (merge.kept != merge.gone || i > 0) merges[count++] = merge;
    merge = {.kept = mesh.to_vertex(h),
             .gone = mesh.from_vertex(g),
             .kept_edges = {mesh.edge(h)},
             .gone_edges = {mesh.edge(g)}};
    h = mesh.next(h);
    g = mesh.prev(g);
  }
  if (merge.kept != merge.gone) merges[count++] = merge;
  return count;
}

template <class Mesh>
[[nodiscard]] Result<void> check_glue(const Mesh& mesh, Halfedge h, Halfedge g, std::size_t n,
                                      std::span<Merge> merges, std::span<Index> scratch) {
  Halfedge last_h = h;
  Halfedge last_g = g;
  for (std::size_t i = 1; i < n; ++i) {
    last_h = mesh.next(last_h);
    last_g = mesh.prev(last_g);
  }
  if (mesh.to_vertex(last_h) == mesh.from_vertex(h)) return repeated_on_seam(mesh.from_vertex(h));
  const std::size_t count = list_merges(mesh, h, g, n, merges);
  if (Result<void> can = check_merges(mesh.links(), merges.first(count), scratch); !can) return can;
  if (Result<void> can = check_fans(mesh, last_h, last_g); !can) return can;
  return check_fans(mesh, g, h);
}

template <class Mesh>
[[nodiscard]] Result<void> check_boundary_halfedges(const Mesh& mesh, Halfedge h, Halfedge g) {
  for (const Halfedge given : {h, g}) {
    if (Result<void> live = check_live(mesh, given); !live) return live;
    if (!mesh.is_boundary(given)) {
      return refusals::off_boundary(given, mesh.face(given));
    }
  }
  return {};
}

}  // namespace internal

/// Whether glue(h, g) can be done: else not-a-halfedge; not-a-boundary-halfedge; repeated-vertex,
/// if h and g begin or end at one vertex, or a face has two vertices that would become one;
/// edge-exists, if such two are joined; duplicate-edge, if they are joined to a third vertex;
/// pinched-vertex, if the faces at a vertex that `h` and `g` share would close around it beside
/// others. cost: as glue
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_glue(const Mesh& mesh, Halfedge h, Halfedge g) {
  if (Result<void> can = internal::check_boundary_halfedges(mesh, h, g); !can) return can;
  std::array<internal::Merge, 2> merges;
  std::array<Index, 2> scratch;
  return internal::check_glue(mesh, h, g, 1, merges, scratch);
}

/// Makes one edge of two on the boundary: `h`, and `g`, which runs the other way. Their ends become
/// one, in so far as they aren't: from_vertex(g) becomes to_vertex(h), to_vertex(g) becomes
/// from_vertex(h). With next(h) == g this closes a gap like a zipper.
///
///          |   a'       |                         |             |
///       ---a   ^        *---                   ---a-------------*---
///          |   |        |                         |  |          |
///          h | | g      |          =>             | h|          |      edge(h) stays,
///          | v |        |                         |  v          |      a' and b' go
///       ---b   b'-------*---                   ---b-------------*---
///
/// attributes: those of edge(h) and its ends stay, with the positions; the corner where h ends is
///             that of the face it gets
/// returns: the edge of h
/// cost: O(product of the valences of two vertices that become one, degrees of the faces there)
/// inverse: cut(opposite(h)), where none of the ends is pinched
/// errors: those of check_glue
template <EditableSurface Mesh>
[[nodiscard]] Result<Edge> glue(Mesh& mesh, Halfedge h, Halfedge g) {
  if (Result<void> can = check_glue(mesh, h, g); !can) return can;
  internal::glue_edges(mesh, h, g);
  return mesh.edge(h);
}

/// Whether glue_path(h, g, n) can be done: else as check_glue says, not-a-path if n is 0, or
/// out-of-memory.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_glue_path(const Mesh& mesh, Halfedge h, Halfedge g,
                                           std::size_t n) {
  if (Result<void> can = internal::check_boundary_halfedges(mesh, h, g); !can) return can;
  if (n == 0) return empty_path();
  Array<internal::Merge> merges;
  Array<Index> scratch;
  if (n > mesh.halfedge_count()) return repeated_on_seam(mesh.to_vertex(h));
  if (!merges.resize(n + 1, internal::Merge{}) || !scratch.resize(n + 1)) {
    return refusals::no_memory("the vertices to be glued");
  }
  return internal::check_glue(mesh, h, g, n, merges.span(), scratch.span());
}

/// Glues n edges at once: `h` to `g`, next(h) to prev(g), and so on. What lies between may be a
/// slit, each edge of which, glued alone, would be a second one between two vertices. Whole
/// boundary loops are glued by join_loop.
///
/// attributes: as glue
/// returns: the edge of h. cost: as n times glue, and O(n log n)
/// inverse: cut_path along the same edges, from the last on, where none of their ends is pinched
/// errors: those of check_glue_path
template <EditableSurface Mesh>
[[nodiscard]] Result<Edge> glue_path(Mesh& mesh, Halfedge h, Halfedge g, std::size_t n) {
  if (Result<void> can = check_glue_path(mesh, h, g, n); !can) return can;
  Halfedge on_h = h;
  for (std::size_t i = 0; i < n; ++i) {
    const Halfedge next_h = mesh.next(on_h);
    const Halfedge next_g = mesh.prev(g);
    internal::glue_edges(mesh, on_h, g);
    on_h = next_h;
    g = next_g;
  }
  return mesh.edge(h);
}

}  // namespace halfedge::operations
