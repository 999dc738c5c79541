#include <halfedge/build/fans.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace halfedge {

namespace {

// Where the fan ends that begins at the outgoing boundary halfedge `first`: the boundary halfedge
// that arrives there.
Index end_of_fan(const Links& links, Index first) {
  Index h = first ^ 1U;
  while (links.face[h] != kNone) h = links.next[h] ^ 1U;
  return h;
}

// Joins into one cycle the fans that begin at these outgoing boundary halfedges of a vertex.
void join_cycles(std::span<const Index> firsts, Links& links) {
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    links.next[end_of_fan(links, firsts[i])] = firsts[i + 1 < firsts.size() ? i + 1 : 0];
  }
}

}  // namespace

bool join_open_fans(Links& links) {
  const auto is_boundary = [&](Index h) { return links.face[h] == kNone; };
  const auto from = [&](Index h) { return links.to_vertex[h ^ 1U]; };
  Array<Index> at_pinched_vertices;

  for (Index h = 0; h < links.next.size(); ++h) {
    if (!is_boundary(h)) continue;
    links.next[end_of_fan(links, h)] = h;
    Index& anchor = links.vertex_halfedge[from(h)];
    if (!is_boundary(anchor)) {
      anchor = h;
    } else if (!at_pinched_vertices.push_back(anchor) || !at_pinched_vertices.push_back(h)) {
      return false;
    }
  }

  Index* const begin = at_pinched_vertices.begin();
  introsort(begin, at_pinched_vertices.end(), [&](Index a, Index b) {
    return std::pair(from(a), links.to_vertex[a]) < std::pair(from(b), links.to_vertex[b]);
  });
  Index* const end = std::unique(begin, at_pinched_vertices.end());
  for (Index* first = begin; first != end;) {
    Index* last = first;
    while (last != end && from(*last) == from(*first)) ++last;
    join_cycles({first, last}, links);
    links.vertex_halfedge[from(*first)] = *first;
    first = last;
  }
  return true;
}

bool each_vertex_has_one_cycle(const Links& links) {
  const Index* const next = links.next.data();
  return each_vertex_has_one_cycle(links.vertex_halfedge.span(), links.next.size(),
                                   [next](Index h) { return next[h ^ 1U]; });
}

}  // namespace halfedge
