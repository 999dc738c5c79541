#pragma once

#include <halfedge/connectivity/handle.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <string_view>

/// The sentences in which the library explains itself.
namespace halfedge::sentence {

/// What is filled in: a text, a whole number, or an item ("face 7", "face none" if it is empty).
/// Refers to the text.
class Part {
 public:
  Part(std::string_view text) : text_(text) {}
  template <std::integral Number>
  requires(!std::same_as<Number, bool>) Part(Number number)
      : number_(static_cast<std::int64_t>(number)) {
    // One above the largest int64 is kept as a negative one, and marked.
    if constexpr (sizeof(Number) == sizeof number_ && std::unsigned_integral<Number>) {
      if (number_ < 0) text_ = kUnsigned;
    }
  }
  template <class Tag>
  Part(Handle<Tag> item) : text_(name_of(kind_of(item))), number_(item.index()) {}

  void append_to(std::string& sentence) const;

 private:
  static constexpr std::int64_t kNoNumber = std::numeric_limits<std::int64_t>::min();
  static constexpr char kUnsigned[] = "u";  // known by its address

  std::string_view text_;
  std::int64_t number_ = kNoNumber;
};

/// A sentence in which "{}" stands for each of `kParts` parts, which is checked when it is
/// compiled.
template <std::size_t kParts>
class Pattern {
 public:
  template <std::size_t kSize>
  consteval Pattern(const char (&text)[kSize]) : text_(text) {
    std::size_t gaps = 0;
    for (std::size_t i = 0; i + 1 < kSize; ++i) gaps += text[i] == '{' && text[i + 1] == '}';
    if (gaps != kParts) another_number_of_parts_than_of_gaps();
  }
  [[nodiscard]] const char* text() const { return text_; }

 private:
  static void another_number_of_parts_than_of_gaps();  // not constexpr: doesn't compile

  const char* text_;
};

/// One function for all: there are hundreds of sentences, and each is said once in a while.
[[nodiscard]] std::string fill_in(const char* pattern, std::initializer_list<Part> parts);

/// `of("{} has degree {}, expected 4", f, degree)`: "face 7 has degree 3, expected 4".
template <class... Parts>
[[nodiscard]] std::string of(Pattern<sizeof...(Parts)> pattern, const Parts&... parts) {
  return fill_in(pattern.text(), {Part(parts)...});
}

/// With a capital and a full stop.
[[nodiscard]] std::string complete(std::string text);

/// "1 corner", "2 corners"; knows the plurals that occur.
[[nodiscard]] std::string count_of(std::uint64_t count, std::string noun);

/// How many items of a long list are named.
inline constexpr std::size_t kListed = 8;

/// "3, 5, 9"; of a long list the first few "and others".
[[nodiscard]] std::string list_of(std::span<const Index> items);

/// In few digits, for people: "0.5", "nan", "-inf", "1e+30".
[[nodiscard]] std::string number(double value);
/// The same, with all digits if it is whole, and a double has them.
[[nodiscard]] std::string in_full(double value);

}  // namespace halfedge::sentence
