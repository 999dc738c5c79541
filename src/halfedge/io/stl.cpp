#include <halfedge/io/byte_scanner.h>
#include <halfedge/io/position_table.h>
#include <halfedge/io/readers.h>

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace halfedge {
namespace io {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kStart = kHeader + 4;  // the number of triangles comes between
constexpr std::size_t kTriangle = 50;        // normal, three corners, two bytes of attributes

using Triangle = std::array<float, 9>;

/// Whether the letters are those of `word`, in lower case, in any case.
bool is_word(std::string_view text, std::string_view word) {
  if (text.size() != word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) | 0x20U) != static_cast<unsigned char>(word[i])) {
      return false;
    }
  }
  return true;
}

/// Triangles over welded vertices.
class TriangleWriter {
 public:
  TriangleWriter(std::span<const std::uint8_t> bytes, const Request& request)
      : out_(request.wanted) {
    out_.follow(bytes, request.options.progress);
  }

  [[nodiscard]] SoupWriter& out() { return out_; }
  /// Room for the triangles, and for half as many vertices, as they share in a mesh.
  void reserve(std::size_t triangles) {
    out_.reserve(triangles / 2, 3 * triangles);
    if (!table_.reserve(triangles / 2)) out_.set_out_of_memory();
  }
  void add(const Triangle& triangle) {
    std::array<Index, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const float* const p = &triangle[3 * i];
      if (!table_.find_or_claim(p, out_.soup().positions.span(), corners[i])) {
        out_.set_out_of_memory();
        return;
      }
      if (corners[i] != kNone) continue;
      corners[i] = static_cast<Index>(out_.vertex_count());
      out_.add_vertex(p[0], p[1], p[2]);
      if (out_.out_of_memory()) return;
    }
    out_.add_triangle(corners[0], corners[1], corners[2]);
  }

 private:
  SoupWriter out_;
  PositionTable table_;
};

/// "x of vertex 2 of triangle 7"
std::string name_of_number(std::size_t number, std::size_t triangle) {
  return std::string(1, "xyz"[number % 3]) + " of vertex " + std::to_string(number / 3) +
         " of triangle " + std::to_string(triangle);
}

bool is_finite(const Triangle& triangle) {
  float sum = 0;  // of zeros, but for NaN
  for (const float number : triangle) sum += number * 0;
  return sum == 0;
}

/// pre: the triangle is not finite
Error not_finite(Error at, const Triangle& triangle, std::size_t face) {
  std::size_t i = 0;
  while (std::isfinite(triangle[i])) ++i;
  at.message +=
      name_of_number(i, face) + " is " + std::to_string(triangle[i]) + ", expected a finite number";
  at.witness.faces = {static_cast<Index>(face)};
  return at;
}

// ---- binary ----------------------------------------------------------------------------------

std::uint64_t announced(std::span<const std::uint8_t> bytes) {
  return load<std::uint32_t, ByteOrder::kLittle>(bytes.data() + kHeader);
}

/// The two bytes behind each triangle, which some programs have colours in.
SoupAttribute face_attribute() {
  SoupAttribute column;
  column.name = "attribute";
  column.item = SoupItem::kFace;
  column.type = Scalar::kUint16;
  column.on_split = OnSplit::kCopy;
  return column;
}
/// Makes room for all at the first value. False when memory is exhausted.
bool set_value(SoupAttribute& column, std::size_t face, std::size_t faces, std::uint16_t value) {
  if (!column.values.resize(sizeof(value) * faces, std::byte{})) return false;
  std::memcpy(&column.values[sizeof(value) * face], &value, sizeof(value));
  return true;
}

Result<ParsedFile> read_binary(std::span<const std::uint8_t> bytes, const ParseOptions& options) {
  if (bytes.size() < kStart) {
    return Error{"truncated", "the file has " + std::to_string(bytes.size()) +
                                  " bytes, expected at least the " + std::to_string(kStart) +
                                  " bytes that start a binary STL file"};
  }
  const std::uint64_t count = announced(bytes);
  const std::uint64_t room = (bytes.size() - kStart) / kTriangle;
  if (count > room) {
    return error_at_byte(kHeader, "truncated",
                         "the header promises " + std::to_string(count) +
                             " triangles, but what follows has room for " + std::to_string(room));
  }

  TriangleWriter writer(bytes, {options});
  SoupWriter& out = writer.out();
  writer.reserve(static_cast<std::size_t>(count));
  const std::uint8_t* at = bytes.data() + kStart;
  SoupAttribute attribute = face_attribute();
  for (std::size_t face = 0; face < count && !out.out_of_memory(); ++face, at += kTriangle) {
    out.reached(at);
    Triangle triangle;
    for (std::size_t i = 0; i < 9; ++i) {
      triangle[i] = load<float, ByteOrder::kLittle>(at + 12 + 4 * i);
    }
    if (!options.for_repair && !is_finite(triangle)) {
      const auto offset = static_cast<std::size_t>(at - bytes.data());
      return not_finite(error_at_byte(offset, "non-finite-position", ""), triangle, face);
    }
    writer.add(triangle);
    const auto value = load<std::uint16_t, ByteOrder::kLittle>(at + 48);
    if (value == 0 || !options.attributes) continue;
    if (!set_value(attribute, face, static_cast<std::size_t>(count), value)) {
      out.set_out_of_memory();
    }
  }
  if (std::optional<Error> error = check_size(out)) return *std::move(error);

  ParsedFile file{Format::kStl, std::move(out.soup()), {}, true};
  if (!attribute.values.empty()) file.attributes.push_back(std::move(attribute));
  const std::size_t rest = bytes.size() - kStart - static_cast<std::size_t>(count) * kTriangle;
  if (rest > 0) {
    file.notes.push_back("ignored the " + std::to_string(rest) + " bytes behind the last of the " +
                         std::to_string(count) + " triangles that the header promises");
  }
  return file;
}

// ---- text ------------------------------------------------------------------------------------

class TextReader {
 public:
  TextReader(std::span<const std::uint8_t> bytes, const Request& request)
      : text_(bytes), options_(request.options), writer_(bytes, request) {}

  [[nodiscard]] std::optional<Error> read();
  [[nodiscard]] SoupWriter& out() { return writer_.out(); }
  [[nodiscard]] std::vector<std::string> notes() const {
    if (!in_solid_) return {};
    return {"the file ends without endsolid: it may be a part only"};
  }

 private:
  [[nodiscard]] bool read_facet();
  /// Past the next token of the file, if it is this word.
  [[nodiscard]] bool skip_word(std::string_view word) {
    text_.skip_to_token();
    const std::string_view token = text_.token();
    if (!is_word(token, word)) return false;
    text_.move_to(text_.position() + token.size());
    return true;
  }
  [[nodiscard]] bool expect(std::string_view word) {
    return skip_word(word) || fail(unexpected(text_, std::string(word) + " of triangle " +
                                                         std::to_string(out().face_count())));
  }
  [[nodiscard]] bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }

  TextScanner text_;
  ParseOptions options_;
  TriangleWriter writer_;
  bool in_solid_ = false;
  Error error_;
};

std::optional<Error> TextReader::read() {
  for (text_.skip_to_token(); !text_.at_end() && !out().out_of_memory(); text_.skip_to_token()) {
    const char* const start = text_.position();
    if (skip_word("facet")) {
      out().reached(start);
      out().begin_face(start);
      if (!read_facet()) return error_;
    } else if (skip_word(in_solid_ ? "endsolid" : "solid")) {
      in_solid_ = !in_solid_;
      text_.skip_line();  // its name
    } else {
      return unexpected(text_, in_solid_ ? "facet or endsolid" : "solid or facet");
    }
  }
  return check_size(out());
}

bool TextReader::read_facet() {
  text_.skip_line();  // the normal, which the corners tell better
  if (!expect("outer") || !expect("loop")) return false;
  Triangle triangle;
  const TextScanner start = text_;
  for (std::size_t i = 0; i < 9; ++i) {
    if (i % 3 == 0 && !expect("vertex")) return false;
    text_.skip_blanks();
    if (text_.read_float(triangle[i])) continue;
    return fail(unexpected(text_, "a number for " + name_of_number(i, out().face_count())));
  }
  if (!options_.for_repair && !is_finite(triangle)) {
    TextScanner first = start;
    first.skip_to_token();
    return fail(
        not_finite(error_at(first, "non-finite-position", ""), triangle, out().face_count()));
  }
  if (!expect("endloop") || !expect("endfacet")) return false;
  writer_.add(triangle);
  return true;
}

/// As in no text. Some programs start the header of a binary file with "solid", as a text does.
bool has_nul(std::string_view text) {
  constexpr std::size_t kLooked = 1024;
  return text.substr(0, kLooked).find('\0') != std::string_view::npos;
}

}  // namespace

StlKind kind_of_stl(std::span<const std::uint8_t> bytes) {
  if (bytes.size() >= kStart && bytes.size() == kStart + kTriangle * announced(bytes)) {
    return StlKind::kBinary;
  }
  TextScanner text(bytes);
  text.skip_to_token();
  if (is_word(text.token().substr(0, 5), "solid")) {
    return has_nul(text.rest()) ? StlKind::kBinary : StlKind::kText;
  }
  return is_word(text.token(), "facet") ? StlKind::kText : StlKind::kUnknown;
}

Result<ParsedFile> read_stl(std::span<const std::uint8_t> bytes, const Request& request) {
  const StlKind kind = kind_of_stl(bytes);
  const bool binary =
      kind == StlKind::kBinary || (kind == StlKind::kUnknown && has_nul(TextScanner(bytes).rest()));
  if (binary) return read_binary(bytes, request.options);
  TextReader reader(bytes, request);
  if (std::optional<Error> error = reader.read()) return *std::move(error);
  return ParsedFile{Format::kStl, std::move(reader.out().soup()), reader.notes()};
}

}  // namespace io

Result<ParsedFile> read_stl(std::span<const std::uint8_t> bytes, const ParseOptions& options) {
  return io::read_stl(bytes, {options});
}

}  // namespace halfedge
