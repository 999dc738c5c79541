#include <halfedge/inlining.h>
#include <halfedge/io/number_reader.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace halfedge::io {
namespace {

constexpr std::array<double, 23> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::int64_t kLargestPower = 22;  // all of them are exact
constexpr int kWordDigits = 19;             // as many as 64 bits hold

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The value is that of the digits between `begin` and `end`, with a point among them or not, times
/// 10^exponent.
struct Decimal {
  const char* begin;
  const char* end;
  std::int64_t exponent;
};

/// What the slow path knows of float and of double.
template <class T>
struct Traits;
template <>
struct Traits<float> {
  using Bits = std::uint32_t;
  static constexpr int kFractionBits = 23;
  static constexpr int kBias = 150;    // of the exponent, the fraction taken for a whole number
  static constexpr int kDigits = 128;  // the middle of two floats has at most 113
  static constexpr std::size_t kWords = 32;
};
template <>
struct Traits<double> {
  using Bits = std::uint64_t;
  static constexpr int kFractionBits = 52;
  static constexpr int kBias = 1075;
  static constexpr int kDigits = 800;  // 768
  static constexpr std::size_t kWords = 160;
};

/// A natural number: words of 32 bits, the lowest first. Has room for what compare() needs.
template <class T>
class Natural {
 public:
  explicit Natural(std::uint64_t value)
      : words_{static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32U)},
        size_(value == 0 ? 0 : 2) {
    if (size_ == 2 && words_[1] == 0) size_ = 1;
  }

  void multiply(std::uint32_t factor, std::uint32_t plus = 0) {
    std::uint64_t carry = plus;
    for (std::size_t i = 0; i < size_; ++i) {
      carry += std::uint64_t{words_[i]} * factor;
      words_[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32U;
    }
    if (carry != 0) words_[size_++] = static_cast<std::uint32_t>(carry);
  }
  void multiply_by_power(std::uint32_t base, std::int64_t exponent) {
    for (; exponent >= 8; exponent -= 8) {
      const std::uint32_t square = base * base;
      multiply(square * square), multiply(square * square);
    }
    for (; exponent > 0; --exponent) multiply(base);
  }

  friend int compare(const Natural& a, const Natural& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
    for (std::size_t i = a.size_; i-- > 0;) {
      if (a.words_[i] != b.words_[i]) return a.words_[i] < b.words_[i] ? -1 : 1;
    }
    return 0;
  }

 private:
  std::array<std::uint32_t, Traits<T>::kWords> words_;
  std::size_t size_;
};

/// Compares the number with the middle of the float or double with these bits and of the next.
/// pre: it is a few of them away at most
template <class T>
int compare_with_middle(const Decimal& number, typename Traits<T>::Bits bits) {
  // Of the digits that no such middle has it is enough to know whether they are all zeros.
  Natural<T> digits(0);
  std::int64_t exponent = number.exponent;
  int count = 0;
  bool more = false;
  for (const char* p = number.begin; p != number.end; ++p) {
    if (*p == '.' || (count == 0 && *p == '0')) continue;
    if (count < Traits<T>::kDigits) {
      digits.multiply(10, static_cast<std::uint32_t>(*p - '0'));
      ++count;
    } else {
      more |= *p != '0';
      ++exponent;
    }
  }
  using Bits = typename Traits<T>::Bits;
  constexpr Bits kHidden = Bits{1} << Traits<T>::kFractionBits;
  const Bits biased = bits / kHidden;
  const Bits fraction = bits % kHidden + (biased == 0 ? 0 : kHidden);
  const int power = static_cast<int>(std::max(biased, Bits{1})) - Traits<T>::kBias - 1;
  Natural<T> middle(2 * fraction + 1);
  digits.multiply_by_power(10, exponent);
  middle.multiply_by_power(10, -exponent);
  middle.multiply_by_power(2, power);
  digits.multiply_by_power(2, -power);
  const int order = compare(digits, middle);
  return order == 0 && more ? 1 : order;
}

/// The nearest to the number, of which `near` is a few units in its last place away.
template <class T>
HALFEDGE_COLD T round_exactly(const Decimal& number, T near) {
  using Bits = typename Traits<T>::Bits;
  auto bits = __builtin_bit_cast(Bits, std::min(near, std::numeric_limits<T>::max()));
  const auto is_beyond = [&](Bits below) {  // so that it is nearer to the next, or even
    const int order = compare_with_middle<T>(number, below);
    return order > 0 || (order == 0 && below % 2 != 0);
  };
  while (bits > 0 && !is_beyond(bits - 1)) --bits;
  constexpr auto kInfinite = __builtin_bit_cast(Bits, std::numeric_limits<T>::infinity());
  while (bits < kInfinite && is_beyond(bits)) ++bits;
  return __builtin_bit_cast(T, bits);
}

/// The word times 10^exponent, each step rounded. pre: it is no more than 10^400 or so
double scaled(std::uint64_t word, std::int64_t exponent) {
  auto near = static_cast<double>(word);
  for (; exponent > kLargestPower; exponent -= kLargestPower) near *= kPowersOfTen[kLargestPower];
  for (; exponent < -kLargestPower; exponent += kLargestPower) near /= kPowersOfTen[kLargestPower];
  return exponent >= 0 ? near * kPowersOfTen[static_cast<std::size_t>(exponent)]
                       : near / kPowersOfTen[static_cast<std::size_t>(-exponent)];
}

// Both are given the digits as a word, or the first nineteen of them.

void convert(const Decimal& number, std::uint64_t word, std::int64_t exponent, float& value) {
  if (word == 0 || exponent < -65) {
    value = 0;
    return;
  }
  if (exponent > 38) {
    value = std::numeric_limits<float>::infinity();
    return;
  }
  // Up to four roundings, and the digits left out, make less than five units in the last place. So
  // rounding once more gives the right float unless these lead across the middle of two.
  const double near = scaled(word, exponent);
  constexpr std::uint64_t kCut = 0x1FFF'FFFF;  // bits of a double that a float lacks
  constexpr std::uint64_t kMiddle = 0x1000'0000;
  constexpr std::uint64_t kDoubt = 8;
  const std::uint64_t cut = __builtin_bit_cast(std::uint64_t, near) & kCut;
  constexpr double kTooLarge = 3.5e38;
  value = near < kTooLarge ? static_cast<float>(near) : std::numeric_limits<float>::infinity();
  const bool in_doubt = cut - (kMiddle - kDoubt) <= 2 * kDoubt;
  if ((in_doubt || near < double{std::numeric_limits<float>::min()}) && near > 1e-46) [[unlikely]]
    if (near < kTooLarge) value = round_exactly(number, value);
}

void convert(const Decimal& number, std::uint64_t word, std::int64_t exponent, double& value) {
  value = 0;
  if (word == 0 || exponent < -343) return;
  value = std::numeric_limits<double>::infinity();
  if (exponent > 308) return;
  value = scaled(word, exponent);
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53U;
  const bool is_exact = word <= kExact && -kLargestPower <= exponent && exponent <= kLargestPower;
  if (!is_exact) value = round_exactly(number, value);
}

/// The first nineteen digits but for zeros in front; `exponent` grows by those that are left out.
HALFEDGE_COLD std::uint64_t leading_digits(const Decimal& number, std::int64_t& exponent) {
  std::uint64_t word = 0;
  int count = 0;
  for (const char* p = number.begin; p != number.end; ++p) {
    if (*p == '.' || (count == 0 && *p == '0')) continue;
    if (count++ < kWordDigits) {
      word = 10 * word + static_cast<std::uint64_t>(*p - '0');
    } else {
      ++exponent;
    }
  }
  return word;
}

/// Whether `text` starts with the word, which is in small letters.
bool starts_with_word(std::string_view text, std::string_view word) {
  return text.size() >= word.size() &&
         std::equal(word.begin(), word.end(), text.begin(),
                    [](char small, char c) { return c == small || c == small - 'a' + 'A'; });
}

template <class T>
HALFEDGE_COLD const char* read_word(const char* p, const char* end, T& value) {
  const std::string_view text(p, static_cast<std::size_t>(end - p));
  for (const std::string_view word : {"infinity", "inf"}) {
    if (!starts_with_word(text, word)) continue;
    value = std::numeric_limits<T>::infinity();
    return p + word.size();
  }
  if (!starts_with_word(text, "nan")) return nullptr;
  value = std::numeric_limits<T>::quiet_NaN();
  p += 3;
  if (p == end || *p != '(') return p;
  const char* const close = std::find_if(p + 1, end, [](char c) {
    return !is_digit(c) && !(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z') && c != '_';
  });
  return close != end && *close == ')' ? close + 1 : p;
}

template <class T>
const char* read(const char* p, const char* end, T& value) {
  const bool negative = p != end && *p == '-';
  if (negative) ++p;
  Decimal number{p, p, 0};
  std::uint64_t word = 0;
  for (; p != end && is_digit(*p); ++p) word = 10 * word + static_cast<std::uint64_t>(*p - '0');
  std::ptrdiff_t count = p - number.begin;
  if (p != end && *p == '.') {
    const char* const point = p++;
    for (; p != end && is_digit(*p); ++p) word = 10 * word + static_cast<std::uint64_t>(*p - '0');
    number.exponent = point + 1 - p;
    count += p - point - 1;
  }
  number.end = p;
  if (count == 0) {
    p = read_word(number.begin, end, value);
    if (p != nullptr && negative) value = -value;
    return p;
  }
  if (p != end && (*p == 'e' || *p == 'E')) {
    const char* digits = p + 1;
    const bool down = digits != end && *digits == '-';
    if (digits != end && (*digits == '-' || *digits == '+')) ++digits;
    constexpr std::int64_t kEnough = 1'000'000'000'000'000;  // whatever digits there are
    std::int64_t power = 0;
    for (const char* q = digits; q != end && is_digit(*q); p = ++q) {
      if (power < kEnough) power = 10 * power + (*q - '0');
    }
    number.exponent += down ? -power : power;
  }
  std::int64_t exponent = number.exponent;
  if (count > kWordDigits) [[unlikely]]
    word = leading_digits(number, exponent);
  convert(number, word, exponent, value);
  if (negative) value = -value;
  return p;
}

}  // namespace

const char* read_number(const char* p, const char* end, float& value) {
  return read(p, end, value);
}
const char* read_number(const char* p, const char* end, double& value) {
  return read(p, end, value);
}

}  // namespace halfedge::io
