#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/result.h>
#include <halfedge/shapes/shapes.h>

#include <cstdint>
#include <initializer_list>
#include <span>

namespace halfedge::shapes {

/// Collects the vertices and faces of one shape, for which it makes room beforehand: after that
/// nothing can fail.
class Maker {
 public:
  /// Counts are those of the whole shape, which 64 bits may not hold.
  Maker(const char* shape, double vertices, double faces, double corners);

  /// Whether there is room; if not, `take` says why.
  [[nodiscard]] bool ready() const { return error_.code.empty(); }

  /// pre of these: ready()
  void vertex(double x, double y, double z);
  void face(std::initializer_list<Index> corners) { face({corners.begin(), corners.size()}); }
  void face(std::span<const Index> corners);
  /// One face, or two that share the diagonal from a to c.
  void quad(Index a, Index b, Index c, Index d, Faces faces);
  /// One face of the vertices from `first` on, `count` of them, in that order or the reverse.
  void polygon(Index first, Index count, bool reverse);

  [[nodiscard]] Result<PolygonSoup> take();

 private:
  PolygonSoup soup_;
  Error error_ = {};
};

/// bad-argument, unless each length is positive, finite, and not too large for a float.
[[nodiscard]] Error check_lengths(const char* shape, std::initializer_list<double> lengths);
/// "a torus has 2 sides, expected 3 or more": bad-argument if it has fewer.
[[nodiscard]] Error check_count(const char* shape, const char* what, Index count, Index least);
/// Whether one of the checks has found something: the first is left in `error`.
[[nodiscard]] bool refused(std::initializer_list<Error> checks, Error& error);

/// A direction in a plane, as its cosine and sine.
struct Turn {
  double cosine = 1;
  double sine = 0;
};

/// i n-ths of a whole turn. Exact at multiples of a quarter turn, and symmetrical: of two
/// directions that mirror each other in an axis or a diagonal, the numbers are the same.
/// pre: i <= n, n > 0
[[nodiscard]] Turn turn(std::uint64_t i, std::uint64_t n);

}  // namespace halfedge::shapes
