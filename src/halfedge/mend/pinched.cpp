#include <halfedge/mend/repairs.h>
#include <halfedge/operations/fans.h>
#include <halfedge/refusals.h>

namespace halfedge::mend {

namespace {

struct Fan {
  Halfedge first;  // boundary halfedges, which leave the vertex, and arrive there
  Halfedge end;
};

// The fans of a boundary vertex, clockwise: next of an end is the first of the fan that follows.
bool list_fans(const Surface& surface, Vertex v, Array<Fan>& fans) {
  fans.clear();
  const Halfedge anchor = surface.halfedge(v);
  Halfedge first = anchor;
  do {
    const Halfedge end = operations::internal::end_of_fan(surface, first);
    if (!fans.push_back({first, end})) return false;
    first = surface.next(end);
  } while (first != anchor);
  return true;
}

}  // namespace

Result<Report> split_pinched_vertices(Surface& surface) {
  Report report;
  Array<Fan> fans;
  const auto no_memory = [] { return refusals::no_memory("copies of vertices"); };
  const Index slots = surface.vertex_slots();  // copies have one fan
  for (Vertex v(0); v.index() < slots; v = Vertex(v.index() + 1)) {
    if (!surface.is_live(v) || !surface.halfedge(v).valid() || !surface.is_boundary(v)) continue;
    if (!list_fans(surface, v, fans)) return no_memory();
    if (fans.size() == 1) continue;
    for (std::size_t i = fans.size(); i-- > 1;) {
      // From the last on, so that what is left is a vertex with fewer fans at any time.
      const Vertex copy = surface.split_fan(v, fans[i].first, fans[i].end);
      if (copy.valid()) surface.link(fans[i - 1].end, fans[0].first);
      if (!copy.valid() || !report.vertices.push_back(copy.index())) return no_memory();
    }
    report.add(Code::kSplitVertex);
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
