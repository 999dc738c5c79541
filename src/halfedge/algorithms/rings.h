#pragma once

#include <halfedge/connectivity/connectivity.h>

#include <algorithm>
#include <bit>
#include <type_traits>

/// The walks around items that adjacency lists are made of: those of the circulators, but over
/// links that may be anything.
namespace halfedge {

/// The links as the walks and views of the circulators read them, by raw pointers. A halfedge is
/// checked once, when it is stepped to; the arrays are equally long.
class RawLinks {
 public:
  explicit RawLinks(const Connectivity& mesh)
      : halfedge_slots_(mesh.halfedge_slots()),
        next_(mesh.links().next.data()),
        prev_(mesh.links().prev.data()),
        to_vertex_(mesh.links().to_vertex.data()),
        face_(mesh.links().face.data()) {}

  [[nodiscard]] bool contain(Halfedge h) const { return h.index() < halfedge_slots_; }

  [[nodiscard]] Halfedge next(Halfedge h) const { return Halfedge(next_[h.index()]); }
  [[nodiscard]] Halfedge prev(Halfedge h) const { return Halfedge(prev_[h.index()]); }
  [[nodiscard]] Vertex to_vertex(Halfedge h) const { return Vertex(to_vertex_[h.index()]); }
  [[nodiscard]] Face face(Halfedge h) const { return Face(face_[h.index()]); }
  [[nodiscard]] static Halfedge opposite(Halfedge h) { return Connectivity::opposite(h); }
  [[nodiscard]] static Edge edge(Halfedge h) { return Connectivity::edge(h); }
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return next(opposite(h)); }
  [[nodiscard]] Halfedge rotate_ccw(Halfedge h) const { return opposite(prev(h)); }

 private:
  Index halfedge_slots_;
  const Index* next_;
  const Index* prev_;
  const Index* to_vertex_;
  const Index* face_;
};

/// A ring is a centre, a walk and a view.
template <class CentreType, class WalkType, class ViewType>
struct RingOf {
  using Centre = CentreType;
  using Walk = WalkType;
  using View = ViewType;
  /// The exact reverse of a lap that begins at the anchor begins one step on from it.
  static constexpr bool kBeginsOneStepOn =
      std::is_same_v<Walk, walk::RotateCcw> || std::is_same_v<Walk, walk::LoopCw>;
};

[[nodiscard]] inline Halfedge stored_halfedge(const Connectivity& mesh, Vertex v) {
  return mesh.vertex_halfedge(v);
}
[[nodiscard]] inline Halfedge stored_halfedge(const Connectivity& mesh, Face f) {
  return mesh.face_halfedge(f);
}
[[nodiscard]] inline Halfedge stored_halfedge(const Connectivity& mesh, Edge e) {
  return mesh.edge_halfedge(e);
}

/// Whether there is anything to walk around: not so at deleted slots and isolated vertices.
template <class Centre>
[[nodiscard]] bool has_ring(const Connectivity& mesh, Centre centre) {
  return !mesh.is_deleted(centre) && stored_halfedge(mesh, centre).valid();
}

/// Where the ring begins; empty if a link leads out of the arrays.
template <class Ring>
[[nodiscard]] Halfedge first_of(const Connectivity& mesh, const RawLinks& links,
                                typename Ring::Centre centre) {
  Halfedge first = stored_halfedge(mesh, centre);
  if (!links.contain(first)) return {};
  if constexpr (Ring::kBeginsOneStepOn) {
    first = Ring::Walk::on(links, first);
    if (!links.contain(first)) return {};
  }
  return first;
}

/// Shows `put` each item of the ring that begins at `first`, in order, kNone where the view is
/// empty. Takes at most `steps` steps and counts them down; false if they don't suffice or lead out
/// of the arrays, which only happens if the mesh is corrupt.
template <class Ring, class Put>
[[nodiscard]] bool walk_ring(const RawLinks& links, Halfedge first, Index& steps, Put&& put) {
  if (!first.valid()) return false;
  Halfedge h = first;
  do {
    if (steps == 0) return false;
    --steps;
    put(Ring::View::of(links, h).index());
    h = Ring::Walk::on(links, h);
    if (!links.contain(h)) return false;
  } while (h != first);
  return true;
}

/// How long a ring `write_short_ring` writes.
inline constexpr Index kShortRing = 7;

/// As walk_ring, but takes kShortRing steps in any case, round and round, and then sees where the
/// lap was over: no branch depends on the valence. Writes kShortRing items, the ring first. Returns
/// the length of the ring; more than kShortRing if it is longer, broken, or has an empty view.
template <class Ring>
[[nodiscard]] Index write_short_ring(const RawLinks& links, Halfedge first, Index* out) {
  constexpr Index kNotShort = kShortRing + 1;
  if (!first.valid()) return kNotShort;
  unsigned over = 1U << kShortRing;  // bit i: over after i + 1 steps
  Index largest = 0;
  Halfedge h = first;
  for (Index i = 0; i < kShortRing; ++i) {
    const Index item = Ring::View::of(links, h).index();
    out[i] = item;
    if constexpr (Ring::View::kCanBeEmpty) largest = std::max(largest, item);
    h = Ring::Walk::on(links, h);
    if (!links.contain(h)) return kNotShort;
    over |= (h == first ? 1U : 0U) << i;
  }
  return largest == kNone ? kNotShort : Index(std::countr_zero(over)) + 1;
}

}  // namespace halfedge
