#include <halfedge/io/off_header.h>
#include <halfedge/io/readers.h>
#include <halfedge/sentence.h>

#include <optional>
#include <string_view>

namespace halfedge::io {
namespace {

struct HeaderWord {
  OffHeader header;
  /// nOFF: the number of coordinates comes before the counts.
  bool any_dimension = false;
};

/// Reads [ST][C][N][4][n]OFF, the letters in any order as programs write them, and moves past it.
/// The counts may be glued to it. No value, without moving, if there is no such word.
std::optional<HeaderWord> read_header_word(TextScanner& text) {
  HeaderWord word;
  std::string_view rest = text.rest();
  const auto skip = [&rest](std::string_view prefix) {
    if (!rest.starts_with(prefix)) return false;
    rest.remove_prefix(prefix.size());
    return true;
  };
  if (!skip("off")) {
    while (!skip("OFF")) {
      OffHeader& header = word.header;
      if (!header.texture && skip("ST")) {
        header.texture = true;
        header.columns += 2;
      } else if (!header.colors && skip("C")) {
        header.colors = true;
        header.columns += 4;
      } else if (!header.normals && skip("N")) {
        header.normals = true;
        header.columns += 3;
      } else if (skip("4") && word.header.coordinates == 3) {
        ++word.header.coordinates;
        ++word.header.columns;
      } else if (skip("n")) {
        word.any_dimension = true;
      } else {
        return std::nullopt;
      }
    }
  }
  if (!rest.empty() && !is_digit(rest.front()) && class_of(rest.front()) == CharClass::kOther) {
    return std::nullopt;
  }
  text.move_to(text.position() + (text.rest().size() - rest.size()));
  return word;
}

/// Reads a number of things, wherever the next token is.
std::optional<Error> read_count(TextScanner& text, std::uint64_t& count, const char* what) {
  text.skip_to_token();
  const TextScanner start = text;
  std::int64_t value = 0;
  if (!text.read_integer(value) || value < 0 || !text.at_token_end())
    return unexpected(start, what);
  if (value == INT64_MAX) {
    return error_at(start, "truncated",
                    sentence::of("{} is {}, more than a file can hold", what, start.number()));
  }
  count = static_cast<std::uint64_t>(value);
  return std::nullopt;
}

std::optional<Error> read_dimension(TextScanner& text) {
  text.skip_to_token();
  const TextScanner start = text;
  std::uint64_t dimension = 0;
  if (auto error = read_count(text, dimension, "the dimension of the vertices (3)")) return error;
  if (dimension == 3) return std::nullopt;
  return error_at(
      start, "unsupported-format",
      sentence::of("the vertices of this nOFF file have dimension {}, expected dimension 3",
                   start.found()));
}

/// The number of edges may be missing, and where it is given it is often wrong.
std::optional<Error> skip_edge_count(TextScanner& text) {
  text.skip_blanks();
  if (text.at_line_end()) {
    TextScanner next = text;
    next.skip_to_token();
    if (next.columns_of_line() != 1) return std::nullopt;
    text = next;
  }
  const TextScanner start = text;
  std::int64_t edges = 0;
  if (text.read_integer(edges) && text.at_token_end()) return std::nullopt;
  return unexpected(start, "the number of edges or the end of the line");
}

/// A number of a vertex takes two bytes at least, a face two, and the very last byte may be
/// missing.
std::optional<Error> check_counts(const TextScanner& text, const OffHeader& header) {
  const std::uint64_t bytes = text.rest().size() + 1;
  const std::uint64_t vertex_bytes = 2 * static_cast<std::uint64_t>(header.coordinates);
  if (header.vertices <= bytes / vertex_bytes &&
      header.faces <= (bytes - header.vertices * vertex_bytes) / 2) {
    return std::nullopt;
  }
  return error_at(text, "truncated",
                  sentence::of("the header promises {} and {}, but is followed by only {}",
                               sentence::count_of(header.vertices, "vertex"),
                               sentence::count_of(header.faces, "face"),
                               sentence::count_of(text.rest().size(), "byte")));
}

}  // namespace

Result<OffHeader> read_off_header(TextScanner& text) {
  text.skip_to_token();
  const HeaderWord word = read_header_word(text).value_or(HeaderWord{});
  text.skip_blanks();
  OffHeader header = word.header;
  if (text.token() == "BINARY") {
    if (word.any_dimension) {
      return error_at(text, "unsupported-format",
                      "this binary OFF file has vertices of any dimension (nOFF), expected 3");
    }
    text.skip_line();
    header.binary = true;
    return header;
  }
  if (word.any_dimension) {
    if (auto error = read_dimension(text)) return *error;
  }
  if (auto error = read_count(text, header.vertices,
                              "the number of vertices (after the header word OFF, if any)")) {
    return *error;
  }
  if (auto error = read_count(text, header.faces, "the number of faces")) return *error;
  if (auto error = skip_edge_count(text)) return *error;
  // A file may be on one line; but fewer numbers than a vertex has are none of its.
  text.skip_blanks();
  const std::size_t more = text.columns_of_line();
  if (more > 0 && header.vertices > 0 && more < static_cast<std::size_t>(header.coordinates)) {
    return unexpected(text, "the end of the line behind the counts");
  }
  if (auto error = check_counts(text, header)) return *error;
  return header;
}

bool looks_like_off(TextScanner text) {
  text.skip_to_token();
  if (read_header_word(text)) return true;
  // Counts without the word: zero of anything is not enough to tell.
  int counts = 0;
  for (; !text.at_line_end(); text.skip_blanks(), ++counts) {
    std::int64_t count = 0;
    if (!text.read_integer(count) || !text.at_token_end()) return false;
    if (count < 0 || (count == 0 && counts == 0)) return false;
  }
  return counts == 2 || counts == 3;
}

}  // namespace halfedge::io
