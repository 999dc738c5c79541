#include <halfedge/algorithms/touch_rings.h>
#include <halfedge/inlining.h>
#include <halfedge/sentence.h>
#include <halfedge/validate/checker.h>

#include <algorithm>

namespace halfedge {

namespace {

// Before any is looked for that can be named: in a bare loop, as in check_links.cpp.
HALFEDGE_NOINLINE bool has_degree_below_three(const Links& links) {
  const Index* const next = links.next.data();
  Index below = 0;
  for (const Index first : links.face_halfedge) {
    if (is_deleted_link(first)) continue;
    const Index second = next[first];
    below |= Index{second == first} | Index{next[second] == first};
  }
  return below != 0;
}

}  // namespace

template <class Mesh>
void PolygonChecker<Mesh>::check_polygons() {
  check_degrees();
  Array<Index> mark;  // by vertex, the last face or vertex in whose ring it was seen
  if (has_memory(mark.resize(mesh_.vertex_slots(), kNone), "repeated vertices and edges")) {
    check_repeated_vertices(mark);
    std::fill(mark.begin(), mark.end(), kNone);
    check_duplicate_halfedges(mark);
  }
  for (const Edge e : mesh_.edges()) {
    const Face f = mesh_.face(mesh_.edge_halfedge(e, 0));
    if (!f.valid() || f != mesh_.face(mesh_.edge_halfedge(e, 1))) continue;
    report(Rule::kSameFaceTwice, e,
           [&] { return sentence::of("{} has {} on both sides, expected two faces", e, f); });
  }
  check_vertices();
}

template <class Mesh>
void PolygonChecker<Mesh>::check_degrees() {
  if (!has_degree_below_three(mesh_.links())) return;
  for (const Face f : mesh_.faces()) {
    const Halfedge first = mesh_.face_halfedge(f);
    const Halfedge second = mesh_.next(first);
    if (first != second && mesh_.next(second) != first) continue;
    report(Rule::kDegreeBelowThree, f, [&] {
      return sentence::of("{} has {}{}, expected three or more", f, mesh_.degree(f),
                          first == second ? " corner" : " corners");
    });
  }
}

template <class Mesh>
void PolygonChecker<Mesh>::check_repeated_vertices(Array<Index>& mark) {
  RingToucher toucher(RawLinks(mesh_), Ring::kFaceVertices, Direction::kCcw);
  for (const Face f : mesh_.faces()) {
    toucher.reach(f.index());
    for (const Vertex v : mesh_.face_vertices_ccw(f)) {
      if (mark[v.index()] == f.index()) {
        report(Rule::kRepeatedVertex, f,
               [&] { return sentence::of("{} has {} at more than one corner", f, v); });
      }
      mark[v.index()] = f.index();
    }
  }
}

// Reported at the second of the two, once for each edge: from its smaller vertex.
template <class Mesh>
void PolygonChecker<Mesh>::check_duplicate_halfedges(Array<Index>& mark) {
  RingToucher toucher(RawLinks(mesh_), Ring::kVertexVertices, Direction::kCw);
  for (const Vertex v : mesh_.vertices()) {
    toucher.reach(v.index());
    for (const Halfedge h : mesh_.outgoing_cw(v)) {
      const Vertex to = mesh_.to_vertex(h);
      if (mark[to.index()] == v.index() && v <= to) {
        report(Rule::kDuplicateHalfedge, h, [&] {
          return sentence::of("{} leads from {} to {}, as another halfedge does already", h, v, to);
        });
      }
      mark[to.index()] = v.index();
    }
  }
}

template <class Mesh>
void PolygonChecker<Mesh>::check_vertices() {
  for (const Vertex v : mesh_.vertices()) {
    if (mesh_.is_isolated(v)) {
      report(Rule::kIsolatedVertex, v,
             [&] { return sentence::of("{} is isolated: it has no edges", v); });
    } else if (mesh_.is_boundary(v) && !mesh_.is_manifold(v)) {
      report(Rule::kPinchedVertex, v,
             [&] { return sentence::of("{} is pinched: its faces form more than one fan", v); });
    }
  }
}

template class PolygonChecker<Connectivity>;
template class PolygonChecker<BasicConnectivity<kPrevAtRunTime>>;

}  // namespace halfedge
