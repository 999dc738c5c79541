#pragma once

#include <halfedge/io/byte_writer.h>
#include <halfedge/io/live_mesh.h>

#include <optional>
#include <span>

namespace halfedge::io {

/// What STL can't hold. `used` are the vertices of faces.
[[nodiscard]] std::optional<Error> check_stl(const LiveMesh& mesh, std::span<const Index> used);

/// Notes how many vertices are not among these, which STL can't hold, and how many of these are in
/// the same place as others, which readers join. False when memory is exhausted.
[[nodiscard]] bool note_vertices(const LiveMesh& mesh, std::span<const Index> used);

/// Writes the triangles of a mesh, and those that its polygons are cut into, as text or as
/// little-endian bytes.
void write_stl(const LiveMesh& mesh, Encoding encoding, ByteWriter& out);

}  // namespace halfedge::io
