#pragma once

#include <halfedge/algorithms/array_sizes.h>
#include <halfedge/algorithms/rings.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/connectivity.h>
#include <halfedge/result.h>

#include <cstdint>
#include <span>

/// Circulators for many items at once: what `for` loops over them would collect, in one call and in
/// flat arrays. Items come in exactly the order of the circulator of the same name.
///
/// These functions check what they follow: on a mesh that breaks its invariants they return an
/// error with the code corrupt-connectivity, they don't hang or write out of bounds.
namespace halfedge {

/// A kind of circulator: around what, and what it lists.
enum class Ring : std::uint8_t {
  kVertexVertices,
  kVertexOutgoing,
  kVertexIncoming,
  kVertexEdges,
  kVertexFaces,
  kFaceVertices,
  kFaceHalfedges,
  kFaceEdges,
  kFaceFaces,
  kEdgeVertices,
  kEdgeHalfedges,
  kEdgeFaces,
};

/// As seen from the side from which faces are counter-clockwise. Rings of edges have none: they
/// list side 0 first in both.
enum class Direction : std::uint8_t { kCcw, kCw };

/// Rows of indices, compressed: row i is items[offsets[i]] to items[offsets[i + 1] - 1].
struct Adjacency {
  Array<Index> offsets;
  Array<Index> items;

  void clear() {
    offsets.clear();
    items.clear();
  }
};

/// What the functions below call, whichever links the mesh stores.
[[nodiscard]] Result<void> adjacency(const RawLinks& links, Ring ring, Direction direction,
                                     Adjacency& out);
[[nodiscard]] Result<void> adjacency(const RawLinks& links, Ring ring, Direction direction,
                                     std::span<const Index> centres, Adjacency& out);
[[nodiscard]] Result<Index> write_ring(const RawLinks& links, Ring ring, Direction direction,
                                       Index centre, std::span<Index> out);

/// One row for each slot of the ring's centre (vertex, face or edge); empty for deleted slots and
/// isolated vertices. `out` is overwritten and its memory reused; after an error it is empty.
/// cost: O(slots), one pass; two passes for what walks against `next` where prev isn't stored
/// errors: corrupt-connectivity, out-of-memory
template <Storage kStored>
[[nodiscard]] Result<void> adjacency(const BasicConnectivity<kStored>& mesh, Ring ring,
                                     Direction direction, Adjacency& out) {
  Result<void> sizes = check_array_sizes(mesh);
  if (!sizes) return out.clear(), sizes;
  return adjacency(RawLinks(mesh), ring, direction, out);
}

/// One row for each of `centres`, in their order; an item may be named more than once.
/// errors: corrupt-connectivity, out-of-memory, too-large (2^32 items and more), index-out-of-range
/// and deleted-item (of `centres`; the message names the position)
template <Storage kStored>
[[nodiscard]] Result<void> adjacency(const BasicConnectivity<kStored>& mesh, Ring ring,
                                     Direction direction, std::span<const Index> centres,
                                     Adjacency& out) {
  Result<void> sizes = check_array_sizes(mesh);
  if (!sizes) return out.clear(), sizes;
  return adjacency(RawLinks(mesh), ring, direction, centres, out);
}

/// Writes the ring around one item to `out`, as much of it as fits, and returns how long the ring
/// is. Allocates nothing.
/// errors: corrupt-connectivity, index-out-of-range, deleted-item
template <Storage kStored>
[[nodiscard]] Result<Index> write_ring(const BasicConnectivity<kStored>& mesh, Ring ring,
                                       Direction direction, Index centre, std::span<Index> out) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  return write_ring(RawLinks(mesh), ring, direction, centre, out);
}

}  // namespace halfedge
