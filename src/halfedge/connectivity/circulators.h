#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/storage.h>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>

/// Checked circulators notice that the connectivity changed under them. On in debug builds.
#if !defined(HALFEDGE_CHECKED)
#if defined(NDEBUG)
#define HALFEDGE_CHECKED 0
#else
#define HALFEDGE_CHECKED 1
#endif
#endif

/// Every circulator and iterator of the library comes from two templates:
///
///   Orbit       halfedges reached by one step again and again, each shown as some item
///   LiveRange   the live items of one kind, in index order
///
/// An orbit has a *walk* (how to step on, and back) and a *view* (what to show of a halfedge). All
/// eleven kinds are combinations of five walks and six views:
///
///            to(h)
///             ^ |            rotate_cw (h) = next(opposite(h))     both leave from(h)
///           h | | opposite   rotate_ccw(h) = opposite(prev(h))
///             | v
///           from(h)          face(h) lies to the left of h
namespace halfedge {

inline constexpr bool kCheckedCirculators = HALFEDGE_CHECKED != 0;

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

/// What a checked circulator remembers of the mesh; nothing in release builds.
template <bool Checked>
class VersionStamp {
 public:
  VersionStamp() = default;
  explicit VersionStamp(const auto&) {}
  void check(const auto&) const {}
};
template <>
class VersionStamp<true> {
 public:
  VersionStamp() = default;
  explicit VersionStamp(const auto& mesh) : version_(mesh.version()) {}
  void check([[maybe_unused]] const auto& mesh) const {
    assert(version_ == mesh.version() &&
           "a circulator was used after the connectivity changed under it: make a new one");
  }

 private:
  [[maybe_unused]] std::uint64_t version_ = 0;  // read by the assert only
};

/// Endless and bidirectional: it has no end, it stops when you say so. `halfedge()` is where it
/// stands, `*c` what the kind of circulator shows of it. Empty (`!valid()`) where there is nothing
/// to visit. Invalidated by any change of connectivity; checked builds assert on use after that.
template <class Mesh, class Walk, class View, bool Checked = kCheckedCirculators>
class Circulator {
 public:
  using value_type = typename View::Item;
  using reference = value_type;
  using difference_type = std::ptrdiff_t;
  using iterator_concept = std::bidirectional_iterator_tag;

  Circulator() = default;
  Circulator(const Mesh& mesh, Halfedge start) : mesh_(&mesh), at_(start), stamp_(mesh) {
    if (at_.valid()) settle<&Walk::template on<Mesh>>();
  }

  [[nodiscard]] bool valid() const { return at_.valid(); }
  [[nodiscard]] Halfedge halfedge() const { return at_; }
  [[nodiscard]] reference operator*() const {
    stamp_.check(*mesh_);
    return View::of(*mesh_, at_);
  }

  Circulator& operator++() {
    stamp_.check(*mesh_);
    at_ = Walk::on(*mesh_, at_);
    settle<&Walk::template on<Mesh>>();
    return *this;
  }
  Circulator& operator--() {
    stamp_.check(*mesh_);
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
/// always holds and the orbit of an isolated vertex is empty.
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
    using pointer = void;

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

    [[nodiscard]] Halfedge halfedge() const { return at_; }
    [[nodiscard]] reference operator*() const {
      stamp_.check(*mesh_);
      return View::of(*mesh_, at_);
    }
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

/// All circulators by name, for any `Mesh` with the links they walk. Order, exactly:
///   - around a vertex, cw begins at the anchor; ccw is its exact reverse and ends at the anchor;
///   - around a face, ccw begins at face_halfedge(f); cw is its exact reverse and ends there;
///   - with an explicit start halfedge both directions begin at it.
/// At a boundary vertex the anchor is a boundary halfedge, so both orders list the one-ring as an
/// open path from one boundary neighbour to the other. Sides without a face are skipped; where the
/// anchor of a vertex has a face there are none (invariant 5), and they aren't looked for. Each
/// step is O(1); nothing is allocated.
template <class Mesh>
class Circulators {
  using RotateCw = walk::RotateCw;
  using RotateCcw = walk::RotateCcw;
  using LoopCcw = walk::LoopCcw;
  using LoopCw = walk::LoopCw;
  using AcrossEdge = walk::AcrossEdge;
  template <class Walk, class View>
  using Lap = Orbit<Mesh, Walk, View>;

 public:
  /// Around a vertex. `start`, where given, is a halfedge that leaves `v`.
  // clang-format off
  [[nodiscard]] auto outgoing_cw(Vertex v) const { return around<RotateCw, view::Self>(v); }
  [[nodiscard]] auto outgoing_ccw(Vertex v) const { return around<RotateCcw, view::Self>(v); }
  [[nodiscard]] auto incoming_cw(Vertex v) const { return around<RotateCw, view::Opposite>(v); }
  [[nodiscard]] auto incoming_ccw(Vertex v) const { return around<RotateCcw, view::Opposite>(v); }
  [[nodiscard]] auto vertex_vertices_cw(Vertex v) const { return around<RotateCw, view::ToVertex>(v); }
  [[nodiscard]] auto vertex_vertices_ccw(Vertex v) const { return around<RotateCcw, view::ToVertex>(v); }
  [[nodiscard]] auto vertex_edges_cw(Vertex v) const { return around<RotateCw, view::ItsEdge>(v); }
  [[nodiscard]] auto vertex_edges_ccw(Vertex v) const { return around<RotateCcw, view::ItsEdge>(v); }
  [[nodiscard]] auto vertex_faces_cw(Vertex v) const { return around<RotateCw, view::ItsFace>(v); }
  [[nodiscard]] auto vertex_faces_ccw(Vertex v) const { return around<RotateCcw, view::ItsFace>(v); }

  [[nodiscard]] auto outgoing_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::Self>(v, start); }
  [[nodiscard]] auto outgoing_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::Self>(v, start); }
  [[nodiscard]] auto incoming_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::Opposite>(v, start); }
  [[nodiscard]] auto incoming_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::Opposite>(v, start); }
  [[nodiscard]] auto vertex_vertices_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::ToVertex>(v, start); }
  [[nodiscard]] auto vertex_vertices_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::ToVertex>(v, start); }
  [[nodiscard]] auto vertex_edges_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::ItsEdge>(v, start); }
  [[nodiscard]] auto vertex_edges_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::ItsEdge>(v, start); }
  [[nodiscard]] auto vertex_faces_cw(Vertex v, Halfedge start) const { return from<RotateCw, view::ItsFace>(v, start); }
  [[nodiscard]] auto vertex_faces_ccw(Vertex v, Halfedge start) const { return from<RotateCcw, view::ItsFace>(v, start); }

  /// Around a face. `start`, where given, is a halfedge of `f`.
  [[nodiscard]] auto face_halfedges_ccw(Face f) const { return around<LoopCcw, view::Self>(f); }
  [[nodiscard]] auto face_halfedges_cw(Face f) const { return around<LoopCw, view::Self>(f); }
  [[nodiscard]] auto face_vertices_ccw(Face f) const { return around<LoopCcw, view::ToVertex>(f); }
  [[nodiscard]] auto face_vertices_cw(Face f) const { return around<LoopCw, view::ToVertex>(f); }
  [[nodiscard]] auto face_edges_ccw(Face f) const { return around<LoopCcw, view::ItsEdge>(f); }
  [[nodiscard]] auto face_edges_cw(Face f) const { return around<LoopCw, view::ItsEdge>(f); }
  [[nodiscard]] auto face_faces_ccw(Face f) const { return around<LoopCcw, view::OppositeFace>(f); }
  [[nodiscard]] auto face_faces_cw(Face f) const { return around<LoopCw, view::OppositeFace>(f); }

  [[nodiscard]] auto face_halfedges_ccw(Face f, Halfedge start) const { return from<LoopCcw, view::Self>(f, start); }
  [[nodiscard]] auto face_halfedges_cw(Face f, Halfedge start) const { return from<LoopCw, view::Self>(f, start); }
  [[nodiscard]] auto face_vertices_ccw(Face f, Halfedge start) const { return from<LoopCcw, view::ToVertex>(f, start); }
  [[nodiscard]] auto face_vertices_cw(Face f, Halfedge start) const { return from<LoopCw, view::ToVertex>(f, start); }
  [[nodiscard]] auto face_edges_ccw(Face f, Halfedge start) const { return from<LoopCcw, view::ItsEdge>(f, start); }
  [[nodiscard]] auto face_edges_cw(Face f, Halfedge start) const { return from<LoopCw, view::ItsEdge>(f, start); }
  [[nodiscard]] auto face_faces_ccw(Face f, Halfedge start) const { return from<LoopCcw, view::OppositeFace>(f, start); }
  [[nodiscard]] auto face_faces_cw(Face f, Halfedge start) const { return from<LoopCw, view::OppositeFace>(f, start); }
  // clang-format on

  /// The face loop or boundary loop through `h`, beginning at `h`.
  [[nodiscard]] auto loop_ccw(Halfedge h) const { return Lap<LoopCcw, view::Self>(self(), h); }
  [[nodiscard]] auto loop_cw(Halfedge h) const { return Lap<LoopCw, view::Self>(self(), h); }

  /// The two ends, the two halfedges, the one or two faces of an edge; side 0 first.
  [[nodiscard]] auto edge_halfedges(Edge e) const { return across<view::Self>(e); }
  [[nodiscard]] auto edge_vertices(Edge e) const { return across<view::ToVertex>(e); }
  [[nodiscard]] auto edge_faces(Edge e) const { return across<view::ItsFace>(e); }

  /// All live items in index order.
  [[nodiscard]] auto vertices() const { return LiveRange<Mesh, Vertex>(self()); }
  [[nodiscard]] auto halfedges() const { return LiveRange<Mesh, Halfedge>(self()); }
  [[nodiscard]] auto edges() const { return LiveRange<Mesh, Edge>(self()); }
  [[nodiscard]] auto faces() const { return LiveRange<Mesh, Face>(self()); }

 private:
  [[nodiscard]] const Mesh& self() const { return static_cast<const Mesh&>(*this); }

  // The reverse of a lap that begins at `first` begins one step back from it.
  template <class Walk, class View>
  [[nodiscard]] auto around(Vertex v) const {
    const Halfedge anchor = self().vertex_halfedge(v);
    if (!anchor.valid()) return Lap<Walk, View>(self(), anchor, {.is_empty = true});
    const Halfedge first = std::is_same_v<Walk, RotateCw> ? anchor : self().rotate_ccw(anchor);
    return Lap<Walk, View>(self(), first, {.may_skip = may_skip<View>(anchor)});
  }
  template <class Walk, class View>
  [[nodiscard]] auto around(Face f) const {
    const Halfedge first = self().face_halfedge(f);
    if constexpr (std::is_same_v<Walk, LoopCcw>) return Lap<Walk, View>(self(), first, {});
    return Lap<Walk, View>(self(), self().prev(first), {});
  }
  template <class Walk, class View>
  [[nodiscard]] auto from([[maybe_unused]] Vertex v, Halfedge start) const {
    assert(self().from_vertex(start) == v && "the start halfedge must leave the vertex");
    if constexpr (StoresAnchors<Mesh>) {
      return Lap<Walk, View>(self(), start,
                             {.may_skip = may_skip<View>(self().vertex_halfedge(v))});
    }
    return Lap<Walk, View>(self(), start, {});
  }
  template <class Walk, class View>
  [[nodiscard]] auto from([[maybe_unused]] Face f, Halfedge start) const {
    if constexpr (StoresFaces<Mesh>) {
      assert(self().face(start) == f && "the start halfedge must lie in the face");
    }
    return Lap<Walk, View>(self(), start, {});
  }
  // Only views that can be empty need to know; so a mesh without faces has all others.
  template <class View>
  [[nodiscard]] bool may_skip([[maybe_unused]] Halfedge anchor) const {
    if constexpr (View::kCanBeEmpty) return self().is_boundary(anchor);
    return false;
  }
  template <class View>
  [[nodiscard]] auto across(Edge e) const {
    return Lap<AcrossEdge, View>(self(), self().edge_halfedge(e, 0));
  }
};

}  // namespace halfedge
