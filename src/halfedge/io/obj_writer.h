#pragma once

#include <halfedge/build/soup_attribute.h>
#include <halfedge/io/byte_writer.h>
#include <halfedge/io/live_mesh.h>

#include <span>

namespace halfedge::io {

/// Writes an OBJ file: `color` of vertices behind their positions, `uv` and `normal` of halfedges,
/// or else of vertices, as vt and vn, `group`, `object` and `material` of faces as statements with
/// their names, or their numbers.
void write_obj(const LiveMesh& mesh, std::span<const SoupNames> names, ByteWriter& out);

}  // namespace halfedge::io
