#pragma once

#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/array_sizes.h>
#include <halfedge/algorithms/rings.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/connectivity.h>
#include <halfedge/connectivity/item_span.h>
#include <halfedge/result.h>

#include <cstdint>
#include <span>

/// What lies around items: k-rings, and the star, closure and link of a set.
///
/// These functions check what they follow: on a mesh that breaks its invariants they return an
/// error with the code corrupt-connectivity, they don't hang or read out of bounds. A bit for each
/// slot is all the scratch memory they take.
/// errors: corrupt-connectivity, out-of-memory, index-out-of-range and deleted-item (of the items
/// that are given; the message names the position)
namespace halfedge {

/// Some items of a mesh, in any order and with repetitions; a view, owning nothing:
/// `star(mesh, {.vertices = v, .faces = faces})`.
struct Items {
  ItemSpan<Vertex> vertices = {};
  ItemSpan<Edge> edges = {};
  ItemSpan<Face> faces = {};
};

/// Some items of a mesh, each once, in ascending order.
struct ItemSet {
  Array<Index> vertices;
  Array<Index> edges;
  Array<Index> faces;

  [[nodiscard]] Items view() const { return {vertices.span(), edges.span(), faces.span()}; }
};

enum class Surroundings : std::uint8_t { kStar, kClosure, kLink };

/// What the functions below call, whichever links the mesh stores.
[[nodiscard]] Result<Adjacency> k_ring(const RawLinks& links, std::span<const Index> vertices,
                                       Index k);
[[nodiscard]] Result<ItemSet> surroundings(const RawLinks& links, Surroundings which,
                                           const Items& items);

/// All vertices that are up to `k` edges away from the nearest of `vertices`. Row d has those at
/// distance d; row 0 has `vertices` themselves, without repetitions. There are as many rows as have
/// vertices in them, k + 1 at the most: with k = kNone, all that is connected.
/// cost: O(vertices visited + their halfedges), and a bit for each slot
template <Storage kStored>
[[nodiscard]] Result<Adjacency> k_ring(const BasicConnectivity<kStored>& mesh,
                                       ItemSpan<Vertex> vertices, Index k) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  return k_ring(RawLinks(mesh), vertices.indices(), k);
}

/// The items, and all edges and faces that have one of them in their closure: of a vertex, its
/// edges and faces; of an edge, its faces. cost: O(items of the result), and a bit for each slot;
/// likewise the next two
template <Storage kStored>
[[nodiscard]] Result<ItemSet> star(const BasicConnectivity<kStored>& mesh, const Items& items) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  return surroundings(RawLinks(mesh), Surroundings::kStar, items);
}

/// The items, and all edges and vertices of them: the smallest complex that they are a part of.
template <Storage kStored>
[[nodiscard]] Result<ItemSet> closure(const BasicConnectivity<kStored>& mesh, const Items& items) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  return surroundings(RawLinks(mesh), Surroundings::kClosure, items);
}

/// The closure of the star without the star of the closure. Of a vertex inside of a triangle mesh
/// the ring of edges and vertices around it; of a boundary vertex a path; of an edge inside of a
/// triangle mesh the two vertices across from it.
template <Storage kStored>
[[nodiscard]] Result<ItemSet> link(const BasicConnectivity<kStored>& mesh, const Items& items) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  return surroundings(RawLinks(mesh), Surroundings::kLink, items);
}

}  // namespace halfedge
