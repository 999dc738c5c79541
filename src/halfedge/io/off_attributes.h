#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/io/off_header.h>
#include <halfedge/io/parse.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace halfedge::io {

/// Colours as they come: floats from 0 to 1, or integers from 0 to 255. Which it is shows when all
/// of them are known: integers without a point, unless there is none but 0 and 1. Where some are
/// floats, a row of integers above 1 becomes floats from 0 to 1, too.
class OffColors {
 public:
  /// A number as it is written in a text.
  void see(std::string_view number) {
    for (const char c : number) is_of_integers_ &= is_digit(c);
  }
  /// All numbers of the next row.
  void see_floats() { is_of_integers_ = false; }
  /// Of the item of this index, after those before; three numbers or four. False when memory is
  /// exhausted.
  [[nodiscard]] bool add(std::size_t item, std::span<const float> color);
  /// Makes them a column, if there are any. False when memory is exhausted.
  [[nodiscard]] bool finish(SoupItem item, std::size_t count, ParsedFile& file);

 private:
  struct Row {
    std::uint8_t width = 0;  // how many of the four values it has
    bool is_of_integers = false;
  };

  /// Whether the numbers of an item are from 0 to 255, beside floats.
  [[nodiscard]] bool is_byte_row(std::size_t item) const;

  Array<float> values_;  // four for each item
  Array<Row> rows_;
  bool is_of_integers_ = true;  // the next row, as far as it was seen
  bool are_integers_ = true;
  bool have_alpha_ = false;
};

/// Collects what an OFF file says beside positions and faces. What returns false has run out of
/// memory.
class OffAttributes {
 public:
  /// `numbers` are the numbers of a vertex behind its position, in the order in which they come.
  [[nodiscard]] bool add_vertex(const OffHeader& header, std::size_t vertex,
                                std::span<const float> numbers);
  /// One number is a place in a table of colours that is no part of the file.
  [[nodiscard]] bool add_face(std::size_t face, std::span<const float> numbers);
  [[nodiscard]] OffColors& vertex_colors() { return vertex_colors_; }
  [[nodiscard]] OffColors& face_colors() { return face_colors_; }

  [[nodiscard]] bool finish(std::size_t vertices, std::size_t faces, ParsedFile& file);

 private:
  Array<float> normals_;
  Array<float> textures_;
  OffColors vertex_colors_;
  OffColors face_colors_;
  std::size_t incomplete_ = 0;  // vertices with fewer numbers than the header promises
  std::size_t other_ = 0;       // vertices with more
  std::size_t of_table_ = 0;    // faces whose colour is one of a table
};

}  // namespace halfedge::io
