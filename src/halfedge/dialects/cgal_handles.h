#pragma once

#include <halfedge/connectivity/arrow.h>
#include <halfedge/connectivity/circulators.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/mesh.h>

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <iterator>
#include <type_traits>

/// Handles, circulators and iterators as CGAL's programs use them; see cgal.h.
namespace halfedge::dialects::cgal {
inline namespace HALFEDGE_CHECKS {

/// An item of a mesh that knows its mesh: handle and record in one, so that `h->next()`,
/// `(*h).next()` and `h.next()` all work. Converts to our handle. Default-constructed it is empty,
/// and equal to `nullptr`.
template <class Self, class Mesh, class Item>
class Named {
 public:
  using size_type = std::size_t;

  Named() = default;
  Named(const Mesh& mesh, Item item) : mesh_(&mesh), item_(item) {}

  [[nodiscard]] const Self& operator*() const { return static_cast<const Self&>(*this); }
  [[nodiscard]] const Self* operator->() const { return static_cast<const Self*>(this); }
  [[nodiscard]] operator Item() const { return item_; }

  friend bool operator==(const Self& a, const Self& b) { return a.item_ == b.item_; }
  friend bool operator==(const Self& a, std::nullptr_t) { return !a.item_.valid(); }
  friend bool operator<(const Self& a, const Self& b) { return a.item_ < b.item_; }

 protected:
  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }

  const Mesh* mesh_ = nullptr;
  Item item_;
};

/// A point whose coordinates are asked for; converts from and to ours.
class Point_3 {
 public:
  Point_3() = default;
  Point_3(Point point) : point_(point) {}
  Point_3(float x, float y, float z) : point_{x, y, z} {}
  [[nodiscard]] float x() const { return point_.x; }
  [[nodiscard]] float y() const { return point_.y; }
  [[nodiscard]] float z() const { return point_.z; }
  [[nodiscard]] float cartesian(int i) const { return i == 0 ? x() : i == 1 ? y() : z(); }
  [[nodiscard]] float operator[](int i) const { return cartesian(i); }
  [[nodiscard]] operator Point() const { return point_; }
  friend bool operator==(const Point_3&, const Point_3&) = default;

  /// As CGAL prints it: `0 0.5 1`.
  template <class Traits>
  friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                                      const Point_3& p) {
    return out << p.x() << ' ' << p.y() << ' ' << p.z();
  }

 private:
  Point point_;
};

template <class Mesh>
class VertexOf;
template <class Mesh>
class FacetOf;
template <class Mesh>
class VertexCirculator;
template <class Mesh>
class FacetCirculator;

/// `Polyhedron_3::Halfedge` and `Halfedge_handle`. Incident to the vertex that it points to.
///
///             vertex()
///              ^ |        facet() lies to the left; prev() and with it prev_on_vertex() take
///         this | | opposite()    constant time where the mesh stores prev, else a search
///              | v
template <class Mesh>
class HalfedgeOf : public Named<HalfedgeOf<Mesh>, Mesh, Halfedge> {
  using Base = Named<HalfedgeOf<Mesh>, Mesh, Halfedge>;

 public:
  using Base::Base;

  [[nodiscard]] HalfedgeOf next() const { return at(this->mesh().next(*this)); }
  [[nodiscard]] HalfedgeOf prev() const { return at(this->mesh().prev(*this)); }
  [[nodiscard]] HalfedgeOf opposite() const { return at(this->mesh().opposite(*this)); }
  [[nodiscard]] VertexOf<Mesh> vertex() const {
    return {this->mesh(), this->mesh().to_vertex(*this)};
  }
  /// Empty for a border halfedge.
  [[nodiscard]] FacetOf<Mesh> facet() const {
    const Face f = this->mesh().face(*this);
    return f.valid() ? FacetOf<Mesh>(this->mesh(), f) : FacetOf<Mesh>();
  }
  [[nodiscard]] FacetOf<Mesh> face() const { return facet(); }

  /// Clockwise: next()->opposite().
  [[nodiscard]] HalfedgeOf next_on_vertex() const { return at(this->mesh().next_on_vertex(*this)); }
  /// Counter-clockwise: opposite()->prev().
  [[nodiscard]] HalfedgeOf prev_on_vertex() const { return at(this->mesh().prev_on_vertex(*this)); }

  /// Of the halfedges that arrive at vertex(), clockwise.
  [[nodiscard]] VertexCirculator<Mesh> vertex_begin() const {
    return VertexCirculator<Mesh>(*this);
  }
  /// Of the halfedges of facet(), or of the hole, counter-clockwise.
  [[nodiscard]] FacetCirculator<Mesh> facet_begin() const { return FacetCirculator<Mesh>(*this); }

  [[nodiscard]] bool is_border() const { return this->mesh().is_boundary(Halfedge(*this)); }
  [[nodiscard]] bool is_border_edge() const { return is_border() || opposite().is_border(); }

  [[nodiscard]] std::size_t vertex_degree() const { return steps_around(vertex_begin()); }
  [[nodiscard]] std::size_t facet_degree() const { return steps_around(facet_begin()); }
  [[nodiscard]] bool is_bivalent() const { return vertex_degree() == 2; }
  [[nodiscard]] bool is_trivalent() const { return vertex_degree() == 3; }
  [[nodiscard]] bool is_triangle() const { return facet_degree() == 3; }
  [[nodiscard]] bool is_quad() const { return facet_degree() == 4; }

 private:
  [[nodiscard]] HalfedgeOf at(Halfedge h) const { return {this->mesh(), h}; }

  template <class Circulator>
  [[nodiscard]] static std::size_t steps_around(Circulator circulator) {
    const Circulator begin = circulator;
    std::size_t steps = 0;
    do ++steps;
    while (++circulator != begin);
    return steps;
  }
};

/// What both kinds of circulator share: endless and bidirectional, and a halfedge handle itself.
/// Equal to `nullptr` where there is nothing to visit. Checked builds assert on use after a change
/// of connectivity.
template <class Self, class Mesh>
class HalfedgeCirculator : public HalfedgeOf<Mesh> {
 public:
  using value_type = HalfedgeOf<Mesh>;
  using reference = value_type;
  using pointer = Arrow<value_type>;
  using difference_type = std::ptrdiff_t;
  using iterator_category = std::bidirectional_iterator_tag;

  HalfedgeCirculator() = default;
  explicit HalfedgeCirculator(const HalfedgeOf<Mesh>& start) : HalfedgeOf<Mesh>(start) {
    if (start != nullptr) stamp_ = VersionStamp<kCheckedCirculators>(this->mesh());
  }

  [[nodiscard]] reference operator*() const {
    if (*this != nullptr) stamp_.check(this->mesh());
    return *this;
  }
  [[nodiscard]] pointer operator->() const { return pointer(**this); }

  Self& operator++() { return move_to(Self::after(*this)); }
  Self& operator--() { return move_to(Self::before(*this)); }
  Self operator++(int) {
    const Self old = static_cast<Self&>(*this);
    ++*this;
    return old;
  }
  Self operator--(int) {
    const Self old = static_cast<Self&>(*this);
    --*this;
    return old;
  }

 private:
  Self& move_to(const HalfedgeOf<Mesh>& h) {
    stamp_.check(this->mesh());
    static_cast<HalfedgeOf<Mesh>&>(*this) = h;
    return static_cast<Self&>(*this);
  }

  [[no_unique_address]] VersionStamp<kCheckedCirculators> stamp_;
};

/// `Halfedge_around_vertex_circulator`.
template <class Mesh>
class VertexCirculator : public HalfedgeCirculator<VertexCirculator<Mesh>, Mesh> {
 public:
  using HalfedgeCirculator<VertexCirculator<Mesh>, Mesh>::HalfedgeCirculator;
  static HalfedgeOf<Mesh> after(const HalfedgeOf<Mesh>& h) { return h.next_on_vertex(); }
  static HalfedgeOf<Mesh> before(const HalfedgeOf<Mesh>& h) { return h.prev_on_vertex(); }
};

/// `Halfedge_around_facet_circulator`.
template <class Mesh>
class FacetCirculator : public HalfedgeCirculator<FacetCirculator<Mesh>, Mesh> {
 public:
  using HalfedgeCirculator<FacetCirculator<Mesh>, Mesh>::HalfedgeCirculator;
  static HalfedgeOf<Mesh> after(const HalfedgeOf<Mesh>& h) { return h.next(); }
  static HalfedgeOf<Mesh> before(const HalfedgeOf<Mesh>& h) { return h.prev(); }
};

/// `Polyhedron_3::Vertex` and `Vertex_handle`.
template <class Mesh>
class VertexOf : public Named<VertexOf<Mesh>, Mesh, Vertex> {
 public:
  using Named<VertexOf<Mesh>, Mesh, Vertex>::Named;

  /// One that arrives here; empty for an isolated vertex, which CGAL doesn't have.
  [[nodiscard]] HalfedgeOf<Mesh> halfedge() const {
    const Halfedge anchor = this->mesh().vertex_halfedge(*this);
    if (!anchor.valid()) return {};
    return {this->mesh(), this->mesh().opposite(anchor)};
  }
  /// A copy: to move a vertex call set_position() of the mesh.
  [[nodiscard]] Point_3 point() const { return this->mesh().position(*this); }
  [[nodiscard]] VertexCirculator<Mesh> vertex_begin() const {
    return VertexCirculator<Mesh>(halfedge());
  }
  [[nodiscard]] std::size_t vertex_degree() const {
    const HalfedgeOf<Mesh> h = halfedge();
    return h == nullptr ? 0 : h.vertex_degree();
  }
  [[nodiscard]] std::size_t degree() const { return vertex_degree(); }
  [[nodiscard]] bool is_bivalent() const { return vertex_degree() == 2; }
  [[nodiscard]] bool is_trivalent() const { return vertex_degree() == 3; }
};

/// `Polyhedron_3::Facet` and `Facet_handle`.
template <class Mesh>
class FacetOf : public Named<FacetOf<Mesh>, Mesh, Face> {
 public:
  using Named<FacetOf<Mesh>, Mesh, Face>::Named;

  [[nodiscard]] HalfedgeOf<Mesh> halfedge() const {
    return {this->mesh(), this->mesh().face_halfedge(*this)};
  }
  [[nodiscard]] FacetCirculator<Mesh> facet_begin() const { return halfedge().facet_begin(); }
  [[nodiscard]] std::size_t facet_degree() const { return halfedge().facet_degree(); }
  [[nodiscard]] std::size_t size() const { return facet_degree(); }
  [[nodiscard]] bool is_triangle() const { return halfedge().is_triangle(); }
  [[nodiscard]] bool is_quad() const { return halfedge().is_quad(); }
};

/// `Vertex_iterator` and its kin: the live items in index order; a handle itself, as in CGAL.
template <class Mesh, class NamedItem, class Item>
class ItemIterator : public NamedItem {
 public:
  using value_type = NamedItem;
  using reference = value_type;
  using pointer = Arrow<value_type>;
  using difference_type = std::ptrdiff_t;
  using iterator_category = std::bidirectional_iterator_tag;

  ItemIterator() = default;
  /// At the first live item from slot `at` on.
  ItemIterator(const Mesh& mesh, Index at) : NamedItem(mesh, {}), at_(at) { settle(); }

  [[nodiscard]] reference operator*() const { return *this; }
  [[nodiscard]] pointer operator->() const { return pointer(*this); }

  ItemIterator& operator++() {
    ++at_;
    settle();
    return *this;
  }
  /// pre: not at the first live item
  ItemIterator& operator--() {
    do --at_;
    while (this->mesh().is_deleted(Item(at_)));
    settle();
    return *this;
  }
  ItemIterator operator++(int) {
    const ItemIterator old = *this;
    ++*this;
    return old;
  }
  ItemIterator operator--(int) {
    const ItemIterator old = *this;
    --*this;
    return old;
  }

 private:
  // An edge is told by its side 0. The end is the empty handle.
  void settle() {
    const Index slots = this->mesh().slots(Item());
    while (at_ < slots && this->mesh().is_deleted(Item(at_))) ++at_;
    if (at_ >= slots) {
      this->item_ = {};
    } else if constexpr (std::is_same_v<Item, Edge>) {
      this->item_ = this->mesh().edge_halfedge(Edge(at_));
    } else {
      this->item_ = Item(at_);
    }
  }

  Index at_ = 0;
};

}  // namespace HALFEDGE_CHECKS
}  // namespace halfedge::dialects::cgal

/// As those of CGAL, handles can be keys of std::unordered_map.
template <class Mesh>
struct std::hash<halfedge::dialects::cgal::VertexOf<Mesh>> : std::hash<halfedge::Vertex> {};
template <class Mesh>
struct std::hash<halfedge::dialects::cgal::HalfedgeOf<Mesh>> : std::hash<halfedge::Halfedge> {};
template <class Mesh>
struct std::hash<halfedge::dialects::cgal::FacetOf<Mesh>> : std::hash<halfedge::Face> {};
