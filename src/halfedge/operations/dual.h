#pragma once

#include <halfedge/algorithms/array_sizes.h>
#include <halfedge/algorithms/rings.h>
#include <halfedge/build/build.h>
#include <halfedge/build/polygons.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <span>
#include <utility>

namespace halfedge {

/// Where the items of a mesh are in its dual, by slot; kNone for deleted ones.
struct DualMaps {
  Array<Index> vertices;  // the face around each vertex; kNone also for those on the boundary
  Array<Index> faces;     // the vertex in each face
};

/// The dual as polygons, and the maps; what `dual` calls.
struct DualPlan {
  PolygonSoup polygons;
  DualMaps maps;
};
[[nodiscard]] Result<DualPlan> plan_dual(const RawLinks& links, std::span<const float> positions);

/// Makes `out` the dual of `mesh`, which may be the same: a vertex in the centroid of each face,
/// and around each interior vertex a face, which has its corners in the faces around that vertex
/// and is counter-clockwise as they are. Vertex i of the dual is in the i-th live face, face j
/// around the j-th live vertex that is not on the boundary. Boundary vertices get no face, isolated
/// vertices nothing; a face of which all corners are on the boundary becomes an isolated vertex.
///
/// The dual of the dual of a closed mesh has the connectivity of the mesh, with its vertices and
/// faces in the same order, but a face may begin at another corner. Attributes aren't carried over.
/// After an error `out` is empty, or as it was if `mesh` itself is refused.
///
/// cost: O(slots), and building
/// errors: where the dual is no polygon mesh: degree-below-three (an interior vertex of valence 1
/// or 2), duplicate-edge (two faces that share two edges), same-face-twice (an edge with one face
/// on both sides), pinched-vertex (a face whose interior corners are not side by side); and
/// corrupt-connectivity, non-finite-position (of a centroid), out-of-memory
template <Storage kStored, Storage kOut>
[[nodiscard]] Result<DualMaps> dual(const BasicMesh<kStored>& mesh, BasicMesh<kOut>& out) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  Result<DualPlan> plan = plan_dual(RawLinks(mesh), mesh.positions());
  if (!plan) return plan;
  BuildReport report;
  if (!build_from_polygons(out, plan.value().polygons.view(), report)) return report.problems[0];
  return std::move(plan.value().maps);
}

/// Whether dual(mesh) can be made: else the errors of `dual`, out-of-memory among them, as it is
/// made and dropped. cost: that of `dual`
template <Storage kStored>
[[nodiscard]] Result<void> check_dual(const BasicMesh<kStored>& mesh) {
  BasicMesh<kPrevAtRunTime> made;
  made.choose_prev(false);
  Result<DualMaps> maps = dual(mesh, made);
  if (!maps) return maps;
  return {};
}

}  // namespace halfedge
