#pragma once

#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <iterator>

namespace halfedge {

/// The live items of one kind in index order; deleted slots are stepped over.
template <class Mesh, class Item>
class LiveRange {
 public:
  class Iterator {
   public:
    using value_type = Item;
    using reference = Item;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::forward_iterator_tag;
    using iterator_category = std::input_iterator_tag;  // references are values
    using pointer = void;

    Iterator() = default;
    Iterator(const Mesh& mesh, Index at) : mesh_(&mesh), at_(at), at_end_(false) { skip_deleted(); }

    [[nodiscard]] Item operator*() const { return Item(at_); }
    Iterator& operator++() {
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
  };

  explicit LiveRange(const Mesh& mesh) : mesh_(&mesh) {}

  [[nodiscard]] Iterator begin() const { return Iterator(*mesh_, 0); }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }
  [[nodiscard]] bool empty() const { return begin() == end(); }

 private:
  const Mesh* mesh_;
};

}  // namespace halfedge
