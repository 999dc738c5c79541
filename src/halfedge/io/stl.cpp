#include <halfedge/build/sentence.h>
#include <halfedge/io/byte_scanner.h>
#include <halfedge/io/position_table.h>
#include <halfedge/io/readers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace halfedge {
namespace io {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kStart = kHeader + 4;  // the number of triangles comes between
constexpr std::size_t kTriangle = 50;        // normal, three corners, two bytes of attributes
constexpr std::size_t kCorners = 12;         // behind the normal
constexpr std::size_t kBlock = 256;          // so many triangles are read at once

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

/// Triangles over vertices that are welded, or over three of their own each.
class TriangleWriter {
 public:
  TriangleWriter(std::span<const std::uint8_t> bytes, const Request& request)
      : out_(request.wanted), welds_(request.options.weld) {
    out_.follow(bytes, request.options.progress);
  }

  [[nodiscard]] SoupWriter& out() { return out_; }
  /// Room for the triangles, and for half as many vertices where they are shared, as in a mesh.
  void reserve(std::size_t triangles) {
    out_.reserve(welds_ ? triangles / 2 : 3 * triangles, 3 * triangles);
    if (welds_ && !table_.reserve(triangles / 2)) out_.set_out_of_memory();
  }
  void add(std::span<const float> triangles) {
    const std::size_t vertices = triangles.size() / 3;
    Index* const corners = out_.add_triangles(triangles.size() / 9);
    if (corners == nullptr) return;
    if (welds_) {
      if (!table_.weld(triangles.data(), vertices, out_.soup().positions, corners)) {
        out_.set_out_of_memory();
      }
    } else {
      std::iota(corners, corners + vertices, static_cast<Index>(out_.vertex_count()));
      if (float* const to = out_.add_vertices(vertices)) {
        std::copy(triangles.begin(), triangles.end(), to);
      }
    }
  }

 private:
  SoupWriter out_;
  bool welds_;
  PositionTable table_;
};

/// "x of vertex 2 of triangle 7"
std::string name_of_number(std::size_t number, std::size_t triangle) {
  return sentence::of("{} of vertex {} of triangle {}",
                      std::string_view("xyz").substr(number % 3, 1), number / 3, triangle);
}

/// By the exponents, which are compared in one go.
bool are_finite(std::span<const float> numbers) {
  constexpr std::uint32_t kExponent = 0x7F80'0000;
  bool are = true;
  for (const float& number : numbers) {
    are &= (__builtin_bit_cast(std::uint32_t, number) & kExponent) != kExponent;
  }
  return are;
}

/// pre: the triangle is not finite
Error not_finite(Error at, std::span<const float> triangle, std::size_t face) {
  std::size_t i = 0;
  while (std::isfinite(triangle[i])) ++i;
  at.message += sentence::of("{} is {}, expected a finite number", name_of_number(i, face),
                             sentence::number(triangle[i]));
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
/// Reads those of the triangles `at`, of which the first is `face`. Makes room for all at the first
/// one that isn't 0. False when memory is exhausted.
bool read_values(const std::uint8_t* at, std::size_t face, std::size_t count, std::size_t faces,
                 SoupAttribute& column) {
  for (std::size_t i = 0; i < count; ++i, at += kTriangle) {
    const auto value = load<std::uint16_t, ByteOrder::kLittle>(at + 48);
    if (value == 0) continue;
    if (!column.values.resize(sizeof(value) * faces, std::byte{})) return false;
    std::memcpy(&column.values[sizeof(value) * (face + i)], &value, sizeof(value));
  }
  return true;
}

/// pre: one of the triangles, of which the first is `face`, is not finite
Error first_not_finite(std::size_t face, std::span<const float> triangles) {
  while (are_finite(triangles.first(9))) {
    triangles = triangles.subspan(9);
    ++face;
  }
  Error at = error_at_byte(kStart + kTriangle * face, "non-finite-position", "");
  return not_finite(std::move(at), triangles.first(9), face);
}

Result<ParsedFile> read_binary(std::span<const std::uint8_t> bytes, const ParseOptions& options) {
  if (bytes.size() < kStart) {
    return Error{
        "truncated",
        sentence::of(
            "the file has {} bytes, expected at least the {} bytes that start a binary STL file",
            bytes.size(), kStart)};
  }
  const std::uint64_t count = announced(bytes);
  const std::uint64_t room = (bytes.size() - kStart) / kTriangle;
  if (count > room) {
    const std::size_t rest = (bytes.size() - kStart) % kTriangle;
    return error_at_byte(
        bytes.size(), "truncated",
        sentence::of("the bytes of this binary STL file of {} triangles end after {} of them{}",
                     count, room,
                     (rest == 0 ? "" : " and " + std::to_string(rest) + " bytes of the next one")));
  }

  TriangleWriter writer(bytes, {options});
  SoupWriter& out = writer.out();
  writer.reserve(static_cast<std::size_t>(count));
  const std::uint8_t* at = bytes.data() + kStart;
  SoupAttribute attribute = face_attribute();
  const auto faces = static_cast<std::size_t>(count);
  std::array<float, 9 * kBlock> numbers;
  for (std::size_t face = 0; face < faces && !out.out_of_memory(); face += kBlock) {
    out.reached(at);
    const std::size_t block = std::min(kBlock, faces - face);
    for (std::size_t i = 0; i < block; ++i) {
      for (std::size_t k = 0; k < 9; ++k) {
        numbers[9 * i + k] = load<float, ByteOrder::kLittle>(at + kTriangle * i + kCorners + 4 * k);
      }
    }
    const std::span<const float> read = std::span(numbers).first(9 * block);
    if (!options.for_repair && !are_finite(read)) return first_not_finite(face, read);
    writer.add(read);
    if (options.attributes && !read_values(at, face, block, faces, attribute)) {
      out.set_out_of_memory();
    }
    at += kTriangle * block;
  }
  if (std::optional<Error> error = check_size(out)) return *std::move(error);

  ParsedFile file{Format::kStl, std::move(out.soup()), {}, true};
  if (!attribute.values.empty()) file.attributes.push_back(std::move(attribute));
  const std::size_t rest = bytes.size() - kStart - static_cast<std::size_t>(count) * kTriangle;
  if (rest > 0) {
    file.notes.push_back(sentence::of(
        "ignored the {} bytes behind the last of the {} triangles that the header promises", rest,
        count));
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
    std::vector<std::string> notes;
    if (in_solid_) notes.emplace_back("the file ends without endsolid: it may be a part only");
    if (names_ > 0) {
      notes.push_back(
          std::string("ignored the ") +
          (names_ == 1 ? "name of a solid" : sentence::of("names of {} solids", names_)));
    }
    return notes;
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
    return skip_word(word) ||
           fail(unexpected(text_, sentence::of("{} of triangle {}", word, out().face_count())));
  }
  [[nodiscard]] bool fail(Error error) {
    error_ = std::move(error);
    return false;
  }

  TextScanner text_;
  ParseOptions options_;
  TriangleWriter writer_;
  bool in_solid_ = false;
  std::size_t names_ = 0;  // of solids
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
      text_.skip_blanks();
      names_ += in_solid_ && !text_.at_line_end() ? 1U : 0U;
      text_.skip_line();
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
    return fail(
        unexpected(text_, sentence::of("a number for {}", name_of_number(i, out().face_count()))));
  }
  if (!options_.for_repair && !are_finite(triangle)) {
    TextScanner first = start;
    first.skip_to_token();
    return fail(
        not_finite(error_at(first, "non-finite-position", ""), triangle, out().face_count()));
  }
  if (!expect("endloop") || !expect("endfacet")) return false;
  writer_.add(triangle);
  return true;
}

/// Whether this is a binary file that was cut, or to which something was added: by its first
/// triangles, which have finite numbers, not all of them next to nothing, as small integers are,
/// and normals of unit length or none.
bool has_triangles(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLooked = 16;
  constexpr float kNothing = 1e-30F;
  if (bytes.size() < kStart + kTriangle) return false;
  const std::size_t room = (bytes.size() - kStart) / kTriangle;
  const std::uint64_t looked = std::min<std::uint64_t>({kLooked, room, announced(bytes)});
  const std::uint8_t* at = bytes.data() + kStart;
  bool are_nothing = true;
  for (std::size_t i = 0; i < looked; ++i, at += kTriangle) {
    std::array<float, 12> numbers;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      numbers[k] = load<float, ByteOrder::kLittle>(at + 4 * k);
    }
    if (!are_finite(numbers)) return false;
    are_nothing &=
        std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::abs(x) < kNothing; });
    const float length = std::hypot(numbers[0], numbers[1], numbers[2]);
    if (length > 0.01F && std::abs(length - 1) > 0.01F) return false;
  }
  return !are_nothing;
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
  if (is_word(text.token(), "facet")) return StlKind::kText;
  return has_triangles(bytes) ? StlKind::kBinaryOfWrongSize : StlKind::kUnknown;
}

Result<ParsedFile> read_stl(std::span<const std::uint8_t> bytes, const Request& request) {
  const StlKind kind = kind_of_stl(bytes);
  const bool binary = kind == StlKind::kBinary || kind == StlKind::kBinaryOfWrongSize ||
                      (kind == StlKind::kUnknown && has_nul(TextScanner(bytes).rest()));
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
