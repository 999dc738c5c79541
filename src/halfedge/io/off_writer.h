#pragma once

#include <halfedge/io/byte_writer.h>
#include <halfedge/io/live_mesh.h>

namespace halfedge::io {

/// Writes an OFF file: `normal`, `color` and `uv` of vertices behind their positions, `color` of
/// faces behind their vertices. Text has colours as floats or as integers, binary as floats only.
void write_off(const LiveMesh& mesh, Encoding encoding, ByteWriter& out);

}  // namespace halfedge::io
