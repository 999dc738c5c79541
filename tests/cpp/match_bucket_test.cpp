#include <gtest/gtest.h>
#include <halfedge/build/buckets.h>
#include <halfedge/build/groups.h>
#include <halfedge/build/match_bucket.h>
#include <halfedge/connectivity/array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "support/large_torus.h"

// Sides of triangles that are matched bucket by bucket: in meshes of any size, as it is done in
// large ones only.

namespace halfedge::test {
namespace {

using Corners = std::vector<Index>;

Index end_of(const Corners& corners, std::size_t side) {
  return corners[side % 3 == 2 ? side - 2 : side + 1];
}

/// The halfedge of each side, and where all halfedges lead to.
struct Matched {
  std::vector<Index> halfedge_of;
  std::vector<Index> to_vertex;
  friend bool operator==(const Matched&, const Matched&) = default;
};

/// As groups.h describes it, by searching: nothing where two sides are the same, or one is a loop.
std::optional<Matched> expected(const Corners& corners, Index vertices) {
  std::set<std::pair<Index, Index>> all;
  std::vector<std::vector<std::size_t>> ups(vertices), downs(vertices);
  for (std::size_t side = 0; side < corners.size(); ++side) {
    const Index from = corners[side];
    const Index to = end_of(corners, side);
    if (from == to || !all.insert({from, to}).second) return std::nullopt;
    (from < to ? ups[from] : downs[to]).push_back(side);
  }
  Matched result{std::vector<Index>(corners.size()), {}};
  const auto add_edge = [&](Index at, Index low, Index high) {
    result.to_vertex.resize(std::max<std::size_t>(result.to_vertex.size(), at + 2));
    result.to_vertex[at] = high;
    result.to_vertex[at + 1] = low;
  };
  std::vector<std::size_t> unforeseen;
  Index begin = 0;
  for (Index low = 0; low < vertices; ++low) {
    const Index end = begin + 2 * Index(std::max(ups[low].size(), downs[low].size()));
    std::map<Index, Index> edge_to;
    Index next = begin;
    for (const std::size_t side : ups[low]) {
      const Index high = end_of(corners, side);
      edge_to[high] = next;
      add_edge(next, low, high);
      result.halfedge_of[side] = next;
      next += 2;
    }
    for (const std::size_t side : downs[low]) {
      const Index high = corners[side];
      if (const auto found = edge_to.find(high); found != edge_to.end()) {
        result.halfedge_of[side] = found->second + 1;
      } else if (next < end) {
        add_edge(next, low, high);
        result.halfedge_of[side] = next + 1;
        next += 2;
      } else {
        unforeseen.push_back(side);
      }
    }
    begin = end;
  }
  for (const std::size_t side : unforeseen) {
    add_edge(begin, end_of(corners, side), corners[side]);
    result.halfedge_of[side] = begin + 1;
    begin += 2;
  }
  return result;
}

/// The same by buckets; nothing where they refuse.
std::optional<Matched> matched(const Corners& corners, Index vertices) {
  const std::vector<float> positions(3 * std::size_t{vertices});
  const Polygons triangles{positions, {}, corners};
  Groups groups;
  Array<Index> marks;
  bool repeated = false;
  EXPECT_TRUE(groups.count<true>(triangles, marks, repeated));
  Buckets buckets;
  (void)buckets.set_up(groups, vertices);  // which may say that they are too large

  const std::size_t places = groups.end();
  std::vector<Index> low_of(places), high_of(places), halfedge_of(places), slot_of;
  std::vector<Index> lists(corners.size() / 3);
  buckets.divide(triangles, lists, [&](Index slot, Index low, Index high) {
    low_of[slot] = low;
    high_of[slot] = high;
    slot_of.push_back(slot);
  });
  // What lies at places before anything is placed there must not be taken for a vertex.
  for (const Index before : {kNone, Index{0}, vertices - 1}) {
    std::vector<Index> to_vertex(places, before);
    Groups fresh;
    EXPECT_TRUE(fresh.count<true>(triangles, marks, repeated));
    BucketMatcher matcher(fresh, low_of.data(), high_of.data(), halfedge_of.data(),
                          to_vertex.data());
    Array<UnforeseenEdge> unforeseen;
    bool is_manifold = true;
    buckets.for_each_bucket([&](const Bucket& bucket) {
      is_manifold = is_manifold && matcher.match(bucket, unforeseen);
    });
    EXPECT_FALSE(matcher.is_out_of_memory());
    std::fill(marks.begin(), marks.end(), kNone);
    if (!is_manifold || !sort_unforeseen(unforeseen, marks)) {
      if (before == vertices - 1) return std::nullopt;
      continue;
    }
    for (const UnforeseenEdge& edge : unforeseen) {
      halfedge_of[edge.side] = Index(to_vertex.size()) + 1;
      to_vertex.insert(to_vertex.end(), {edge.high, edge.low});
    }
    Matched result{{}, to_vertex};
    for (const Index slot : slot_of) result.halfedge_of.push_back(halfedge_of[slot]);
    if (before == vertices - 1) return result;
  }
  return std::nullopt;
}

/// Whether the sides can be matched, as both agree on.
bool expect_as_described(const Corners& corners, Index vertices) {
  const std::optional<Matched> result = matched(corners, vertices);
  EXPECT_EQ(result, expected(corners, vertices)) << testing::PrintToString(corners);
  return result.has_value();
}

TEST(MatchBucket, AgreesOnUpToThreeTrianglesOfFiveVertices) {
  std::vector<std::array<Index, 3>> triangles;
  for (Index a = 0; a < 5; ++a) {
    for (Index b = 0; b < 5; ++b) {
      for (Index c = 0; c < 5; ++c) {
        if (a <= b && a <= c) triangles.push_back({a, b, c});
      }
    }
  }
  int taken = 0;
  int refused = 0;
  Corners corners;
  const auto add = [&](const auto& self, std::size_t first) -> void {
    if (!corners.empty()) (expect_as_described(corners, 5) ? taken : refused) += 1;
    if (corners.size() == 9) return;
    for (std::size_t i = first; i < triangles.size(); ++i) {
      corners.insert(corners.end(), triangles[i].begin(), triangles[i].end());
      self(self, i);
      corners.resize(corners.size() - 3);
    }
  };
  add(add, 0);
  EXPECT_GT(taken, 400);
  EXPECT_GT(refused, 5000);
}

TEST(MatchBucket, AgreesOnRandomTrianglesAroundFewVertices) {
  std::mt19937 random(std::random_device{}());
  const auto seed = random();
  random.seed(seed);
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  int taken = 0;
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    // The fewer vertices, the more often sides repeat each other.
    const Index vertices = 4 + random() % 600;
    const std::size_t count = 1 + random() % 60;
    const bool has_hub = random() % 2 == 0;
    Corners corners;
    for (std::size_t i = 0; i < 3 * count; ++i) {
      corners.push_back(has_hub && i % 3 == 0 ? vertices / 2 : Index(random() % vertices));
    }
    (expect_as_described(corners, vertices) ? taken : refused) += 1;
  }
  EXPECT_GT(taken, 200);
  EXPECT_GT(refused, 200);
}

TEST(MatchBucket, AgreesOnTheSidesOfATorusWithAndWithoutHoles) {
  for (const Index gap : {0U, 2U, 5U}) {
    const Triangles mesh = without_some(shuffled(large_torus(60), gap), gap);
    EXPECT_TRUE(expect_as_described(mesh.corners, Index(mesh.positions.size() / 3)));
  }
}

/// Groups of more sides than are looked at at once.
TEST(MatchBucket, AgreesOnFansOfAnyValence) {
  for (Index rim = 3; rim <= 70; ++rim) {
    for (const Index hub : {Index{0}, rim / 2, rim}) {
      Corners corners;
      for (Index i = 0; i < rim; ++i) {
        const auto name = [&](Index v) { return v < hub ? v : v + 1; };
        for (const Index v : {hub, name(i), name((i + 1) % rim)}) corners.push_back(v);
      }
      EXPECT_TRUE(expect_as_described(corners, rim + 1));
      Corners open(corners.begin() + 3, corners.end());
      EXPECT_TRUE(expect_as_described(open, rim + 1));
      open.insert(open.end(), corners.end() - 3, corners.end());
      EXPECT_FALSE(expect_as_described(open, rim + 1));  // the last face twice
    }
  }
}

}  // namespace
}  // namespace halfedge::test
