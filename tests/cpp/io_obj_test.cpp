#include <gtest/gtest.h>
#include <halfedge/io/parse.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/text_file.h"

namespace halfedge {
namespace {

using namespace std::string_literals;
using test::obj_error;
using test::parse_obj;
using test::Parsed;
using Faces = std::vector<std::vector<Index>>;
using Floats = std::vector<float>;

// A square: what most forms below are put behind.
constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string square_and(const std::string& rest) { return kSquare + rest; }

TEST(Obj, ReadsVerticesAndFaces) {
  const Parsed file = parse_obj("v 1 2 3\nv -4.5 .25 6e1\nv 7 8 9\nf 1 2 3\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, (Floats{1, 2, 3, -4.5F, 0.25F, 60, 7, 8, 9}));
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2}}));
  EXPECT_TRUE(file.notes.empty());
}

TEST(Obj, LeavesSizesEmptyForTrianglesOnly) {
  const auto triangles = read_obj(test::bytes_of(square_and("f 1 2 3\nf 1 3 4\n")));
  ASSERT_TRUE(triangles);
  EXPECT_TRUE(triangles.value().soup.sizes.empty());
  const auto mixed = read_obj(test::bytes_of(square_and("f 1 2 3\nf 1 3 4\nf 1 2 3 4\nf 2 3 4\n")));
  ASSERT_TRUE(mixed);
  const auto sizes = mixed.value().soup.sizes.span();
  EXPECT_EQ(std::vector<Index>(sizes.begin(), sizes.end()), (std::vector<Index>{3, 3, 4, 3}));
}

TEST(Obj, ReadsPolygonsOfAnyDegree) {
  EXPECT_EQ(parse_obj(square_and("f 1 2 3 4\nf 1 2 3\nf 4 3 2 1 4 2 3\n")).faces,
            (Faces{{0, 1, 2, 3}, {0, 1, 2}, {3, 2, 1, 0, 3, 1, 2}}));
}

TEST(Obj, LeavesSmallAndRepeatedFacesToTheBuilder) {
  const Parsed file = parse_obj(square_and("f\nf 1\nf 1 2\nf 1 1 2\n"));
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces, (Faces{{}, {0}, {0, 1}, {0, 0, 1}}));
}

TEST(Obj, ReadsTheVertexOfEachFormOfCorner) {
  for (const char* face :
       {"1 2 3", "1/5 2/6 3/7", "1/5/9 2/6/8 3/7/7", "1//9 2//8 3//7", "1/ 2/ 3/", "1// 2// 3//",
        "1/-1/-2 2/-9 3//-3", "+1 +2/+3 3", "01 002 3", "00000000000000000000000001 2 3"}) {
    const Parsed file = parse_obj(square_and(std::string("f ") + face + "\n"));
    EXPECT_EQ(file.error, "") << face;
    EXPECT_EQ(file.faces, (Faces{{0, 1, 2}})) << face;
  }
}

TEST(Obj, CountsNegativeIndicesBackFromTheVerticesSoFar) {
  const Parsed file =
      parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4/-1 -2//-1 -1/-1/-1\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Obj, AllowsAFaceBeforeItsVertices) {
  EXPECT_EQ(parse_obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\n").faces, (Faces{{0, 1, 2}}));
}

TEST(Obj, ReadsTheObsoleteFaceStatement) {
  EXPECT_EQ(parse_obj(square_and("fo 1 2 3\n")).faces, (Faces{{0, 1, 2}}));
}

TEST(Obj, AcceptsEveryEndOfLine) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char* line : {"# comment", "v 0 0 0", "", "v 1 0 0", "v 1 1 0", "f 1 2 3"}) {
      text += std::string(line) + end;
    }
    EXPECT_EQ(parse_obj(text).positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
    EXPECT_EQ(parse_obj(text).faces, (Faces{{0, 1, 2}}));
    text += std::string("f 1 x") + end;
    EXPECT_EQ(obj_error(text),
              "parse-error: line 7: expected a vertex of the face, as 3, 3/1, 3/1/2 or 3//2, "
              "found \"x\"");
  }
}

TEST(Obj, NeedsNoEndOfTheLastLine) {
  EXPECT_EQ(parse_obj(square_and("f 1 2 3")).faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(parse_obj("v 1 2 3").positions, (Floats{1, 2, 3}));
}

TEST(Obj, AcceptsBlanksTabsAndAByteOrderMark) {
  const Parsed file =
      parse_obj("\xEF\xBB\xBFv\t0 \t 0  0\t\n  v 1 0 0\n\tv 1 1 0  \n \t \n f  1\t2   3 \n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2}}));
}

TEST(Obj, SkipsComments) {
  const Parsed file = parse_obj(
      "#v 9 9 9\n  # v 9 9 9\nv 0 0 0 # origin\nv 1 0 0#x\nv 1 1 0\n"
      "f 1 2 3 # 4\n#f 1 2 3");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2}}));
}

TEST(Obj, JoinsLinesAtABackslash) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : "v 0 \\\n0 0\nv 1 0 0\nv \\\n 1 1 0\nf 1\\\n\\\n2 \\\n3\n"s) {
      if (c == '\n') {
        text += end;
      } else {
        text += c;
      }
    }
    const Parsed file = parse_obj(text);
    EXPECT_EQ(file.error, "");
    EXPECT_EQ(file.positions, (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0}));
    EXPECT_EQ(file.faces, (Faces{{0, 1, 2}}));
  }
}

TEST(Obj, JoinsLinesAtABackslashBeforeBlanks) {
  const Parsed file = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\ \t\n3\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}}));
  EXPECT_NE(parse_obj("v 0 0 0\nf 1 1 \\ 1\n").error, "");
}

// A vertex that is taken for an unknown statement would move the indices of all that follow.
TEST(Obj, SkipsTheByteOrderMarksOfFilesPutTogether) {
  const std::string mark = "\xEF\xBB\xBF";
  const std::string part = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
  const Parsed file = parse_obj(mark + mark + part + mark + "\n" + mark + part);
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.faces, (std::vector<std::vector<Index>>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_TRUE(file.notes.empty());
}

TEST(Obj, CountsJoinedLinesInErrors) {
  EXPECT_EQ(obj_error("v 0 0 \\\n0\nv 1 \\\n\\\nx 0\n"),
            "parse-error: line 5: expected a number for y of the vertex, found \"x\"");
}

TEST(Obj, KeepsTheLineAfterACommentOrANameThatEndsWithABackslash) {
  EXPECT_EQ(parse_obj("# C:\\meshes\\\nv 1 2 3\nmtllib C:\\\nv 4 5 6\n").positions,
            (Floats{1, 2, 3, 4, 5, 6}));
}

// One that isn't read goes as far as one that is: else attributes would decide what is a face.
TEST(Obj, JoinsLinesOfWhatItPassesOver) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
  for (const std::string start : {"vt 0 1", "vt", "vn 0 0 1", "vn", "s", "s 1", "l 1 2", "p 1",
                                  "curv 0 1 1 2", "surf 0 1", "parm u 0", "vp 1", "cstype"}) {
    const std::string text = corners + start + " \\\nf 1 2 3\n" + start + "\\ \n 1 \\\r\n1\n";
    for (const bool attributes : {true, false}) {
      const Parsed file = test::flatten(read_obj(test::bytes_of(text), {.attributes = attributes}));
      EXPECT_EQ(file.error, "");
      EXPECT_EQ(file.faces, (Faces{{0, 1, 2}})) << start << attributes;
      for (const std::string& note : file.notes) EXPECT_EQ(note.find("unknown"), note.npos) << note;
    }
  }
  for (const std::string start :
       {"g a", "o a", "usemtl C:", "mtllib C:", "usemap C:", "call a", "what"}) {
    for (const bool attributes : {true, false}) {
      const Parsed file = test::flatten(
          read_obj(test::bytes_of(corners + start + "\\\nf 3 2 1\n"), {.attributes = attributes}));
      EXPECT_EQ(file.faces, (Faces{{0, 1, 2}, {2, 1, 0}})) << start << attributes;
    }
  }
}

TEST(Obj, IgnoresWhatAVertexHasBesidesItsPosition) {
  EXPECT_EQ(parse_obj("v 1 2 3 1.0\nv 4 5 6 0.5 0.25 nan\nv 7 8 9 1 \\\n0 0 1\n").positions,
            (Floats{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(Obj, IgnoresOtherStatements) {
  const Parsed file = parse_obj(
      "mtllib a.mtl\no an f v\ng f 1 2 3\nvn 0 0 1\nvt 0 0\nvp 1\ns off\nusemtl red\n"
      "cstype bezier\ndeg 3\nparm u 0 1\nend\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  EXPECT_EQ(file.error, "");
  EXPECT_EQ(file.positions.size(), 9U);
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(file.notes,
            (std::vector<std::string>{"ignored 1 texture coordinate (vt) to which no face refers",
                                      "ignored 1 normal (vn) to which no face refers"}));
}

TEST(Obj, NotesWhatAMeshCannotHold) {
  const Parsed file = parse_obj(square_and(
      "p 1 2\nl 1 2\nl 2 3\nl 3 4\ncurv 0 1 1 2\nsurf 0 1 0 1 1\nvertex 1\nfaces\nf 1 2 3\n"));
  EXPECT_EQ(file.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(file.notes, (std::vector<std::string>{
                            "ignored 1 point (p) statement", "ignored 3 line (l) statements",
                            "ignored 2 curve or surface (curv, curv2, surf) statements",
                            "ignored 2 unknown statements, the first in line 11: \"vertex\""}));
}

TEST(Obj, AnEmptyFileIsAnEmptySoup) {
  for (const char* text : {"", "\n\n", "# nothing\n", "o name\n"}) {
    EXPECT_EQ(parse_obj(text).error, "");
    EXPECT_TRUE(parse_obj(text).positions.empty());
    EXPECT_TRUE(parse_obj(text).faces.empty());
  }
}

TEST(Obj, RefusesTextThatHasNothingOfAnObjFile) {
  EXPECT_EQ(obj_error("\nlorem ipsum\ndolor sit\n"),
            "parse-error: line 2: expected a statement of an OBJ file, such as v or f, found "
            "\"lorem\"");
}

TEST(Obj, TellsWhichCoordinateIsNoNumber) {
  EXPECT_EQ(obj_error("# 1\n\nv 1 abc 3\n"),
            "parse-error: line 3: expected a number for y of the vertex, found \"abc\"");
  EXPECT_EQ(
      obj_error("v 1 2\nf 1\n"),
      "parse-error: line 1: expected a number for z of the vertex, found the end of the line");
  EXPECT_EQ(
      obj_error("v # 1 2 3\n"),
      "parse-error: line 1: expected a number for x of the vertex, found the end of the line");
  EXPECT_EQ(obj_error("v 1 2 3\nv 1 2"),
            "truncated: line 2: expected a number for z of the vertex, found the end of the file");
}

TEST(Obj, RefusesMalformedCorners) {
  for (const char* corner :
       {"a", "/1", "1/a", "1/2/3/4", "1.5", "1,2", "-", "+", "1-2", "--1", "1\\2"}) {
    EXPECT_EQ(obj_error(square_and(std::string("f 2 3 ") + corner + "\n")),
              std::string("parse-error: line 5: expected a vertex of the face, as 3, 3/1, 3/1/2 or "
                          "3//2, found \"") +
                  (corner == std::string("1\\2") ? "\\" : corner) + "\"")
        << corner;
  }
}

TEST(Obj, TellsWhichVertexIsOutOfRange) {
  EXPECT_EQ(
      obj_error(square_and("f 1 2 3\nf 3 4 5\n")),
      "index-out-of-range: line 6: corner 2 of face 1 is \"5\", expected a vertex from 1 to 4");
  EXPECT_EQ(
      obj_error(square_and("\n\nf 1/1 0/1 3/1\n")),
      "index-out-of-range: line 7: corner 1 of face 0 is \"0/1\", expected a vertex from 1 to 4");
  EXPECT_EQ(obj_error("v 0 0 0\nv 1 0 0\nf 1 2 0\nv 1 1 0\n"),
            "index-out-of-range: line 3: corner 2 of face 0 is \"0\", expected a vertex from 1 to "
            "3");
  EXPECT_EQ(obj_error(square_and("f 1 2 3 4\nf 1 2 3\nf 9 1 2 3\n")),
            "index-out-of-range: line 7: corner 0 of face 2 is \"9\", expected a vertex from 1 to "
            "4");
  EXPECT_EQ(obj_error("v 0 0 0\nf -1 -2 -1\nv 0 0 0\n"),
            "index-out-of-range: line 2: corner 1 of face 0 is \"-2\", expected -1 to -1, counted "
            "back from the last vertex so far");
  EXPECT_EQ(
      obj_error("f -1 -2 -3\n"),
      "index-out-of-range: line 1: corner 0 of face 0 is \"-1\", but no vertex comes before it");
  EXPECT_EQ(
      obj_error("f 1 2 3\n"),
      "index-out-of-range: line 1: corner 0 of face 0 is \"1\", but the file has no vertices");
}

TEST(Obj, FindsTheWrongIndexAmongPolygonsAndJoinedLines) {
  const std::string text = square_and("f 1 2 3 4\nf 1 2\nf 1 2 \\\n3 4 \\\n7/1 2\nf 1 2 9\n");
  EXPECT_EQ(
      obj_error(text),
      "index-out-of-range: line 9: corner 4 of face 2 is \"7/1\", expected a vertex from 1 to 4");
  const auto file = read_obj(test::bytes_of(text));
  EXPECT_EQ(file.error().witness.faces, std::vector<Index>{2});
}

TEST(Obj, DoesNotWrapHugeIndices) {
  for (const char* index :
       {"4294967297", "2147483648", "2147483649", "9223372036854775807", "9223372036854775809",
        "18446744073709551617", "99999999999999999999999"}) {
    EXPECT_EQ(obj_error(square_and(std::string("f 2 3 ") + index + "\n")),
              std::string("index-out-of-range: line 5: corner 2 of face 0 is \"") + index +
                  "\", expected a vertex from 1 to 4");
    EXPECT_EQ(obj_error(square_and(std::string("f 2 3 -") + index + "\n")),
              std::string("index-out-of-range: line 5: corner 2 of face 0 is \"-") + index +
                  "\", expected -1 to -4, counted back from the last vertex so far");
  }
}

TEST(Obj, ShowsStrangeBytesOfAnErrorInPlainText) {
  using namespace std::string_literals;
  EXPECT_EQ(obj_error("v 0 \xC3\xA9\0\x01\n 0\n"s),
            "parse-error: line 1: expected a number for y of the vertex, found "
            "\"\\xc3\\xa9\\x00\\x01\"");
  EXPECT_EQ(obj_error("v " + std::string(100, 'a')),
            "parse-error: line 1: expected a number for x of the vertex, found \"" +
                std::string(32, 'a') + "...\"");
  EXPECT_EQ(obj_error("v " + std::string(32, '~')),
            "parse-error: line 1: expected a number for x of the vertex, found \"" +
                std::string(32, '~') + "\"");
}

TEST(Obj, FindsTheLinesOfFaces) {
  const std::string text = square_and("f 1 2 3\n# f\n\nf 1 \\\n2 3\r\nf 1 2 3 4\rf 4 3 2");
  EXPECT_EQ(
      lines_of_faces(test::bytes_of(text), Format::kObj, std::vector<Index>{3, 0, 2, 1, 9, 0}),
      (std::vector<std::size_t>{11, 5, 10, 8, 0, 5}));
}

}  // namespace
}  // namespace halfedge
