#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

namespace halfedge {

/// The whole representation: six flat arrays of 32-bit indices. Halfedges come in pairs, so that
/// opposite(h) = h ^ 1 and edge(h) = h >> 1 cost no memory.
///
///   by halfedge   next, prev, to_vertex, face     kNone: no face (a boundary halfedge)
///   by vertex     vertex_halfedge, the *anchor*   kNone: an isolated vertex
///   by face       face_halfedge                   never empty
///
/// A closed triangle mesh has two faces and six halfedges to a vertex: 4 + 2·4 + 6·16 = 108 bytes,
/// 120 with float positions.
///
/// Arrays that a mesh type doesn't store stay empty (see Storage).
///
/// Deleted slots hold values with the sign bit set other than kNone, and form a free list that is
/// threaded through `vertex_halfedge`, `face_halfedge` and `next` (of an edge's side 0).
struct Links {
  Array<Index> next;
  Array<Index> prev;
  Array<Index> to_vertex;
  Array<Index> face;
  Array<Index> vertex_halfedge;
  Array<Index> face_halfedge;
};

/// What the links of a deleted slot hold; a free-list link is kDeleted - 1 - (next free slot).
inline constexpr Index kDeleted = 0xFFFF'FFFE;

/// Whether a link belongs to a deleted slot.
[[nodiscard]] constexpr bool is_deleted_link(Index link) {
  return link > 0x7FFF'FFFF && link != kNone;
}

/// The free slot after one whose link is `link`, or kNone at the end of the chain.
[[nodiscard]] constexpr Index next_free_slot(Index link) {
  return link == kDeleted ? kNone : kDeleted - 1 - link;
}

/// A chain of deleted slots: the last one deleted, and how many there are.
struct FreeList {
  Index head = kNone;
  Index count = 0;

  /// Of a slot whose link leads to the last one deleted before.
  void push(Index slot) {
    head = slot;
    ++count;
  }
  /// Of the slot at the head, whose link led to `next_free`.
  void pop(Index next_free) {
    head = next_free;
    --count;
  }
  /// Undoes or repeats one of the two: pops the slot at the head, whose link is `link`; pushes any
  /// other one.
  void exchange(Index slot, Index link) {
    if (slot != head) return push(slot);
    pop(next_free_slot(link));
  }
};

}  // namespace halfedge
