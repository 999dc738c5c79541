#pragma once

#include <halfedge/connectivity/arrow.h>
#include <halfedge/connectivity/circulators.h>
#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <iterator>

/// Handles, circulators and iterators as OpenMesh's programs use them; see openmesh.h.
namespace halfedge::dialects::openmesh {
inline namespace HALFEDGE_CHECKS {

/// One of our handles with the members of OpenMesh's. Converts silently from and to ours.
template <class Item>
class NamedHandle : public Item {
 public:
  constexpr NamedHandle() = default;
  constexpr NamedHandle(Item item) : Item(item) {}
  /// -1 is the empty handle.
  constexpr explicit NamedHandle(int idx) : Item(static_cast<Index>(idx)) {}

  [[nodiscard]] constexpr int idx() const { return static_cast<int>(this->index()); }
  [[nodiscard]] constexpr bool is_valid() const { return this->valid(); }
  constexpr void reset() { *this = NamedHandle(); }
  constexpr void invalidate() { reset(); }

  template <class Traits>
  friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                                      NamedHandle handle) {
    return out << handle.idx();
  }
};

using VertexHandle = NamedHandle<Vertex>;
using HalfedgeHandle = NamedHandle<Halfedge>;
using EdgeHandle = NamedHandle<Edge>;
using FaceHandle = NamedHandle<Face>;

/// `VertexVertexIter` and its kin: a lap around an item that is compared with its end, asked
/// `is_valid()`, and goes both ways. It counts laps, as OpenMesh's does: so it can be taken back
/// from the end. Checked builds assert on use after a change of connectivity.
template <class Mesh, class W, class View>
class LapIter {
 public:
  using Walk = W;
  using value_type = NamedHandle<typename View::Item>;
  using reference = value_type;
  using pointer = Arrow<value_type>;
  using difference_type = std::ptrdiff_t;
  using iterator_concept = std::bidirectional_iterator_tag;
  using iterator_category = std::bidirectional_iterator_tag;  // as OpenMesh's, for std::prev

  LapIter() = default;
  /// The begin of the lap from `first`, or its end. The lap of an empty `first` is empty.
  LapIter(const Mesh& mesh, Halfedge first, bool is_end = false)
      : mesh_(&mesh), first_(first), at_(first), lap_(is_end && first.valid()), stamp_(mesh) {
    if (is_valid() && shows_nothing()) ++*this;
  }

  [[nodiscard]] bool is_valid() const { return at_.valid() && lap_ == 0; }
  [[nodiscard]] reference operator*() const {
    stamp_.check(*mesh_);
    return View::of(*mesh_, at_);
  }
  [[nodiscard]] pointer operator->() const { return pointer(**this); }

  LapIter& operator++() {
    stamp_.check(*mesh_);
    do {
      at_ = Walk::on(*mesh_, at_);
      if (at_ == first_) ++lap_;
    } while (is_valid() && shows_nothing());
    return *this;
  }
  LapIter& operator--() {
    stamp_.check(*mesh_);
    do {
      if (at_ == first_) --lap_;
      at_ = Walk::back(*mesh_, at_);
    } while (is_valid() && shows_nothing());
    return *this;
  }
  LapIter operator++(int) {
    LapIter before = *this;
    ++*this;
    return before;
  }
  LapIter operator--(int) {
    LapIter before = *this;
    --*this;
    return before;
  }

  friend bool operator==(const LapIter& a, const LapIter& b) {
    return a.mesh_ == b.mesh_ && a.first_ == b.first_ && a.at_ == b.at_ && a.lap_ == b.lap_;
  }

 private:
  [[nodiscard]] bool shows_nothing() const {
    if constexpr (View::kCanBeEmpty) return !View::of(*mesh_, at_).valid();
    return false;
  }

  const Mesh* mesh_ = nullptr;
  Halfedge first_;
  Halfedge at_;
  int lap_ = 0;
  [[no_unique_address]] VersionStamp<kCheckedCirculators> stamp_;
};

/// `VertexIter` and its kin: the live items of one kind, in index order. Items may be deleted
/// meanwhile. A new one takes the slot of a deleted one, where OpenMesh appends it: a loop meets
/// that, too, if the slot is ahead. Checked builds assert on use after there were more or fewer
/// slots, for which begin and end are to be asked anew.
template <class Mesh, class Item>
class ItemIter {
 public:
  using value_type = NamedHandle<Item>;
  using reference = value_type;
  using pointer = Arrow<value_type>;
  using difference_type = std::ptrdiff_t;
  using iterator_concept = std::bidirectional_iterator_tag;
  using iterator_category = std::bidirectional_iterator_tag;  // as OpenMesh's, for std::prev

  ItemIter() = default;
  /// At the first live item from slot `at` on.
  ItemIter(const Mesh& mesh, Index at) : mesh_(&mesh), at_(at), stamp_(mesh.slots(Item{})) {
    skip_deleted();
  }

  [[nodiscard]] reference operator*() const {
    stamp_.check(mesh_->slots(Item{}));
    return Item(at_);
  }
  [[nodiscard]] pointer operator->() const { return pointer(**this); }

  ItemIter& operator++() {
    stamp_.check(mesh_->slots(Item{}));
    ++at_;
    skip_deleted();
    return *this;
  }
  /// pre: not at the first live item
  ItemIter& operator--() {
    do --at_;
    while (mesh_->is_deleted(Item(at_)));
    return *this;
  }
  ItemIter operator++(int) {
    ItemIter before = *this;
    ++*this;
    return before;
  }
  ItemIter operator--(int) {
    ItemIter before = *this;
    --*this;
    return before;
  }

  friend bool operator==(const ItemIter& a, const ItemIter& b) { return a.at_ == b.at_; }

 private:
  void skip_deleted() {
    const Index slots = mesh_->slots(Item{});
    while (at_ < slots && mesh_->is_deleted(Item(at_))) ++at_;
  }

  const Mesh* mesh_ = nullptr;
  Index at_ = 0;
  [[no_unique_address]] SlotsStamp<kCheckedCirculators> stamp_;
};

/// What a range-based for loop asks for.
template <class Iter>
class IterRange {
 public:
  IterRange(Iter begin, Iter end) : begin_(begin), end_(end) {}
  [[nodiscard]] Iter begin() const { return begin_; }
  [[nodiscard]] Iter end() const { return end_; }

 private:
  Iter begin_;
  Iter end_;
};

}  // namespace HALFEDGE_CHECKS
}  // namespace halfedge::dialects::openmesh

template <class Item>
struct std::hash<halfedge::dialects::openmesh::NamedHandle<Item>> : std::hash<Item> {};
