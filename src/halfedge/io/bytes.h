#pragma once

#include <halfedge/attributes/attributes.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/storage.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <array>
#include <cstdint>
#include <span>

/// A mesh as bytes, to the last word: unlike a file of polygons they hold deleted slots and their
/// chains, the numbering of edges, anchors, attributes. For keeping a mesh, or sending it to a
/// worker; for meshes that store all links but, perhaps, prev.
///
/// All numbers are little-endian; sections begin at multiples of 8 bytes, padded with zeros:
///
///   0   8 characters  "halfedge"
///   8   uint32        version of this format, 1
///   12  uint32        1 if the mesh stores prev, else 0
///   16  uint32[3]     slots of vertices, halfedges, faces
///   28  uint32[6]     chains of deleted vertices, edges, faces: the first one, and how many
///   52  uint32        number of sections, at most 4096
///   56  sections      4 characters, 4 bytes of zeros, uint64 length in bytes, and so many bytes:
///
///   "next" "prev" "to-v" "face"  uint32 for each halfedge; prev only if it is stored
///   "v-he"  uint32 for each vertex            "f-he"  uint32 for each face
///   "posi"  float32, three for each vertex
///   "attr"  for each attribute: uint32[5] kind of item (vertex, halfedge, edge, face), type
///           (float32, float64, int8, uint8, int16, uint16, int32, uint32), components, on-split
///           (interpolate, normalize, copy, default, copy-corner), length of the name; the name in
///           UTF-8 up to the next multiple of 8; the default likewise; a value for each slot
namespace halfedge {

/// What to_bytes calls, whatever the mesh stores.
struct BytesSource {
  const Links& links;
  std::span<const float> positions;
  std::array<FreeList, 3> free;  // vertices, edges, faces
  const Attributes& attributes;
  bool stores_prev;
};
[[nodiscard]] Result<Array<std::uint8_t>> to_bytes(const BytesSource& source);

/// The bytes of a mesh, whatever state it is in. History isn't part of them, and generations
/// aren't. cost: one pass over all arrays, and the bytes
/// errors: too-large (more attributes than the bytes can number), out-of-memory
template <Storage kStored>
[[nodiscard]] Result<Array<std::uint8_t>> to_bytes(const BasicMesh<kStored>& mesh) {
  static_assert(kStored.face && kStored.face_halfedge && kStored.vertex_halfedge,
                "bytes hold all links but prev (StoresSurface)");
  return to_bytes(BytesSource{mesh.links(),
                              mesh.positions(),
                              {mesh.free_vertices(), mesh.free_edges(), mesh.free_faces()},
                              mesh.attributes(),
                              mesh.stores_prev()});
}

/// Where bytes come from: those that another thread of this very program has just made need not be
/// checked once more.
enum class BytesFrom : std::uint8_t { kAnywhere, kThisProgram };

/// Whether the mesh in these bytes stores prev. errors: as from_bytes, of the first 56 bytes
[[nodiscard]] Result<bool> stores_prev(std::span<const std::uint8_t> bytes);

/// Makes `mesh` the one that these bytes were made of; its history is off. The bytes may be
/// anything: all that a mesh needs to be safe is checked, the invariants up to level 2 of
/// `validate` included, unless `from` says that this is known. After an error `mesh` is as it was.
/// cost: O(bytes), most of it for the checks; beside the mesh, what `validate` takes
/// errors: unknown-format (these are no such bytes), unsupported-version, truncated, parse-error
///         (with what was expected at which byte), storage-mismatch (prev is stored and `mesh` has
///         none, or the reverse; kPrevAtRunTime chooses what the bytes have),
///         corrupt-connectivity, attribute-exists, bad-attribute, out-of-memory
template <Storage kStored>
requires StoresSurface<BasicMesh<kStored>>
[[nodiscard]] Result<void> from_bytes(std::span<const std::uint8_t> bytes, BasicMesh<kStored>& mesh,
                                      BytesFrom from = BytesFrom::kAnywhere);

}  // namespace halfedge
