// Bytes that no well-meaning program writes. Run under the sanitizers, these tests show that no
// reader leaves its buffer; each text is parsed from a block of memory of just its size.

#include <gtest/gtest.h>
#include <halfedge/io/parse.h>

#include <cstring>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "support/text_file.h"
#include "support/whole_soup.h"

namespace halfedge {
namespace {

using namespace std::string_literals;

/// Small files that reach every statement and every branch of the readers.
const std::vector<std::string> kSeeds = {
    R"(# obj
mtllib a.mtl
v 0 0 0 1
v 1.5 -.5e-3 +2. # c
v 0 1 0
f 1/1/1 2//2 3/3
)",
    R"(v 0 0 \
0
v 1 0 0
v 1 1 0
v 0 1 0
f 1 2 \
3 4
f -4 -3 -2
f 4 5 6
v 2 2 2
v 3 3 3
)",
    R"(v nan inf -infinity
v 1.#IND -1.#INF00 nan(1)
v 1e999 1e-999 0
l 1 2
p 1
xyz
f 1 2 3
)",
    R"(v 1.00000017881393432617187499 123456789012345678901234567890 1e-30
f 99999999999999999999
)",
    "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n",
    R"(OFF
4 2 5
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3 255 0 0
3 0 1 2
)",
    R"(# c
 STCN4OFF4 2
0 0 0 1 # c
1 0 0 2
1 1 0 0
0 1 0 1

3 0 1 2
2 3 1
trailing)",
    R"(OFF 4 1
0
0 0 1 0
0
1 1 0 0 1 0
4 0
1 2
3)",
    R"(nOFF 3 3 1 3 0 0 0 1 0 0 1 1 0
3 0 1 2
)",
    R"(3 1 3
0 0 0 1 0 0
0 1 0
3 0 1 2)",
    "OFF BINARY\n\0\0\0\4"s,
    "COFF BINARY\n\0\0\0\2\0\0\0\2\0\0\0\0"s + std::string(56, '\1') +
        "\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0\0"s + "\0\0\0\1\0\0\0\1\0\0\0\0"s,
    "4OFF BINARY\r\n\1\0\0\0\1\0\0\0\0\0\0\0"s + std::string(16, '\1') +
        "\2\0\0\0\0\0\0\0\0\0\0\0"s,
    "\xEF\xBB\xBFOFF\r4 0 0\r1 2 3\r\r1 2 3\r1 2 3\r1 2 3",
    R"(ply
format ascii 1.0
comment c
element vertex 3
property float x
property double y
property uchar z
property uchar red
element face 2
property list uchar int vertex_indices
property list int float uv
element edge 1
property int a
end_header
0 .5 1 2
1 0 0 3
0 1 0 4
3 0 1 2 1 .5
4 2 1 0 1 0
7
)",
    "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar uint vertex_index\nend_header\n"s +
        std::string(36, '\0') + "\3\0\0\0\0\1\0\0\0\2\0\0\0\2\0\0\0\0\1\0\0\0"s,
    "ply\rformat binary_big_endian 1.0\relement vertex 2\rproperty char x\rproperty short y\r"
    "property double z\relement tristrips 1\rproperty list ushort char vertex_indices\rend_header\r"s +
        std::string(22, '\1') + "\0\6\0\1\0\xFF\1\0"s,
    R"(solid a
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 1 1 0
endloop
endfacet
endsolid
)",
    std::string(80, ' ') + "\2\0\0\0"s + std::string(50, '\0') + std::string(50, '\1'),
};

/// Parses in every way. What was read is whole, and what was refused says why.
void survive(std::string_view text) {
  std::unique_ptr<std::uint8_t[]> block(new std::uint8_t[text.size()]);
  if (!text.empty()) std::memcpy(block.get(), text.data(), text.size());
  const std::span<const std::uint8_t> bytes(block.get(), text.size());

  for (const Result<ParsedFile>& file :
       {parse(bytes), parse(bytes, Format::kObj), parse(bytes, Format::kOff),
        parse(bytes, Format::kPly), parse(bytes, Format::kStl), read_obj(bytes), read_off(bytes),
        read_ply(bytes), read_stl(bytes)}) {
    if (!file) {
      ASSERT_FALSE(file.error().code.empty());
      ASSERT_FALSE(file.error().message.empty());
      for (const char c : file.error().message) ASSERT_TRUE(c >= ' ' && c <= '~');
      continue;
    }
    test::expect_whole(file.value().soup, true);

    const std::vector<Index> faces = {0, 1, 1000};
    for (const std::size_t line : lines_of_faces(bytes, file.value().format, faces)) {
      ASSERT_LE(line, text.size() + 1);
    }
  }
}

TEST(Hostile, EveryPrefixAndSuffixOfAFile) {
  for (const std::string& seed : kSeeds) {
    SCOPED_TRACE(seed);
    for (std::size_t i = 0; i <= seed.size(); ++i) {
      survive(std::string_view(seed).substr(0, i));
      survive(std::string_view(seed).substr(i));
    }
  }
}

TEST(Hostile, EveryByteInEveryPlace) {
  for (const std::string& seed : kSeeds) {
    for (std::size_t i = 0; i < seed.size(); ++i) {
      std::string text = seed;
      for (const char c : "\0\n\r\\#/+-.0179 \t\x7F\xFF\xFEvfeO"s) {
        text[i] = c;
        survive(text);
      }
    }
  }
}

TEST(Hostile, RandomMutations) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const auto below = [&random](std::size_t n) { return random() % n; };
  const std::string dictionary[] = {"f",      "v ",         "\n",          "\r",
                                    "\\\n",   "/",          "//",          "-",
                                    "1",      "0",          " ",           "#",
                                    "OFF",    "4294967303", "-2147483649", "9223372036854775808",
                                    "nan",    "1e400",      "\0"s,         "\xEF\xBB\xBF",
                                    "1.#IND", ".",          "element",     "vertex",
                                    "int",    "list",       "4294967295",  "\xFF\xFF\xFF\xFF"};
  for (int round = 0; round < 3000; ++round) {
    std::string text = kSeeds[below(kSeeds.size())];
    for (std::size_t edits = 1 + below(8); edits > 0; --edits) {
      const std::size_t at = below(text.size() + 1);
      switch (below(5)) {
        case 0:
          text.insert(at, dictionary[below(std::size(dictionary))]);
          break;
        case 1:
          text.erase(at, below(12));
          break;
        case 2:
          if (at < text.size()) text[at] = static_cast<char>(below(256));
          break;
        case 3:
          text.insert(at, text.substr(below(text.size() + 1), below(40)));
          break;
        default: {
          const std::string& other = kSeeds[below(kSeeds.size())];
          text = text.substr(0, at) + other.substr(below(other.size() + 1));
        }
      }
    }
    survive(text);
    ASSERT_FALSE(testing::Test::HasFailure()) << testing::PrintToString(text);
  }
}

TEST(Hostile, RandomBytes) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::string alphabet = "vf 0123456789-+./e#\\\n\r\tOFNan";
  for (int round = 0; round < 3000; ++round) {
    std::string text(random() % 200, ' ');
    const bool any = round % 3 == 0;
    for (char& c : text) {
      c = any ? static_cast<char>(random() % 256) : alphabet[random() % alphabet.size()];
    }
    survive(text);
    survive("v 0 0 0\n" + text);
    survive("OFF\n4 4 4\n0 0 0\n" + text);
    survive("solid\nfacet\nouter loop\nvertex " + text);
    survive("ply\nformat ascii 1.0\n" + text);
  }
}

TEST(Hostile, OverlongLines) {
  const std::string spaces(1 << 20, ' ');
  const std::string digits(1 << 20, '1');
  survive("v" + spaces + "0 0 0\nf" + spaces + "1 1 1" + spaces);
  survive("v " + digits + " 0." + digits + " 0\nf " + digits + " 1 1\n");
  survive("#" + digits + "\nv 0 0 0\n");
  survive("OFF " + digits + " " + digits + "\n" + spaces);
  survive("OFF\n1 1\n0 0 0\n" + digits + " 0");
  std::string face = "v 0 0 0\nf";
  for (int i = 0; i < 100000; ++i) face += " 1";
  const test::Parsed file = test::parse_obj(face);
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces.at(0), std::vector<Index>(100000, 0));
}

std::string repeated(std::string_view text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// A header of vertices and faces of single bytes.
std::string ply_of_bytes(std::size_t vertices, std::size_t faces) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty char x\nproperty char y\nproperty char z\nelement face " +
         std::to_string(faces) + "\nproperty list char char vertex_index\nend_header\n";
}

/// The rest of a binary STL file, of triangles that share nothing.
std::string different_triangles(std::size_t count) {
  std::string all(50 * count, '\0');
  for (std::size_t i = 0; i < 3 * count; ++i) {
    const auto x = static_cast<float>(i);
    std::memcpy(&all[50 * (i / 3) + 12 + 12 * (i % 3)], &x, sizeof(x));
  }
  return all;
}

// Lines as short as can be, where the arrays are as large as can be beside them.
TEST(Hostile, MemoryStaysInProportionToTheFile) {
  const std::string texts[] = {repeated("v 0 0 0\n", 100000),
                               repeated("f\n", 100000) + "v 0 0 0\n",
                               "v 0 0 0\nf" + repeated(" 1", 100000),
                               "v 0 0 0\n" + repeated("f 1 1 1\n", 100000),
                               "OFF\n100000 0\n" + repeated("0 0 0\n", 100000),
                               "OFF\n1 100000\n0 0 0\n" + repeated("0\n", 100000),
                               "OFF\n1 100000\n0 0 0\n" + repeated("1 0\n", 100000),
                               "OFF\n1 1\n0 0 0\n50000" + repeated(" 0", 50000),
                               ply_of_bytes(100000, 0) + repeated("abc", 100000),
                               ply_of_bytes(1, 100000) + "abc" + repeated("\0"s, 100000),
                               ply_of_bytes(1, 100000) + "abc" + repeated("\1\0"s, 100000),
                               repeated(" ", 80) + "\xA0\x86\1\0"s + different_triangles(100000)};
  for (const std::string& text : texts) {
    SCOPED_TRACE(text.substr(0, 30));
    const auto file = parse(test::bytes_of(text), Format::kObj);
    ASSERT_TRUE(file) << file.error().message;
    const PolygonSoup& soup = file.value().soup;
    const std::size_t memory =
        4 * (soup.positions.capacity() + soup.sizes.capacity() + soup.corners.capacity());
    EXPECT_LE(memory, 7 * text.size());
  }
}

// With a quadratic reader, this would be the slowest test by far.
TEST(Hostile, ReadsOddLayoutsOfManyLines) {
  const std::size_t n = 100000;
  survive("OFF\n" + std::to_string(n) + " 0\n" + repeated("0\n0\n0\n", n));
  survive("OFF\n" + std::to_string(n) + " 0\n" + repeated("0 0 0 ", n));
  survive("OFF\n1 1\n0 0 0\n" + std::to_string(n) + repeated("\n0", n));
  survive("v 0 0 0\nf 1" + repeated(" \\\n1", n));
  survive(repeated("\\\n", n) + "v 0 0 0");
  survive(repeated("x\n", n));
  survive("v 0 0 0\n" + repeated("f 1 1 1\n", n) + "f 2 2 2\n");
}

}  // namespace
}  // namespace halfedge
