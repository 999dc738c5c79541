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

bool sizes_fit_a_mesh(const Polygons& polygons) {
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

// Two words of 32 bits at a time, which halves the time where compilers don't do so (WebAssembly).
constexpr std::uint64_t twice(std::uint32_t word) { return std::uint64_t{word} << 32U | word; }

/// Calls `visit` with all words, two at a time; the last of an odd number comes with itself.
template <class Word, class Visit>
void for_each_pair(std::span<const Word> words, const Visit& visit) {
  static_assert(sizeof(Word) == 4);
  std::size_t i = 0;
  for (; i + 2 <= words.size(); i += 2) {
    std::uint64_t pair = 0;
    std::memcpy(&pair, &words[i], sizeof pair);
    visit(pair);
  }
  if (i == words.size()) return;
  std::uint32_t word = 0;
  std::memcpy(&word, &words[i], sizeof word);
  visit(twice(word));
}

// The sign of the difference tells, without a branch: all are below 2^31 if all is well. The lower
// word borrows from the upper one only if it is too large itself, which its own sign tells.
bool are_below(std::span<const Index> indices, std::size_t count) {
  const std::uint64_t last = twice(Index(count) - 1);
  std::uint64_t signs = 0;
  for_each_pair(indices, [&](std::uint64_t pair) { signs |= pair | (last - pair); });
  return indices.empty() || (count > 0 && (signs & twice(0x8000'0000)) == 0);
}

// All bits of the exponent are set in numbers that aren't finite: then 1 more carries into the
// sign.
bool are_finite(std::span<const float> numbers) {
  std::uint64_t carries = 0;
  for_each_pair(numbers, [&](std::uint64_t pair) {
    carries |= (pair & twice(0x7FFF'FFFF)) + twice(0x0080'0000);
  });
  return (carries & twice(0x8000'0000)) == 0;
}

}  // namespace

bool can_be_connected(const Polygons& polygons) {
  return sizes_fit_a_mesh(polygons) && are_below(polygons.corners, polygons.vertex_count());
}

ConnectResult copy_positions(std::span<const float> from, Array<float>& to) {
  if (!are_finite(from)) return ConnectResult::kNotManifold;
  return to.assign(from) ? ConnectResult::kDone : ConnectResult::kOutOfMemory;
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
