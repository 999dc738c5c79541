#pragma once

// The parts of BasicConnectivity that history needs: what is noted of links, and how the words
// noted are exchanged with those of the arrays, to go back and forth.

#include <halfedge/connectivity/connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

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

// The arrays of links that items of a kind have; as many as are told.
template <Storage kStored>
std::size_t BasicConnectivity<kStored>::list_arrays(ItemKind kind,
                                                    std::array<Array<Index>*, 4>& arrays) {
  std::size_t count = 0;
  const auto list = [&](Array<Index>& array) {
    arrays[count++] = &array;
    return true;
  };
  if (kind == ItemKind::kHalfedge) (void)internal::for_halfedge_arrays(storage(), links_, list);
  if (kStorage.vertex_halfedge && kind == ItemKind::kVertex) list(links_.vertex_halfedge);
  if (kStorage.face_halfedge && kind == ItemKind::kFace) list(links_.face_halfedge);
  return count;
}

// Changes the number of slots back, in room that is there. What a slot holds is noted by itself,
// unless it is new: then it is dropped, or added again as it was.
template <Storage kStored>
void BasicConnectivity<kStored>::exchange_slots(ItemKind kind, bool is_new,
                                                const Journal::Note& note) {
  const Index before = slots(kind);
  const Index after = std::exchange(note.words[0], before);
  if (kind == ItemKind::kHalfedge) attributes_.resize(ItemKind::kEdge, after / 2);
  attributes_.resize(kind, after);
  if (!kStorage.vertex_halfedge && kind == ItemKind::kVertex) bare_vertices_ = after;
  if (!kStorage.face_halfedge && kind == ItemKind::kFace) bare_faces_ = after;

  std::array<Array<Index>*, 4> listed;
  const std::span<Array<Index>* const> arrays(listed.data(), list_arrays(kind, listed));
  const std::size_t more = is_new && after > before ? after - before : 0;
  const auto* dropped =
      static_cast<const Index*>(more > 0 ? journal_->take_dropped(arrays.size() * more) : nullptr);
  for (Array<Index>* const array : arrays) {
    if (is_new && after < before) journal_->keep_dropped(&(*array)[after], before - after);
    if (!is_new) {
      (void)array->resize(after, kNone);
      continue;
    }
    array->grow_to(after);
    std::copy_n(dropped, more, array->begin() + before);
    dropped += more;
  }
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
      return exchange_slots(ItemKind::kVertex, true, note);
    case Field::kNewHalfedges:
      return exchange_slots(ItemKind::kHalfedge, true, note);
    case Field::kNewFaces:
      return exchange_slots(ItemKind::kFace, true, note);
    case Field::kVertexSlots:
      return exchange_slots(ItemKind::kVertex, false, note);
    case Field::kHalfedgeSlots:
      return exchange_slots(ItemKind::kHalfedge, false, note);
    case Field::kFaceSlots:
      return exchange_slots(ItemKind::kFace, false, note);
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
