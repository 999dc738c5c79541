#pragma once

#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <span>
#include <type_traits>

namespace halfedge {

/// Items of one kind that a function is given: a handle, several, or the indices of several, in
/// anything that a std::span can be made of. A view, owning nothing: what it is made of has to
/// outlive it, as a temporary does that is made for the call.
template <class Item>
class ItemSpan {
 public:
  constexpr ItemSpan() = default;
  ItemSpan(const Item& item) : ItemSpan(std::span<const Item>(&item, 1)) {}
  template <class Range>
  requires std::is_convertible_v<const Range&, std::span<const Item>> ItemSpan(const Range& items)
      : indices_(indices_of(items)) {}
  template <class Range>
  requires std::is_convertible_v<const Range&, std::span<const Index>>
  constexpr ItemSpan(const Range& indices) : indices_(indices) {}

  [[nodiscard]] constexpr std::span<const Index> indices() const { return indices_; }
  [[nodiscard]] constexpr std::size_t size() const { return indices_.size(); }

 private:
  // A handle is an index and nothing else, so handles in a row are indices in a row.
  static std::span<const Index> indices_of(std::span<const Item> items) {
    static_assert(sizeof(Item) == sizeof(Index) && std::is_standard_layout_v<Item>);
    return {reinterpret_cast<const Index*>(items.data()), items.size()};
  }

  std::span<const Index> indices_;
};

}  // namespace halfedge
