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
  MeasuredComponents components{.labels = labelled.value()};
  if (!components.measure(surface)) return no_memory();
  const Array<Extent>& extents = components.extents;
  double largest_area = 0;
  double largest_diagonal = 0;
  for (const Extent& extent : extents) {
    largest_area = std::max(largest_area, extent.area);
    largest_diagonal = std::max(largest_diagonal, extent.diagonal());
  }

  Report report;
  for (std::size_t c = 0; c < extents.size(); ++c) {
    components.is_chosen[c] = components.labels.list[c].faces < options.faces ||
                              extents[c].area < options.area * largest_area ||
                              extents[c].diagonal() < options.diagonal * largest_diagonal;
    if (components.is_chosen[c]) report.add(Code::kDroppedComponent);
  }
  if (!components.list_chosen_faces(report.faces)) return no_memory();
  if (report.count(Code::kDroppedComponent) > 0) {
    for (const Index f : report.faces) surface.release(Face(f));
    (void)components.for_each_chosen_edge(surface, [&](Edge e) {
      surface.release(e);
      return true;
    });
    for (Index v = 0; v < components.labels.of_vertex.size(); ++v) {
      if (components.chooses(components.labels.of_vertex[v])) surface.release(Vertex(v));
    }
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
