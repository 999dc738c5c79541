#include <gtest/gtest.h>
#include <halfedge/io/number_reader.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace halfedge::io {
namespace {

/// What is read of the whole text; NaN if that isn't a number as a whole.
template <class T>
T read(const std::string& text) {
  T value = 0;
  const char* const end = text.data() + text.size();
  return read_number(text.data(), end, value) == end ? value : std::numeric_limits<T>::quiet_NaN();
}

template <class... Arguments>
std::string printed(const char* format, Arguments... arguments) {
  std::array<char, 1200> text;
  const int length = std::snprintf(text.data(), text.size(), format, arguments...);
  return {text.data(), static_cast<std::size_t>(length)};
}

/// Decimals of all lengths and sizes, from what a file has to what no program writes.
std::vector<std::string> decimals(std::mt19937_64& random) {
  const auto below = [&](int count) { return static_cast<int>(random() % unsigned(count)); };
  const auto number = [&] { return static_cast<unsigned long long>(random()); };
  const double shrunk = std::ldexp(static_cast<double>(random() >> 11U), -below(90));
  return {printed("%.6f", static_cast<double>(below(2'000'000'000) - 1'000'000'000) / 1e6),
          printed("%.*f", below(30), shrunk),
          printed("%.17g", shrunk),
          printed("%llue%d", number(), below(120) - 80),
          printed("%llue%d", number(), below(700) - 360),
          printed("%llu.%llu%llue%d", number(), number(), number(), below(120) - 80),
          printed("0.%0*llu", below(60) + 1, number())};
}

TEST(ReadNumber, AgreesWithTheStandardLibrary) {
  const unsigned seed = std::random_device{}();
  std::mt19937_64 random(seed);
  for (int i = 0; i < 20000; ++i) {
    for (const std::string& text : decimals(random)) {
      ASSERT_EQ(read<float>(text), std::strtof(text.c_str(), nullptr)) << text << ", seed " << seed;
      ASSERT_EQ(read<double>(text), std::strtod(text.c_str(), nullptr))
          << text << ", seed " << seed;
    }
  }
}

// Where one digit decides, however far behind.
TEST(ReadNumber, RoundsTheMiddleOfTwoFloatsToTheEvenOne) {
  const unsigned seed = std::random_device{}();
  std::mt19937 random(seed);
  for (int i = 0; i < 20000; ++i) {
    const auto bits =
        static_cast<std::uint32_t>(random()) % (i % 2 == 0 ? 0x7F7F'FFFFU : 0x80'0000U);
    const auto low = __builtin_bit_cast(float, bits);
    const auto high = __builtin_bit_cast(float, bits + 1);
    const double middle = (double{low} + double{high}) / 2;  // exact
    const std::string text = printed("%.160e", middle);
    const std::size_t exponent = text.find('e');
    const auto with = [&](const char* digits) {
      return text.substr(0, exponent) + digits + text.substr(exponent);
    };
    ASSERT_EQ(read<float>(text), bits % 2 == 0 ? low : high) << text << ", seed " << seed;
    ASSERT_EQ(read<float>(with("0000000000000000000000000001")), high) << text;
    ASSERT_EQ(read<float>(printed("%.160e", std::nextafter(middle, 0.0))), low) << text;
  }
}

TEST(ReadNumber, RoundsTheMiddleOfTwoDoublesToTheEvenOne) {
  EXPECT_EQ(read<double>("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(read<double>("9007199254740995"), 9007199254740996.0);
  EXPECT_EQ(read<double>("9007199254740993.0000000000000000000000000000001"), 9007199254740994.0);
  EXPECT_EQ(read<double>("2.4703282292062327208e-324"), 0.0);
  EXPECT_EQ(read<double>("2.4703282292062327209e-324"), 4.9e-324);
  EXPECT_EQ(read<double>("1.7976931348623158079e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(read<double>("1.7976931348623158080e308"), std::numeric_limits<double>::infinity());
}

TEST(ReadNumber, TakesTooLargeForInfiniteAndTooSmallForZero) {
  EXPECT_EQ(read<float>("3.4028235677973367e38"), std::numeric_limits<float>::infinity());
  EXPECT_EQ(read<float>("3.4028235677973366e38"), std::numeric_limits<float>::max());
  EXPECT_EQ(read<float>("7.1e-46"), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(read<float>("7.0e-46"), 0.0F);
  for (const char* text : {"1e99999999999999999999", "1e309"}) {
    EXPECT_EQ(read<float>(text), std::numeric_limits<float>::infinity());
    EXPECT_EQ(read<double>(text), std::numeric_limits<double>::infinity());
  }
  for (const char* text : {"1e-99999999999999999999", "0e99999999999999999999", "1e-400"}) {
    EXPECT_EQ(read<float>(text), 0.0F);
    EXPECT_EQ(read<double>(text), 0.0);
  }
  EXPECT_EQ(read<double>("0." + std::string(5000, '0') + "1e5001"), 1.0);
  EXPECT_EQ(read<double>("1" + std::string(5000, '0') + "e-5000"), 1.0);
}

TEST(ReadNumber, StopsWhereTheNumberEnds) {
  const auto length = [](const std::string& text) -> std::ptrdiff_t {
    float value = 0;
    const char* const stop = read_number(text.data(), text.data() + text.size(), value);
    return stop == nullptr ? -1 : stop - text.data();
  };
  for (const char* none : {"", "-", ".", "-.", "+1", "e5", "--1", "in", "na"}) {
    EXPECT_EQ(length(none), -1) << none;
  }
  EXPECT_EQ(length("1e"), 1);
  EXPECT_EQ(length("1e+"), 1);
  EXPECT_EQ(length("1.5.5"), 3);
  EXPECT_EQ(length("-.5e-3x"), 6);
  EXPECT_EQ(length("nan(ind),"), 8);
  EXPECT_EQ(length("nan(ind"), 3);
  EXPECT_EQ(length("-INFINITY"), 9);
  EXPECT_EQ(length("infinit"), 3);
}

}  // namespace
}  // namespace halfedge::io
