#pragma once

#include <halfedge/build/each_face.h>
#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

#include <algorithm>
#include <cstddef>

namespace halfedge {

/// The halfedges set aside for each vertex. A side of a face *runs up* if it leads from the smaller
/// vertex of its edge to the larger. No two sides of an edge run the same way, so a vertex has at
/// least as many edges to larger vertices as sides run up from it. That many are its *group*:
/// [begin[v], begin[v + 1]) are their halfedges.
struct Groups {
  /// A group of more halfedges than this, two for each edge, is too large to be searched.
  static constexpr Index kSearched = 32;

  Array<Index> begin;
  /// The halfedges of all groups that are too large.
  Index in_large = 0;

  [[nodiscard]] Index end() const { return begin[begin.size() - 1]; }
};

/// Sets up the groups; `repeated` tells whether a face has a vertex twice. `last_face` is scratch,
/// and has one entry for each vertex after that. False when memory is exhausted.
template <bool kTriangles>
[[nodiscard]] bool count_groups(const Polygons& polygons, Array<Index>& last_face, Groups& groups,
                                bool& repeated) {
  const std::size_t vertices = polygons.vertex_count();
  if (!groups.begin.recreate(vertices + 1) || !last_face.recreate(vertices)) return false;
  std::fill(groups.begin.begin(), groups.begin.end(), 0U);
  if (!kTriangles) std::fill(last_face.begin(), last_face.end(), kNone);

  Index* const count = groups.begin.data();
  Index* const last = last_face.data();
  Index repeats = 0;
  for_each_face<kTriangles>(
      polygons, [=, &repeats]([[maybe_unused]] Index f, const Index* corners, auto size) {
        if constexpr (kTriangles) {
          const Index a = corners[0];
          const Index b = corners[1];
          const Index c = corners[2];
          repeats |= Index{a == b} | Index{b == c} | Index{c == a};
        }
        for (Index i = 0; i < size; ++i) {
          const Index from = corners[i];
          const Index to = corners[i + 1 == size ? 0 : i + 1];
          count[from] += from < to ? 2U : 0U;
          if constexpr (!kTriangles) {
            repeats |= Index{last[from] == f};
            last[from] = f;
          }
        }
      });
  repeated = repeats != 0;

  Index sum = 0;
  for (Index& entry : groups.begin) {
    const Index size = entry;
    entry = sum;
    sum += size;
    groups.in_large += size > Groups::kSearched ? size : 0;
  }
  return true;
}

}  // namespace halfedge
