#include <gtest/gtest.h>
#include <halfedge/io/parse.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "support/text_file.h"

namespace halfedge {
namespace {

using namespace std::string_literals;
using test::off_error;
using test::parse_off;
using test::Parsed;
using Faces = std::vector<std::vector<Index>>;
using Floats = std::vector<float>;

constexpr const char* kVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const Floats kSquare = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

/// A square and a triangle behind the given head.
std::string after(const std::string& head) {
  return head + "\n" + kVertices + "4 0 1 2 3\n3 0 1 2\n";
}

void expect_square_and_triangle(const std::string& text, const std::string& note = "") {
  SCOPED_TRACE(text);
  const Parsed file = parse_off(text);
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, kSquare);
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(file.notes, note.empty() ? std::vector<std::string>() : std::vector{note});
}

TEST(Off, ReadsEveryFormOfTheHead) {
  for (const char* head :
       {"OFF\n4 2 5", "OFF\n4 2", "OFF 4 2 5", "OFF 4 2", "OFF4 2 5", "4 2 5", "4 2", "off\n4 2 5",
        "  \t OFF4 2 5 # or nah", "# a\n\n# b\nOFF # c\n# d\n 4 2 5 # e\n\n#f", "OFF\n4\n2\n5",
        "OFF\n4 2\n5", "OFF\n\n4\n2 5", "OFF\r\n4 2 5\r", "\xEF\xBB\xBFOFF\n4 2 5", "OFF#c\n4 2 -1",
        "nOFF\n3\n4 2 5", "nOFF 3 4 2 5"}) {
    expect_square_and_triangle(after(head));
  }
}

TEST(Off, ReadsCarriageReturnsAlone) {
  std::string text = after("OFF\n4 2 5");
  for (char& c : text) c = c == '\n' ? '\r' : c;
  expect_square_and_triangle(text);
}

TEST(Off, SkipsWhatAVertexHasBesidesItsPosition) {
  const std::pair<const char*, const char*> forms[] = {
      {"COFF", " 255 0 0 255"},
      {"COFF", " 0.5 0 0"},
      {"NOFF", " 0 0 1"},
      {"CNOFF", " 0 0 1 1 0 0 1"},
      {"NCOFF", " 0 0 1 1 0 0 1"},
      {"STOFF", " 0.5 0.5"},
      {"STCNOFF", " 0 0 1 1 0 0 1 0 0"},
      {"OFF", " 0.1 0.2 0.3 # colours without a C"},
      {"OFF", " 1 2 3 4 5 6"}};
  const std::string note = "of 4 vertices: ignored what is more than the header word promises";
  for (const auto& [word, extra] : forms) {
    std::string text = std::string(word) + "\n4 2 5\n";
    for (const char* vertex : {"0 0 0", "1 0 0", "1 1 0", "0 1 0"}) {
      text += std::string(vertex) + extra + "\n";
    }
    expect_square_and_triangle(text + "4 0 1 2 3\n3 0 1 2\n",
                               std::string(word) == "OFF" ? note : "");
  }
}

TEST(Off, DividesTheCoordinatesOf4OffByTheFourth) {
  const Parsed file = parse_off("4OFF\n3 1 3\n2 4 6 2\n1 0 0 1\n0 1 0 0.5\n3 0 1 2\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, (Floats{1, 2, 3, 1, 0, 0, 0, 2, 0}));
  EXPECT_EQ(parse_off("4nOFF 3\n1 0 0\n2 4 6 2 9 9\n").positions, (Floats{1, 2, 3}));
}

TEST(Off, SkipsTheColoursOfFaces) {
  expect_square_and_triangle(std::string("OFF\n4 2 5\n") + kVertices +
                             "4  0 1 2 3  1.000 0.000 0.000 0.75\n3 0 1 2 255 0 0\n");
  expect_square_and_triangle(
      std::string("OFF\n4 2 5\n") + kVertices + "4 0 1 2 3 7\n3 0 1 2 # a comment\n",
      "of 1 face: ignored a colour that is no red, green and blue");
}

TEST(Off, SkipsCommentsAnywhere) {
  expect_square_and_triangle(
      "OFF\n4 2 5\n#\n0 0 0# a\n1 0 0 # b\n\n1 1 0\n# 9 9 9\n0 1 0\n  #\n4 0 1 2 3\n\n3 0 1 2#");
}

TEST(Off, ReadsRecordsBrokenOverLines) {
  expect_square_and_triangle("OFF\n4 2 5\n0 0\n0\n1\n0 0\n1 1 0\n0 1 0\n4\n0 1\n2 3\n3 0 1 2\n");
}

// What isn't read goes as far as what is: else attributes would decide what is a vertex.
TEST(Off, JoinsLinesOfWhatItPassesOver) {
  const std::string text =
      "COFF\n3 1 0\n0 0 0 1 1 1\\\n1\n1 0 0 1 1 \\\r\n1 1\n0 1 0 1 1 1 1\n3 0 1 2 1 0 \\\n0\n";
  for (const bool attributes : {true, false}) {
    const Parsed file = test::flatten(read_off(test::bytes_of(text), {.attributes = attributes}));
    EXPECT_EQ(file.error, "");
    EXPECT_EQ(file.positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}}));
    EXPECT_TRUE(file.notes.empty());
  }
}

TEST(Off, ReadsSeveralVerticesOnALine) {
  expect_square_and_triangle("OFF\n4 2 5\n0 0 0 1 0 0\n1 1 0 0 1 0\n4 0 1 2 3\n3 0 1 2\n");
  expect_square_and_triangle("OFF\n4 2 5\n0 0 0 1 0 0 1 1 0 0 1 0\n4 0 1 2 3\n3 0 1 2\n");
  expect_square_and_triangle(
      "NOFF\n4 2 5\n0 0 0 0 0 1 1 0 0 0 0 1\n1 1 0 0 0 1 0 1 0 0 0 1\n4 0 1 2 3\n3 0 1 2\n");
}

TEST(Off, ReadsRecordsThatStartAndEndAnywhere) {
  expect_square_and_triangle("OFF\n4 2 5\n0 0 0 1\n0 0 1 1\n0\n0 1 0 4\n0\n1\n2 3 3 0\n1\n2\n");
  expect_square_and_triangle(
      "OFF\n4 2 5\n0 0 0 1 \n0 0 \n1 1\n0 0 1\n0 # b\n4 0\n1 2 3\n3 0 1\n2\n");
  expect_square_and_triangle(
      "4OFF\n4 2 5\n0 0 0\n1 1 0 0\n1 1 1 0\n1 0 1 0 1\n4 0 1\n2\n3\n3 0 1 2\n");
  // More lines than records for another reason.
  const Parsed file = parse_off("OFF\n3 1 0\n0 0 0 9 9\n1 0 0 9\n0 1 0\n3 0 1 2\nmore\n");
  EXPECT_EQ(file.positions, (Floats{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(file.notes.size(), 2U);
}

TEST(Off, ReadsSeveralFacesOnALine) {
  const std::string head = std::string("OFF\n4 4\n") + kVertices;
  const Faces faces = {{0, 1, 2}, {0, 1, 2, 3}, {2, 1, 0}, {3, 2, 1}};
  for (const char* rows :
       {"3 0 1 2 4 0 1 2 3 3 2 1 0 3 3 2 1\n", "3 0 1 2 4 0 1 2 3 3 2 1 0\n# b\n3 3 2 1 # c\n\n",
        "3 0 1 2\n4 0 1 2 3 3 2 1 0 3 3\n2 1", "3 0 1 2 4 0\n1 2 3 3 2 1 0 3 3 2 1\n"}) {
    const Parsed file = parse_off(head + rows);
    EXPECT_EQ(file.error, "") << rows;
    EXPECT_EQ(file.faces, faces) << rows;
    EXPECT_TRUE(file.notes.empty());
  }
}

// A file that was cut has fewer lines than faces, too.
TEST(Off, DoesNotTakeColoursForFaces) {
  const auto cut = [](const std::string& faces, const std::string& rows) {
    return off_error("OFF\n3 " + faces + " 0\n0 0 0\n1 0 0\n0 1 0\n" + rows);
  };
  const auto error = [](const char* line, const char* face) {
    return std::string("truncated: line ") + line + ": expected the number of vertices of face " +
           face + ", found the end of the file";
  };
  EXPECT_EQ(cut("4", "3 0 1 2 3 0 1 2\n3 0 2 1 3 0 1 2\n"), error("8", "2 of 4"));
  EXPECT_EQ(cut("3", "3 0 1 2 1 0 0\n"), error("7", "1 of 3"));
  EXPECT_EQ(cut("3", "3 0 1 2 255 0 0\n3 0 2 1 255 0 0\n"), error("8", "2 of 3"));
  EXPECT_EQ(cut("3", "3 0 1 2 1 0 1 2\n"), error("7", "1 of 3"));
  EXPECT_EQ(cut("3", "3 0 1 2 0.5 0 0 1\n3 0 2"),
            "truncated: line 7: expected vertex 3 of the 3 of face 1, found the end of the file");
}

TEST(Off, LeavesSmallAndRepeatedFacesToTheBuilder) {
  const Parsed file = parse_off(std::string("OFF\n4 4\n") + kVertices + "0\n1 2\n2 1 3\n3 1 1 2\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces, (Faces{{}, {2}, {1, 3}, {1, 1, 2}}));
}

TEST(Off, ReadsAnEmptyMesh) {
  for (const char* text : {"OFF\n0 0 0\n", "OFF 0 0", "0 0 0"}) {
    EXPECT_EQ(off_error(text), "") << text;
    EXPECT_TRUE(parse_off(text).positions.empty());
    EXPECT_TRUE(parse_off(text).faces.empty());
  }
}

TEST(Off, PassesOverWhatFillsUpATextBehindItsEnd) {
  for (const std::string& padding : {"\0"s, "\n\0\0"s, "\x1A\0"s}) {
    const Parsed file = parse_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2" + padding);
    EXPECT_EQ(file.error, "");
    EXPECT_EQ(file.notes, std::vector<std::string>());
    EXPECT_EQ(file.faces.size(), 1U);
    EXPECT_EQ(parse_off("OFF\n0 0 0" + padding).error, "");
  }
}

TEST(Off, NotesWhatFollowsTheLastFace) {
  const Parsed file = parse_off(after("OFF\n4 1 5"));
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2, 3}}));
  EXPECT_EQ(
      file.notes,
      (std::vector<std::string>{"ignored what follows the last face, from line 8 on: \"3\""}));
}

TEST(Off, NotesWordsThatItPassesOver) {
  const Parsed vertices = parse_off("OFF\n3 1 3\n0 0 0 abc\n1 0 0 foo\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(vertices.notes,
            (std::vector<std::string>{
                "Of 2 vertices: ignored words behind the position, expected numbers"}));
  const std::vector<std::string> note = {
      "Of 1 face: ignored what follows the vertices and is no colour of 3 or 4 numbers"};
  EXPECT_EQ(parse_off("OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 baz\n").notes, note);
  EXPECT_EQ(parse_off("OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 9 0 0 1 foo\n").notes, note);
  EXPECT_TRUE(parse_off("OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 9 0 0 1 # foo\n").notes.empty());
}

TEST(Off, RefusesANumberTooManyBehindTheCounts) {
  for (const std::string more : {"7", "7 8"}) {
    EXPECT_EQ(off_error("OFF\n3 1 3 " + more + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
              "parse-error: line 2: expected the end of the line behind the counts, found \"7\"");
  }
  EXPECT_EQ(parse_off("OFF 3 1 3 0 0 0 1 0 0 0 1 0 3 0 1 2").faces, (Faces{{0, 1, 2}}));
}

TEST(Off, RefusesAMalformedHead) {
  EXPECT_EQ(off_error(""),
            "truncated: line 1: expected the number of vertices (after the header word OFF, if "
            "any), found the end of the file");
  EXPECT_EQ(off_error("PFF\n1 0 0\n"),
            "parse-error: line 1: expected the number of vertices (after the header word OFF, if "
            "any), found \"PFF\"");
  EXPECT_EQ(off_error("OFFSET\n1 0 0\n"),
            "parse-error: line 1: expected the number of vertices (after the header word OFF, if "
            "any), found \"OFFSET\"");
  EXPECT_EQ(off_error("OFF\n-4 2 5\n"),
            "parse-error: line 2: expected the number of vertices (after the header word OFF, if "
            "any), found \"-4\"");
  EXPECT_EQ(off_error("OFF\n4 two 5\n"),
            "parse-error: line 2: expected the number of faces, found \"two\"");
  EXPECT_EQ(off_error("OFF\n4\n"),
            "truncated: line 3: expected the number of faces, found the end of the file");
  EXPECT_EQ(off_error("OFF\n4 2 many\n"),
            "parse-error: line 2: expected the number of edges or the end of the line, found "
            "\"many\"");
}

TEST(Off, RefusesAnotherDimension) {
  EXPECT_EQ(off_error("nOFF 4\n1 0 0\n1 2 3 4\n"),
            "unsupported-format: line 1: the vertices of this nOFF file have dimension \"4\", "
            "expected dimension 3");
}

TEST(Off, RefusesCountsThatTheFileIsTooShortFor) {
  EXPECT_EQ(
      off_error("OFF\n4000000000 2 0\n0 0 0\n"),
      "truncated: line 2: the header promises 4000000000 vertices and 2 faces, but is followed "
      "by only 7 bytes");
  EXPECT_EQ(off_error("OFF\n1 4000000000 0\n0 0 0\n"),
            "truncated: line 2: the header promises 1 vertex and 4000000000 faces, but is followed "
            "by only 7 bytes");
  EXPECT_EQ(off_error("OFF\n99999999999999999999 9223372036854775807 0\n"),
            "truncated: line 2: the number of vertices (after the header word OFF, if any) is "
            "99999999999999999999, more than a file can hold");
  EXPECT_EQ(off_error("OFF\n1 2\n0 0 0\n0\n0"), "");  // as short as it gets
}

TEST(Off, TellsWhereTheFileEnds) {
  const std::string long_enough = "                              # so long\n";
  EXPECT_EQ(off_error("OFF\n4 2 5\n0 0 0\n1 0" + long_enough),
            "parse-error: line 4: expected a number for z of vertex 1 of 4, found the end of the "
            "line");
  EXPECT_EQ(off_error("OFF\n4 2 5\n0 0 0\n1 0 0" + long_enough),
            "truncated: line 5: expected a number for x of vertex 2 of 4, found the end of the "
            "file");
  EXPECT_EQ(off_error(std::string("OFF\n4 2 5\n") + kVertices + "3 0 1 2 # a long comment"),
            "truncated: line 7: expected the number of vertices of face 1 of 2, found the end of "
            "the file");
}

TEST(Off, TellsWhichNumberIsNone) {
  EXPECT_EQ(off_error(after("OFF\n4 2 5\n0 x 0")),
            "parse-error: line 3: expected a number for y of vertex 0 of 4, found \"x\"");
  EXPECT_EQ(off_error(std::string("OFF\n4 2 5\n0 0 0\n1 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n")),
            "parse-error: line 4: expected a number for z of vertex 1 of 4, found the end of the "
            "line");
  EXPECT_EQ(off_error("4OFF\n1 0\n1 2 3 #####\n"),
            "parse-error: line 3: expected a number for w of vertex 0 of 1, found the end of the "
            "line");
  const std::string vertices = std::string("OFF\n4 2 5\n") + kVertices;
  EXPECT_EQ(off_error(vertices + "four 0 1 2 3\n3 0 1 2\n"),
            "parse-error: line 7: expected the number of vertices of face 0 of 2, found \"four\"");
  EXPECT_EQ(off_error(vertices + "-3 0 1 2 3\n3 0 1 2\n"),
            "parse-error: line 7: expected the number of vertices of face 0 of 2, found \"-3\"");
  EXPECT_EQ(off_error(vertices + "4 0 1 2.0 3\n3 0 1 2\n"),
            "parse-error: line 7: expected vertex 3 of the 4 of face 0, found \"2.0\"");
  EXPECT_EQ(off_error(vertices + "4 0 1 2\n3 0 1 2\n"),
            "parse-error: line 7: expected vertex 4 of the 4 of face 0, found the end of the line");
  EXPECT_EQ(off_error(vertices + "4000000000 0 1 2\n3 0 1 2\n"),
            "parse-error: line 7: expected vertex 4 of the 4000000000 of face 0, found the end of "
            "the line");
}

TEST(Off, TellsWhichVertexIsOutOfRange) {
  const std::string vertices = std::string("OFF\n4 2 5\n") + kVertices;
  for (const char* index : {"4", "-1", "4294967296", "4294967303", "2147483648",
                            "18446744073709551616", "99999999999999999999999"}) {
    EXPECT_EQ(off_error(vertices + "4 0 1 2 3\n3 0 " + index + " 2\n"),
              std::string("index-out-of-range: line 8: corner 1 of face 1 is \"") + index +
                  "\", expected a vertex from 0 to 3");
  }
  EXPECT_EQ(
      off_error("OFF\n0 1 0\n3 0 1 2\n"),
      "index-out-of-range: line 3: corner 0 of face 0 is \"0\", but the file has no vertices");
  const auto file = read_off(test::bytes_of(vertices + "4 0 1 2 3\n3 0 4 2\n"));
  EXPECT_EQ(file.error().witness.faces, std::vector<Index>{1});
}

TEST(Off, FindsTheLinesOfFaces) {
  const std::string text =
      std::string("OFF\n4 3 5\n") + kVertices + "\n4 0 1 2 3\r\n#\r3 0 1 2\n2 0 1";
  EXPECT_EQ(lines_of_faces(test::bytes_of(text), Format::kOff, std::vector<Index>{2, 0, 1, 3}),
            (std::vector<std::size_t>{11, 8, 10, 0}));
}

/// Words of a binary file: integers, or floats.
class Words {
 public:
  explicit Words(bool big) : big_(big) {}
  Words& ints(std::initializer_list<std::int32_t> values) {
    for (const std::int32_t value : values) add(value);
    return *this;
  }
  Words& floats(std::initializer_list<float> values) {
    for (const float value : values) add(value);
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  void add(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big_) std::reverse(raw, raw + sizeof(T));
    bytes_.append(raw, sizeof(T));
  }

  bool big_;
  std::string bytes_;
};

TEST(OffBinary, ReadsBothByteOrdersWithColoursAndWithout) {
  for (const bool big : {true, false}) {
    for (const bool colours : {true, false}) {
      Words words(big);
      words.ints({4, 2, 0}).floats({0, 0, 0, 1, 0, 0, 1, 1, -0.0F, 0, 0.1F, 0});
      words.ints({3, 0, 1, 2});
      if (colours) words.ints({4}).floats({1, 0, 0, 1});
      words.ints({4, 3, 2, 1, 0});
      if (colours) words.ints({0});
      const Parsed file = parse_off("OFF BINARY\n" + words.bytes());
      EXPECT_EQ(file.error, "");
      EXPECT_EQ(file.positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0.1F, 0}));
      EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}, {3, 2, 1, 0}}));
      EXPECT_TRUE(file.notes.empty());
    }
  }
}

// Found by cutting a file at each byte: cut in the right place, the numbers of colour components,
// all of them 0, passed for faces, and there were as many as promised.
TEST(OffBinary, DoesNotTakeColoursForFaces) {
  for (const bool big : {true, false}) {
    Words words(big);
    words.ints({3, 4, 0}).floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    for (int face = 0; face < 4; ++face) words.ints({3, 0, 1, 2, 0});
    const std::string whole = "OFF BINARY\n" + words.bytes();
    EXPECT_EQ(parse_off(whole).faces.size(), 4U);
    for (std::size_t size = 15; size < whole.size(); ++size) {
      EXPECT_TRUE(off_error(whole.substr(0, size)).starts_with("truncated: ")) << size;
    }
  }
}

TEST(OffBinary, ReadsFacesOfFewerCornersThanThree) {
  for (const bool colours : {true, false}) {
    Words words(true);
    words.ints({3, 4, 0}).floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    for (int face = 0; face < 4; ++face) {
      words.ints({2, face % 2, 2});
      if (colours) words.ints({1, 7});
    }
    const Parsed file = parse_off("OFF BINARY\n" + words.bytes());
    EXPECT_EQ(file.error, "");
    EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 2}, {1, 2}, {0, 2}, {1, 2}}));
    EXPECT_EQ(file.notes.size(), colours ? 1U : 0U);
  }
}

TEST(OffBinary, ReadsThePrefixes) {
  Words words(true);
  words.ints({1, 1, 0}).floats({2, 4, 6, 2, /* normal */ 0, 0, 1, /* colour */ 1, 1, 1, 1});
  words.floats({/* texture */ .5F, .5F}).ints({1, 0, 0});
  const Parsed file = parse_off("STCN4OFF BINARY\r\n" + words.bytes() + "xy");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, (std::vector<float>{1, 2, 3}));
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0}}));
  EXPECT_EQ(file.notes, std::vector<std::string>{"ignored the 2 bytes behind the last face"});
}

TEST(OffBinary, ExplainsWrongBytes) {
  const std::string header = "OFF BINARY\n";
  EXPECT_EQ(off_error(header + "1234"),
            "truncated: byte 11: expected the numbers of vertices, faces and edges, found the end "
            "of the file in 4 bytes");
  EXPECT_EQ(
      off_error(header + Words(true).ints({2000000000, 5, 0}).bytes()),
      "truncated: byte 11: the header promises 2000000000 vertices and 5 faces, but is followed "
      "by only 0 bytes");
  const std::string start = header + Words(true).ints({1, 1, 0}).floats({0, 0, 0}).bytes();
  EXPECT_EQ(off_error(start + Words(true).ints({1, 1, 0}).bytes()),
            "index-out-of-range: byte 39: corner 0 of face 0 is 1, expected a vertex from 0 to 0");
  EXPECT_EQ(off_error(start + Words(true).ints({1, -5, 0}).bytes()),
            "index-out-of-range: byte 39: corner 0 of face 0 is -5, expected a vertex from 0 to 0");
  const std::string missing = start + Words(true).ints({1, -5, 0}).bytes();
  const auto for_repair = read_off(test::bytes_of(missing), {.for_repair = true});
  ASSERT_TRUE(for_repair);
  ASSERT_EQ(for_repair.value().soup.missing.size(), 1U);
  EXPECT_EQ(for_repair.value().soup.missing[0].name, "-5");
  EXPECT_EQ(off_error(start + Words(true).ints({9, 0, 0}).bytes()),
            "truncated: byte 35: the number of vertices of face 0 of 1 is 9, more than the rest of "
            "the file can hold");
  EXPECT_EQ(off_error("nOFF BINARY\n"),
            "unsupported-format: line 1: this binary OFF file has vertices of any dimension "
            "(nOFF), expected 3");
  EXPECT_EQ(lines_of_faces(test::bytes_of(start), Format::kOff, std::vector<Index>{0}),
            std::vector<std::size_t>{0});
}

TEST(OffBinary, TellsAtWhichBytesItemsStart) {
  const std::string text = "OFF BINARY\n" + Words(true)
                                                .ints({3, 2, 0})
                                                .floats({0, 0, 0, 1, 0, 0, 0, 1, 0})
                                                .ints({3, 0, 1, 2, 0, 3, 0, 1, 1, 0})
                                                .bytes();
  std::vector<Error> problems = {{"a", "Faces.", {.faces = {1, 0}}},
                                 {"b", "Vertices.", {.vertices = {2}}}};
  add_places(problems, test::bytes_of(text), Format::kOff);
  EXPECT_EQ(problems[0].message, "Faces. (Bytes 79, 59)");
  EXPECT_EQ(problems[1].message, "Vertices. (Byte 47)");
}

TEST(Off, RefusesCountsThatNoFileHas) {
  EXPECT_EQ(off_error("OFF 3 99999999999999999999 0\n0 0 0\n"),
            "truncated: line 1: the number of faces is 99999999999999999999, more than a file can "
            "hold");
}

}  // namespace
}  // namespace halfedge
