#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/sort.h>

#include <cstddef>
#include <span>

namespace halfedge::repair {

/// Items in the order of the smallest vertex of each, and of those that share it: by a counting
/// sort, and then among these few. To be called in the order in which the functions are here, with
/// `count` and then `put` for each item.
template <class Item>
class ByVertex {
 public:
  /// False when memory is exhausted.
  [[nodiscard]] bool prepare(std::size_t vertices, std::size_t items) {
    begin_.clear();
    return begin_.resize(vertices + 2, 0) && items_.recreate(items);
  }
  void count(Index smallest) { ++begin_[smallest + 2]; }
  void divide() {
    for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  }
  void put(Index smallest, const Item& item) { items_[begin_[smallest + 1]++] = item; }
  template <class Less>
  void sort(const Less& less) {
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) {
      introsort(items_.begin() + begin_[v], items_.begin() + begin_[v + 1], less);
    }
  }

  [[nodiscard]] const Item& operator[](std::size_t i) const { return items_[i]; }
  [[nodiscard]] std::span<const Item> between(Index begin, Index end) const {
    return items_.span().subspan(begin, end - begin);
  }
  /// Calls `visit` with the smallest vertex, the first and the end of the items that are the same,
  /// in turn.
  template <class IsSame, class Visit>
  void for_each_group(const IsSame& is_same, const Visit& visit) const {
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) {
      const Index end = begin_[v + 1];
      for (Index i = begin_[v], next = i; i < end; i = next) {
        while (next < end && is_same(items_[i], items_[next])) ++next;
        visit(Index(v), i, next);
      }
    }
  }

 private:
  Array<Index> begin_;  // by vertex: of the items whose smallest it is
  Array<Item> items_;
};

}  // namespace halfedge::repair
