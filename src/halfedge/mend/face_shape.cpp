#include <halfedge/geometry/loop.h>
#include <halfedge/inlining.h>
#include <halfedge/mend/face_shape.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfedge::mend {

double FaceShape::limit(double tolerance) const { return std::max(tolerance, kThin * length); }

HALFEDGE_NOINLINE FaceShape shape_of(const SurfaceView& surface, Face f) {
  const auto at = [&](Vertex v) { return point_of(surface, v); };
  FaceShape shape;
  const Halfedge first = surface.halfedge(f);
  Halfedge h = first;
  Halfedge far = first;  // where it leads is farthest from where `first` does
  double farthest = -1;
  double side = -1;
  bool is_finite = true;
  do {
    const double own = length_of(surface, h);
    is_finite = is_finite && std::isfinite(own);
    const double away = length(at(surface.to_vertex(h)) - at(surface.to_vertex(first)));
    if (own > side) side = own, shape.longest = h;
    if (!shape.shortest.valid() || own < shape.least) shape.least = own, shape.shortest = h;
    if (away > farthest) farthest = away, far = h;
    h = surface.next(h);
  } while (h != first);
  if (!is_finite) {
    shape.length = shape.width = shape.least = std::numeric_limits<double>::quiet_NaN();
    return shape;
  }
  // From there the farthest again: of a triangle, take the longest side itself.
  const bool has_three = is_triangle(surface, f);
  const Vector a = has_three ? at(surface.from_vertex(shape.longest)) : at(surface.to_vertex(far));
  Vector b = at(surface.to_vertex(shape.longest));
  if (!has_three) {
    farthest = -1;
    do {
      const Vector p = at(surface.to_vertex(h));
      if (length(p - a) > farthest) farthest = length(p - a), b = p;
      h = surface.next(h);
    } while (h != first);
  }
  shape.length = length(b - a);
  do {
    const Vector p = at(surface.to_vertex(h));
    if (shape.length > 0) {
      shape.width = std::max(shape.width, length(cross(b - a, p - a)) / shape.length);
    }
    h = surface.next(h);
  } while (h != first);
  return shape;
}

double width_of(const Vector& a, const Vector& b, const Vector& c) {
  const double longest = std::max({length(b - a), length(c - b), length(a - c)});
  if (!(longest > 0)) return 0;
  const double width = length(cross(b - a, c - a)) / longest;
  return width > kThin * longest ? width : 0;
}

HALFEDGE_NOINLINE Vector area_vector(const SurfaceView& surface, Halfedge h, const Vector& there) {
  return geometry::internal::area_vector(surface, h, there);
}

}  // namespace halfedge::mend
