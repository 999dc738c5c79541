// Positions and edges chosen by someone who has read how we hash them: all in one place of the
// table, where it would take as long to find one as there are others: eleven seconds for an STL of
// 5 MB.

#include <gtest/gtest.h>
#include <halfedge/algorithms/polygon_cutter.h>
#include <halfedge/io/parse.h>
#include <halfedge/repair/repair.h>

#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/repairing.h"
#include "support/scaling.h"
#include "support/text_file.h"

namespace halfedge::test {
namespace {

constexpr std::size_t kCount = 99'999;  // positions, three a triangle

/// The number that takes a multiplication by the odd number `n` back.
constexpr std::uint64_t inverse(std::uint64_t n) {
  std::uint64_t x = n;
  for (int i = 0; i < 6; ++i) x *= 2 - n * x;
  return x;
}

/// Positions with z = 0 whose other bits are those of `bits_of(0)`, `bits_of(1)`, ...
template <class BitsOf>
std::vector<float> positions_of(const BitsOf& bits_of) {
  std::vector<float> positions;
  for (std::uint64_t i = 0; positions.size() < 3 * kCount; ++i) {
    const std::uint64_t bits = bits_of(i);
    float xy[2];
    std::memcpy(xy, &bits, sizeof xy);
    if (!std::isfinite(xy[0]) || !std::isfinite(xy[1]) || xy[0] == 0 || xy[1] == 0) continue;
    positions.insert(positions.end(), {xy[0], xy[1], 0});
  }
  return positions;
}

/// The same place in io::PositionTable: its hash, taken back step by step.
std::vector<float> colliding_in_stl() {
  return positions_of([](std::uint64_t i) {
    std::uint64_t h = i * inverse(0x94D0'49BB'1331'11EBU);
    h = (h ^ (h >> 32U)) * inverse(0xBF58'476D'1CE4'E5B9U);
    h = h ^ (h >> 29U) ^ (h >> 58U);
    return h * inverse(0x9E37'79B9'7F4A'7C15U);
  });
}

/// The same place in the table of the exact welder.
std::vector<float> colliding_in_weld() {
  return positions_of([](std::uint64_t i) {
    constexpr std::uint64_t kFactor = 0xD6E8'FEB8'6659'FD93U;
    std::uint64_t h = i << 32U;
    h = (h ^ (h >> 32U)) * inverse(kFactor);
    h = (h ^ (h >> 32U)) * inverse(kFactor);
    return h ^ 0x9E37'79B9'7F4A'7C15U;
  });
}

/// Places apart whose cells lie in the same place in the table of the welder with this tolerance,
/// and beside each another one, closer than it.
constexpr double kTolerance = 0x1p-40 / 2.000002;  // makes cells as wide as a power of two

std::vector<float> colliding_in_near_weld() {
  constexpr std::uint64_t kStart = 0x9E37'79B9'7F4A'7C15U;
  constexpr std::uint64_t kFactor = 0xD6E8'FEB8'6659'FD93U;
  constexpr auto kInverse = std::uint32_t(inverse(kFactor));
  std::vector<float> positions;
  // Cells are whole numbers as doubles whose lower 32 bits are 0. So the upper ones of z can be
  // chosen such that the hash of any y, with x in the first cell, ends in 32 zeros.
  for (std::uint64_t i = 0; positions.size() < 3 * kCount / 2; ++i) {
    const std::uint64_t y = (0x4330'0000U + i) << 32U;
    std::uint64_t h = kStart * kFactor;
    h = ((h ^ (h >> 32U)) ^ y) * kFactor;
    h = ((h ^ (h >> 32U)) ^ kStart) * kFactor;
    h ^= h >> 32U;
    const std::uint64_t of_low = (h & 0xFFFF'FFFFU) * kFactor;
    const auto missing = std::uint32_t(of_low) - std::uint32_t(of_low >> 32U);
    const std::uint64_t z = ((h >> 32U) ^ std::uint32_t(missing * kInverse)) << 32U;
    double cells[2];
    std::memcpy(&cells[0], &y, sizeof y);
    std::memcpy(&cells[1], &z, sizeof z);
    const double size = std::abs(cells[1]);
    if (!(size >= 0x1p21 && size < 0x1p150)) continue;
    positions.insert(positions.end(), {0, float(cells[0] * 0x1p-40), float(cells[1] * 0x1p-40)});
  }
  return positions;
}

std::vector<float> ordinary() {
  std::mt19937_64 random(1);
  return positions_of([&random](std::uint64_t) { return random(); });
}

using Edges = std::vector<std::pair<Vertex, Vertex>>;

/// Edges whose keys are `key_of(0)`, `key_of(1)`, ...
template <class KeyOf>
Edges edges_of(const KeyOf& key_of) {
  Edges edges;
  for (std::uint64_t i = 0; edges.size() < kCount; ++i) {
    const std::uint64_t key = key_of(i);
    const Vertex low(Index(key >> 32U));
    const Vertex high(Index(key & 0xFFFF'FFFFU));
    if (low < high) edges.emplace_back(low, high);
  }
  return edges;
}

/// The same place in the table of planned edges.
Edges colliding_edges() {
  return edges_of([](std::uint64_t i) {
    std::uint64_t h = i << 32U;
    h = (h ^ (h >> 32U)) * inverse(0xD6E8'FEB8'6659'FD93U);
    return (h ^ (h >> 32U)) * inverse(0x9E37'79B9'7F4A'7C15U);
  });
}

Edges ordinary_edges() {
  std::mt19937_64 random(1);
  return edges_of([&random](std::uint64_t) { return random(); });
}

/// All edges of one vertex, those of others in steps.
Edges edges_of_a_hub() {
  return edges_of([](std::uint64_t i) { return ((i * 4096) << 32U) | 0xFFFF'FFF0U; });
}

double seconds_to_plan(const Edges& edges) {
  return seconds_of([&edges] {
    PlannedEdges planned;
    for (const auto& [a, b] : edges) {
      ASSERT_FALSE(planned.contains(a, b));
      ASSERT_TRUE(planned.insert(b, a));
    }
    for (const auto& [a, b] : edges) ASSERT_TRUE(planned.contains(a, b));
  });
}

double seconds_to_read_stl(const std::vector<float>& positions) {
  constexpr std::uint32_t kTriangles = kCount / 3;
  std::string file(84 + 50 * std::size_t{kTriangles}, '\0');
  std::memcpy(&file[80], &kTriangles, sizeof kTriangles);
  for (std::size_t i = 0; i < kTriangles; ++i) {
    std::memcpy(&file[84 + 50 * i + 12], &positions[9 * i], 36);
  }
  return seconds_of([&file] {
    const Result<ParsedFile> read = read_stl(bytes_of(file));
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().soup.positions.size(), 3 * kCount);
  });
}

double seconds_to_weld(const std::vector<float>& positions) {
  return seconds_of([&positions] {
    const Repaired welded({positions, {}, {}}, {.weld = 0});
    EXPECT_EQ(welded.mesh.vertex_count(), kCount);
  });
}

/// Welds each position with another one that is close to it.
double seconds_to_weld_twins(std::vector<float> positions) {
  const std::size_t count = positions.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    positions[3 * i] = 0;
    positions.insert(positions.end(),
                     {float(kTolerance / 2), positions[3 * i + 1], positions[3 * i + 2]});
  }
  return seconds_of([&] {
    const Repaired welded({positions, {}, {}}, {.weld = kTolerance});
    EXPECT_EQ(welded.mesh.vertex_count(), count);
  });
}

// Of so many times as long an attack would make a thousand.
constexpr double kNoSlower = 20;

TEST(HashAttack, MakesReadingStlNoSlower) {
  expect_at_most(
      kNoSlower, [] { return seconds_to_read_stl(ordinary()); },
      [] { return seconds_to_read_stl(colliding_in_stl()); });
}

TEST(HashAttack, MakesWeldingNoSlower) {
  expect_at_most(
      kNoSlower, [] { return seconds_to_weld(ordinary()); },
      [] { return seconds_to_weld(colliding_in_weld()); });
}

TEST(HashAttack, MakesWeldingWithinAToleranceNoSlower) {
  std::vector<float> others;
  for (std::size_t i = 0; i < kCount / 2; ++i) others.insert(others.end(), {0, float(i), 1});
  expect_at_most(
      kNoSlower, [&others] { return seconds_to_weld_twins(others); },
      [] { return seconds_to_weld_twins(colliding_in_near_weld()); });
}

TEST(HashAttack, MakesPlannedEdgesNoSlower) {
  const Edges ordinary = ordinary_edges();
  for (const Edges& edges : {colliding_edges(), edges_of_a_hub()}) {
    expect_at_most(
        kNoSlower, [&] { return seconds_to_plan(ordinary); },
        [&] { return seconds_to_plan(edges); });
  }
}

}  // namespace
}  // namespace halfedge::test
