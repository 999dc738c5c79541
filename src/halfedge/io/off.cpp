#include <halfedge/io/readers.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace halfedge {
namespace io {
namespace {

/// What the header word says of a vertex.
struct HeaderWord {
  /// Numbers that make its position, and numbers in all.
  int coordinates = 3;
  int columns = 3;
  /// nOFF: the number of coordinates is in the file.
  bool any_dimension = false;
};

/// Reads [ST][C][N][4][n]OFF, the letters in any order as programs write them, and moves past it.
/// The counts may be glued to it. No value, without moving, if there is no such word.
std::optional<HeaderWord> read_header_word(TextScanner& text) {
  HeaderWord header;
  std::string_view rest = text.rest();
  const auto skip = [&rest](std::string_view prefix) {
    if (!rest.starts_with(prefix)) return false;
    rest.remove_prefix(prefix.size());
    return true;
  };
  if (!skip("off")) {
    while (!skip("OFF")) {
      if (skip("ST")) {
        header.columns += 2;
      } else if (skip("C")) {
        header.columns += 4;
      } else if (skip("N")) {
        header.columns += 3;
      } else if (skip("4")) {
        ++header.coordinates;
        ++header.columns;
      } else if (skip("n")) {
        header.any_dimension = true;
      } else {
        return std::nullopt;
      }
    }
  }
  if (!rest.empty() && !is_digit(rest.front()) && class_of(rest.front()) == CharClass::kOther) {
    return std::nullopt;
  }
  text.move_to(text.position() + (text.rest().size() - rest.size()));
  return header;
}

/// A vertex is three numbers and a face a count with so many indices. Files put each in a line of
/// its own, and may add colours and such behind; but line breaks mean nothing to Geomview. So lines
/// are records, which gives errors their place, unless there are too many or too few of them.
class OffReader {
 public:
  OffReader(std::span<const std::uint8_t> bytes, FacePositions* wanted)
      : text_(bytes), out_(wanted) {}

  [[nodiscard]] std::optional<Error> read() {
    if (read_header() && read_vertices() && read_faces()) return check_size(out_);
    return error_;
  }

  [[nodiscard]] SoupWriter& out() { return out_; }
  [[nodiscard]] std::vector<std::string> notes();

 private:
  [[nodiscard]] bool read_header();
  [[nodiscard]] bool read_dimension();
  [[nodiscard]] bool read_counts();
  [[nodiscard]] bool read_count(std::uint64_t& count, const char* what);
  [[nodiscard]] bool check_counts();
  [[nodiscard]] bool read_vertices();
  [[nodiscard]] bool read_vertex(bool packed);
  [[nodiscard]] bool read_faces();
  [[nodiscard]] bool read_face();
  [[nodiscard]] bool read_corner(std::int64_t corner, std::int64_t degree);
  /// To the next token of the record. False at its end, the end of the line.
  [[nodiscard]] bool skip_to_value(bool packed);

  void count_lines();
  [[nodiscard]] std::size_t columns_of_line() const;

  [[nodiscard]] bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }

  TextScanner text_;
  SoupWriter out_;
  Error error_;
  HeaderWord header_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
  const char* data_ = nullptr;
  /// Lines with something on them from data_ on; counted when first needed.
  std::optional<std::uint64_t> data_lines_;
};

bool OffReader::read_header() {
  text_.skip_to_token();
  if (std::optional<HeaderWord> word = read_header_word(text_)) {
    header_ = *word;
    text_.skip_blanks();
    if (text_.token() == "BINARY") {
      return fail(error_at(text_, "unsupported-format",
                           "this OFF file is binary, expected one in text form"));
    }
    text_.skip_to_token();
  }
  return (!header_.any_dimension || read_dimension()) && read_counts() && check_counts();
}

bool OffReader::read_dimension() {
  const TextScanner start = text_;
  std::uint64_t dimension = 0;
  if (!read_count(dimension, "the dimension of nOFF")) return false;
  if (dimension == 3) return true;
  text_ = start;
  return fail(error_at(
      text_, "unsupported-format",
      "this nOFF file has vertices of dimension " + text_.found() + ", expected dimension 3"));
}

bool OffReader::read_count(std::uint64_t& count, const char* what) {
  text_.skip_to_token();
  const TextScanner start = text_;
  std::int64_t value = 0;
  if (text_.read_integer(value) && value >= 0 && text_.at_token_end()) {
    count = static_cast<std::uint64_t>(value);
    return true;
  }
  text_ = start;
  return fail(unexpected(text_, what));
}

bool OffReader::read_counts() {
  if (!read_count(vertices_, "the number of vertices (after the header word OFF, if any)")) {
    return false;
  }
  text_.skip_blanks();
  const bool one_line = !text_.at_line_end();
  if (!read_count(faces_, "the number of faces")) return false;
  text_.skip_blanks();
  if (one_line ? !text_.at_line_end() : (text_.skip_to_token(), columns_of_line() == 1)) {
    std::uint64_t edges = 0;  // unused, and often wrong
    if (!read_count(edges, "the number of edges")) return false;
  }
  return true;
}

/// Counts that the file is too short for are refused here, so that memory can be asked for by them:
/// a vertex takes two bytes a number at least, the last one less, and a face two.
bool OffReader::check_counts() {
  data_ = text_.position();
  const std::uint64_t bytes = text_.rest().size() + 1;
  const auto vertex_bytes = static_cast<std::uint64_t>(2 * header_.coordinates);
  if (vertices_ <= bytes / vertex_bytes && faces_ <= (bytes - vertices_ * vertex_bytes) / 2) {
    return true;
  }
  return fail(error_at(text_, "truncated",
                       "the header promises " + std::to_string(vertices_) + " vertices and " +
                           std::to_string(faces_) + " faces, but only " +
                           std::to_string(bytes - 1) + " bytes follow"));
}

void OffReader::count_lines() {
  if (data_lines_) return;
  TextScanner text = text_;
  text.move_to(data_);
  std::uint64_t lines = 0;
  for (text.skip_to_token(); !text.at_end(); text.skip_to_token()) {
    ++lines;
    text.skip_line();
  }
  data_lines_ = lines;
}

std::size_t OffReader::columns_of_line() const {
  TextScanner text = text_;
  std::size_t columns = 0;
  for (text.skip_blanks(); !text.at_line_end(); text.skip_blanks(), ++columns) {
    text.skip_token();
  }
  return columns;
}

bool OffReader::skip_to_value(bool packed) {
  text_.skip_blanks();
  if (!text_.at_line_end()) return true;
  if (!packed) {
    count_lines();
    if (*data_lines_ <= vertices_ + faces_) return false;  // no record is on two lines
  }
  text_.skip_to_token();
  return !text_.at_end();
}

bool OffReader::read_vertices() {
  text_.skip_to_token();
  bool packed = false;
  const std::size_t columns = columns_of_line();
  const auto expected = static_cast<std::size_t>(header_.columns);
  if (columns > expected && columns % expected == 0) {
    count_lines();
    packed = *data_lines_ < vertices_ + faces_;
  }
  const std::uint64_t corners = std::min<std::uint64_t>(3 * faces_, text_.rest().size() / 2);
  out_.reserve(static_cast<std::size_t>(vertices_), static_cast<std::size_t>(corners));
  if (out_.out_of_memory()) return true;
  for (std::uint64_t i = 0; i < vertices_; ++i) {
    if (!read_vertex(packed)) return false;
  }
  return true;
}

bool OffReader::read_vertex(bool packed) {
  text_.skip_to_token();
  std::array<float, 4> p{};
  for (int i = 0; i < header_.coordinates; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    if (skip_to_value(packed) && text_.read_float(p[axis])) continue;
    return fail(unexpected(text_, std::string("a number for ") + "xyzw"[axis] + " of vertex " +
                                      std::to_string(out_.vertex_count()) + " of " +
                                      std::to_string(vertices_)));
  }
  if (header_.coordinates == 4) {
    out_.add_vertex(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
  } else {
    out_.add_vertex(p[0], p[1], p[2]);
  }
  if (!packed) {
    text_.skip_line();
    return true;
  }
  for (int i = header_.coordinates; i < header_.columns && skip_to_value(packed); ++i) {
    text_.skip_token();
  }
  return true;
}

bool OffReader::read_faces() {
  if (out_.out_of_memory()) return true;
  for (std::uint64_t i = 0; i < faces_; ++i) {
    if (!read_face()) return false;
    if (out_.out_of_memory()) break;
  }
  return true;
}

bool OffReader::read_face() {
  text_.skip_to_token();
  out_.begin_face(text_.position());
  const TextScanner start = text_;
  std::int64_t degree = 0;
  if (!text_.read_integer(degree) || degree < 0 || !text_.at_token_end()) {
    text_ = start;
    return fail(unexpected(text_, "the number of vertices of face " +
                                      std::to_string(out_.face_count()) + " of " +
                                      std::to_string(faces_)));
  }
  for (std::int64_t corner = 0; corner < degree; ++corner) {
    if (!read_corner(corner, degree)) return false;
  }
  out_.end_face();
  text_.skip_line();  // a colour
  return true;
}

bool OffReader::read_corner(std::int64_t corner, std::int64_t degree) {
  const bool any = skip_to_value(false);
  const TextScanner start = text_;
  std::int64_t vertex = 0;
  const auto name = [&] {
    return "corner " + std::to_string(corner) + " of face " + std::to_string(out_.face_count());
  };
  if (!any || !text_.read_integer(vertex) || !text_.at_token_end()) {
    text_ = start;
    return fail(unexpected(
        text_, "a vertex for " + name() + " (it promises " + std::to_string(degree) + ")"));
  }
  if (static_cast<std::uint64_t>(vertex) < vertices_) {
    out_.add_corner(static_cast<Index>(vertex));
    return true;
  }
  text_ = start;
  Error error = error_at(
      text_, "index-out-of-range",
      name() + " is " + text_.found() +
          (vertices_ == 0 ? ", but the file has no vertices"
                          : ", expected a vertex from 0 to " + std::to_string(vertices_ - 1)));
  error.witness.faces = {static_cast<Index>(out_.face_count())};
  return fail(std::move(error));
}

std::vector<std::string> OffReader::notes() {
  text_.skip_to_token();
  if (text_.at_end()) return {};
  return {"ignored what follows the last face, from line " + std::to_string(text_.line()) +
          " on: " + text_.found()};
}

}  // namespace

Result<ParsedFile> read_off(std::span<const std::uint8_t> bytes, FacePositions* wanted) {
  OffReader reader(bytes, wanted);
  if (std::optional<Error> error = reader.read()) return *std::move(error);
  return ParsedFile{Format::kOff, std::move(reader.out().soup()), reader.notes()};
}

bool looks_like_off(TextScanner text) {
  text.skip_to_token();
  if (read_header_word(text)) return true;
  int counts = 0;
  for (; !text.at_line_end(); text.skip_blanks(), ++counts) {
    std::int64_t count = 0;
    if (!is_digit(text.rest().front()) || !text.read_integer(count) || !text.at_token_end()) {
      return false;
    }
  }
  return counts == 2 || counts == 3;
}

}  // namespace io

Result<ParsedFile> read_off(std::span<const std::uint8_t> bytes) {
  return io::read_off(bytes, nullptr);
}

}  // namespace halfedge
