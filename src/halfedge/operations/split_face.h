#pragma once

#include <halfedge/decorator/center.h>
#include <halfedge/operations/requirements.h>

#include <cmath>
#include <optional>

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
  if (Result<void> can = check_split_face(mesh, f); !can) return can.error();
  const Result<Halfedge> to_center =
      decorator::internal::add_center_vertex(mesh, mesh.face_halfedge(f));
  if (!to_center) return to_center.error();
  const Vertex c = mesh.to_vertex(to_center.value());
  if constexpr (HasPositions<Mesh>) {
    if (position) mesh.set_position(c, *position);
  }
  return c;
}

namespace internal {

struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// The sum of the cross products of the corners, seen from one of them (Newell 1972): normal to the
/// face, of twice its area. The corner is near the others, so that little cancels out.
template <class Mesh>
[[nodiscard]] Vector area_vector(const Mesh& mesh, Face f) {
  const auto from_first =
      [&, first = mesh.position(mesh.to_vertex(mesh.face_halfedge(f)))](Halfedge h) {
        const Point p = mesh.position(mesh.to_vertex(h));
        return Vector{double{p.x} - double{first.x}, double{p.y} - double{first.y},
                      double{p.z} - double{first.z}};
      };
  Vector sum;
  for (const Halfedge h : mesh.loop_ccw(mesh.face_halfedge(f))) {
    const Vector a = from_first(h);
    const Vector b = from_first(mesh.next(h));
    sum.x += a.y * b.z - a.z * b.y;
    sum.y += a.z * b.x - a.x * b.z;
    sum.z += a.x * b.y - a.y * b.x;
  }
  return sum;
}

}  // namespace internal

/// Whether poke(f, offset) can be done: else not-a-face; not-finite; degenerate-face, if an offset
/// is given and the face has no area, so no normal to move along.
template <EditableSurface Mesh>
requires HasPositions<Mesh>
[[nodiscard]] Result<void> check_poke(const Mesh& mesh, Face f, double offset = 0) {
  if (Result<void> live = check_live(mesh, f); !live) return live;
  if (!std::isfinite(offset)) return not_finite("offset", offset);
  if (offset == 0) return {};
  const internal::Vector normal = internal::area_vector(mesh, f);
  const double length = std::hypot(normal.x, normal.y, normal.z);
  if (!(length > 0)) return degenerate_face(f);
  return {};
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
  if (Result<void> can = check_poke(mesh, f, offset); !can) return can.error();
  if (offset == 0) return split_face(mesh, f);
  const internal::Vector normal = internal::area_vector(mesh, f);
  const double scale = offset / std::hypot(normal.x, normal.y, normal.z);
  const Point mean = decorator::internal::centroid(mesh, mesh.face_halfedge(f));
  return split_face(
      mesh, f,
      Point{float(double{mean.x} + scale * normal.x), float(double{mean.y} + scale * normal.y),
            float(double{mean.z} + scale * normal.z)});
}

}  // namespace halfedge::operations
