#pragma once

#include <halfedge/mend/surface.h>
#include <halfedge/vector.h>

namespace halfedge::mend {

/// A face that is thinner than this share of its length has no normal to speak of: the rounding of
/// positions alone could turn it over.
inline constexpr double kThin = 1e-6;

[[nodiscard]] double length(const Vector& a);
/// Of length 1, or 0 if `a` is no longer than `least`.
[[nodiscard]] Vector unit_vector(const Vector& a, double least);
[[nodiscard]] inline Vector point_of(const SurfaceView& surface, Vertex v) {
  const Point p = surface.position(v);
  return {double{p.x}, double{p.y}, double{p.z}};
}

/// What a connected component measures.
struct Extent {
  Index first_face = kNone;
  Vector low = {};
  Vector high = {};
  double area = 0;
  double volume = 0;  // of the cone from the centre of the area: signed, and its own if closed

  [[nodiscard]] double diagonal() const { return length(high - low); }
};

/// By component. False when memory is exhausted.
[[nodiscard]] bool measure(const Surface& surface, const Components& components,
                           Array<Extent>& extents);

}  // namespace halfedge::mend
