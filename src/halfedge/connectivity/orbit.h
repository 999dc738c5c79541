#pragma once

#include <halfedge/connectivity/arrow.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/version_stamp.h>

#include <cassert>
#include <cstddef>
#include <iterator>
#include <version>

#if defined(__cpp_lib_ranges)
#include <ranges>
#endif

/// An orbit: halfedges reached by one step again and again, each shown as some item. It has a
/// *walk* (how to step on, and back) and a *view* (what to show of a halfedge). All kinds of
/// circulators are combinations of five walks and six views:
///
///            to(h)
///             ^ |            rotate_cw (h) = next(opposite(h))     both leave from(h)
///           h | | opposite   rotate_ccw(h) = opposite(prev(h))
///             | v
///           from(h)          face(h) lies to the left of h
namespace halfedge {

namespace walk {

struct RotateCw {
  static Halfedge on(const auto& mesh, Halfedge h) { return mesh.rotate_cw(h); }
  static Halfedge back(const auto& mesh, Halfedge h) { return mesh.rotate_ccw(h); }
};
struct RotateCcw {
  static Halfedge on(const auto& mesh, Halfedge h) { return mesh.rotate_ccw(h); }
  static Halfedge back(const auto& mesh, Halfedge h) { return mesh.rotate_cw(h); }
};
struct LoopCcw {
  static Halfedge on(const auto& mesh, Halfedge h) { return mesh.next(h); }
  static Halfedge back(const auto& mesh, Halfedge h) { return mesh.prev(h); }
};
struct LoopCw {
  static Halfedge on(const auto& mesh, Halfedge h) { return mesh.prev(h); }
  static Halfedge back(const auto& mesh, Halfedge h) { return mesh.next(h); }
};
struct AcrossEdge {
  static Halfedge on(const auto& mesh, Halfedge h) { return mesh.opposite(h); }
  static Halfedge back(const auto& mesh, Halfedge h) { return mesh.opposite(h); }
};

}  // namespace walk

namespace view {

/// A view that can be empty (no face on this side) makes the orbit skip that halfedge.
struct Self {
  using Item = Halfedge;
  static constexpr bool kCanBeEmpty = false;
  static Item of(const auto&, Halfedge h) { return h; }
};
struct Opposite {
  using Item = Halfedge;
  static constexpr bool kCanBeEmpty = false;
  static Item of(const auto& mesh, Halfedge h) { return mesh.opposite(h); }
};
struct ToVertex {
  using Item = Vertex;
  static constexpr bool kCanBeEmpty = false;
  static Item of(const auto& mesh, Halfedge h) { return mesh.to_vertex(h); }
};
struct ItsEdge {
  using Item = Edge;
  static constexpr bool kCanBeEmpty = false;
  static Item of(const auto& mesh, Halfedge h) { return mesh.edge(h); }
};
struct ItsFace {
  using Item = Face;
  static constexpr bool kCanBeEmpty = true;
  static Item of(const auto& mesh, Halfedge h) { return mesh.face(h); }
};
struct OppositeFace {
  using Item = Face;
  static constexpr bool kCanBeEmpty = true;
  static Item of(const auto& mesh, Halfedge h) { return mesh.face(mesh.opposite(h)); }
};

}  // namespace view

/// Endless and bidirectional: it has no end, it stops when you say so. `halfedge()` is where it
/// stands, `*c` what the kind of circulator shows of it. Empty (`!valid()`) where there is nothing
/// to visit: then nothing else may be asked. Invalidated by any change of connectivity; checked
/// builds assert on use after that.
template <class Mesh, class Walk, class View, bool Checked = kCheckedCirculators>
class Circulator {
 public:
  using value_type = typename View::Item;
  using reference = value_type;
  using pointer = Arrow<value_type>;
  using difference_type = std::ptrdiff_t;
  using iterator_concept = std::bidirectional_iterator_tag;
  // Although references are values: std::prev of an input iterator would go forward without end.
  using iterator_category = std::bidirectional_iterator_tag;

  Circulator() = default;
  Circulator(const Mesh& mesh, Halfedge start) : mesh_(&mesh), at_(start), stamp_(mesh) {
    if (at_.valid()) settle<&Walk::template on<Mesh>>();
  }

  [[nodiscard]] bool valid() const { return at_.valid(); }
  [[nodiscard]] Halfedge halfedge() const {
    if (valid()) stamp_.check(*mesh_);
    return at_;
  }
  [[nodiscard]] reference operator*() const {
    check();
    return View::of(*mesh_, at_);
  }
  [[nodiscard]] pointer operator->() const { return pointer(**this); }

  Circulator& operator++() {
    check();
    at_ = Walk::on(*mesh_, at_);
    settle<&Walk::template on<Mesh>>();
    return *this;
  }
  Circulator& operator--() {
    check();
    at_ = Walk::back(*mesh_, at_);
    settle<&Walk::template back<Mesh>>();
    return *this;
  }
  Circulator operator++(int) {
    Circulator before = *this;
    ++*this;
    return before;
  }
  Circulator operator--(int) {
    Circulator before = *this;
    --*this;
    return before;
  }

  friend bool operator==(const Circulator& a, const Circulator& b) { return a.at_ == b.at_; }

 private:
  void check() const {
    assert(valid() && "a circulator was used that has nothing to visit: ask valid() first");
    stamp_.check(*mesh_);
  }

  // Steps over halfedges that show nothing; empty if a whole lap shows nothing.
  template <auto Step>
  void settle() {
    if constexpr (View::kCanBeEmpty) {
      const Halfedge lap = at_;
      while (!View::of(*mesh_, at_).valid()) {
        at_ = Step(*mesh_, at_);
        if (at_ == lap) {
          at_ = Halfedge{};
          return;
        }
      }
    }
  }

  const Mesh* mesh_ = nullptr;
  Halfedge at_;
  [[no_unique_address]] VersionStamp<Checked> stamp_;
};

/// One lap as a range: `for (Vertex w : mesh.vertex_vertices_ccw(v))`. A forward range without
/// allocation or lap counter: an iterator marks the end by forgetting where it is, so `it == it`
/// always holds and the orbit of an isolated vertex is empty. It is a view and a borrowed range in
/// the words of the standard library: it owns nothing, and its iterators don't need it. So it can
/// be piped into std::views, and std::ranges::find of it gives an iterator.
template <class Mesh, class Walk, class View, bool Checked = kCheckedCirculators>
class Orbit {
 public:
  class Iterator {
   public:
    using value_type = typename View::Item;
    using reference = value_type;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::forward_iterator_tag;
    using iterator_category = std::input_iterator_tag;  // references are values
    using pointer = Arrow<value_type>;

    Iterator() = default;
    explicit Iterator(const Orbit& orbit)
        : mesh_(orbit.mesh_),
          at_(orbit.first_),
          first_(orbit.first_),
          at_end_(orbit.is_empty_),
          may_skip_(orbit.may_skip_),
          stamp_(*orbit.mesh_) {
      if (may_skip() && !at_end_ && shows_nothing()) ++*this;
    }

    [[nodiscard]] Halfedge halfedge() const {
      stamp_.check(*mesh_);
      return at_;
    }
    [[nodiscard]] reference operator*() const {
      stamp_.check(*mesh_);
      return View::of(*mesh_, at_);
    }
    [[nodiscard]] pointer operator->() const { return pointer(**this); }
    Iterator& operator++() {
      stamp_.check(*mesh_);
      at_ = Walk::on(*mesh_, at_);
      if (may_skip()) [[unlikely]] {
        while (at_ != first_ && shows_nothing()) at_ = Walk::on(*mesh_, at_);
      }
      if (at_ == first_) {
        at_ = Halfedge{};
        at_end_ = true;
      }
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
    [[nodiscard]] bool may_skip() const { return View::kCanBeEmpty && may_skip_; }
    [[nodiscard]] bool shows_nothing() const { return !View::of(*mesh_, at_).valid(); }

    // Both flags save time. at_end_ repeats what at_ tells, but compilers see through it, and what
    // skips is out of the way: a step jumps once, and its jumps are what predicts the end of a lap.
    const Mesh* mesh_ = nullptr;
    Halfedge at_;
    Halfedge first_;
    bool at_end_ = true;
    bool may_skip_ = false;
    [[no_unique_address]] VersionStamp<Checked> stamp_;
  };

  /// The lap that begins at `first`; empty if `first` is.
  Orbit(const Mesh& mesh, Halfedge first) : Orbit(mesh, first, {.is_empty = !first.valid()}) {}

  /// What is known of a lap beforehand, and then needn't be tested.
  struct Known {
    bool is_empty = false;
    /// Whether halfedges on the way may show nothing, and must be skipped.
    bool may_skip = true;
  };
  Orbit(const Mesh& mesh, Halfedge first, Known known)
      : mesh_(&mesh),
        first_(first),
        is_empty_(known.is_empty),
        may_skip_(known.may_skip),
        stamp_(mesh) {}

  [[nodiscard]] Iterator begin() const {
    stamp_.check(*mesh_);
    return Iterator(*this);
  }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }
  [[nodiscard]] bool empty() const { return begin() == end(); }

  /// The endless form of the same walk, standing where the lap begins.
  [[nodiscard]] Circulator<Mesh, Walk, View, Checked> circulator() const {
    stamp_.check(*mesh_);
    return {*mesh_, first_};
  }

 private:
  const Mesh* mesh_;
  Halfedge first_;
  bool is_empty_;
  bool may_skip_;
  [[no_unique_address]] VersionStamp<Checked> stamp_;
};

}  // namespace halfedge

#if defined(__cpp_lib_ranges)
template <class Mesh, class Walk, class View, bool Checked>
inline constexpr bool std::ranges::enable_view<halfedge::Orbit<Mesh, Walk, View, Checked>> = true;
template <class Mesh, class Walk, class View, bool Checked>
inline constexpr bool
    std::ranges::enable_borrowed_range<halfedge::Orbit<Mesh, Walk, View, Checked>> = true;
#endif
