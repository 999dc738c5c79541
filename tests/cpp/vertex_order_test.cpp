#include <gtest/gtest.h>
#include <halfedge/algorithms/vertex_order.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::vector<Index> listed(const Result<Array<Index>>& order) {
  EXPECT_TRUE(order.ok());
  return {order.value().begin(), order.value().end()};
}

/// Of points that all are live vertices.
std::vector<Index> morton(const std::vector<float>& positions) {
  return listed(morton_order(positions, Links{}));
}

/// The definition, in steps: the box, the cell, its bits in turn from the highest on.
std::vector<Index> morton_by_definition(const std::vector<float>& positions) {
  std::array<double, 3> least = {1e300, 1e300, 1e300};
  std::array<double, 3> most = {-1e300, -1e300, -1e300};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    least[i % 3] = std::min(least[i % 3], double(positions[i]));
    most[i % 3] = std::max(most[i % 3], double(positions[i]));
  }
  const double longest = std::max({most[0] - least[0], most[1] - least[1], most[2] - least[2]});
  const auto place = [&](Index v) {
    std::vector<bool> bits;
    for (int bit = 20; bit >= 0; --bit) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double cells = (positions[3 * v + axis] - least[axis]) / longest * 2097152;
        bits.push_back((std::min(std::uint64_t(cells), std::uint64_t{2097151}) >> bit & 1U) != 0);
      }
    }
    return bits;
  };
  std::vector<Index> order(positions.size() / 3);
  for (Index v = 0; v < order.size(); ++v) order[v] = v;
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return place(a) < place(b); });
  return order;
}

TEST(MortonOrder, GoesThroughTheEightPartsOfABoxInTurn) {
  const std::vector<float> corners = {1, 1, 1, 0, 0, 0, 1, 0, 1, 0, 1, 0,
                                      0, 0, 1, 1, 0, 0, 0, 1, 1, 1, 1, 0};
  EXPECT_EQ(morton(corners), (std::vector<Index>{1, 4, 3, 6, 5, 2, 7, 0}));
}

TEST(MortonOrder, IsThatOfItsDefinition) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<float> positions(3 * (1 + random() % 400));
    // Powers of two only, so that both divide exactly: the box is [-2048, 2048] in each direction.
    for (float& p : positions) p = float(random() % 4096) - 2048;
    positions.insert(positions.end(), {-2048, 0, 0, 2048, 0, 0});
    EXPECT_EQ(morton(positions), morton_by_definition(positions));
  }
}

TEST(MortonOrder, KeepsTheOrderOfPointsInOneCell) {
  EXPECT_EQ(morton({7, 7, 7, 7, 7, 7, 7, 7, 7}), (std::vector<Index>{0, 1, 2})) << "all equal";
  EXPECT_EQ(morton({5, 5, 5, 1, 1, 1, 5, 5, 5, 1, 1, 1}), (std::vector<Index>{1, 3, 0, 2}));
  EXPECT_TRUE(morton({}).empty());
  EXPECT_EQ(morton({3, 1, 2}), std::vector<Index>{0});
}

TEST(MortonOrder, TakesPositionsThatAreNotFiniteForTheSidesOfTheBox) {
  const std::vector<float> positions = {3, 0,    0, kInfinity, 0, 0, 2, 0, 0, -kInfinity, 0,
                                        0, kNan, 0, 0,         1, 0, 0, 0, 0, 0};
  EXPECT_EQ(morton(positions), (std::vector<Index>{3, 4, 6, 5, 2, 0, 1}));
  EXPECT_EQ(morton({kNan, kNan, kNan, kInfinity, 0, kNan, -kInfinity, 0, 0}),
            (std::vector<Index>{0, 1, 2}))
      << "no box";
  constexpr float kMost = std::numeric_limits<float>::max();
  EXPECT_EQ(morton({kMost, 0, 0, -kMost, 0, 0, 0, 0, 0}), (std::vector<Index>{1, 2, 0}))
      << "the length of the box is no float";
  constexpr float kLeast = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(morton({2 * kLeast, 0, 0, 0, 0, 0, kLeast, 0, 0}), (std::vector<Index>{1, 2, 0}));
}

TEST(MortonOrder, SortsWhatLiesCloseTogetherAlsoWhenOnePointLiesFarOff) {
  std::vector<float> positions;
  for (Index i = 0; i < 1000; ++i) positions.insert(positions.end(), {float(i * 7 % 1000), 0, 0});
  positions.insert(positions.end(), {1e6F, 1e6F, 1e6F});
  const std::vector<Index> order = morton(positions);
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(positions[3 * order[i]], float(i));
}

TEST(MortonOrder, LeavesDeletedVerticesOutOfTheBoxToo) {
  Mesh mesh;
  for (const float x : {3.0F, 1e30F, 1.0F, 0.0F}) ASSERT_TRUE(mesh.add_vertex({x, 0, 0}).valid());
  mesh.release(Vertex(1));
  EXPECT_EQ(listed(morton_order(mesh.positions(), mesh.links())), (std::vector<Index>{3, 2, 0}));
}

/// The definition: a queue, rings in the order of the circulator.
std::vector<Index> breadth_first_by_definition(const Mesh& mesh) {
  std::vector<Index> order;
  std::set<Vertex> seen;
  for (const Vertex seed : mesh.vertices()) {
    std::deque<Vertex> queue;
    if (seen.insert(seed).second) queue.push_back(seed);
    for (; !queue.empty(); queue.pop_front()) {
      order.push_back(queue.front().index());
      for (const Vertex w : mesh.vertex_vertices_cw(queue.front())) {
        if (seen.insert(w).second) queue.push_back(w);
      }
    }
  }
  return order;
}

TEST(BreadthFirstOrder, IsThatOfAQueue) {
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < 30; ++seed) shapes.push_back(random_polygons(seed));
  for (const Shape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    Mesh mesh = reference_build(shape);
    (void)mesh.add_vertex({});
    mesh.release(mesh.add_vertex({}));
    (void)mesh.add_vertex({});
    EXPECT_EQ(listed(breadth_first_order(mesh.links())), breadth_first_by_definition(mesh));
  }
}

TEST(BreadthFirstOrder, ListsEachLiveVertexOnceWhateverTheLinksAre) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE("round " + std::to_string(i));
    Mesh mesh = reference_build(torus(4, 3, 1));
    Links& links = mesh.mutable_links();
    for (int writes = 0; writes < 5; ++writes) {
      for (Array<Index>* array : {&links.next, &links.to_vertex}) {
        (*array)[random() % array->size()] = Index(random() % 2 == 0 ? random() : random() % 24);
      }
      Index& anchor = links.vertex_halfedge[random() % 12];
      if (!is_deleted_link(anchor)) anchor = Index(random() % 100);
    }
    std::vector<Index> order = listed(breadth_first_order(links));
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  }
}

}  // namespace
}  // namespace halfedge::test
