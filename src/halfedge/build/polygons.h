#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/inlining.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace halfedge {

/// A corner whose vertex doesn't exist, and whose number didn't fit into the 32 bits of a corner.
struct MissingVertex {
  /// In `corners`, of all faces.
  std::size_t corner = 0;
  /// As it was given: "10000000000".
  std::string name;
};

/// A list of them, whose special members are compiled once: soups are made in many places, and few
/// have such corners. They aren't marked as cold, as compilers would take every function that makes
/// a soup for cold, too.
class MissingVertices : public std::vector<MissingVertex> {
 public:
  HALFEDGE_NOINLINE MissingVertices();
  HALFEDGE_NOINLINE MissingVertices(MissingVertices&& other) noexcept;
  HALFEDGE_NOINLINE MissingVertices& operator=(MissingVertices&& other) noexcept;
  MissingVertices(const MissingVertices&) = delete;
  MissingVertices& operator=(const MissingVertices&) = delete;
  HALFEDGE_NOINLINE ~MissingVertices();

  HALFEDGE_COLD void add(std::size_t corner, std::string name);
};

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
  /// Corners that a repair names by a text instead, in ascending order; the first of each face is
  /// enough.
  std::span<const MissingVertex> missing = {};

  [[nodiscard]] std::size_t vertex_count() const { return positions.size() / 3; }
  [[nodiscard]] std::size_t face_count() const {
    return sizes.empty() ? corners.size() / 3 : sizes.size();
  }
  /// Whether each face has three corners. cost: O(faces), O(1) where `sizes` is empty
  [[nodiscard]] bool are_triangles() const;
};

/// The same, owning its arrays; what a reader makes of a file. `sizes` is empty if all faces are
/// triangles.
struct PolygonSoup {
  Array<float> positions;
  Array<Index> sizes;
  Array<Index> corners;
  MissingVertices missing = {};

  [[nodiscard]] Polygons view() const {
    return {positions.span(), sizes.span(), corners.span(), false, missing};
  }
};

}  // namespace halfedge
