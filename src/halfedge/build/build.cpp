#include <halfedge/build/build.h>
#include <halfedge/build/corners.h>
#include <halfedge/build/diagnose.h>
#include <halfedge/build/sentence.h>
#include <halfedge/build/sweep.h>

#include <cassert>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

namespace halfedge {

namespace {

bool sizes_fit(const Polygons& polygons) {
  if (polygons.positions.size() % 3 != 0 || polygons.vertex_count() > kMaxSlots ||
      polygons.corners.size() > kMaxSlots) {
    return false;
  }
  if (polygons.sizes.empty()) return polygons.corners.size() % 3 == 0;
  std::uint64_t sum = 0;
  bool large_enough = true;
  for (const Index size : polygons.sizes) {
    sum += size;
    large_enough &= size >= 3;
  }
  return large_enough && sum == polygons.corners.size();
}

bool are_finite(std::span<const float> numbers) {
  std::uint32_t bad = 0;
  for (const float number : numbers) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    bad |= std::uint32_t{(bits & 0x7F80'0000U) == 0x7F80'0000U};
  }
  return bad == 0;
}

bool are_below(std::span<const Index> indices, std::size_t count) {
  Index largest = 0;
  for (const Index index : indices) largest = index > largest ? index : largest;
  return indices.empty() || largest < count;
}

bool all_triangles(std::span<const Index> sizes) {
  Index different = 0;
  for (const Index size : sizes) different |= size ^ 3U;
  return different == 0;
}

SweepResult connect(Links& links, const Polygons& polygons) {
  if (!sizes_fit(polygons) || !are_finite(polygons.positions) ||
      !are_below(polygons.corners, polygons.vertex_count())) {
    return SweepResult::kNotManifold;
  }
  if (all_triangles(polygons.sizes)) return Sweep(links, polygons, TriangleCorners{}).run();
  PolygonCorners corners;
  if (!corners.assign(polygons.sizes, polygons.corners.size())) return SweepResult::kOutOfMemory;
  return Sweep(links, polygons, corners).run();
}

}  // namespace

bool build_from_polygons(Mesh& mesh, const Polygons& polygons, BuildReport& report) {
  report = {};
  mesh.clear();
  SweepResult result = connect(mesh.mutable_links(), polygons);
  if (result == SweepResult::kDone && !mesh.mutable_positions().assign(polygons.positions)) {
    result = SweepResult::kOutOfMemory;
  }
  if (result != SweepResult::kDone) mesh.clear();
  const auto fail = [&](const char* code, std::string message) {
    report.problems.push_back({code, std::move(message)});
    report.problem_count = 1;
  };
  switch (result) {
    case SweepResult::kDone:
      return true;
    case SweepResult::kNotManifold:
      diagnose(polygons, report);
      assert(report.problem_count > 0);
      break;
    case SweepResult::kTooLarge:
      fail("too-large", "A mesh of these faces needs more than the " + std::to_string(kMaxSlots) +
                            " halfedges that a mesh can have.");
      break;
    case SweepResult::kOutOfMemory:
      fail("out-of-memory", "There is not enough memory for a mesh of " +
                                sentence::count_of(polygons.vertex_count(), "vertex") + " and " +
                                sentence::count_of(polygons.face_count(), "face") + ".");
      break;
  }
  return false;
}

}  // namespace halfedge
