#include <halfedge/sentence.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>

namespace halfedge::sentence {

void Part::append_to(std::string& sentence) const {
  if (text_.data() == kUnsigned) {
    sentence += std::to_string(static_cast<std::uint64_t>(number_));
    return;
  }
  sentence += text_;
  if (number_ == kNoNumber) return;
  if (!text_.empty()) sentence += ' ';
  sentence += !text_.empty() && number_ == kNone ? "none" : std::to_string(number_);
}

std::string fill_in(const char* pattern, std::initializer_list<Part> parts) {
  std::string sentence;
  sentence.reserve(std::strlen(pattern) + 20 * parts.size());
  for (const Part& part : parts) {
    const char* gap = pattern;
    while (gap[0] != '{' || gap[1] != '}') ++gap;
    sentence.append(pattern, static_cast<std::size_t>(gap - pattern));
    part.append_to(sentence);
    pattern = gap + 2;
  }
  return sentence += pattern;
}

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
  std::string list;
  for (std::size_t i = 0; i < items.size() && i < kListed; ++i) {
    if (i > 0) list += ", ";
    list += std::to_string(items[i]);
  }
  if (items.size() > kListed) list += " and others";
  return list;
}

std::string number(double value) {
  if (std::isnan(value)) return "nan";  // with a sign it would say no more
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string in_full(double value) {
  const bool has_digits = std::trunc(value) == value && std::abs(value) < 0x1p53;
  return has_digits ? std::to_string(static_cast<std::int64_t>(value)) : number(value);
}

}  // namespace halfedge::sentence
