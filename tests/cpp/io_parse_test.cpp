#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/mesh.h>
#include <halfedge/repair/repair.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "support/text_file.h"

namespace halfedge {
namespace {

using namespace std::string_literals;
using test::bytes_of;

constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
constexpr const char* kOff = "OFF\n3 1 3\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";

std::string error_of(const std::string& text, std::optional<Format> claimed = std::nullopt) {
  return test::flatten(parse(bytes_of(text), claimed)).error;
}

TEST(Parse, FindsTheFormatByTheContent) {
  for (const std::string text : {kObj, "# blender\n\nmtllib a.mtl\n", "o thing\ng part\nvn 0 0 1\n",
                                 "f 1 2 3\nv 0 0 0\nv 0 0 0\nv 0 0 0", "\xEF\xBB\xBFv 0 0 0",
                                 "v nan nan nan", "name\n \tv 0 0 0", "usemtl red"}) {
    const auto file = parse(bytes_of(text));
    ASSERT_TRUE(file) << text << file.error().message;
    EXPECT_EQ(file.value().format, Format::kObj) << text;
  }
  for (const std::string text :
       {kOff, "\xEF\xBB\xBFOFF 0 0 0", "# c\n  OFF0 0 0", "NOFF\n0 0", "1 0\n1 2 3"}) {
    const auto file = parse(bytes_of(text));
    ASSERT_TRUE(file) << text << file.error().message;
    EXPECT_EQ(file.value().format, Format::kOff) << text;
  }
}

TEST(Parse, TrustsTheContentMoreThanTheClaim) {
  const auto obj = parse(bytes_of(kObj), Format::kOff);
  ASSERT_TRUE(obj);
  EXPECT_EQ(obj.value().format, Format::kObj);
  EXPECT_EQ(obj.value().notes,
            std::vector<std::string>{"read as OBJ, which its content is, and not as OFF"});
  const auto off = parse(bytes_of(kOff), Format::kObj);
  ASSERT_TRUE(off);
  EXPECT_EQ(off.value().format, Format::kOff);
  EXPECT_EQ(off.value().notes,
            std::vector<std::string>{"read as OFF, which its content is, and not as OBJ"});
  EXPECT_TRUE(parse(bytes_of(kObj), Format::kObj).value().notes.empty());
}

TEST(Parse, FallsBackOnTheClaim) {
  EXPECT_EQ(error_of("# nothing\n", Format::kObj), "");
  EXPECT_EQ(error_of("0 0 0\n", Format::kOff), "");
  EXPECT_EQ(
      error_of("v one two three\n", Format::kObj),
      "parse-error: line 1: expected a number for x of the vertex, found \"one\" (read as OBJ)");
  EXPECT_EQ(error_of("OOF\n", Format::kOff),
            "parse-error: line 1: expected the number of vertices (after the header word OFF, if "
            "any), found \"OOF\" (read as OFF)");
}

TEST(Parse, KnowsAnObjFileByNumbersThatCannotBeRead) {
  for (const std::string number : {"0,5", "-0,25", "0x1", "1l"}) {
    EXPECT_EQ(error_of("v " + number + " 0 0\n"),
              "parse-error: line 1: expected a number for x of the vertex, found \"" + number +
                  "\" (read as OBJ)");
  }
}

TEST(Parse, SaysWhatAnUnreadableFileIs) {
  EXPECT_EQ(error_of(""),
            "unknown-format: the file is empty (0 bytes), expected an OBJ, OFF, PLY or STL file");
  EXPECT_EQ(error_of("", Format::kObj),
            "unknown-format: the file is empty (0 bytes), expected an OBJ, OFF, PLY or STL file");
  EXPECT_EQ(
      error_of("# only\n \n"),
      "unknown-format: the file has nothing but comments and blanks, expected an OBJ, OFF, PLY or "
      "STL file");
  EXPECT_EQ(error_of("\nhello world\n"),
            "unknown-format: line 2: expected the start of an OBJ, OFF, PLY or STL file, found "
            "\"hello\"");
  for (const std::string line :
       {"0 0 0", "1", "1 2 3 4", "1 2 -3", "1 2 x", "1.5 2 3", "point 1 2 3", "f x"}) {
    EXPECT_EQ(
        error_of(line + "\n"),
        "unknown-format: line 1: expected the start of an OBJ, OFF, PLY or STL file, found \"" +
            line.substr(0, line.find(' ')) + "\"");
  }
  const std::pair<std::string, std::string> kinds[] = {
      {"glTF\x02\0\0\0"s, "a GLB file"},
      {"{\"asset\": {}}", "a JSON (perhaps glTF) file"},
      {" {\n  \"asset\": {}}", "a JSON (perhaps glTF) file"},
      {"{", "a JSON (perhaps glTF) file"},
      {"{ }", "a JSON (perhaps glTF) file"},
      {"{asset : {}}", "a JSON (perhaps glTF) file"},
      {"{ OFF", "a JSON (perhaps glTF) file"},
      {"# a list\n{\nOFF\n1 0 0\n0 0 0\n}\n", "a Geomview file with objects in braces"},
      {"<!DOCTYPE html>\n<p>404\n", "an HTML or XML file"},
      {"version https://git-lfs.github.com/spec/v1\nsize 1\n",
       "a Git LFS pointer, which stands for the file itself"},
      {"\x1F\x8B\x08\0\0"s, "a gzip archive, to be unpacked first"},
      {"PK\x03\x04\x14\0"s, "a ZIP archive (perhaps 3MF), to be unpacked first"},
      {"Kaydara FBX Binary  \0\x1A"s, "an FBX file"},
      {"7z\xBC\xAF\x27\x1C\0\4"s, "a 7z archive, to be unpacked first"},
      {"\x28\xB5\x2F\xFD\0\0"s, "a Zstandard archive, to be unpacked first"},
      {"# .PCD v0.7\nVERSION 0.7\n", "a PCD point cloud"},
      {"# vtk DataFile Version 3.0\nv 1\n", "a VTK file"}};
  for (const auto& [text, name] : kinds) {
    for (const auto claimed : {std::optional<Format>{}, std::optional{Format::kObj}}) {
      EXPECT_EQ(error_of(text, claimed),
                "unsupported-format: this is " + name + ", expected an OBJ, OFF, PLY or STL file");
    }
  }
}

TEST(Parse, SaysThatPositionsAreTooFarFromTheOriginForTheirSize) {
  const auto notes_of = [](const std::string& text) { return parse(bytes_of(text)).value().notes; };
  using Notes = std::vector<std::string>;
  // Of a map, in metres, with the second vertex 10 cm beside the first.
  EXPECT_EQ(notes_of("v 4512345.1 5412345.7 9\nv 4512345.2 5412345.7 9\nv 4512399 5412399 9\n"),
            Notes{"the positions are far from the origin for their size: as floats, which "
                  "are up to 0.5 apart there, they lose what is finer"});
  // South-west of the origin, and beside a vertex that is nowhere.
  EXPECT_EQ(notes_of("OFF\n3 0 0\n-9e6 -4e6 0\n-9000001 -4000002 0\nnan inf 0\n"),
            Notes{"the positions are far from the origin for their size: as floats, which "
                  "are up to 1 apart there, they lose what is finer"});
  // A part of a decimetre that has become one point.
  EXPECT_EQ(notes_of("v 5e6 1 0\nv 5e6 1 0.0\nv 5000000.1 1 0\nf 1 2 3\n"),
            Notes{"the positions are far from the origin for their size: as floats, which are up "
                  "to 0.5 apart there, they lose what is finer"});
  // Just over 2,048 times its size.
  EXPECT_EQ(notes_of("v 2048 0 0\nv 2049 0 0"),
            Notes{"the positions are far from the origin for their size: as floats, which are up "
                  "to 0.000244141 apart there, they lose what is finer"});
  for (const std::string near :
       {"v 2047 0 0\nv 2048 0 0", "v 0 0 0\nv 1e-30 0 0", "v 1000 0 0\nv 1001 0 0",
        "v 4e6 5e6 0\nv 4.1e6 5e6 0", "v 0 0 0\nv 1 0 0\nv 5e6 5e6 0", "v 5e6 5e6 5e6",
        "v nan nan nan", "v 0 0 0\nf 1 1 1"}) {
    EXPECT_EQ(notes_of(near), Notes{}) << near;
  }
}

TEST(Parse, TellsMaterialsFromFaces) {
  EXPECT_EQ(error_of("# materials\nnewmtl red\nKd 1 0 0\n", Format::kObj),
            "unsupported-format: this is an MTL file, the materials of an OBJ file, expected that "
            "one");
}

TEST(Parse, RefusesUtf16AndBinary) {
  const std::string utf16 = "not-text: the file is encoded in UTF-16, expected ASCII or UTF-8";
  EXPECT_EQ(error_of("\xFE\xFF\0v\0 "s, Format::kObj), utf16);
  EXPECT_EQ(error_of("\xFF\xFEv\0 \0"s, Format::kObj), utf16);
  EXPECT_EQ(error_of("v\0 \0001\0"s, Format::kObj), utf16);
  EXPECT_EQ(error_of("\0v\0 \0001"s, Format::kObj), utf16);
  EXPECT_EQ(error_of(std::string(4096, '\0'), Format::kObj),
            "not-text: byte 0 is 0, which no text has: this is no OBJ, OFF, PLY or STL file in "
            "text form");
  EXPECT_EQ(error_of("v 1 2 3\nabc\0d"s, Format::kObj),
            "not-text: byte 11 is 0, which no text has: this is no OBJ, OFF, PLY or STL file in "
            "text form");
}

// The bytes of a text, taken for those of triangles, are finite numbers of a fair size.
TEST(Parse, DoesNotTakeATextWithNulsForBinaryStl) {
  for (const std::string& text : {std::string(kObj), std::string(kOff)}) {
    std::string lines;
    while (lines.size() < 200) lines += "# 1234567\n";
    for (const std::string& padding : {"\0"s, std::string(600, '\0'), "\x1A\0"s}) {
      const auto file = parse(bytes_of(lines + text + padding));
      ASSERT_TRUE(file) << file.error().message;
      EXPECT_NE(file.value().format, Format::kStl);
      EXPECT_EQ(file.value().soup.view().face_count(), 1U);
      EXPECT_EQ(file.value().notes, std::vector<std::string>());
    }
  }
  std::string lines;
  while (lines.size() < 200) lines += "v 1 2 3\n";
  EXPECT_EQ(error_of(lines + "\0 "s + lines),
            "not-text: byte 200 is 0, which no text has: this is no OBJ, OFF, PLY or STL file in "
            "text form");
}

TEST(Parse, NamesItsFormats) {
  EXPECT_STREQ(name_of(Format::kObj), "OBJ");
  EXPECT_STREQ(name_of(Format::kOff), "OFF");
  EXPECT_STREQ(name_of(Format::kPly), "PLY");
  EXPECT_STREQ(name_of(Format::kStl), "STL");
}

TEST(Parse, FindsNoLinesOfNoFaces) {
  EXPECT_TRUE(lines_of_faces(bytes_of(kObj), Format::kObj, {}).empty());
  EXPECT_EQ(lines_of_faces({}, Format::kOff, std::vector<Index>{0}), std::vector<std::size_t>{0});
}

/// Their sentences, with the lines.
std::vector<std::string> sentences_of(std::vector<Error> problems, const std::string& text,
                                      Format format) {
  add_places(problems, bytes_of(text), format);
  std::vector<std::string> sentences;
  for (const Error& problem : problems) sentences.push_back(problem.message);
  return sentences;
}

/// What mending a file has found.
std::vector<std::string> findings_of(const std::string& text) {
  Result<ParsedFile> file = parse(bytes_of(text), std::nullopt, {.for_repair = true});
  if (!file) return {file.error().message};
  Mesh mesh;
  RepairReport report;
  EXPECT_TRUE(build_from_soup(mesh, file.value().soup.view(), {}, report));
  return sentences_of(report.problems, text, file.value().format);
}

/// Why no mesh can be built of a file as it is.
std::vector<std::string> refusals_of(const std::string& text, bool for_repair = false) {
  Result<ParsedFile> file = parse(bytes_of(text), std::nullopt, {.for_repair = for_repair});
  if (!file) return {file.error().message};
  Mesh mesh;
  BuildReport report;
  EXPECT_FALSE(build_from_polygons(mesh, file.value().soup.view(), report));
  return sentences_of(report.problems, text, file.value().format);
}

using Strings = std::vector<std::string>;

TEST(Parse, NamesTheLinesOfFacesAndVertices) {
  const std::string obj = "v 0 0 0\nv 1 0 0\n\nv 0 nan 0\nv 0 1 0\nf 1 2 4\n";
  EXPECT_EQ(refusals_of(obj),
            Strings{"Vertex 2 is at (0, nan, 0); expected three finite numbers. (Line 4)"});
  const std::string off =
      "OFF 4 1 0\n0 0 0 1 0 0\n0 1 0 # the last one is on the line below\n"
      "0 0 inf\n3 0 1 2\n";
  EXPECT_EQ(refusals_of(off),
            Strings{"Vertex 3 is at (0, 0, inf); expected three finite numbers. (Line 4)"});
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\nnan 0 0\n3 0 1 2\n";
  EXPECT_EQ(refusals_of(ply),
            Strings{"Vertex 3 is at (nan, 0, 0); expected three finite numbers. (Line 13)"});
  const std::string twice = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\nf 1 2 3\n";
  EXPECT_EQ(findings_of(twice),
            Strings{"Face 0 has the vertices of face 1, which was left out. (Lines 4, 6)"});
}

TEST(Parse, NamesMissingVerticesOfObjAsTheyAreWritten) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto finding = [&vertices](const std::string& face) {
    return findings_of(vertices + "f 1 2 3 # fine\nf  " + face + "\n");
  };
  const auto told = [](const std::string& what) {
    return Strings{"Face 1 uses vertex " + what + ": it was left out. (Line 5)"};
  };
  EXPECT_EQ(finding("1 0 2"), told("\"0\", but vertices have the numbers 1 to 3"));
  EXPECT_EQ(finding("1/7 99/8/9 2"), told("\"99/8/9\", but vertices have the numbers 1 to 3"));
  EXPECT_EQ(finding("1 2 3 \\\n 99999999999999999999 1"),
            told("\"99999999999999999999\", but vertices have the numbers 1 to 3"));
  EXPECT_EQ(finding("-1 -2 -9"), told("\"-9\", but fewer come before it"));
  EXPECT_EQ(findings_of("f 1 2 3\n"), Strings{"Face 0 uses vertex \"1\", but the file has no "
                                              "vertices: it was left out. (Line 1)"});
  EXPECT_EQ(refusals_of(vertices + "f 1 2 9\n", true),
            Strings{"Face 0 uses vertex \"9\", but vertices have the numbers 1 to 3. (Line 4)"});
  // Faces and corners by the hundred thousand take no time for each other.
  std::string many = vertices;
  for (int i = 0; i < 100000; ++i) many += "f 1 2 3 1\n";
  many += "f";
  for (int i = 0; i < 100000; ++i) many += " 1 2";
  const Strings found = findings_of(many + " 9\n");
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const std::string& sentence) {
    return sentence.starts_with(
        "Face 100000 uses vertex \"9\", but vertices have the numbers 1 to");
  }));
  // Behind a polygon, corners are no longer three by three.
  EXPECT_EQ(findings_of(vertices + "v 1 1 0\nf 1 2 4 3\nf 4 3 7\n"),
            Strings{"Face 1 uses vertex \"7\", but vertices have the numbers 1 to 4: it was left "
                    "out. (Line 6)"});
}

}  // namespace
}  // namespace halfedge
