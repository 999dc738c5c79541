#pragma once

#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

/// Parts of the sentences in which the library explains itself.
namespace halfedge::sentence {

/// With a capital and a full stop.
[[nodiscard]] inline std::string complete(std::string text) {
  if ('a' <= text[0] && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text + ".";
}

/// "1 corner", "2 corners"; knows the plurals that occur.
[[nodiscard]] inline std::string count_of(std::uint64_t count, std::string noun) {
  if (count == 1) return "1 " + noun;
  if (noun.ends_with("vertex"))
    return std::to_string(count) + " " + noun.erase(noun.size() - 2) + "ices";
  return std::to_string(count) + " " + noun + "s";
}

/// "3, 5, 9"; of a long list the first few and "...".
[[nodiscard]] inline std::string list_of(std::span<const Index> items) {
  constexpr std::size_t kShown = 8;
  std::string list;
  for (std::size_t i = 0; i < items.size() && i < kShown; ++i) {
    if (i > 0) list += ", ";
    list += std::to_string(items[i]);
  }
  if (items.size() > kShown) list += ", ...";
  return list;
}

/// As few digits as tell the number from others to the eye: "0.5", "nan", "-inf", "1e+30".
[[nodiscard]] inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace halfedge::sentence
