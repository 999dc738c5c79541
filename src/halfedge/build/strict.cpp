#include <halfedge/build/diagnose.h>
#include <halfedge/build/strict.h>
#include <halfedge/sentence.h>

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

// The sign of the difference tells, without a branch: both are below 2^31 if all is well.
bool are_below(std::span<const Index> indices, std::size_t count) {
  const Index last = Index(count) - 1;
  Index signs = 0;
  for (const Index index : indices) signs |= index | (last - index);
  return indices.empty() || (count > 0 && signs >> 31U == 0);
}

}  // namespace

bool can_be_connected(const Polygons& polygons) {
  return sizes_fit(polygons) && are_below(polygons.corners, polygons.vertex_count());
}

ConnectResult copy_positions(std::span<const float> from, Array<float>& to) {
  if (!to.recreate(from.size())) return ConnectResult::kOutOfMemory;
  float* const copy = to.data();
  std::uint32_t not_finite = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &from[i], sizeof bits);
    not_finite |= std::uint32_t{(bits & 0x7F80'0000U) == 0x7F80'0000U};
    copy[i] = from[i];
  }
  return not_finite != 0 ? ConnectResult::kNotManifold : ConnectResult::kDone;
}

bool explain(ConnectResult result, const Polygons& polygons, BuildReport& report) {
  const auto fail = [&](const char* code, std::string message) {
    report.problems.emplace_back(code, std::move(message));
    report.problem_count = 1;
  };
  switch (result) {
    case ConnectResult::kDone:
      return true;
    case ConnectResult::kNotManifold:
      diagnose(polygons, report);
      assert(report.problem_count > 0);
      break;
    case ConnectResult::kTooLarge:
      fail("too-large",
           sentence::of(
               "A mesh of these faces needs more than the {} halfedges that a mesh can have.",
               kMaxSlots));
      break;
    case ConnectResult::kOutOfMemory:
      fail("out-of-memory", sentence::of("There is not enough memory for a mesh of {} and {}.",
                                         sentence::count_of(polygons.vertex_count(), "vertex"),
                                         sentence::count_of(polygons.face_count(), "face")));
      break;
  }
  return false;
}

}  // namespace halfedge
