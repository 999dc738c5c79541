#pragma once

#include <halfedge/connectivity/connectivity.h>

#include <algorithm>
#include <bit>
#include <type_traits>

/// The walks around items that adjacency lists are made of: those of the circulators, but over
/// links that may be anything.
namespace halfedge {

/// The links as the walks and views of the circulators read them, by raw pointers: one type for all
/// storage options, so that what is written for it is compiled once. A halfedge is checked once,
/// when it is stepped to; the arrays by halfedge are equally long. Good until the mesh changes.
class RawLinks {
 public:
  template <Storage kStored>
  explicit RawLinks(const BasicConnectivity<kStored>& mesh)
      : vertex_slots_(mesh.vertex_slots()),
        halfedge_slots_(mesh.halfedge_slots()),
        face_slots_(mesh.face_slots()),
        next_(mesh.links().next.data()),
        prev_(mesh.links().prev.data()),
        to_vertex_(mesh.links().to_vertex.data()),
        face_(mesh.links().face.data()),
        vertex_halfedge_(mesh.links().vertex_halfedge.data()),
        face_halfedge_(mesh.links().face_halfedge.data()),
        stores_prev_(mesh.stores_prev()) {
    static_assert(kStored.face && kStored.face_halfedge && kStored.vertex_halfedge,
                  "adjacency lists need all links but prev (StoresSurface)");
  }

  /// If not, walks against `next` can't be taken.
  [[nodiscard]] bool stores_prev() const { return stores_prev_; }

  [[nodiscard]] Index halfedge_slots() const { return halfedge_slots_; }
  [[nodiscard]] Index slots(Vertex) const { return vertex_slots_; }
  [[nodiscard]] Index slots(Edge) const { return halfedge_slots_ / 2; }
  [[nodiscard]] Index slots(Face) const { return face_slots_; }
  [[nodiscard]] bool contain(Halfedge h) const { return h.index() < halfedge_slots_; }

  /// Where a walk around the item begins; what is empty or deleted is not contained.
  [[nodiscard]] Halfedge stored_halfedge(Vertex v) const {
    return Halfedge(vertex_halfedge_[v.index()]);
  }
  [[nodiscard]] Halfedge stored_halfedge(Face f) const {
    return Halfedge(face_halfedge_[f.index()]);
  }
  [[nodiscard]] Halfedge stored_halfedge(Edge e) const { return Halfedge(2 * e.index()); }

  [[nodiscard]] bool is_deleted(Vertex v) const {
    return is_deleted_link(vertex_halfedge_[v.index()]);
  }
  [[nodiscard]] bool is_deleted(Face f) const { return is_deleted_link(face_halfedge_[f.index()]); }
  [[nodiscard]] bool is_deleted(Edge e) const {
    return is_deleted_link(next_[2 * std::size_t{e.index()}]);
  }
  template <class Item>
  [[nodiscard]] bool is_live(Item item) const {
    return item.index() < slots(Item{}) && !is_deleted(item);
  }

  /// The arrays, by halfedge, and by vertex or face.
  [[nodiscard]] const Index* all_next() const { return next_; }
  [[nodiscard]] const Index* all_prev() const { return prev_; }
  [[nodiscard]] const Index* all_to_vertex() const { return to_vertex_; }
  [[nodiscard]] const Index* all_face() const { return face_; }
  [[nodiscard]] const Index* all_stored_halfedges(Vertex) const { return vertex_halfedge_; }
  [[nodiscard]] const Index* all_stored_halfedges(Face) const { return face_halfedge_; }

  [[nodiscard]] Halfedge next(Halfedge h) const { return Halfedge(next_[h.index()]); }
  /// pre: stores_prev()
  [[nodiscard]] Halfedge prev(Halfedge h) const { return Halfedge(prev_[h.index()]); }
  [[nodiscard]] Vertex to_vertex(Halfedge h) const { return Vertex(to_vertex_[h.index()]); }
  [[nodiscard]] Face face(Halfedge h) const { return Face(face_[h.index()]); }
  [[nodiscard]] static Halfedge opposite(Halfedge h) { return Connectivity::opposite(h); }
  [[nodiscard]] static Edge edge(Halfedge h) { return Connectivity::edge(h); }
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return next(opposite(h)); }
  [[nodiscard]] Halfedge rotate_ccw(Halfedge h) const { return opposite(prev(h)); }

 private:
  Index vertex_slots_;
  Index halfedge_slots_;
  Index face_slots_;
  const Index* next_;
  const Index* prev_;
  const Index* to_vertex_;
  const Index* face_;
  const Index* vertex_halfedge_;
  const Index* face_halfedge_;
  bool stores_prev_;
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

/// Whether there is anything to walk around: not so at deleted slots and isolated vertices.
template <class Centre>
[[nodiscard]] bool has_ring(const RawLinks& links, Centre centre) {
  return !links.is_deleted(centre) && links.stored_halfedge(centre).valid();
}

/// Where the ring begins; empty if a link leads out of the arrays.
template <class Ring>
[[nodiscard]] Halfedge first_of(const RawLinks& links, typename Ring::Centre centre) {
  Halfedge first = links.stored_halfedge(centre);
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

/// Writes the ring of a triangle, without a loop whose end is found. False if it is no triangle, or
/// an item is missing. A loop of one halfedge is none: three steps end there, too.
/// pre: links.contain(first)
template <class Ring>
[[nodiscard]] bool write_triangle(const RawLinks& links, Halfedge first, Index* out) {
  const Halfedge second = Ring::Walk::on(links, first);
  if (!links.contain(second)) return false;
  const Halfedge third = Ring::Walk::on(links, second);
  if (!links.contain(third) || Ring::Walk::on(links, third) != first || third == first)
    return false;
  out[0] = Ring::View::of(links, first).index();
  out[1] = Ring::View::of(links, second).index();
  out[2] = Ring::View::of(links, third).index();
  // Only kNone has its highest bit.
  return !Ring::View::kCanBeEmpty || (out[0] | out[1] | out[2]) != kNone;
}

}  // namespace halfedge
