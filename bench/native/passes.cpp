#include <halfedge/algorithms/adjacency.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <vector>

#include "memory.h"

// Whole-mesh passes over the mesh of a file, to be compared with the same C++ as WebAssembly:
// prints the names and the median milliseconds as JSON. See bench/web/wasm.mjs.

namespace {

constexpr int kRounds = 15;

double milliseconds_of(const std::function<void()>& run) {
  std::vector<double> times;
  for (int round = 0; round < kRounds; ++round) {
    const std::clock_t begin = std::clock();
    run();
    times.push_back(1000.0 * double(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  std::nth_element(times.begin(), times.begin() + kRounds / 2, times.end());
  return times[kRounds / 2];
}

void require(bool fine) {
  if (fine) return;
  std::fprintf(stderr, "The file doesn't hold a mesh that can be built.\n");
  std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  keep_one_heap();
  require(argc == 2);
  std::ifstream file(argv[1], std::ios::binary);
  const std::vector<char> text((std::istreambuf_iterator<char>(file)),
                               std::istreambuf_iterator<char>());
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto parsed = halfedge::parse({bytes, text.size()});
  require(bool(parsed));
  const halfedge::PolygonSoup& soup = parsed.value().soup;

  halfedge::Mesh mesh;
  const double build = milliseconds_of([&] {
    halfedge::BuildReport report;
    require(build_from_polygons(mesh, {soup.positions, {}, soup.corners}, report));
  });
  // Keeps rows from lying as far into their pages as the links that are read while they are
  // written: processors take one for the other then, and rings of the open grid took 3.5 times as
  // long.
  const std::vector<char> apart(1000);
  const auto rows = [&](halfedge::Ring ring) {
    return milliseconds_of([&] {
      halfedge::Adjacency out;
      require(bool(adjacency(mesh, ring, halfedge::Direction::kCcw, out)));
    });
  };
  const double vertex_vertices = rows(halfedge::Ring::kVertexVertices);
  const double face_faces = rows(halfedge::Ring::kFaceFaces);
  const double validated =
      milliseconds_of([&] { require(validate(mesh, halfedge::kMaxValidationLevel).empty()); });
  std::printf(
      R"({"build": %.3f, "rings of vertices": %.3f, "rings of faces": %.3f, "validate": %.3f})"
      "\n",
      build, vertex_vertices, face_faces, validated);
  return 0;
}
