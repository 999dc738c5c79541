#include <halfedge/build/sentence.h>

#include <cmath>
#include <cstddef>

namespace halfedge::sentence {

std::string complete(std::string text) {
  if ('a' <= text[0] && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  text += '.';
  return text;
}

std::string count_of(std::uint64_t count, std::string noun) {
  std::string text = std::to_string(count) + " ";
  if (count != 1) {
    if (noun.ends_with("vertex")) {
      noun.replace(noun.size() - 2, 2, "ices");
    } else {
      noun += 's';
    }
  }
  return text + noun;
}

std::string list_of(std::span<const Index> items) {
  constexpr std::size_t kShown = 8;
  std::string list;
  for (std::size_t i = 0; i < items.size() && i < kShown; ++i) {
    if (i > 0) list += ", ";
    list += std::to_string(items[i]);
  }
  if (items.size() > kShown) list += ", ...";
  return list;
}

std::string number(double value) {
  constexpr int kDigits = 6;
  std::string text = std::signbit(value) ? "-" : "";
  if (std::isnan(value)) return text + "nan";
  if (std::isinf(value)) return text + "inf";
  if (value == 0) return text + "0";

  // value = 0.digits * 10^point
  double scaled = std::fabs(value);
  int point = 0;
  for (; scaled >= 1; scaled /= 10) ++point;
  for (; scaled < 0.1; scaled *= 10) --point;
  std::string digits = std::to_string(std::llround(scaled * 1e6));
  if (digits.size() > kDigits) ++point;  // rounded up to the next power of ten
  digits.erase(digits.find_last_not_of('0') + 1);

  const int count = int(digits.size());
  if (point < -3 || point > kDigits) {
    if (count > 1) digits.insert(1, ".");
    const int exponent = point - 1;
    const int size = exponent < 0 ? -exponent : exponent;
    return text + digits + (exponent < 0 ? "e-" : "e+") + (size < 10 ? "0" : "") +
           std::to_string(size);
  }
  if (point <= 0) return text + "0." + std::string(std::size_t(-point), '0') + digits;
  if (count > point) return text + digits.insert(std::size_t(point), ".");
  return text + digits + std::string(std::size_t(point - count), '0');
}

}  // namespace halfedge::sentence
