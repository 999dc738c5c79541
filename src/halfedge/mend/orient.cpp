#include <halfedge/decorator/refusal.h>
#include <halfedge/mend/box_tree.h>
#include <halfedge/mend/measure.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/sentence.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace halfedge::mend {

namespace {

using decorator::internal::refusal;

// Less than this, of area times diagonal, is not told from nothing.
constexpr double kNoVolume = 1e-10;

std::string component_of(const Extent& extent, const Component& component) {
  return sentence::of("the component of face {}, of {}{}", extent.first_face, component.faces,
                      component.faces == 1 ? " face," : " faces,");
}

Failure is_open(const Extent& extent, const Component& component) {
  return refusal("",
                 sentence::of("{} has {}{}, expected none: what is open has no inside",
                              component_of(extent, component), component.boundary_loops,
                              component.boundary_loops == 1 ? " boundary loop" : " boundary loops"),
                 {.faces = {extent.first_face}});
}

Failure is_flat(const Extent& extent, const Component& component) {
  return refusal("",
                 sentence::of("{} has no volume that could be told from 0, expected an inside",
                              component_of(extent, component)),
                 {.faces = {extent.first_face}});
}

Failure is_unmeasured(const Extent& extent, const Component& component) {
  return refusal("",
                 sentence::of("{} has a position that is no finite number, expected a volume",
                              component_of(extent, component)),
                 {.faces = {extent.first_face}});
}

// Which components lie inside of others: by the solid angles under which the faces of these are
// seen from a vertex (Van Oosterom and Strackee 1983), which add up to 4 pi from the inside.
class Nesting {
 public:
  Nesting(const Surface& surface, const Components& components, const Array<Extent>& extents)
      : surface_(surface), components_(components), extents_(extents), boxes_(extents) {}

  /// False when memory is exhausted.
  [[nodiscard]] bool prepare() {
    if (!first_.resize(extents_.size() + 2, 0) || !faces_.reserve(components_.of_face.size())) {
      return false;
    }
    for (const Index c : components_.of_face) {
      if (c != kNone) ++first_[c + 2];
    }
    for (std::size_t c = 2; c < first_.size(); ++c) first_[c] += first_[c - 1];
    faces_.grow_to(first_.empty() ? 0 : first_[first_.size() - 1]);
    for (Index f = 0; f < components_.of_face.size(); ++f) {
      const Index c = components_.of_face[f];
      if (c != kNone) faces_[first_[c + 1]++] = f;
    }
    for (Index c = 0; c < extents_.size(); ++c) {
      const bool can_contain =
          components_.list[c].boundary_loops == 0 && std::isfinite(extents_[c].volume);
      if (can_contain && !boxes_.add(c)) return false;
    }
    return boxes_.build();
  }

  /// Whether an odd number of closed components is around this one.
  [[nodiscard]] bool is_cavity(std::size_t inner) const {
    const Vector p =
        point_of(surface_, surface_.to_vertex(surface_.halfedge(Face(extents_[inner].first_face))));
    bool is_inside = false;
    boxes_.for_each_around(extents_[inner], [&](Index outer) {
      if (outer != inner && contains(outer, p)) is_inside = !is_inside;
    });
    return is_inside;
  }

 private:
  [[nodiscard]] bool contains(std::size_t outer, const Vector& p) const {
    double half_angle = 0;
    for (std::size_t i = first_[outer]; i < first_[outer + 1]; ++i) {
      const Halfedge first = surface_.halfedge(Face(faces_[i]));
      const Vector a = point_of(surface_, surface_.to_vertex(first)) - p;
      Vector b = point_of(surface_, surface_.to_vertex(surface_.next(first))) - p;
      for (Halfedge h = surface_.next(surface_.next(first)); h != first; h = surface_.next(h)) {
        const Vector c = point_of(surface_, surface_.to_vertex(h)) - p;
        const double la = length(a);
        const double lb = length(b);
        const double lc = length(c);
        half_angle += std::atan2(dot(a, cross(b, c)),
                                 la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
        b = c;
      }
    }
    return std::abs(half_angle) > 3.14159;  // half of 2 pi
  }

  const Surface& surface_;
  const Components& components_;
  const Array<Extent>& extents_;
  BoxTree boxes_;             // of closed components
  Array<std::size_t> first_;  // of the faces of each component, and the end
  Array<Index> faces_;
};

}  // namespace

Result<Report> orient_outward(Surface& surface, const OrientOptions& options) {
  const auto no_memory = [] { return decorator::internal::no_memory("the components"); };
  const Result<Components> labelled = surface.components();
  if (!labelled) return labelled.error();
  const Components& components = labelled.value();
  Array<Extent> extents;
  Array<bool> reversed;
  if (!measure(surface, components, extents) || !reversed.resize(extents.size(), false)) {
    return no_memory();
  }
  Nesting nesting(surface, components, extents);
  if (options.nested && !nesting.prepare()) return no_memory();

  Report report;
  for (std::size_t c = 0; c < extents.size(); ++c) {
    const Extent& extent = extents[c];
    const Component& component = components.list[c];
    const bool is_closed = component.boundary_loops == 0;
    if (!is_closed && !options.open) {
      report.leave(Code::kOpenComponent, [&] { return is_open(extent, component); });
    } else if (!std::isfinite(extent.volume)) {
      report.leave(Code::kFlatComponent, [&] { return is_unmeasured(extent, component); });
    } else if (!(std::abs(extent.volume) > kNoVolume * extent.area * extent.diagonal())) {
      report.leave(Code::kFlatComponent, [&] { return is_flat(extent, component); });
    } else {
      const bool is_cavity = options.nested && is_closed && nesting.is_cavity(c);
      reversed[c] = (extent.volume < 0) != is_cavity;
      if (reversed[c]) report.add(Code::kReversedComponent);
    }
  }
  if (report.count(Code::kReversedComponent) > 0) {
    Array<Edge> edges;
    for (Index i = 0; i < surface.edge_slots(); ++i) {
      const Edge e(i);
      if (!surface.is_live(e)) continue;
      const Vertex v = surface.to_vertex(Halfedge(2 * i));
      if (reversed[components.of_vertex[v.index()]] && !edges.push_back(e)) return no_memory();
    }
    for (Index f = 0; f < components.of_face.size(); ++f) {
      const Index c = components.of_face[f];
      if (c != kNone && reversed[c] && !report.faces.push_back(f)) return no_memory();
    }
    if (!surface.reverse(edges.span())) return no_memory();
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
