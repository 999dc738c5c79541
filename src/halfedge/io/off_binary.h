#pragma once

#include <halfedge/io/off_header.h>
#include <halfedge/io/readers.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace halfedge::io {

/// Reads the rest of a binary OFF file from `offset` on, behind the line of its header word.
///
/// Geomview writes big-endian numbers, and a list of colour components behind each face. Others
/// (pmp-library) write the numbers of their machine, and no colours. What fits the size of the file
/// best is taken.
[[nodiscard]] Result<ParsedFile> read_off_binary(std::span<const std::uint8_t> bytes,
                                                 std::size_t offset, OffHeader header,
                                                 const Request& request);

}  // namespace halfedge::io
