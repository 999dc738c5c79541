#pragma once

#include <halfedge/connectivity/links.h>
#include <halfedge/result.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

/// What writing and reading of bytes have in common: bytes.h describes the form.
namespace halfedge::bytes_layout {

inline constexpr std::string_view kMagic = "halfedge";
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::size_t kHeaderSize = 56;
inline constexpr std::size_t kSectionHeaderSize = 16;
inline constexpr std::size_t kAttributeHeaderSize = 20;
/// More can't be read back: bytes may come from anywhere, and each attribute is looked up by its
/// name.
inline constexpr std::uint32_t kMaxSections = 4096;

/// The sections of the arrays, in the order of `array_of`; then those of attributes.
inline constexpr std::string_view kTags[] = {"next", "prev", "to-v", "face",
                                             "v-he", "f-he", "posi"};
inline constexpr std::size_t kPrev = 1;
inline constexpr std::size_t kPositions = 6;
inline constexpr std::string_view kAttributeTag = "attr";

[[nodiscard]] constexpr std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }

[[nodiscard]] inline Error no_memory_for_bytes() { return no_memory_for("a mesh and its bytes"); }

/// Copies numbers of `width` bytes, which are little-endian on one side.
inline void copy_little_endian(const void* from, void* to, std::size_t size, std::size_t width) {
  if (size > 0) std::memcpy(to, from, size);
  if constexpr (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__) {
    auto* const bytes = static_cast<std::uint8_t*>(to);
    for (std::size_t i = 0; i < size; i += width) std::reverse(bytes + i, bytes + i + width);
  }
}

/// The array of one of kTags but the last.
template <class AnyLinks>
[[nodiscard]] auto& array_of(AnyLinks& links, std::size_t section) {
  const std::array arrays{
      &links.next,         &links.prev, &links.to_vertex, &links.face, &links.vertex_halfedge,
      &links.face_halfedge};
  return *arrays[section];
}

}  // namespace halfedge::bytes_layout
