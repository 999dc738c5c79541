// Every circulator, link and boundary flag against OpenMesh's, on real and on random meshes.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <algorithm>
#include <iostream>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "openmesh/comparison.h"
#include "openmesh/theirs.h"
#include "support/data_files.h"
#include "support/random_polygons.h"
#include "support/shapes.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif

namespace halfedge::test {
namespace {

// Under the sanitizers the largest meshes would take minutes.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kMaxFaces = 20000;
#else
constexpr std::size_t kMaxFaces = 10'000'000;
#endif

// Adds the polygons one by one, as OpenMesh does; the position of the first that it refuses.
std::optional<std::size_t> add_faces(TheirMesh& mesh, const Polygons& polygons) {
  const QuietLog quiet;
  for (std::size_t v = 0; v < polygons.vertex_count(); ++v) {
    const float* p = &polygons.positions[3 * v];
    mesh.add_vertex({p[0], p[1], p[2]});
  }
  std::size_t first = 0;
  for (std::size_t f = 0; f < polygons.face_count(); ++f) {
    const std::size_t degree = polygons.sizes.empty() ? 3 : polygons.sizes[f];
    std::vector<OpenMesh::VertexHandle> corners;
    for (std::size_t i = 0; i < degree; ++i) {
      corners.emplace_back(int(polygons.corners[first + i]));
    }
    first += degree;
    if (!mesh.add_face(corners).is_valid()) return f;
  }
  return std::nullopt;
}

// The polygons with their faces in another order.
Shape reordered(const Polygons& polygons, const std::vector<std::size_t>& order) {
  std::vector<std::vector<Index>> faces;
  std::size_t first = 0;
  for (std::size_t f = 0; f < polygons.face_count(); ++f) {
    const std::size_t degree = polygons.sizes.empty() ? 3 : polygons.sizes[f];
    const auto begin = polygons.corners.begin() + std::ptrdiff_t(first);
    faces.emplace_back(begin, begin + std::ptrdiff_t(degree));
    first += degree;
  }
  std::vector<std::vector<Index>> permuted;
  for (const std::size_t f : order) permuted.push_back(faces[f]);
  return {"reordered", Index(polygons.vertex_count()), std::move(permuted)};
}

struct Outcome {
  bool compared = false;
  bool in_file_order = false;
  std::size_t pinched = 0;
};

void compare_in_order(const Polygons& polygons, TheirMesh& theirs, Outcome& outcome) {
  Mesh ours;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(ours, polygons, report)) << report.problems[0].message;
  Comparison comparison(ours, theirs);
  EXPECT_EQ(comparison.run(), "");
  outcome.compared = true;
  outcome.pinched = comparison.pinched_vertices();
}

// Compares in the order of the input; where OpenMesh can't add the faces in that order, in others.
Outcome compare(const Polygons& polygons, std::uint32_t seed) {
  Outcome outcome;
  {
    TheirMesh theirs;
    if (!add_faces(theirs, polygons)) {
      compare_in_order(polygons, theirs, outcome);
      outcome.in_file_order = true;
      return outcome;
    }
  }
  std::mt19937 random(seed);
  std::vector<std::size_t> order(polygons.face_count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int tries = 0; tries < 20 && !outcome.compared; ++tries) {
    std::shuffle(order.begin(), order.end(), random);
    const Shape shape = reordered(polygons, order);
    TheirMesh theirs;
    if (!add_faces(theirs, shape.polygons())) {
      compare_in_order(shape.polygons(), theirs, outcome);
    }
  }
  return outcome;
}

// What a file holds, by our reader where it knows the format, else by OpenMesh's (which welds STL).
std::optional<PolygonSoup> read(const std::filesystem::path& path) {
  Result<ParsedFile> parsed = parse_file(path);
  if (parsed.ok()) return std::move(parsed.value().soup);

  const QuietLog quiet;
  TheirMesh mesh;
  // OpenMesh knows formats by the extension and only in lower case.
  OpenMesh::IO::Options options;
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  std::ifstream in(path, std::ios::binary);
  if (!OpenMesh::IO::read_mesh(mesh, in, extension, options)) return std::nullopt;
  PolygonSoup soup;
  for (const auto v : mesh.vertices()) {
    for (int i = 0; i < 3; ++i)
      EXPECT_TRUE(soup.positions.push_back(mesh.point(v)[std::size_t(i)]));
  }
  for (const auto f : mesh.faces()) {
    EXPECT_TRUE(soup.sizes.push_back(Index(mesh.valence(f))));
    for (const auto v : f.vertices_ccw()) EXPECT_TRUE(soup.corners.push_back(Index(v.idx())));
  }
  return soup;
}

TEST(OpenMesh, AgreesOnEveryShape) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    EXPECT_TRUE(compare(shape.polygons(), 1).compared);
  }
}

TEST(OpenMesh, AgreesOnTheMeshCollection) {
  HALFEDGE_NEEDS_DATA();
  std::size_t compared = 0;
  std::size_t faces = 0;
  std::size_t reordered = 0;
  std::size_t too_large = 0;
  std::vector<std::string> skipped;
  for (const auto& path : data_files("good", {".obj", ".off", ".ply", ".stl"})) {
    SCOPED_TRACE(path.filename());
    const std::optional<PolygonSoup> soup = read(path);
    if (!soup) {
      skipped.push_back(path.filename().string() + " (unreadable)");
      continue;
    }
    if (soup->view().face_count() > kMaxFaces) {
      ++too_large;
      continue;
    }
    const Outcome outcome = compare(soup->view(), 1);
    if (!outcome.compared) {
      skipped.push_back(path.filename().string() + " (OpenMesh refuses faces)");
      continue;
    }
    ++compared;
    faces += soup->view().face_count();
    reordered += outcome.in_file_order ? 0 : 1;
  }
  std::cout << compared << " meshes of " << faces << " faces compared, " << reordered
            << " of them in another order than the file's; " << too_large
            << " too large to compare under the sanitizers; skipped:";
  for (const std::string& name : skipped) std::cout << " " << name;
  std::cout << (skipped.empty() ? " none\n" : "\n");
  EXPECT_GE(compared + too_large, 100U);
  EXPECT_TRUE(skipped.empty());
}

TEST(OpenMesh, AgreesOnRandomPolygonMeshes) {
  std::size_t skipped = 0;
  std::size_t reordered = 0;
  std::size_t pinched = 0;
  constexpr std::uint32_t kMeshes = 300;
  for (std::uint32_t seed = 0; seed < kMeshes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Outcome outcome = compare(random_polygons(seed).polygons(), seed);
    skipped += outcome.compared ? 0 : 1;
    reordered += outcome.compared && !outcome.in_file_order ? 1 : 0;
    pinched += outcome.pinched;
  }
  std::cout << kMeshes << " random meshes with " << pinched << " pinched vertices, " << skipped
            << " of them skipped: OpenMesh adds their faces in no order tried; " << reordered
            << " compared in another order\n";
  EXPECT_GT(pinched, 500U);
  EXPECT_EQ(skipped, 0U);
}

}  // namespace
}  // namespace halfedge::test
