#pragma once

#include <cstddef>
#include <cstdint>

namespace halfedge::io {

/// Where the numbers of some rows lie: the first one, and how far it is from one to the next.
template <class Byte>
struct Numbers {
  Byte* first;
  std::size_t stride;
};

/// Copies `count` numbers of `size` bytes (1, 2, 4 or 8), each turned round if `reverse`. They need
/// not be aligned.
void copy_numbers(Numbers<const std::uint8_t> from, Numbers<std::uint8_t> to, std::size_t count,
                  std::size_t size, bool reverse);

}  // namespace halfedge::io
