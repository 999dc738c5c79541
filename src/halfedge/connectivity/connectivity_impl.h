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

}  // namespace internal

template <Storage kStored>
BasicConnectivity<kStored>& BasicConnectivity<kStored>::operator=(
    BasicConnectivity&& other) noexcept {
  if (this == &other) return *this;
  links_ = std::move(other.links_);
  attributes_ = std::move(other.attributes_);
  free_vertices_ = std::exchange(other.free_vertices_, {});
  free_edges_ = std::exchange(other.free_edges_, {});
  free_faces_ = std::exchange(other.free_faces_, {});
  bare_vertices_ = std::exchange(other.bare_vertices_, 0);
  bare_faces_ = std::exchange(other.bare_faces_, 0);
  prev_is_stored_ = other.prev_is_stored_;
  journal_ = std::move(other.journal_);
  // Not the version of `other`, which a circulator of this mesh may remember by chance.
  version_ = std::max(version_, other.version_) + 1;
  ++other.version_;
  return *this;
}

template <Storage kStored>
bool BasicConnectivity<kStored>::reserve(Index vertices, Index edges, Index faces) {
  if (vertices > kMaxSlots || edges > kMaxSlots / 2 || faces > kMaxSlots) return false;
  const std::size_t halfedges = 2 * std::size_t{edges};
  if (kStorage.vertex_halfedge && !links_.vertex_halfedge.reserve(vertices)) return false;
  if (kStorage.face_halfedge && !links_.face_halfedge.reserve(faces)) return false;
  if (!attributes_.reserve(ItemKind::kVertex, vertices) ||
      !attributes_.reserve(ItemKind::kHalfedge, halfedges) ||
      !attributes_.reserve(ItemKind::kEdge, edges) ||
      !attributes_.reserve(ItemKind::kFace, faces)) {
    return false;
  }
  return internal::for_halfedge_arrays(
      storage(), links_, [&](Array<Index>& array) { return array.reserve(halfedges); });
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
  (void)fit_attributes();  // to nothing
  attributes_.end_all_generations();
  forget_history();
  ++version_;
}

template <Storage kStored>
bool BasicConnectivity<kStored>::assign(const BasicConnectivity& other) {
  if (this == &other) return true;
  forget_history();
  const Links& from = other.links_;
  const bool fits = links_.next.assign(from.next.span()) && links_.prev.assign(from.prev.span()) &&
                    links_.to_vertex.assign(from.to_vertex.span()) &&
                    links_.face.assign(from.face.span()) &&
                    links_.vertex_halfedge.assign(from.vertex_halfedge.span()) &&
                    links_.face_halfedge.assign(from.face_halfedge.span()) &&
                    attributes_.assign(other.attributes_);
  if (!fits) {
    clear();
    return false;
  }
  free_vertices_ = other.free_vertices_;
  free_edges_ = other.free_edges_;
  free_faces_ = other.free_faces_;
  bare_vertices_ = other.bare_vertices_;
  bare_faces_ = other.bare_faces_;
  prev_is_stored_ = other.prev_is_stored_;
  ++version_;
  return true;
}

template <Storage kStored>
Index BasicConnectivity<kStored>::take_free(Field field, Array<Index>& links, FreeList& list,
                                            Index link) {
  const Index slot = list.head;
  const Index next_free = next_free_slot(links[slot]);
  write(field, links, slot, link);
  list.pop(next_free);
  return slot;
}

template <Storage kStored>
Vertex BasicConnectivity<kStored>::new_vertex() {
  if (vertex_count() >= kMaxSlots) return {};
  Vertex v(vertex_slots());
  if (kStorage.vertex_halfedge && free_vertices_.count > 0) {
    v = Vertex(take_free(Field::kRecycledVertex, links_.vertex_halfedge, free_vertices_, kNone));
    attributes_.set_default(ItemKind::kVertex, v.index(), journal_.get());
  } else {
    if (!attributes_.reserve(ItemKind::kVertex, std::size_t{v.index()} + 1)) return {};
    if constexpr (!kStorage.vertex_halfedge) {
      note_new(Field::kNewVertices, bare_vertices_++);
    } else {
      Array<Index>& anchors = links_.vertex_halfedge;
      if (!anchors.reserve_more(1)) return {};
      note_new(Field::kNewVertices, v.index());
      (void)anchors.resize(anchors.size() + 1, kNone);  // in the room made above
    }
    attributes_.resize(ItemKind::kVertex, v.index() + 1, journal_.get());
  }
  lone_fans_.carry_over(version_);
  ++version_;
  return v;
}

// Two slots more, in room that may have to be made; empty when memory is exhausted.
template <Storage kStored>
Halfedge BasicConnectivity<kStored>::add_edge_slot() {
  const Halfedge h(halfedge_slots());
  const std::size_t count = links_.next.size() + 2;
  const auto has_room = [&](Array<Index>& array) { return array.reserve_amply(count); };
  if (count > kMaxSlots || !internal::for_halfedge_arrays(storage(), links_, has_room)) return {};
  if (attributes_.has_any() && (!attributes_.reserve(ItemKind::kEdge, count / 2) ||
                                !attributes_.reserve(ItemKind::kHalfedge, count))) {
    return {};
  }
  note_new(Field::kNewHalfedges, h.index());
  (void)internal::for_halfedge_arrays(storage(), links_, [&](Array<Index>& array) {
    array.grow_to(count);
    array[h.index()] = array[h.index() + 1U] = kNone;
    return true;
  });
  if (attributes_.has_any()) {
    attributes_.resize(ItemKind::kEdge, Index(count / 2), journal_.get());
    attributes_.resize(ItemKind::kHalfedge, Index(count));  // nothing to note: see append_edges
  }
  return h;
}

template <Storage kStored>
Vertex BasicConnectivity<kStored>::append_vertex() {
  const Vertex v(vertex_slots());
  note_new(Field::kNewVertices, v.index());
  if constexpr (kStorage.vertex_halfedge) {
    links_.vertex_halfedge.grow_to(std::size_t{v.index()} + 1);
  } else {
    ++bare_vertices_;
  }
  attributes_.resize(ItemKind::kVertex, v.index() + 1, journal_.get());
  ++version_;
  return v;
}

template <Storage kStored>
Edge BasicConnectivity<kStored>::append_edges(Index count) {
  const Edge first(edge_slots());
  const std::size_t halfedges = halfedge_slots() + 2 * std::size_t{count};
  note_new(Field::kNewHalfedges, halfedge_slots());
  (void)internal::for_halfedge_arrays(storage(), links_, [&](Array<Index>& array) {
    array.grow_to(halfedges);
    return true;
  });
  attributes_.resize(ItemKind::kEdge, Index(halfedges / 2), journal_.get());
  // All that is noted of new slots is their generation, and that of a halfedge is its edge's.
  attributes_.resize(ItemKind::kHalfedge, Index(halfedges));
  ++version_;
  return first;
}

template <Storage kStored>
Face BasicConnectivity<kStored>::append_faces(Index count) {
  const Face first(face_slots());
  const Index faces = face_slots() + count;
  note_new(Field::kNewFaces, face_slots());
  if constexpr (kStorage.face_halfedge) {
    links_.face_halfedge.grow_to(faces);
  } else {
    bare_faces_ = faces;
  }
  attributes_.resize(ItemKind::kFace, faces, journal_.get());
  ++version_;
  return first;
}

template <Storage kStored>
Halfedge BasicConnectivity<kStored>::new_unlinked_edge(Vertex from, Vertex to) {
  Halfedge h;
  if (free_edges_.count == 0) {
    h = add_edge_slot();
    if (!h.valid()) return h;
  } else {
    h = edge_halfedge(Edge(free_edges_.head));
    if (journal_ != nullptr) [[unlikely]]
      note_recycled(edge(h), /*is_taken=*/true);
    free_edges_.pop(next_free_slot(links_.next[h.index()]));
    attributes_.set_default(ItemKind::kEdge, edge(h).index(), journal_.get());
    attributes_.set_default(ItemKind::kHalfedge, h.index(), journal_.get());
    attributes_.set_default(ItemKind::kHalfedge, opposite(h).index(), journal_.get());
  }
  const Writer writer(*this);
  writer.set_to_vertex(h, to);
  writer.set_to_vertex(opposite(h), from);
  return h;
}

template <Storage kStored>
Halfedge BasicConnectivity<kStored>::new_edge(Vertex from, Vertex to) {
  const Halfedge h = new_unlinked_edge(from, to);
  if (!h.valid()) return h;
  const Writer writer(*this);
  for (const Halfedge side : {h, opposite(h)}) {
    writer.link(side, opposite(side));
    writer.set_face(side, Face{});
  }
  return h;
}

template <Storage kStored>
Face BasicConnectivity<kStored>::new_face([[maybe_unused]] Halfedge h) {
  static_assert(kStorage.face, HALFEDGE_NEEDS_FACES);
  if (face_count() >= kMaxSlots) return {};
  Face f(face_slots());
  if (kStorage.face_halfedge && free_faces_.count > 0) {
    f = Face(take_free(Field::kRecycledFace, links_.face_halfedge, free_faces_, h.index()));
    attributes_.set_default(ItemKind::kFace, f.index(), journal_.get());
  } else {
    if (!attributes_.reserve(ItemKind::kFace, std::size_t{f.index()} + 1)) return {};
    if constexpr (!kStorage.face_halfedge) {
      note_new(Field::kNewFaces, bare_faces_++);
    } else {
      Array<Index>& firsts = links_.face_halfedge;
      if (!firsts.reserve_more(1)) return {};
      note_new(Field::kNewFaces, f.index());
      (void)firsts.resize(firsts.size() + 1, kNone);  // in the room made above
    }
    attributes_.resize(ItemKind::kFace, f.index() + 1, journal_.get());
  }
  if constexpr (kStorage.face_halfedge) set_face_halfedge(f, h);
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
void BasicConnectivity<kStored>::release_slot(Field field, Array<Index>& links, FreeList& list,
                                              Index slot) {
  write(field, links, slot, internal::encode_free_slot(list.head));
  list.push(slot);
  ++version_;
}

template <Storage kStored>
void BasicConnectivity<kStored>::release(Vertex v) {
  static_assert(kStorage.vertex_halfedge, HALFEDGE_NEEDS_ANCHORS);
  assert(is_live(v));
  attributes_.end_generation(ItemKind::kVertex, v.index(), journal_.get());
  release_slot(Field::kRecycledVertex, links_.vertex_halfedge, free_vertices_, v.index());
}

template <Storage kStored>
void BasicConnectivity<kStored>::release(Edge e) {
  assert(is_live(e));
  attributes_.end_generation(ItemKind::kEdge, e.index(), journal_.get());
  const Index h = edge_halfedge(e).index();
  if (journal_ != nullptr) [[unlikely]]
    note_recycled(e, /*is_taken=*/false);
  (void)internal::for_halfedge_arrays(storage(), links_, [h](Array<Index>& array) {
    array[h] = array[h + 1] = kDeleted;
    return true;
  });
  links_.next[h] = internal::encode_free_slot(free_edges_.head);
  free_edges_.push(e.index());
  ++version_;
}

template <Storage kStored>
void BasicConnectivity<kStored>::release(Face f) {
  static_assert(kStorage.face_halfedge, HALFEDGE_NEEDS_FACE_HALFEDGES);
  assert(is_live(f));
  attributes_.end_generation(ItemKind::kFace, f.index(), journal_.get());
  release_slot(Field::kRecycledFace, links_.face_halfedge, free_faces_, f.index());
}

}  // namespace halfedge
