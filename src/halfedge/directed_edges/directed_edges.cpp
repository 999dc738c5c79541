#include <halfedge/directed_edges/directed_edges.h>

#include <algorithm>

namespace halfedge {

DirectedEdges& DirectedEdges::operator=(DirectedEdges&& other) noexcept {
  if (this == &other) return *this;
  links_ = std::move(other.links_);
  other.links_.sides = 0;
  // Not the version of `other`, which a circulator of this mesh may remember by chance.
  version_ = std::max(version_, other.version_) + 1;
  ++other.version_;
  return *this;
}

void DirectedEdges::clear() {
  links_.opposite.clear();
  links_.to_vertex.clear();
  links_.boundary_next.clear();
  links_.boundary_prev.clear();
  links_.vertex_halfedge.clear();
  links_.sides = 0;
  ++version_;
}

bool DirectedEdges::assign(const DirectedEdges& other) {
  if (this == &other) return true;
  const DirectedLinks& from = other.links_;
  const bool fits = links_.opposite.assign(from.opposite.span()) &&
                    links_.to_vertex.assign(from.to_vertex.span()) &&
                    links_.boundary_next.assign(from.boundary_next.span()) &&
                    links_.boundary_prev.assign(from.boundary_prev.span()) &&
                    links_.vertex_halfedge.assign(from.vertex_halfedge.span());
  if (!fits) {
    clear();
    return false;
  }
  links_.sides = from.sides;
  ++version_;
  return true;
}

}  // namespace halfedge
