#pragma once

#include <halfedge/io/byte_scanner.h>
#include <halfedge/io/position_table.h>
#include <halfedge/io/readers.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <string_view>

/// What the readers of the two forms of STL share.
namespace halfedge::io {

/// The binary form: 80 bytes for anyone, the number of triangles, and these.
inline constexpr std::size_t kStlHeader = 80;
inline constexpr std::size_t kStlStart = kStlHeader + 4;
inline constexpr std::size_t kStlTriangle = 50;  // normal, three corners, two bytes of attributes

/// The number of triangles that a binary file says it has. pre: kStlStart bytes
[[nodiscard]] inline std::uint64_t announced_triangles(std::span<const std::uint8_t> bytes) {
  return load<std::uint32_t>(bytes.data() + kStlHeader, ByteOrder::kLittle);
}

/// Whether that number is four letters, digits or blanks of a text: no file has so many triangles.
/// pre: kStlStart bytes
[[nodiscard]] bool count_is_text(std::span<const std::uint8_t> bytes);

/// Whether the letters are those of `word`, in lower case, in any case.
[[nodiscard]] inline bool is_word(std::string_view text, std::string_view word) {
  if (text.size() != word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) | 0x20U) != static_cast<unsigned char>(word[i])) {
      return false;
    }
  }
  return true;
}

/// "x of vertex 2 of triangle 7"
[[nodiscard]] std::string name_of_number(std::size_t number, std::size_t triangle);

/// By the exponents, which are compared in one go.
[[nodiscard]] inline bool are_finite(std::span<const float> numbers) {
  constexpr std::uint32_t kExponent = 0x7F80'0000;
  bool are = true;
  for (const float& number : numbers) {
    are &= (__builtin_bit_cast(std::uint32_t, number) & kExponent) != kExponent;
  }
  return are;
}

/// Says at `at` which number of the triangle is none. pre: the triangle is not finite
[[nodiscard]] Error not_finite(Error at, std::span<const float> triangle, std::size_t face);

/// Triangles over vertices that are welded, or over three of their own each.
class TriangleWriter {
 public:
  TriangleWriter(std::span<const std::uint8_t> bytes, const Request& request)
      : out_(request.wanted), welds_(request.options.weld) {
    out_.follow(bytes, request.options.progress);
  }

  [[nodiscard]] SoupWriter& out() { return out_; }
  /// Room for the triangles, and for half as many vertices where they are shared, as in a mesh.
  void reserve(std::size_t triangles) {
    out_.reserve(welds_ ? triangles / 2 : 3 * triangles, 3 * triangles);
    if (welds_ && !table_.reserve(triangles / 2)) out_.set_out_of_memory();
  }
  void add(std::span<const float> triangles) {
    const std::size_t vertices = triangles.size() / 3;
    Index* const corners = out_.add_triangles(triangles.size() / 9);
    if (corners == nullptr) return;
    if (welds_) {
      if (!table_.weld(triangles.data(), vertices, out_.soup().positions, corners)) {
        out_.set_out_of_memory();
      }
    } else {
      std::iota(corners, corners + vertices, static_cast<Index>(out_.vertex_count()));
      if (float* const to = out_.add_vertices(vertices)) {
        std::copy(triangles.begin(), triangles.end(), to);
      }
    }
  }

 private:
  SoupWriter out_;
  bool welds_;
  PositionTable table_;
};

/// Whether this is a binary file that was cut, or to which something was added: by its first
/// triangles, which have finite numbers, not all of them next to nothing, as small integers are,
/// and normals of unit length or none.
[[nodiscard]] bool has_stl_triangles(std::span<const std::uint8_t> bytes);

[[nodiscard]] Result<ParsedFile> read_stl_binary(std::span<const std::uint8_t> bytes,
                                                 const Request& request);
[[nodiscard]] Result<ParsedFile> read_stl_text(std::span<const std::uint8_t> bytes,
                                               const Request& request);

}  // namespace halfedge::io
