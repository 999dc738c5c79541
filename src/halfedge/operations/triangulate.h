#pragma once

#include <halfedge/decorator/faces.h>
#include <halfedge/operations/face_plan.h>
#include <halfedge/operations/requirements.h>

#include <cstddef>
#include <span>

namespace halfedge::operations {

namespace internal {

template <class Mesh>
[[nodiscard]] std::span<const float> positions_of([[maybe_unused]] const Mesh& mesh) {
  if constexpr (HasPositions<Mesh>) return mesh.positions();
  return {};
}

/// The halfedges and neighbours of the corners of a face while it is cut up.
struct Corners {
  Array<Halfedge> into;
  Array<Index> next;
  Array<Index> prev;

  [[nodiscard]] bool reserve(std::size_t n) {
    return into.reserve(n) && next.reserve(n) && prev.reserve(n);
  }
};

/// Cuts the face of the loop of `first` at the corners listed from `ear` on, n - 3 of n. Returns
/// where the next face begins. pre: there is room for all of it
template <class Mesh>
const Index* cut_into_triangles(Mesh& mesh, Halfedge first, const Index* ear, Corners& corners) {
  corners.into.clear();
  for (const Halfedge h : mesh.loop_ccw(first)) (void)corners.into.push_back(h);
  const std::size_t n = corners.into.size();
  (void)corners.next.resize(n);
  (void)corners.prev.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    corners.next[i] = Index(i + 1 == n ? 0 : i + 1);
    corners.prev[i] = Index(i == 0 ? n - 1 : i - 1);
  }
  for (std::size_t left = n; left > 3; --left, ++ear) {
    const Index a = corners.prev[*ear];
    const Index b = corners.next[*ear];
    const Result<Halfedge> diagonal = decorator::split_face(mesh, corners.into[a], corners.into[b]);
    corners.into[b] = diagonal.value();
    corners.next[a] = b;
    corners.prev[b] = a;
  }
  return ear;
}

}  // namespace internal

/// Whether triangulate(f) can be done: else not-a-face; no-triangulation, if each way without a
/// fold joins two vertices that are joined already, of more than 32 corners each way that was
/// tried; out-of-memory. cost: as triangulate
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_triangulate(const Mesh& mesh, Face f) {
  if (Result<void> live = check_live(mesh, f); !live) return live;
  internal::FacePlan plan;
  return plan.add(mesh.links(), internal::positions_of(mesh), mesh.face_halfedge(f), false);
}

/// Cuts a face of degree n into n - 2 triangles, without new vertices. It may be concave, and
/// nearly planar only; the choice is told at PolygonTriangulator: no triangle folds over, and
/// diagonals are short. No two vertices are joined that are joined already. (CGAL:
/// triangulate_face)
///
/// attributes: the triangles have those of the face; a corner is divided into corners like it;
///             diagonals have the defaults
/// returns: the number of new faces, n - 3; f is one of the triangles
/// cost: O(n^3) up to 32 corners; of more O(n log n) and, for each corner, a look at the concave
///       ones. inverse: remove_edge of the new edges, in reverse order
/// errors: those of check_triangulate
template <EditableSurface Mesh>
[[nodiscard]] Result<Index> triangulate(Mesh& mesh, Face f) {
  using namespace refusals;
  using namespace steps;
  if (Result<void> live = check_live(mesh, f); !live) return live;
  internal::FacePlan plan;
  const Halfedge first = mesh.face_halfedge(f);
  if (Result<void> can = plan.add(mesh.links(), internal::positions_of(mesh), first, false); !can) {
    return can;
  }
  const Index added = Index(plan.ears().size());
  internal::Corners corners;
  if (!corners.reserve(plan.largest()) || !make_room(mesh, 0, added, added)) {
    return no_memory("the triangles");
  }
  internal::cut_into_triangles(mesh, first, plan.ears().begin(), corners);
  return added;
}

/// Whether triangulate() can be done: as check_triangulate(f) for all faces, which don't use a
/// diagonal twice either. Each face avoids those of the faces before it; up to 16 that are left no
/// way go before all others. Where more stand in each other's way, a mesh that could be cut may be
/// refused.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_triangulate(const Mesh& mesh) {
  internal::FacePlan plan;
  return internal::plan_all(mesh.links(), internal::positions_of(mesh), plan);
}

/// The same for all faces: afterwards the mesh is one of triangles. (CGAL: triangulate_faces)
///
/// returns: the number of new faces. cost: the sum over the faces, 16 to 32 bytes a diagonal
/// inverse: remove_edge of the new edges, in reverse order
/// errors: those of check_triangulate; nothing has changed then
template <EditableSurface Mesh>
[[nodiscard]] Result<Index> triangulate(Mesh& mesh) {
  using namespace refusals;
  using namespace steps;
  internal::FacePlan plan;
  if (Result<void> can = internal::plan_all(mesh.links(), internal::positions_of(mesh), plan);
      !can) {
    return can;
  }
  const std::size_t added = plan.ears().size();
  internal::Corners corners;
  if (added > kMaxSlots || !corners.reserve(plan.largest()) ||
      !make_room(mesh, 0, Index(added), Index(added))) {
    return no_memory("the triangles");
  }
  const Index* ear = plan.ears().begin();
  for (const Halfedge first : plan.loops()) {
    ear = internal::cut_into_triangles(mesh, first, ear, corners);
  }
  return Index(added);
}

}  // namespace halfedge::operations
