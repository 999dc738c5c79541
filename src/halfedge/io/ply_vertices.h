#pragma once

#include <halfedge/io/copy_numbers.h>
#include <halfedge/io/ply_reader.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>
#include <vector>

/// How PlyReader reads vertices.
namespace halfedge::io {

template <class T>
std::uint8_t* bytes_at(T* value) {
  return reinterpret_cast<std::uint8_t*>(value);
}

template <class Source>
bool PlyReader<Source>::read_vertices(const PlyElement& element) {
  const std::array axes = {element.find("x"), element.find("y"), element.find("z")};
  if (!columns_.begin(element, SoupItem::kVertex, axes, options_.attributes)) {
    out_.set_out_of_memory();
  }
  if (std::any_of(axes.begin(), axes.end(),
                  [](const PlyProperty* axis) { return axis->type == PlyType::kFloat64; })) {
    note(sentence::of("read the positions of {}{}, doubles, as floats", element.count,
                      element.count == 1 ? " vertex" : " vertices"));
  }
  out_.reserve(static_cast<std::size_t>(element.count), 0);
  if (out_.out_of_memory()) return true;
  if constexpr (!std::is_same_v<Source, PlyText>) {
    if (read_packed_vertices(element)) return true;
  }
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    out_.begin_vertex(source_.begin_row());
    out_.reached(source_.position());
    std::array<float, 3> p{};
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      const auto axis = std::find(axes.begin(), axes.end(), &property);
      if (axis == axes.end()) {
        if (!keep_or_skip(element, k)) return false;
        continue;
      }
      const auto i = static_cast<std::size_t>(axis - axes.begin());
      if (source_.read(property.type, p[i])) continue;
      return fail(source_.unexpected(
          sentence::of("a number for {}{}", std::string_view("xyz").substr(i, 1), in_row(element)),
          property.type));
    }
    out_.add_vertex(p[0], p[1], p[2]);
  }
  return true;
}

/// Nearly all binary files have floats x, y, z and rows of the same size. False, without moving, if
/// this one is another.
template <class Source>
bool PlyReader<Source>::read_packed_vertices(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    const bool is_axis = property.name == "x" || property.name == "y" || property.name == "z";
    if (property.length_type || (is_axis && property.type != PlyType::kFloat32)) return false;
    if (is_long(property.type)) return false;
    size += size_of(property.type);
  }
  ByteScanner& bytes = source_.bytes();
  if (element.count > bytes.left() / size) return false;
  const auto count = static_cast<std::size_t>(element.count);
  out_.begin_vertices(count, bytes.position(), size);
  float* const positions = out_.add_vertices(count);
  if (positions == nullptr) return true;

  struct Piece {
    std::size_t from;
    std::size_t size;
    Numbers<std::uint8_t> to;
  };
  std::vector<Piece> pieces;
  std::size_t at = 0;
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    const PlyTarget& target = columns_.target(k);
    const std::size_t axis = std::string_view("xyz").find(property.name);
    if (target.column != PlyTarget::kNowhere) {
      SoupAttribute& column = columns_.column(target.column);
      std::byte* const to = column.values.data() + target.offset;
      pieces.push_back({at, size_of(property.type), {bytes_at(to), column.stride()}});
    } else if (property.name.size() == 1 && element.find(property.name) == &property && axis < 3) {
      pieces.push_back({at, sizeof(float), {bytes_at(positions + axis), 3 * sizeof(float)}});
    }
    at += size_of(property.type);
  }
  // So many rows at a time that they stay in the nearest cache from piece to piece.
  constexpr std::size_t kRows = 256;
  for (std::size_t row = 0; row < count; row += kRows) {
    const std::size_t rows = std::min(kRows, count - row);
    for (Piece& piece : pieces) {
      copy_numbers({bytes.position() + piece.from, size}, piece.to, rows, piece.size,
                   is_reversed(bytes.order()));
      piece.to.first += rows * piece.to.stride;
    }
    bytes.skip(rows * size);
    out_.reached(bytes.position());
    if (out_.out_of_memory()) break;
  }
  return true;
}

}  // namespace halfedge::io
