#pragma once

#include <halfedge/algorithms/adjacency.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/io/parse.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstdint>
#include <optional>
#include <span>

namespace halfedge {

/// How the numbers of a file are written. kBinary is in the byte order that the format is defined
/// with: little-endian of PLY and STL, big-endian of OFF.
enum class Encoding : std::uint8_t { kText, kBinary, kBinaryBigEndian };

struct WriteOptions {
  /// Left open, text for OBJ and OFF, binary for PLY and STL.
  std::optional<Encoding> encoding = std::nullopt;
};

/// What write() calls, whatever the mesh stores. `is_deleted` has an element for each vertex slot
/// that isn't 0 for a deleted one, or is empty if there are none.
[[nodiscard]] Result<Array<std::uint8_t>> write_faces(std::span<const float> positions,
                                                      const Adjacency& faces,
                                                      std::span<const std::uint8_t> is_deleted,
                                                      Format format, const WriteOptions& options);

/// The bytes of a file of this mesh: its live vertices and faces, each in the order of their
/// indices, a face from the vertex on that it was built from. Reading it gives the same polygons,
/// and the same bits of each position, also from text.
///
/// Polygons stay polygons, but in STL, which has only triangles: there a polygon becomes a fan
/// around its first vertex, right for convex ones, and isolated vertices are left out.
///
/// cost: one pass; the file, and 8 bytes for each corner of a face
/// errors: corrupt-connectivity, out-of-memory, unsupported-format (an encoding that the format
/// doesn't have), non-finite-position (in STL), too-large (more triangles than STL can count)
template <Storage kStored>
[[nodiscard]] Result<Array<std::uint8_t>> write(const BasicMesh<kStored>& mesh, Format format,
                                                const WriteOptions& options = {}) {
  Adjacency faces;
  const Result<void> rows = adjacency(mesh, Ring::kFaceVertices, Direction::kCcw, faces);
  if (!rows) return rows.error();
  Array<std::uint8_t> deleted;
  if (mesh.vertex_count() < mesh.vertex_slots()) {
    if (!deleted.resize(mesh.vertex_slots())) {
      return Error{"out-of-memory", "memory was exhausted while a file was written"};
    }
    for (Index v = 0; v < mesh.vertex_slots(); ++v) deleted[v] = mesh.is_deleted(Vertex(v));
  }
  return write_faces(mesh.positions(), faces, deleted.span(), format, options);
}

}  // namespace halfedge
