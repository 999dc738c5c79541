#pragma once

#include <halfedge/io/byte_writer.h>
#include <halfedge/io/live_mesh.h>

namespace halfedge::io {

/// Writes a PLY file with all attributes that it can hold: those of vertices and faces, under the
/// usual names of properties for `normal`, `color` and `uv`, and `uv` of halfedges as `texcoord`.
void write_ply(const LiveMesh& mesh, Encoding encoding, ByteWriter& out);

}  // namespace halfedge::io
