#pragma once

#include <halfedge/inlining.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace halfedge::io {

/// What a byte means between tokens.
enum class CharClass : std::uint8_t { kOther, kBlank, kNewline, kComment, kBackslash };

inline constexpr std::array<CharClass, 256> kCharClasses = [] {
  std::array<CharClass, 256> classes{};
  for (const char blank : {' ', '\t', '\v', '\f'}) {
    classes[static_cast<unsigned char>(blank)] = CharClass::kBlank;
  }
  classes['\n'] = classes['\r'] = CharClass::kNewline;
  classes['#'] = CharClass::kComment;
  classes['\\'] = CharClass::kBackslash;
  return classes;
}();

[[nodiscard]] inline CharClass class_of(char c) {
  return kCharClasses[static_cast<unsigned char>(c)];
}
[[nodiscard]] inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A part of a file in quotation marks, for a sentence. Plain ASCII and short, whatever the bytes.
[[nodiscard]] std::string quoted(std::string_view text);

/// That of UTF-8, which some programs start a text with.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A text without what some programs leave behind its end: NULs, and the Ctrl-Z of DOS.
[[nodiscard]] std::span<const std::uint8_t> without_padding(std::span<const std::uint8_t> bytes);

/// A cursor over the bytes of a text file, which need not end with NUL. Never reads beyond them.
///
/// Lines end with LF, CR LF or CR; `#` starts a comment that runs to the end of its line; a
/// backslash at the end of a line, before blanks at most, joins the next line to it. Line numbers
/// are counted only when asked for, so that they cost nothing on the way.
class TextScanner {
 public:
  /// Starts behind the UTF-8 byte-order mark, if there is one.
  explicit TextScanner(std::span<const std::uint8_t> bytes)
      : begin_(reinterpret_cast<const char*>(bytes.data())),
        end_(begin_ + bytes.size()),
        at_(begin_) {
    (void)skip(kByteOrderMark);
  }

  [[nodiscard]] const char* position() const { return at_; }
  /// pre: `position` came from position().
  void move_to(const char* position) { at_ = position; }
  [[nodiscard]] std::string_view rest() const {
    return {at_, static_cast<std::size_t>(end_ - at_)};
  }
  [[nodiscard]] bool at_end() const { return at_ == end_; }
  /// No more tokens on this line: at its end, at a comment or at the end of the file.
  [[nodiscard]] bool at_line_end() const {
    if (at_ == end_) return true;
    const CharClass c = class_of(*at_);
    return c == CharClass::kNewline || c == CharClass::kComment;
  }

  /// To the next token of this line, or to its end.
  void skip_blanks() {
    while (at_ != end_) {
      const CharClass c = class_of(*at_);
      if (c == CharClass::kBlank) {
        ++at_;
      } else if (c != CharClass::kBackslash || !skip_continuation()) {
        return;
      }
    }
  }

  /// To the start of the next line. A backslash doesn't count: comments and names end with one.
  void skip_line() {
    while (at_ != end_ && class_of(*at_) != CharClass::kNewline) ++at_;
    skip_newline();
  }

  /// pre: not at the end of the line.
  void skip_token() {
    at_ += token().empty() ? 1 : token().size();  // a lone backslash is no token
  }

  /// Past all tokens of this line, and of those that a backslash joins to it.
  void skip_tokens() {
    if (!at_line_end()) skip_more_tokens();
  }

  /// To the next token of the file, past line ends and comments.
  void skip_to_token() {
    for (skip_blanks(); at_ != end_ && at_line_end(); skip_blanks()) skip_line();
  }

  /// Past `word`, if it is next.
  bool skip(std::string_view word) {
    if (!rest().starts_with(word)) return false;
    at_ += word.size();
    return true;
  }
  /// Past `c`, if it is next.
  bool skip(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  /// The token at the cursor, up to the next blank or the end of the line.
  [[nodiscard]] std::string_view token() const {
    const char* stop = at_;
    while (stop != end_ && class_of(*stop) == CharClass::kOther) ++stop;
    return {at_, static_cast<std::size_t>(stop - at_)};
  }

  /// How many tokens are left on this line.
  [[nodiscard]] std::size_t columns_of_line() const {
    TextScanner ahead = *this;
    std::size_t columns = 0;
    for (ahead.skip_blanks(); !ahead.at_line_end(); ahead.skip_blanks(), ++columns) {
      ahead.skip_token();
    }
    return columns;
  }

  /// Reads a number and moves past it; false, without moving, if the token is none. Correctly
  /// rounded; nan, inf and infinity in any case, and 1.#IND, 1.#INF and the like, are numbers.
  [[nodiscard]] bool read_float(float& value);
  [[nodiscard]] bool read_double(double& value);

  /// Reads an integer and moves past it; false, without moving, if there is none. Stops at the
  /// first byte that is no digit: see at_token_end(). What 64 bits cannot hold becomes the nearest
  /// value that they can.
  [[nodiscard]] bool read_integer(std::int64_t& value) {
    const char* p = at_;
    const bool negative = p != end_ && *p == '-';
    if (p != end_ && (*p == '-' || *p == '+')) ++p;
    const char* const digits = p;
    std::uint64_t magnitude = 0;
    for (; p != end_ && is_digit(*p); ++p) {
      magnitude = 10 * magnitude + static_cast<std::uint64_t>(*p - '0');
    }
    if (p == digits) return false;
    if (p - digits > 18) magnitude = saturated(digits, p);
    value = static_cast<std::int64_t>(magnitude);
    if (negative) value = -value;
    at_ = p;
    return true;
  }

  /// The token at the cursor, which is a number, as it is written.
  [[nodiscard]] std::string number() const;
  /// The number just read is a token of its own, with nothing glued to it.
  [[nodiscard]] bool at_token_end() const {
    return at_ == end_ || class_of(*at_) != CharClass::kOther;
  }

  /// The line of the cursor, from 1. cost: the distance from the start of the file.
  [[nodiscard]] std::size_t line() const { return lines_between(begin_, at_) + 1; }
  /// How many lines end between two positions of the text.
  [[nodiscard]] static std::size_t lines_between(const char* from, const char* to);

  /// The token at the cursor in quotation marks, or "the end of the line" or "of the file": what an
  /// error says was found.
  [[nodiscard]] std::string found() const;

 private:
  void skip_newline() {
    skip('\r');
    skip('\n');
  }
  HALFEDGE_NOINLINE bool skip_continuation() {
    const char* next = at_ + 1;
    while (next != end_ && class_of(*next) == CharClass::kBlank) ++next;
    if (next != end_ && class_of(*next) != CharClass::kNewline) return false;
    at_ = next;
    skip_newline();
    return true;
  }
  HALFEDGE_NOINLINE void skip_more_tokens() {
    for (skip_blanks(); !at_line_end(); skip_blanks()) skip_token();
  }
  template <class T>
  [[nodiscard]] bool read_number(T& value);
  [[nodiscard]] static std::uint64_t saturated(const char* digits, const char* stop);

  const char* begin_;
  const char* end_;
  const char* at_;
};

}  // namespace halfedge::io
