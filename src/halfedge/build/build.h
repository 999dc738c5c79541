#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/convert.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstddef>
#include <vector>

namespace halfedge {

/// What a strict build found wrong: first the sizes of the arrays (if these are wrong, nothing
/// else), then positions by vertex, faces by themselves and repeated faces by face, edges by their
/// smaller vertex, vertices. Witnesses hold input indices.
struct BuildReport {
  /// At most kMaxListed of them, one sentence each.
  std::vector<Error> problems;
  /// All of them, listed or not.
  std::size_t problem_count = 0;

  static constexpr std::size_t kMaxListed = 1000;
};

/// Makes `mesh` the mesh of these polygons: vertex i and face j are vertex i and face j of the
/// input. Strict: what is not an oriented 2-manifold with or without boundary is refused, with a
/// sentence and a witness for each problem, and `mesh` is left empty.
///
/// Independent of the order of faces, and never crashes, whatever the input. Anchors: of a boundary
/// vertex its boundary halfedge; of an interior one its halfedge in the incident face with the
/// highest index. face_halfedge of a face v0..vn-1 is the halfedge v(n-1) -> v0. Edges are numbered
/// grouped by their smaller vertex, for locality, but for some boundary edges, which come last. A
/// pinched vertex is accepted when boundary halfedges join its fans; they are then ordered by the
/// index of the vertex their boundary halfedge points to, and the first is the anchor.
///
/// pre: `polygons` doesn't view the arrays of `mesh`
/// Memory of `mesh` is reused if it suffices, and exactly what is needed where it doesn't; peak
/// beyond the mesh is at most 8 bytes a vertex, and 12 for some of the boundary edges, which are
/// given back before positions are copied.
/// cost: O(vertices + corners); O(n log n) for the fans of a pinched vertex, and for a refusal
///
/// Codes: index-out-of-range, non-finite-position, bad-size (of an array), degree-below-three,
/// repeated-vertex, duplicate-face, edge-with-many-faces, opposite-orientation, pinched-vertex,
/// too-large, out-of-memory.
[[nodiscard]] bool build_from_polygons(Mesh& mesh, const Polygons& polygons, BuildReport& report);

/// The same without prev, in less memory.
[[nodiscard]] bool build_from_polygons(BasicMesh<kWithoutPrev>& mesh, const Polygons& polygons,
                                       BuildReport& report);
/// The same with prev or without, as `mesh` has chosen.
[[nodiscard]] bool build_from_polygons(BasicMesh<kPrevAtRunTime>& mesh, const Polygons& polygons,
                                       BuildReport& report);

/// The same for a mesh type that leaves other links out, by way of a full mesh.
template <Storage kStored>
[[nodiscard]] bool build_from_polygons(BasicMesh<kStored>& mesh, const Polygons& polygons,
                                       BuildReport& report) {
  return build_whole(mesh,
                     [&](Mesh& whole) { return build_from_polygons(whole, polygons, report); });
}

}  // namespace halfedge
