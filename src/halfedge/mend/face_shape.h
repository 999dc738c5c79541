#pragma once

#include <halfedge/mend/measure.h>

namespace halfedge::mend {

/// How far the corners of a face reach along a line, and away from it.
struct FaceShape {
  double length = 0;
  double width = 0;
  Halfedge longest;  // sides
  Halfedge shortest;
  double least = 0;  // the length of `shortest`

  /// Up to this width, and this length of a side, it counts as thin.
  [[nodiscard]] double limit(double tolerance) const;
  [[nodiscard]] bool is_thin(double tolerance) const { return width <= limit(tolerance); }
};

/// NaN in all, which is not thin, if a corner has no finite position. O(degree)
[[nodiscard]] FaceShape shape_of(const SurfaceView& surface, Face f);

/// The width of a triangle: 0 if its length leaves it no normal.
[[nodiscard]] double width_of(const Vector& a, const Vector& b, const Vector& c);

/// Twice the area of the face of `h`, if the vertex that h leaves were there. O(degree)
[[nodiscard]] Vector area_vector(const SurfaceView& surface, Halfedge h, const Vector& there);

[[nodiscard]] inline double length_of(const SurfaceView& surface, Halfedge h) {
  return length(point_of(surface, surface.to_vertex(h)) -
                point_of(surface, surface.from_vertex(h)));
}
[[nodiscard]] inline bool is_triangle(const SurfaceView& surface, Face f) {
  const Halfedge h = surface.halfedge(f);
  return surface.next(surface.next(surface.next(h))) == h;
}

}  // namespace halfedge::mend
