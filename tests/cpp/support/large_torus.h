#pragma once

#include <halfedge/build/build.h>
#include <halfedge/shapes/shapes.h>

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

/// A torus of `size` times `size` squares that are cut in two, without every 1001st triangle.
inline Triangles large_torus(Index size) {
  const PolygonSoup whole = shapes::torus(size, size, shapes::Faces::kTriangles).value();
  Triangles torus{{whole.positions.begin(), whole.positions.end()}, {}};
  for (std::size_t f = 0; 3 * f < whole.corners.size(); ++f) {
    if (f % 1001 == 500) continue;
    const Index* const corners = &whole.corners[3 * f];
    torus.corners.insert(torus.corners.end(), corners, corners + 3);
  }
  return torus;
}

/// Without every so many-th triangle; with all of them if that is 0.
inline Triangles without_some(const Triangles& mesh, Index every) {
  if (every == 0) return mesh;
  Triangles rest{mesh.positions, {}};
  for (std::size_t corner = 0; corner < mesh.corners.size(); ++corner) {
    if (corner / 3 % every != 0) rest.corners.push_back(mesh.corners[corner]);
  }
  return rest;
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
