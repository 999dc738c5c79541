#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "support/sweep.h"

namespace halfedge::test {

inline std::set<std::pair<Index, Index>> edges_of(const Polys& faces) {
  std::set<std::pair<Index, Index>> edges;
  for (const std::vector<Index>& face : faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      edges.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
    }
  }
  return edges;
}

/// How many fans the faces at the vertices form, all together; 0 if a vertex or edge isn't manifold
/// or a face has a vertex twice.
inline std::size_t count_fans(const Polys& faces) {
  std::map<Index, std::map<Index, Index>>
      turns;  // at a vertex: from the one before to the one after
  for (const std::vector<Index>& face : faces) {
    if (std::set<Index>(face.begin(), face.end()).size() < face.size()) return 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index after = face[(i + 1) % face.size()];
      const Index before = face[(i + face.size() - 1) % face.size()];
      if (!turns[face[i]].emplace(after, before).second) return 0;
    }
  }
  std::size_t fans = 0;
  for (auto& [v, around] : turns) {
    std::set<Index> ends;
    for (const auto& [after, before] : around) {
      if (!ends.insert(before).second) return 0;
    }
    std::size_t open = 0;
    for (const auto& [after, before] : around) open += ends.count(after) == 0 ? 1 : 0;
    fans += open;
    std::size_t reached = 0;
    for (const auto& [after, before] : around) {
      if (ends.count(after) > 0) continue;
      ++reached;
      for (Index at = before; around.count(at) > 0; at = around[at]) ++reached;
    }
    if (reached == around.size()) continue;
    if (open > 0) return 0;  // a closed fan beside an open one
    Index at = around.begin()->first;
    do {
      ++reached;
      at = around[at];
    } while (at != around.begin()->first);
    if (reached != around.size()) return 0;  // two closed fans
    ++fans;
  }
  return fans;
}

}  // namespace halfedge::test
