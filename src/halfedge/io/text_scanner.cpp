#include <fast_float/fast_float.h>
#include <halfedge/io/text_scanner.h>

#include <algorithm>
#include <limits>

namespace halfedge::io {
namespace {

/// The spellings of older Microsoft C libraries: 1.#IND, -1.#INF, 1.#QNAN, 1.#SNAN, and with digits
/// behind ("1.#INF00"). Returns the end of the token, or null if it is none of them.
template <class T>
const char* read_microsoft_special(const char* p, const char* end, T& value) {
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  const std::string_view rest(p, static_cast<std::size_t>(end - p));
  for (const std::string_view name : {"1.#INF", "1.#IND", "1.#QNAN", "1.#SNAN"}) {
    if (!rest.starts_with(name)) continue;
    value =
        name == "1.#INF" ? std::numeric_limits<T>::infinity() : std::numeric_limits<T>::quiet_NaN();
    if (negative) value = -value;
    p += name.size();
    while (p != end && is_digit(*p)) ++p;
    return p;
  }
  return nullptr;
}

}  // namespace

template <class T>
bool TextScanner::read_number(T& value) {
  const char* number = at_;
  if (number != end_ && *number == '+') {
    ++number;
    if (number != end_ && *number == '-') return false;
  }
  // What is too large or too small becomes infinite or zero, and some versions report it.
  const auto [stop, code] = fast_float::from_chars(number, end_, value);
  if (code == std::errc::invalid_argument) return false;
  const char* after = stop;
  if (after != end_ && *after == '#') {  // a comment, unless it belongs to the number
    if (const char* special = read_microsoft_special(at_, end_, value)) after = special;
  }
  if (after != end_ && class_of(*after) == CharClass::kOther) return false;
  at_ = after;
  return true;
}

bool TextScanner::read_float(float& value) { return read_number(value); }
bool TextScanner::read_double(double& value) { return read_number(value); }

std::uint64_t TextScanner::saturated(const char* digits, const char* stop) {
  constexpr auto kMax = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  std::uint64_t value = 0;
  for (; digits != stop; ++digits) {
    const auto digit = static_cast<std::uint64_t>(*digits - '0');
    if (value > (kMax - digit) / 10) return kMax;
    value = 10 * value + digit;
  }
  return value;
}

std::size_t TextScanner::lines_between(const char* from, const char* to) {
  std::size_t lines = 0;
  for (const char* p = from; p != to; ++p) {
    if (*p == '\n' || (*p == '\r' && (p + 1 == to || p[1] != '\n'))) ++lines;
  }
  return lines;
}

std::span<const std::uint8_t> without_padding(std::span<const std::uint8_t> bytes) {
  constexpr std::uint8_t kCtrlZ = 0x1A;
  std::size_t size = bytes.size();
  while (size > 0 && (bytes[size - 1] == 0 || bytes[size - 1] == kCtrlZ)) --size;
  return bytes.first(size);
}

namespace {

constexpr std::size_t kShown = 32;  // bytes of a token

}  // namespace

std::string quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text.substr(0, std::min(text.size(), kShown))) {
    if (c >= ' ' && c <= '~') {
      quoted += c;
      continue;
    }
    constexpr std::string_view kHex = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    quoted += "\\x";
    quoted += kHex[byte >> 4];
    quoted += kHex[byte & 15];
  }
  return quoted + (text.size() > kShown ? "...\"" : "\"");
}

std::string TextScanner::number() const {
  const std::string_view text = token();
  return text.size() > kShown ? quoted(text) : std::string(text);
}

std::string TextScanner::found() const {
  if (at_end()) return "the end of the file";
  if (at_line_end()) return "the end of the line";
  const std::string_view text = token();
  return quoted(text.empty() ? rest().substr(0, 1) : text);  // a lone backslash is no token
}

}  // namespace halfedge::io
