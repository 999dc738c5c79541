#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/history/chunked_array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace halfedge {

/// What a note is of: words of an array, or numbers that go with the arrays.
enum class Field : std::uint32_t {
  kNext,
  kPrev,
  kToVertex,
  kFace,
  kVertexHalfedge,
  kFaceHalfedge,
  kPosition,     // of a vertex
  kVertexSlots,  // sizes of the arrays, which compact changes; no index
  kHalfedgeSlots,
  kFaceSlots,
  kNewVertices,  // the same where slots were added at the end
  kNewHalfedges,
  kNewFaces,
  kFreeListOfVertices,  // the head and the count of a free list; no index
  kFreeListOfEdges,
  kFreeListOfFaces,
  kRecycledVertex,  // the link of a slot that went to its free list, or was taken from it; the list
  kRecycledFace,
  kRecycledEdge,  // the same of an edge, with the eight links of its sides
  kLoopLinks,     // next, prev and face of a halfedge
  kWords,         // a run of words of one of the arrays before kPosition
  kAttribute,     // what an item has in a column
  kAttributeRun,  // the same of several items, from one on
  kFar,           // not a field: the index of the note lies in a word of its own
  kFiller = 31    // says nothing: it fills a chunk up, all bits set, so that each note lies in one
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

/// A record of writes, by which a mesh goes back and forth exactly. A note holds the words that a
/// write replaced; to undo a step is to exchange those of its notes with those of the arrays, last
/// one first, and to redo it, first one first. So the cost is that of what was touched: 4 bytes a
/// word, and 4 for what a note is of. Some hold several words: the links of a halfedge in its loop
/// take 16 bytes, a position as well, an edge that is deleted 36. What is written to slots that are
/// new in a step needs no note: to undo it is to drop them. What they held is kept then, for redo.
///
/// A step is all that was written since the end of the step before.
class Journal {
 public:
  /// Of one write, or of several that belong together, as it lies in the journal.
  struct Note {
    Field field;
    Index index;
    Index column;        // of attributes: its serial number; of a run of words: their field
    Index count;         // of the words
    Index* words;        // of the other state, on the tape
    std::size_t length;  // of the note on the tape, with its header
  };

  explicit Journal(HistoryLimits limits) : limits_(limits) {}

  /// Notes that `word`, at `index` of `field`, is about to be replaced. If there is no memory for
  /// it, all steps are forgotten: history then begins anew with the next step.
  void record(Field field, Index index, Index word);
  /// The same for the words of a position.
  void record_position(Index vertex, const Index (&words)[3]);
  /// The same for words from `index` of `field` on, whether their slots are new or not: one of the
  /// arrays before kPosition. It takes 4 bytes a word, and 8 for 63 of them.
  void record_words(Field field, Index index, const Index* words, std::size_t count);
  /// The same for the bytes of an item in a column, of at most kMostWords words.
  void record_attribute(Index column, Index item, const std::byte* bytes, std::size_t size) {
    record_counted(Field::kAttribute, item, column, bytes, size);
  }
  /// The same for the bytes of several items, from `item` on. A note doesn't tell how many bytes of
  /// its last word are theirs.
  void record_attribute_run(Index column, Index item, const std::byte* bytes, std::size_t size) {
    record_counted(Field::kAttributeRun, item, column, bytes, size);
  }
  static constexpr std::size_t kMostWords = 63;
  /// Columns have serial numbers below this one: there can be no more in the life of a mesh.
  static constexpr Index kMostColumns = Index{1} << 26U;

  /// The same for words of slots that aren't new in this step.
  template <std::size_t kWords>
  void record_in_old_slots(Field field, Index index, const Index (&words)[kWords]) {
    if (has_undone_ || tape_.room_in_chunk() < kWords + kMostOfHeader) [[unlikely]]
      return record_in_new_chunk(field, index, std::to_array(words));
    Index* const note = tape_.grow_in_chunk(kWords + 1);
    std::copy_n(words, kWords, note);
    end_note(note + kWords, field, index);
  }
  /// The same for the words of an edge that is about to be deleted, or to take the slot of a
  /// deleted one: then what is written to it in this step needs no note.
  void record_recycled_edge(Index edge, const Index (&words)[8], bool is_taken) {
    record_in_old_slots(Field::kRecycledEdge, edge, words);
    if (!is_taken) return;
    std::copy_backward(taken_, taken_ + 3, taken_ + 4);
    taken_[0] = edge;
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
    return !has_undone_ && tape_.end_index() != begin_of(ends_.end_index());
  }

  /// Steps that can be undone and redone.
  [[nodiscard]] std::size_t undo_count() const { return done_ - first_; }
  [[nodiscard]] std::size_t redo_count() const { return ends_.end_index() - done_; }
  /// What the notes of all steps take.
  [[nodiscard]] std::size_t bytes() const;

  /// Takes back the last step, or repeats the one taken back last: calls `exchange` with each of
  /// its notes, whose words it exchanges with those of the mesh. False if there is none. A step
  /// underway that is taken back costs no other steps, whatever the limits are.
  template <class Exchange>
  bool undo(const Exchange& exchange) {
    close_step();
    if (undo_count() == 0) return false;
    --done_;
    for (std::size_t end = ends_[done_]; end > begin_of(done_);) {
      const Note note = read(&tape_[end - 1], -1);
      exchange(note);
      turn(note);
      end -= note.length;
    }
    has_undone_ = true;
    if (lost_dropped_) forget_redo();
    return true;
  }
  template <class Exchange>
  bool redo(const Exchange& exchange) {
    if (redo_count() == 0) return false;
    for (std::size_t begin = begin_of(done_); begin < ends_[done_];) {
      const Note note = read(&tape_[begin], 1);
      turn(note);
      exchange(note);
      begin += note.length;
    }
    has_undone_ = ++done_ < ends_.end_index();
    return true;
  }

  /// What `exchange` does with a note whose words were one after the other at `stored`.
  static void exchange_words(const Note& note, Index* stored);

  /// Forgets all steps, as when the whole mesh is replaced.
  void forget();
  /// Forgets all steps but the one underway.
  void forget_steps();
  /// Forgets the steps that were undone.
  void forget_redo() {
    if (has_undone_) forget_undone();
  }

 private:
  // Notes lie on a tape of words: those of a note, and its header behind them, so that undo can
  // read it from the end. A note that was undone lies the other way round, for redo.
  //
  // The words of a header, from its outer end:
  //   field and index    of an index above kLastNear: kFar and the field
  //   index              only then
  //   column and count   only of attributes and runs of words: how many there are
  static constexpr Index kFieldBits = 5;
  static constexpr Index kCountBits = 6;
  static constexpr Index kLastNear = kNone >> kFieldBits;
  static_assert(Index(Field::kFiller) == (1U << kFieldBits) - 1);
  static_assert(kMostWords < 1U << kCountBits);
  static_assert(kMostColumns - 1 <= kNone >> kCountBits);

  static constexpr std::size_t kMostOfHeader = 3;

  [[nodiscard]] static Index header_of(Field field, Index index) {
    return index << kFieldBits | Index(field);
  }
  // Writes the header of the last note, for which there is a word, and room for another one.
  void end_note(Index* header, Field field, Index index) {
    *header = header_of(field, index);
    if (index > kLastNear) [[unlikely]]
      end_far_note(header, field, index);
  }
  [[gnu::noinline]] void end_far_note(Index* header, Field field, Index index);

  // The note whose header begins at `header` and goes on in steps of `inwards`.
  [[nodiscard]] static Note read(Index* header, std::ptrdiff_t inwards);
  static void turn(const Note& note);
  [[nodiscard]] std::size_t begin_of(std::size_t step) const {
    return step == ends_.begin_index() ? tape_.begin_index() : ends_[step - 1];
  }
  void record_counted(Field field, Index index, Index column, const void* bytes, std::size_t size);
  // For a note of so many words, in one chunk. False when memory is exhausted.
  [[nodiscard]] bool make_room(std::size_t words);
  // By value, so that what calls it needs no register or memory for the words.
  template <std::size_t kWords>
  [[gnu::noinline]] void record_in_new_chunk(Field field, Index index,
                                             std::array<Index, kWords> words) {
    if (!make_room(kWords + kMostOfHeader)) return;
    end_note(std::copy_n(words.begin(), kWords, tape_.grow_in_chunk(kWords + 1)), field, index);
  }
  bool close_step();
  void forget_undone();
  void forget_beyond_limits();
  void drop_forgotten();
  void lose();

  HistoryLimits limits_;
  ChunkedArray<Index, 4096> tape_;
  ChunkedArray<std::size_t, 1024> ends_;  // of the steps, on the tape
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
