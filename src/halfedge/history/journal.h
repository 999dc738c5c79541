#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

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
  kVertexSlots,  // sizes of the arrays; no index
  kHalfedgeSlots,
  kFaceSlots,
  kFreeVertices,  // free lists; index 0: the head, 1: the count
  kFreeEdges,
  kFreeFaces,
  kFirstAttribute  // attributes have numbers from here on
};

/// How far back history reaches. The oldest steps are forgotten first; the last one is kept in any
/// case.
struct HistoryLimits {
  std::size_t steps = std::numeric_limits<std::size_t>::max();
  std::size_t bytes = std::numeric_limits<std::size_t>::max();
};

/// A record of writes, by which a mesh goes back and forth exactly. Each write is noted with the
/// word that it replaced; to undo a step is to exchange its words with those of the arrays, last
/// one first, and to redo it, first one first. So the cost is that of what was touched, 12 bytes a
/// word.
///
/// A step is all that was written since the end of the step before.
class Journal {
 public:
  struct Write {
    Field field;
    Index index;
    Index word;  // of the other state
  };

  explicit Journal(HistoryLimits limits) : limits_(limits) {}

  /// Notes that `word`, at `index` of `field`, is about to be replaced. If there is no memory for
  /// it, all steps are forgotten: history then begins anew with the next step.
  void record(Field field, Index index, Index word);

  /// Sets how far back history reaches from now on, and forgets what lies beyond.
  void limit(HistoryLimits limits);

  /// Closes a step. Nothing happens if nothing was written since the last one.
  void end_step();

  /// Whether something was written since the end of the last step.
  [[nodiscard]] bool has_open_step() const {
    return step_end_ == writes_.size() && writes_.size() != begin_of(ends_.size());
  }

  /// Steps that can be undone and redone.
  [[nodiscard]] std::size_t undo_count() const { return done_ - first_; }
  [[nodiscard]] std::size_t redo_count() const { return ends_.size() - done_; }
  /// What the notes of all steps take.
  [[nodiscard]] std::size_t bytes() const;

  /// Takes back the last step, or repeats the one taken back last: calls `exchange` with each of
  /// its writes, whose word it exchanges with that of the mesh. False if there is none.
  template <class Exchange>
  bool undo(const Exchange& exchange) {
    end_step();
    if (undo_count() == 0) return false;
    --done_;
    for (std::size_t i = ends_[done_]; i-- > begin_of(done_);) exchange(writes_[i]);
    step_end_ = begin_of(done_);
    return true;
  }
  template <class Exchange>
  bool redo(const Exchange& exchange) {
    if (redo_count() == 0) return false;
    for (std::size_t i = begin_of(done_); i < ends_[done_]; ++i) exchange(writes_[i]);
    step_end_ = ends_[done_++];
    return true;
  }

  /// Forgets all steps, as when the whole mesh is replaced.
  void forget();
  /// Forgets the steps that were undone.
  void forget_redo() {
    if (step_end_ != writes_.size()) forget_undone();
  }

 private:
  [[nodiscard]] std::size_t begin_of(std::size_t step) const {
    return step == 0 ? 0 : ends_[step - 1];
  }
  void forget_undone();
  void forget_beyond_limits();
  void forget_oldest();
  void lose();

  HistoryLimits limits_;
  Array<Write> writes_;
  Array<std::size_t> ends_;   // of the steps, in writes_
  std::size_t first_ = 0;     // steps before this one are forgotten
  std::size_t done_ = 0;      // steps from here on are undone
  std::size_t step_end_ = 0;  // of the writes that are done
  bool lost_ = false;         // notes of the step underway
};

}  // namespace halfedge
