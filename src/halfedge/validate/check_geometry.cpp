#include <halfedge/inlining.h>
#include <halfedge/mend/face_shape.h>
#include <halfedge/repair/weld.h>
#include <halfedge/sentence.h>
#include <halfedge/validate/check_geometry.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace halfedge {

namespace {

using mend::SurfaceView;
using repair::Vertices;

class GeometryChecker {
 public:
  GeometryChecker(const SurfaceView& surface, ProblemList& problems)
      : surface_(surface), problems_(problems) {}

  void run() {
    check_positions();
    if (!find_places()) {
      return problems_.add(Rule::kOutOfMemory, ItemKind::kMesh, kNone, [] {
        return std::string("memory is exhausted, so this was not checked: edges and faces");
      });
    }
    check_edges();
    check_faces();
    check_vertices();
  }

 private:
  template <class Item, class Message>
  HALFEDGE_COLD void report(Rule rule, Item item, const Message& message) {
    problems_.add(rule, kind_of(item), item.index(), message);
  }

  void check_positions() {
    for (Index i = 0; i < surface_.vertex_slots(); ++i) {
      const Vertex v(i);
      if (!surface_.is_live(v) || is_finite(surface_.position(v))) continue;
      report(Rule::kNonFinitePosition, v, [&] {
        return sentence::of("{} lies at {}, expected finite numbers", v, place_of(v));
      });
    }
  }
  [[nodiscard]] static bool is_finite(const Point& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  [[nodiscard]] HALFEDGE_COLD std::string place_of(Vertex v) const {
    const Point p = surface_.position(v);
    return sentence::of("({}, {}, {})", sentence::number(double{p.x}),
                        sentence::number(double{p.y}), sentence::number(double{p.z}));
  }

  // Gives the vertices that lie in one place a number in common; those that are deleted, or
  // nowhere, have none.
  [[nodiscard]] bool find_places() {
    const std::span<const float> positions = surface_.positions();
    Array<float> live;
    if (!live.assign(positions)) return false;
    for (Index v = 0; v < surface_.vertex_slots(); ++v) {
      if (surface_.is_live(Vertex(v))) continue;
      live[3 * std::size_t{v}] = std::numeric_limits<float>::quiet_NaN();
    }
    if (!repair::weld(live.span(), 0, places_)) return false;
    if (!joined_.recreate(surface_.vertex_slots())) return false;
    for (Index v = 0; v < joined_.size(); ++v) joined_[v] = v;
    return last_.resize(places_.size(), kNone);
  }
  [[nodiscard]] HALFEDGE_NOINLINE_IN_WASM bool has_no_length(Halfedge h) const {
    const Index place = places_.of_input[surface_.to_vertex(h).index()];
    return place != kNone && place == places_.of_input[surface_.from_vertex(h).index()];
  }

  void check_edges() {
    for (Index e = 0; e < surface_.edge_slots(); ++e) {
      const Halfedge h(2 * e);
      if (!surface_.is_live(h) || !has_no_length(h)) continue;
      join(surface_.from_vertex(h).index(), surface_.to_vertex(h).index());
      report(Rule::kZeroLengthEdge, SurfaceView::edge(h), [&] {
        return sentence::of("{} has no length: {} and {} both lie at {}", SurfaceView::edge(h),
                            surface_.from_vertex(h), surface_.to_vertex(h),
                            place_of(surface_.to_vertex(h)));
      });
    }
  }
  // The smallest of the vertices that edges without length join to this one.
  [[nodiscard]] HALFEDGE_NOINLINE Index root_of(Index v) {
    while (joined_[v] != v) v = joined_[v] = joined_[joined_[v]];
    return v;
  }
  void join(Index a, Index b) {
    a = root_of(a);
    b = root_of(b);
    joined_[std::max(a, b)] = std::min(a, b);
  }

  void check_faces() {
    for (Index i = 0; i < surface_.face_slots(); ++i) {
      const Face f(i);
      if (!surface_.is_live(f)) continue;
      const mend::FaceShape shape = mend::shape_of(surface_, f);
      if (!is_degenerate(f, shape)) continue;
      if (mend::is_triangle(surface_, f) && has_no_length(shape.shortest)) continue;  // told
      report(Rule::kDegenerateFace, f, [&] {
        return sentence::of("{} has no area to speak of: it is {} long and {} wide{}", f,
                            sentence::number(shape.length), sentence::number(shape.width),
                            shape.is_thin(0) ? "" : ", but its sides cross");
      });
    }
  }
  [[nodiscard]] bool is_degenerate(Face f, const mend::FaceShape& shape) const {
    if (shape.is_thin(0) || mend::is_triangle(surface_, f)) return shape.is_thin(0);
    const Halfedge h = surface_.halfedge(f);
    const Vector from = mend::point_of(surface_, surface_.from_vertex(h));
    const double area = mend::length(mend::area_vector(surface_, h, from));
    return area <= mend::kThin * shape.length * shape.length;
  }

  void check_vertices() {
    for (Index i = 0; i < surface_.vertex_slots(); ++i) {
      const Index place = places_.of_input[i];
      if (place == kNone || root_of(i) != i) continue;
      const Index before = std::exchange(last_[place], i);
      if (before == kNone) continue;
      report(Rule::kCoincidentVertices, Vertex(i), [&] {
        return sentence::of("{} lies at {}, as {} does", Vertex(i), place_of(Vertex(i)),
                            Vertex(before));
      });
    }
  }

  const SurfaceView& surface_;
  ProblemList& problems_;
  Vertices places_;
  Array<Index> joined_;  // by vertex, a smaller one that lies there, or itself
  Array<Index> last_;    // by place, the last vertex seen there
};

}  // namespace

HALFEDGE_NOINLINE void check_geometry(const SurfaceView& surface, ProblemList& problems) {
  GeometryChecker(surface, problems).run();
}

}  // namespace halfedge
