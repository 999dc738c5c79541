#pragma once

#include <halfedge/operations/normal.h>
#include <halfedge/operations/requirements.h>
#include <halfedge/operations/split_face.h>
#include <halfedge/operations/surgery_refusals.h>

#include <cstddef>

namespace halfedge::operations {

namespace internal {

/// A side of a face, and what a ring of quads puts before it.
struct RingSide {
  Halfedge outer;       // of the face before, of a quad now
  Halfedge inner = {};  // of the face now
  Halfedge spoke = {};  // from to_vertex(outer) to to_vertex(inner)
  Vertex corner = {};   // where `inner` leads
};

[[nodiscard]] inline std::size_t before(std::size_t i, std::size_t n) {
  return i == 0 ? n - 1 : i - 1;
}

/// Puts a ring of quads between the face and its sides; its new corners are copies of the old, and
/// lie where these do. False when memory is exhausted.
template <class Mesh>
[[nodiscard]] bool insert_ring(Mesh& mesh, Face f, Array<RingSide>& sides) {
  using namespace steps;
  const Index n = mesh.degree(f);
  if (!sides.reserve(n) || n > kMaxSlots / 4 || !make_room(mesh, n, 2 * n, n)) return false;
  for (const Halfedge h : mesh.loop_ccw(mesh.face_halfedge(f))) {
    (void)sides.push_back({.outer = h});
  }
  for (RingSide& side : sides) side.corner = copy_vertex(mesh, mesh.to_vertex(side.outer));
  for (std::size_t i = 0; i < n; ++i) {
    RingSide& side = sides[i];
    const RingSide& last = sides[before(i, n)];
    side.inner = new_edge_like(mesh, last.corner, side.corner, side.outer);
    side.spoke = mesh.new_edge(mesh.to_vertex(side.outer), side.corner);
    mesh.copy_corner(mesh.opposite(side.inner), last.outer);
    mesh.copy_corner(side.spoke, side.outer);
    mesh.copy_corner(mesh.opposite(side.spoke), side.outer);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const RingSide& side = sides[i];
    const RingSide& last = sides[before(i, n)];
    mesh.link(side.outer, side.spoke);
    mesh.link(side.spoke, mesh.opposite(side.inner));
    mesh.link(mesh.opposite(side.inner), mesh.opposite(last.spoke));
    mesh.link(mesh.opposite(last.spoke), side.outer);
    mesh.link(last.inner, side.inner);
    mesh.set_face(side.inner, f);
    set_anchor(mesh, last.corner, side.inner);
    make_face(mesh, side.outer, f);
  }
  mesh.set_face_halfedge(f, sides[0].inner);
  return true;
}

}  // namespace internal

/// Whether extrude_face(f, offset) can be done: else not-a-face; not-finite, also if a new position
/// would fit no 32-bit floats; degenerate-face, if the offset isn't 0 and the face has no area, so
/// no normal to move along.
template <EditableSurface Mesh>
requires HasPositions<Mesh>
[[nodiscard]] Result<void> check_extrude_face(const Mesh& mesh, Face f, double offset) {
  if (Result<void> can = internal::check_offset(mesh, f, offset); !can) return can;
  if (offset == 0) return {};
  const Vector offset_vector = internal::along_normal(mesh, f, offset);
  for (const Vertex v : mesh.face_vertices_ccw(f)) {
    if (!internal::is_finite(internal::moved(mesh.position(v), offset_vector))) {
      return too_far(f, offset);
    }
  }
  return {};
}

/// Moves a face by `offset` along its normal, and closes the gap with a quad at each side: a prism
/// on the face, or with a negative offset in it.
///
///                                  * ------- *
///     * ------- *                 /|   f    /|       f keeps its index, on top;
///    /    f    /         =>      * ------- * |       its old sides stay below
///   * ------- *                  | *       | *
///                                |/        |/
///                                * ------- *
///
/// attributes: new vertices have those of the corner below, quads those of f, sides on top those of
///             the side below, corners those of the corner of f; upright edges have the defaults
/// position: the corners, moved by offset times the unit normal (Newell's)
/// returns: f. cost: O(degree). inverse: delete_vertex of the new vertices, then fill_hole; of the
///          positions too
/// errors: those of check_extrude_face, out-of-memory
template <EditableSurface Mesh>
requires HasPositions<Mesh>
[[nodiscard]] Result<Face> extrude_face(Mesh& mesh, Face f, double offset) {
  if (Result<void> can = check_extrude_face(mesh, f, offset); !can) return can;
  const Vector offset_vector = internal::along_normal(mesh, f, offset);
  Array<internal::RingSide> sides;
  if (!internal::insert_ring(mesh, f, sides)) {
    return refusals::no_memory("a quad at each side");
  }
  for (const internal::RingSide& side : sides) {
    mesh.set_position(side.corner, internal::moved(mesh.position(side.corner), offset_vector));
  }
  return f;
}

/// Whether inset_face(f, fraction) can be done: else not-a-face, out-of-range.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_inset_face(const Mesh& mesh, Face f, double fraction) {
  if (Result<void> live = check_live(mesh, f); !live) return live;
  if (!(0 <= fraction && fraction <= 1)) return not_a_fraction("fraction", fraction);
  return {};
}

/// Shrinks a face towards the mean of its corners, and puts a quad between each of its sides and
/// where that was: with a fraction of 0 the new corners are where the old are, with 1 at the mean.
///
///     * --------- *          * --------- *
///     |           |          | `*-----*´ |
///     |     f     |    =>    |  |  f  |  |
///     |           |          | .*-----*. |
///     * --------- *          * --------- *
///
/// attributes: new vertices and corners are blended as their positions are; quads have those of f,
///             the new sides of f those of the old; the edges between corners have the defaults
/// returns: f. cost: O(degree). inverse: delete_vertex of the new vertices, then fill_hole
/// errors: those of check_inset_face, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> inset_face(Mesh& mesh, Face f, double fraction) {
  if (Result<void> can = check_inset_face(mesh, f, fraction); !can) return can;
  Array<internal::RingSide> sides;
  if (!internal::insert_ring(mesh, f, sides)) {
    return refusals::no_memory("a quad at each side");
  }
  [[maybe_unused]] Point mean;
  if constexpr (HasPositions<Mesh>) {
    mean = decorator::internal::centroid(mesh, mesh.face_halfedge(f));
  }
  // The first corner holds the mean for the others, and is what is between that and the corner
  // outside in the end.
  const internal::RingSide& first = sides[0];
  mesh.average_attributes(first.corner, [&](const auto& add) {
    for (const internal::RingSide& each : sides) add(mesh.to_vertex(each.outer).index());
  });
  mesh.average_attributes(first.inner, [&](const auto& add) {
    for (const internal::RingSide& each : sides) add(each.outer.index());
  });
  for (std::size_t i = sides.size(); i-- > 0;) {
    const internal::RingSide& side = sides[i];
    const Vertex v = side.corner;
    const Vertex outer = mesh.to_vertex(side.outer);
    if constexpr (HasPositions<Mesh>) {
      mesh.set_position(v, steps::blend(mesh.position(outer), mean, fraction));
    }
    mesh.copy_attributes(v, first.corner);
    mesh.blend_attributes(v, outer, v, fraction);
    mesh.copy_corner(side.inner, first.inner);
    mesh.blend_corners(side.inner, side.outer, side.inner, fraction);
    mesh.copy_corner(side.spoke, side.inner);
    mesh.copy_corner(mesh.opposite(sides[i + 1 == sides.size() ? 0 : i + 1].inner), side.inner);
  }
  return f;
}

}  // namespace halfedge::operations
