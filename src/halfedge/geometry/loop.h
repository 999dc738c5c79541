#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/mesh.h>
#include <halfedge/vector.h>

#include <cmath>

/// What all measures are made of: places in double precision, and the sums over the corners of a
/// loop. They take whatever has positions, to_vertex, from_vertex and next.
namespace halfedge::geometry::internal {

template <class Mesh>
[[nodiscard]] Vector place(const Mesh& mesh, Vertex v) {
  const Point p = mesh.position(v);
  return {double{p.x}, double{p.y}, double{p.z}};
}

[[nodiscard]] inline Point rounded(const Vector& a) {
  return {float(a[0]), float(a[1]), float(a[2])};
}

/// Squares, and squares of squares, of floats are in the range of doubles: no need for std::hypot.
[[nodiscard]] inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

/// Of length 1; zeros if `a` isn't longer than `least`, or isn't finite.
[[nodiscard]] inline Vector unit(const Vector& a, double least = 0) {
  const double size = length(a);
  if (!(size > least) || !std::isfinite(size)) return {};
  return {a[0] / size, a[1] / size, a[2] / size};
}

/// Of vectors that cancel out to less than this share of their lengths, rounding alone is left.
inline constexpr double kRounding = 1e-10;

/// The sum of the cross products of the corners of the loop of `h` (Newell 1972): normal to it, of
/// twice its area. It is as if the vertex that h leaves lay at `there`, from where all the others
/// are seen: what is small and far away isn't lost.
template <class Mesh>
[[nodiscard]] Vector area_vector(const Mesh& mesh, Halfedge h, const Vector& there) {
  Vector sum = {};
  Vector last = place(mesh, mesh.to_vertex(h)) - there;
  for (Halfedge on_loop = mesh.next(h); mesh.next(on_loop) != h; on_loop = mesh.next(on_loop)) {
    const Vector p = place(mesh, mesh.to_vertex(on_loop)) - there;
    sum += cross(last, p);
    last = p;
  }
  return sum;
}
template <class Mesh>
[[nodiscard]] Vector area_vector(const Mesh& mesh, Halfedge h) {
  return area_vector(mesh, h, place(mesh, mesh.from_vertex(h)));
}

/// The same of a triangle, whose halfedges they are: a loop that is known takes 0.7 of the time.
template <class Mesh>
[[nodiscard]] Vector triangle_vector(const Mesh& mesh, Halfedge h, Halfedge second,
                                     Halfedge third) {
  const Vector there = place(mesh, mesh.to_vertex(third));
  return cross(place(mesh, mesh.to_vertex(h)) - there, place(mesh, mesh.to_vertex(second)) - there);
}

/// The mean of the corners of the loop of `h`, seen from `origin`. Floats add up to a double that
/// is exact or nearly so, far from the origin too.
template <class Mesh>
[[nodiscard]] Vector centroid(const Mesh& mesh, Halfedge h, const Vector& origin = {}) {
  Vector sum = {};
  double corners = 0;
  Halfedge on_loop = h;
  do {
    sum += place(mesh, mesh.to_vertex(on_loop)) - origin;
    ++corners;
    on_loop = mesh.next(on_loop);
  } while (on_loop != h);
  return {sum[0] / corners, sum[1] / corners, sum[2] / corners};
}

}  // namespace halfedge::geometry::internal
