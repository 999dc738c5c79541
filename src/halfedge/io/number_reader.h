#pragma once

namespace halfedge::io {

/// Reads a decimal number, correctly rounded: 1, -.5, 2.5e-3; nan, nan(...), inf and infinity in
/// any case. What is too large becomes infinite, what is too small zero. Returns where it stops, or
/// null if there is no number at `p`; a plus in front is not part of one.
///
/// The digits are taken as a whole number, which is scaled by powers of ten in double precision;
/// that settles all floats but those next to the middle of two, some in a hundred million. These,
/// and doubles of more than sixteen digits or so, are compared with the middles in exact
/// arithmetic.
[[nodiscard]] const char* read_number(const char* p, const char* end, float& value);
[[nodiscard]] const char* read_number(const char* p, const char* end, double& value);

}  // namespace halfedge::io
