#pragma once

#include <halfedge/mesh.h>

#include <optional>

namespace halfedge::operations::internal {

/// The t in [0, 1] for which (1 - t) a + t b is closest to `p`; 1/2 if that can't be told, because
/// a and b coincide or something isn't finite.
[[nodiscard]] inline double closest_parameter(Point a, Point b, Point p) {
  const double edge[] = {double{b.x} - double{a.x}, double{b.y} - double{a.y},
                         double{b.z} - double{a.z}};
  const double to_p[] = {double{p.x} - double{a.x}, double{p.y} - double{a.y},
                         double{p.z} - double{a.z}};
  double along = 0;
  double squares = 0;
  for (const int axis : {0, 1, 2}) {
    along += edge[axis] * to_p[axis];
    squares += edge[axis] * edge[axis];
  }
  const double t = along / squares;
  if (t >= 0 && t <= 1) return t;
  if (t < 0) return 0;
  return t > 1 ? 1 : 0.5;
}

/// Where on the edge of `h` new values are taken from: at the point closest to `position`; without
/// one, or without positions at all, at `otherwise`.
template <class Mesh>
[[nodiscard]] double parameter_on(const Mesh& mesh, Halfedge h,
                                  const std::optional<Point>& position, double otherwise) {
  if constexpr (HasPositions<Mesh>) {
    if (position.has_value()) {
      return closest_parameter(mesh.position(mesh.from_vertex(h)), mesh.position(mesh.to_vertex(h)),
                               *position);
    }
  }
  return otherwise;
}

/// Moves `v` there, if a position is given and vertices have positions.
template <class Mesh>
void move_to([[maybe_unused]] Mesh& mesh, [[maybe_unused]] Vertex v,
             [[maybe_unused]] const std::optional<Point>& position) {
  if constexpr (HasPositions<Mesh>) {
    if (position.has_value()) mesh.set_position(v, *position);
  }
}

}  // namespace halfedge::operations::internal
