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
  journal_->record_loop_links(h, links_.next[h], prev, face);
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange_loop_links(Journal::Write& first) {
  const Index h = first.index;
  Journal::Write& second = (&first)[1];
  std::swap(links_.next[h], first.word);
  if (stores_prev()) std::swap(links_.prev[h], second.index);
  if constexpr (kStorage.face) std::swap(links_.face[h], second.word);
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
void BasicConnectivity<kStored>::exchange_recycled_edge(Journal::Write& first) {
  const Index e = first.index;
  const Index h = edge_halfedge(Edge(e)).index();
  free_edges_.exchange(e, links_.next[h]);
  Index words[8] = {};
  Index* word = words;
  Journal::for_edge_words(&first, [&word](Index noted) { *word++ = noted; });
  for_edge_links([&](Array<Index>& array, int place) {
    std::swap(array[h], words[place]);
    std::swap(array[h + 1], words[place + 1]);
  });
  word = words;
  Journal::for_edge_words(&first, [&word](Index& noted) { noted = *word++; });
}

// Drops slots that were new, or adds them again, in room that was there before, as they were.
template <Storage kStored>
void BasicConnectivity<kStored>::exchange_new(ItemKind kind, bool is_stored, Array<Index>& array,
                                              Index& bare, Journal::Write& write) {
  const Index size = slots(kind);
  attributes_.resize(kind, write.word);
  if (!is_stored) {
    bare = write.word;
  } else if (write.word < size) {
    journal_->keep_dropped(&array[write.word], size - write.word);
    array.grow_to(write.word);
  } else {
    const Index count = write.word - size;
    array.grow_to(write.word);
    const void* const dropped = journal_->take_dropped(count);
    if (count > 0) std::memcpy(array.begin() + size, dropped, count * sizeof(Index));
  }
  write.word = size;
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange_new_halfedges(Journal::Write& write) {
  const Index size = halfedge_slots();
  attributes_.resize(ItemKind::kEdge, write.word / 2);
  attributes_.resize(ItemKind::kHalfedge, write.word);
  if (write.word < size) {
    (void)internal::for_halfedge_arrays(storage(), links_, [&](Array<Index>& array) {
      journal_->keep_dropped(&array[write.word], size - write.word);
      array.grow_to(write.word);
      return true;
    });
  } else {
    const std::size_t count = write.word - size;
    std::size_t arrays = 0;
    (void)internal::for_halfedge_arrays(storage(), links_,
                                        [&](Array<Index>&) { return ++arrays > 0; });
    const auto* dropped = static_cast<const Index*>(journal_->take_dropped(arrays * count));
    (void)internal::for_halfedge_arrays(storage(), links_, [&](Array<Index>& array) {
      array.grow_to(write.word);
      std::copy_n(dropped, count, array.begin() + size);
      dropped += count;
      return true;
    });
  }
  write.word = size;
}

// Changes the size back, in room that is there. What a slot holds is noted by itself.
template <Storage kStored>
void BasicConnectivity<kStored>::exchange_slots(ItemKind kind, bool is_stored, Array<Index>& array,
                                                Index& bare, Journal::Write& write) {
  const Index size = slots(kind);
  attributes_.resize(kind, write.word);
  if (is_stored) {
    (void)array.resize(write.word, kNone);
  } else {
    bare = write.word;
  }
  write.word = size;
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange_halfedge_slots(Journal::Write& write) {
  const Index size = halfedge_slots();
  (void)internal::for_halfedge_arrays(
      storage(), links_, [&](Array<Index>& array) { return array.resize(write.word, kNone); });
  attributes_.resize(ItemKind::kEdge, write.word / 2);
  attributes_.resize(ItemKind::kHalfedge, write.word);
  write.word = size;
}

template <Storage kStored>
void BasicConnectivity<kStored>::exchange(Journal::Write& write) {
  const auto exchange_word = [&](Array<Index>& array) {
    std::swap(array[write.index], write.word);
  };
  const auto exchange_free_list = [&](FreeList& list) {
    std::swap(write.index == 0 ? list.head : list.count, write.word);
  };
  const auto exchange_recycled = [&](FreeList& list, Array<Index>& array) {
    list.exchange(write.index, array[write.index]);
    exchange_word(array);
  };
  switch (write.field) {
    case Field::kNext:
      return exchange_word(links_.next);
    case Field::kPrev:
      return exchange_word(links_.prev);
    case Field::kToVertex:
      return exchange_word(links_.to_vertex);
    case Field::kFace:
      return exchange_word(links_.face);
    case Field::kVertexHalfedge:
      return exchange_word(links_.vertex_halfedge);
    case Field::kFaceHalfedge:
      return exchange_word(links_.face_halfedge);
    case Field::kLoopLinks:
      return exchange_loop_links(write);
    case Field::kRecycledVertex:
      return exchange_recycled(free_vertices_, links_.vertex_halfedge);
    case Field::kRecycledFace:
      return exchange_recycled(free_faces_, links_.face_halfedge);
    case Field::kRecycledEdge:
      return exchange_recycled_edge(write);
    case Field::kNewVertices:
      return exchange_new(ItemKind::kVertex, kStorage.vertex_halfedge, links_.vertex_halfedge,
                          bare_vertices_, write);
    case Field::kNewHalfedges:
      return exchange_new_halfedges(write);
    case Field::kNewFaces:
      return exchange_new(ItemKind::kFace, kStorage.face_halfedge, links_.face_halfedge,
                          bare_faces_, write);
    case Field::kVertexSlots:
      return exchange_slots(ItemKind::kVertex, kStorage.vertex_halfedge, links_.vertex_halfedge,
                            bare_vertices_, write);
    case Field::kHalfedgeSlots:
      return exchange_halfedge_slots(write);
    case Field::kFaceSlots:
      return exchange_slots(ItemKind::kFace, kStorage.face_halfedge, links_.face_halfedge,
                            bare_faces_, write);
    case Field::kFreeListOfVertices:
      return exchange_free_list(free_vertices_);
    case Field::kFreeListOfEdges:
      return exchange_free_list(free_edges_);
    case Field::kFreeListOfFaces:
      return exchange_free_list(free_faces_);
    case Field::kFiller:
      return;
    default:
      assert(write.field >= Field::kFirstAttribute && "a field of a class built on this one");
      attributes_.exchange(write);
  }
}

}  // namespace halfedge
