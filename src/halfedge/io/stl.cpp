#include <halfedge/io/stl_reader.h>
#include <halfedge/sentence.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace halfedge {
namespace io {
namespace {

/// As in no text, but behind its end. Some programs start the header of a binary file with "solid",
/// as a text does.
bool looks_binary(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLooked = 1024;
  if (bytes.size() >= kStlStart && count_is_text(bytes)) return false;
  const std::string_view text = TextScanner(bytes).rest();
  const std::string_view lines = TextScanner(without_padding(bytes)).rest();
  const bool is_padded = lines.find_first_of("\r\n") != std::string_view::npos;
  return (is_padded ? lines : text).substr(0, kLooked).find('\0') != std::string_view::npos;
}

}  // namespace

std::string name_of_number(std::size_t number, std::size_t triangle) {
  return sentence::of("{} of vertex {} of triangle {}",
                      std::string_view("xyz").substr(number % 3, 1), number / 3, triangle);
}

Error not_finite(Error at, std::span<const float> triangle, std::size_t face) {
  std::size_t i = 0;
  while (std::isfinite(triangle[i])) ++i;
  at.message += sentence::of("{} is {}, expected a finite number", name_of_number(i, face),
                             sentence::number(triangle[i]));
  at.witness.faces = {static_cast<Index>(face)};
  return at;
}

StlKind kind_of_stl(std::span<const std::uint8_t> bytes) {
  if (bytes.size() >= kStlStart &&
      bytes.size() == kStlStart + kStlTriangle * announced_triangles(bytes)) {
    return StlKind::kBinary;
  }
  TextScanner text(bytes);
  text.skip_to_token();
  if (is_word(text.token().substr(0, 5), "solid")) {
    return looks_binary(bytes) ? StlKind::kBinary : StlKind::kText;
  }
  if (is_word(text.token(), "facet")) return StlKind::kText;
  return has_stl_triangles(bytes) ? StlKind::kBinaryOfWrongSize : StlKind::kUnknown;
}

Result<ParsedFile> read_stl(std::span<const std::uint8_t> bytes, const Request& request) {
  const StlKind kind = kind_of_stl(bytes);
  const bool binary = kind == StlKind::kBinary || kind == StlKind::kBinaryOfWrongSize ||
                      (kind == StlKind::kUnknown && looks_binary(bytes));
  return binary ? read_stl_binary(bytes, request) : read_stl_text(bytes, request);
}

}  // namespace io

Result<ParsedFile> read_stl(std::span<const std::uint8_t> bytes, const ParseOptions& options) {
  return io::read_stl(bytes, {options});
}

}  // namespace halfedge
