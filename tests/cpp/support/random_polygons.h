#pragma once

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/shapes.h"

namespace halfedge::test {

/// Whether two faces that share the directed edge a -> b of `left` have no other vertex in common,
/// so that they can be joined into one.
inline bool can_join(const std::vector<Index>& left, const std::vector<Index>& right) {
  const std::set<Index> of_left(left.begin(), left.end());
  return std::count_if(right.begin(), right.end(), [&](Index v) { return of_left.count(v) > 0; }) ==
         2;
}

/// `left` without its edge a -> b, and the rest of `right` in place of it.
inline std::vector<Index> joined(std::vector<Index> left, std::vector<Index> right, Index a,
                                 Index b) {
  std::rotate(left.begin(), std::find(left.begin(), left.end(), b), left.end());      // b ... a
  std::rotate(right.begin(), std::find(right.begin(), right.end(), a), right.end());  // a ... b
  left.insert(left.end(), right.begin() + 1, right.end() - 1);
  return left;
}

/// A manifold of faces with 3 to 12 or so corners, in random order and beginning at random corners,
/// over randomly numbered vertices: a torus some of whose quads are cut in two, some of whose faces
/// are joined, and some left out, which makes boundary loops, pinched and isolated vertices.
inline Shape random_polygons(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](std::size_t count) { return std::size_t(random()) % count; };

  // One draw a line: compilers evaluate arguments in different orders.
  const Index rows = Index(3 + below(8));
  const Index columns = Index(3 + below(8));
  const Shape base = torus(columns, rows);
  std::vector<std::vector<Index>> faces;
  const std::size_t cut_of_4 = below(5);
  for (const std::vector<Index>& quad : base.faces) {
    if (below(4) >= cut_of_4) {
      faces.push_back(quad);
    } else {
      const std::size_t i = below(2);
      faces.push_back({quad[i], quad[i + 1], quad[i + 2]});
      faces.push_back({quad[i], quad[i + 2], quad[(i + 3) % 4]});
    }
  }

  for (std::size_t tries = below(faces.size()); tries > 0; --tries) {
    std::map<std::pair<Index, Index>, std::size_t> owner;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (std::size_t i = 0; i < faces[f].size(); ++i) {
        owner[{faces[f][i], faces[f][(i + 1) % faces[f].size()]}] = f;
      }
    }
    const std::size_t left = below(faces.size());
    const std::size_t i = below(faces[left].size());
    const Index a = faces[left][i];
    const Index b = faces[left][(i + 1) % faces[left].size()];
    const std::size_t right = owner.at({b, a});
    if (!can_join(faces[left], faces[right])) continue;
    faces[left] = joined(faces[left], faces[right], a, b);
    faces.erase(faces.begin() + std::ptrdiff_t(right));
  }

  const std::size_t left_out_of_10 = below(8);
  const auto is_left_out = [&](const std::vector<Index>&) { return below(10) < left_out_of_10; };
  faces.erase(std::remove_if(faces.begin(), faces.end(), is_left_out), faces.end());

  std::vector<Index> number(base.vertices);
  for (Index v = 0; v < base.vertices; ++v) number[v] = v;
  if (below(2) == 0) std::shuffle(number.begin(), number.end(), random);
  for (std::vector<Index>& face : faces) {
    for (Index& v : face) v = number[v];
    std::rotate(face.begin(), face.begin() + std::ptrdiff_t(below(face.size())), face.end());
  }
  std::shuffle(faces.begin(), faces.end(), random);
  return {"random polygons, seed " + std::to_string(seed), base.vertices, std::move(faces)};
}

}  // namespace halfedge::test
