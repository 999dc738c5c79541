#pragma once

#include <halfedge/operations/parameter.h>
#include <halfedge/operations/requirements.h>

#include <cstdint>
#include <optional>

namespace halfedge::operations {

/// What fills the gap on one side of the new edge of split_vertex.
enum class SplitSide : std::uint8_t {
  kDefault,   ///< a triangle; on the boundary, a corner
  kTriangle,  ///< a new triangle: the edge there becomes two
  kCorner     ///< nothing: the face, or the boundary loop, gains a corner
};

/// The two sides of split_vertex: of hl, and of hr.
struct SplitSides {
  SplitSide left = SplitSide::kDefault;
  SplitSide right = SplitSide::kDefault;
};

namespace internal {

/// Whether a side with `in_loop` gets a triangle.
template <class Mesh>
[[nodiscard]] bool gets_triangle(const Mesh& mesh, SplitSide side, Halfedge in_loop) {
  if (side == SplitSide::kDefault) return !mesh.is_boundary(in_loop);
  return side == SplitSide::kTriangle;
}

}  // namespace internal

/// Whether split_vertex(hl, hr) can be done. Else:
///
///   not-a-halfedge
///   different-vertices  they don't leave the same vertex
///   loop-edge           one of them leads back to it
///   same-vertex         they are one halfedge, and both of its sides should get a triangle: its
///                       end would be joined to the new vertex twice
///   nothing-between     the new vertex would have no edge but the new one
///   edge-without-face   the new edge would lie on the boundary with both sides
///
/// cost: O(1)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_split_vertex(const Mesh& mesh, Halfedge hl, Halfedge hr,
                                              SplitSides sides = {}) {
  for (const Halfedge given : {hl, hr}) {
    if (Result<void> live = check_live(mesh, given); !live) return live;
  }
  const Vertex v = mesh.from_vertex(hl);
  if (v != mesh.from_vertex(hr)) {
    return leave_different_vertices(hl, v, hr, mesh.from_vertex(hr));
  }
  for (const Halfedge given : {hl, hr}) {
    if (mesh.to_vertex(given) == v) return refusals::is_loop_edge(given, v);
  }
  const bool left = internal::gets_triangle(mesh, sides.left, hl);
  const bool right = internal::gets_triangle(mesh, sides.right, mesh.opposite(hr));
  if (left && right) {
    if (hl == hr) return same_side_twice(hl, mesh.to_vertex(hl));
    return {};
  }
  if (!left && !right && mesh.rotate_cw(hr) == hl) return nothing_between(hl, hr);
  if (!left && !right && mesh.is_boundary(hl) && mesh.is_boundary(mesh.opposite(hr))) {
    return would_be_bare_edge(v, hl, hr);
  }
  return {};
}

namespace internal {

/// `e`, which leads from `a` to `b`, enters the loop of `before` behind it.
template <class Mesh>
void enter_loop(Mesh& mesh, Halfedge e, Halfedge before) {
  const Halfedge after = mesh.next(before);
  mesh.copy_corner(e, before);
  mesh.link(before, e);
  mesh.link(e, after);
  mesh.set_face(e, mesh.face(before));
}

/// The corners of a triangle that was cut off the boundary, where there are none: those of the face
/// beyond the edge of `like`.
template <class Mesh>
void take_corners_from_beyond(Mesh& mesh, Halfedge first, Halfedge second, Halfedge inner,
                              Halfedge like) {
  if (mesh.attributes().of(ItemKind::kHalfedge).empty()) return;
  const Halfedge at_from = mesh.opposite(like);
  const Halfedge at_to = mesh.prev(at_from);
  mesh.copy_corner(first, like == first ? at_to : at_from);
  mesh.copy_corner(second, at_to);
  mesh.copy_corner(inner, at_from);
}

/// Cuts a triangle off: of `first` and `second`, which follow each other in a loop, and a new edge
/// like that of `like`, one of the two. The rest of the loop keeps its face.
/// pre: there is room for it
template <class Mesh>
void make_triangle(Mesh& mesh, Halfedge first, Halfedge second, Halfedge like) {
  const Face f = mesh.face(first);
  const Halfedge before = mesh.prev(first);
  const Halfedge after = mesh.next(second);
  const Vertex from = mesh.from_vertex(first);
  const Vertex to = mesh.to_vertex(second);
  const Halfedge outer = mesh.new_edge(from, to);
  const Halfedge inner = mesh.opposite(outer);
  mesh.copy_attributes(mesh.edge(outer), mesh.edge(like));
  mesh.copy_attributes(outer, like);
  mesh.copy_attributes(inner, mesh.opposite(like));
  mesh.copy_corner(inner, before);
  mesh.link(before, outer);
  mesh.link(outer, after);
  mesh.link(second, inner);
  mesh.link(inner, first);
  mesh.set_face(outer, f);
  for (const Halfedge gone : {first, second}) steps::replace_in_face(mesh, f, gone, outer);
  if (!f.valid()) {
    steps::replace_anchor(mesh, from, first, outer);
    take_corners_from_beyond(mesh, first, second, inner, like);
  }
  const Face beyond = mesh.face(mesh.opposite(like));
  steps::make_face(mesh, inner, f.valid() ? f : beyond);
}

}  // namespace internal

/// A new vertex w beside v = from_vertex(hl) = from_vertex(hr), joined to it by a new edge. The
/// halfedges strictly between hl and hr, counter-clockwise, leave w from now on; all other ones but
/// hl if hl == hr. Two new triangles fill the gap: the edges of hl and hr become two each, of which
/// the old one stays at v. On a side that lies on the boundary there is no triangle, only a new
/// edge in the boundary loop, if `sides` doesn't say otherwise. (CGAL: split_vertex without
/// triangles; OpenMesh: vertex_split)
///
///            v                        v
///       hl ´   ` hr              hl ´ | ` hr
///        ´       `                ´   |   `
///      c  between  d     =>      c    |    d         c = to_vertex(hl), d = to_vertex(hr)
///                                 `   |   ´
///                                   ` w ´
///                                  between
///
/// attributes: w lies at `position`, else where v does, and has its attributes; the new edges to c
///             and d are like those of hl and hr, that to v has defaults. A new triangle has the
///             attributes of the face that it was cut from, beyond the boundary of the other face
///             of the edge. Corners are divided into two alike
/// returns: w
/// cost: O(halfedges between), O(valence) on the boundary; and finding prev where it isn't stored
/// inverse: collapse of the halfedge from w to v, kPermissive if v was a corner of a pillow; it is
///          refused if v was a pinched vertex which this takes apart
/// errors: those of check_split_vertex, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Vertex> split_vertex(Mesh& mesh, Halfedge hl, Halfedge hr,
                                          const std::optional<Point>& position = {},
                                          SplitSides sides = {}) {
  if (Result<void> can = check_split_vertex(mesh, hl, hr, sides); !can) return can;
  if (!steps::make_room(mesh, 1, 3, 2)) {
    return refusals::no_memory("a vertex, three edges and two faces");
  }
  const bool left = internal::gets_triangle(mesh, sides.left, hl);
  const bool right = internal::gets_triangle(mesh, sides.right, mesh.opposite(hr));
  const Vertex v = mesh.from_vertex(hl);
  const bool was_on_boundary = mesh.is_boundary(v);
  const Halfedge anchor = mesh.vertex_halfedge(v);
  const Halfedge before_hl = mesh.prev(hl);
  const Halfedge before_hr = mesh.opposite(hr);

  const Vertex w = steps::copy_vertex(mesh, v);
  internal::move_to(mesh, w, position);
  const Halfedge down = mesh.new_edge(v, w);
  const Halfedge up = mesh.opposite(down);
  internal::enter_loop(mesh, up, before_hl);    // before_hl -> up -> hl
  internal::enter_loop(mesh, down, before_hr);  // before_hr -> down
  bool takes_anchor = false;
  for (Halfedge moved = mesh.next(down); moved != up; moved = mesh.rotate_cw(moved)) {
    mesh.set_to_vertex(mesh.opposite(moved), w);
    takes_anchor = takes_anchor || moved == anchor;
  }
  if (takes_anchor) mesh.set_vertex_halfedge(v, hl);
  mesh.set_vertex_halfedge(w, up);
  if (left) internal::make_triangle(mesh, up, hl, hl);
  if (right) internal::make_triangle(mesh, before_hr, down, before_hr);
  if (was_on_boundary) {
    steps::mend_anchor(mesh, down);
    steps::mend_anchor(mesh, up);
  }
  return w;
}

}  // namespace halfedge::operations
