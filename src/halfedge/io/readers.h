#pragma once

#include <halfedge/io/parse.h>
#include <halfedge/io/soup_writer.h>

#include <cstdint>
#include <span>

namespace halfedge::io {

/// What is asked of a reader.
struct Request {
  ParseOptions options;
  WantedPlaces wanted = {};
};

/// The readers themselves.
[[nodiscard]] Result<ParsedFile> read_obj(std::span<const std::uint8_t> bytes,
                                          const Request& request);
[[nodiscard]] Result<ParsedFile> read_off(std::span<const std::uint8_t> bytes,
                                          const Request& request);
[[nodiscard]] Result<ParsedFile> read_ply(std::span<const std::uint8_t> bytes,
                                          const Request& request);
[[nodiscard]] Result<ParsedFile> read_stl(std::span<const std::uint8_t> bytes,
                                          const Request& request);

/// That of a format.
[[nodiscard]] Result<ParsedFile> read_as(Format format, std::span<const std::uint8_t> bytes,
                                         const Request& request);

/// The text starts with an OBJ statement that has what such a statement needs, after any number of
/// others. Looks at the first lines only.
[[nodiscard]] bool looks_like_obj(TextScanner text);
/// The text starts with the header word of an OFF file, or with a line of two or three counts.
[[nodiscard]] bool looks_like_off(TextScanner text);
/// The file starts with the word ply.
[[nodiscard]] bool looks_like_ply(TextScanner text);

enum class StlKind : std::uint8_t { kUnknown, kText, kBinary, kBinaryOfWrongSize };
/// Binary if the size is that of the number of triangles, whatever the header says; else by how it
/// starts. A binary file that ends too early, or goes on too long, is told by its first triangles,
/// if nothing else is.
[[nodiscard]] StlKind kind_of_stl(std::span<const std::uint8_t> bytes);

}  // namespace halfedge::io
