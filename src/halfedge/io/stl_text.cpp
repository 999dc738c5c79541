#include <halfedge/io/stl_reader.h>
#include <halfedge/sentence.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfedge::io {
namespace {

using Triangle = std::array<float, 9>;

class TextReader {
 public:
  TextReader(std::span<const std::uint8_t> bytes, const Request& request)
      : text_(without_padding(bytes)), options_(request.options), writer_(bytes, request) {}

  [[nodiscard]] std::optional<Error> read();
  [[nodiscard]] SoupWriter& out() { return writer_.out(); }
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    if (in_solid_) notes.emplace_back("the file ends without endsolid: it may be a part only");
    if (unended_ > 0) {
      notes.push_back(sentence::of("{} before the last one",
                                   unended_ == 1
                                       ? "1 solid ends without endsolid"
                                       : sentence::of("{} solids end without endsolid", unended_)));
    }
    if (names_ > 0) {
      notes.push_back(
          std::string("ignored the ") +
          (names_ == 1 ? "name of a solid" : sentence::of("names of {} solids", names_)));
    }
    return notes;
  }

 private:
  [[nodiscard]] bool read_facet();
  void skip_name();
  void skip_normal();
  [[nodiscard]] bool at_facet() const;
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
  std::size_t names_ = 0;    // of solids
  std::size_t unended_ = 0;  // solids
  Error error_;
};

std::optional<Error> TextReader::read() {
  for (text_.skip_to_token(); !text_.at_end() && !out().out_of_memory(); text_.skip_to_token()) {
    const char* const start = text_.position();
    if (skip_word("facet")) {
      out().reached(start);
      out().begin_face(start);
      if (!read_facet()) return error_;
    } else if (skip_word("solid")) {
      unended_ += in_solid_ ? 1U : 0U;
      in_solid_ = true;
      text_.skip_blanks();
      names_ += text_.at_line_end() || at_facet() ? 0U : 1U;
      skip_name();
    } else if (skip_word("endsolid")) {
      in_solid_ = false;
      skip_name();
    } else {
      return unexpected(text_, in_solid_ ? "facet or endsolid" : "solid or facet");
    }
  }
  return check_size(out());
}

/// "facet normal 0 0 1", which no name ends with.
bool TextReader::at_facet() const {
  TextScanner ahead = text_;
  for (const std::string_view word : {"facet", "normal"}) {
    const std::string_view token = ahead.token();
    if (!is_word(token, word)) return false;
    ahead.move_to(ahead.position() + token.size());
    ahead.skip_blanks();
  }
  float number = 0;
  return ahead.read_float(number);
}

/// The rest of the line, or as much of it as comes before a facet: all may be on one line.
void TextReader::skip_name() {
  for (text_.skip_blanks(); !text_.at_line_end(); text_.skip_blanks()) {
    if (at_facet()) return;
    text_.skip_token();
  }
  text_.skip_line();
}

/// Which the corners tell better. Its numbers have no o, as "outer" has, which may be on this line,
/// but perhaps a #: 1.#IND is no number to some.
void TextReader::skip_normal() {
  const char* const start = text_.position();
  if (!skip_word("normal")) text_.move_to(start);
  const std::string_view rest = text_.rest();
  std::size_t length = 0;
  for (; length < rest.size(); ++length) {
    const CharClass c = class_of(rest[length]);
    const bool in_number = length > 0 && class_of(rest[length - 1]) == CharClass::kOther;
    if ((rest[length] | ' ') == 'o' || c == CharClass::kNewline || c == CharClass::kBackslash)
      break;
    if (c == CharClass::kComment && !in_number) break;
  }
  text_.move_to(rest.data() + length);
}

bool TextReader::read_facet() {
  skip_normal();
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
    for (const float x : triangle) {
      first.skip_to_token();
      if (is_word(first.token(), "vertex")) first.skip_token();
      first.skip_blanks();
      float number = 0;
      if (!std::isfinite(x) || !first.read_float(number)) break;
    }
    return fail(
        not_finite(error_at(first, "non-finite-position", ""), triangle, out().face_count()));
  }
  if (!expect("endloop") || !expect("endfacet")) return false;
  writer_.add(triangle);
  return true;
}

}  // namespace

Result<ParsedFile> read_stl_text(std::span<const std::uint8_t> bytes, const Request& request) {
  TextReader reader(bytes, request);
  if (std::optional<Error> error = reader.read()) return *std::move(error);
  return ParsedFile{Format::kStl, std::move(reader.out().soup()), reader.notes()};
}

}  // namespace halfedge::io
