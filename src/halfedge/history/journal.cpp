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

// Whose slots the arrays from kNext to kFaceHalfedge have.
constexpr std::uint8_t kSlotsOf[] = {kHalfedges, kHalfedges, kHalfedges,
                                     kHalfedges, kVertices,  kFaces};
static_assert(std::size(kSlotsOf) == std::size_t(Field::kFaceHalfedge) + 1);

// How many words a note has, where its header doesn't tell.
Index words_of(Field field) {
  switch (field) {
    case Field::kFiller:
      return 0;
    case Field::kFreeListOfVertices:
    case Field::kFreeListOfEdges:
    case Field::kFreeListOfFaces:
      return 2;
    case Field::kPosition:
    case Field::kLoopLinks:
      return 3;
    case Field::kRecycledEdge:
      return 8;
    default:
      return 1;
  }
}

bool is_counted(Field field) {
  return field == Field::kWords || field == Field::kAttribute || field == Field::kAttributeRun;
}

}  // namespace

std::size_t Journal::bytes() const {
  return sizeof(Index) * (tape_.end_index() - begin_of(first_) + dropped_.size());
}

// Not inline: it is called wherever something is written, and mostly there is no journal at all.
// All that is rare is elsewhere, so that this needs no register to be saved.
void Journal::record(Field field, Index index, Index word) {
  if (field <= Field::kFaceHalfedge && index >= new_from_[kSlotsOf[std::size_t(field)]]) return;
  record_in_old_slots(field, index, {word});
}

void Journal::record_position(Index vertex, const Index (&words)[3]) {
  if (vertex < new_from_[kVertices]) record_in_old_slots(Field::kPosition, vertex, words);
}

void Journal::record_words(Field field, Index index, const Index* words, std::size_t count) {
  for (std::size_t begin = 0; begin < count; begin += kMostWords) {
    const std::size_t run = std::min(count - begin, kMostWords);
    record_counted(Field::kWords, index + Index(begin), Index(field), words + begin,
                   run * sizeof(Index));
  }
}

void Journal::record_counted(Field field, Index index, Index column, const void* bytes,
                             std::size_t size) {
  const std::size_t count = (size + sizeof(Index) - 1) / sizeof(Index);
  if (!make_room(count + kMostOfHeader)) return;
  Index* const words = tape_.grow_in_chunk(count + 2);
  words[count - 1] = 0;  // of which there may be bytes behind the last
  std::memcpy(words, bytes, size);
  words[count] = column << kCountBits | Index(count);
  end_note(words + count + 1, field, index);
}

void Journal::end_far_note(Index* header, Field field, Index index) {
  header[0] = index;
  *tape_.grow_in_chunk(1) = header_of(Field::kFar, Index(field));
}

void Journal::record_new(Field field, Index slots) {
  Index& new_from = new_from_[std::size_t(field) - std::size_t(Field::kNewVertices)];
  if (new_from != kNone) return;
  record(field, 0, slots);
  new_from = slots;
}

bool Journal::make_room(std::size_t words) {
  forget_redo();
  if (tape_.room_in_chunk() >= words) return true;
  const std::size_t left = tape_.room_in_chunk();
  std::fill_n(tape_.grow_in_chunk(left), left, header_of(Field::kFiller, kLastNear));
  if (tape_.add_chunk()) return true;
  lose();
  return false;
}

Journal::Note Journal::read(Index* header, std::ptrdiff_t inwards) {
  Note note{};
  const auto next_word = [&] { return header[inwards * std::ptrdiff_t(note.length++)]; };
  const Index first = next_word();
  note.field = Field(first & ((1U << kFieldBits) - 1));
  note.index = first >> kFieldBits;
  if (note.field == Field::kFar) {
    note.field = Field(note.index);
    note.index = next_word();
  }
  note.count = words_of(note.field);
  if (is_counted(note.field)) {
    const Index column = next_word();
    note.column = column >> kCountBits;
    note.count = column & ((1U << kCountBits) - 1);
  }
  note.length += note.count;
  note.words = inwards < 0 ? header + 1 - note.length : header;
  return note;
}

void Journal::turn(const Note& note) { std::reverse(note.words, note.words + note.length); }

void Journal::exchange_words(const Note& note, Index* stored) {
  std::swap_ranges(note.words, note.words + note.count, stored);
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
  if (!ends_.push_back(tape_.end_index())) {
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
  tape_.drop_before(begin_of(first_));
  ends_.drop_before(first_);
}

void Journal::forget() {
  tape_.clear();
  ends_.clear();
  dropped_.clear();
  first_ = done_ = 0;
  lost_ = lost_dropped_ = has_undone_ = false;
  end_new();
}

void Journal::forget_undone() {
  dropped_.clear();
  lost_dropped_ = false;
  tape_.drop_from(begin_of(done_));
  ends_.drop_from(done_);
  has_undone_ = false;
}

void Journal::lose() {
  forget();
  lost_ = true;
}

}  // namespace halfedge
