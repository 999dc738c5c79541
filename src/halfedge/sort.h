#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <iterator>
#include <span>
#include <utility>

namespace halfedge {

namespace internal {

template <class T, class Less>
void insertion_sort(T* first, T* last, Less& less) {
  for (T* end = first; end < last; ++end) {
    T moved = std::move(*end);
    T* hole = end;
    for (; hole != first && less(moved, hole[-1]); --hole) *hole = std::move(hole[-1]);
    *hole = std::move(moved);
  }
}

template <class T, class Less>
void sift_down(T* heap, std::size_t count, std::size_t hole, Less& less) {
  T moved = std::move(heap[hole]);
  for (std::size_t child; (child = 2 * hole + 1) < count; hole = child) {
    if (child + 1 < count && less(heap[child], heap[child + 1])) ++child;
    if (!less(moved, heap[child])) break;
    heap[hole] = std::move(heap[child]);
  }
  heap[hole] = std::move(moved);
}

template <class T, class Less>
void heap_sort(T* first, std::size_t count, Less& less) {
  for (std::size_t root = count / 2; root-- > 0;) sift_down(first, count, root, less);
  while (count > 1) {
    std::swap(first[0], first[--count]);
    sift_down(first, count, 0, less);
  }
}

// Hoare's partition around the median of three; returns where the upper part begins. Neither part
// is empty.
template <class T, class Less>
T* partition(T* first, T* last, Less& less) {
  T* low = first;
  T* middle = first + (last - first) / 2;
  T* high = last - 1;
  if (less(*middle, *low)) std::swap(*middle, *low);
  if (less(*high, *middle)) std::swap(*high, *middle);
  if (less(*middle, *low)) std::swap(*middle, *low);
  const T pivot = *middle;
  for (;;) {
    while (less(*low, pivot)) ++low;
    while (less(pivot, *high)) --high;
    if (low >= high) return low == high ? low + 1 : low;
    std::swap(*low++, *high--);
  }
}

template <class T, class Less>
void introsort(T* first, T* last, std::size_t rounds, Less& less) {
  constexpr std::ptrdiff_t kFew = 16;
  while (last - first > kFew) {
    if (rounds-- == 0) return heap_sort(first, std::size_t(last - first), less);
    T* const upper = partition(first, last, less);
    if (upper - first < last - upper) {
      introsort(first, upper, rounds, less);
      first = upper;
    } else {
      introsort(upper, last, rounds, less);
      last = upper;
    }
  }
  insertion_sort(first, last, less);
}

}  // namespace internal

/// Sorts as std::sort does, not stably, in a quarter of the compiled code: one instantiation for
/// each order adds up. Quicksort, with heapsort where it goes wrong. cost: O(n log n)
/// pre: `less` is a strict weak order, `T` can be copied.
template <class T, class Less = std::less<>>
void introsort(T* first, T* last, Less less = {}) {
  internal::introsort(first, last, std::size_t(2 * std::bit_width(std::size_t(last - first))),
                      less);
}
template <class Range, class Less = std::less<>>
requires requires(Range&& range) { std::data(range); }
void introsort(Range&& range, Less less = {}) {
  introsort(std::data(range), std::data(range) + std::size(range), less);
}

/// Sorts, and finds an item that occurs twice; else `Item{}`. cost: O(n log n)
template <class Item>
[[nodiscard]] Item sort_and_find_repeated(std::span<Item> items) {
  introsort(items);
  const auto repeated = std::adjacent_find(items.begin(), items.end());
  return repeated == items.end() ? Item{} : *repeated;
}

}  // namespace halfedge
