// Attributes of OBJ files: what is read, where it goes, and that it is written back.

#include <gtest/gtest.h>
#include <halfedge/mend/mend.h>
#include <halfedge/operations/deletion.h>

#include <cstdint>
#include <cstring>
#include <random>
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

const std::string kObjSquare = R"(mtllib a.mtl b c.mtl
v 0 0 0 1 0.5 0
v 1 0 0 1
v 1 1 0 .25 .5 .75
o thing
vt 0 0
vt 1 0 7
f 1/1/1 2/2/1 3/-1/-1
vn 0 0 1
v 0 1 0
v 0 2 0
v -1 0 0
vt 0.5
usemtl  two words  # comment
g left
f 1/3 3//1 4/9/-9
g
f 4 3 5
g left
f 1/1 4/2 6/3
)";

TEST(ObjAttributes, AreReadByCornerAndByName) {
  const test::MeshFile read = read_mesh(kObjSquare);
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(describe_all(read.mesh),
            (Strings{"vertex color float32 3 interpolate", "halfedge uv float32 2 interpolate",
                     "halfedge normal float32 3 normalize", "face group int32 1 copy",
                     "face object int32 1 copy", "face material int32 1 copy"}));
  const Mesh& mesh = read.mesh;
  EXPECT_EQ(values_of(mesh, ItemKind::kVertex, "color"),
            (Doubles{1, 0.5, 0, 0, 0, 0, .25, .5, .75, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(values_of(mesh, ItemKind::kHalfedge, "uv"),
            (Doubles{0, 0, 1, 0, 1, 0, 0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0.5, 0}));
  Doubles normals(36, 0.0);
  normals[2] = normals[5] = normals[14] = 1;
  EXPECT_EQ(values_of(mesh, ItemKind::kHalfedge, "normal"), normals);
  EXPECT_EQ(values_of(mesh, ItemKind::kFace, "group"), (Doubles{0, 1, 0, 1}));
  EXPECT_EQ(values_of(mesh, ItemKind::kFace, "object"), (Doubles{1, 1, 1, 1}));
  EXPECT_EQ(values_of(mesh, ItemKind::kFace, "material"), (Doubles{0, 1, 1, 1}));
  EXPECT_EQ(read.notes, (Strings{"3 corners have texture coordinates or normals that the file "
                                 "doesn't have: what is missing is 0",
                                 "ignored 1 third texture coordinate that is not 0"}));
  const Result<ParsedFile> file = parse(test::bytes_of(kObjSquare));
  ASSERT_EQ(file.value().names.size(), 4U);
  EXPECT_EQ(file.value().names[0].names, (Strings{"", "left"}));
  EXPECT_EQ(file.value().names[2].attribute, "material");
  EXPECT_EQ(file.value().names[2].names, (Strings{"", "two words"}));
  EXPECT_EQ(file.value().names[3].attribute, "library");
  EXPECT_EQ(file.value().names[3].names, (Strings{"a.mtl b c.mtl"}));
}

// Four triangles around a square hole, of which each has a seam to the next.
TEST(ObjAttributes, SaysThatColoursInCommentsOfZBrushAreIgnored) {
  const auto bytes = test::bytes_of(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\n#MRGB ffff0000ff00ff00\n#MRGB ff0000ff\n#MRGBA\nf 1 2 3\n");
  EXPECT_EQ(read_obj(bytes).value().notes, Strings{"ignored 2 colour (#MRGB) statements"});
  EXPECT_EQ(read_obj(bytes, {.attributes = false}).value().notes, Strings());
}

TEST(ObjAttributes, OfCornersReachAcrossABoundary) {
  test::MeshFile read = read_mesh(R"(
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0.5 -1 0
v 2 0.5 0
v 0.5 2 0
v -1 0.5 0
vt 0.1 0
vt 0.2 0
vt 0.3 0
vt 0.4 0
vt 0.5 0
vt 0.6 0
vt 0.7 0
vt 0.8 0
vt 0.9 0
f 2/1 1/2 5/9
f 3/3 2/4 6/9
f 4/5 3/6 7/9
f 1/7 4/8 8/9
)");
  ASSERT_EQ(read.error, "");
  Mesh& mesh = read.mesh;
  const Attribute& uv = *mesh.find_attribute(ItemKind::kHalfedge, "uv");
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_boundary(h)) continue;
    EXPECT_EQ(uv.get(h.index(), 0), uv.get(Mesh::opposite(mesh.next(h)).index(), 0));
    EXPECT_GT(uv.get(h.index(), 0), 0);
  }
  const Index before = mesh.face_count();
  const Result<mend::Report> report = mend::fill_holes(mesh, {.max_edges = 4, .max_angle = 180});
  ASSERT_TRUE(report);
  ASSERT_EQ(mesh.face_count(), before + 2);
  for (const Index f : report.value().faces) {
    for (const Halfedge h : mesh.face_halfedges_ccw(Face(f))) {
      EXPECT_GT(uv.get(h.index(), 0), 0);
      EXPECT_LT(uv.get(h.index(), 0), 0.9F);
    }
  }
}

TEST(ObjAttributes, MayBeLeftOut) {
  const Result<ParsedFile> file =
      parse(test::bytes_of(kObjSquare), std::nullopt, {.attributes = false});
  ASSERT_TRUE(file);
  EXPECT_TRUE(file.value().attributes.empty());
  EXPECT_TRUE(file.value().names.empty());
  EXPECT_TRUE(file.value().notes.empty());
}

/// A mesh with all that OBJ has a place for, and few different values by corner.
Mesh sample_for_obj(Index color_components) {
  std::mt19937 random(3);
  Mesh mesh = sample_mesh();
  using enum Scalar;
  test::randomize(
      add(mesh, ItemKind::kVertex, "color", kFloat32, color_components, OnSplit::kInterpolate),
      random);
  for (const Index width : {Index{2}, Index{3}}) {
    Attribute& column = add(mesh, ItemKind::kHalfedge, width == 2 ? "uv" : "normal", kFloat32,
                            width, width == 2 ? OnSplit::kInterpolate : OnSplit::kNormalize);
    for (float& value : column.values<float>()) value = random() % 2 == 0 ? -0.0F : 0.1F;
  }
  for (const char* name : {"group", "object", "material", "smoothing"}) {
    Attribute& column = add(mesh, ItemKind::kFace, name, kInt32, 1, OnSplit::kCopy);
    for (std::int32_t& value : column.values<std::int32_t>())
      value = std::int32_t(random() % 5) - 2;
  }
  return mesh;
}

TEST(ObjAttributes, ComeBackToTheLastBit) {
  expect_round_trip(sample_for_obj(3), Format::kObj, Encoding::kText);
  expect_round_trip(sample_for_obj(4), Format::kObj, Encoding::kText,
                    {"wrote the vertex attribute \"color\" with an alpha, for which some readers "
                     "refuse the file"});
}

TEST(ObjAttributes, NamesOfLibrariesThatAreChangedAreNoted) {
  const std::vector<SoupNames> names = {{"library", {"a\tb.mtl", "c #d.mtl", "e.mtl ", "f.mtl"}}};
  Strings notes;
  const auto bytes = write(sample_mesh(), Format::kObj, {.names = names, .notes = &notes});
  const std::string text(bytes.value().begin(), bytes.value().end());
  EXPECT_TRUE(text.starts_with("mtllib a_b.mtl\nmtllib c _d.mtl\nmtllib e.mtl\nmtllib f.mtl\n"));
  EXPECT_EQ(notes,
            Strings{"wrote 3 of 4 names of libraries changed: control characters and a # that "
                    "starts a word become _, blanks at the ends are left out"});
}

TEST(ObjAttributes, ShareValuesAndHaveNames) {
  Mesh mesh = sample_mesh();
  Attribute& uv = add(mesh, ItemKind::kHalfedge, "uv", Scalar::kFloat32, 2, OnSplit::kInterpolate);
  uv.set(mesh.face_halfedge(Face(1)).index(), 1, 0.5, nullptr);
  add(mesh, ItemKind::kVertex, "normal", Scalar::kFloat32, 3, OnSplit::kNormalize);
  Attribute& material = add(mesh, ItemKind::kFace, "material", Scalar::kUint8, 1, OnSplit::kCopy);
  material.set(1, 0, 1, nullptr);
  const std::vector<SoupNames> names = {{"library", {"x.mtl"}}, {"material", {"", "oak#\n2"}}};
  Strings notes;
  const auto bytes = write(mesh, Format::kObj, {.names = names, .notes = &notes});
  std::string text(bytes.value().begin(), bytes.value().end());
  EXPECT_EQ(text.substr(0, 15), "mtllib x.mtl\nv ");
  EXPECT_EQ(
      text.substr(text.find("vt")),
      "vt 0 0\nvt 0 0.5\n" +
          [] {
            std::string lines;
            for (int v = 0; v < 7; ++v) lines += "vn 0 0 0\n";
            return lines;
          }() +
          "f 1/1/1 2/1/2 3/1/3 4/1/4\nusemtl oak#_2\nf 4/2/4 3/1/3 5/1/5\nusemtl (null)\n"
          "f 2/1/2 6/1/6 3/1/3\nf 6/1/6 7/1/7 3/1/3\n");
  EXPECT_EQ(notes,
            (Strings{"wrote the vertex attribute \"normal\" for the corners of faces, to which "
                     "readers give it",
                     "wrote the face attribute \"material\" as numbers that readers take for int32",
                     "wrote the face attribute \"material\" with 1 of its 1 names changed: "
                     "control characters and a # that starts a word become _, blanks at the ends "
                     "are left out"}));
  notes.clear();
  ASSERT_TRUE(write(mesh, Format::kPly, {.names = names, .notes = &notes}));
  EXPECT_EQ(notes,
            Strings{"wrote the face attribute \"material\" as numbers, without their names"});
}

TEST(ObjAttributes, FacesBehindThoseOfAMaterialMayHaveNone) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nusemtl oak\nf 1 2 3\nusemtl (null)\nf 3 2 4\n"
      "usemtl\nf 4 2 5\n";
  const test::MeshFile read = read_mesh(text);
  EXPECT_EQ(values_of(read.mesh, ItemKind::kFace, "material"), (Doubles{1, 0, 0}));
  const Result<ParsedFile> file = parse(test::bytes_of(text), {}, {.attributes = true});
  ASSERT_EQ(file.value().names.size(), 1U);
  EXPECT_EQ(file.value().names[0].names, (Strings{"", "oak"}));
  const std::vector<SoupNames> others = {{"material", {"", "(null)"}}};
  Strings notes;
  (void)write(read.mesh, Format::kObj, {.names = others, .notes = &notes});
  EXPECT_EQ(notes, Strings{"wrote the face attribute \"material\" with 1 of its 1 names left out, "
                           "being (null), which stands for none"});
}

// Vertices with seven numbers stop some readers, so they have them only where it says something.
TEST(ObjAttributes, WritesAnAlphaThatIsNotOneEverywhere) {
  for (const Scalar type : {Scalar::kFloat32, Scalar::kUint8}) {
    Mesh mesh = sample_mesh();
    Attribute& color = add(mesh, ItemKind::kVertex, "color", type, 4, OnSplit::kInterpolate);
    for (Index v = 0; v < 7; ++v) color.set(v, 3, type == Scalar::kUint8 ? 255 : 1, nullptr);
    const auto components_and_note = [&mesh] {
      Strings notes;
      const auto bytes = write(mesh, Format::kObj, {.notes = &notes});
      const test::MeshFile read = read_mesh(bytes.value().span());
      const Attribute* const found = read.mesh.attributes().find(ItemKind::kVertex, "color");
      return std::pair(found->components(), notes.back());
    };
    EXPECT_EQ(components_and_note(),
              std::pair(Index{3}, std::string("wrote the vertex attribute \"color\" without its "
                                              "alpha, which is 1 everywhere")));
    color.set(6, 3, 0, nullptr);
    EXPECT_EQ(components_and_note(),
              std::pair(Index{4}, std::string("wrote the vertex attribute \"color\" with an alpha, "
                                              "for which some readers refuse the file")));
  }
}

TEST(ObjAttributes, SaysWhichNamesDoNotComeBack) {
  using Names = std::vector<std::string>;
  const auto notes_of = [](const Names& names, const std::vector<int>& numbers) {
    Mesh mesh = sample_mesh();
    Attribute& group = add(mesh, ItemKind::kFace, "group", Scalar::kInt32, 1, OnSplit::kCopy);
    for (Index f = 0; f < numbers.size(); ++f) group.set(f, 0, numbers[f], nullptr);
    const std::vector<SoupNames> tables = {{"group", names}};
    Strings notes;
    EXPECT_TRUE(write(mesh, Format::kObj, {.names = tables, .notes = &notes}));
    return notes;
  };
  const std::string wrote = "wrote the face attribute \"group\" with ";
  const std::string changed =
      " names changed: control characters and a # that starts a word become _, blanks at the ends "
      "are left out";
  EXPECT_EQ(notes_of({"", "a", "b"}, {1, 2, 0, 1}), Strings());
  EXPECT_EQ(notes_of({"", "a", "3"}, {1, 2, 0, 1}), Strings()) << "not all of them are numbers";
  EXPECT_EQ(notes_of({"", "a", "#"}, {1, 1, 1, 1}), Strings()) << "is not used";
  EXPECT_EQ(notes_of({"", "a #b", "a_b", " a\tb"}, {1, 2, 3, 0}),
            Strings{wrote + "2 of its 3" + changed});
  EXPECT_EQ(notes_of({"", "#a", "a_b"}, {1, 2, 1, 1}), Strings{wrote + "1 of its 2" + changed});
  EXPECT_EQ(notes_of({"", "a#b", "a# b#"}, {1, 2, 1, 1}), Strings());
  EXPECT_EQ(notes_of({"", "", "b"}, {1, 2, 1, 2}),
            Strings{wrote + "1 of its 2 names left out, being empty"});
  EXPECT_EQ(notes_of({"", "1", "0"}, {1, 2, 1, 2}),
            Strings{wrote + "2 of its 2 names that are numbers, for which readers take them"});
  EXPECT_EQ(notes_of({"", "a"}, {1, 7, 1, 0}),
            Strings{wrote + "names that are the numbers of faces which have none"});
}

TEST(ObjAttributes, ANameEndsAtAHashThatStartsAWord) {
  const Result<ParsedFile> file = parse(
      test::bytes_of("mtllib a#1.mtl b#.mtl # of both\nv 0 0 0\nv 1 0 0\nv 1 1 0\no thing#1#\n"
                     "usemtl steel#2\nf 1 2 3\nusemtl steel #2\nf 1 2 3\nusemtl #2\nf 1 2 3\n"
                     "usemtl a# b\t#\nf 1 2 3\nusemtl#2\nf 1 2 3#4\nusemtl steel#2#\nf 1 2 3\n"));
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file.value().names.size(), 3U);
  EXPECT_EQ(file.value().names[0].names, (Strings{"", "thing#1#"}));
  EXPECT_EQ(file.value().names[1].names, (Strings{"", "steel#2", "steel", "a# b", "steel#2#"}));
  EXPECT_EQ(file.value().names[2].names, (Strings{"a#1.mtl b#.mtl"}));
  const SoupAttribute& material = file.value().attributes.back();
  ASSERT_EQ(material.name, "material");
  std::vector<std::int32_t> numbers(6);
  ASSERT_EQ(material.values.size(), sizeof(std::int32_t) * numbers.size());
  std::memcpy(numbers.data(), material.values.begin(), material.values.size());
  EXPECT_EQ(numbers, (std::vector<std::int32_t>{1, 2, 0, 3, 0, 4}));
}

// Whatever is written as a name is read as that: the second time nothing is changed any more.
TEST(ObjAttributes, NamesWithHashesAndBlanksComeBack) {
  const Strings hard = {"", "a#b", "a #b", "#a", "##", "a# #", "a\t#b", " # a", "a  b", "#", "\v#"};
  const Strings spelt = {"", "a#b", "a _b", "_a", "_#", "a# _", "a_#b", "_ a", "a  b", "_", "_#"};
  for (std::size_t i = 1; i < hard.size(); ++i) {
    SCOPED_TRACE(hard[i]);
    Mesh mesh = sample_mesh();
    add(mesh, ItemKind::kFace, "group", Scalar::kInt32, 1, OnSplit::kCopy).set(0, 0, 1, nullptr);
    std::string name = hard[i];
    for (int times = 0; times < 2; ++times) {
      const std::vector<SoupNames> tables = {{"group", {"", name}}};
      const auto bytes = write(mesh, Format::kObj, {.names = tables});
      const Result<ParsedFile> file = parse(bytes.value());
      ASSERT_TRUE(file);
      ASSERT_EQ(file.value().names.size(), 1U);
      name = file.value().names[0].names[1];
      EXPECT_EQ(name, spelt[i]);
    }
  }
}

TEST(ObjAttributes, LeavesOutLabelsThatAreNoInt32) {
  Mesh mesh = sample_mesh();
  Attribute& group = add(mesh, ItemKind::kFace, "group", Scalar::kUint32, 1, OnSplit::kCopy);
  Attribute& object = add(mesh, ItemKind::kFace, "object", Scalar::kUint32, 1, OnSplit::kCopy);
  group.set(2, 0, 4294967295.0, nullptr);
  object.set(2, 0, 2147483647, nullptr);
  Strings notes;
  const auto bytes = write(mesh, Format::kObj, {.notes = &notes});
  EXPECT_EQ(notes,
            (Strings{"wrote the face attribute \"object\" as numbers that readers take for int32",
                     "left out the face attribute \"group\": readers of OBJ take numbers up "
                     "to 2147483647"}));
  const test::MeshFile read = read_mesh(bytes.value().span());
  EXPECT_EQ(describe_all(read.mesh), Strings{"face object int32 1 copy"});
  EXPECT_EQ(values_of(read.mesh, ItemKind::kFace, "object"), (Doubles{0, 0, 2147483647, 0}));

  ASSERT_TRUE(
      operations::delete_face(mesh, Face(2)));  // what is left of it in its slot isn't written
  for (Attribute* column : {&group, &object}) column->set(0, 0, 7, nullptr);
  notes.clear();
  (void)write(mesh, Format::kObj, {.notes = &notes});
  EXPECT_EQ(notes,
            (Strings{"wrote the face attribute \"object\" as numbers that readers take for int32",
                     "wrote the face attribute \"group\" as numbers that readers take for int32"}));
}

TEST(ObjAttributes, SaysWhatItCannotHold) {
  Mesh mesh = sample_mesh();
  add(mesh, ItemKind::kVertex, "color", Scalar::kUint8, 3, OnSplit::kInterpolate)
      .set(2, 1, 51, nullptr);
  add(mesh, ItemKind::kVertex, "uv", Scalar::kFloat32, 3, OnSplit::kInterpolate);
  add(mesh, ItemKind::kHalfedge, "normal", Scalar::kFloat64, 3, OnSplit::kNormalize);
  add(mesh, ItemKind::kVertex, "normal", Scalar::kFloat32, 3, OnSplit::kNormalize);
  add(mesh, ItemKind::kFace, "color", Scalar::kFloat32, 3, OnSplit::kInterpolate);
  add(mesh, ItemKind::kEdge, "crease", Scalar::kFloat32, 1, OnSplit::kCopy);
  Strings notes;
  const auto bytes = write(mesh, Format::kObj, {.notes = &notes});
  EXPECT_EQ(notes,
            (Strings{"wrote the vertex attribute \"color\" as numbers from 0 to 1",
                     "wrote the halfedge attribute \"normal\" as doubles, which readers take for "
                     "floats",
                     "left out the vertex attribute \"uv\": OBJ has no place for it",
                     "left out the vertex attribute \"normal\": OBJ has no place for it",
                     "left out the edge attribute \"crease\": OBJ has no place for it",
                     "left out the face attribute \"color\": OBJ has no place for it"}));
  const test::MeshFile read = read_mesh(bytes.value().span());
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "color")[7], double(0.2F));
}

TEST(ObjAttributes, SaysWhichLabelsNoFaceHas) {
  Mesh mesh = sample_mesh();
  add(mesh, ItemKind::kFace, "material", Scalar::kInt32, 1, OnSplit::kCopy);
  add(mesh, ItemKind::kFace, "smoothing", Scalar::kInt32, 1, OnSplit::kCopy);
  Strings notes;
  const auto bytes = write(mesh, Format::kObj, {.notes = &notes});
  EXPECT_EQ(notes, (Strings{"left out the face attribute \"material\": it is 0 for all faces, for "
                            "which OBJ has no statement",
                            "left out the face attribute \"smoothing\": it is 0 for all faces, for "
                            "which OBJ has no statement"}));
  EXPECT_EQ(describe_all(read_mesh(bytes.value().span()).mesh), Strings());
  notes.clear();
  (void)write(Mesh(), Format::kObj, {.notes = &notes});
  EXPECT_EQ(notes, Strings());
}

TEST(ObjAttributes, HaveSmoothingGroups) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 1\n";
  const auto smoothing_of = [&](const std::string& statements) {
    const test::MeshFile read = read_mesh(triangle + statements);
    EXPECT_EQ(read.error, "");
    return values_of(read.mesh, ItemKind::kFace, "smoothing");
  };
  EXPECT_EQ(smoothing_of("f 1 2 3\ns 3\nf 2 4 3\ns off\nf 2 1 5\n"), (Doubles{0, 3, 0}));
  EXPECT_EQ(smoothing_of("s -7\nf 1 2 3\ns 0\nf 2 4 3\n"), (Doubles{-7, 0}));
  EXPECT_EQ(smoothing_of("s off\nf 1 2 3\ns 0\nf 2 4 3\n"), Doubles()) << "nothing is said";
  const test::MeshFile strange =
      read_mesh(triangle + "s on\nf 1 2 3\ns 1\nf 2 4 3\ns 9999999999\nf 2 1 5\ns 7x\nf 1 4 5\n");
  EXPECT_EQ(values_of(strange.mesh, ItemKind::kFace, "smoothing"), (Doubles{0, 1, 0, 0}));
  EXPECT_EQ(
      strange.notes,
      Strings{
          "ignored 3 smoothing groups (s) that are neither integers of 32 bits, signed, nor off"});
}

TEST(ObjAttributes, KeepAnAlphaThatComesLate) {
  const test::MeshFile read = read_mesh(
      "v 0 0 0\nv 1 0 0 .1 .2 .3\nv 0 1 0 .4 .5 .6 .7\nv 1 1 0 .8 .9 1\nf 1 2 3\nf 2 4 3\n");
  EXPECT_EQ(describe_all(read.mesh), Strings{"vertex color float32 4 interpolate"});
  const Doubles colors = values_of(read.mesh, ItemKind::kVertex, "color");
  const std::vector<float> expected = {0,   0,   0,   1,   .1F, .2F, .3F, 1,
                                       .4F, .5F, .6F, .7F, .8F, .9F, 1,   1};
  EXPECT_EQ(std::vector<float>(colors.begin(), colors.end()), expected);
}

TEST(ObjAttributes, TakesWholeNumbersAboveOneForBytes) {
  const auto read = [](const std::string& colors) {
    std::string text = "v 0 0 0 " + colors + "v 1 0 0 0 1 255\nv 0 1 0 255 0 1\nf 1 2 3\n";
    return read_mesh(text);
  };
  const test::MeshFile whole = read("188 94 0\n");
  EXPECT_EQ(describe_all(whole.mesh), Strings{"vertex color uint8 3 interpolate"});
  EXPECT_EQ(values_of(whole.mesh, ItemKind::kVertex, "color"),
            (Doubles{188, 94, 0, 0, 1, 255, 255, 0, 1}));
  EXPECT_EQ(whole.notes, Strings{"read the colours of vertices as numbers from 0 to 255"});
  EXPECT_EQ(values_of(read("188 94 0 7\n").mesh, ItemKind::kVertex, "color"),
            (Doubles{188, 94, 0, 7, 0, 1, 255, 255, 255, 0, 1, 255}))
      << "what has no alpha is opaque";
  for (const char* colors : {"188 94 0.5\n", "256 0 0\n", "-1 0 0\n"}) {
    const test::MeshFile other = read(colors);
    EXPECT_EQ(describe_all(other.mesh), Strings{"vertex color float32 3 interpolate"}) << colors;
    EXPECT_EQ(other.notes, Strings()) << colors;
  }
  const test::MeshFile floats = read_mesh("v 0 0 0 1 1 0\nv 1 0 0 0 0 1\nv 0 1 0 1 1 1\nf 1 2 3\n");
  EXPECT_EQ(describe_all(floats.mesh), Strings{"vertex color float32 3 interpolate"});
}

TEST(ObjAttributes, SayThatReadersTakeThemForBytes) {
  Mesh mesh;
  ASSERT_TRUE(mesh.add_vertex({0, 0, 0}).valid());
  Attribute& color =
      add(mesh, ItemKind::kVertex, "color", Scalar::kFloat32, 3, OnSplit::kInterpolate);
  const auto notes_with = [&](double value) {
    color.set(0, 1, value, nullptr);
    Strings notes;
    EXPECT_TRUE(write(mesh, Format::kObj, {.notes = &notes}));
    return notes;
  };
  for (const double value : {1.0, 1.5, -2.0, 256.0}) EXPECT_EQ(notes_with(value), Strings());
  EXPECT_EQ(notes_with(255),
            Strings{"wrote the vertex attribute \"color\" as numbers that readers take for uint8"});
}

TEST(ObjAttributes, SayThatThereAreNoCornersToReadThem) {
  Mesh mesh;
  ASSERT_TRUE(mesh.add_vertex({0, 0, 0}).valid());
  add(mesh, ItemKind::kVertex, "normal", Scalar::kFloat32, 3, OnSplit::kNormalize);
  Strings notes;
  ASSERT_TRUE(write(mesh, Format::kObj, {.notes = &notes}));
  EXPECT_EQ(notes, Strings{"wrote the vertex attribute \"normal\" for corners of faces, of which "
                           "there are none"});
}

TEST(ObjAttributes, SaysWhatIsIgnored) {
  const test::MeshFile read = read_mesh(
      "v 0 0 0 2\nv 1 0 0 1\nv 0 1 0\nvt 0 0 .5\nvt 0 1 0\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n"
      "f 1/1/1 2/1/1 3/1/1\n");
  EXPECT_EQ(read.notes, (Strings{"ignored 1 third texture coordinate that is not 0",
                                 "ignored 1 weight of a vertex",
                                 "ignored 1 texture coordinate (vt) to which no face refers",
                                 "ignored 2 normals (vn) to which no face refers"}));
}

TEST(ObjAttributes, SaysWhatIsNoNumber) {
  const auto notes_of = [](const std::string& statements) {
    const test::MeshFile read =
        read_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + statements + "f 1/1/1 2/1/1 3/1/1\n");
    EXPECT_EQ(read.error, "");
    return read.notes;
  };
  const auto of = [](const std::string& what) {
    return Strings{what + " not the numbers expected: what is missing is 0"};
  };
  const std::string good = "vt .5 .5\nvn 0 0 1\n";
  EXPECT_EQ(notes_of(good), Strings());
  EXPECT_EQ(notes_of("vt .5\nvn 0 0 1 # up\n"), Strings());
  EXPECT_EQ(notes_of("vt abc 0.5\nvn 0 0 x\n"),
            of("2 texture coordinates or normals (vt, vn) have"));
  for (const char* bad : {"vt\nvn 0 0 1\n", "vt .5 .5 0 0\nvn 0 0 1\n", "vt .5 .5x\nvn 0 0 1\n",
                          "vt .5 .5\nvn 0 1\n", "vt .5 .5\nvn 0 0 1 1\n"}) {
    EXPECT_EQ(notes_of(bad), of("1 texture coordinate or normal (vt, vn) has")) << bad;
  }
  EXPECT_EQ(notes_of(good + "v 1 2 3 junk\n"),
            Strings{"ignored 1 end of the line of a vertex that is neither weight nor colour"});
  EXPECT_EQ(notes_of(good + "v 1 2 3 .5 .5\nv 1 2 3 1 1 1 1 x\nv 1 2 3 1 1 1 # c\nv 1 2 3 1 \n"),
            Strings{"ignored 2 ends of lines of vertices that are neither weights nor colours"});
}

TEST(ObjAttributes, LimitWhatNamesTake) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 70000; ++i) text += "g a" + std::to_string(i) + "\n";
  text += "f 1 2 3\n";
  const Result<ParsedFile> file = parse(test::bytes_of(text));
  ASSERT_TRUE(file);
  EXPECT_EQ(file.value().names[0].names.size(), 65537U);
  EXPECT_EQ(file.value().notes, Strings{"the file has more than 65536 different names of a group: "
                                        "faces of further ones have none"});
}

}  // namespace
}  // namespace halfedge
