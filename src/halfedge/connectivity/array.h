#pragma once

#include <halfedge/inlining.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

namespace halfedge {

namespace internal {

/// How much room to make for `count` elements where there is some for `capacity`, fewer than that:
/// half as much again at least, so that a sequence of additions is amortised O(1) each.
[[nodiscard]] constexpr std::size_t ample_capacity(std::size_t count, std::size_t capacity) {
  return std::max(count, capacity + capacity / 2 + 16);
}

/// realloc(data, count * size), empty if that is more than there can be or than there is.
[[nodiscard]] HALFEDGE_NOINLINE void* reallocate(void* data, std::size_t count, std::size_t size);

/// The same with ample_capacity(count, capacity), or if that is more than there is with `count`;
/// sets `capacity` to what there is room for.
[[nodiscard]] HALFEDGE_NOINLINE void* reallocate_amply(void* data, std::size_t count,
                                                       std::size_t size, std::size_t& capacity);

}  // namespace internal

/// A contiguous array that reports a failed allocation instead of aborting: the core is built
/// without exceptions, and a mesh too large for memory must end in an error.
///
/// Elements are trivially copyable. `resize` leaves new elements uninitialised (the bulk builder
/// writes each of them exactly once); growth by `push_back` is amortised, `resize` is exact.
/// Every function that allocates returns false when memory is exhausted; it has then changed
/// nothing, but for `recreate` and `assign`, which leave the array empty. Growing and
/// `shrink_to_fit` invalidate pointers and spans into the array; `resize` to less doesn't.
template <class T>
class Array {
  static_assert(std::is_trivially_copyable_v<T>, "Array moves its elements with memcpy");

 public:
  using value_type = T;

  Array() = default;
  Array(Array&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)),
        size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  Array& operator=(Array&& other) noexcept {
    if (this != &other) {
      std::free(data_);
      data_ = std::exchange(other.data_, nullptr);
      size_ = std::exchange(other.size_, 0);
      capacity_ = std::exchange(other.capacity_, 0);
    }
    return *this;
  }
  Array(const Array&) = delete;  // a copy can fail: use assign()
  Array& operator=(const Array&) = delete;
  ~Array() { std::free(data_); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] T& operator[](std::size_t i) {
    assert(i < size_);
    return data_[i];
  }
  [[nodiscard]] const T& operator[](std::size_t i) const {
    assert(i < size_);
    return data_[i];
  }
  [[nodiscard]] T* begin() { return data_; }
  [[nodiscard]] T* end() { return data_ + size_; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }
  [[nodiscard]] std::span<T> span() { return {data_, size_}; }
  [[nodiscard]] std::span<const T> span() const { return {data_, size_}; }

  /// Makes room for `count` elements in all. Keeps the contents.
  [[nodiscard]] bool reserve(std::size_t count) {
    if (count <= capacity_) return true;
    void* grown = internal::reallocate(static_cast<void*>(data_), count, sizeof(T));
    if (grown == nullptr) return false;
    data_ = static_cast<T*>(grown);
    capacity_ = count;
    return true;
  }

  /// Changes the size to exactly `count`. New elements are uninitialised.
  [[nodiscard]] bool resize(std::size_t count) {
    if (!reserve(count)) return false;
    size_ = count;
    return true;
  }

  /// As `resize`, where there is room for so many already.
  void grow_to(std::size_t count) {
    assert(count <= capacity_);
    size_ = count;
  }

  /// As `resize`, and sets the new elements to `value`.
  [[nodiscard]] bool resize(std::size_t count, const T& value) {
    const std::size_t old = size_;
    const T copy = value;  // value may lie in this array
    if (!resize(count)) return false;
    for (std::size_t i = old; i < count; ++i) data_[i] = copy;
    return true;
  }

  /// Drops the contents first, so that growing copies nothing; then as `resize(count)`.
  [[nodiscard]] bool recreate(std::size_t count) {
    if (count > capacity_) {
      reset();
      void* fresh = internal::reallocate(nullptr, count, sizeof(T));
      if (fresh == nullptr) return false;
      data_ = static_cast<T*>(fresh);
      capacity_ = count;
    }
    size_ = count;
    return true;
  }

  /// Gives back the memory beyond the elements. Keeps it if the allocator can't.
  void shrink_to_fit() {
    if (size_ == capacity_) return;
    if (size_ == 0) return reset();
    void* shrunk = internal::reallocate(static_cast<void*>(data_), size_, sizeof(T));
    if (shrunk == nullptr) return;
    data_ = static_cast<T*>(shrunk);
    capacity_ = size_;
  }

  /// As `reserve`, and then some if it must: for arrays that grow bit by bit, amortised O(1) each.
  [[nodiscard]] bool reserve_amply(std::size_t count) {
    if (count <= capacity_) return true;
    void* grown =
        internal::reallocate_amply(static_cast<void*>(data_), count, sizeof(T), capacity_);
    if (grown == nullptr) return false;
    data_ = static_cast<T*>(grown);
    return true;
  }

  /// The same for `count` elements more.
  [[nodiscard]] bool reserve_more(std::size_t count) { return reserve_amply(size_ + count); }

  /// Appends one element; amortised O(1).
  [[nodiscard]] bool push_back(const T& value) {
    const T copy = value;  // value may lie in this array
    if (size_ == capacity_ && !reserve_more(1)) return false;
    data_[size_++] = copy;
    return true;
  }

  void pop_back() {
    assert(size_ > 0);
    --size_;
  }

  /// Becomes a copy of `other`, which may be a part of this array.
  [[nodiscard]] bool assign(std::span<const T> other) {
    if (!recreate(other.size())) return false;
    if (!other.empty()) std::memmove(static_cast<void*>(data_), other.data(), other.size_bytes());
    return true;
  }

  /// Forgets the elements, keeps the memory.
  void clear() { size_ = 0; }

  /// Gives up the memory and returns it, to be freed with std::free.
  [[nodiscard]] T* release() {
    size_ = capacity_ = 0;
    return std::exchange(data_, nullptr);
  }

  /// Forgets the elements and frees the memory.
  void reset() {
    std::free(data_);
    data_ = nullptr;
    size_ = capacity_ = 0;
  }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace halfedge
