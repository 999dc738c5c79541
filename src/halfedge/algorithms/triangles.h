#pragma once

#include <halfedge/algorithms/array_sizes.h>
#include <halfedge/algorithms/rings.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/item_span.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace halfedge {

/// What names the corners of triangles: their vertices, as in an index buffer, or the halfedges of
/// the mesh that end in them, to which the values of corners belong.
enum class CornersAs : std::uint8_t { kVertices, kHalfedges };

/// The faces of a mesh as triangles.
struct TriangleList {
  Array<Index> corners;  // three for each triangle, counter-clockwise
  Array<Index> faces;    // by triangle: the face that it is a part of
};

/// What the functions below call, whichever links the mesh stores. Without `faces` of all of them,
/// for which `expected` triangles are made room for at first.
[[nodiscard]] Result<TriangleList> to_triangles(const RawLinks& links,
                                                std::span<const float> positions,
                                                CornersAs corners_as, std::size_t expected,
                                                std::optional<std::span<const Index>> faces);

/// The triangles of all faces, in ascending order: n - 2 of a face of degree n, none of the faces
/// of loops and segments. Larger faces may be concave, and nearly planar only: they are cut as
/// PolygonTriangulator tells, a quad along its shorter diagonal; none folds over.
///
/// The mesh is not changed, and none is refused: each face is cut for itself, also where
/// `operations::triangulate` would avoid a diagonal since its ends are joined already. (Blender:
/// corner triangles)
///
/// cost: O(slots), and what `triangulate` takes for faces of more than four corners; 16 bytes a
///       triangle
/// errors: corrupt-connectivity, out-of-memory
template <Storage kStored>
[[nodiscard]] Result<TriangleList> to_triangles(const BasicMesh<kStored>& mesh,
                                                CornersAs corners_as = CornersAs::kVertices) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  const std::size_t halfedges = 2 * std::size_t{mesh.edge_count()};
  const std::size_t faces = mesh.face_count();  // two corners of each make no triangle
  return to_triangles(RawLinks(mesh), mesh.positions(), corners_as,
                      halfedges > 2 * faces ? halfedges - 2 * faces : 0, std::nullopt);
}

/// The same of the live ones among `faces`, in that order; others have no triangles. A face may be
/// named more than once.
template <Storage kStored>
[[nodiscard]] Result<TriangleList> to_triangles(const BasicMesh<kStored>& mesh,
                                                ItemSpan<Face> faces,
                                                CornersAs corners_as = CornersAs::kVertices) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  return to_triangles(RawLinks(mesh), mesh.positions(), corners_as, faces.size(), faces.indices());
}

}  // namespace halfedge
