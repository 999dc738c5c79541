#pragma once

#include <halfedge/mesh.h>
#include <halfedge/operations/requirements.h>
#include <halfedge/vector.h>

#include <cmath>
#include <cstddef>

/// Which way a face faces.
namespace halfedge::operations::internal {

/// The sum of the cross products of the corners, seen from one of them (Newell 1972): normal to the
/// face, of twice its area. The corner is near the others, so that little cancels out.
template <HasPositions Mesh>
[[nodiscard]] Vector area_vector(const Mesh& mesh, Face f) {
  const auto end_of = [&](Halfedge h) {
    const Point p = mesh.position(mesh.to_vertex(h));
    return Vector{double{p.x}, double{p.y}, double{p.z}};
  };
  const Vector first = end_of(mesh.face_halfedge(f));
  Vector sum = {};
  for (const Halfedge h : mesh.loop_ccw(mesh.face_halfedge(f))) {
    const Vector n = cross(end_of(h) - first, end_of(mesh.next(h)) - first);
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += n[axis];
  }
  return sum;
}

/// `offset` times the unit normal of a face. pre: the face has an area, or the offset is 0
template <HasPositions Mesh>
[[nodiscard]] Vector along_normal(const Mesh& mesh, Face f, double offset) {
  if (offset == 0) return {};
  const Vector normal = area_vector(mesh, f);
  const double scale = offset / std::hypot(normal[0], normal[1], normal[2]);
  return {scale * normal[0], scale * normal[1], scale * normal[2]};
}

/// Whether the place fits 32-bit floats.
[[nodiscard]] inline bool is_finite(Point p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

[[nodiscard]] inline Point moved(Point p, const Vector& by) {
  return {float(double{p.x} + by[0]), float(double{p.y} + by[1]), float(double{p.z} + by[2])};
}

}  // namespace halfedge::operations::internal
