#include <halfedge/io/ply_source.h>

#include <cmath>

namespace halfedge::io {

bool to_whole(double number, std::int64_t& value) {
  if (!std::isfinite(number) || std::trunc(number) != number) return false;
  if (std::abs(number) < 0x1p63) {
    value = static_cast<std::int64_t>(number);
  } else {
    value = number < 0 ? INT64_MIN : INT64_MAX;
  }
  return true;
}

std::string PlyBinary::number_at(const ByteScanner& mark, PlyType type) const {
  PlyBinary there = *this;
  there.move_to(mark);
  if (type == PlyType::kInt64) return std::to_string(there.bytes_.take<std::int64_t>());
  if (type == PlyType::kUint64) return std::to_string(there.bytes_.take<std::uint64_t>());
  return sentence::in_full(there.take(type));
}

}  // namespace halfedge::io
