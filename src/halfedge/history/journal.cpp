#include <halfedge/history/journal.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace halfedge {

namespace {

constexpr std::size_t kVertices = 0;
constexpr std::size_t kHalfedges = 1;
constexpr std::size_t kFaces = 2;

// Whose slots the arrays from kNext to kPositionZ have.
constexpr std::uint8_t kSlotsOf[] = {kHalfedges, kHalfedges, kHalfedges, kHalfedges, kVertices,
                                     kFaces,     kVertices,  kVertices,  kVertices};
static_assert(std::size(kSlotsOf) == std::size_t(Field::kVertexSlots));

}  // namespace

std::size_t Journal::bytes() const {
  return sizeof(Write) * (writes_.end_index() - begin_of(first_)) + sizeof(Index) * dropped_.size();
}

// Not inline: it is called wherever something is written, and mostly there is no journal at all.
// All that is rare is elsewhere, so that this needs no register to be saved.
void Journal::record(Field field, Index index, Index word) {
  if (field < Field::kVertexSlots && index >= new_from_[kSlotsOf[std::size_t(field)]]) return;
  record_in_old_slot(field, index, word);
}

void Journal::record_in_new_place(Field field, Index index, Index word) {
  forget_redo();
  if (!writes_.push_back({field, index, word})) lose();
}

void Journal::record_new(Field field, Index slots) {
  Index& new_from = new_from_[std::size_t(field) - std::size_t(Field::kNewVertices)];
  if (new_from != kNone) return;
  record(field, 0, slots);
  new_from = slots;
}

bool Journal::find_room_in_row(std::size_t writes) {
  forget_redo();
  while (writes_.room_in_chunk() < writes) {
    if (writes_.push_back({Field::kFiller, 0, 0})) continue;
    lose();
    return false;
  }
  return true;
}

void Journal::keep_dropped(const void* words, std::size_t count) {
  if (lost_dropped_ || !dropped_.reserve_more(count)) {
    lost_dropped_ = true;
    return;
  }
  std::memcpy(dropped_.end(), words, count * sizeof(Index));
  dropped_.grow_to(dropped_.size() + count);
}

const void* Journal::take_dropped(std::size_t count) {
  (void)dropped_.resize(dropped_.size() - count);
  return dropped_.end();
}

void Journal::end_step() {
  if (close_step()) forget_beyond_limits();
}

// Whether there was one.
bool Journal::close_step() {
  end_new();
  if (lost_) {  // what is left of this step can't be taken back
    forget();
    return false;
  }
  if (!has_open_step()) return false;
  if (!ends_.push_back(writes_.end_index())) {
    forget();
    return false;
  }
  done_ = ends_.end_index();
  return true;
}

void Journal::limit(HistoryLimits limits) {
  limits_ = limits;
  forget_redo();
  forget_beyond_limits();
}

void Journal::forget_beyond_limits() {
  if (limits_.are_infinite()) return;
  const std::size_t first = first_;
  while (done_ - first_ > 1 && (done_ - first_ > limits_.steps || bytes() > limits_.bytes)) {
    ++first_;
  }
  if (first_ != first) drop_forgotten();
}

void Journal::forget_steps() {
  forget_redo();
  if (first_ == done_) return;
  first_ = done_;
  drop_forgotten();
}

void Journal::drop_forgotten() {
  writes_.drop_before(begin_of(first_));
  ends_.drop_before(first_);
}

void Journal::forget() {
  writes_.clear();
  ends_.clear();
  dropped_.clear();
  first_ = done_ = 0;
  lost_ = lost_dropped_ = has_undone_ = false;
  end_new();
}

void Journal::forget_undone() {
  dropped_.clear();
  lost_dropped_ = false;
  writes_.drop_from(begin_of(done_));
  ends_.drop_from(done_);
  has_undone_ = false;
}

void Journal::lose() {
  forget();
  lost_ = true;
}

}  // namespace halfedge
