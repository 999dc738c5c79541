#pragma once

#include <halfedge/io/ply_columns.h>
#include <halfedge/io/ply_header.h>
#include <halfedge/io/ply_source.h>
#include <halfedge/io/readers.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace halfedge::io {

/// Reads the rows that a header announces. Source is PlyText or PlyBinary.
template <class Source>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Source source, const Request& request)
      : header_(header),
        source_(std::move(source)),
        options_(request.options),
        out_(request.wanted),
        vertices_(header.find("vertex")->count) {}

  [[nodiscard]] std::optional<Error> read();
  [[nodiscard]] SoupWriter& out() { return out_; }
  [[nodiscard]] std::vector<std::string> notes();
  [[nodiscard]] std::vector<SoupAttribute>& columns() { return columns_; }

 private:
  [[nodiscard]] bool read_vertices(const PlyElement& element);
  [[nodiscard]] bool read_packed_vertices(const PlyElement& element);
  [[nodiscard]] bool read_faces(const PlyElement& element);
  [[nodiscard]] bool read_corners(const PlyProperty& list);
  [[nodiscard]] bool read_corner(const PlyProperty& list, std::size_t corner, std::int64_t degree);
  [[nodiscard]] bool read_strips(const PlyElement& element);
  [[nodiscard]] bool read_strip(const PlyProperty& list);
  [[nodiscard]] bool read_length(const PlyProperty& list, std::int64_t& length);
  [[nodiscard]] bool read_texture(const PlyProperty& list);
  void end_texture();
  [[nodiscard]] bool skip(const PlyElement& element, const PlyProperty& property);
  [[nodiscard]] bool skip_values(const PlyElement& element, const PlyProperty& property,
                                 std::int64_t count);
  [[nodiscard]] bool keep_or_skip(const PlyElement& element, std::size_t property);
  [[nodiscard]] bool read_list(const PlyElement& element, const PlyProperty& property,
                               SoupAttribute& column);
  void keep_even_lists(const PlyElement& element);
  [[nodiscard]] bool skip_rows(const PlyElement& element);

  /// Decides which properties become attributes, if any may, and makes room for their rows.
  void choose(const PlyElement& element, SoupItem item, std::span<const PlyProperty* const> taken,
              bool keeps);
  void note_unread(const PlyElement& element, std::span<const PlyProperty* const> read);
  [[nodiscard]] std::string in_row(const PlyElement& element) const {
    return sentence::of(" of {} {} of {}", quoted(element.name), row_, element.count);
  }
  [[nodiscard]] Error wrong_index(std::size_t corner, const PlyProperty& list) const;
  [[nodiscard]] bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }

  const PlyHeader& header_;
  Source source_;
  ParseOptions options_;
  SoupWriter out_;
  std::uint64_t vertices_;
  std::uint64_t row_ = 0;
  std::vector<SoupAttribute> columns_;
  std::vector<PlyTarget> targets_;      // by property of the element that is read
  std::vector<SoupAttribute> lists_;    // of the same, while it is read
  std::optional<std::size_t> texture_;  // the column of the corners
  std::size_t texture_begin_ = 0;       // the first corner of the face that is read
  std::size_t wrong_textures_ = 0;
  Error error_;
  std::vector<std::string> notes_;
};

template <class Source>
std::optional<Error> PlyReader<Source>::read() {
  for (const PlyElement& element : header_.elements) {
    row_ = 0;
    bool ok = true;
    if (element.name == "vertex") {
      ok = read_vertices(element);
    } else if (element.name == "face") {
      ok = read_faces(element);
    } else if (element.name == "tristrips" && element.vertex_list() != nullptr) {
      ok = read_strips(element);
    } else {
      ok = skip_rows(element);
    }
    if (!ok) return error_;
    if (out_.out_of_memory()) break;
    keep_even_lists(element);
  }
  if (std::optional<Error> error = check_size(out_)) return error;
  return source_.check_end();
}

template <class Source>
void PlyReader<Source>::choose(const PlyElement& element, SoupItem item,
                               std::span<const PlyProperty* const> taken, bool keeps) {
  targets_.assign(element.properties.size(), {});
  if (keeps) {
    targets_ = choose_columns(element, item, taken, columns_);
    lists_ = choose_lists(element, item, taken, columns_, targets_);
  }
  note_unread(element, taken);
  for (SoupAttribute& column : columns_) {
    if (column.item != item) continue;
    const auto rows = static_cast<std::size_t>(element.count);
    if (!column.values.resize(rows * column.stride(), std::byte{})) out_.set_out_of_memory();
  }
}

/// Reads a value into its column, if it has one. pre: the property is none that is taken
template <class Source>
bool PlyReader<Source>::keep_or_skip(const PlyElement& element, std::size_t property) {
  const PlyTarget& target = targets_[property];
  const PlyProperty& what = element.properties[property];
  if (target.column == PlyTarget::kNowhere) return skip(element, what);
  if (what.length_type) return read_list(element, what, lists_[target.column]);
  SoupAttribute& column = columns_[target.column];
  const auto row = static_cast<std::size_t>(row_);
  if (source_.read(what.type, &column.values[row * column.stride() + target.offset])) return true;
  return fail(source_.unexpected(
      sentence::of("a number for {}{}", quoted(what.name), in_row(element)), what.type));
}

template <class Source>
bool PlyReader<Source>::read_length(const PlyProperty& list, std::int64_t& length) {
  const auto start = source_.mark();
  const auto expected = [&] {
    return sentence::of("the length of the list {} of row {}", quoted(list.name), row_);
  };
  const auto given = [&] { return source_.number_at(start, *list.length_type); };
  if (!source_.read(*list.length_type, length)) {
    return fail(source_.unexpected(expected(), *list.length_type));
  }
  if (length < 0) {
    source_.move_to(start);
    return fail(source_.error("parse-error",
                              sentence::of("{} is {}, expected 0 or more", expected(), given())));
  }
  if (static_cast<std::uint64_t>(length) <= source_.room(list.type)) return true;
  source_.move_to(start);
  return fail(source_.error(
      "truncated",
      sentence::of("{} is {}, more than the rest of the file can hold", expected(), given())));
}

template <class Source>
bool PlyReader<Source>::skip(const PlyElement& element, const PlyProperty& property) {
  std::int64_t count = 1;
  if (property.length_type && !read_length(property, count)) return false;
  return skip_values(element, property, count);
}

template <class Source>
bool PlyReader<Source>::skip_values(const PlyElement& element, const PlyProperty& property,
                                    std::int64_t count) {
  if (source_.skip(property.type, static_cast<std::uint64_t>(count))) return true;
  return fail(source_.unexpected(
      sentence::of("the value of {}{}", quoted(property.name), in_row(element)), property.type));
}

template <class Source>
bool PlyReader<Source>::skip_rows(const PlyElement& element) {
  if (element.count > 0) {
    notes_.push_back(sentence::of("ignored the {} {}", sentence::count_of(element.count, "element"),
                                  quoted(element.name)));
  }
  if (element.properties.empty()) return true;
  for (; row_ < element.count && !out_.out_of_memory(); ++row_) {
    source_.begin_row();
    out_.reached(source_.position());
    for (const PlyProperty& property : element.properties) {
      if (!skip(element, property)) return false;
    }
  }
  return true;
}

/// Says which properties of an element nobody reads, and which change their type.
template <class Source>
void PlyReader<Source>::note_unread(const PlyElement& element,
                                    std::span<const PlyProperty* const> read) {
  std::vector<bool> unread(element.properties.size());
  std::vector<bool> changed(element.properties.size());
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    const bool is_kept = k < targets_.size() && targets_[k].column != PlyTarget::kNowhere;
    unread[k] = !is_kept && std::find(read.begin(), read.end(), &property) == read.end();
    changed[k] = is_kept && is_long(property.type);
  }
  if (element.count == 0) return;
  if (const std::string names = element.name_of(unread); !names.empty()) {
    notes_.push_back("ignored " + names);
  }
  if (const std::string names = element.name_of(changed); !names.empty()) {
    notes_.push_back("read " + names + ", integers of 64 bits, as doubles");
  }
}

template <class Source>
std::vector<std::string> PlyReader<Source>::notes() {
  if (wrong_textures_ > 0) {
    notes_.push_back(sentence::of(
        "the list \"texcoord\" of {}{} has not two numbers for each corner: what is missing is 0",
        wrong_textures_, wrong_textures_ == 1 ? " face" : " faces"));
  }
  source_.add_notes(notes_);
  return std::move(notes_);
}

}  // namespace halfedge::io
