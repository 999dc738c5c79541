#pragma once

#include <halfedge/mend/surface.h>
#include <halfedge/vector.h>

namespace halfedge::mend {

/// A face that is thinner than this share of its length has no normal to speak of: the rounding of
/// positions alone could turn it over.
inline constexpr double kThin = 1e-6;

[[nodiscard]] double length(const Vector& a);
/// Of length 1, or 0 if `a` is no longer than `least`.
[[nodiscard]] Vector unit_vector(const Vector& a, double least);
[[nodiscard]] inline Vector point_of(const SurfaceView& surface, Vertex v) {
  const Point p = surface.position(v);
  return {double{p.x}, double{p.y}, double{p.z}};
}

/// What a connected component measures.
struct Extent {
  Index first_face = kNone;
  Vector low = {};
  Vector high = {};
  double area = 0;
  double volume = 0;  // of the cone from the centre of the area: signed, and its own if closed

  [[nodiscard]] double diagonal() const { return length(high - low); }
};

/// By component. False when memory is exhausted.
[[nodiscard]] bool measure(const Surface& surface, const Components& components,
                           Array<Extent>& extents);

/// The connected components of a surface, what each of them measures, and which of them a repair
/// chooses.
struct MeasuredComponents {
  const Components& labels;
  Array<Extent> extents = {};
  Array<bool> is_chosen = {};

  /// None is chosen then. False when memory is exhausted.
  [[nodiscard]] bool measure(const Surface& surface) {
    return mend::measure(surface, labels, extents) && is_chosen.resize(extents.size(), false);
  }
  [[nodiscard]] bool chooses(Index component) const {
    return component != kNone && is_chosen[component];
  }
  /// False when memory is exhausted.
  [[nodiscard]] bool list_chosen_faces(Array<Index>& faces) const;
  /// Calls `visit` with each edge of the components chosen, until that returns false; as this does
  /// then.
  template <class Visit>
  [[nodiscard]] bool for_each_chosen_edge(const Surface& surface, const Visit& visit) const {
    for (Index i = 0; i < surface.edge_slots(); ++i) {
      const Edge e(i);
      if (!surface.is_live(e)) continue;
      const Vertex v = surface.to_vertex(Halfedge(2 * i));
      if (chooses(labels.of_vertex[v.index()]) && !visit(e)) return false;
    }
    return true;
  }
};

}  // namespace halfedge::mend
