#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/io/number_writer.h>
#include <halfedge/io/write.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/data_files.h"
#include "support/text_file.h"

namespace halfedge {
namespace {

using test::Parsed;
using Faces = std::vector<std::vector<Index>>;

constexpr std::pair<Format, Encoding> kForms[] = {
    {Format::kObj, Encoding::kText},   {Format::kOff, Encoding::kText},
    {Format::kOff, Encoding::kBinary}, {Format::kPly, Encoding::kText},
    {Format::kPly, Encoding::kBinary}, {Format::kPly, Encoding::kBinaryBigEndian},
    {Format::kStl, Encoding::kText},   {Format::kStl, Encoding::kBinary}};

Mesh built(const std::vector<float>& positions, const Faces& faces) {
  std::vector<Index> sizes;
  std::vector<Index> corners;
  for (const auto& face : faces) {
    sizes.push_back(static_cast<Index>(face.size()));
    corners.insert(corners.end(), face.begin(), face.end());
  }
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, {positions, sizes, corners}, report));
  return mesh;
}

std::string written(const Mesh& mesh, Format format, std::optional<Encoding> encoding = {}) {
  const auto bytes = write(mesh, format, {encoding});
  if (!bytes) return std::string(bytes.error().code) + ": " + bytes.error().message;
  return {bytes.value().begin(), bytes.value().end()};
}

Parsed read_back(const Mesh& mesh, Format format, Encoding encoding) {
  const std::string bytes = written(mesh, format, encoding);
  const auto file = parse(test::bytes_of(bytes));
  if (file) {
    EXPECT_EQ(file.value().format, format);
    EXPECT_TRUE(file.value().notes.empty());
  }
  return test::flatten(file);
}

std::vector<std::uint32_t> bits_of(const std::vector<float>& values) {
  std::vector<std::uint32_t> bits(values.size());
  if (!values.empty()) std::memcpy(bits.data(), values.data(), 4 * values.size());
  return bits;
}

const std::vector<float> kPositions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5F, 2, 0, 7, 8, 9};
const Faces kFaces = {{2, 3, 0, 1}, {3, 2, 4}};

TEST(Write, WritesEachFormat) {
  const Mesh mesh = built(kPositions, kFaces);
  const std::string rows = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 2 0\n7 8 9\n4 2 3 0 1\n3 3 2 4\n";
  EXPECT_EQ(written(mesh, Format::kObj),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0\nv 7 8 9\nf 3 4 1 2\nf 4 3 5\n");
  EXPECT_EQ(written(mesh, Format::kOff), "OFF\n6 2 0\n" + rows);
  EXPECT_EQ(written(mesh, Format::kPly, Encoding::kText),
            "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
            "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
            "end_header\n" +
                rows);
  EXPECT_EQ(
      written(built({0, 0, 0, 2, 0, 0, 0, 0, -2}, {{0, 1, 2}}), Format::kStl, Encoding::kText),
      "solid\nfacet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 0 -2\n"
      "endloop\nendfacet\nendsolid\n");
  EXPECT_EQ(written(mesh, Format::kPly), written(mesh, Format::kPly, Encoding::kBinary));
  EXPECT_EQ(written(mesh, Format::kStl), written(mesh, Format::kStl, Encoding::kBinary));
  EXPECT_EQ(written(mesh, Format::kStl).size(), 84U + 3 * 50);
}

TEST(Write, ReadsBackTheSamePolygons) {
  const Mesh mesh = built(kPositions, kFaces);
  for (const auto& [format, encoding] : kForms) {
    SCOPED_TRACE(name_of(format));
    const Parsed file = read_back(mesh, format, encoding);
    EXPECT_EQ(file.error, "");
    if (format == Format::kStl) {  // triangles, over vertices in the order in which they come
      EXPECT_EQ(file.faces, (Faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
      continue;
    }
    EXPECT_EQ(file.faces, kFaces);
    EXPECT_EQ(file.positions, kPositions);
  }
}

TEST(Write, CutsConcaveFacesWithoutFoldsForStl) {
  // Seen from the corner at which the face starts, another one is hidden.
  const Mesh mesh =
      built({0, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0}, {{1, 2, 3, 4, 5, 0}});
  const std::string text = written(mesh, Format::kStl, Encoding::kText);
  std::size_t facets = 0;
  std::size_t upwards = 0;
  for (std::size_t at = 0; (at = text.find("facet normal ", at)) != std::string::npos; ++at) {
    ++facets;
    upwards += text.substr(at, 18) == "facet normal 0 0 1" ? 1U : 0U;
  }
  EXPECT_EQ(facets, 4U);
  EXPECT_EQ(upwards, 4U);
  for (const Encoding encoding : {Encoding::kText, Encoding::kBinary}) {
    const Parsed file = read_back(mesh, Format::kStl, encoding);
    double area = 0;
    for (const auto& face : file.faces) {
      const auto x = [&](std::size_t i) { return double{file.positions[3 * face[i]]}; };
      const auto y = [&](std::size_t i) { return double{file.positions[3 * face[i] + 1]}; };
      const double part = ((x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0))) / 2;
      EXPECT_GT(part, 0);
      area += part;
    }
    EXPECT_EQ(file.faces.size(), 4U);
    EXPECT_EQ(area, 3);
  }
}

TEST(Write, ReadsBackTheSameBits) {
  std::mt19937 random(5);
  std::vector<float> positions;
  Faces faces;
  for (Index f = 0; f < 20000; ++f) {
    for (int i = 0; i < 9; ++i) {
      float x = 0;
      do {
        const auto bits = static_cast<std::uint32_t>(random());
        std::memcpy(&x, &bits, sizeof(x));
        if (f % 2 == 0) x = static_cast<float>(bits) / 4e9F - 0.5F;
      } while (!std::isfinite(x));
      positions.push_back(x);
    }
    faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  const Mesh mesh = built(positions, faces);
  for (const auto& [format, encoding] : kForms) {
    SCOPED_TRACE(name_of(format));
    const Parsed file = read_back(mesh, format, encoding);
    ASSERT_EQ(file.error, "");
    EXPECT_TRUE(bits_of(file.positions) == bits_of(positions));
    EXPECT_EQ(file.faces, faces);
  }
}

TEST(Write, LeavesOutDeletedItems) {
  Mesh rest = built({0, 0, 0, 9, 9, 9, 1, 0, 0, 1, 1, 0, 8, 8, 8, 0, 1, 0}, {{0, 2, 3, 5}});
  rest.release(Vertex(1));
  rest.release(Vertex(4));
  for (const auto& [format, encoding] : kForms) {
    if (format == Format::kStl) continue;
    const Parsed file = read_back(rest, format, encoding);
    EXPECT_EQ(file.faces, (Faces{{0, 1, 2, 3}}));
    EXPECT_EQ(file.positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  }
}

TEST(Write, WritesNothingButAHeader) {
  for (const auto& [format, encoding] : kForms) {
    const Parsed file = read_back(Mesh(), format, encoding);
    EXPECT_EQ(file.error, "");
    EXPECT_TRUE(file.positions.empty());
  }
  EXPECT_EQ(written(Mesh(), Format::kObj), "# no vertices\nusemtl (null)\n");
}

TEST(Write, CountsTheCornersOfLargeFaces) {
  std::vector<float> positions;
  Faces faces(1);
  for (Index v = 0; v < 300; ++v) {
    positions.insert(positions.end(), {static_cast<float>(v), static_cast<float>(v * v), 0});
    faces[0].push_back(v);
  }
  const Mesh mesh = built(positions, faces);
  for (const Encoding encoding : {Encoding::kText, Encoding::kBinary, Encoding::kBinaryBigEndian}) {
    EXPECT_EQ(read_back(mesh, Format::kPly, encoding).faces, faces);
  }
  EXPECT_NE(written(mesh, Format::kPly).find("\nproperty list int int vertex_indices\n"),
            std::string::npos)
      << "OpenMesh has no lists of uint";
  EXPECT_EQ(read_back(mesh, Format::kStl, Encoding::kBinary).faces.size(), 298U);
}

TEST(Write, RefusesWhatAFormatCannotHold) {
  Mesh mesh = built(kPositions, kFaces);
  EXPECT_EQ(written(mesh, Format::kObj, Encoding::kBinary),
            "unsupported-format: OBJ has no binary form, expected text");
  EXPECT_EQ(written(mesh, Format::kStl, Encoding::kBinaryBigEndian),
            "unsupported-format: STL has no big-endian form");
  mesh.set_position(Vertex(4), {0, std::numeric_limits<float>::infinity(), 0});
  EXPECT_EQ(written(mesh, Format::kStl).substr(0, 54),
            "non-finite-position: vertex 4 has the position 0, inf,");
  const Parsed file = read_back(mesh, Format::kOff, Encoding::kText);
  EXPECT_EQ(file.positions[13], std::numeric_limits<float>::infinity());
}

TEST(Write, SaysWhichVerticesReadersWillNotHave) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh = built({0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5}, {{0, 1, 2}});
  std::vector<std::string> notes;
  ASSERT_TRUE(write(mesh, Format::kStl, {.notes = &notes}));
  EXPECT_EQ(notes,
            std::vector<std::string>{"left out 1 vertex without faces: STL has no place for it"});
  notes.clear();
  mesh.set_position(Vertex(3), {nan, 0, 0});
  ASSERT_TRUE(write(mesh, Format::kObj, {.notes = &notes}));
  EXPECT_EQ(notes, std::vector<std::string>{
                       "wrote 1 vertex whose position isn't finite: readers leave it out"});
}

TEST(Write, RefusesACorruptMesh) {
  for (const Index wrong : {Index{6}, kNone, Index{1000000}}) {
    Mesh mesh = built(kPositions, kFaces);
    mesh.mutable_links().to_vertex[mesh.face_halfedge(Face(1)).index()] = wrong;
    for (const auto& [format, encoding] : kForms) {
      EXPECT_EQ(written(mesh, format, encoding).substr(0, 20), "corrupt-connectivity");
    }
  }
}

TEST(Write, WritesTheShortestNumberThatReadsTheSame) {
  std::mt19937 random(6);
  for (int round = 0; round < 300000; ++round) {
    const auto bits = static_cast<std::uint32_t>(random());
    float value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    if (round % 3 == 1) value = static_cast<float>(static_cast<int>(bits % 2000000)) / 1000.0F;
    if (round % 3 == 2) value = static_cast<float>(bits) * 1e-9F;
    if (!std::isfinite(value)) continue;
    char ours[io::kMaxNumberLength + 1];
    char theirs[64];
    char* const end = io::write_float(ours, value);
    ASSERT_LE(end - ours, io::kMaxNumberLength);
    *end = '\0';
    float read = 0;
    const auto result = std::from_chars(ours, end, read);
    ASSERT_TRUE(result.ec == std::errc() && result.ptr == end) << ours;
    ASSERT_EQ(read, value) << ours;
    ASSERT_EQ(std::signbit(read), std::signbit(value)) << ours;
    const auto digits = [](const std::string& number) {
      std::string all;
      for (const char c : number.substr(0, number.find('e'))) {
        if (c >= '0' && c <= '9') all += c;
      }
      all.erase(0, std::min(all.find_first_not_of('0'), all.size()));
      all.erase(all.find_last_not_of('0') + 1);
      return all;
    };
    const auto shortest =
        std::to_chars(theirs, theirs + sizeof(theirs), value, std::chars_format::scientific);
    if (std::abs(value) < std::numeric_limits<float>::min())
      continue;  // a digit too many is no harm
    ASSERT_EQ(digits(ours), digits(std::string(theirs, shortest.ptr))) << ours;
  }
}

TEST(Write, ReadsBackTheCollection) {
  HALFEDGE_NEEDS_DATA();
  for (const char* const name : {"spot_gc.ply", "fandisk_quads.off", "halftunnel.off", "torus.STL",
                                 "platonic_shelf_big_endian.ply", "openmesh_cube-minimal.ply"}) {
    SCOPED_TRACE(name);
    const std::string bytes = test::read_file(test::data_folder() / "good" / name);
    const auto file = parse(test::bytes_of(bytes));
    ASSERT_TRUE(file) << file.error().message;
    const Parsed original = test::flatten(file);
    Mesh mesh;
    BuildReport report;
    ASSERT_TRUE(build_from_polygons(mesh, file.value().soup.view(), report));
    for (const auto& [format, encoding] : kForms) {
      if (format == Format::kStl && file.value().format != Format::kStl) continue;
      const Parsed again = read_back(mesh, format, encoding);
      EXPECT_EQ(again.error, "");
      EXPECT_TRUE(bits_of(again.positions) == bits_of(original.positions));
      EXPECT_EQ(again.faces, original.faces);
    }
  }
}

}  // namespace
}  // namespace halfedge
