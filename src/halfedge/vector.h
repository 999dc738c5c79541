#pragma once

#include <array>
#include <cstddef>

namespace halfedge {

/// A point or a vector, of which differences of floats are exact or nearly so.
using Vector = std::array<double, 3>;

[[nodiscard]] inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector& operator+=(Vector& a, const Vector& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) a[axis] += b[axis];
  return a;
}
[[nodiscard]] inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[nodiscard]] inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace halfedge
