#include <halfedge/build/fans.h>
#include <halfedge/directed_edges/connect.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>

namespace halfedge {

namespace {

void join(DirectedLinks& links, Index arriving, Index leaving) {
  links.boundary_next[arriving - links.sides] = leaving;
  links.boundary_prev[leaving - links.sides] = arriving;
}

// Joins into one cycle the fans that begin at these outgoing boundary halfedges of a vertex, each
// of which is a cycle so far.
void join_cycles(std::span<const Index> firsts, DirectedLinks& links) {
  Index last = links.prev(firsts.front());
  for (const Index first : firsts.subspan(1)) {
    const Index last_of_next = links.prev(first);
    join(links, last, first);
    last = last_of_next;
  }
  join(links, last, firsts.front());
}

// `firsts` are outgoing boundary halfedges of pinched vertices, all of them, some more than once.
ConnectResult join_at_pinched_vertices(std::span<Index> firsts, DirectedLinks& links) {
  const auto from = [&](Index h) { return links.to_vertex[links.opposite[h]]; };
  introsort(firsts, [&](Index a, Index b) {
    return std::tuple(from(a), links.to_vertex[a], a) < std::tuple(from(b), links.to_vertex[b], b);
  });
  const auto end = std::unique(firsts.begin(), firsts.end());
  for (auto first = firsts.begin(); first != end;) {
    auto last = first + 1;
    for (; last != end && from(*last) == from(*first); ++last) {
      if (links.to_vertex[*last] == links.to_vertex[*(last - 1)]) {
        return ConnectResult::kNotManifold;
      }
    }
    join_cycles({first, last}, links);
    links.vertex_halfedge[from(*first)] = *first;
    first = last;
  }
  return ConnectResult::kDone;
}

}  // namespace

ConnectResult join_open_fans(DirectedLinks& links) {
  Array<Index> at_pinched_vertices;
  for (Index h = links.sides; h < links.opposite.size(); ++h) {
    Index arriving = links.opposite[h];
    const Index vertex = links.to_vertex[arriving];
    while (!links.is_boundary(arriving)) arriving = links.opposite[links.next(arriving)];
    join(links, arriving, h);

    Index& anchor = links.vertex_halfedge[vertex];
    if (!links.is_boundary(anchor)) {
      anchor = h;
    } else if (!at_pinched_vertices.push_back(anchor) || !at_pinched_vertices.push_back(h)) {
      return ConnectResult::kOutOfMemory;
    }
  }
  return join_at_pinched_vertices(at_pinched_vertices.span(), links);
}

// All halfedges are rotated first, in the order of memory. That takes less than to do it at each
// step of a walk, which only loads one word after the other then.
bool each_vertex_has_one_cycle(const DirectedLinks& links, std::span<Index> rotated) {
  const std::span<const Index> opposite = links.opposite.span();
  for (std::size_t h = 0; h < opposite.size(); ++h) {
    rotated[h] = DirectedLinks::next_in_face(opposite[h]);  // not if that is on the boundary
  }
  for (std::size_t b = links.sides; b < opposite.size(); ++b) {
    rotated[opposite[b]] = links.next(Index(b));
  }
  return each_vertex_has_one_cycle(links.vertex_halfedge.span(), opposite.size(),
                                   [next = rotated.data()](Index h) { return next[h]; });
}

}  // namespace halfedge
