#pragma once

#include <halfedge/io/parse.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfedge::test {

inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// A parsed file in a form that compares and prints.
struct Parsed {
  std::vector<float> positions;
  std::vector<std::vector<Index>> faces;
  std::vector<std::string> notes;
  /// "code: message"; then the rest is empty.
  std::string error;
};

inline Parsed flatten(const Result<ParsedFile>& file) {
  Parsed parsed;
  if (!file) {
    parsed.error = std::string(file.error().code) + ": " + file.error().message;
    return parsed;
  }
  const Polygons soup = file.value().soup.view();
  parsed.positions.assign(soup.positions.begin(), soup.positions.end());
  std::size_t corner = 0;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const std::size_t size = soup.sizes.empty() ? 3 : soup.sizes[f];
    parsed.faces.emplace_back(soup.corners.begin() + std::ptrdiff_t(corner),
                              soup.corners.begin() + std::ptrdiff_t(corner + size));
    corner += size;
  }
  parsed.notes = file.value().notes;
  return parsed;
}

inline Parsed parse_obj(std::string_view text) { return flatten(read_obj(bytes_of(text))); }
inline Parsed parse_off(std::string_view text) { return flatten(read_off(bytes_of(text))); }

/// The error of an OBJ file, "" if there is none.
inline std::string obj_error(std::string_view text) { return parse_obj(text).error; }
inline std::string off_error(std::string_view text) { return parse_off(text).error; }

}  // namespace halfedge::test
