#pragma once

#include <halfedge/connectivity/handle.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace halfedge::internal {

/// A face as a list of vertices that doesn't depend on where it starts or which way it runs: from
/// its smallest vertex towards the smaller neighbour of that. A view: `corners` stay the caller's.
struct Cycle {
  std::span<const Index> corners;
  std::size_t start = 0;  // of the smallest, in `corners`
  bool reversed = false;  // it runs the other way than `corners`

  explicit Cycle(std::span<const Index> vertices) : corners(vertices) {
    start = std::size_t(std::min_element(corners.begin(), corners.end()) - corners.begin());
    reversed = at(corners.size() - 1) < at(1);
  }
  [[nodiscard]] Index at(std::size_t i) const {
    const std::size_t n = corners.size();
    return corners[(start + (reversed ? n - i : i)) % n];
  }
};

/// -1, 0, 1 as for strings, shorter ones first. 0 for faces with the same vertices in the same
/// cyclic order, in either orientation. cost: O(n)
[[nodiscard]] inline int compare(const Cycle& a, const Cycle& b) {
  if (a.corners.size() != b.corners.size()) return a.corners.size() < b.corners.size() ? -1 : 1;
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    if (a.at(i) != b.at(i)) return a.at(i) < b.at(i) ? -1 : 1;
  }
  return 0;
}

}  // namespace halfedge::internal
