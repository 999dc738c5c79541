#include <halfedge/history/journal.h>

#include <algorithm>

namespace halfedge {

std::size_t Journal::bytes() const { return sizeof(Write) * (writes_.size() - begin_of(first_)); }

// Not inline: it is called wherever something is written, and mostly there is no journal at all.
void Journal::record(Field field, Index index, Index word) {
  forget_redo();
  if (!writes_.push_back({field, index, word})) lose();
  step_end_ = writes_.size();
}

void Journal::end_step() {
  if (lost_) {  // what is left of this step can't be taken back
    forget();
    return;
  }
  if (!has_open_step()) return;
  if (!ends_.push_back(writes_.size())) {
    forget();
    return;
  }
  done_ = ends_.size();
  forget_beyond_limits();
}

void Journal::limit(HistoryLimits limits) {
  limits_ = limits;
  forget_redo();
  forget_beyond_limits();
}

void Journal::forget_beyond_limits() {
  while (done_ - first_ > 1 && (done_ - first_ > limits_.steps || bytes() > limits_.bytes)) {
    ++first_;
  }
  forget_oldest();
}

void Journal::forget() {
  writes_.clear();
  ends_.clear();
  first_ = done_ = step_end_ = 0;
  lost_ = false;
}

void Journal::forget_undone() {
  (void)writes_.resize(step_end_);  // no larger than they are
  (void)ends_.resize(done_);
}

// Moves the notes down once half of them are forgotten, so that each is moved once on average.
void Journal::forget_oldest() {
  const std::size_t gone = begin_of(first_);
  if (2 * gone < writes_.size()) return;
  std::copy(writes_.begin() + gone, writes_.end(), writes_.begin());
  (void)writes_.resize(writes_.size() - gone);
  for (std::size_t step = first_; step < ends_.size(); ++step) {
    ends_[step - first_] = ends_[step] - gone;
  }
  (void)ends_.resize(ends_.size() - first_);
  done_ -= first_;
  first_ = 0;
  step_end_ = writes_.size();
}

void Journal::lose() {
  forget();
  lost_ = true;
}

}  // namespace halfedge
