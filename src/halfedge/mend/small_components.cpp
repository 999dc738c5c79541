#include <halfedge/mend/measure.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/refusals.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace halfedge::mend {

Result<Report> drop_small_components(Surface& surface, const DropOptions& options) {
  for (const auto& [of, share] : {std::pair{"The least share of the area", options.area},
                                  std::pair{"The least share of the diagonal", options.diagonal}}) {
    if (Result<void> checked = check_option("bad-share", of, share, 1); !checked) {
      return checked;
    }
  }
  const auto no_memory = [] { return refusals::no_memory("the components"); };
  Result<Components> labelled = surface.components();
  if (!labelled) return labelled;
  const Components& components = labelled.value();
  Array<Extent> extents;
  Array<bool> dropped;
  if (!measure(surface, components, extents) || !dropped.resize(extents.size(), false)) {
    return no_memory();
  }
  double largest_area = 0;
  double largest_diagonal = 0;
  for (const Extent& extent : extents) {
    largest_area = std::max(largest_area, extent.area);
    largest_diagonal = std::max(largest_diagonal, extent.diagonal());
  }

  Report report;
  for (std::size_t c = 0; c < extents.size(); ++c) {
    dropped[c] = components.list[c].faces < options.faces ||
                 extents[c].area < options.area * largest_area ||
                 extents[c].diagonal() < options.diagonal * largest_diagonal;
    if (dropped[c]) report.add(Code::kDroppedComponent);
  }
  const auto is_dropped = [&](Index c) { return c != kNone && dropped[c]; };
  for (Index f = 0; f < components.of_face.size(); ++f) {
    if (is_dropped(components.of_face[f]) && !report.faces.push_back(f)) return no_memory();
  }
  if (report.count(Code::kDroppedComponent) > 0) {
    for (const Index f : report.faces) surface.release(Face(f));
    for (Index i = 0; i < surface.edge_slots(); ++i) {
      const Edge e(i);
      if (!surface.is_live(e)) continue;
      const Vertex v = surface.to_vertex(Halfedge(2 * i));
      if (is_dropped(components.of_vertex[v.index()])) surface.release(e);
    }
    for (Index v = 0; v < components.of_vertex.size(); ++v) {
      if (is_dropped(components.of_vertex[v])) surface.release(Vertex(v));
    }
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
