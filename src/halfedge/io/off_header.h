#pragma once

#include <halfedge/io/text_scanner.h>
#include <halfedge/result.h>

#include <cstdint>

namespace halfedge::io {

/// What the head of an OFF file says of the rest.
struct OffHeader {
  /// Numbers that make the position of a vertex: 3, or 4 with a divisor.
  int coordinates = 3;
  /// Numbers of a vertex in all, with its normal, colour and texture coordinates: behind the
  /// position in this order, if it has them, and 3, 4 and 2 numbers.
  int columns = 3;
  bool normals = false;
  bool colors = false;
  bool texture = false;
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  /// The rest is binary, the counts as well.
  bool binary = false;
};

/// Reads the header word, if there is one, and the counts, and moves behind them. Counts that the
/// rest of the file is too short for are refused, so that memory may be asked for by them. Of a
/// binary file it moves behind the line of the header word, and reads no counts.
[[nodiscard]] Result<OffHeader> read_off_header(TextScanner& text);

}  // namespace halfedge::io
