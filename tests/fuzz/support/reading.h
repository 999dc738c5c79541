#pragma once

#include <halfedge/io/parse.h>
#include <halfedge/result.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace halfedge::fuzz {

using Reader =
    std::function<Result<ParsedFile>(std::span<const std::uint8_t>, const ParseOptions&)>;

/// What every reader promises of any bytes, in both ways of reading. Either an error: one sentence
/// that says what was expected where. Or polygons that fit together, of which a repair makes a mesh
/// that is valid at level 4 and comes back, attributes and all, from each format that it is written
/// in. In memory in proportion.
///
/// The first expectation that fails ends the program, as libFuzzer wants it. Always 0.
int expect_read(std::span<const std::uint8_t> bytes, const Reader& read);

/// Makes a failed expectation of GoogleTest end the program, once.
void stop_at_failures();

/// One sentence of printable characters, with a code.
void expect_sentence(const Error& error);

}  // namespace halfedge::fuzz
