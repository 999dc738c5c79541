#pragma once

#include <halfedge/operations/link_condition.h>
#include <halfedge/operations/parameter.h>
#include <halfedge/operations/requirements.h>

#include <optional>

namespace halfedge::operations {

namespace internal {

/// Attributes of the point at (1 - t) a + t b that becomes of both ends.
template <class Mesh>
void blend_ends(Mesh& mesh, const CollapseSite& site, Halfedge before_h, Halfedge before_o,
                double t) {
  if (t != 1) mesh.blend_attributes(site.b, site.a, site.b, t);
  if (mesh.attributes().of(ItemKind::kHalfedge).empty()) return;
  mesh.contract_corners(site.h, before_h, before_o, t, [&](const auto& move) {
    const auto move_all = [&](Halfedge first, Attributes::EdgeEnd end) {
      for (Halfedge in = mesh.next_on_vertex(first); in != first; in = mesh.next_on_vertex(in)) {
        move(in.index(), end);
      }
    };
    move_all(site.o, Attributes::EdgeEnd::kFrom);
    if (t != 1) move_all(site.h, Attributes::EdgeEnd::kTo);  // else the corners at b stay
  });
}

/// The edges of a that stay lead to b. Clockwise after that of h the first one vanishes with a
/// triangle on the right, the last one with a triangle on the left.
template <class Mesh>
void move_edges(Mesh& mesh, const CollapseSite& site, Halfedge before_h) {
  const Halfedge last = site.left_is_triangle ? before_h : site.o;
  Halfedge in = mesh.next_on_vertex(site.o);
  if (site.right_is_triangle && in != last) in = mesh.next_on_vertex(in);
  const auto writer = mesh.writer();
  for (; in != last; in = mesh.next_on_vertex(in)) writer.set_to_vertex(in, site.b);
}

/// If b was inside, or on the boundary with this edge only, it takes over the anchor of a.
template <class Mesh>
void move_anchor(Mesh& mesh, const CollapseSite& site) {
  const Halfedge anchor_of_a = mesh.vertex_halfedge(site.a);
  const Halfedge anchor_of_b = mesh.vertex_halfedge(site.b);
  if (anchor_of_b != site.o && mesh.is_boundary(anchor_of_b)) return;
  if (mesh.is_boundary(anchor_of_a)) {
    mesh.set_vertex_halfedge(site.b, anchor_of_a == site.h ? site.after_h : anchor_of_a);
  } else if (anchor_of_b == site.o) {
    mesh.set_vertex_halfedge(site.b, site.after_h);
  }
}

/// Takes away the triangle beside a contracted edge, of which two edges are left: `kept`, at b, and
/// `gone`, at a. The edge of `kept` takes the place of the other one in the face beyond that, after
/// `before`.
template <class Mesh>
void zip_triangle(Mesh& mesh, const CollapseSite& site, Halfedge kept, Halfedge gone,
                  Halfedge before) {
  const auto end_that_stays = [&](Vertex v) { return v == site.a ? site.b : v; };
  const Halfedge beyond = mesh.opposite(gone);
  const Face f = mesh.face(beyond);
  const Halfedge after = mesh.next(beyond);
  steps::replace_anchor(mesh, end_that_stays(mesh.from_vertex(gone)), gone, mesh.opposite(kept));
  steps::replace_anchor(mesh, end_that_stays(mesh.from_vertex(beyond)), beyond, kept);
  mesh.release(mesh.face(kept));
  mesh.copy_corner(kept, beyond);
  if (mesh.history() != nullptr) [[unlikely]] {
    mesh.note_next(before);
    mesh.note_loop_links(kept);
    mesh.note_prev(after);
  }
  const auto writer = mesh.unnoted_writer();
  writer.link(before, kept);
  writer.link(kept, after);
  writer.set_face(kept, f);
  steps::replace_in_face(mesh, f, beyond, kept);
  mesh.release(mesh.edge(gone));
}

}  // namespace internal

/// Contracts the edge of `h`: a = from_vertex(h) disappears into b = to_vertex(h). Triangles beside
/// the edge vanish: of their other two edges the one at b stays. Larger faces lose a corner. The
/// boundary may be anywhere. (CGAL: collapse_edge; OpenMesh: collapse)
///
///          b                   b
///        ´ | `               ´   `
///     c  h |   d     =>    c       d        one of the two is missing at a boundary edge
///        ` | ´               ´ | `
///          a                     the edges of a
///        ´ | `
///
/// attributes: b stays where it is with what it has; given a position, it moves there, and gets the
///             blend of a and b at the closest point of the edge. The edges c-b and d-b keep their
///             own, those of a too, in their new place. Corners at a get the value that the corner
///             beside h has at b, if they have the same value as that at a; others, beyond a seam
///             of textures, keep theirs
/// returns: b
/// cost: O(valence of a), and finding prev where it isn't stored; and the check
/// inverse: split_vertex(next(h), opposite(prev(opposite(h)))), these taken before; where there was
///          no triangle, with SplitSide::kCorner
/// errors: those of check_collapse
template <EditableSurface Mesh>
[[nodiscard]] Result<Vertex> collapse(Mesh& mesh, Halfedge h,
                                      const std::optional<Point>& position = {},
                                      LinkCondition condition = LinkCondition::kStrict) {
  if (Result<void> live = check_live(mesh, h); !live) return live;
  const internal::CollapseSite site(mesh, h);
  if (Result<void> can = internal::check_site(mesh, site, condition); !can) return can;
  const Halfedge o = site.o;
  const Halfedge before_h = mesh.prev(h);
  const Halfedge before_o = mesh.prev(o);
  if (mesh.attributes().has_any()) {
    internal::blend_ends(mesh, site, before_h, before_o,
                         internal::parameter_on(mesh, h, position, 1));
  }
  internal::move_to(mesh, site.b, position);

  internal::move_edges(mesh, site, before_h);
  internal::move_anchor(mesh, site);
  // Taken while all laps are closed: prev may have to be searched for. Where a has valence two o is
  // what comes before, and vanishes.
  const auto before_beyond = [&](bool is_triangle, Halfedge gone) {
    const Halfedge before = is_triangle ? mesh.prev(mesh.opposite(gone)) : Halfedge{};
    return before == o ? before_o : before;
  };
  const Halfedge before_left = before_beyond(site.left_is_triangle, before_h);
  const Halfedge before_right = before_beyond(site.right_is_triangle, site.after_o);
  if (!site.left_is_triangle) {
    mesh.link(before_h, site.after_h);
    steps::replace_in_face(mesh, mesh.face(h), h, site.after_h);
  }
  if (!site.right_is_triangle) {
    mesh.link(before_o, site.after_o);
    steps::replace_in_face(mesh, mesh.face(o), o, before_o);
  }
  mesh.release(mesh.edge(h));
  mesh.release(site.a);
  if (site.left_is_triangle) {
    internal::zip_triangle(mesh, site, site.after_h, before_h, before_left);
  }
  if (site.right_is_triangle) {
    internal::zip_triangle(mesh, site, before_o, site.after_o, before_right);
  }
  return site.b;
}

}  // namespace halfedge::operations
