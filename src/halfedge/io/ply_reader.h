#pragma once

#include <halfedge/io/ply_columns.h>
#include <halfedge/io/ply_header.h>
#include <halfedge/io/ply_source.h>
#include <halfedge/io/readers.h>
#include <halfedge/sentence.h>

#include <cstddef>
#include <cstdint>
#include <optional>
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
  [[nodiscard]] std::vector<SoupAttribute>& columns() { return columns_.all(); }

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
  [[nodiscard]] bool skip_rows(const PlyElement& element);

  [[nodiscard]] std::string in_row(const PlyElement& element) const {
    return sentence::of(" of {} {} of {}", quoted(element.name), row_, element.count);
  }
  [[nodiscard]] Error wrong_index(std::size_t corner, const PlyProperty& list) const;
  void note(std::string sentence) { columns_.notes().push_back(std::move(sentence)); }
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
  PlyColumns columns_;
  std::optional<std::size_t> texture_;  // the column of the corners
  std::size_t texture_begin_ = 0;       // the first corner of the face that is read
  std::size_t wrong_textures_ = 0;
  Error error_;
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
    columns_.end(element);
  }
  if (std::optional<Error> error = check_size(out_)) return error;
  return source_.check_end();
}

/// Reads a value into its column, if it has one. pre: the property is none that is taken
template <class Source>
bool PlyReader<Source>::keep_or_skip(const PlyElement& element, std::size_t property) {
  const PlyTarget& target = columns_.target(property);
  const PlyProperty& what = element.properties[property];
  if (target.column == PlyTarget::kNowhere) return skip(element, what);
  if (what.length_type) return read_list(element, what, columns_.list(target.column));
  SoupAttribute& column = columns_.column(target.column);
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
    note(sentence::of("ignored the {} {}", sentence::count_of(element.count, "element"),
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

template <class Source>
std::vector<std::string> PlyReader<Source>::notes() {
  if (wrong_textures_ > 0) {
    note(sentence::of(
        "the list \"texcoord\" of {}{} has not two numbers for each corner: what is missing is 0",
        wrong_textures_, wrong_textures_ == 1 ? " face" : " faces"));
  }
  source_.add_notes(columns_.notes());
  return std::move(columns_.notes());
}

}  // namespace halfedge::io
