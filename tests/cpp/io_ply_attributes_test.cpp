// Attributes of PLY files: what is read, where it goes, and that it is written back.

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(PlyAttributes, ComeBackBitForBit) {
  for (const Encoding encoding : {Encoding::kText, Encoding::kBinary, Encoding::kBinaryBigEndian}) {
    std::mt19937 random(7);
    Mesh mesh = sample_mesh();
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
  Mesh mesh = sample_mesh();
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
  Mesh mesh = sample_mesh();
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
  Mesh mesh = sample_mesh();
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

TEST(PlyAttributes, AreFoundInAnyOrderOfTheirProperties) {
  const auto described = [](const std::string& properties, const std::string& face = "") {
    const test::MeshFile read = read_mesh(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\n" +
        properties + "element face 1\nproperty list uchar int vertex_indices\n" + face +
        "end_header\n0 0 0 1 2 3 4\n1 0 0 5 6 7 8\n0 1 0 9 10 11 12\n3 0 1 2 1 2\n");
    Strings all = describe_all(read.mesh);
    if (all.empty()) return std::make_pair(all, Doubles());
    const ItemKind kind = face.empty() ? ItemKind::kVertex : ItemKind::kFace;
    const std::string name = all[0].substr(all[0].find(' ') + 1);
    return std::make_pair(all, values_of(read.mesh, kind, name.substr(0, name.find(' ')).c_str()));
  };
  const auto first_row = [](const Doubles& values, std::size_t width) {
    return Doubles(values.begin(), values.begin() + std::ptrdiff_t(width));
  };
  const auto bgr = described("property uchar blue\nproperty uchar green\nproperty uchar red\n");
  EXPECT_EQ(bgr.first, Strings{"vertex color uint8 3 interpolate"});
  EXPECT_EQ(first_row(bgr.second, 3), (Doubles{3, 2, 1}));
  const auto argb = described(
      "property uchar alpha\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n");
  EXPECT_EQ(argb.first, Strings{"vertex color uint8 4 interpolate"});
  EXPECT_EQ(first_row(argb.second, 4), (Doubles{2, 3, 4, 1}));
  const auto normal = described("property float nz\nproperty float ny\nproperty float nx\n");
  EXPECT_EQ(normal.first, Strings{"vertex normal float32 3 normalize"});
  EXPECT_EQ(first_row(normal.second, 3), (Doubles{3, 2, 1}));
  const auto uv = described("property float t\nproperty float s\n");
  EXPECT_EQ(uv.first, Strings{"vertex uv float32 2 interpolate"});
  EXPECT_EQ(first_row(uv.second, 2), (Doubles{2, 1}));

  const auto other = described(
      "property float alpha\nproperty uchar blue\nproperty uchar green\nproperty uchar red\n");
  EXPECT_EQ(other.first,
            (Strings{"vertex alpha float32 1 interpolate", "vertex color uint8 3 interpolate"}));
  EXPECT_EQ(described("property uchar green\nproperty uchar red\n").first,
            (Strings{"vertex green uint8 1 copy", "vertex red uint8 1 copy"}));
  EXPECT_EQ(described("", "property float t\nproperty float s\n").first,
            (Strings{"face t float32 1 interpolate", "face s float32 1 interpolate"}));
}

TEST(PlyAttributes, OfTextAreToldWhereTheirTypeDoesNotHoldThem) {
  const auto read_values = [](const std::string& type, const std::string& values) {
    const test::MeshFile read = read_mesh(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty " +
        type +
        " value\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 " +
        values + " 1 0 0 1 0 1 0 2 3 0 1 2\n");
    EXPECT_EQ(read.error, "");
    const double first = values_of(read.mesh, ItemKind::kVertex, "value")[0];
    return std::make_pair(first, read.notes);
  };
  const Strings told = {"took 1 number that its type does not hold for the nearest that it does"};
  using Read = std::pair<double, Strings>;
  EXPECT_EQ(read_values("uchar", "300"), Read(255, told));
  EXPECT_EQ(read_values("uchar", "-1"), Read(0, told));
  EXPECT_EQ(read_values("short", "40000.0"), Read(32767, told));
  EXPECT_EQ(read_values("int", "3000000000"), Read(2147483647, told));
  EXPECT_EQ(read_values("int", "2.7"), Read(3, told));
  EXPECT_EQ(read_values("int", "nan"), Read(0, told));
  EXPECT_EQ(read_values("int", "16777217.0"), Read(16777217, {}));
  EXPECT_EQ(read_values("uint", "4294967295"), Read(4294967295, {}));
  EXPECT_EQ(read_values("double", "16777217"), Read(16777217, {}));
}

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
  EXPECT_EQ(read.notes, (Strings{"ignored the list \"neighbours\" of \"vertex\": expected 1 to 16 "
                                 "numbers, as many in each row",
                                 "took 3 numbers that their types do not hold for the nearest that "
                                 "they do"}));
}

// No type of the format, but what programs make of arrays of such integers.
TEST(PlyAttributes, HaveIntegersOf64BitsAsDoubles) {
  const auto header = [](const char* format) {
    return std::string("ply\nformat ") + format +
           " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "property int64 label\nelement face 1\nproperty list uint64 int64 vertex_indices\n"
           "property uint64 id\nproperty list uchar int64 pair\nend_header\n";
  };
  const std::int64_t labels[] = {-7, 1, std::int64_t{1} << 40};
  const float positions[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto expect = [](const std::string& file) {
    const test::MeshFile read = read_mesh(file);
    EXPECT_EQ(read.error, "");
    EXPECT_EQ(describe_all(read.mesh),
              (Strings{"vertex label float64 1 copy", "face id float64 1 copy",
                       "face pair float64 2 copy"}));
    EXPECT_EQ(values_of(read.mesh, ItemKind::kVertex, "label"), (Doubles{-7, 1, 0x1p40}));
    EXPECT_EQ(values_of(read.mesh, ItemKind::kFace, "id"), Doubles{0x1p63});
    EXPECT_EQ(values_of(read.mesh, ItemKind::kFace, "pair"), (Doubles{5, -6}));
    EXPECT_EQ(read.notes,
              (Strings{"read the property \"label\" of \"vertex\", integers of 64 bits, as doubles",
                       "read the properties \"id\", \"pair\" of \"face\", integers of 64 bits, as "
                       "doubles"}));
  };
  expect(header("ascii") +
         "0 0 0 -7\n1 0 0 1\n0 1 0 1099511627776\n3 0 1 2 9223372036854775808 2 5 -6\n");
  for (const bool big : {false, true}) {
    std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian");
    const auto append = [&](auto value) {
      std::string raw(sizeof(value), '\0');
      std::memcpy(raw.data(), &value, sizeof(value));
      if (big) std::reverse(raw.begin(), raw.end());
      bytes += raw;
    };
    for (std::size_t v = 0; v < 3; ++v) {
      for (const float x : positions[v]) append(x);
      append(labels[v]);
    }
    append(std::uint64_t{3});
    for (const std::int64_t v : {0, 1, 2}) append(v);
    append(std::uint64_t{1} << 63U);
    append(std::uint8_t{2});
    for (const std::int64_t k : {5, -6}) append(k);
    expect(bytes);
  }
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
  std::string two_faces = faces;
  two_faces.replace(faces.find("face 1"), 6, "face 2");  // of one strip, which has another count
  const test::MeshFile more = read_mesh(vertices + two_faces + strips + points +
                                        "3 0 1 2 5 2 8 9\n3 2 1 3 6 2 8 9\n3 0 2 3\n");
  EXPECT_EQ(values_of(more.mesh, ItemKind::kFace, "label"), (Doubles{5, 6, 0}));
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

}  // namespace
}  // namespace halfedge
