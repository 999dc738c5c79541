#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/history/chunked_array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace halfedge {

/// What a write changes: an array of 32-bit words, or one of the numbers that go with the arrays.
enum class Field : std::uint32_t {
  kNext,
  kPrev,
  kToVertex,
  kFace,
  kVertexHalfedge,
  kFaceHalfedge,
  kPositionX,  // by vertex
  kPositionY,
  kPositionZ,
  kVertexSlots,  // sizes of the arrays, which compact changes; no index
  kHalfedgeSlots,
  kFaceSlots,
  kNewVertices,  // the same where slots were added at the end
  kNewHalfedges,
  kNewFaces,
  kFreeListOfVertices,  // free lists; index 0: the head, 1: the count
  kFreeListOfEdges,
  kFreeListOfFaces,
  kRecycledVertex,  // the link of a slot that went to its free list, or was taken from it; the list
  kRecycledFace,
  kRecycledEdge,  // the same of an edge, with the eight links of its sides
  kLoopLinks,     // next, prev and face of a halfedge
  kFiller,  // says nothing: it fills a chunk up, so that writes that belong together are in one
  kFirstAttribute  // attributes have numbers from here on
};

/// How far back history reaches. The oldest steps are forgotten first; the last one is kept in any
/// case.
struct HistoryLimits {
  std::size_t steps = std::numeric_limits<std::size_t>::max();
  std::size_t bytes = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] bool are_infinite() const {
    return steps == HistoryLimits().steps && bytes == HistoryLimits().bytes;
  }
};

/// A record of writes, by which a mesh goes back and forth exactly. Each write is noted with the
/// word that it replaced; to undo a step is to exchange its words with those of the arrays, last
/// one first, and to redo it, first one first. So the cost is that of what was touched, 12 bytes a
/// word; 24 for all links of a halfedge in its loop; 12 for a vertex or face that is deleted, 48
/// for an edge. What is written to slots that are new in a step needs no note: to undo it is to
/// drop them. What they held is kept then, for redo.
///
/// A step is all that was written since the end of the step before.
class Journal {
 public:
  struct Write {
    Field field;
    Index index;
    Index word;  // of the other state
  };

  /// An edge that was deleted, or whose slot was taken again, is noted by four in a row, the first
  /// and the last with its field and index: in their other members are its words.
  static constexpr std::size_t kWritesOfRecycledEdge = 4;
  /// Calls `each` with each of those eight words.
  template <class Each>
  static void for_edge_words(Write* first, const Each& each) {
    each(first[0].word);
    for (Write* inner : {first + 1, first + 2}) {
      auto word = Index(inner->field);
      each(word);
      inner->field = Field(word);
      each(inner->index);
      each(inner->word);
    }
    each(first[3].word);
  }

  /// The links of a halfedge in its loop are noted by two in a row: with its index and `next`, and
  /// with `prev` and `face`.
  static constexpr std::size_t kWritesOfLoopLinks = 2;

  explicit Journal(HistoryLimits limits) : limits_(limits) {}

  /// Notes that `word`, at `index` of `field`, is about to be replaced. If there is no memory for
  /// it, all steps are forgotten: history then begins anew with the next step.
  void record(Field field, Index index, Index word);
  /// The same for a slot that isn't new in this step.
  void record_in_old_slot(Field field, Index index, Index word) {
    if (has_undone_ || writes_.room_in_chunk() == 0) [[unlikely]]
      return record_in_new_place(field, index, word);
    writes_.push_back_in_chunk({field, index, word});
  }
  /// The same for the links of `h` in its loop. pre: `h` isn't new in this step
  void record_loop_links(Index h, Index next, Index prev, Index face) {
    if (!has_room_in_row(kWritesOfLoopLinks)) return;
    writes_.push_back_in_chunk({Field::kLoopLinks, h, next});
    writes_.push_back_in_chunk({Field::kLoopLinks, prev, face});
  }
  /// The same for the words of an edge that is about to be deleted, or to take the slot of a
  /// deleted one: then what is written to it in this step needs no note.
  void record_recycled_edge(Index edge, const Index (&words)[8], bool is_taken) {
    if (!has_room_in_row(kWritesOfRecycledEdge)) return;
    writes_.push_back_in_chunk({Field::kRecycledEdge, edge, words[0]});
    writes_.push_back_in_chunk({Field(words[1]), words[2], words[3]});
    writes_.push_back_in_chunk({Field(words[4]), words[5], words[6]});
    writes_.push_back_in_chunk({Field::kRecycledEdge, edge, words[7]});
    if (is_taken) {
      std::copy_backward(taken_, taken_ + 3, taken_ + 4);
      taken_[0] = edge;
    }
  }

  /// Notes that slots are about to be added behind the present ones. `field` is kNewVertices,
  /// kNewHalfedges or kNewFaces.
  void record_new(Field field, Index slots);
  /// Whether the step needs no note of what is written to `h`. Of those that took the slots of
  /// deleted ones it knows the last four.
  [[nodiscard]] bool is_new_halfedge(Index h) const {
    const Index e = h >> 1U;
    return h >= new_from_[1] || e == taken_[0] || e == taken_[1] || e == taken_[2] ||
           e == taken_[3];
  }
  /// Takes notes of all slots again.
  void end_new() {
    std::fill_n(new_from_, 3, kNone);
    std::fill_n(taken_, 4, kNone);
  }

  /// Keeps words of slots that undo drops, and gives back the last ones that were kept. If there is
  /// no memory for them, what is undone can't be redone.
  void keep_dropped(const void* words, std::size_t count);
  [[nodiscard]] const void* take_dropped(std::size_t count);

  /// Sets how far back history reaches from now on, and forgets what lies beyond.
  void limit(HistoryLimits limits);

  /// Closes a step, and forgets what lies beyond the limits then. Nothing happens if nothing was
  /// written since the last one.
  void end_step();

  /// Whether something was written since the end of the last step.
  [[nodiscard]] bool has_open_step() const {
    return !has_undone_ && writes_.end_index() != begin_of(ends_.end_index());
  }

  /// Steps that can be undone and redone.
  [[nodiscard]] std::size_t undo_count() const { return done_ - first_; }
  [[nodiscard]] std::size_t redo_count() const { return ends_.end_index() - done_; }
  /// What the notes of all steps take.
  [[nodiscard]] std::size_t bytes() const;

  /// Takes back the last step, or repeats the one taken back last: calls `exchange` with each of
  /// its writes (of several in a row with the first), whose words it exchanges with those of the
  /// mesh. False if there is none. A step underway that is taken back costs no other steps,
  /// whatever the limits are.
  template <class Exchange>
  bool undo(const Exchange& exchange) {
    close_step();
    if (undo_count() == 0) return false;
    --done_;
    for (std::size_t i = ends_[done_]; i > begin_of(done_);) {
      i -= length_of(writes_[i - 1]);
      exchange(writes_[i]);
    }
    has_undone_ = true;
    if (lost_dropped_) forget_redo();
    return true;
  }
  template <class Exchange>
  bool redo(const Exchange& exchange) {
    if (redo_count() == 0) return false;
    for (std::size_t i = begin_of(done_); i < ends_[done_]; i += length_of(writes_[i])) {
      exchange(writes_[i]);
    }
    has_undone_ = ++done_ < ends_.end_index();
    return true;
  }

  /// Forgets all steps, as when the whole mesh is replaced.
  void forget();
  /// Forgets all steps but the one underway.
  void forget_steps();
  /// Forgets the steps that were undone.
  void forget_redo() {
    if (has_undone_) forget_undone();
  }

 private:
  [[nodiscard]] static std::size_t length_of(const Write& write) {
    if (write.field == Field::kLoopLinks) return kWritesOfLoopLinks;
    return write.field == Field::kRecycledEdge ? kWritesOfRecycledEdge : 1;
  }
  [[nodiscard]] std::size_t begin_of(std::size_t step) const {
    return step == ends_.begin_index() ? writes_.begin_index() : ends_[step - 1];
  }
  [[gnu::noinline]] void record_in_new_place(Field field, Index index, Index word);
  // So that as many are in one chunk. False when memory is exhausted.
  [[nodiscard]] bool has_room_in_row(std::size_t writes) {
    if (!has_undone_ && writes_.room_in_chunk() >= writes) [[likely]]
      return true;
    return find_room_in_row(writes);
  }
  [[nodiscard, gnu::noinline]] bool find_room_in_row(std::size_t writes);
  bool close_step();
  void forget_undone();
  void forget_beyond_limits();
  void drop_forgotten();
  void lose();

  HistoryLimits limits_;
  ChunkedArray<Write, 1024> writes_;
  ChunkedArray<std::size_t, 1024> ends_;  // of the steps, in writes_
  Array<Index> dropped_;                  // what the slots held that were new in undone steps
  std::size_t first_ = 0;                 // steps before this one are forgotten
  std::size_t done_ = 0;                  // steps from here on are undone
  bool has_undone_ = false;
  bool lost_ = false;  // notes of the step underway
  bool lost_dropped_ = false;
  Index new_from_[3] = {kNone, kNone, kNone};  // vertices, halfedges, faces of the step underway
  Index taken_[4] = {kNone, kNone, kNone, kNone};  // edges of the step underway
};

}  // namespace halfedge
