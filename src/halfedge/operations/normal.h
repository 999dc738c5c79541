#pragma once

#include <halfedge/geometry/normals.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/requirements.h>
#include <halfedge/vector.h>

#include <cmath>

/// Along the normal of a face.
namespace halfedge::operations::internal {

/// `offset` times the unit normal of a face. pre: the face has an area, or the offset is 0
template <HasPositions Mesh>
[[nodiscard]] Vector along_normal(const Mesh& mesh, Face f, double offset) {
  if (offset == 0) return {};
  const Vector normal = geometry::area_vector(mesh, f);
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
