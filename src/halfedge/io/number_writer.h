#pragma once

#include <halfedge/attributes/attribute.h>
#include <halfedge/connectivity/handle.h>

namespace halfedge::io {

/// The most that either of these writes.
inline constexpr int kMaxNumberLength = 24;

/// Writes a decimal number of so few digits that no shorter one reads as the same float, at most
/// nine; nan, inf and -inf where it is none. Returns the end.
/// pre: room for kMaxNumberLength characters
[[nodiscard]] char* write_float(char* out, float value);
[[nodiscard]] char* write_index(char* out, Index value);
/// The same for a double, at most 17 digits.
[[nodiscard]] char* write_double(char* out, double value);
/// The number of this type that lies at `value`.
[[nodiscard]] char* write_number(char* out, Scalar type, const void* value);

}  // namespace halfedge::io
