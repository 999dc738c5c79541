#include <gtest/gtest.h>
#include <halfedge/sentence.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace halfedge {
namespace {

TEST(Sentence, IsFilledIn) {
  EXPECT_EQ(sentence::of("{} has degree {}, expected {}", Face(7), 3U, "four"),
            "face 7 has degree 3, expected four");
  EXPECT_EQ(sentence::of("{}{}", std::string("a"), std::string_view("bcd").substr(0, 2)), "abc");
  EXPECT_EQ(sentence::of("{} of {}", -5, std::uint64_t{1} << 40U), "-5 of 1099511627776");
  EXPECT_EQ(sentence::of("{} of {}", 7U, UINT64_MAX), "7 of 18446744073709551615");
}

TEST(Sentence, SaysNoneOfAnEmptyItem) {
  EXPECT_EQ(sentence::of("next of {} is {}", Halfedge(0), Halfedge()),
            "next of halfedge 0 is halfedge none");
  EXPECT_EQ(sentence::of("{}", kNone), "4294967295");
}

TEST(SentenceNumber, HasAsFewDigitsAsTellItFromOthers) {
  EXPECT_EQ(sentence::number(0.5), "0.5");
  EXPECT_EQ(sentence::number(-3), "-3");
  EXPECT_EQ(sentence::number(double(0.1F)), "0.1");
  EXPECT_EQ(sentence::number(999999.6), "1e+06");
  EXPECT_EQ(sentence::number(1.7976931348623157e308), "1.79769e+308");
  EXPECT_EQ(sentence::number(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(sentence::number(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(SentenceCount, KnowsPlurals) {
  EXPECT_EQ(sentence::count_of(1, "vertex"), "1 vertex");
  EXPECT_EQ(sentence::count_of(2, "vertex"), "2 vertices");
  EXPECT_EQ(sentence::count_of(0, "boundary vertex"), "0 boundary vertices");
  EXPECT_EQ(sentence::count_of(3, "face"), "3 faces");
}

}  // namespace
}  // namespace halfedge
