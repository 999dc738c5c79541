#pragma once

#include <halfedge/connectivity/array.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace halfedge {

/// A sequence that grows at its end and shrinks at both. Its elements lie in chunks of `kChunk`, so
/// that to grow moves none of them, and what is dropped gives its memory back.
template <class T, std::size_t kChunk>
class ChunkedArray {
  static_assert((kChunk & (kChunk - 1)) == 0, "so that places are found by shifting");

 public:
  ChunkedArray() = default;
  ChunkedArray(const ChunkedArray&) = delete;
  ChunkedArray& operator=(const ChunkedArray&) = delete;
  ~ChunkedArray() { clear(); }

  /// Elements are counted from the first ever added: those before begin_index() were dropped.
  [[nodiscard]] std::size_t begin_index() const { return begin_; }
  [[nodiscard]] std::size_t end_index() const {
    return (first_chunk_ + chunks_.size()) * kChunk - std::size_t(chunk_end_ - next_);
  }

  [[nodiscard]] T& operator[](std::size_t i) {
    assert(begin_ <= i && i < end_index());
    return chunk_of(i)[i % kChunk];
  }
  [[nodiscard]] const T& operator[](std::size_t i) const {
    assert(begin_ <= i && i < end_index());
    return chunk_of(i)[i % kChunk];
  }

  /// False when memory is exhausted. O(1) on average.
  [[nodiscard]] bool push_back(const T& value) {
    if (next_ == chunk_end_ && !add_chunk()) [[unlikely]]
      return false;
    *next_++ = value;
    return true;
  }

  /// Adds so many elements, which are yet to be written.
  /// pre: room_in_chunk() >= count
  [[nodiscard]] T* grow_in_chunk(std::size_t count) { return std::exchange(next_, next_ + count); }

  /// How many elements more fit into the last chunk.
  [[nodiscard]] std::size_t room_in_chunk() const { return std::size_t(chunk_end_ - next_); }

  /// Makes room for elements in a new chunk. False when memory is exhausted. Not inline, so that to
  /// add an element is short.
  /// pre: room_in_chunk() == 0
  [[nodiscard, gnu::noinline]] bool add_chunk() {
    auto* chunk = static_cast<T*>(std::malloc(kChunk * sizeof(T)));
    if (chunk == nullptr || !chunks_.push_back({chunk})) {
      std::free(chunk);
      return false;
    }
    next_ = chunk;
    chunk_end_ = chunk + kChunk;
    return true;
  }

  /// Drops the elements from `end` on.
  void drop_from(std::size_t end) {
    while (!chunks_.empty() && (first_chunk_ + chunks_.size() - 1) * kChunk >= end) {
      std::free(chunks_[chunks_.size() - 1].elements);
      chunks_.pop_back();
    }
    set_end(end);
  }

  /// Drops the elements before `begin`. O(chunks) where it frees one.
  void drop_before(std::size_t begin) {
    begin_ = begin;
    const std::size_t gone = begin_ / kChunk - first_chunk_;
    if (gone == 0) return;
    for (std::size_t i = 0; i < gone; ++i) std::free(chunks_[i].elements);
    std::copy(chunks_.begin() + gone, chunks_.end(), chunks_.begin());
    (void)chunks_.resize(chunks_.size() - gone);  // no larger than it is
    first_chunk_ += gone;
    if (chunks_.empty()) set_end(begin_);
  }

  /// Drops all of them, and counts from 0 again.
  void clear() {
    for (const Chunk& chunk : chunks_) std::free(chunk.elements);
    chunks_.reset();
    begin_ = first_chunk_ = 0;
    set_end(0);
  }

 private:
  struct Chunk {
    T* elements;
  };

  [[nodiscard]] T* chunk_of(std::size_t i) const {
    return chunks_[i / kChunk - first_chunk_].elements;
  }

  // Where the last chunk ends that `end` needs.
  void set_end(std::size_t end) {
    if (chunks_.empty()) {
      next_ = chunk_end_ = nullptr;
      return;
    }
    T* last = chunks_[chunks_.size() - 1].elements;
    chunk_end_ = last + kChunk;
    next_ = last + (end - (first_chunk_ + chunks_.size() - 1) * kChunk);
  }

  Array<Chunk> chunks_;
  std::size_t first_chunk_ = 0;
  std::size_t begin_ = 0;
  T* next_ = nullptr;  // behind the last element, in the last chunk
  T* chunk_end_ = nullptr;
};

}  // namespace halfedge
