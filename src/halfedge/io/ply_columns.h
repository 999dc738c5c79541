#pragma once

#include <halfedge/build/soup_attribute.h>
#include <halfedge/io/ply_header.h>
#include <halfedge/io/text_scanner.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace halfedge::io {

/// Where the values of a property go.
struct PlyTarget {
  std::size_t column = kNowhere;  // of those of numbers, or of those of lists
  std::size_t offset = 0;         // within a row of the column, in bytes

  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
};

/// Adds columns for the properties of an element, but for lists and those in `taken`; nx, ny and nz
/// make one column, and so on. Returns the place of each property. What finds none, because its
/// name is taken or there are too many, goes nowhere.
[[nodiscard]] std::vector<PlyTarget> choose_columns(const PlyElement& element, SoupItem item,
                                                    std::span<const PlyProperty* const> taken,
                                                    std::vector<SoupAttribute>& columns);

/// The same for lists, of which each makes a column of its own. How many components that has, and
/// whether it can be one, is known when its rows have been read.
[[nodiscard]] std::vector<SoupAttribute> choose_lists(const PlyElement& element, SoupItem item,
                                                      std::span<const PlyProperty* const> taken,
                                                      std::span<const SoupAttribute> columns,
                                                      std::vector<PlyTarget>& targets);

/// Whether this list of a face holds the texture coordinates of its corners.
[[nodiscard]] bool is_texture_list(const PlyProperty& property);
/// The column for them.
[[nodiscard]] SoupAttribute texture_column(const PlyProperty& property);

/// Reads the next number of a text as one of this type; false, at the number, if it is none.
/// Where that is an integer which the type doesn't hold, it is the nearest one, and `altered`
/// counts it.
[[nodiscard]] bool read_number(TextScanner& text, PlyType type, std::byte* value,
                               std::size_t& altered);

}  // namespace halfedge::io
