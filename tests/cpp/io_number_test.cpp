#include <gtest/gtest.h>
#include <halfedge/io/parse.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "support/text_file.h"

namespace halfedge {
namespace {

using test::obj_error;
using test::parse_obj;

std::uint32_t bits(float value) {
  std::uint32_t b;
  std::memcpy(&b, &value, sizeof b);
  return b;
}

/// What a vertex reads as its x; a test failure if it is refused.
float read(const std::string& number) {
  const test::Parsed file = parse_obj("v " + number + " 0 0\n");
  EXPECT_EQ(file.error, "") << number;
  return file.positions.empty() ? 0 : file.positions[0];
}

TEST(Number, ReadsEveryForm) {
  const std::pair<const char*, float> forms[] = {{"0", 0.0F},
                                                 {"-0", -0.0F},
                                                 {"+1", 1.0F},
                                                 {"1.", 1.0F},
                                                 {".5", 0.5F},
                                                 {"-.5", -0.5F},
                                                 {"+.5", 0.5F},
                                                 {"+2.", 2.0F},
                                                 {"1e5", 1e5F},
                                                 {"1E5", 1e5F},
                                                 {"1e+5", 1e5F},
                                                 {"1e-5", 1e-5F},
                                                 {"2.e1", 20.0F},
                                                 {"+3.1e2", 310.0F},
                                                 {".8e-1", 0.08F},
                                                 {"2.e01", 20.0F},
                                                 {"0000.25", 0.25F},
                                                 {"1e0", 1.0F},
                                                 {"100", 100.0F},
                                                 {"-7", -7.0F},
                                                 {"1e39", INFINITY},
                                                 {"-1e999", -INFINITY},
                                                 {"1e-99", 0.0F},
                                                 {"3.4028235e38", 3.4028235e38F},
                                                 {"1e-45", 1.4012985e-45F}};
  for (const auto& [text, value] : forms) EXPECT_EQ(bits(read(text)), bits(value)) << text;
}

TEST(Number, ReadsTheSpellingsOfInfinityAndNan) {
  for (const char* text : {"inf", "Inf", "INF", "infinity", "+inf", "1.#INF", "1.#INF00"}) {
    EXPECT_EQ(read(text), INFINITY) << text;
  }
  for (const char* text : {"-inf", "-Infinity", "-1.#INF"})
    EXPECT_EQ(read(text), -INFINITY) << text;
  for (const char* text :
       {"nan", "NaN", "-nan", "nan(ind)", "1.#IND", "-1.#IND", "1.#QNAN", "1.#SNAN"}) {
    EXPECT_TRUE(std::isnan(read(text))) << text;
  }
}

TEST(Number, RefusesWhatIsNone) {
  for (const char* text :
       {"abc", "-",   "+",   ".",   "e5",    "1e", "1e+",    "1,5",     "0x10", "1..2",    "1.2.3",
        "--1", "+-1", "-+1", "++1", "1_000", "1f", "3.1+e2", "infinit", "nanx", "1.#INFx", "1/2"}) {
    EXPECT_EQ(obj_error(std::string("v 0 0 ") + text + "\n"),
              std::string("parse-error: line 1: expected a number for z of the vertex, found \"") +
                  (text == std::string("1.#INFx") ? "1." : text) + "\"");
  }
}

TEST(Number, RoundsOnceAndCorrectly) {
  // Just below the middle of two floats: the nearest double is that middle, and rounding it again
  // goes to the wrong, even neighbour.
  EXPECT_EQ(bits(read("1.00000017881393432617187499")), bits(1.00000011920928955F));
  EXPECT_EQ(bits(read("1.00000017881393432617187501")), bits(1.00000023841857910F));
  EXPECT_EQ(bits(read("16777217.0000000000000000001")), bits(16777218.0F));
  EXPECT_EQ(bits(read("0." + std::string(200, '0') + "1e201")), bits(1.0F));
  EXPECT_EQ(bits(read("1" + std::string(400, '0') + "e-400")), bits(1.0F));
}

TEST(Number, AgreesWithTheStandardLibraryOnRandomFloats) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const char* const formats[] = {"%.9g", "%.6f", "%.17g", "%.3e", "%g", "%.30f"};
  std::string text;
  std::vector<float> expected;
  for (int i = 0; i < 30000; ++i) {
    const auto raw = static_cast<std::uint32_t>(random());
    float value;
    std::memcpy(&value, &raw, sizeof value);
    if (!std::isfinite(value)) continue;
    char digits[512];
    std::snprintf(digits, sizeof digits, formats[random() % 6], static_cast<double>(value));
    expected.push_back(std::strtof(digits, nullptr));
    text += std::string("v ") + digits + " 0 0\n";
  }
  const test::Parsed file = parse_obj(text);
  ASSERT_EQ(file.error, "");
  ASSERT_EQ(file.positions.size(), 3 * expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(bits(file.positions[3 * i]), bits(expected[i])) << "vertex " << i;
  }
}

}  // namespace
}  // namespace halfedge
