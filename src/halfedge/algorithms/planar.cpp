#include <halfedge/algorithms/planar.h>

namespace halfedge {

namespace {

/// The sign of a sum, exactly: of its parts, none of which overlaps another, the largest decides.
/// (Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997: grow-expansion)
int sign_of_sum(const double (&terms)[6]) {
  double parts[6] = {};
  int count = 0;
  for (const double term : terms) {
    double carried = term;
    for (int i = 0; i < count; ++i) {
      const double sum = carried + parts[i];
      const double of_part = sum - carried;
      parts[i] = (carried - (sum - of_part)) + (parts[i] - of_part);
      carried = sum;
    }
    parts[count++] = carried;
  }
  for (int i = count; i-- > 0;) {
    if (parts[i] != 0) return parts[i] > 0 ? 1 : -1;
  }
  return 0;
}

}  // namespace

// Products of two floats are exact in double precision.
int exact_turn_of(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return sign_of_sum({double{a.u} * double{b.v}, -double{a.u} * double{c.v},
                      -double{c.u} * double{b.v}, -double{a.v} * double{b.u},
                      double{a.v} * double{c.u}, double{c.v} * double{b.u}});
}

}  // namespace halfedge
