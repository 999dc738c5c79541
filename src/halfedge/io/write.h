#pragma once

#include <halfedge/algorithms/adjacency.h>
#include <halfedge/attributes/attributes.h>
#include <halfedge/build/soup_attribute.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/inlining.h>
#include <halfedge/io/parse.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halfedge {

/// How the numbers of a file are written. kBinary is in the byte order that the format is defined
/// with: little-endian of PLY and STL, big-endian of OFF.
enum class Encoding : std::uint8_t { kText, kBinary, kBinaryBigEndian };

struct WriteOptions {
  /// Left open, text for OBJ and OFF, binary for PLY and STL.
  std::optional<Encoding> encoding = std::nullopt;
  /// Whether attributes are written, as far as the format has a place for them: see docs/files.md.
  bool attributes = true;
  /// Words for the numbers of `group`, `object` and `material`, as a reader of OBJ gives them; and
  /// as `library` the files of materials. Without them numbers are written.
  std::span<const SoupNames> names = {};
  /// Gets a sentence for each attribute that isn't in the file, or not as it was; and one if
  /// readers of STL will join vertices. Looking for those costs a pass over the positions.
  std::vector<std::string>* notes = nullptr;
};

/// What write() calls, whatever the mesh stores.
struct WriteSource {
  std::span<const float> positions;
  Adjacency faces;                 // their vertices
  Adjacency halfedges;             // that end at these; empty without attributes by halfedge
  Adjacency neighbours;            // by vertex, if polygons are to be cut; else empty
  Array<std::uint8_t> is_deleted;  // by vertex slot, not 0 if so; empty if there are none
  const Attributes* attributes = nullptr;  // null if they are left out
};
[[nodiscard]] Result<Array<std::uint8_t>> write_faces(const WriteSource& source, Format format,
                                                      const WriteOptions& options);
/// Whether a face has more than three corners.
[[nodiscard]] bool has_polygons(const Adjacency& faces);
namespace io {
[[nodiscard]] HALFEDGE_COLD Error no_memory_for_a_file();
}

/// The bytes of a file of this mesh: its live vertices and faces, each in the order of their
/// indices, a face from the vertex on that it was built from. Reading it gives the same polygons,
/// and the same bits of each position, also from text; and the same attributes, where the format
/// has a place for them. For meshes that store all links but, perhaps, prev.
///
/// Polygons stay polygons, but in STL, which has only triangles: there they are cut as
/// operations::triangulate does, also concave ones, and isolated vertices are left out. A face that
/// can't be cut without joining vertices a second time is cut all the same.
///
/// cost: one pass; the file, and 8 bytes for each corner of a face; for polygons in STL besides 16
/// bytes an edge and 16 to 32 a diagonal
/// errors: corrupt-connectivity, out-of-memory, unsupported-format (an encoding that the format
/// doesn't have), non-finite-position (in STL), too-large (more triangles than STL can count)
template <Storage kStored>
[[nodiscard]] Result<Array<std::uint8_t>> write(const BasicMesh<kStored>& mesh, Format format,
                                                const WriteOptions& options = {}) {
  WriteSource source;
  source.positions = mesh.positions();
  Result<void> rows = adjacency(mesh, Ring::kFaceVertices, Direction::kCcw, source.faces);
  if (!rows) return rows;
  if (options.attributes) source.attributes = &mesh.attributes();
  if (options.attributes && !mesh.attributes().of(ItemKind::kHalfedge).empty()) {
    rows = adjacency(mesh, Ring::kFaceHalfedges, Direction::kCcw, source.halfedges);
    if (!rows) return rows;
  }
  if (format == Format::kStl && has_polygons(source.faces)) {
    rows = adjacency(mesh, Ring::kVertexVertices, Direction::kCcw, source.neighbours);
    // Without neighbours faces are cut each for itself.
    if (!rows && rows.error().code == "out-of-memory") return rows;
  }
  if (mesh.vertex_count() < mesh.vertex_slots()) {
    if (!source.is_deleted.resize(mesh.vertex_slots())) return io::no_memory_for_a_file();
    for (Index v = 0; v < mesh.vertex_slots(); ++v) {
      source.is_deleted[v] = mesh.is_deleted(Vertex(v));
    }
  }
  return write_faces(source, format, options);
}

}  // namespace halfedge
