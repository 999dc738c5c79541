#include <halfedge/io/copy_numbers.h>

#include <algorithm>
#include <cstring>

namespace halfedge::io {
namespace {

template <class T>
void copy_all(Numbers<const std::uint8_t> from, Numbers<std::uint8_t> to, std::size_t count,
              bool reverse) {
  for (; count > 0; --count, from.first += from.stride, to.first += to.stride) {
    std::uint8_t raw[sizeof(T)];
    std::memcpy(raw, from.first, sizeof(T));
    if (reverse) std::reverse(raw, raw + sizeof(T));
    std::memcpy(to.first, raw, sizeof(T));
  }
}

}  // namespace

void copy_numbers(Numbers<const std::uint8_t> from, Numbers<std::uint8_t> to, std::size_t count,
                  std::size_t size, bool reverse) {
  switch (size) {
    case 1:
      return copy_all<std::uint8_t>(from, to, count, false);
    case 2:
      return copy_all<std::uint16_t>(from, to, count, reverse);
    case 4:
      return copy_all<std::uint32_t>(from, to, count, reverse);
    default:
      return copy_all<std::uint64_t>(from, to, count, reverse);
  }
}

}  // namespace halfedge::io
