#pragma once

#include <halfedge/connectivity/handle.h>

#include <cstdint>
#include <span>
#include <string>

/// Parts of the sentences in which the library explains itself.
namespace halfedge::sentence {

/// With a capital and a full stop.
[[nodiscard]] std::string complete(std::string text);

/// "1 corner", "2 corners"; knows the plurals that occur.
[[nodiscard]] std::string count_of(std::uint64_t count, std::string noun);

/// "3, 5, 9"; of a long list the first few and "...".
[[nodiscard]] std::string list_of(std::span<const Index> items);

/// As few digits as tell the number from others to the eye: "0.5", "nan", "-inf", "1e+30".
[[nodiscard]] std::string number(double value);

}  // namespace halfedge::sentence
