#pragma once

#include <halfedge/build/soup_attribute.h>
#include <halfedge/io/ply_header.h>
#include <halfedge/io/text_scanner.h>

#include <cstddef>
#include <span>
#include <string>
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

/// The attributes that properties become, element by element, and notes on what becomes of others.
class PlyColumns {
 public:
  /// Decides which properties of an element become attributes, if any may, and makes room for its
  /// rows. Those in `taken` are read otherwise. False when memory is exhausted.
  [[nodiscard]] bool begin(const PlyElement& element, SoupItem item,
                           std::span<const PlyProperty* const> taken, bool keeps);
  /// All rows of the element were read. Lists become attributes if they have the same length in all
  /// of them.
  void end(const PlyElement& element);

  /// Where a property of the element goes.
  [[nodiscard]] const PlyTarget& target(std::size_t property) const { return targets_[property]; }
  [[nodiscard]] SoupAttribute& column(std::size_t number) { return columns_[number]; }
  [[nodiscard]] SoupAttribute& list(std::size_t number) { return lists_[number]; }
  /// Adds a column, and returns its number.
  std::size_t add(SoupAttribute column);

  [[nodiscard]] std::vector<SoupAttribute>& all() { return columns_; }
  [[nodiscard]] std::vector<std::string>& notes() { return notes_; }

 private:
  void choose_lists(const PlyElement& element, SoupItem item,
                    std::span<const PlyProperty* const> taken);
  void note_unread(const PlyElement& element, std::span<const PlyProperty* const> taken);

  std::vector<SoupAttribute> columns_;
  std::vector<PlyTarget> targets_;    // by property of the element that is read
  std::vector<SoupAttribute> lists_;  // of the same, while it is read
  std::vector<std::string> notes_;
};

/// A list with no components knows no length yet, one with more than an attribute can have is given
/// up.
inline constexpr Index kUneven = Attribute::kMaxComponents + 1;

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
