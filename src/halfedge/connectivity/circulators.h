#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/live_range.h>
#include <halfedge/connectivity/orbit.h>
#include <halfedge/connectivity/storage.h>

#include <cassert>
#include <type_traits>

/// Every circulator and iterator of the library comes from two templates:
///
///   Orbit       halfedges reached by one step again and again, each shown as some item
///   LiveRange   the live items of one kind, in index order
namespace halfedge {

/// All circulators by name, and what one lap of them tells, for any `Mesh` with the links they
/// walk. Order, exactly:
///   - around a vertex, cw begins at the anchor; ccw is its exact reverse and ends at the anchor;
///   - around a face, ccw begins at face_halfedge(f); cw is its exact reverse and ends there;
///   - with an explicit start halfedge both directions begin at it.
/// At a boundary vertex the anchor is a boundary halfedge, so both orders list the one-ring as an
/// open path from one boundary neighbour to the other. Sides without a face are skipped; where the
/// anchor of a vertex has a face there are none (invariant 5), and they aren't looked for. Each
/// step is O(1); nothing is allocated.
///
/// `Checked` is in their names for the linker: a program that is compiled for debugging may use a
/// library that isn't, and what their functions return differs in size.
template <class Mesh, bool Checked = kCheckedCirculators>
class Circulators {
  using RotateCw = walk::RotateCw;
  using RotateCcw = walk::RotateCcw;
  using LoopCcw = walk::LoopCcw;
  using LoopCw = walk::LoopCw;
  using AcrossEdge = walk::AcrossEdge;
  template <class Walk, class View>
  using Lap = Orbit<Mesh, Walk, View, Checked>;
  template <class Item>
  using Live = LiveRange<Mesh, Item, Checked>;

 public:
  /// Around a vertex. `start`, where given, is a halfedge that leaves `v`.
  // clang-format off
  [[nodiscard]] auto outgoing_cw(Vertex v) const { return around<RotateCw, view::Self>(v); }
  [[nodiscard]] auto outgoing_ccw(Vertex v) const { return around<RotateCcw, view::Self>(v); }
  [[nodiscard]] auto incoming_cw(Vertex v) const { return around<RotateCw, view::Opposite>(v); }
  [[nodiscard]] auto incoming_ccw(Vertex v) const { return around<RotateCcw, view::Opposite>(v); }
  [[nodiscard]] auto vertex_vertices_cw(Vertex v) const { return around<RotateCw, view::ToVertex>(v); }
  [[nodiscard]] auto vertex_vertices_ccw(Vertex v) const { return around<RotateCcw, view::ToVertex>(v); }
  [[nodiscard]] auto vertex_edges_cw(Vertex v) const { return around<RotateCw, view::ItsEdge>(v); }
  [[nodiscard]] auto vertex_edges_ccw(Vertex v) const { return around<RotateCcw, view::ItsEdge>(v); }
  [[nodiscard]] auto vertex_faces_cw(Vertex v) const { return around<RotateCw, view::ItsFace>(v); }
  [[nodiscard]] auto vertex_faces_ccw(Vertex v) const { return around<RotateCcw, view::ItsFace>(v); }

  [[nodiscard]] auto outgoing_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::Self>(v, start); }
  [[nodiscard]] auto outgoing_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::Self>(v, start); }
  [[nodiscard]] auto incoming_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::Opposite>(v, start); }
  [[nodiscard]] auto incoming_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::Opposite>(v, start); }
  [[nodiscard]] auto vertex_vertices_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::ToVertex>(v, start); }
  [[nodiscard]] auto vertex_vertices_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::ToVertex>(v, start); }
  [[nodiscard]] auto vertex_edges_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::ItsEdge>(v, start); }
  [[nodiscard]] auto vertex_edges_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::ItsEdge>(v, start); }
  [[nodiscard]] auto vertex_faces_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::ItsFace>(v, start); }
  [[nodiscard]] auto vertex_faces_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::ItsFace>(v, start); }

  /// Around a face. `start`, where given, is a halfedge of `f`.
  [[nodiscard]] auto face_halfedges_ccw(Face f) const { return around<LoopCcw, view::Self>(f); }
  [[nodiscard]] auto face_halfedges_cw(Face f) const { return around<LoopCw, view::Self>(f); }
  [[nodiscard]] auto face_vertices_ccw(Face f) const { return around<LoopCcw, view::ToVertex>(f); }
  [[nodiscard]] auto face_vertices_cw(Face f) const { return around<LoopCw, view::ToVertex>(f); }
  [[nodiscard]] auto face_edges_ccw(Face f) const { return around<LoopCcw, view::ItsEdge>(f); }
  [[nodiscard]] auto face_edges_cw(Face f) const { return around<LoopCw, view::ItsEdge>(f); }
  [[nodiscard]] auto face_faces_ccw(Face f) const { return around<LoopCcw, view::OppositeFace>(f); }
  [[nodiscard]] auto face_faces_cw(Face f) const { return around<LoopCw, view::OppositeFace>(f); }

  [[nodiscard]] auto face_halfedges_ccw(Face f, Halfedge start) const { return from<LoopCcw, view::Self>(f, start); }
  [[nodiscard]] auto face_halfedges_cw(Face f, Halfedge start) const { return from<LoopCw, view::Self>(f, start); }
  [[nodiscard]] auto face_vertices_ccw(Face f, Halfedge start) const { return from<LoopCcw, view::ToVertex>(f, start); }
  [[nodiscard]] auto face_vertices_cw(Face f, Halfedge start) const { return from<LoopCw, view::ToVertex>(f, start); }
  [[nodiscard]] auto face_edges_ccw(Face f, Halfedge start) const { return from<LoopCcw, view::ItsEdge>(f, start); }
  [[nodiscard]] auto face_edges_cw(Face f, Halfedge start) const { return from<LoopCw, view::ItsEdge>(f, start); }
  [[nodiscard]] auto face_faces_ccw(Face f, Halfedge start) const { return from<LoopCcw, view::OppositeFace>(f, start); }
  [[nodiscard]] auto face_faces_cw(Face f, Halfedge start) const { return from<LoopCw, view::OppositeFace>(f, start); }
  // clang-format on

  /// The face loop or boundary loop through `h`, beginning at `h`.
  [[nodiscard]] auto loop_ccw(Halfedge h) const { return Lap<LoopCcw, view::Self>(self(), h); }
  [[nodiscard]] auto loop_cw(Halfedge h) const { return Lap<LoopCw, view::Self>(self(), h); }

  /// The two ends, the two halfedges, the one or two faces of an edge; side 0 first.
  [[nodiscard]] auto edge_halfedges(Edge e) const { return across<view::Self>(e); }
  [[nodiscard]] auto edge_vertices(Edge e) const { return across<view::ToVertex>(e); }
  [[nodiscard]] auto edge_faces(Edge e) const { return across<view::ItsFace>(e); }

  /// All live items in index order.
  [[nodiscard]] auto vertices() const { return Live<Vertex>(self()); }
  [[nodiscard]] auto halfedges() const { return Live<Halfedge>(self()); }
  [[nodiscard]] auto edges() const { return Live<Edge>(self()); }
  [[nodiscard]] auto faces() const { return Live<Face>(self()); }

  // ---- what one lap tells

  /// Whether the faces at `v` form at most one fan: not pinched. O(valence).
  [[nodiscard]] bool is_manifold(Vertex v) const {
    Index gaps = 0;
    for (const Halfedge h : outgoing_cw(v)) gaps += self().is_boundary(h) ? 1U : 0U;
    return gaps <= 1;
  }

  /// The number of edges at `v`. O(valence).
  [[nodiscard]] Index valence(Vertex v) const {
    Index count = 0;
    for ([[maybe_unused]] const Halfedge h : outgoing_cw(v)) ++count;
    return count;
  }

  /// The halfedge from `a` to `b`, or empty. O(the smaller valence).
  [[nodiscard]] Halfedge find_halfedge(Vertex a, Vertex b) const {
    const Halfedge from_a = self().vertex_halfedge(a);
    const Halfedge from_b = self().vertex_halfedge(b);
    return from_a.valid() && from_b.valid() ? find_halfedge(from_a, from_b) : Halfedge{};
  }
  /// The same, from from_vertex(from_a) to from_vertex(from_b).
  [[nodiscard]] Halfedge find_halfedge(Halfedge from_a, Halfedge from_b) const {
    const Vertex a = self().from_vertex(from_a);
    const Vertex b = self().from_vertex(from_b);
    // Most vertices have few edges: a lap around one of them decides. Where it is long, around both
    // in step.
    Halfedge at_a = from_a;
    for (int steps = 0; steps < 8; ++steps) {
      if (self().to_vertex(at_a) == b) return at_a;
      at_a = self().rotate_cw(at_a);
      if (at_a == from_a) return {};
    }
    Halfedge at_b = from_b;
    do {
      if (self().to_vertex(at_a) == b) return at_a;
      if (self().to_vertex(at_b) == a) return self().opposite(at_b);
      at_a = self().rotate_cw(at_a);
      at_b = self().rotate_cw(at_b);
    } while (at_a != from_a && at_b != from_b);
    return {};
  }
  /// The edge between `a` and `b`, or empty. O(the smaller valence).
  [[nodiscard]] Edge find_edge(Vertex a, Vertex b) const {
    const Halfedge h = find_halfedge(a, b);
    return h.valid() ? self().edge(h) : Edge{};
  }

 private:
  [[nodiscard]] const Mesh& self() const { return static_cast<const Mesh&>(*this); }

  // The reverse of a lap that begins at `first` begins one step back from it.
  template <class Walk, class View>
  [[nodiscard]] auto around(Vertex v) const {
    const Halfedge anchor = self().vertex_halfedge(v);
    if (!anchor.valid()) return Lap<Walk, View>(self(), anchor, {.is_empty = true});
    const Halfedge first = std::is_same_v<Walk, RotateCw> ? anchor : self().rotate_ccw(anchor);
    return Lap<Walk, View>(self(), first, {.may_skip = may_skip<View>(anchor)});
  }
  template <class Walk, class View>
  [[nodiscard]] auto around(Face f) const {
    const Halfedge first = self().face_halfedge(f);
    if constexpr (std::is_same_v<Walk, LoopCcw>) return Lap<Walk, View>(self(), first, {});
    return Lap<Walk, View>(self(), self().prev(first), {});
  }
  template <class Walk, class View>
  [[nodiscard]] auto from([[maybe_unused]] Vertex v, Halfedge start) const {
    assert(self().from_vertex(start) == v && "the start halfedge must leave the vertex");
    if constexpr (StoresAnchors<Mesh>) {
      return Lap<Walk, View>(self(), start,
                             {.may_skip = may_skip<View>(self().vertex_halfedge(v))});
    }
    return Lap<Walk, View>(self(), start, {});
  }
  template <class Walk, class View>
  [[nodiscard]] auto from([[maybe_unused]] Face f, Halfedge start) const {
    if constexpr (StoresFaces<Mesh>) {
      assert(self().face(start) == f && "the start halfedge must lie in the face");
    }
    return Lap<Walk, View>(self(), start, {});
  }
  // Only views that can be empty need to know; so a mesh without faces has all others.
  template <class View>
  [[nodiscard]] bool may_skip([[maybe_unused]] Halfedge anchor) const {
    if constexpr (View::kCanBeEmpty) return self().is_boundary(anchor);
    return false;
  }
  template <class View>
  [[nodiscard]] auto across(Edge e) const {
    return Lap<AcrossEdge, View>(self(), self().edge_halfedge(e, 0));
  }
};

}  // namespace halfedge
