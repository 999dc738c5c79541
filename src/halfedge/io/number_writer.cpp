#include <fast_float/fast_float.h>
#include <halfedge/io/number_writer.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace halfedge::io {
namespace {

/// Powers of ten that a double holds exactly.
constexpr int kMaxPower = 22;
constexpr double kPowers[kMaxPower + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                           1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                           1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// digits * 10^exponent, correctly rounded where |exponent| <= kMaxPower, else nearly.
double scaled(double digits, int exponent) {
  for (; exponent < -kMaxPower; exponent += kMaxPower) digits /= kPowers[kMaxPower];
  for (; exponent > kMaxPower; exponent -= kMaxPower) digits *= kPowers[kMaxPower];
  return exponent < 0 ? digits / kPowers[-exponent] : digits * kPowers[exponent];
}

/// Whether digits * 10^exponent reads as `value`. As a double in the middle between two floats it
/// tells only then on which side of it the number lies, if it is exactly the number.
bool reads_as(double digits, int exponent, float value) {
  const double rounded = scaled(digits, exponent);
  if (static_cast<float>(rounded) != value) return false;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &rounded, sizeof(bits));
  constexpr std::uint64_t kBeyondFloat = (std::uint64_t{1} << 29U) - 1;
  const bool middle = (bits & kBeyondFloat) == std::uint64_t{1} << 28U;
  return !middle || exponent >= 0 || std::fma(rounded, kPowers[-exponent], -digits) == 0;
}

/// The decimal number digits * 10^exponent.
struct Decimal {
  std::uint32_t digits = 0;
  int exponent = 0;
};

/// `value` to so many digits, without zeros at their end. `magnitude`: of its first digit.
Decimal rounded(float value, int magnitude, int count) {
  const int exponent = magnitude + 1 - count;
  const double digits = std::nearbyint(scaled(static_cast<double>(value), -exponent));
  Decimal result{static_cast<std::uint32_t>(digits), exponent};
  for (; result.digits % 10 == 0; result.digits /= 10) ++result.exponent;
  return result;
}

/// The power of ten at or below the value. pre: 10^lowest <= value, nearly
int magnitude_of(float value, int lowest) {
  int magnitude = lowest;
  while (static_cast<double>(value) >= scaled(1, magnitude + 1)) ++magnitude;
  return magnitude;
}

// Six digits suffice if any number of fewer does, with zeros at their end.
constexpr int kFewest = 6;
constexpr int kMost = 9;

/// pre: 1e-6 <= value < 1e9, where powers of ten are exact and floats normal
bool shortest(float value, Decimal& result) {
  const int magnitude = magnitude_of(value, -6);
  for (int count = kFewest; count <= kMost; ++count) {
    result = rounded(value, magnitude, count);
    if (reads_as(static_cast<double>(result.digits), result.exponent, value)) return true;
  }
  return false;
}

/// pre: the number is not 0, and as shortest() makes them
char* write_decimal(char* out, Decimal number) {
  char digits[10];
  const auto end = std::to_chars(digits, digits + sizeof(digits), number.digits).ptr;
  const int count = static_cast<int>(end - digits);
  const int whole = count + number.exponent;  // digits before the point
  if (whole <= 0) {
    *out++ = '0';
    *out++ = '.';
    for (int i = whole; i < 0; ++i) *out++ = '0';
  }
  for (int i = 0; i < count; ++i) {
    if (i == whole && i > 0) *out++ = '.';
    *out++ = digits[i];
  }
  for (int i = 0; i < number.exponent; ++i) *out++ = '0';
  return out;
}

/// 1.5e-30. For what no model has as a coordinate: tried by reading it.
char* write_scientific(char* out, float value) {
  const int magnitude = magnitude_of(value, -45);
  for (int count = kFewest;; ++count) {
    const Decimal number = rounded(value, magnitude, count);
    char* const end = std::to_chars(out + 1, out + kMaxNumberLength, number.digits).ptr;
    const int after_point = static_cast<int>(end - out) - 2;
    out[0] = out[1];
    out[1] = '.';
    char* const mantissa_end = after_point == 0 ? out + 1 : end;
    *mantissa_end = 'e';
    char* const stop =
        std::to_chars(mantissa_end + 1, out + kMaxNumberLength, number.exponent + after_point).ptr;
    float read = 0;
    (void)fast_float::from_chars(out, stop, read);
    if (read == value || count == kMost) return stop;
  }
}

char* write_word(char* out, std::string_view word) {
  std::memcpy(out, word.data(), word.size());
  return out + word.size();
}

}  // namespace

char* write_float(char* out, float value) {
  if (std::isnan(value)) return write_word(out, "nan");
  if (std::signbit(value)) {
    *out++ = '-';
    value = -value;
  }
  if (value == 0) return write_word(out, "0");
  if (std::isinf(value)) return write_word(out, "inf");
  Decimal number;
  if (value >= 1e-6F && value < 1e9F && shortest(value, number)) {
    return write_decimal(out, number);
  }
  return write_scientific(out, value);
}

char* write_index(char* out, Index value) {
  return std::to_chars(out, out + kMaxNumberLength, value).ptr;
}

// Seldom, so it may be slow: tried by reading it.
char* write_double(char* out, double value) {
  if (std::isnan(value)) return write_word(out, "nan");
  char text[40];
  int length = 0;
  for (int digits = 15; digits <= 17; ++digits) {
    length = std::snprintf(text, sizeof(text), "%.*g", digits, value);
    std::replace(text, text + length, ',', '.');  // of the language that the program is set to
    double read = 0;
    (void)fast_float::from_chars(text, text + length, read);
    if (read == value) break;
  }
  return write_word(out, {text, static_cast<std::size_t>(length)});
}

namespace {

template <class T>
T number_at(const void* value) {
  T number;
  std::memcpy(&number, value, sizeof(number));
  return number;
}

}  // namespace

char* write_number(char* out, Scalar type, const void* value) {
  std::int64_t integer = 0;
  switch (type) {
    case Scalar::kFloat32:
      return write_float(out, number_at<float>(value));
    case Scalar::kFloat64:
      return write_double(out, number_at<double>(value));
    case Scalar::kInt8:
      integer = int{number_at<std::int8_t>(value)};
      break;
    case Scalar::kUint8:
      integer = number_at<std::uint8_t>(value);
      break;
    case Scalar::kInt16:
      integer = number_at<std::int16_t>(value);
      break;
    case Scalar::kUint16:
      integer = number_at<std::uint16_t>(value);
      break;
    case Scalar::kInt32:
      integer = number_at<std::int32_t>(value);
      break;
    case Scalar::kUint32:
      return write_index(out, number_at<Index>(value));
  }
  return std::to_chars(out, out + kMaxNumberLength, integer).ptr;
}

}  // namespace halfedge::io
