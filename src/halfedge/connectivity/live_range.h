#pragma once

#include <halfedge/connectivity/arrow.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/version_stamp.h>

#include <cstddef>
#include <iterator>
#include <version>

#if defined(__cpp_lib_ranges)
#include <ranges>
#endif

namespace halfedge {

/// The live items of one kind in index order; deleted slots are stepped over. Items may be deleted
/// meanwhile; one that is made in a deleted slot ahead is met. Invalidated by what makes more slots
/// of the kind, or fewer: a loop that adds items in each round would meet these, too, and not end.
/// Checked builds assert on use after that.
template <class Mesh, class Item, bool Checked = kCheckedCirculators>
class LiveRange {
 public:
  class Iterator {
   public:
    using value_type = Item;
    using reference = Item;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::forward_iterator_tag;
    using iterator_category = std::input_iterator_tag;  // references are values
    using pointer = Arrow<value_type>;

    Iterator() = default;
    Iterator(const Mesh& mesh, Index at)
        : mesh_(&mesh), at_(at), at_end_(false), stamp_(mesh.slots(Item{})) {
      skip_deleted();
    }

    [[nodiscard]] Item operator*() const {
      stamp_.check(mesh_->slots(Item{}));
      return Item(at_);
    }
    [[nodiscard]] pointer operator->() const { return pointer(**this); }
    Iterator& operator++() {
      stamp_.check(mesh_->slots(Item{}));
      ++at_;
      skip_deleted();
      return *this;
    }
    Iterator operator++(int) {
      Iterator before = *this;
      ++*this;
      return before;
    }

    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }
    friend bool operator==(const Iterator& a, std::default_sentinel_t) { return a.at_end_; }

   private:
    void skip_deleted() {
      for (const Index slots = mesh_->slots(Item{}); at_ < slots; ++at_) {
        if (!mesh_->has_deleted(Item{}) || !mesh_->is_deleted(Item(at_))) return;
      }
      at_end_ = true;
    }

    const Mesh* mesh_ = nullptr;
    Index at_ = 0;
    bool at_end_ = true;
    [[no_unique_address]] SlotsStamp<Checked> stamp_;
  };

  explicit LiveRange(const Mesh& mesh) : mesh_(&mesh), stamp_(mesh.slots(Item{})) {}

  [[nodiscard]] Iterator begin() const {
    stamp_.check(mesh_->slots(Item{}));
    return Iterator(*mesh_, 0);
  }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }
  [[nodiscard]] bool empty() const { return begin() == end(); }

 private:
  const Mesh* mesh_;
  [[no_unique_address]] SlotsStamp<Checked> stamp_;
};

}  // namespace halfedge

#if defined(__cpp_lib_ranges)
/// It owns nothing, and its iterators don't need it: see Orbit.
template <class Mesh, class Item, bool Checked>
inline constexpr bool std::ranges::enable_view<halfedge::LiveRange<Mesh, Item, Checked>> = true;
template <class Mesh, class Item, bool Checked>
inline constexpr bool std::ranges::enable_borrowed_range<halfedge::LiveRange<Mesh, Item, Checked>> =
    true;
#endif
