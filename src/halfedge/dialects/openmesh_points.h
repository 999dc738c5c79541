#pragma once

#include <halfedge/mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iosfwd>

namespace halfedge::dialects::openmesh {
inline namespace HALFEDGE_CHECKS {

/// A point that is calculated with as OpenMesh's `Vec3f` is; converts from and to ours. Products
/// and quotients of two are taken number by number; `|` is the dot product, `%` the cross product.
class Vec3f {
 public:
  using value_type = float;
  using Scalar = float;

  Vec3f() = default;
  explicit Vec3f(float all) : values_{all, all, all} {}
  Vec3f(float x, float y, float z) : values_{x, y, z} {}
  Vec3f(Point point) : values_{point.x, point.y, point.z} {}
  [[nodiscard]] operator Point() const { return {values_[0], values_[1], values_[2]}; }

  [[nodiscard]] static constexpr std::size_t size() { return 3; }
  [[nodiscard]] float operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] float& operator[](std::size_t i) { return values_[i]; }
  [[nodiscard]] const float* data() const { return values_.data(); }
  [[nodiscard]] float* data() { return values_.data(); }
  Vec3f& vectorize(float all) { return *this = Vec3f(all); }

  [[nodiscard]] float sqrnorm() const { return *this | *this; }
  [[nodiscard]] float norm() const { return std::sqrt(sqrnorm()); }
  [[nodiscard]] float length() const { return norm(); }
  Vec3f& normalize() { return *this /= norm(); }
  /// Leaves a zero vector as it is, of which `normalize` makes NaN.
  Vec3f& normalize_cond() { return norm() != 0 ? normalize() : *this; }
  [[nodiscard]] Vec3f normalized() const { return *this / norm(); }
  [[nodiscard]] float dot(const Vec3f& other) const { return *this | other; }
  [[nodiscard]] Vec3f cross(const Vec3f& other) const { return *this % other; }

#define HALFEDGE_OPENMESH_ARITHMETIC(op)                                 \
  Vec3f& operator op##=(const Vec3f& other) {                            \
    for (std::size_t i = 0; i < size(); ++i) values_[i] op## = other[i]; \
    return *this;                                                        \
  }                                                                      \
  [[nodiscard]] friend Vec3f operator op(Vec3f a, const Vec3f& b) { return a op## = b; }

  HALFEDGE_OPENMESH_ARITHMETIC(+)
  HALFEDGE_OPENMESH_ARITHMETIC(-)
  HALFEDGE_OPENMESH_ARITHMETIC(*)
  HALFEDGE_OPENMESH_ARITHMETIC(/)

#undef HALFEDGE_OPENMESH_ARITHMETIC

  Vec3f& operator*=(float scale) { return *this *= Vec3f(scale); }
  Vec3f& operator/=(float scale) { return *this /= Vec3f(scale); }
  [[nodiscard]] friend Vec3f operator*(Vec3f v, float scale) { return v *= scale; }
  [[nodiscard]] friend Vec3f operator*(float scale, Vec3f v) { return v *= scale; }
  [[nodiscard]] friend Vec3f operator/(Vec3f v, float scale) { return v /= scale; }
  [[nodiscard]] friend Vec3f operator-(const Vec3f& v) { return {-v[0], -v[1], -v[2]}; }
  [[nodiscard]] friend float operator|(const Vec3f& a, const Vec3f& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  [[nodiscard]] friend Vec3f operator%(const Vec3f& a, const Vec3f& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  friend bool operator==(const Vec3f&, const Vec3f&) = default;
  friend bool operator==(const Vec3f& a, const Point& b) { return a == Vec3f(b); }

  /// As OpenMesh prints it: `0 0.5 1`.
  template <class Traits>
  friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                                      const Vec3f& v) {
    return out << v[0] << ' ' << v[1] << ' ' << v[2];
  }

 private:
  std::array<float, 3> values_{};
};

}  // namespace HALFEDGE_CHECKS
}  // namespace halfedge::dialects::openmesh
