#pragma once

#include <halfedge/decorator/center.h>
#include <halfedge/operations/normal.h>
#include <halfedge/operations/requirements.h>

#include <cmath>
#include <optional>
#include <utility>

namespace halfedge::operations {

/// Whether split_face(f) can be done: else not-a-face.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_split_face(const Mesh& mesh, Face f) {
  return check_live(mesh, f);
}

/// A new vertex in the face, joined to each of its n corners: n triangles.
/// (CGAL: Euler::add_center_vertex; OpenMesh: split)
///
///     * ------- *        * ------- *
///     |         |        | `.   .´ |
///     |    f    |   =>   |    c    |
///     |         |        | .´   `. |
///     * ------- *        * ------- *
///
/// attributes: the vertex and its corners get the means of the corners, new faces the values of f,
///             the other new corners those of the old; new edges have the defaults
/// position: the mean of the corners by default
/// returns: c; the triangle opposite(vertex_halfedge(c)) lies in keeps the face
/// cost: O(degree). inverse: dissolve_vertex(returned)
/// errors: those of check_split_face, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Vertex> split_face(
    Mesh& mesh, Face f, [[maybe_unused]] const std::optional<Point>& position = {}) {
  if (Result<void> can = check_split_face(mesh, f); !can) return can;
  Result<Halfedge> to_center = decorator::internal::add_center_vertex(mesh, mesh.face_halfedge(f));
  if (!to_center) return std::move(to_center).failure();
  const Vertex c = mesh.to_vertex(to_center.value());
  if constexpr (HasPositions<Mesh>) {
    if (position) mesh.set_position(c, *position);
  }
  return c;
}

namespace internal {

/// Whether a face can be left along its normal, so far: else not-a-face, not-finite,
/// degenerate-face.
template <EditableSurface Mesh>
requires HasPositions<Mesh>
[[nodiscard]] Result<void> check_offset(const Mesh& mesh, Face f, double offset) {
  if (Result<void> live = check_live(mesh, f); !live) return live;
  if (!std::isfinite(offset)) return not_finite("offset", offset);
  if (offset == 0) return {};
  const Vector normal = geometry::area_vector(mesh, f);
  if (!(std::hypot(normal[0], normal[1], normal[2]) > 0)) return degenerate_face(f);
  return {};
}

/// The mean of the corners of a face, moved along its normal.
template <EditableSurface Mesh>
requires HasPositions<Mesh>
[[nodiscard]] Point tip(const Mesh& mesh, Face f, double offset) {
  const Point mean = decorator::internal::centroid(mesh, mesh.face_halfedge(f));
  return moved(mean, along_normal(mesh, f, offset));
}

}  // namespace internal

/// Whether poke(f, offset) can be done: else not-a-face; not-finite, also if the new position would
/// fit no 32-bit floats; degenerate-face, if an offset is given and the face has no area, so no
/// normal to move along.
template <EditableSurface Mesh>
requires HasPositions<Mesh>
[[nodiscard]] Result<void> check_poke(const Mesh& mesh, Face f, double offset = 0) {
  Result<void> can = internal::check_offset(mesh, f, offset);
  if (can && offset != 0 && !internal::is_finite(internal::tip(mesh, f, offset))) {
    return too_far(f, offset);
  }
  return can;
}

/// split_face with the vertex `offset` above the mean of the corners, along the normal of the face:
/// a pyramid on it, or with a negative offset in it.
///
/// attributes, returns, inverse: as split_face
/// cost: O(degree)
/// errors: those of check_poke, out-of-memory
template <EditableSurface Mesh>
requires HasPositions<Mesh>
[[nodiscard]] Result<Vertex> poke(Mesh& mesh, Face f, double offset = 0) {
  if (Result<void> can = check_poke(mesh, f, offset); !can) return can;
  if (offset == 0) return split_face(mesh, f);
  return split_face(mesh, f, internal::tip(mesh, f, offset));
}

}  // namespace halfedge::operations
