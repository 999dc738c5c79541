#pragma once

#include <cmath>
#include <limits>

namespace halfedge {

/// A point of a plane.
struct PlanarPoint {
  float u = 0;
  float v = 0;

  friend bool operator==(const PlanarPoint&, const PlanarPoint&) = default;
};

/// 1 if a, b, c turn left, -1 if right, 0 on a line: exactly, for finite numbers.
[[nodiscard]] int exact_turn_of(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c);

/// The same, faster, as far as rounding may leave the sign in doubt.
[[nodiscard]] inline int turn_of(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  const double left = (double{a.u} - double{c.u}) * (double{b.v} - double{c.v});
  const double right = (double{a.v} - double{c.v}) * (double{b.u} - double{c.u});
  const double area = left - right;
  constexpr double kError = 4 * std::numeric_limits<double>::epsilon();
  if (std::abs(area) > kError * (std::abs(left) + std::abs(right))) return area > 0 ? 1 : -1;
  return exact_turn_of(a, b, c);
}

}  // namespace halfedge
