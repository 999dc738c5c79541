#include <gtest/gtest.h>
#include <halfedge/build/sentence.h>

#include <cstdio>
#include <limits>
#include <random>
#include <string>

namespace halfedge {
namespace {

std::string as_printf(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

TEST(SentenceNumber, IsThatOfPrintf) {
  for (const double value : {0.0,         -0.0,
                             1.0,         -1.0,
                             0.5,         0.1,
                             0.3,         1e-3,
                             1e-4,        1e-5,
                             0.000123456, 123456.0,
                             999999.0,    999999.6,
                             1e6,         1234567.0,
                             1e30,        1e-30,
                             3.4e38,      1e300,
                             4.9e-324,    1.7976931348623157e308,
                             99.99996,    0.0999999999}) {
    EXPECT_EQ(sentence::number(value), as_printf(value));
    EXPECT_EQ(sentence::number(-value), as_printf(-value));
  }
  EXPECT_EQ(sentence::number(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(sentence::number(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(SentenceNumber, IsThatOfPrintfForRandomNumbers) {
  constexpr unsigned kSeed = 7;
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  for (int i = 0; i < 20000; ++i) {
    const double value =
        std::stod(as_printf(mantissa(random)) + "e" + std::to_string(int(random() % 600) - 300));
    ASSERT_EQ(sentence::number(value), as_printf(value)) << "seed " << kSeed;
  }
}

TEST(SentenceCount, KnowsPlurals) {
  EXPECT_EQ(sentence::count_of(1, "vertex"), "1 vertex");
  EXPECT_EQ(sentence::count_of(2, "vertex"), "2 vertices");
  EXPECT_EQ(sentence::count_of(0, "boundary vertex"), "0 boundary vertices");
  EXPECT_EQ(sentence::count_of(3, "face"), "3 faces");
}

}  // namespace
}  // namespace halfedge
