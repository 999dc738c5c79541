#pragma once

#include <halfedge/build/polygons.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/input.h"

namespace halfedge::fuzz {

/// Polygons that own their arrays.
struct Soup {
  std::vector<float> positions;
  std::vector<Index> sizes;
  std::vector<Index> corners;

  [[nodiscard]] Polygons view() const { return {positions, sizes, corners}; }
  [[nodiscard]] std::size_t items() const {
    return positions.size() + sizes.size() + corners.size();
  }
};

/// What may be wrong with all of a soup.
enum Oddity : std::uint8_t { kTriangles = 1, kLoseACoordinate = 2, kLoseACorner = 4 };

/// The rest of an input: number of vertices, three coordinates for each, then faces: the number of
/// corners, and a vertex for each.
inline Soup soup_of(Input& input, std::uint8_t oddities) {
  Soup soup;
  const std::size_t vertices = input.byte();
  for (std::size_t i = 0; i < 3 * vertices; ++i) soup.positions.push_back(input.coordinate());
  while (!input.used_up()) {
    const Index size = (oddities & kTriangles) != 0 ? 3 : input.byte() % 64;
    soup.sizes.push_back(size);
    for (Index i = 0; i < size; ++i) {
      const Index v = input.byte();
      soup.corners.push_back(v == 255 ? kNone : v);
    }
  }
  if ((oddities & kTriangles) != 0) soup.sizes.clear();
  if ((oddities & kLoseACoordinate) != 0 && !soup.positions.empty()) soup.positions.pop_back();
  if ((oddities & kLoseACorner) != 0 && !soup.corners.empty()) soup.corners.pop_back();
  return soup;
}

}  // namespace halfedge::fuzz
