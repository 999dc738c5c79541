#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/circulators.h>
#include <halfedge/connectivity/handle.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <type_traits>
#include <utility>

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

/// Vertices, halfedges, edges and faces, and how they are joined; no geometry. Invariants (the
/// codes of `validate` name them):
///   1. opposite is an involution without fixed points; next and prev are inverse permutations.
///   2. from(next(h)) == to(h).
///   3. face(next(h)) == face(h); face_halfedge(f) lies in the loop of f; each loop closes.
///   4. from(anchor(v)) == v.
///   5. The anchor of a boundary vertex is a boundary halfedge: "is v on the boundary?" is O(1).
///   6. Every halfedge that leaves v is reached from anchor(v) by rotating.
///   7. No live item refers to a deleted one.
///
/// Navigation is O(1) and unchecked in release builds: passing a deleted or foreign handle is a
/// caller's bug, caught by `assert` in debug builds.
class Connectivity : public Circulators<Connectivity> {
 public:
  Connectivity() = default;
  /// Moving leaves `other` empty. It counts as a change of both.
  Connectivity(Connectivity&& other) noexcept { *this = std::move(other); }
  Connectivity& operator=(Connectivity&& other) noexcept;

  // ---- counts -------------------------------------------------------------------------------

  /// Live items.
  [[nodiscard]] Index vertex_count() const { return vertex_slots() - free_vertices_.count; }
  [[nodiscard]] Index halfedge_count() const { return 2 * edge_count(); }
  [[nodiscard]] Index edge_count() const { return edge_slots() - free_edges_.count; }
  [[nodiscard]] Index face_count() const { return face_slots() - free_faces_.count; }

  /// Live and deleted items: the range of indices.
  [[nodiscard]] Index vertex_slots() const { return Index(links_.vertex_halfedge.size()); }
  [[nodiscard]] Index halfedge_slots() const { return Index(links_.next.size()); }
  [[nodiscard]] Index edge_slots() const { return halfedge_slots() / 2; }
  [[nodiscard]] Index face_slots() const { return Index(links_.face_halfedge.size()); }

  /// The same, chosen by the type of the handle; for code that is generic over the kind of item.
  [[nodiscard]] Index slots(Vertex) const { return vertex_slots(); }
  [[nodiscard]] Index slots(Halfedge) const { return halfedge_slots(); }
  [[nodiscard]] Index slots(Edge) const { return edge_slots(); }
  [[nodiscard]] Index slots(Face) const { return face_slots(); }

  [[nodiscard]] bool is_deleted(Vertex v) const {
    return is_deleted_link(links_.vertex_halfedge[v.index()]);
  }
  [[nodiscard]] bool is_deleted(Halfedge h) const {
    return is_deleted_link(links_.next[h.index()]);
  }
  [[nodiscard]] bool is_deleted(Edge e) const { return is_deleted(edge_halfedge(e)); }
  [[nodiscard]] bool is_deleted(Face f) const {
    return is_deleted_link(links_.face_halfedge[f.index()]);
  }

  /// Whether the handle is not empty, in range and not deleted.
  template <class Item>
  [[nodiscard]] bool is_live(Item item) const {
    return item.index() < slots(Item{}) && !is_deleted(item);
  }

  /// Changes with every change of connectivity.
  [[nodiscard]] std::uint64_t version() const { return version_; }

  // ---- navigation: the links (1)-(7), O(1) --------------------------------------------------

  /// (1) One halfedge that leaves `v`, its anchor; empty for an isolated vertex.
  [[nodiscard]] Halfedge vertex_halfedge(Vertex v) const {
    return Halfedge(links_.vertex_halfedge[v.index()]);
  }
  /// (2) One halfedge of `f`.
  [[nodiscard]] Halfedge face_halfedge(Face f) const {
    return Halfedge(links_.face_halfedge[f.index()]);
  }
  /// (3)
  [[nodiscard]] Vertex to_vertex(Halfedge h) const { return Vertex(links_.to_vertex[h.index()]); }
  /// (4) The face on the left of `h`; empty for a boundary halfedge.
  [[nodiscard]] Face face(Halfedge h) const { return Face(links_.face[h.index()]); }
  /// (5) The halfedge after `h` in its face loop or boundary loop.
  [[nodiscard]] Halfedge next(Halfedge h) const { return Halfedge(links_.next[h.index()]); }
  /// (6)
  [[nodiscard]] static constexpr Halfedge opposite(Halfedge h) { return Halfedge(h.index() ^ 1U); }
  /// (7) The halfedge before `h` in its face loop or boundary loop.
  [[nodiscard]] Halfedge prev(Halfedge h) const { return Halfedge(links_.prev[h.index()]); }

  [[nodiscard]] Vertex from_vertex(Halfedge h) const { return to_vertex(opposite(h)); }
  [[nodiscard]] static constexpr Edge edge(Halfedge h) { return Edge(h.index() >> 1U); }
  /// The halfedge on `side` 0 or 1 of `e`.
  [[nodiscard]] static constexpr Halfedge edge_halfedge(Edge e, Index side = 0) {
    return Halfedge(2 * e.index() + side);
  }

  /// The next outgoing halfedge of from_vertex(h), clockwise and counter-clockwise.
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return next(opposite(h)); }
  [[nodiscard]] Halfedge rotate_ccw(Halfedge h) const { return opposite(prev(h)); }
  /// The next incoming halfedge of to_vertex(h), clockwise and counter-clockwise.
  [[nodiscard]] Halfedge next_on_vertex(Halfedge h) const { return opposite(next(h)); }
  [[nodiscard]] Halfedge prev_on_vertex(Halfedge h) const { return prev(opposite(h)); }

  // ---- queries ------------------------------------------------------------------------------

  [[nodiscard]] bool is_isolated(Vertex v) const { return !vertex_halfedge(v).valid(); }

  /// O(1), by invariant 5. An isolated vertex counts as boundary.
  [[nodiscard]] bool is_boundary(Vertex v) const {
    const Halfedge anchor = vertex_halfedge(v);
    return !anchor.valid() || is_boundary(anchor);
  }
  [[nodiscard]] bool is_boundary(Halfedge h) const { return !face(h).valid(); }
  [[nodiscard]] bool is_boundary(Edge e) const {
    return is_boundary(edge_halfedge(e, 0)) || is_boundary(edge_halfedge(e, 1));
  }
  /// Whether one of its edges is a boundary edge. O(degree).
  [[nodiscard]] bool is_boundary(Face f) const {
    for (const Halfedge h : face_halfedges_ccw(f)) {
      if (is_boundary(opposite(h))) return true;
    }
    return false;
  }

  /// Whether the faces at `v` form at most one fan: not pinched. O(valence).
  [[nodiscard]] bool is_manifold(Vertex v) const {
    Index gaps = 0;
    for (const Halfedge h : outgoing_cw(v)) gaps += is_boundary(h) ? 1 : 0;
    return gaps <= 1;
  }

  /// The number of edges at `v`. O(valence).
  [[nodiscard]] Index valence(Vertex v) const {
    Index count = 0;
    for ([[maybe_unused]] const Halfedge h : outgoing_cw(v)) ++count;
    return count;
  }
  /// The number of corners of `f`. O(degree).
  [[nodiscard]] Index degree(Face f) const {
    Index count = 0;
    for ([[maybe_unused]] const Halfedge h : face_halfedges_ccw(f)) ++count;
    return count;
  }

  /// The halfedge from `a` to `b`, or empty. O(valence of a).
  [[nodiscard]] Halfedge find_halfedge(Vertex a, Vertex b) const {
    for (const Halfedge h : outgoing_cw(a)) {
      if (to_vertex(h) == b) return h;
    }
    return {};
  }
  /// The edge between `a` and `b`, or empty. O(valence of a).
  [[nodiscard]] Edge find_edge(Vertex a, Vertex b) const {
    const Halfedge h = find_halfedge(a, b);
    return h.valid() ? edge(h) : Edge{};
  }

  // ---- storage ------------------------------------------------------------------------------

  /// Room for that many slots of each kind. False when memory is exhausted.
  [[nodiscard]] bool reserve(Index vertices, Index edges, Index faces);

  /// No items; keeps the memory.
  void clear();

  /// Becomes a copy of `other`, slot by slot. False when memory is exhausted; then it is empty.
  [[nodiscard]] bool assign(const Connectivity& other);

  // ---- low-level changes ----------------------------------------------------------------------
  // These keep no invariant by themselves; `validate` tells whether the result holds them. New
  // items take the most recently deleted slot, else a new one at the end; they are empty when
  // memory is exhausted. Each of them invalidates circulators.

  /// An isolated vertex.
  [[nodiscard]] Vertex new_vertex();

  /// Two halfedges without faces that are each other's next and prev; returns from -> to, side 0.
  /// Anchors are left alone.
  [[nodiscard]] Halfedge new_edge(Vertex from, Vertex to);

  /// A face with the loop of `h` as its boundary; the halfedges of the loop still need `set_face`.
  [[nodiscard]] Face new_face(Halfedge h);

  /// next(h) = n and prev(n) = h.
  void link(Halfedge h, Halfedge n) {
    links_.next[h.index()] = n.index();
    links_.prev[n.index()] = h.index();
    ++version_;
  }
  void set_to_vertex(Halfedge h, Vertex v) {
    links_.to_vertex[h.index()] = v.index();
    ++version_;
  }
  /// An empty `f` makes `h` a boundary halfedge.
  void set_face(Halfedge h, Face f) {
    links_.face[h.index()] = f.index();
    ++version_;
  }
  /// Sets the anchor; an empty `h` makes `v` isolated.
  void set_vertex_halfedge(Vertex v, Halfedge h) {
    links_.vertex_halfedge[v.index()] = h.index();
    ++version_;
  }
  void set_face_halfedge(Face f, Halfedge h) {
    links_.face_halfedge[f.index()] = h.index();
    ++version_;
  }

  /// Restores invariant 5 at `v` after low-level edits: moves the anchor to a boundary halfedge if
  /// one is reached by rotating clockwise from it. O(valence).
  void adjust_anchor(Vertex v);

  /// Give a slot back. Nothing else is changed: links of other items that lead to it must be
  /// mended by the caller.
  void release(Vertex v);
  void release(Edge e);
  void release(Face f);

  /// The arrays themselves, for bulk code: readers never need the mutable form.
  [[nodiscard]] const Links& links() const { return links_; }
  /// For code that writes whole arrays (builder, bindings). Counts as a change of connectivity.
  [[nodiscard]] Links& mutable_links() {
    ++version_;
    return links_;
  }

  /// A chain of deleted slots: the last one deleted, and how many there are.
  struct FreeList {
    Index head = kNone;
    Index count = 0;
  };
  [[nodiscard]] const FreeList& free_vertices() const { return free_vertices_; }
  [[nodiscard]] const FreeList& free_edges() const { return free_edges_; }
  [[nodiscard]] const FreeList& free_faces() const { return free_faces_; }

 private:
  Links links_;
  FreeList free_vertices_;
  FreeList free_edges_;
  FreeList free_faces_;
  std::uint64_t version_ = 0;
};

}  // namespace halfedge
