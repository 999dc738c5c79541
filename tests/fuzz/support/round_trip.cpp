#include "support/round_trip.h"

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/io/write.h>
#include <halfedge/repair/transfer.h>

#include <array>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace halfedge::fuzz {
namespace {

constexpr std::pair<Format, Encoding> kPolygonForms[] = {
    {Format::kObj, Encoding::kText},   {Format::kOff, Encoding::kText},
    {Format::kOff, Encoding::kBinary}, {Format::kPly, Encoding::kText},
    {Format::kPly, Encoding::kBinary}, {Format::kPly, Encoding::kBinaryBigEndian}};
constexpr std::pair<Format, Encoding> kTriangleForms[] = {{Format::kStl, Encoding::kText},
                                                          {Format::kStl, Encoding::kBinary}};

template <class A, class B>
bool same_bits(const A& a, const B& b) {
  return a.size() == b.size() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), a.size() * sizeof(*a.data())) == 0);
}

ParsedFile read_back(const Array<std::uint8_t>& bytes, Format format) {
  Result<ParsedFile> file = parse(bytes.span());
  EXPECT_TRUE(file) << file.error().message;
  EXPECT_EQ(file.value().format, format);
  return std::move(file).value();
}

Array<std::uint8_t> written(const Mesh& mesh, Format format, Encoding encoding) {
  std::vector<std::string> notes;
  Result<Array<std::uint8_t>> bytes = write(mesh, format, {.encoding = encoding, .notes = &notes});
  EXPECT_TRUE(bytes) << bytes.error().message;
  for (const std::string& note : notes) EXPECT_FALSE(note.empty());
  return std::move(bytes).value();
}

void expect_same_polygons(const Mesh& mesh, const PolygonSoup& soup) {
  EXPECT_TRUE(same_bits(soup.positions, mesh.positions()));
  std::vector<Index> corners;
  ASSERT_EQ(soup.view().face_count(), mesh.face_count());
  for (const Face f : mesh.faces()) {
    const Halfedge last = mesh.face_halfedge(f);  // a face is written from where it ends on
    const std::size_t before = corners.size();
    for (const Halfedge h : mesh.loop_ccw(last)) corners.push_back(mesh.to_vertex(h).index());
    const std::size_t size = corners.size() - before;
    EXPECT_EQ(soup.sizes.empty() ? 3 : soup.sizes[f.index()], size);
  }
  EXPECT_TRUE(same_bits(soup.corners, corners));
}

using Position = std::array<float, 3>;
using Passed = std::map<std::pair<Position, Position>, int>;

// How often the lines between positions are passed, forth less back.
void pass(Passed& lines, std::span<const Position> loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Position& from = loop[i];
    const Position& to = loop[(i + 1) % loop.size()];
    if (from < to) ++lines[{from, to}];
    if (to < from) --lines[{to, from}];
  }
  std::erase_if(lines, [](const auto& line) { return line.second == 0; });
}

// STL repeats positions, and reading welds them, where 0 and -0 are the same. Cut anyhow, the
// triangles of a polygon have its boundary.
void expect_same_triangles(const Mesh& mesh, const PolygonSoup& soup) {
  EXPECT_TRUE(soup.sizes.empty());
  std::size_t corner = 0;
  for (const Face f : mesh.faces()) {
    std::vector<Position> polygon;
    for (const Halfedge h : mesh.loop_ccw(mesh.face_halfedge(f))) {
      const Point p = mesh.position(mesh.to_vertex(h));
      polygon.push_back({p.x, p.y, p.z});
    }
    Passed expected;
    pass(expected, polygon);
    Passed passed;
    for (std::size_t i = 2; i < polygon.size(); ++i, corner += 3) {
      ASSERT_LE(corner + 3, soup.corners.size());
      std::array<Position, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const float* const p = &soup.positions[3 * std::size_t{soup.corners[corner + k]}];
        triangle[k] = {p[0], p[1], p[2]};
      }
      pass(passed, triangle);
    }
    EXPECT_EQ(passed, expected) << "face " << f.index();
  }
  EXPECT_EQ(soup.corners.size(), corner);
}

// The file of the mesh that a file gives, with its attributes.
Array<std::uint8_t> rewritten(ParsedFile file, Encoding encoding) {
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, file.soup.view(), report));
  const Result<void> added = add_attributes(mesh, file.soup.view(), nullptr, file.attributes);
  EXPECT_TRUE(added) << added.error().message;
  return written(mesh, file.format, encoding);
}

}  // namespace

void expect_round_trips(const Mesh& mesh) {
  for (const auto& [format, encoding] : kPolygonForms) {
    if (format == Format::kObj && mesh.vertex_slots() == 0) continue;  // an empty file
    Array<std::uint8_t> bytes = written(mesh, format, encoding);
    expect_same_polygons(mesh, read_back(bytes, format).soup);
    if (format == Format::kObj) {
      // Normals of vertices become those of corners, and are written once each from then on.
      bytes = rewritten(read_back(bytes, format), encoding);
    }
    // A column without values isn't in the file, or isn't found there.
    if (mesh.face_count() == 0) continue;
    EXPECT_TRUE(same_bits(rewritten(read_back(bytes, format), encoding), bytes));
  }
  for (const auto& [format, encoding] : kTriangleForms) {
    expect_same_triangles(mesh, read_back(written(mesh, format, encoding), format).soup);
  }
}

}  // namespace halfedge::fuzz
