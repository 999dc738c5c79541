#pragma once

// The parts of BasicConnectivity that move arrays or recycle slots.

#include <halfedge/connectivity/connectivity.h>

namespace halfedge {

namespace internal {

// A deleted slot stores the next one of its chain below kDeleted, so that every stored value has
// the sign bit set and can't be taken for a live link.
constexpr Index encode_free_slot(Index next_free) {
  return next_free == kNone ? kDeleted : kDeleted - 1 - next_free;
}

inline void push_free(FreeList& list, Index slot, Index& link) {
  link = encode_free_slot(list.head);
  list.head = slot;
  ++list.count;
}

inline Index pop_free(FreeList& list, const Array<Index>& links, Index stride) {
  const Index slot = list.head;
  list.head = next_free_slot(links[std::size_t{slot} * stride]);
  --list.count;
  return slot;
}

// Grows by half, so that a sequence of single additions is amortised O(1).
inline bool make_room(Array<Index>& array, std::size_t count) {
  if (count <= array.capacity()) return true;
  return array.reserve(std::max(count, array.capacity() + array.capacity() / 2 + 16)) ||
         array.reserve(count);
}

// Whether `each` holds for all arrays by halfedge that are stored; stops at the first that fails.
template <Storage kStored, class Each>
bool for_halfedge_arrays(Links& links, const Each& each) {
  return each(links.next) && each(links.to_vertex) && (!kStored.prev || each(links.prev)) &&
         (!kStored.face || each(links.face));
}

}  // namespace internal

template <Storage kStored>
BasicConnectivity<kStored>& BasicConnectivity<kStored>::operator=(
    BasicConnectivity&& other) noexcept {
  if (this == &other) return *this;
  links_ = std::move(other.links_);
  free_vertices_ = std::exchange(other.free_vertices_, {});
  free_edges_ = std::exchange(other.free_edges_, {});
  free_faces_ = std::exchange(other.free_faces_, {});
  bare_vertices_ = std::exchange(other.bare_vertices_, 0);
  bare_faces_ = std::exchange(other.bare_faces_, 0);
  // Not the version of `other`, which a circulator of this mesh may remember by chance.
  version_ = std::max(version_, other.version_) + 1;
  ++other.version_;
  return *this;
}

template <Storage kStored>
bool BasicConnectivity<kStored>::reserve(Index vertices, Index edges, Index faces) {
  const std::size_t halfedges = 2 * std::size_t{edges};
  if (kStorage.vertex_halfedge && !links_.vertex_halfedge.reserve(vertices)) return false;
  if (kStorage.face_halfedge && !links_.face_halfedge.reserve(faces)) return false;
  return internal::for_halfedge_arrays<kStored>(
      links_, [&](Array<Index>& array) { return array.reserve(halfedges); });
}

template <Storage kStored>
void BasicConnectivity<kStored>::clear() {
  links_.next.clear();
  links_.prev.clear();
  links_.to_vertex.clear();
  links_.face.clear();
  links_.vertex_halfedge.clear();
  links_.face_halfedge.clear();
  free_vertices_ = free_edges_ = free_faces_ = FreeList{};
  bare_vertices_ = bare_faces_ = 0;
  ++version_;
}

template <Storage kStored>
bool BasicConnectivity<kStored>::assign(const BasicConnectivity& other) {
  if (this == &other) return true;
  const Links& from = other.links_;
  const bool fits = links_.next.assign(from.next.span()) && links_.prev.assign(from.prev.span()) &&
                    links_.to_vertex.assign(from.to_vertex.span()) &&
                    links_.face.assign(from.face.span()) &&
                    links_.vertex_halfedge.assign(from.vertex_halfedge.span()) &&
                    links_.face_halfedge.assign(from.face_halfedge.span());
  if (!fits) {
    clear();
    return false;
  }
  free_vertices_ = other.free_vertices_;
  free_edges_ = other.free_edges_;
  free_faces_ = other.free_faces_;
  bare_vertices_ = other.bare_vertices_;
  bare_faces_ = other.bare_faces_;
  ++version_;
  return true;
}

template <Storage kStored>
Vertex BasicConnectivity<kStored>::new_vertex() {
  if (vertex_count() >= kMaxSlots) return {};
  if constexpr (!kStorage.vertex_halfedge) {
    ++version_;
    return Vertex(bare_vertices_++);
  }
  Array<Index>& anchors = links_.vertex_halfedge;
  Vertex v(vertex_slots());
  if (free_vertices_.count > 0) {
    v = Vertex(internal::pop_free(free_vertices_, anchors, 1));
    anchors[v.index()] = kNone;
  } else {
    if (!internal::make_room(anchors, anchors.size() + 1)) return {};
    (void)anchors.resize(anchors.size() + 1, kNone);  // in the room made above
  }
  ++version_;
  return v;
}

template <Storage kStored>
Halfedge BasicConnectivity<kStored>::new_edge(Vertex from, Vertex to) {
  Halfedge h(halfedge_slots());
  if (free_edges_.count > 0) {
    h = edge_halfedge(Edge(internal::pop_free(free_edges_, links_.next, 2)));
  } else {
    const std::size_t count = links_.next.size() + 2;
    const auto has_room = [&](Array<Index>& array) { return internal::make_room(array, count); };
    const auto resize = [&](Array<Index>& array) { return array.resize(count); };
    if (count > kMaxSlots || !internal::for_halfedge_arrays<kStored>(links_, has_room) ||
        !internal::for_halfedge_arrays<kStored>(links_, resize)) {
      return {};
    }
  }
  const Halfedge o = opposite(h);
  link(h, o);
  link(o, h);
  set_to_vertex(h, to);
  set_to_vertex(o, from);
  if constexpr (kStorage.face) {
    set_face(h, Face{});
    set_face(o, Face{});
  }
  return h;
}

template <Storage kStored>
Face BasicConnectivity<kStored>::new_face([[maybe_unused]] Halfedge h) {
  static_assert(kStorage.face, HALFEDGE_NEEDS_FACES);
  if (face_count() >= kMaxSlots) return {};
  if constexpr (!kStorage.face_halfedge) {
    ++version_;
    return Face(bare_faces_++);
  }
  Array<Index>& firsts = links_.face_halfedge;
  Face f(face_slots());
  if (free_faces_.count > 0) {
    f = Face(internal::pop_free(free_faces_, firsts, 1));
  } else {
    if (!internal::make_room(firsts, firsts.size() + 1)) return {};
    (void)firsts.resize(firsts.size() + 1);  // in the room made above
  }
  links_.face_halfedge[f.index()] = h.index();
  ++version_;
  return f;
}

template <Storage kStored>
void BasicConnectivity<kStored>::adjust_anchor(Vertex v) {
  for (const Halfedge h : this->outgoing_cw(v)) {
    if (is_boundary(h)) {
      set_vertex_halfedge(v, h);
      return;
    }
  }
}

template <Storage kStored>
void BasicConnectivity<kStored>::release(Vertex v) {
  static_assert(kStorage.vertex_halfedge, HALFEDGE_NEEDS_ANCHORS);
  assert(is_live(v));
  internal::push_free(free_vertices_, v.index(), links_.vertex_halfedge[v.index()]);
  ++version_;
}

template <Storage kStored>
void BasicConnectivity<kStored>::release(Edge e) {
  assert(is_live(e));
  for (const Index side : {0U, 1U}) {
    const Index h = edge_halfedge(e, side).index();
    (void)internal::for_halfedge_arrays<kStored>(links_, [&](Array<Index>& array) {
      array[h] = kDeleted;
      return true;
    });
  }
  internal::push_free(free_edges_, e.index(), links_.next[edge_halfedge(e).index()]);
  ++version_;
}

template <Storage kStored>
void BasicConnectivity<kStored>::release(Face f) {
  static_assert(kStorage.face_halfedge, HALFEDGE_NEEDS_FACE_HALFEDGES);
  assert(is_live(f));
  internal::push_free(free_faces_, f.index(), links_.face_halfedge[f.index()]);
  ++version_;
}

}  // namespace halfedge
