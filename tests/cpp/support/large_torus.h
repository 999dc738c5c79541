#pragma once

#include <halfedge/build/build.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace halfedge::test {

struct Triangles {
  std::vector<float> positions;
  std::vector<Index> corners;

  [[nodiscard]] Polygons polygons() const { return {positions, {}, corners}; }
};

/// A torus of `size` times `size` squares that are cut in two, with a hole here and there.
inline Triangles large_torus(Index size) {
  Triangles torus{std::vector<float>(3 * std::size_t{size} * size), {}};
  for (Index y = 0; y < size; ++y) {
    for (Index x = 0; x < size; ++x) {
      const auto at = [size](Index i, Index j) { return j % size * size + i % size; };
      const Index square[] = {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)};
      torus.corners.insert(torus.corners.end(), {square[0], square[1], square[2]});
      if (torus.corners.size() % 3003 == 0) torus.corners.resize(torus.corners.size() - 3);
      torus.corners.insert(torus.corners.end(), {square[2], square[3], square[0]});
    }
  }
  return torus;
}

/// The triangles in random order, and other numbers for the vertices.
inline Triangles shuffled(const Triangles& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Index> names(mesh.positions.size() / 3);
  std::iota(names.begin(), names.end(), 0U);
  std::shuffle(names.begin(), names.end(), random);
  std::vector<Index> order(mesh.corners.size() / 3);
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  Triangles result{mesh.positions, {}};
  for (const Index f : order) {
    for (Index i = 0; i < 3; ++i) result.corners.push_back(names[mesh.corners[3 * f + i]]);
  }
  return result;
}

}  // namespace halfedge::test
