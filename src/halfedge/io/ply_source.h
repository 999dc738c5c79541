#pragma once

#include <halfedge/inlining.h>
#include <halfedge/io/byte_scanner.h>
#include <halfedge/io/copy_numbers.h>
#include <halfedge/io/ply_columns.h>
#include <halfedge/io/ply_header.h>
#include <halfedge/io/soup_writer.h>
#include <halfedge/io/text_scanner.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halfedge::io {

/// A number that counts, or is an index. What 64 bits cannot hold becomes the nearest value that
/// they can. False if it is not whole.
[[nodiscard]] HALFEDGE_NOINLINE bool to_whole(double number, std::int64_t& value);

/// The values of a PLY file in text form. Rows are lines, so that one with too few or too many
/// values is found where it is; unless there are more lines than rows, or fewer: then rows are
/// broken over lines, or share them.
class PlyText {
 public:
  PlyText(std::span<const std::uint8_t> bytes, std::size_t offset, std::uint64_t rows)
      : text_(bytes), data_(text_), rows_(rows) {
    data_.move_to(reinterpret_cast<const char*>(bytes.data()) + std::min(offset, bytes.size()));
    text_ = data_;
  }

  /// As many values as the rest of the file can hold, behind `others` values of another type.
  [[nodiscard]] std::uint64_t room(PlyType, std::uint64_t others = 0, PlyType = {}) const {
    const std::uint64_t values = text_.rest().size() / 2;
    return values - std::min(values, others);
  }

  [[nodiscard]] const void* position() const { return text_.position(); }
  /// Returns where the row starts.
  const char* begin_row() {
    text_.skip_blanks();
    if (!text_.at_line_end() && text_.position() != data_.position()) end_row();
    text_.skip_to_token();
    return text_.position();
  }
  /// Each reads or skips the next value of the row; false, at that value, if it is none.
  [[nodiscard]] bool read(PlyType type, float& value) {
    text_.skip_blanks();
    if (text_.read_float(value)) return true;
    return goes_on() && read(type, value);
  }
  /// What 64 bits cannot hold becomes the nearest value that they can.
  [[nodiscard]] bool read(PlyType type, std::int64_t& value) {
    text_.skip_blanks();
    const char* const start = text_.position();
    if (text_.read_integer(value) && text_.at_token_end()) return true;
    text_.move_to(start);
    if (goes_on()) return read(type, value);
    return !is_integer(type) && read_whole_number(value);
  }
  [[nodiscard]] bool read(PlyType type, std::byte* value) {
    if (read_number(text_, type, value, altered_)) return true;
    return goes_on() && read(type, value);
  }
  [[nodiscard]] bool skip(PlyType, std::uint64_t count) {
    for (; count > 0; --count) {
      text_.skip_blanks();
      if (text_.at_line_end() && !goes_on()) return false;
      text_.skip_token();
    }
    return true;
  }

  /// The place of the next value, to go back to it.
  [[nodiscard]] const char* mark() {
    text_.skip_blanks();
    if (text_.at_line_end()) (void)goes_on();
    return text_.position();
  }
  void move_to(const char* mark) { text_.move_to(mark); }
  /// The number at `mark` as the file has it.
  [[nodiscard]] std::string number_at(const char* mark, PlyType) const {
    TextScanner text = text_;
    text.move_to(mark);
    return text.number();
  }

  /// `expected` should have been here, of this type.
  [[nodiscard]] Error unexpected(const std::string& expected, PlyType) const {
    return io::unexpected(text_, expected);
  }
  [[nodiscard]] Error error(const char* code, const std::string& message) const {
    return error_at(text_, code, message);
  }
  [[nodiscard]] Error index_error(std::size_t corner, std::size_t face, PlyType) const {
    return io::index_error(text_, corner, face);
  }
  /// Once all rows have been read. Rows that share lines leave nothing behind them; else each has a
  /// line, and more values than the header says, and there are fewer than it says.
  [[nodiscard]] std::optional<Error> check_end() {
    TextScanner text = text_;
    text.skip_to_token();
    if (text.at_end() || lines() >= rows_) return std::nullopt;
    return error_at(
        text, "truncated",
        sentence::of("the header promises {}, but is followed by only {}: expected the end of "
                     "the file behind the last row, found {}",
                     sentence::count_of(rows_, "row"), sentence::count_of(lines(), "line"),
                     text.found()));
  }
  /// Says what was not read, when all rows have been.
  void add_notes(std::vector<std::string>& notes) {
    end_row();
    if (altered_ > 0) {
      notes.push_back(altered_ == 1
                          ? "took 1 number that its type does not hold for the nearest that it does"
                          : sentence::of("took {} numbers that their types do not hold for the "
                                         "nearest that they do",
                                         altered_));
    }
    if (long_rows_ > 0) {
      notes.push_back(
          sentence::of("ignored what {} beyond the properties of the header",
                       long_rows_ == 1 ? "1 row has" : sentence::of("{} rows have", long_rows_)));
    }
    text_.skip_to_token();
    if (text_.at_end()) return;
    notes.push_back(sentence::of("ignored what follows the last element, from line {} on: {}",
                                 text_.line(), text_.found()));
  }

 private:
  /// Past what a row has behind its last value, unless that is another row.
  HALFEDGE_NOINLINE void end_row() {
    text_.skip_blanks();
    if (text_.at_line_end() || lines() < rows_) return;
    ++long_rows_;
    text_.skip_line();
  }
  /// From the end of a line to the next value, where rows are broken over lines; false if that is
  /// not so, or if there is none. Asked last, where a value is missing: most rows have all of
  /// theirs.
  [[nodiscard]] HALFEDGE_NOINLINE bool goes_on() {
    if (!text_.at_line_end() || lines() <= rows_) return false;
    text_.skip_to_token();
    return !text_.at_end();
  }
  /// Lines with something on them. Counted when first asked for.
  [[nodiscard]] std::uint64_t lines() {
    if (lines_ > 0) return lines_;
    TextScanner text = data_;
    for (text.skip_to_token(); !text.at_end(); text.skip_to_token()) {
      ++lines_;
      text.skip_line();
    }
    return lines_;
  }
  /// 3.0, where the header says that an index is a float.
  [[nodiscard]] bool read_whole_number(std::int64_t& value) {
    const char* const start = text_.position();
    double number = 0;
    if (text_.read_double(number) && to_whole(number, value)) return true;
    text_.move_to(start);
    return false;
  }

  TextScanner text_;
  TextScanner data_;  // stays behind the header
  std::uint64_t rows_;
  std::uint64_t lines_ = 0;
  std::size_t long_rows_ = 0;
  std::size_t altered_ = 0;  // numbers that their types do not hold
};

/// The values of a binary PLY file.
class PlyBinary {
 public:
  PlyBinary(std::span<const std::uint8_t> bytes, std::size_t offset, ByteOrder order)
      : bytes_(bytes, offset, order) {}

  [[nodiscard]] std::uint64_t room(PlyType type, std::uint64_t others = 0,
                                   PlyType other = {}) const {
    const std::uint64_t left = bytes_.left();
    return (left - std::min(left, others * size_of(other))) / size_of(type);
  }
  [[nodiscard]] ByteScanner& bytes() { return bytes_; }

  [[nodiscard]] const void* position() const { return bytes_.position(); }
  const char* begin_row() { return bytes_.text(); }
  [[nodiscard]] bool read(PlyType type, float& value) {
    if (room(type) == 0) return false;
    value = static_cast<float>(take(type));
    return true;
  }
  [[nodiscard]] bool read(PlyType type, std::int64_t& value) {
    if (room(type) == 0) return false;
    if (type == PlyType::kUint8) {  // as lengths nearly always are
      value = bytes_.take<std::uint8_t>();
      return true;
    }
    const ByteScanner start = bytes_;
    if (to_whole(take(type), value)) return true;
    bytes_ = start;
    return false;
  }
  [[nodiscard]] bool read(PlyType type, std::byte* value) {
    if (room(type) == 0) return false;
    if (is_long(type)) {
      const double number = take_long(type);
      std::memcpy(value, &number, sizeof(number));
      return true;
    }
    copy_numbers({bytes_.position(), 0}, {reinterpret_cast<std::uint8_t*>(value), 0}, 1,
                 size_of(type), is_reversed(bytes_.order()));
    bytes_.skip(size_of(type));
    return true;
  }
  [[nodiscard]] bool skip(PlyType type, std::uint64_t count) {
    if (count > room(type)) return false;
    bytes_.skip(static_cast<std::size_t>(count) * size_of(type));
    return true;
  }

  [[nodiscard]] ByteScanner mark() const { return bytes_; }
  void move_to(const ByteScanner& mark) { bytes_ = mark; }
  /// pre: a number of this type is at `mark`
  [[nodiscard]] HALFEDGE_COLD std::string number_at(const ByteScanner& mark, PlyType type) const;

  [[nodiscard]] Error unexpected(const std::string& expected, PlyType type) const {
    if (room(type) > 0) {
      return error("parse-error", sentence::of("expected {}, found {}, which is no whole number",
                                               expected, number_at(bytes_, type)));
    }
    return error("truncated", sentence::of("expected {}, found the end of the file in {}", expected,
                                           sentence::count_of(bytes_.left(), "byte")));
  }
  [[nodiscard]] Error error(const char* code, const std::string& message) const {
    return error_at_byte(bytes_.offset(), code, message);
  }
  [[nodiscard]] Error index_error(std::size_t corner, std::size_t face, PlyType type) const {
    Error error = error_at_byte(
        bytes_.offset(), "index-out-of-range",
        sentence::of("corner {} of face {} is {}", corner, face, number_at(bytes_, type)));
    error.witness.faces = {static_cast<Index>(face)};
    return error;
  }
  [[nodiscard]] std::optional<Error> check_end() const { return std::nullopt; }
  void add_notes(std::vector<std::string>& notes) const {
    if (bytes_.left() == 0) return;
    notes.push_back(sentence::of("ignored the {} behind the last element",
                                 sentence::count_of(bytes_.left(), "byte")));
  }

 private:
  /// pre: room(type) > 0
  [[nodiscard]] double take(PlyType type) {
    switch (type) {
      case PlyType::kInt8:
        return bytes_.take<std::int8_t>();
      case PlyType::kUint8:
        return bytes_.take<std::uint8_t>();
      case PlyType::kInt16:
        return bytes_.take<std::int16_t>();
      case PlyType::kUint16:
        return bytes_.take<std::uint16_t>();
      case PlyType::kInt32:
        return bytes_.take<std::int32_t>();
      case PlyType::kUint32:
        return bytes_.take<std::uint32_t>();
      case PlyType::kInt64:
      case PlyType::kUint64:
        return take_long(type);
      case PlyType::kFloat32:
        return static_cast<double>(bytes_.take<float>());
      case PlyType::kFloat64:
        return bytes_.take<double>();
    }
    return 0;
  }

  HALFEDGE_NOINLINE double take_long(PlyType type) {
    const auto number = bytes_.take<std::int64_t>();
    return type == PlyType::kInt64 ? static_cast<double>(number)
                                   : static_cast<double>(static_cast<std::uint64_t>(number));
  }

  ByteScanner bytes_;
};

}  // namespace halfedge::io
