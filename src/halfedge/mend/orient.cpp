#include <halfedge/mend/box_tree.h>
#include <halfedge/mend/measure.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/refusals.h>
#include <halfedge/sentence.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <string>

namespace halfedge::mend {

namespace {

using refusals::refusal;

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
// seen from a point (Van Oosterom and Strackee 1983), which add up to 4 pi from the inside.
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
    bool is_inside = false;
    boxes_.for_each_around(extents_[inner], [&](Index outer) {
      if (outer != inner && contains(outer, inner)) is_inside = !is_inside;
    });
    return is_inside;
  }

 private:
  // Where the points to be asked lie among the faces of a component, in sixteenths: from any of
  // them on spread as widely as can be.
  static constexpr std::array<std::size_t, 16> kSpread = {0, 8, 4, 12, 2, 10, 6, 14,
                                                          1, 9, 5, 13, 3, 11, 7, 15};
  // They are asked until so many more say one thing than the other.
  static constexpr int kLead = 3;
  // The number of times that a surface goes around a point is whole by this, or the point lies on
  // it.
  static constexpr double kWhole = 0.01;
  // A triangle that fills half of the view, but for this, is touched.
  static constexpr double kTouches = 1e-4;

  // By where most of a few points of `inner` lie, spread over it: any single one may lie where the
  // two touch. What has the very same box does not lie inside.
  [[nodiscard]] bool contains(std::size_t outer, std::size_t inner) const {
    if (extents_[outer].low == extents_[inner].low &&
        extents_[outer].high == extents_[inner].high) {
      return false;
    }
    const std::size_t begin = first_[inner];
    const std::size_t count = first_[inner + 1] - begin;
    int lead = 0;
    bool takes_corner = false;
    for (const std::size_t sixteenths : kSpread) {
      const Face f(faces_[begin + sixteenths * count / kSpread.size()]);
      takes_corner = !takes_corner;
      const double turns = turns_around(outer, takes_corner ? corner_of(f) : centre_of(f));
      const double whole = std::round(turns);
      if (std::abs(turns - whole) < kWhole) lead += whole == 0 ? -1 : 1;
      if (std::abs(lead) == kLead) break;
    }
    return lead > 0;
  }

  [[nodiscard]] Vector corner_of(Face f) const {
    return point_of(surface_, surface_.to_vertex(surface_.halfedge(f)));
  }

  [[nodiscard]] Vector centre_of(Face f) const {
    Vector sum = {};
    double corners = 0;
    const Halfedge first = surface_.halfedge(f);
    Halfedge h = first;
    do {
      const Vector p = point_of(surface_, surface_.to_vertex(h));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += p[k];
      corners += 1;
      h = surface_.next(h);
    } while (h != first);
    return {sum[0] / corners, sum[1] / corners, sum[2] / corners};
  }

  // How many times the surface of a component goes around a point; no number on the surface, where
  // it could be either.
  [[nodiscard]] double turns_around(std::size_t outer, const Vector& p) const {
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
        const double half = std::atan2(
            dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
        if (std::abs(half) > std::numbers::pi - kTouches) return std::nan("");
        half_angle += half;
        b = c;
      }
    }
    return half_angle / (2 * std::numbers::pi);
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
  const auto no_memory = [] { return refusals::no_memory("the components"); };
  Result<Components> labelled = surface.components();
  if (!labelled) return labelled;
  MeasuredComponents components{.labels = labelled.value()};
  if (!components.measure(surface)) return no_memory();
  const Array<Extent>& extents = components.extents;
  Nesting nesting(surface, components.labels, extents);
  if (options.nested && !nesting.prepare()) return no_memory();

  Report report;
  for (std::size_t c = 0; c < extents.size(); ++c) {
    const Extent& extent = extents[c];
    const Component& component = components.labels.list[c];
    const bool is_closed = component.boundary_loops == 0;
    if (!is_closed && !options.open) {
      report.leave(Code::kOpenComponent, [&] { return is_open(extent, component); });
    } else if (!std::isfinite(extent.volume)) {
      report.leave(Code::kFlatComponent, [&] { return is_unmeasured(extent, component); });
    } else if (!(std::abs(extent.volume) > kNoVolume * extent.area * extent.diagonal())) {
      report.leave(Code::kFlatComponent, [&] { return is_flat(extent, component); });
    } else {
      const bool is_cavity = options.nested && is_closed && nesting.is_cavity(c);
      components.is_chosen[c] = (extent.volume < 0) != is_cavity;
      if (components.is_chosen[c]) report.add(Code::kReversedComponent);
    }
  }
  if (report.count(Code::kReversedComponent) > 0) {
    Array<Edge> edges;
    const auto list = [&](Edge e) { return edges.push_back(e); };
    if (!components.for_each_chosen_edge(surface, list)) return no_memory();
    if (!components.list_chosen_faces(report.faces)) return no_memory();
    if (!surface.reverse(edges.span())) return no_memory();
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
