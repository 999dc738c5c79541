// Attributes of files: what is read, where it goes, and that it is written back.

#include <gtest/gtest.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/attribute_file.h"

namespace halfedge {
namespace {

using test::describe_all;
using test::read_mesh;
using test::values_of;
using Doubles = std::vector<double>;
using Strings = std::vector<std::string>;

/// 3---2   6
/// |   | \ |   a square, a triangle, and a pentagon over the three on the left
/// 0---1---5
Mesh sample() {
  const std::vector<float> positions = {0, 0,    0, 1, 0, 0, 1, 1, 0, 0, 1,
                                        0, 0.5F, 2, 0, 2, 0, 0, 2, 1, 0};
  const std::vector<Index> sizes = {4, 3, 3, 3};
  const std::vector<Index> corners = {0, 1, 2, 3, 3, 2, 4, 1, 5, 2, 5, 6, 2};
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, {positions, sizes, corners}, report));
  return mesh;
}

Attribute& add(Mesh& mesh, ItemKind kind, const char* name, Scalar type, Index components,
               OnSplit on_split) {
  return *mesh.add_attribute(kind, name,
                             {.type = type, .components = components, .on_split = on_split})
              .value();
}

/// Writes, reads, and compares the attributes.
void expect_round_trip(const Mesh& mesh, Format format, Encoding encoding) {
  SCOPED_TRACE(std::string(name_of(format)) + " " + std::to_string(int(encoding)));
  Strings notes;
  const auto bytes = write(mesh, format, {.encoding = encoding, .notes = &notes});
  ASSERT_TRUE(bytes) << bytes.error().message;
  EXPECT_EQ(notes, Strings());
  const test::MeshFile read = read_mesh(bytes.value().span());
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(read.notes, Strings());
  EXPECT_EQ(describe_all(read.mesh), describe_all(mesh));
  for (const ItemKind kind : {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kFace}) {
    for (const auto& column : mesh.attributes().of(kind)) {
      const char* const name = column->name().c_str();
      const Doubles before = values_of(mesh, kind, name);
      const Doubles after = values_of(read.mesh, kind, name);
      ASSERT_EQ(before.size(), after.size()) << name;
      EXPECT_EQ(std::memcmp(before.data(), after.data(), 8 * before.size()), 0) << name;
    }
  }
}

TEST(PlyAttributes, ComeBackBitForBit) {
  for (const Encoding encoding : {Encoding::kText, Encoding::kBinary, Encoding::kBinaryBigEndian}) {
    std::mt19937 random(7);
    Mesh mesh = sample();
    using enum Scalar;
    for (const ItemKind kind : {ItemKind::kVertex, ItemKind::kFace}) {
      add(mesh, kind, "normal", kFloat32, 3, OnSplit::kNormalize);
      add(mesh, kind, "color", kUint8, kind == ItemKind::kFace ? 3 : 4, OnSplit::kInterpolate);
      add(mesh, kind, "quality", kFloat64, 1, OnSplit::kInterpolate);
      add(mesh, kind, "weight", kFloat32, 5, OnSplit::kInterpolate);
      const Scalar integers[] = {kInt8, kUint8, kInt16, kUint16, kInt32, kUint32};
      for (const Scalar type : integers) {
        add(mesh, kind, name_of(type), type, type == kInt16 ? 2 : 1, OnSplit::kCopy);
      }
    }
    add(mesh, ItemKind::kVertex, "uv", kFloat64, 2, OnSplit::kInterpolate);
    add(mesh, ItemKind::kHalfedge, "uv", kFloat32, 2, OnSplit::kInterpolate);
    test::randomize(mesh, random);
    expect_round_trip(mesh, Format::kPly, encoding);
  }
}

TEST(PlyAttributes, KeepBitsThatAreNoNumbers) {
  Mesh mesh = sample();
  Attribute& quality =
      add(mesh, ItemKind::kVertex, "q", Scalar::kFloat32, 1, OnSplit::kInterpolate);
  const std::uint32_t payload = 0x7FA0'1234;  // a signalling NaN
  std::memcpy(&quality.values<float>()[2], &payload, 4);
  for (const Encoding encoding : {Encoding::kBinary, Encoding::kBinaryBigEndian}) {
    const auto bytes = write(mesh, Format::kPly, {.encoding = encoding});
    const test::MeshFile read = read_mesh(bytes.value().span());
    const Attribute* const again = read.mesh.attributes().find(ItemKind::kVertex, "q");
    ASSERT_NE(again, nullptr);
    EXPECT_TRUE(std::equal(again->bytes().begin(), again->bytes().end(), quality.bytes().begin()));
  }
}

TEST(PlyAttributes, SaysWhatItCannotHold) {
  Mesh mesh = sample();
  add(mesh, ItemKind::kVertex, "two words", Scalar::kFloat32, 1, OnSplit::kCopy);
  add(mesh, ItemKind::kVertex, "x", Scalar::kFloat32, 1, OnSplit::kCopy);
  add(mesh, ItemKind::kEdge, "crease", Scalar::kFloat32, 1, OnSplit::kCopy);
  add(mesh, ItemKind::kHalfedge, "normal", Scalar::kFloat32, 3, OnSplit::kNormalize);
  add(mesh, ItemKind::kFace, "kept", Scalar::kUint8, 1, OnSplit::kCopy);
  Strings notes;
  const auto bytes = write(mesh, Format::kPly, {.notes = &notes});
  EXPECT_EQ(notes,
            (Strings{"left out the vertex attribute \"two words\": a name in PLY is one word",
                     "left out the vertex attribute \"x\": there is another property \"x\"",
                     "left out the halfedge attribute \"normal\": of halfedges PLY has only uv, "
                     "two floats or doubles",
                     "left out the edge attribute \"crease\": PLY has none by edge"}));
  EXPECT_EQ(describe_all(read_mesh(bytes.value().span()).mesh), Strings{"face kept uint8 1 copy"});
  notes.clear();
  const auto bare = write(mesh, Format::kPly, {.attributes = false, .notes = &notes});
  EXPECT_EQ(describe_all(read_mesh(bare.value().span()).mesh), Strings());
  EXPECT_EQ(notes, Strings());
}

TEST(PlyAttributes, SaysWhatReadersTakeForSomethingElse) {
  Mesh mesh = sample();
  for (const char* name : {"nx", "ny", "nz", "s", "t", "f[0]", "texture_u", "red"}) {
    add(mesh, ItemKind::kVertex, name, Scalar::kFloat32, 1, OnSplit::kCopy);
  }
  add(mesh, ItemKind::kFace, "s", Scalar::kFloat32, 1, OnSplit::kCopy);
  add(mesh, ItemKind::kFace, "t", Scalar::kFloat32, 1, OnSplit::kCopy);
  Strings notes;
  const auto bytes = write(mesh, Format::kPly, {.notes = &notes});
  const auto taken_for = [](const char* name, const char* other) {
    return std::string("wrote the vertex attribute \"") + name + "\" as what readers take for \"" +
           other + "\"";
  };
  EXPECT_EQ(notes, (Strings{taken_for("nx", "normal"), taken_for("ny", "normal"),
                            taken_for("nz", "normal"), taken_for("s", "uv"), taken_for("t", "uv"),
                            taken_for("f[0]", "f")}));
  EXPECT_EQ(describe_all(read_mesh(bytes.value().span()).mesh),
            (Strings{"vertex normal float32 3 normalize", "vertex uv float32 2 interpolate",
                     "vertex f float32 1 interpolate", "vertex texture_u float32 1 interpolate",
                     "vertex red float32 1 interpolate", "face s float32 1 interpolate",
                     "face t float32 1 interpolate"}));
}

const std::string kPlyTriangle = R"(ply
format ascii 1.0
element vertex 3
property float x
property float nx
property float y
property uchar red
property float ny
property float z
property float nz
property uchar green
property uchar blue
property double quality
property short label
property list uchar int neighbours
element face 1
property list uchar float texcoord
property list uchar int vertex_indices
property int material
end_header
0 0 0 255 0 0 1 128 0 0.1 -7 2 1 2
1 0 0 0 0 0 1 255.0 1 1e300 300 0
0 1 1 0 0 0 0 300 -4 -0 99999 1 5
6 0 0 1 0 0.5 1 3 0 1 2 -5
)";

TEST(PlyAttributes, HaveTheUsualNames) {
  const test::MeshFile read = read_mesh(kPlyTriangle);
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(describe_all(read.mesh),
            (Strings{"vertex normal float32 3 normalize", "vertex color uint8 3 interpolate",
                     "vertex quality float64 1 interpolate", "vertex label int16 1 copy",
                     "halfedge uv float32 2 interpolate", "face material int32 1 copy"}));
  const Mesh& mesh = read.mesh;
  EXPECT_EQ(values_of(mesh, ItemKind::kVertex, "normal"), (Doubles{0, 0, 1, 0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(values_of(mesh, ItemKind::kVertex, "color"),
            (Doubles{255, 128, 0, 0, 255, 1, 0, 255, 0}));
  EXPECT_EQ(values_of(mesh, ItemKind::kVertex, "quality"), (Doubles{0.1, 1e300, 0}));
  EXPECT_EQ(values_of(mesh, ItemKind::kVertex, "label"), (Doubles{-7, 300, 32767}));
  EXPECT_EQ(values_of(mesh, ItemKind::kHalfedge, "uv"), (Doubles{0, 0, 1, 0, 0.5, 1}));
  EXPECT_EQ(values_of(mesh, ItemKind::kFace, "material"), Doubles{-5});
  // A corner lies where its halfedge ends.
  EXPECT_EQ(mesh.to_vertex(mesh.face_halfedge(Face(0))), Vertex(0));
  EXPECT_EQ(read.notes, Strings{"ignored the list \"neighbours\" of \"vertex\": expected 1 to 16 "
                                "numbers, as many in each row"});
}

// The same file in text and in both byte orders.
void expect_lists(const Mesh& mesh) {
  EXPECT_EQ(describe_all(mesh),
            (Strings{"vertex quality float32 1 interpolate", "vertex normal float64 3 normalize",
                     "vertex one uint8 1 copy", "face flags int16 4 copy"}));
  EXPECT_EQ(values_of(mesh, ItemKind::kVertex, "quality"), (Doubles{7, 8, 9}));
  EXPECT_EQ(values_of(mesh, ItemKind::kVertex, "normal"),
            (Doubles{0, 0, 1, 0, 1, 0, 0.1, 0, 1e-300}));
  EXPECT_EQ(values_of(mesh, ItemKind::kVertex, "one"), (Doubles{1, 2, 255}));
  EXPECT_EQ(values_of(mesh, ItemKind::kFace, "flags"), (Doubles{-1, 2, -3, 4}));
}

TEST(PlyAttributes, KeepListsOfOneLength) {
  const test::MeshFile read = read_mesh(R"(ply
format ascii 1.0
element vertex 3
property float x
property list uchar double normal
property float y
property float z
property list int uchar one
property float quality
element face 1
property list uchar short flags
property list uchar int vertex_indices
end_header
0 3 0 0 1 0 0 1 1 7
1 3 0 1 0 0 0 1 2 8
0 3 0.1 0 1e-300 1 0 1 255 9
4 -1 2 -3 4 3 0 1 2
)");
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(read.notes, Strings());
  expect_lists(read.mesh);
  for (const Encoding encoding : {Encoding::kText, Encoding::kBinary, Encoding::kBinaryBigEndian}) {
    expect_round_trip(read.mesh, Format::kPly, encoding);
  }
}

TEST(PlyAttributes, KeepListsOfBinaryFiles) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nproperty list uchar ushort pair\n"
      "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
  for (int v = 0; v < 3; ++v) {
    text += std::string(12, '\0');
    text += {'\2', char(v), '\1', '\0', char(v)};
  }
  text += {'\3', '\0', '\1', '\2'};
  const test::MeshFile read = read_mesh(text);
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "pair"), (Doubles{256, 0, 257, 256, 258, 512}));
}

TEST(PlyAttributes, SaysWhichListsItCannotKeep) {
  const auto read_lists = [](const std::string& rows) {
    return read_mesh(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty "
        "float z\nproperty list uchar float a\nproperty list uchar float b\nproperty float a\n"
        "element face 0\nproperty list uchar int vertex_indices\nend_header\n" +
            rows,
        true);
  };
  const auto uneven = [](const std::string& name) {
    return "ignored the list \"" + name +
           "\" of \"vertex\": expected 1 to 16 numbers, as many in each row";
  };
  const std::string taken = "ignored the property \"a\" of \"vertex\"";
  const std::string seventeen = "17 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1";
  const std::string sixteen = "16 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1";
  EXPECT_EQ(read_lists("0 0 0 0 1 5 0\n0 0 0 0 1 6 0\n").notes, Strings{taken});
  EXPECT_EQ(read_lists("0 0 0 0 0 0\n0 0 0 0 0 0\n").notes, (Strings{taken, uneven("b")}));
  EXPECT_EQ(read_lists("0 0 0 0 1 5 0\n0 0 0 0 2 6 7 0\n").notes, (Strings{taken, uneven("b")}));
  EXPECT_EQ(read_lists("0 0 0 0 0 0\n0 0 0 0 1 6 0\n").notes, (Strings{taken, uneven("b")}));
  const std::string long_rows = "0 0 0 0 " + seventeen + " 0\n0 0 0 0 " + seventeen + " 0\n";
  EXPECT_EQ(read_lists(long_rows).notes, (Strings{taken, uneven("b")}));
  const test::MeshFile longest =
      read_lists("0 0 0 0 " + sixteen + " 0\n0 0 0 0 " + sixteen + " 0\n");
  EXPECT_EQ(longest.notes, Strings{taken});
  EXPECT_EQ(values_of(longest.mesh, ItemKind::kVertex, "b"), Doubles(32, 1));
  EXPECT_EQ(read_lists("0 0 0 0 1 5 0\n0 0 0 0 1 x 0\n").error,
            "line 14: expected a number for \"b\" of \"vertex\" 1 of 2, found \"x\" (read as PLY)");
}

// Memory is in proportion to the file, also where strips make faces of single bytes.
TEST(PlyAttributes, OfFacesEndBeforeThoseOfStrips) {
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\n";
  const std::string faces =
      "element face 1\nproperty list uchar int vertex_indices\nproperty int label\nproperty list "
      "uchar float pair\n";
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  const std::string points = "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const test::MeshFile before =
      read_mesh(vertices + faces + strips + points + "3 0 1 2 5 2 8 9\n3 2 1 3\n");
  ASSERT_EQ(before.error, "");
  EXPECT_EQ(before.notes, Strings());
  EXPECT_EQ(values_of(before.mesh, ItemKind::kFace, "label"), (Doubles{5, 0}));
  EXPECT_EQ(values_of(before.mesh, ItemKind::kFace, "pair"), (Doubles{8, 9, 0, 0}));
  const test::MeshFile after =
      read_mesh(vertices + strips + faces + points + "3 2 1 3\n3 0 1 2 5 2 8 9\n");
  EXPECT_EQ(after.notes, Strings{"ignored the properties \"label\", \"pair\" of \"face\""});
  EXPECT_EQ(describe_all(after.mesh), Strings());
  EXPECT_EQ(after.mesh.face_count(), 2U);
}

TEST(PlyAttributes, SaysThatPositionsWereDoubles) {
  const auto notes_of = [](const std::string& type) {
    return read_mesh("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty " + type +
                         " y\nproperty float z\nelement face 0\nproperty list uchar int "
                         "vertex_indices\nend_header\n0 0.1 0\n",
                     true)
        .notes;
  };
  EXPECT_EQ(notes_of("double"), Strings{"read the positions of 1 vertex, doubles, as floats"});
  EXPECT_EQ(notes_of("float"), Strings());
}

TEST(PlyAttributes, MayBeLeftOut) {
  const Result<ParsedFile> file =
      parse(test::bytes_of(kPlyTriangle), std::nullopt, {.attributes = false});
  ASSERT_TRUE(file);
  EXPECT_TRUE(file.value().attributes.empty());
  EXPECT_EQ(file.value().soup.positions.size(), 9U);
}

TEST(PlyAttributes, KeepNamesThatMakeNoGroup) {
  const test::MeshFile read = read_mesh(R"(ply
format ascii 1.0
element vertex 1
property float x
property float y
property float z
property float nx
property float ny
property uchar red
property uchar green
property float blue
property float f[0]
property float f[1]
property float f[3]
property float nx
element face 1
property list uchar int vertex_indices
property list uchar float texcoord
property float s
property float t
end_header
0 0 0 1 2 3 4 5 6 7 8 9
0 1 0 2 3
)",
                                        true);
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(describe_all(read.mesh),
            (Strings{"vertex nx float32 1 interpolate", "vertex ny float32 1 interpolate",
                     "vertex red uint8 1 copy", "vertex green uint8 1 copy",
                     "vertex blue float32 1 interpolate", "vertex f float32 2 interpolate",
                     "vertex f[3] float32 1 interpolate", "halfedge uv float32 2 interpolate",
                     "face s float32 1 interpolate", "face t float32 1 interpolate"}));
  EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "f"), (Doubles{6, 7}));
  EXPECT_EQ(read.notes,
            (Strings{"ignored the property \"nx\" of \"vertex\"",
                     "the list \"texcoord\" of 1 face has not two numbers for each corner: what "
                     "is missing is 0"}));
}

TEST(PlyAttributes, SayWhereAValueIsNone) {
  std::string text = kPlyTriangle;
  text.replace(text.find("255.0"), 5, "green");
  EXPECT_EQ(read_mesh(text).error,
            "line 22: expected a number for \"green\" of \"vertex\" 1 of 3, found \"green\" "
            "(read as PLY)");
}

// ---- OBJ -------------------------------------------------------------------------------------

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
  Mesh mesh = sample();
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
  expect_round_trip(sample_for_obj(4), Format::kObj, Encoding::kText);
}

TEST(ObjAttributes, ShareValuesAndHaveNames) {
  Mesh mesh = sample();
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
          "f 1/1/1 2/1/2 3/1/3 4/1/4\nusemtl oak__2\nf 4/2/4 3/1/3 5/1/5\nusemtl\n"
          "f 2/1/2 6/1/6 3/1/3\nf 6/1/6 7/1/7 3/1/3\n");
  EXPECT_EQ(notes,
            (Strings{"wrote the vertex attribute \"normal\" for the corners of faces, to which "
                     "readers give it",
                     "wrote the face attribute \"material\" as numbers that readers take for int32",
                     "wrote the face attribute \"material\" with 1 of its 1 names changed: # and "
                     "control characters become _, blanks at the ends are left out"}));
}

TEST(ObjAttributes, SaysWhichNamesDoNotComeBack) {
  using Names = std::vector<std::string>;
  const auto notes_of = [](const Names& names, const std::vector<int>& numbers) {
    Mesh mesh = sample();
    Attribute& group = add(mesh, ItemKind::kFace, "group", Scalar::kInt32, 1, OnSplit::kCopy);
    for (Index f = 0; f < numbers.size(); ++f) group.set(f, 0, numbers[f], nullptr);
    const std::vector<SoupNames> tables = {{"group", names}};
    Strings notes;
    EXPECT_TRUE(write(mesh, Format::kObj, {.names = tables, .notes = &notes}));
    return notes;
  };
  const std::string wrote = "wrote the face attribute \"group\" with ";
  const std::string changed =
      " names changed: # and control characters become _, blanks at the ends are left out";
  EXPECT_EQ(notes_of({"", "a", "b"}, {1, 2, 0, 1}), Strings());
  EXPECT_EQ(notes_of({"", "a", "3"}, {1, 2, 0, 1}), Strings()) << "not all of them are numbers";
  EXPECT_EQ(notes_of({"", "a", "#"}, {1, 1, 1, 1}), Strings()) << "is not used";
  EXPECT_EQ(notes_of({"", "a#b", "a_b", " a\tb"}, {1, 2, 3, 0}),
            Strings{wrote + "2 of its 3" + changed});
  EXPECT_EQ(notes_of({"", "", "b"}, {1, 2, 1, 2}),
            Strings{wrote + "1 of its 2 names left out, being empty"});
  EXPECT_EQ(notes_of({"", "1", "0"}, {1, 2, 1, 2}),
            Strings{wrote + "2 of its 2 names that are numbers, for which readers take them"});
  EXPECT_EQ(notes_of({"", "a"}, {1, 7, 1, 0}),
            Strings{wrote + "names that are the numbers of faces which have none"});
}

TEST(ObjAttributes, LeavesOutLabelsThatAreNoInt32) {
  Mesh mesh = sample();
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
}

TEST(ObjAttributes, SaysWhatItCannotHold) {
  Mesh mesh = sample();
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
  EXPECT_EQ(strange.notes,
            Strings{"ignored 3 smoothing groups (s) that are neither integers nor off"});
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

TEST(ObjAttributes, SaysWhatIsIgnored) {
  const test::MeshFile read = read_mesh(
      "v 0 0 0 2\nv 1 0 0 1\nv 0 1 0\nvt 0 0 .5\nvt 0 1 0\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n"
      "f 1/1/1 2/1/1 3/1/1\n");
  EXPECT_EQ(read.notes, (Strings{"ignored 1 third texture coordinate that is not 0",
                                 "ignored 1 weight of a vertex",
                                 "ignored 1 texture coordinate (vt) to which no face refers",
                                 "ignored 2 normals (vn) to which no face refers"}));
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

// ---- OFF -------------------------------------------------------------------------------------

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
      Mesh mesh = sample();
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
  Mesh mesh = sample();
  Attribute& color =
      add(mesh, ItemKind::kVertex, "color", Scalar::kFloat32, 3, OnSplit::kInterpolate);
  for (float& value : color.values<float>())
    value = float(&value - color.values<float>().data()) * 10;
  expect_round_trip(mesh, Format::kOff, Encoding::kText);
}

TEST(OffAttributes, SaysWhatItCannotHold) {
  Mesh mesh = sample();
  add(mesh, ItemKind::kVertex, "color", Scalar::kUint8, 3, OnSplit::kInterpolate)
      .set(0, 0, 1, nullptr);
  add(mesh, ItemKind::kHalfedge, "uv", Scalar::kFloat32, 2, OnSplit::kInterpolate);
  Strings notes;
  (void)write(mesh, Format::kOff, {.notes = &notes});
  EXPECT_EQ(notes, (Strings{"wrote the vertex attribute \"color\" as 0 and 1, which readers take "
                            "for floats",
                            "left out the halfedge attribute \"uv\": OFF has no place for it"}));
  notes.clear();
  (void)write(mesh, Format::kOff, {.encoding = Encoding::kBinary, .notes = &notes});
  EXPECT_EQ(notes, (Strings{"wrote the vertex attribute \"color\" as numbers from 0 to 1",
                            "wrote the vertex attribute \"color\" with an alpha of 1",
                            "left out the halfedge attribute \"uv\": OFF has no place for it"}));
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

// ---- STL -------------------------------------------------------------------------------------

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
  EXPECT_EQ(notes, Strings{"left out the face attribute \"attribute\": STL has no place for it"});
  const auto bytes = write(mesh, Format::kStl);
  const Result<ParsedFile> bare = parse(bytes.value().span(), std::nullopt, {.attributes = false});
  EXPECT_TRUE(bare.value().attributes.empty());
}

// ---- following repairs -----------------------------------------------------------------------

Index below(std::mt19937& random, Index end) { return Index(random() % end); }

/// A column whose value is the index of its item.
SoupAttribute numbered(const char* name, SoupItem item, std::size_t count) {
  SoupAttribute column;
  column.name = name;
  column.item = item;
  column.type = Scalar::kUint32;
  column.on_split = OnSplit::kInterpolate;
  EXPECT_TRUE(column.values.resize(4 * count));
  for (Index i = 0; i < count; ++i) std::memcpy(&column.values[4 * std::size_t{i}], &i, 4);
  return column;
}

/// Repairs a soup, and looks for every item of the mesh where it came from.
void expect_to_follow(const std::vector<float>& positions, const std::vector<Index>& sizes,
                      const std::vector<Index>& corners, const RepairOptions& options) {
  const Polygons soup{positions, sizes, corners};
  Mesh mesh;
  RepairReport report;
  ASSERT_TRUE(build_from_soup(mesh, soup, options, report)) << report.problems[0].message;
  std::vector<SoupAttribute> columns;
  columns.push_back(numbered("v", SoupItem::kVertex, soup.vertex_count()));
  columns.push_back(numbered("c", SoupItem::kCorner, corners.size()));
  columns.push_back(numbered("f", SoupItem::kFace, soup.face_count()));
  ASSERT_TRUE(add_attributes(mesh, soup, &report, columns));
  const auto of_vertices = mesh.find_attribute(ItemKind::kVertex, "v")->values<Index>();
  const auto of_corners = mesh.find_attribute(ItemKind::kHalfedge, "c")->values<Index>();
  const auto of_faces = mesh.find_attribute(ItemKind::kFace, "f")->values<Index>();
  EXPECT_TRUE(std::equal(of_vertices.begin(), of_vertices.end(), report.vertex_origin.begin()));
  std::vector<Index> begin = {0};
  for (const Index size : sizes) begin.push_back(begin.back() + size);
  for (Index f = 0; f < mesh.face_slots(); ++f) {
    const Index source = of_faces[f];
    ASSERT_EQ(report.face_map[source], f);
    std::set<Index> seen;
    int down = 0;
    Index before = kNone;
    const Halfedge first = mesh.face_halfedge(Face(f));
    Halfedge h = first;
    do {
      const Index corner = of_corners[h.index()];
      ASSERT_TRUE(corner >= begin[source] && corner < begin[source + 1]) << report.summary;
      // At its place, and at its position unless welded with a tolerance.
      const Index origin = of_vertices[mesh.to_vertex(h).index()];
      EXPECT_EQ(report.vertex_map[corners[corner]], report.vertex_map[origin]);
      EXPECT_TRUE(seen.insert(corner).second);
      down += before != kNone && corner < before ? 1 : 0;
      before = corner;
      h = mesh.next(h);
    } while (h != first);
    // In order, or all in the opposite order, once round.
    const int steps = int(seen.size()) - 1;
    EXPECT_TRUE(down <= 1 || down >= steps - 1);
  }
}

TEST(Transfer, FollowsWeldsSplitsDropsAndTurns) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Index vertices = 4 + below(random, 12);
    std::vector<float> positions;
    for (Index i = 0; i < 3 * vertices; ++i) positions.push_back(float(below(random, 3)));
    if (seed % 7 == 0) positions[4] = std::nanf("");
    std::vector<Index> sizes;
    std::vector<Index> corners;
    const Index faces = 1 + below(random, 14);
    for (Index f = 0; f < faces; ++f) {
      sizes.push_back(seed % 3 == 0 ? 3 : below(random, 9));
      for (Index i = 0; i < sizes.back(); ++i) corners.push_back(below(random, vertices));
      if (below(random, 40) == 0 && !corners.empty()) corners.back() = 1000;
    }
    RepairOptions options;
    if (seed % 2 == 0) options.weld = seed % 4 == 0 ? 0 : 1.5;
    options.drop_isolated = seed % 5 == 0;
    expect_to_follow(positions, sizes, corners, options);
  }
}

TEST(Transfer, KeepsTheValuesOfTheCornerThatStays) {
  // The face goes to 3 and back, and repeats 2; the other one is turned over.
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 5, 5, 5};
  const std::vector<Index> sizes = {6, 3, 3};
  const std::vector<Index> corners = {0, 1, 4, 1, 2, 2, 0, 3, 2, 0, 1, 9};
  Mesh mesh;
  RepairReport report;
  const Polygons soup{positions, sizes, corners};
  ASSERT_TRUE(build_from_soup(mesh, soup, {}, report));
  std::vector<SoupAttribute> columns;
  columns.push_back(numbered("c", SoupItem::kCorner, corners.size()));
  ASSERT_TRUE(add_attributes(mesh, soup, &report, columns));
  const Doubles values = values_of(mesh, ItemKind::kHalfedge, "c");
  EXPECT_TRUE((values == Doubles{0, 1, 4, 6, 8, 7}) || (values == Doubles{0, 4, 1, 6, 7, 8}))
      << testing::PrintToString(values);
}

}  // namespace
}  // namespace halfedge
