#include <gtest/gtest.h>
#include <halfedge/io/parse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/text_file.h"

namespace halfedge {
namespace {

using namespace std::string_literals;
using test::bytes_of;
using test::Parsed;

using Triangle = std::array<float, 9>;

Parsed parse_stl(const std::string& text) { return test::flatten(read_stl(bytes_of(text))); }
std::string stl_error(const std::string& text) { return parse_stl(text).error; }

template <class T>
std::string raw(const T& value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

std::string binary(const std::vector<Triangle>& triangles, std::string header = "",
                   std::uint32_t more = 0) {
  header.resize(80, ' ');
  header += raw(static_cast<std::uint32_t>(triangles.size()) + more);
  for (const Triangle& triangle : triangles) {
    header += std::string(12, '\x11');
    header += raw(triangle);
    header += "ab";
  }
  return header;
}

constexpr Triangle kFirst = {0, 0, 0, 1, 0, 0, 1, 1, 0};
constexpr Triangle kSecond = {0, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<std::vector<Index>> kFaces = {{0, 1, 2}, {0, 2, 3}};

const std::string kText =
    "solid a # name \\\n"
    " facet normal 0 0 1\n  outer loop\n"
    "   vertex 0 0 0\n   vertex 1 0 0\n   vertex 1 1 0\n"
    "  endloop\n endfacet\n"
    " facet normal nan nan nan\n  outer loop\n"
    "   vertex 0 0 0\n   vertex 1 1 0\n   vertex 0 1 0\n"
    "  endloop\n endfacet\n"
    "endsolid a\n";

TEST(Stl, WeldsTheTrianglesOfBothForms) {
  for (const std::string& text : {kText, binary({kFirst, kSecond})}) {
    const Parsed file = parse_stl(text);
    EXPECT_EQ(file.error, "");
    EXPECT_EQ(file.positions, kSquare);
    EXPECT_EQ(file.faces, kFaces);
    EXPECT_EQ(file.notes.size(), text == kText ? 1U : 0U);  // of its name
  }
}

TEST(Stl, KeepsVerticesApartIfAsked) {
  for (const std::string& text : {kText, binary({kFirst, kSecond})}) {
    const Parsed file = test::flatten(read_stl(bytes_of(text), {.weld = false}));
    EXPECT_EQ(file.error, "");
    std::vector<float> positions(kFirst.begin(), kFirst.end());
    positions.insert(positions.end(), kSecond.begin(), kSecond.end());
    EXPECT_EQ(file.positions, positions);
    EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}, {3, 4, 5}}));
  }
}

TEST(Stl, TellsTheFormsApartByTheContent) {
  for (const std::string& header : {"solid cube"s, "facet normal"s, "ply\nformat"s, "OFF 1 2 3\n"s,
                                    "\0v\0 \0001"s, "\xFF\xFE"s, "v 0 0 0\n"s}) {
    const auto file = parse(bytes_of(binary({kFirst, kSecond}, header)));
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file.value().format, Format::kStl);
    EXPECT_TRUE(file.value().binary);
  }
  const auto text = parse(bytes_of(kText));
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_EQ(text.value().format, Format::kStl);
  EXPECT_FALSE(text.value().binary);
}

TEST(Stl, WeldsZerosOfEitherSignAndNothingElse) {
  const float tiny = std::numeric_limits<float>::denorm_min();
  const float next = std::nextafter(1.0F, 2.0F);
  const Parsed file = parse_stl(binary({{-0.0F, 0, 0, 1, 0, 0, 0, 1, -0.0F},
                                        {0, -0.0F, 0, 0, 1, 0, tiny, 0, 0},
                                        {0, 0, -0.0F, next, 0, 0, -tiny, 0, 0}}));
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}, {0, 2, 3}, {0, 4, 5}}));
  EXPECT_TRUE(std::signbit(file.positions[0])) << "the first one's bits are kept";
}

// A table of the wrong size or with a wrong look-up would lose or double some.
TEST(Stl, WeldsManyPositions) {
  std::mt19937 random(3);
  std::vector<Triangle> triangles(20000);
  std::vector<std::vector<Index>> expected;
  std::vector<Index> index_of(8000, kNone);
  Index count = 0;
  for (Triangle& triangle : triangles) {
    expected.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto p = static_cast<std::size_t>(random() % index_of.size());
      triangle[3 * i] = static_cast<float>(p % 20);
      triangle[3 * i + 1] = static_cast<float>(p / 20 % 20);
      triangle[3 * i + 2] = static_cast<float>(p / 400);
      if (index_of[p] == kNone) index_of[p] = count++;
      expected.back().push_back(index_of[p]);
    }
  }
  EXPECT_EQ(parse_stl(binary(triangles)).faces, expected);
  EXPECT_EQ(parse_stl(binary(triangles)).positions.size(), 3 * std::size_t{count});
}

TEST(Stl, TakesTextInAnyCaseAndSeveralSolids) {
  std::string loud = kText;
  for (char& c : loud) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  EXPECT_EQ(parse_stl(loud).faces, kFaces);
  const Parsed twice = parse_stl(kText + kText);
  EXPECT_EQ(twice.faces.size(), 4U);
  EXPECT_EQ(twice.positions, kSquare);
  EXPECT_EQ(parse_stl("solid\nendsolid\n").error, "");
}

TEST(Stl, NotesAnOddEnd) {
  const std::string part = kText.substr(0, kText.find("endsolid"));
  EXPECT_EQ(parse_stl(part).faces, kFaces);
  EXPECT_EQ(parse_stl(part).notes,
            (std::vector<std::string>{"the file ends without endsolid: it may be a part only",
                                      "ignored the name of a solid"}));
  const std::string longer = binary({kFirst}, "\0"s) + "xyz";
  EXPECT_EQ(parse_stl(longer).faces.size(), 1U);
  EXPECT_EQ(parse_stl(longer).notes,
            std::vector<std::string>{"ignored the 3 bytes behind the 1 triangle that "
                                     "the header promises"});
}

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

TEST(Stl, TakesTextOnAnyLines) {
  std::string part = kText;
  part.replace(0, part.find('\n'), "solid my facet normal part");  // no number follows: a name
  for (const std::string& text : {on_one_line(part), on_one_line(part + part)}) {
    const Parsed file = parse_stl(text);
    EXPECT_EQ(file.error, "");
    EXPECT_EQ(file.faces.size(), text.size() > part.size() ? 4U : 2U);
    EXPECT_EQ(file.positions, kSquare);
  }
  const std::string facet = "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 ";
  EXPECT_EQ(parse_stl("solid\n" + facet + "endloop endfacet\nendsolid\n").faces.size(), 1U);
  // Two spellings of no number.
  for (const char* normal : {"1.#IND 1.#IND 1.#IND", "1.#QNAN0 -1.#INF 0"}) {
    std::string broken = facet;
    broken.replace(broken.find("0 0 1"), 5, normal);
    EXPECT_EQ(parse_stl("solid\n" + broken + "endloop endfacet\nendsolid\n").faces.size(), 1U);
  }
  const std::string comment = "facet normal 0 0 1 # from the outer loop\nouter loop vertex 0 0 0 ";
  const std::string corners = facet.substr(facet.find("vertex 1 0 0"));
  EXPECT_EQ(parse_stl("solid\n" + comment + corners + "endloop endfacet\n").faces.size(), 1U);
}

TEST(Stl, TakesSolidsWithoutAnEnd) {
  const std::string part = kText.substr(0, kText.find("endsolid"));
  const Parsed file = parse_stl(part + part + kText);
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces.size(), 6U);
  EXPECT_EQ(file.notes,
            (std::vector<std::string>{"2 solids end without endsolid before the last one",
                                      "ignored the names of 3 solids"}));
}

TEST(Stl, PassesOverWhatFillsUpATextBehindItsEnd) {
  const std::string small = kText.substr(0, kText.find(" facet normal nan")) + "endsolid\n";
  for (const std::string& text : {kText, small}) {
    for (const std::string& padding : {"\0"s, std::string(600, '\0'), "\x1A"s, "\x1A\0\0"s}) {
      const auto file = parse(bytes_of(text + padding));
      ASSERT_TRUE(file) << file.error().message;
      EXPECT_FALSE(file.value().binary);
      EXPECT_EQ(file.value().soup.view().face_count(), text == kText ? 2U : 1U);
      EXPECT_EQ(file.value().notes.size(), 1U);
    }
  }
  EXPECT_EQ(stl_error("solid"s + std::string(30, '\0')).substr(0, 10), "truncated:");

  const auto empty = parse(bytes_of("solid a\nendsolid a\n" + std::string(600, '\0')));
  ASSERT_TRUE(empty) << empty.error().message;
  EXPECT_FALSE(empty.value().binary);
}

TEST(Stl, ReadsATextWhoseNameHasNuls) {
  std::string text = kText;
  text.insert(text.find('\n'), 3, '\0');
  const auto file = parse(bytes_of(text));
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_FALSE(file.value().binary);
  EXPECT_EQ(file.value().soup.view().face_count(), 2U);
}

// Programs that write as they go begin with such a count, and some never come back to it.
TEST(Stl, CountsTheTrianglesWhereTheHeaderHasAPlaceholder) {
  for (const std::string header : {"made by us", "solid"}) {
    for (const std::uint32_t count : {0U, UINT32_MAX}) {
      std::string bytes = binary({kFirst, kSecond}, header);
      bytes.replace(80, 4, raw(count));
      for (std::size_t at : {84U, 134U}) bytes.replace(at, 12, std::string(12, '\0'));
      const auto file = parse(bytes_of(bytes));
      ASSERT_TRUE(file) << file.error().message;
      EXPECT_EQ(file.value().soup.view().face_count(), 2U);
      EXPECT_EQ(file.value().notes,
                std::vector<std::string>{"the header promises " + std::to_string(count) +
                                         " triangles, but the file has 2, which were read"});
    }
  }
  // What follows no triangle is none.
  const auto none = parse(bytes_of(binary({}, "solid") + std::string(100, '\0')));
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_EQ(none.value().soup.view().face_count(), 0U);
}

TEST(Stl, NotesTheNamesOfSolids) {
  EXPECT_EQ(parse_stl("solid \nendsolid\n").notes, std::vector<std::string>());
  EXPECT_EQ(parse_stl("solid a b\nendsolid a b\nsolid\nendsolid\n").notes,
            std::vector<std::string>{"ignored the name of a solid"});
  EXPECT_EQ(parse_stl("solid a\nendsolid a\nsolid b\nendsolid b\n").notes,
            std::vector<std::string>{"ignored the names of 2 solids"});
}

TEST(Stl, NotesAColourInTheHeader) {
  EXPECT_EQ(parse_stl(binary({kFirst}, "made by us COLOR=\x1F\x2F\x3F\xFF")).notes,
            std::vector<std::string>{"ignored the colour in the header"});
  EXPECT_EQ(parse_stl(binary({kFirst}, "COLOR")).notes, std::vector<std::string>());
}

TEST(Stl, ExplainsWrongText) {
  const std::string start = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  const std::pair<std::string, std::string> errors[] = {
      {"solid\nfacets\n", "parse-error: line 2: expected facet or endsolid, found \"facets\""},
      {"solid\nfacet\nvertex\n",
       "parse-error: line 3: expected outer of triangle 0, found \"vertex\""},
      {start + "vertex 1 0\n",
       "parse-error: line 5: expected a number for z of vertex 1 of triangle 0, found the end of "
       "the line"},
      {start + "vertex 1 0 0\nendloop\n",
       "parse-error: line 6: expected vertex of triangle 0, found \"endloop\""},
      {start + "vertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n",
       "parse-error: line 7: expected endloop of triangle 0, found \"vertex\""},
      {start + "vertex 1 0",
       "truncated: line 5: expected a number for z of vertex 1 of triangle "
       "0, found the end of the file"},
      {start + "vertex 1 inf 0\nvertex 1 1 0\nendloop\nendfacet\n",
       "non-finite-position: line 5: y of vertex 1 of triangle 0 is inf, expected a finite number"},
      {start + "vertex 1 0 0\nvertex 1 1\\\n1.#INF\nendloop\nendfacet\n",
       "non-finite-position: line 7: z of vertex 2 of triangle 0 is inf, expected a finite number"},
      {"hello world", "parse-error: line 1: expected solid or facet, found \"hello\""}};
  for (const auto& [text, error] : errors) EXPECT_EQ(stl_error(text), error);
}

TEST(Stl, ExplainsWrongBytes) {
  EXPECT_EQ(stl_error(std::string(80, '\0')),
            "truncated: the file has 80 bytes, expected at least the 84 bytes that start a binary "
            "STL file");
  EXPECT_EQ(stl_error(binary({kFirst}, "solid", 4)),
            "truncated: byte 134: the bytes of this binary STL file of 5 triangles end after 1 of "
            "them");
  Triangle bad = kSecond;
  bad[8] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(stl_error(binary({kFirst, bad})),
            "non-finite-position: byte 134: z of vertex 2 of triangle 1 is nan, expected a finite "
            "number");
  bad[0] = -std::numeric_limits<float>::infinity();
  const auto file = read_stl(bytes_of(binary({kFirst, bad})));
  EXPECT_EQ(file.error().message,
            "byte 134: x of vertex 0 of triangle 1 is -inf, expected a finite number");
  EXPECT_EQ(file.error().witness.faces, std::vector<Index>{1});
}

TEST(Stl, TellsABinaryFileOfTheWrongSize) {
  const auto error_of = [](const std::string& bytes) {
    const Result<ParsedFile> file = parse(bytes_of(bytes));
    return file ? "none" : std::string(file.error().code) + ": " + file.error().message;
  };
  const std::string whole = binary({kFirst, kSecond}, "made by\0us"s);
  EXPECT_EQ(error_of(whole), "none");
  EXPECT_EQ(error_of(whole.substr(0, whole.size() - 7)),
            "truncated: byte 177: the bytes of this binary STL file of 2 triangles end after 1 of "
            "them and 43 bytes of the next one (read as STL)");
  const Result<ParsedFile> longer = parse(bytes_of(whole + "\0end"s));
  ASSERT_TRUE(longer) << longer.error().message;
  EXPECT_EQ(longer.value().soup.view().face_count(), 2U);
  EXPECT_EQ(longer.value().notes,
            (std::vector<std::string>{
                "ignored the 4 bytes behind the 2 triangles that the header promises"}));
  // Whose numbers are none of triangles, or too few to tell.
  EXPECT_EQ(error_of(std::string(80, ' ') + raw(std::uint32_t{1}) + std::string(90, '\1') + "\0"s)
                .substr(0, 15),
            "not-text: byte ");
  EXPECT_EQ(error_of(whole.substr(0, 130)).substr(0, 15), "not-text: byte ");
  std::string other = whole.substr(0, whole.size() - 7);
  other[84 + 2] = 'x';  // a normal of another length
  other[84 + 3] = 'y';
  EXPECT_EQ(error_of(other).substr(0, 15), "not-text: byte ");
}

TEST(Stl, FindsTheLinesOfTrianglesInTextOnly) {
  const std::vector<Index> faces = {1, 0, 2};
  EXPECT_EQ(lines_of_faces(bytes_of(kText), Format::kStl, faces),
            (std::vector<std::size_t>{9, 2, 0}));
  EXPECT_EQ(lines_of_faces(bytes_of(binary({kFirst, kSecond})), Format::kStl, faces),
            (std::vector<std::size_t>{0, 0, 0}));
}

TEST(Stl, TellsAtWhichBytesTrianglesStart) {
  const std::string text = binary(std::vector<Triangle>(600, kFirst));
  std::vector<Error> problems = {{"a", "Faces.", {.faces = {599, 0, 255, 256, 255}}},
                                 {"b", "Vertices.", {.vertices = {2}}}};
  add_places(problems, bytes_of(text), Format::kStl);
  EXPECT_EQ(problems[0].message, "Faces. (Bytes 30034, 84, 12834, 12884, 12834)");
  EXPECT_EQ(problems[1].message, "Vertices.");  // which are welded
}

}  // namespace
}  // namespace halfedge
