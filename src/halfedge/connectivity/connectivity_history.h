#pragma once

// The parts of BasicConnectivity that history needs: what is noted of links, and how the words
// noted are exchanged with those of the arrays, to go back and forth.

#include <halfedge/connectivity/connectivity.h>

#include <cstring>

namespace halfedge {

template <Storage kStored>
void BasicConnectivity<kStored>::note_loop_links_at(Index h) {
  Index prev = kNone;
  Index face = kNone;
  if (stores_prev()) prev = links_.prev[h];
  if constexpr (kStorage.face) face = links_.face[h];
  journal_->record_in_old_slots(Field::kLoopLinks, h, {links_.next[h], prev, face});
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange_loop_links(const Journal::Note& note) {
  const Index h = note.index;
  std::swap(links_.next[h], note.words[0]);
  if (stores_prev()) std::swap(links_.prev[h], note.words[1]);
  if constexpr (kStorage.face) std::swap(links_.face[h], note.words[2]);
}

// Calls `visit` with each array of links that is stored, and the place of the two words that an
// edge has in it among its eight.
template <Storage kStored>
template <class Visit>
void BasicConnectivity<kStored>::for_edge_links(const Visit& visit) {
  visit(links_.next, 0);
  if (stores_prev()) visit(links_.prev, 2);
  visit(links_.to_vertex, 4);
  if constexpr (kStorage.face) visit(links_.face, 6);
}

template <Storage kStored>
void BasicConnectivity<kStored>::note_recycled(Edge e, bool is_taken) {
  const Index h = edge_halfedge(e).index();
  Index words[8] = {};
  for_edge_links([&](const Array<Index>& array, int place) {
    words[place] = array[h];
    words[place + 1] = array[h + 1];
  });
  journal_->record_recycled_edge(e.index(), words, is_taken);
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange_recycled_edge(const Journal::Note& note) {
  const Index e = note.index;
  const Index h = edge_halfedge(Edge(e)).index();
  free_edges_.exchange(e, links_.next[h]);
  for_edge_links([&](Array<Index>& array, int place) {
    std::swap(array[h], note.words[place]);
    std::swap(array[h + 1], note.words[place + 1]);
  });
}

// Drops slots that were new, or adds them again, in room that was there before, as they were.
template <Storage kStored>
void BasicConnectivity<kStored>::exchange_new(ItemKind kind, bool is_stored, Array<Index>& array,
                                              Index& bare, const Journal::Note& note) {
  const Index size = slots(kind);
  attributes_.resize(kind, note.words[0]);
  if (!is_stored) {
    bare = note.words[0];
  } else if (note.words[0] < size) {
    journal_->keep_dropped(&array[note.words[0]], size - note.words[0]);
    array.grow_to(note.words[0]);
  } else {
    const Index count = note.words[0] - size;
    array.grow_to(note.words[0]);
    const void* const dropped = journal_->take_dropped(count);
    if (count > 0) std::memcpy(array.begin() + size, dropped, count * sizeof(Index));
  }
  note.words[0] = size;
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange_new_halfedges(const Journal::Note& note) {
  const Index size = halfedge_slots();
  attributes_.resize(ItemKind::kEdge, note.words[0] / 2);
  attributes_.resize(ItemKind::kHalfedge, note.words[0]);
  if (note.words[0] < size) {
    (void)internal::for_halfedge_arrays(storage(), links_, [&](Array<Index>& array) {
      journal_->keep_dropped(&array[note.words[0]], size - note.words[0]);
      array.grow_to(note.words[0]);
      return true;
    });
  } else {
    const std::size_t count = note.words[0] - size;
    std::size_t arrays = 0;
    (void)internal::for_halfedge_arrays(storage(), links_,
                                        [&](Array<Index>&) { return ++arrays > 0; });
    const auto* dropped = static_cast<const Index*>(journal_->take_dropped(arrays * count));
    (void)internal::for_halfedge_arrays(storage(), links_, [&](Array<Index>& array) {
      array.grow_to(note.words[0]);
      std::copy_n(dropped, count, array.begin() + size);
      dropped += count;
      return true;
    });
  }
  note.words[0] = size;
}

// Changes the size back, in room that is there. What a slot holds is noted by itself.
template <Storage kStored>
void BasicConnectivity<kStored>::exchange_slots(ItemKind kind, bool is_stored, Array<Index>& array,
                                                Index& bare, const Journal::Note& note) {
  const Index size = slots(kind);
  attributes_.resize(kind, note.words[0]);
  if (is_stored) {
    (void)array.resize(note.words[0], kNone);
  } else {
    bare = note.words[0];
  }
  note.words[0] = size;
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange_halfedge_slots(const Journal::Note& note) {
  const Index size = halfedge_slots();
  (void)internal::for_halfedge_arrays(
      storage(), links_, [&](Array<Index>& array) { return array.resize(note.words[0], kNone); });
  attributes_.resize(ItemKind::kEdge, note.words[0] / 2);
  attributes_.resize(ItemKind::kHalfedge, note.words[0]);
  note.words[0] = size;
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange(const Journal::Note& note) {
  const auto exchange_words = [&](Array<Index>& array) {
    Journal::exchange_words(note, &array[note.index]);
  };
  const auto exchange_free_list = [&](FreeList& list) {
    std::swap(list.head, note.words[0]);
    std::swap(list.count, note.words[1]);
  };
  const auto exchange_recycled = [&](FreeList& list, Array<Index>& array) {
    list.exchange(note.index, array[note.index]);
    exchange_words(array);
  };
  switch (note.field == Field::kWords ? Field(note.column) : note.field) {
    case Field::kNext:
      return exchange_words(links_.next);
    case Field::kPrev:
      return exchange_words(links_.prev);
    case Field::kToVertex:
      return exchange_words(links_.to_vertex);
    case Field::kFace:
      return exchange_words(links_.face);
    case Field::kVertexHalfedge:
      return exchange_words(links_.vertex_halfedge);
    case Field::kFaceHalfedge:
      return exchange_words(links_.face_halfedge);
    case Field::kLoopLinks:
      return exchange_loop_links(note);
    case Field::kRecycledVertex:
      return exchange_recycled(free_vertices_, links_.vertex_halfedge);
    case Field::kRecycledFace:
      return exchange_recycled(free_faces_, links_.face_halfedge);
    case Field::kRecycledEdge:
      return exchange_recycled_edge(note);
    case Field::kNewVertices:
      return exchange_new(ItemKind::kVertex, kStorage.vertex_halfedge, links_.vertex_halfedge,
                          bare_vertices_, note);
    case Field::kNewHalfedges:
      return exchange_new_halfedges(note);
    case Field::kNewFaces:
      return exchange_new(ItemKind::kFace, kStorage.face_halfedge, links_.face_halfedge,
                          bare_faces_, note);
    case Field::kVertexSlots:
      return exchange_slots(ItemKind::kVertex, kStorage.vertex_halfedge, links_.vertex_halfedge,
                            bare_vertices_, note);
    case Field::kHalfedgeSlots:
      return exchange_halfedge_slots(note);
    case Field::kFaceSlots:
      return exchange_slots(ItemKind::kFace, kStorage.face_halfedge, links_.face_halfedge,
                            bare_faces_, note);
    case Field::kFreeListOfVertices:
      return exchange_free_list(free_vertices_);
    case Field::kFreeListOfEdges:
      return exchange_free_list(free_edges_);
    case Field::kFreeListOfFaces:
      return exchange_free_list(free_faces_);
    case Field::kFiller:
      return;
    default:
      assert((note.field == Field::kAttribute || note.field == Field::kAttributeRun) &&
             "a field of a class built on this one");
      attributes_.exchange(note);
  }
}

}  // namespace halfedge
