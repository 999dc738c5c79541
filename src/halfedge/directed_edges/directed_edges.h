#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/circulators.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/storage.h>
#include <halfedge/mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace halfedge {

/// The whole representation of a triangle mesh as Directed Edges (Campagna, Kobbelt, Seidel,
/// "Directed Edges - A Scalable Representation for Triangle Meshes", 1998). The halfedges of face f
/// with corners v0 v1 v2 are three in a row, so that `face`, `next` and `prev` are arithmetic:
///
///   3f: v2 -> v0     3f + 1: v0 -> v1     3f + 2: v1 -> v2
///
/// Halfedge 3f is the one that face_halfedge(f) is everywhere, and the first 3F entries of
/// `to_vertex` are the corners of the faces as an index buffer holds them. The B boundary
/// halfedges come after those; only they have their next and prev stored.
///
///   by halfedge            opposite, to_vertex
///   by boundary halfedge   boundary_next, boundary_prev   at [h - sides]
///   by vertex              vertex_halfedge, the anchor    kNone: an isolated vertex
///
/// A closed mesh has six halfedges to a vertex: 4 + 2·24 = 52 bytes, 64 with float positions.
struct DirectedLinks {
  Array<Index> opposite;
  Array<Index> to_vertex;
  Array<Index> boundary_next;
  Array<Index> boundary_prev;
  Array<Index> vertex_halfedge;
  /// 3F: halfedges from here on are boundary halfedges.
  Index sides = 0;

  [[nodiscard]] bool is_boundary(Index h) const { return h >= sides; }
  [[nodiscard]] Index next(Index h) const {
    return is_boundary(h) ? boundary_next[h - sides] : next_in_face(h);
  }
  [[nodiscard]] static Index next_in_face(Index h) {
    return h + 1 - 3 * Index{h % 3 == 2};  // no branch: it could not be predicted
  }
  [[nodiscard]] Index prev(Index h) const {
    if (is_boundary(h)) return boundary_prev[h - sides];
    return h - 1 + 3 * Index{h % 3 == 0};
  }
  [[nodiscard]] Index from_vertex(Index h) const { return to_vertex[prev(h)]; }
};

/// The connectivity of a triangle mesh in half the memory. The items, their invariants (listed at
/// `Connectivity`) and all circulators are those of the full structure, element for element, and
/// the functions have the same names. What differs:
///   - Static: items are neither added nor deleted. To edit, convert to a `Mesh` and back
///     (convert.h). Handles stay valid until the mesh is built anew.
///   - opposite(h) is a load; next, prev and face are computed.
///   - An edge has the index of the smaller of its two halfedges, so edge indices have gaps:
///     edges() steps over them, is_deleted(e) tells that `e` is one, and edge_slots() is 3F, as
///     the smaller halfedge is never a boundary halfedge.
///   - The two boundary arrays are the only ones whose size depends on the boundary.
class DirectedEdges : public Circulators<DirectedEdges> {
 public:
  /// Everything can be asked; prev, face and face_halfedge are computed.
  static constexpr Storage kStorage{};

  DirectedEdges() = default;
  /// Moving leaves `other` empty. It counts as a change of both.
  DirectedEdges(DirectedEdges&& other) noexcept { *this = std::move(other); }
  DirectedEdges& operator=(DirectedEdges&& other) noexcept;

  // ---- counts -------------------------------------------------------------------------------

  [[nodiscard]] Index vertex_count() const { return Index(links_.vertex_halfedge.size()); }
  [[nodiscard]] Index halfedge_count() const { return Index(links_.opposite.size()); }
  [[nodiscard]] Index edge_count() const { return halfedge_count() / 2; }
  [[nodiscard]] Index face_count() const { return links_.sides / 3; }
  /// The halfedges without a face.
  [[nodiscard]] Index boundary_halfedge_count() const { return halfedge_count() - links_.sides; }

  /// The ranges of indices.
  [[nodiscard]] Index vertex_slots() const { return vertex_count(); }
  [[nodiscard]] Index halfedge_slots() const { return halfedge_count(); }
  [[nodiscard]] Index edge_slots() const { return links_.sides; }
  [[nodiscard]] Index face_slots() const { return face_count(); }

  /// The same, chosen by the type of the handle; for code that is generic over the kind of item.
  [[nodiscard]] Index slots(Vertex) const { return vertex_slots(); }
  [[nodiscard]] Index slots(Halfedge) const { return halfedge_slots(); }
  [[nodiscard]] Index slots(Edge) const { return edge_slots(); }
  [[nodiscard]] Index slots(Face) const { return face_slots(); }

  /// Whether no item has this index: never so, but for the gaps between edges.
  [[nodiscard]] static constexpr bool is_deleted(Vertex) { return false; }
  [[nodiscard]] static constexpr bool is_deleted(Halfedge) { return false; }
  [[nodiscard]] bool is_deleted(Edge e) const { return links_.opposite[e.index()] < e.index(); }
  [[nodiscard]] static constexpr bool is_deleted(Face) { return false; }
  [[nodiscard]] static constexpr bool has_deleted(Vertex) { return false; }
  [[nodiscard]] static constexpr bool has_deleted(Halfedge) { return false; }
  [[nodiscard]] static constexpr bool has_deleted(Edge) { return true; }
  [[nodiscard]] static constexpr bool has_deleted(Face) { return false; }

  /// Whether the handle is not empty and that of an item.
  template <class Item>
  [[nodiscard]] bool is_live(Item item) const {
    return item.index() < slots(Item{}) && !is_deleted(item);
  }

  /// Changes with every change of connectivity.
  [[nodiscard]] std::uint64_t version() const { return version_; }

  // ---- navigation, O(1) -----------------------------------------------------------------------

  /// One halfedge that leaves `v`, its anchor; empty for an isolated vertex.
  [[nodiscard]] Halfedge vertex_halfedge(Vertex v) const {
    return Halfedge(links_.vertex_halfedge[v.index()]);
  }
  /// The halfedge v2 -> v0 of the face v0 v1 v2.
  [[nodiscard]] static constexpr Halfedge face_halfedge(Face f) { return Halfedge(3 * f.index()); }
  [[nodiscard]] Vertex to_vertex(Halfedge h) const { return Vertex(links_.to_vertex[h.index()]); }
  /// The face on the left of `h`; empty for a boundary halfedge.
  [[nodiscard]] Face face(Halfedge h) const {
    return is_boundary(h) ? Face{} : Face(h.index() / 3);
  }
  /// The halfedge after `h` in its face loop or boundary loop.
  [[nodiscard]] Halfedge next(Halfedge h) const { return Halfedge(links_.next(h.index())); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const { return Halfedge(links_.opposite[h.index()]); }
  /// The halfedge before `h` in its face loop or boundary loop.
  [[nodiscard]] Halfedge prev(Halfedge h) const { return Halfedge(links_.prev(h.index())); }

  /// Of the halfedge before `h`, which in a face lies beside it in memory.
  [[nodiscard]] Vertex from_vertex(Halfedge h) const { return to_vertex(prev(h)); }
  [[nodiscard]] Edge edge(Halfedge h) const {
    const Index o = opposite(h).index();
    return Edge(h.index() < o ? h.index() : o);
  }
  /// The halfedge on `side` 0 or 1 of `e`; side 0 has the index of the edge, and a face.
  [[nodiscard]] Halfedge edge_halfedge(Edge e, Index side = 0) const {
    const Halfedge h(e.index());
    return side == 0 ? h : opposite(h);
  }

  /// The next outgoing halfedge of from_vertex(h), clockwise and counter-clockwise.
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return next(opposite(h)); }
  [[nodiscard]] Halfedge rotate_ccw(Halfedge h) const { return opposite(prev(h)); }
  /// The next incoming halfedge of to_vertex(h), clockwise and counter-clockwise.
  [[nodiscard]] Halfedge next_on_vertex(Halfedge h) const { return opposite(next(h)); }
  [[nodiscard]] Halfedge prev_on_vertex(Halfedge h) const { return prev(opposite(h)); }

  // ---- queries ------------------------------------------------------------------------------

  [[nodiscard]] bool is_isolated(Vertex v) const { return !vertex_halfedge(v).valid(); }

  /// O(1), as the anchor of a boundary vertex is a boundary halfedge. An isolated vertex counts as
  /// boundary.
  [[nodiscard]] bool is_boundary(Vertex v) const {
    return links_.is_boundary(links_.vertex_halfedge[v.index()]);  // kNone is large
  }
  [[nodiscard]] bool is_boundary(Halfedge h) const { return links_.is_boundary(h.index()); }
  [[nodiscard]] bool is_boundary(Edge e) const { return is_boundary(edge_halfedge(e, 1)); }
  /// Whether one of its edges is a boundary edge.
  [[nodiscard]] bool is_boundary(Face f) const {
    const Halfedge h = face_halfedge(f);
    return is_boundary(opposite(h)) || is_boundary(opposite(next(h))) ||
           is_boundary(opposite(prev(h)));
  }

  /// The number of corners of a face.
  [[nodiscard]] static constexpr Index degree(Face) { return 3; }

  // ---- memory -------------------------------------------------------------------------------

  /// No items; keeps the memory.
  void clear();

  /// Becomes a copy of `other`. False when memory is exhausted; then it is empty.
  [[nodiscard]] bool assign(const DirectedEdges& other);

  /// The arrays themselves.
  [[nodiscard]] const DirectedLinks& links() const { return links_; }
  /// For code that writes whole arrays (builder, conversions). Counts as a change of connectivity.
  [[nodiscard]] DirectedLinks& mutable_links() {
    ++version_;
    return links_;
  }

 private:
  DirectedLinks links_;
  std::uint64_t version_ = 0;
};

/// Directed Edges whose vertices have positions: three floats for each vertex, xyz interleaved.
class DirectedEdgesMesh : public DirectedEdges {
 public:
  [[nodiscard]] Point position(Vertex v) const {
    const float* p = &positions_[3 * std::size_t{v.index()}];
    return {p[0], p[1], p[2]};
  }
  void set_position(Vertex v, Point p) {
    float* stored = &positions_[3 * std::size_t{v.index()}];
    stored[0] = p.x;
    stored[1] = p.y;
    stored[2] = p.z;
  }

  /// 3 * vertex_slots() floats.
  [[nodiscard]] std::span<const float> positions() const { return positions_.span(); }
  [[nodiscard]] Array<float>& mutable_positions() { return positions_; }

  void clear() {
    positions_.clear();
    DirectedEdges::clear();
  }
  /// Becomes a copy of `other`. False when memory is exhausted; then it is empty.
  [[nodiscard]] bool assign(const DirectedEdgesMesh& other) {
    if (this == &other) return true;
    if (positions_.assign(other.positions_.span()) && DirectedEdges::assign(other)) return true;
    clear();
    return false;
  }

 private:
  Array<float> positions_;
};

}  // namespace halfedge
