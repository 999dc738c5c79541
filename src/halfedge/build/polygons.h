#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <span>

namespace halfedge {

/// Faces over shared vertices, as files and index buffers hold them; a view, owning nothing.
struct Polygons {
  /// 3 floats for each vertex, xyz interleaved.
  std::span<const float> positions;
  /// The number of corners of each face. Left empty, all faces are triangles.
  std::span<const Index> sizes;
  /// The vertex of each corner, face after face, counter-clockwise within a face.
  std::span<const Index> corners;
  /// Corners from 2^31 stand for the negative numbers with the same 32 bits: a repair names these.
  /// No mesh has such a vertex either way.
  bool has_negative = false;

  [[nodiscard]] std::size_t vertex_count() const { return positions.size() / 3; }
  [[nodiscard]] std::size_t face_count() const {
    return sizes.empty() ? corners.size() / 3 : sizes.size();
  }
};

/// The same, owning its arrays; what a reader makes of a file. `sizes` is empty if all faces are
/// triangles.
struct PolygonSoup {
  Array<float> positions;
  Array<Index> sizes;
  Array<Index> corners;
  bool has_negative = false;

  [[nodiscard]] Polygons view() const {
    return {positions.span(), sizes.span(), corners.span(), has_negative};
  }
};

}  // namespace halfedge
