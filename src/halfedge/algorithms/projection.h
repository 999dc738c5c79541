#pragma once

#include <halfedge/algorithms/planar.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace halfedge {

/// How a polygon is seen: without the coordinate in which its normal (Newell's) is largest. What is
/// left are the numbers given, so that corners on a line stay on it.
class Projection {
 public:
  explicit Projection(std::span<const Point> polygon) {
    double normal[3] = {};
    const Point origin = polygon[0];
    const auto from_origin = [&](const Point& p, double(&v)[3]) {
      v[0] = double{p.x} - double{origin.x};
      v[1] = double{p.y} - double{origin.y};
      v[2] = double{p.z} - double{origin.z};
    };
    double a[3];
    double b[3];
    from_origin(polygon[polygon.size() - 1], a);
    for (const Point& p : polygon) {
      from_origin(p, b);
      normal[0] += a[1] * b[2] - a[2] * b[1];
      normal[1] += a[2] * b[0] - a[0] * b[2];
      normal[2] += a[0] * b[1] - a[1] * b[0];
      std::copy(std::begin(b), std::end(b), std::begin(a));
    }
    for (const int i : {0, 1}) {
      if (std::abs(normal[i]) > std::abs(normal[axis_])) axis_ = i;
    }
    is_reversed_ = normal[axis_] < 0;
  }

  [[nodiscard]] PlanarPoint operator()(const Point& p) const {
    PlanarPoint planar = axis_ == 2   ? PlanarPoint{p.x, p.y}
                         : axis_ == 0 ? PlanarPoint{p.y, p.z}
                                      : PlanarPoint{p.z, p.x};
    if (is_reversed_) std::swap(planar.u, planar.v);
    return planar;
  }

 private:
  int axis_ = 2;
  bool is_reversed_ = false;
};

/// Of two corners; 0 if that is no number, or too large for one.
[[nodiscard]] inline double diagonal_length(const Point& p, const Point& q) {
  const double x = double{p.x} - double{q.x};
  const double y = double{p.y} - double{q.y};
  const double z = double{p.z} - double{q.z};
  const double length = std::sqrt(x * x + y * y + z * z);
  return length < std::numeric_limits<double>::max() ? length : 0;
}

}  // namespace halfedge
