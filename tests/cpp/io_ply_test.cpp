#include <gtest/gtest.h>
#include <halfedge/io/parse.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "support/text_file.h"

namespace halfedge {
namespace {

using namespace std::string_literals;
using test::bytes_of;
using test::Parsed;

Parsed parse_ply(const std::string& text) { return test::flatten(read_ply(bytes_of(text))); }
std::string ply_error(const std::string& text) { return parse_ply(text).error; }

const std::string kVertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";

std::string header(const std::string& format, const std::string& elements = kVertices + kFaces) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

const std::vector<float> kCorner = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::string kRows = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// The bytes of numbers, in either order.
class Bytes {
 public:
  explicit Bytes(bool big) : big_(big) {}
  template <class T>
  Bytes& add(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big_) std::reverse(raw, raw + sizeof(T));
    bytes_.append(raw, sizeof(T));
    return *this;
  }
  operator std::string() const { return bytes_; }

 private:
  bool big_;
  std::string bytes_;
};

TEST(Ply, ReadsText) {
  const Parsed file = parse_ply(header("ascii") + kRows);
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, kCorner);
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}}));
  EXPECT_TRUE(file.notes.empty());
}

TEST(Ply, ReadsBothByteOrdersAndEveryType) {
  for (const bool big : {false, true}) {
    const std::string text =
        header(big ? "binary_big_endian" : "binary_little_endian",
               "element odd 1\nproperty char a\nproperty uint b\nproperty float32 c\n"
               "element vertex 2\nproperty int16 x\nproperty ushort y\nproperty int z\n"
               "element face 1\nproperty list uint16 short vertex_index\nproperty uint8 d\n"
               "element more 1\nproperty list uint32 float64 list\n");
    Bytes data(big);
    data.add(std::int8_t{-1}).add(std::uint32_t{4000000000}).add(0.1F);
    data.add(std::int16_t{-300}).add(std::uint16_t{60000}).add(std::int32_t{-70000});
    data.add(std::int16_t{1}).add(std::uint16_t{2}).add(std::int32_t{3});
    data.add(std::uint16_t{4});
    for (const std::int16_t v : {std::int16_t{0}, std::int16_t{1}}) data.add(v).add(v);
    data.add(std::uint8_t{200}).add(std::uint32_t{2}).add(2.0).add(1.0);
    const Parsed file = parse_ply(text + std::string(data));
    EXPECT_EQ(file.error, "");
    EXPECT_EQ(file.positions, (std::vector<float>{-300, 60000, -70000, 1, 2, 3}));
    EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 0, 1, 1}}));
    EXPECT_EQ(file.notes, (std::vector<std::string>{"ignored the 1 element \"odd\"",
                                                    "ignored the 1 element \"more\""}));
  }
}

TEST(Ply, ReadsLengthsOfAByteUpTo255) {
  const std::string text =
      header("binary_little_endian",
             "element vertex 255\nproperty uint8 x\nproperty uint8 y\nproperty uint8 z\n"
             "element face 1\nproperty list uchar uchar vertex_indices\n");
  std::vector<Index> corners;
  Bytes data(false);
  for (int v = 0; v < 255; ++v) data.add(std::uint8_t(v)).add(std::uint8_t{0}).add(std::uint8_t{0});
  data.add(std::uint8_t{255});
  for (int v = 0; v < 255; ++v) {
    data.add(std::uint8_t(v));
    corners.push_back(Index(v));
  }
  const Parsed file = parse_ply(text + std::string(data));
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{corners}));
}

TEST(Ply, ReadsBinaryFloatsBitForBit) {
  const float odd[] = {-0.0F, 1e-42F, 3.4028235e38F};
  for (const bool big : {false, true}) {
    Bytes data(big);
    for (int i = 0; i < 3; ++i) {
      data.add(std::uint8_t{9}).add(odd[0]).add(odd[1]).add(1.5).add(odd[2]);
    }
    const std::string vertices =
        "element vertex 3\nproperty uchar red\nproperty float y\nproperty float z\n"
        "property double quality\nproperty float x\n";
    const Parsed file = parse_ply(
        header(big ? "binary_big_endian" : "binary_little_endian", vertices) + std::string(data));
    ASSERT_EQ(file.error, "");
    for (std::size_t v = 0; v < 3; ++v) {
      EXPECT_EQ(file.positions[3 * v], odd[2]);
      EXPECT_TRUE(std::signbit(file.positions[3 * v + 1]));
      EXPECT_EQ(file.positions[3 * v + 2], odd[1]);
    }
    EXPECT_TRUE(file.notes.empty());
  }
}

TEST(Ply, TakesElementsAndPropertiesInAnyOrder) {
  const Parsed file = parse_ply(
      header("ascii",
             "comment # odd \\\nobj_info 1\nCreated by somebody, source file: \nelement face "
             "2\nproperty uchar flag\n"
             "property list uchar int vertex_indices\nproperty list int float uv\n\n"
             "element nothing 5\nelement vertex 4\nproperty list uchar int n\nproperty double z\n"
             "property float y\nproperty float x\n") +
      "1 3 0 1 2 0\n0 4 0 1 2 3 2 .5 .5\n0 3 2 1\n1 7 6 5 4\n0 0 0 0\n0 0 0 0\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, (std::vector<float>{1, 2, 3, 4, 5, 6, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}, {0, 1, 2, 3}}));
  EXPECT_EQ(
      file.notes,
      (std::vector<std::string>{
          "ignored the list \"uv\" of \"face\": expected 1 to 16 numbers, as many in each row",
          "ignored the 5 elements \"nothing\"",
          "read the positions of 4 vertices, doubles, as floats",
          "ignored the list \"n\" of \"vertex\": expected 1 to 16 numbers, as many in each row"}));
}

TEST(Ply, TakesAnyEndOfLine) {
  const std::string text = header("ascii") + kRows;
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(parse_ply(other).positions, kCorner);
  }
  // The data starts with 0x0A: part of the first number where all lines end with CR.
  const std::string point =
      "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\n";
  std::string cr;
  for (const char c : header("binary_little_endian", point)) cr += c == '\n' ? '\r' : c;
  EXPECT_EQ(parse_ply(cr + "\n\r\n").positions, (std::vector<float>{10, 13, 10}));
  std::string mixed = header("binary_little_endian", point);
  mixed.insert(mixed.size() - 1, "\r");
  EXPECT_EQ(parse_ply(mixed + "\n\r\n").positions, (std::vector<float>{10, 13, 10}));
}

TEST(Ply, UnrollsTriangleStrips) {
  const Parsed file =
      parse_ply(header("ascii",
                       "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                       "element tristrips 1\nproperty list int int vertex_indices\n") +
                "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n11 0 1 2 3 3 4 -1 0 1 -1 2\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}, {2, 1, 3}}));
}

TEST(Ply, TakesPointsAlone) {
  const Parsed file =
      parse_ply(header("ascii", kVertices + "element face 0\n") + "1 2 3 4 5 6 7 8 9");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions.size(), 9U);
  EXPECT_TRUE(file.faces.empty());
}

std::string with(std::string text, char from, char to) {
  std::replace(text.begin(), text.end(), from, to);
  return text;
}

TEST(Ply, TakesRowsOnAnyLines) {
  for (const std::string& rows : {with(kRows, ' ', '\n'), with(kRows, '\n', ' '),
                                  "\n# corners\n0 0\n0\n1\n0 0 # x\n\n0 1 0\n3 0 1\n 2"s}) {
    const Parsed file = parse_ply(header("ascii") + rows);
    EXPECT_EQ(file.error, "") << rows;
    EXPECT_EQ(file.positions, kCorner);
    EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}}));
    EXPECT_TRUE(file.notes.empty());
  }
  const std::string vertices = header("ascii") + "0 0\n0\n1 0\n0\n0 1 0\n";
  EXPECT_EQ(ply_error(vertices + "3 0 1\n7\n"),
            "index-out-of-range: line 16: corner 2 of face 0 is \"7\", expected a vertex from 0 to "
            "2");
  EXPECT_EQ(ply_error(vertices + "3 0 1\n").substr(0, 18), "truncated: line 15");
}

// A file that was cut has fewer lines than rows, as one has whose rows share lines.
TEST(Ply, DoesNotTakeWhatARowHasMoreForRows) {
  const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(ply_error(header("ascii", kVertices + faces) + vertices + "3 0 1 2 1 0 0\n"),
            "truncated: line 13: the header promises 5 rows, but is followed by only 4 lines: "
            "expected the end of the file behind the last row, found \"0\"");
  EXPECT_EQ(
      parse_ply(header("ascii", kVertices + faces) + vertices + "3 0 1 2 3 2 1 0 # c\n\n").faces,
      (std::vector<std::vector<Index>>{{0, 1, 2}, {2, 1, 0}}));
}

TEST(Ply, SaysThatTheFileEndsWithinAValueThatIsPassedOver) {
  // In an element of its own, beside what is read, and in a list that only some rows have.
  const std::string rows = "0 0\n0\n1 0\n0\n0 1 0\n";
  for (const std::string end : {"", "\n", "\n\n", " \n # no more\n", "\r\n\t"}) {
    EXPECT_EQ(ply_error(header("ascii", kVertices + "element edge 1\nproperty int a\n"
                                                    "property int b\n") +
                        rows + "7" + end)
                  .substr(0, 11),
              "truncated: ");
    EXPECT_EQ(ply_error(header("ascii", kVertices + kFaces + "property list int int more\n") +
                        rows + "3 0 1 2 2 7" + end)
                  .substr(0, 11),
              "truncated: ");
    EXPECT_EQ(ply_error(header("ascii", kVertices + "element material 1\n"
                                                    "property list uchar int more\n") +
                        rows + "1" + end)
                  .substr(0, 11),
              "truncated: ");
  }
}

TEST(Ply, PassesOverWhatARowHasMoreThanTheHeaderSays) {
  const std::string colors = "0 0 0 255\n1 0 0 0 0\n0 1 0\n3 0 1 2 1 2 3\n";
  const Parsed file = parse_ply(header("ascii") + colors);
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, kCorner);
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}}));
  EXPECT_EQ(file.notes, std::vector<std::string>{
                            "ignored what 3 rows have beyond the properties of the header"});
}

TEST(Ply, TakesTheOnlyListOfIntegersForTheVertices) {
  const std::string faces = "element face 1\nproperty list uchar int corners\n";
  const Parsed file = parse_ply(header("ascii", kVertices + faces) + kRows);
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}}));
  EXPECT_EQ(file.notes,
            std::vector<std::string>{"took the list \"corners\" of \"face\" for its vertices"});
  const std::string error =
      "parse-error: line 10: the element face has no list vertex_indices (or vertex_index)";
  EXPECT_EQ(ply_error(header("ascii", kVertices + faces + "property list uchar int more\n")),
            error);
  EXPECT_EQ(ply_error(header("ascii", kVertices + "element face 1\nproperty list uchar float uv\n"
                                                  "property uchar red\n")),
            error);
}

TEST(Ply, PassesOverWhatFillsUpATextBehindItsEnd) {
  const std::string text = header("ascii");
  for (const std::string& padding : {"\n\0"s, "\0\0"s, "\n\x1A\0"s}) {
    const Parsed file = parse_ply(text + kRows + padding);
    EXPECT_EQ(file.error, "");
    EXPECT_EQ(file.notes, std::vector<std::string>());
    EXPECT_EQ(file.faces.size(), 1U);
    EXPECT_NE(ply_error(text + padding), "");
    EXPECT_NE(ply_error(text.substr(0, text.size() - 1) + " #" + padding), "");
  }
  // As without it, a row that is too short takes nothing of the next one.
  EXPECT_EQ(ply_error(text + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n\0"s),
            "parse-error: line 10: expected a number for z of \"vertex\" 0 of 3, found the end of "
            "the line");
}

TEST(Ply, NotesWhatFollows) {
  EXPECT_EQ(
      parse_ply(header("ascii") + kRows + "\nmore\n").notes,
      std::vector<std::string>{"ignored what follows the last element, from line 15 on: \"more\""});
  EXPECT_EQ(parse_ply(header("binary_little_endian", kVertices) + std::string(40, '\0')).notes,
            std::vector<std::string>{"ignored the 4 bytes behind the last element"});
}

TEST(Ply, ExplainsAWrongHeader) {
  const std::pair<std::string, std::string> errors[] = {
      {"ply\n",
       "truncated: line 2: expected format, element, property, comment, obj_info or "
       "end_header, found the end of the file"},
      {"ply\nformat text 1.0\n",
       "parse-error: line 2: expected ascii, binary_little_endian or binary_big_endian, found "
       "\"text\""},
      {"ply\nend_header\n", "parse-error: line 2: the header has no line format"},
      {"ply\nelemnt vertex 3\n",
       "parse-error: line 2: expected format, element, property, comment, obj_info or end_header, "
       "found \"elemnt\""},
      {"ply\nelement vertex -1\n",
       "parse-error: line 2: expected the number of elements, found \"-1\""},
      {"ply\nelement\n",
       "parse-error: line 2: expected the name of the element, found the end of "
       "the line"},
      {"ply\nproperty float x\n", "parse-error: line 2: this property comes before any element"},
      {"ply\nelement vertex 1\nproperty real x\n",
       "parse-error: line 3: expected a type, such as float, uchar or int32, found \"real\""},
      {"ply\nelement vertex 1\nproperty list uchar x\n",
       "parse-error: line 3: expected a type, such as float, uchar or int32, found \"x\""},
      {"ply\nelement vertex 1\nproperty float\n",
       "parse-error: line 3: expected the name of the property, found the end of the line"},
      {"ply\nelement face 1\nelement face 1\n",
       "parse-error: line 3: the header has the element \"face\" already, expected it once"},
      {"ply\nformat ascii 1.0\nformat binary_little_endian 1.0\n",
       "parse-error: line 3: the header has a line format already, expected it once"},
      {"ply\nformat ascii 2.0\n", "parse-error: line 2: expected the version 1.0, found \"2.0\""},
      {"ply\nformat ascii 1.0 junk\n",
       "parse-error: line 2: expected the end of the line, found \"junk\""},
      {"ply\nelement vertex 1 junk\n",
       "parse-error: line 2: expected the end of the line, found \"junk\""},
      {"ply\nelement vertex 1\nproperty float x junk\n",
       "parse-error: line 3: expected the end of the line, found \"junk\""},
      {"ply\nelement vertex 1\nproperty list uchar int x junk\n",
       "parse-error: line 3: expected the end of the line, found \"junk\""},
      {header("ascii", kVertices + "property double x\n"),
       "parse-error: line 7: the element \"vertex\" has the property \"x\" already, expected it "
       "once"},
      {header("ascii", kFaces), "parse-error: line 5: the header has no element vertex"},
      {header("ascii", "element vertex 1\nproperty float x\nproperty list uchar float y\n"),
       "parse-error: line 6: the element vertex has no property y, expected the numbers x, y and "
       "z"},
      {header("ascii", kVertices + "element face 1\nproperty uchar vertex_indices\n"),
       "parse-error: line 9: the element face has no list vertex_indices (or vertex_index)"}};
  for (const auto& [text, error] : errors) EXPECT_EQ(ply_error(text), error) << text;
}

TEST(Ply, TakesBlanksBehindTheLinesOfTheHeader) {
  std::string text;
  for (const char c : header("ascii")) text += c == '\n' ? " \t\n" : std::string(1, c);
  EXPECT_EQ(parse_ply(text + kRows).positions, kCorner);
  // Elements may have properties of the same name.
  EXPECT_EQ(ply_error(header("ascii", kVertices + kFaces + "property float x # twice\n") +
                      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 5\n"),
            "");
}

TEST(Ply, RefusesCountsBeyondTheFile) {
  for (const std::string format : {"ascii", "binary_little_endian"}) {
    EXPECT_EQ(ply_error(header(format,
                               "element vertex 4000000000\nproperty float x\nproperty float y\n"
                               "property float z\n")),
              "truncated: line " + std::string("7") +
                  ": the header promises 4000000000 elements \"vertex\", but is followed by only 0 "
                  "bytes");
  }
  EXPECT_EQ(ply_error(header("ascii", kVertices + "element face 99999999999999999999\n"
                                                  "property list uchar int vertex_index\n") +
                      kRows)
                .substr(0, 11),
            "truncated: ");
  // Each of the two would fit alone.
  const std::string faces = "element face 30\nproperty list uchar int vertex_index\n";
  EXPECT_EQ(ply_error(header("binary_little_endian", kVertices + faces) + std::string(40, '\0')),
            "truncated: line 9: the header promises 30 elements \"face\", but is followed by only "
            "40 bytes");
}

TEST(Ply, ExplainsAWrongRow) {
  const std::string text = header("ascii");
  const std::pair<std::string, std::string> errors[] = {
      {"0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n",
       "parse-error: line 11: expected a number for y of \"vertex\" 1 of 3, found \"x\""},
      {"0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
       "parse-error: line 11: expected a number for z of \"vertex\" 1 of 3, found the end of the "
       "line"},
      {"0 0 0\n1 0 0\n0 1 0\n# comment\n",
       "truncated: line 14: expected the length of the list \"vertex_indices\" of row 0, found the "
       "end of the file"},
      {"0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n",
       "parse-error: line 13: the length of the list \"vertex_indices\" of row 0 is -3, expected 0 "
       "or more"},
      {"0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n",
       "truncated: line 13: the length of the list \"vertex_indices\" of row 0 is 4000000000, more "
       "than the rest of the file can hold"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
       "index-out-of-range: line 13: corner 2 of face 0 is \"3\", expected a vertex from 0 to 2"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n",
       "index-out-of-range: line 13: corner 2 of face 0 is \"-1\", expected a vertex from 0 to 2"},
      {"0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n",
       "parse-error: line 13: expected vertex 2 of the 3 of face 0, found \"1.5\""}};
  for (const auto& [rows, error] : errors) EXPECT_EQ(ply_error(text + rows), error);
}

TEST(Ply, ExplainsWrongBytes) {
  const std::string text = header("binary_little_endian");
  const auto at = [&text](std::size_t offset) {
    return "byte " + std::to_string(text.size() + offset) + ": ";
  };
  Bytes vertices(false);
  for (const float x : kCorner) vertices.add(x);
  const std::string data = text + std::string(vertices);
  EXPECT_EQ(ply_error(text + std::string(20, 'x')).substr(0, 19), "truncated: line 9: ");
  Bytes outside(false);
  outside.add(std::uint8_t{3}).add(0).add(1).add(-7);
  EXPECT_EQ(
      ply_error(data + std::string(outside)),
      "index-out-of-range: " + at(45) + "corner 2 of face 0 is -7, expected a vertex from 0 to 2");
  EXPECT_EQ(ply_error(data + "\x03" + std::string(11, '\0')),
            "truncated: " + at(36) +
                "the length of the list \"vertex_indices\" of row 0 is 3, more than the rest of "
                "the file can hold");
  const std::string halves = header(
      "binary_big_endian", kVertices + "element face 1\nproperty list uchar float vertex_index\n");
  Bytes half(true);
  half.add(std::uint8_t{3}).add(0.0F).add(0.5F).add(1.0F);
  EXPECT_EQ(ply_error(halves + std::string(36, '\0') + std::string(half)),
            "parse-error: byte " + std::to_string(halves.size() + 41) +
                ": expected vertex 2 of the 3 of face 0, found 0.5, which is no whole number");
}

TEST(Ply, TellsNumbersThatAreNoneFromTheEndOfTheFile) {
  const std::string text =
      header("binary_little_endian",
             kVertices + "element face 1\nproperty list uchar float vertex_index\n");
  Bytes data(false);
  for (const float x : kCorner) data.add(x);
  data.add(std::uint8_t{3}).add(0.0F).add(1.0F).add(0.5F);
  EXPECT_EQ(ply_error(text + std::string(data)),
            "parse-error: byte " + std::to_string(text.size() + 45) +
                ": expected vertex 3 of the 3 of face 0, found 0.5, which is no whole number");
}

TEST(Ply, NamesIndicesOfAnySizeAsTheyAreWritten) {
  const auto elements = [](const std::string& type) {
    return kVertices + "element face 1\nproperty list uchar " + type + " vertex_index\n";
  };
  const auto found = [](const std::string& text) {
    const std::string error = ply_error(text);
    const std::size_t begin = error.find(" is ") + 4;
    return error.substr(begin, error.find(',') - begin);
  };
  const auto text = [&](const char* type, const std::string& vertex) {
    return header("ascii", elements(type)) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 " + vertex + "\n";
  };
  EXPECT_EQ(found(text("float", "1e10")), "\"1e10\"");
  EXPECT_EQ(found(text("double", "-1e300")), "\"-1e300\"");
  EXPECT_EQ(found(text("int", "99999999999999999999")), "\"99999999999999999999\"");
  const auto bytes = [&](const char* type, auto vertex) {
    using T = decltype(vertex);
    Bytes data(true);
    for (const float x : kCorner) data.add(x);
    data.add(std::uint8_t{3}).add(T{0}).add(T{1}).add(vertex);
    return header("binary_big_endian", elements(type)) + std::string(data);
  };
  EXPECT_EQ(found(bytes("float", 1e10F)), "10000000000");
  EXPECT_EQ(found(bytes("double", 1e20)), "1e+20");
  EXPECT_EQ(found(bytes("int64", std::int64_t{-5'000'000'000})), "-5000000000");
  EXPECT_EQ(found(bytes("uint64", UINT64_MAX)), "18446744073709551615");
}

TEST(Ply, NamesCountsAsTheyAreWritten) {
  EXPECT_EQ(ply_error(header("ascii", "element vertex 99999999999999999999\n")),
            "truncated: line 3: the header promises 99999999999999999999 elements \"vertex\", more "
            "than a file can hold");
  const std::string floats =
      header("ascii", kVertices + "element face 1\nproperty list float int vertex_index\n");
  EXPECT_EQ(ply_error(floats + "0 0 0\n1 0 0\n0 1 0\n1e10 0 1 2\n"),
            "truncated: line 13: the length of the list \"vertex_index\" of row 0 is 1e10, more "
            "than the rest of the file can hold");
  EXPECT_EQ(ply_error(header("ascii") + "0 0 0\n1 0 0\n0 1 0\n99999999999999999999 0 1 2\n"),
            "truncated: line 13: the length of the list \"vertex_indices\" of row 0 is "
            "99999999999999999999, more than the rest of the file can hold");
}

TEST(Ply, TellsAtWhichBytesItemsStart) {
  // Rows of one size, and rows that are read value by value.
  for (const bool packed : {true, false}) {
    const std::string more = packed ? "property uchar c\n" : "property list uchar uchar c\n";
    const std::string text = header("binary_little_endian", kVertices + more + kFaces);
    Bytes data(false);
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t i = 0; i < 3; ++i) data.add(kCorner[3 * v + i]);
      data.add(std::uint8_t{0});
    }
    data.add(std::uint8_t{3}).add(0).add(1).add(1);
    std::vector<Error> problems = {{"a", "Face.", {.faces = {0, 9}}},
                                   {"b", "Vertices.", {.vertices = {2, 1}}}};
    add_places(problems, bytes_of(text + std::string(data)), Format::kPly);
    const auto at = [&](std::size_t offset) { return std::to_string(text.size() + offset); };
    EXPECT_EQ(problems[0].message, "Face. (Byte " + at(39) + ")");
    EXPECT_EQ(problems[1].message, "Vertices. (Bytes " + at(26) + ", " + at(13) + ")");
  }
}

TEST(Ply, FindsTheLinesOfFacesInTextOnly) {
  const std::vector<Index> faces = {0, 7};
  EXPECT_EQ(lines_of_faces(bytes_of(header("ascii") + kRows), Format::kPly, faces),
            (std::vector<std::size_t>{13, 0}));
  Bytes data(false);
  for (const float x : kCorner) data.add(x);
  data.add(std::uint8_t{3}).add(0).add(1).add(2);
  const std::string binary = header("binary_little_endian") + std::string(data);
  EXPECT_TRUE(read_ply(bytes_of(binary)).value().binary);
  EXPECT_EQ(lines_of_faces(bytes_of(binary), Format::kPly, faces),
            (std::vector<std::size_t>{0, 0}));
}

}  // namespace
}  // namespace halfedge
