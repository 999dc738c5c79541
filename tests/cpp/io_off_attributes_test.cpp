// Attributes of OFF files, and of STL, which has but one: what is read, and that it is written
// back.

#include <gtest/gtest.h>
#include <halfedge/operations/deletion.h>

#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "support/attribute_file.h"

namespace halfedge {
namespace {

using test::add;
using test::describe_all;
using test::expect_round_trip;
using test::read_mesh;
using test::sample_mesh;
using test::values_of;
using Doubles = std::vector<double>;
using Strings = std::vector<std::string>;

TEST(OffAttributes, AreReadInEveryOrderOfThePrefixes) {
  const test::MeshFile read = read_mesh(R"(STCNOFF
4 2 0
0 0 0  0 0 1  255 0 7 200  .5 .25
1 0 0  0 1 0  0 0 0 100  1 0
1 1 0  1 0 0  1 2 3 4  0 1
0 1 0  0 0 -1  9 9 9 9  1 1
3 0 1 2
3 0 2 3  0.5 1 0
)");
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(describe_all(read.mesh),
            (Strings{"vertex normal float32 3 normalize", "vertex color uint8 4 interpolate",
                     "vertex uv float32 2 interpolate", "face color float32 3 interpolate"}));
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "normal"),
            (Doubles{0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, -1}));
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "color"),
            (Doubles{255, 0, 7, 200, 0, 0, 0, 100, 1, 2, 3, 4, 9, 9, 9, 9}));
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "uv"), (Doubles{.5, .25, 1, 0, 0, 1, 1, 1}));
  EXPECT_EQ(values_of(read.mesh, ItemKind::kFace, "color"), (Doubles{0, 0, 0, .5, 1, 0}));
  EXPECT_EQ(read.notes, Strings());
}

TEST(OffAttributes, TellIntegersFromFloats) {
  const auto types = [](const std::string& a, const std::string& b) {
    const test::MeshFile read = read_mesh("COFF\n3 1 0\n0 0 0 " + a + "\n1 0 0 " + b +
                                          "\n0 1 0 0 0 0\n3 0 1 2 " + a + "\n");
    return read.error.empty() ? describe_all(read.mesh) : Strings{read.error};
  };
  const Strings bytes = {"vertex color uint8 3 interpolate", "face color uint8 3 interpolate"};
  EXPECT_EQ(types("255 0 0", "0 1 2"), bytes);
  EXPECT_EQ(types("0 0 0", "0 0 0"), bytes);
  EXPECT_EQ(types("1 1 1", "0 1 0")[0], "vertex color float32 3 interpolate");
  EXPECT_EQ(types("1 1 1", "0 .5 0")[0], "vertex color float32 3 interpolate");
  EXPECT_EQ(types("300 1 1", "0 5 0")[0], "vertex color float32 3 interpolate");
  EXPECT_EQ(types("1 2 3 4", "5 6 7 8"),
            (Strings{"vertex color uint8 4 interpolate", "face color uint8 4 interpolate"}));
}

TEST(OffAttributes, TakeIntegersBesideFloatsForBytesByRow) {
  const test::MeshFile read = read_mesh(
      "COFF\n4 2 0\n0 0 0 255 0 51\n1 0 0 1 0 1\n0 1 0 .5 .5 .5\n1 1 0 255 255 255 51\n"
      "3 0 1 2 255 0 0\n3 2 1 3 0.5 0.5 0.5\n");
  ASSERT_EQ(read.error, "");
  const double fifth = double(0.2F);
  EXPECT_EQ(describe_all(read.mesh),
            (Strings{"vertex color float32 4 interpolate", "face color float32 3 interpolate"}));
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "color"),
            (Doubles{1, 0, fifth, 1, 1, 0, 1, 1, .5, .5, .5, 1, 1, 1, 1, fifth}));
  EXPECT_EQ(values_of(read.mesh, ItemKind::kFace, "color"), (Doubles{1, 0, 0, .5, .5, .5}));
}

// Beyond 255 they are no bytes, and floats in a binary file are never.
TEST(OffAttributes, LeaveOtherColoursAsTheyAre) {
  const test::MeshFile read =
      read_mesh("COFF\n3 1 0\n0 0 0 300 0 51\n1 0 0 2.0 0 1\n0 1 0 .5 .5 .5\n3 0 1 2\n");
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "color"),
            (Doubles{300, 0, 51, 2, 0, 1, .5, .5, .5}));
  Mesh mesh = sample_mesh();
  add(mesh, ItemKind::kVertex, "color", Scalar::kFloat32, 4, OnSplit::kInterpolate)
      .set(0, 0, 200, nullptr);
  expect_round_trip(mesh, Format::kOff, Encoding::kBinary);
}

TEST(OffAttributes, HaveAnAlphaOfOneWhereTheLineHasNone) {
  const test::MeshFile read = read_mesh(
      "COFF\n4 2 0\n0 0 0 .5 .5 .5 -1.0\n1 0 0 .25 .25 .25\n0 1 0 0 0 0 .75\n1 1 0 0 0 0\n"
      "3 0 1 2\n3 0 2 3 .5 .5 .5 -1.\n");
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "color"),
            (Doubles{.5, .5, .5, -1, .25, .25, .25, 1, 0, 0, 0, .75, 0, 0, 0, 1}));
  EXPECT_EQ(values_of(read.mesh, ItemKind::kFace, "color"), (Doubles{0, 0, 0, 0, .5, .5, .5, -1}));
}

TEST(OffAttributes, SaysWhichLinesAreOthers) {
  const test::MeshFile read =
      read_mesh("NOFF\n3 1 0\n0 0 0 0 0 1 9\n1 0 0 0\n0 1 0 0 0 1\n3 0 1 2 7\n");
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(
      read.notes,
      (Strings{"of 1 vertex: fewer numbers than the header word promises, those missing are 0",
               "of 1 vertex: ignored what is more than the header word promises",
               "of 1 face: ignored a colour that is no red, green and blue"}));
}

TEST(OffAttributes, ComeBackToTheLastBit) {
  for (const bool bytes : {false, true}) {
    for (const Encoding encoding : {Encoding::kText, Encoding::kBinary}) {
      if (bytes && encoding != Encoding::kText) continue;
      std::mt19937 random(11);
      Mesh mesh = sample_mesh();
      using enum Scalar;
      const Scalar type = bytes ? kUint8 : kFloat32;
      add(mesh, ItemKind::kVertex, "normal", kFloat32, 3, OnSplit::kNormalize);
      add(mesh, ItemKind::kVertex, "color", type, 4, OnSplit::kInterpolate);
      add(mesh, ItemKind::kVertex, "uv", kFloat32, 2, OnSplit::kInterpolate);
      add(mesh, ItemKind::kFace, "color", type, bytes ? 3 : 4, OnSplit::kInterpolate);
      test::randomize(mesh, random);
      expect_round_trip(mesh, Format::kOff, encoding);
    }
  }
}

TEST(OffAttributes, ComeBackAsFloatsThatAreWholeNumbers) {
  Mesh mesh = sample_mesh();
  Attribute& color =
      add(mesh, ItemKind::kVertex, "color", Scalar::kFloat32, 4, OnSplit::kInterpolate);
  for (float& value : color.values<float>())
    value = float(&value - color.values<float>().data()) * 10;
  expect_round_trip(mesh, Format::kOff, Encoding::kText);
}

TEST(OffAttributes, SaysWhatItCannotHold) {
  Mesh mesh = sample_mesh();
  add(mesh, ItemKind::kVertex, "color", Scalar::kUint8, 3, OnSplit::kInterpolate)
      .set(0, 0, 1, nullptr);
  add(mesh, ItemKind::kHalfedge, "uv", Scalar::kFloat32, 2, OnSplit::kInterpolate);
  Strings notes;
  (void)write(mesh, Format::kOff, {.notes = &notes});
  EXPECT_EQ(notes, (Strings{"wrote the vertex attribute \"color\" with an alpha of 1",
                            "left out the halfedge attribute \"uv\": OFF has no place for it"}));
  notes.clear();
  (void)write(mesh, Format::kOff, {.encoding = Encoding::kBinary, .notes = &notes});
  EXPECT_EQ(notes, (Strings{"wrote the vertex attribute \"color\" as numbers from 0 to 1",
                            "wrote the vertex attribute \"color\" with an alpha of 1",
                            "left out the halfedge attribute \"uv\": OFF has no place for it"}));
}

// With three, Geomview takes the next number of the file for the fourth.
TEST(OffAttributes, ColoursOfVerticesHaveFourNumbersInText) {
  const auto lines = [](Scalar type, double red) {
    Mesh mesh = sample_mesh();
    add(mesh, ItemKind::kVertex, "color", type, 3, OnSplit::kInterpolate).set(0, 0, red, nullptr);
    add(mesh, ItemKind::kFace, "color", type, 3, OnSplit::kInterpolate).set(0, 0, 2, nullptr);
    const auto bytes = write(mesh, Format::kOff);
    const test::MeshFile read = read_mesh(bytes.value().span());
    EXPECT_EQ(read.notes, Strings());
    EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "color")[0], red);
    EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "color")[3],
              type == Scalar::kUint8 ? 255 : 1);
    std::istringstream text(std::string(bytes.value().begin(), bytes.value().end()));
    Strings lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  };
  const Strings bytes = lines(Scalar::kUint8, 1);
  EXPECT_EQ(bytes[2].substr(bytes[2].size() - 10), " 1 0 0 255");
  EXPECT_EQ(bytes[3].substr(bytes[3].size() - 10), " 0 0 0 255");
  EXPECT_EQ(bytes[9], "4 0 1 2 3 2 0 0");
  const Strings floats = lines(Scalar::kFloat32, .5);
  EXPECT_EQ(floats[2].substr(floats[2].size() - 16), " 0.5 0.0 0.0 1.0");
  EXPECT_EQ(floats[9], "4 0 1 2 3 2.0 0.0 0.0");
}

// Integers of which none is above 1 are taken for numbers from 0 to 1, and so would bytes be.
TEST(OffAttributes, WritesBytesUpToOneAsTheNumbersTheyStandFor) {
  Mesh mesh = sample_mesh();
  Attribute& color = add(mesh, ItemKind::kFace, "color", Scalar::kUint8, 3, OnSplit::kInterpolate);
  color.set(1, 0, 1, nullptr);
  color.set(3, 2, 200, nullptr);
  expect_round_trip(mesh, Format::kOff, Encoding::kText);

  ASSERT_TRUE(
      operations::delete_face(mesh, Face(3)));  // what is left of it in its slot isn't written
  Strings notes;
  const auto bytes = write(mesh, Format::kOff, {.notes = &notes});
  EXPECT_EQ(notes, Strings{"wrote the face attribute \"color\" as numbers from 0 to 1"});
  const test::MeshFile read = read_mesh(bytes.value().span());
  EXPECT_EQ(describe_all(read.mesh), Strings{"face color float32 3 interpolate"});
  EXPECT_EQ(values_of(read.mesh, ItemKind::kFace, "color"),
            (Doubles{0, 0, 0, double(1 / 255.0F), 0, 0, 0, 0, 0}));
  expect_round_trip(read.mesh, Format::kOff, Encoding::kText);
}

TEST(OffAttributes, MayBeOnOneLine) {
  for (const char* text : {
           "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2",
           "OFF\n3 2 0\n0 0 0 1 0 0 0 1 0 3 0 1 2 3 0 2 1\n",
           "OFF 3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 3 0 2 1\n",
           "COFF 3 1 0 0 0 0 1 2 3 4 1 0 0 5 6 7 8 0 1 0 9 10 11 12 3 0 1 2",
       }) {
    const Result<ParsedFile> file = parse(test::bytes_of(text));
    ASSERT_TRUE(file) << text << ": " << file.error().message;
    EXPECT_EQ(test::flatten(file).positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(test::flatten(file).faces[0], (std::vector<Index>{0, 1, 2}));
    EXPECT_EQ(file.value().notes, Strings());
  }
}

TEST(StlAttributes, ComeBackInTheBytesBehindATriangle) {
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const std::vector<Index> corners = {0, 1, 2, 2, 1, 3};
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, {positions, {}, corners}, report));
  EXPECT_EQ(describe_all(read_mesh(write(mesh, Format::kStl).value().span()).mesh), Strings());
  Attribute& column = add(mesh, ItemKind::kFace, "attribute", Scalar::kUint16, 1, OnSplit::kCopy);
  column.set(1, 0, 0xFFF1, nullptr);
  expect_round_trip(mesh, Format::kStl, Encoding::kBinary);
  Strings notes;
  (void)write(mesh, Format::kStl, {.encoding = Encoding::kText, .notes = &notes});
  EXPECT_EQ(notes,
            Strings{"left out the face attribute \"attribute\": text STL has no place for it"});
  const auto bytes = write(mesh, Format::kStl);
  const Result<ParsedFile> bare = parse(bytes.value().span(), std::nullopt, {.attributes = false});
  EXPECT_TRUE(bare.value().attributes.empty());
}

}  // namespace
}  // namespace halfedge
