#pragma once

#include <halfedge/io/text_scanner.h>
#include <halfedge/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halfedge::io {

enum class PlyType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

/// The bytes of a value in a binary file.
[[nodiscard]] constexpr std::size_t size_of(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}
[[nodiscard]] constexpr bool is_integer(PlyType type) { return type < PlyType::kFloat32; }
/// An integer of 64 bits, which attributes hold as a double.
[[nodiscard]] constexpr bool is_long(PlyType type) {
  return type == PlyType::kInt64 || type == PlyType::kUint64;
}

/// Names are views of the file.
struct PlyProperty {
  std::string_view name;
  PlyType type;
  /// A list: the type of its length, before the values.
  std::optional<PlyType> length_type;
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The property of this name, or null.
  [[nodiscard]] const PlyProperty* find(std::string_view property) const;
  /// The list of the vertices of each row, under either of its usual names, or else the only list
  /// of integers; or null.
  [[nodiscard]] const PlyProperty* vertex_list() const;
  /// Some of the properties, the first few by name: `the property "a" of "vertex"`. Empty if there
  /// is none.
  [[nodiscard]] std::string name_of(const std::vector<bool>& which) const;
};

enum class PlyEncoding : std::uint8_t { kText, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  /// In the order of the file.
  std::vector<PlyElement> elements;
  /// Where the data starts.
  std::size_t size = 0;

  /// The element of this name, or null.
  [[nodiscard]] const PlyElement* find(std::string_view element) const;
  /// How many rows follow, of all elements.
  [[nodiscard]] std::uint64_t rows() const;
};

/// Reads the header. Counts that the rest of the file is too short for are refused, so that memory
/// may be asked for by them; so is a header without x, y and z of vertices, or without the vertices
/// of faces.
[[nodiscard]] Result<PlyHeader> read_ply_header(std::span<const std::uint8_t> bytes);

}  // namespace halfedge::io
