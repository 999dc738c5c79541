#include <halfedge/io/ply_source.h>

#include <cmath>
#include <type_traits>

namespace halfedge::io {
namespace {

template <class T>
std::string spelt_as(const std::uint8_t* bytes, ByteOrder order) {
  const T number = load<T>(bytes, order);
  if constexpr (std::is_integral_v<T>) {
    return std::to_string(number);
  } else {
    const bool is_short = std::trunc(number) == number && std::abs(number) < T{0x1p63};
    return is_short ? std::to_string(static_cast<std::int64_t>(number))
                    : sentence::number(static_cast<double>(number));
  }
}

}  // namespace

bool to_whole(double number, std::int64_t& value) {
  if (!std::isfinite(number) || std::trunc(number) != number) return false;
  if (std::abs(number) < 0x1p63) {
    value = static_cast<std::int64_t>(number);
  } else {
    value = number < 0 ? INT64_MIN : INT64_MAX;
  }
  return true;
}

std::string spelt(const std::uint8_t* bytes, PlyType type, ByteOrder order) {
  switch (type) {
    case PlyType::kInt8:
      return spelt_as<std::int8_t>(bytes, order);
    case PlyType::kUint8:
      return spelt_as<std::uint8_t>(bytes, order);
    case PlyType::kInt16:
      return spelt_as<std::int16_t>(bytes, order);
    case PlyType::kUint16:
      return spelt_as<std::uint16_t>(bytes, order);
    case PlyType::kInt32:
      return spelt_as<std::int32_t>(bytes, order);
    case PlyType::kUint32:
      return spelt_as<std::uint32_t>(bytes, order);
    case PlyType::kInt64:
      return spelt_as<std::int64_t>(bytes, order);
    case PlyType::kUint64:
      return spelt_as<std::uint64_t>(bytes, order);
    case PlyType::kFloat32:
      return spelt_as<float>(bytes, order);
    case PlyType::kFloat64:
      return spelt_as<double>(bytes, order);
  }
  return {};
}

}  // namespace halfedge::io
