#include <halfedge/inlining.h>
#include <halfedge/sentence.h>
#include <halfedge/validate/checker.h>

#include <algorithm>
#include <cstddef>

namespace halfedge {

namespace {

// Whether all is right with them, as nearly always. In a loop of little more than the loads, so
// that a processor sees far ahead in it: where the links lie scattered in memory, as many of them
// as it can wait for are underway at a time.
HALFEDGE_NOINLINE bool loops_agree(const Links& links) {
  const Index* const next = links.next.data();
  const Index* const to = links.to_vertex.data();
  const Index* const face = links.face.data();
  Index different = 0;
  for (std::size_t h = 0; h < links.next.size(); ++h) {
    const Index n = next[h];
    if (is_deleted_link(n)) continue;
    different |= (to[n ^ 1U] ^ to[h]) | (face[n] ^ face[h]);
  }
  return different == 0;
}

}  // namespace

template <class Mesh>
void LinkChecker<Mesh>::check_inverse_links() {
  // prev(next(h)) == h for all h makes next injective, and so a permutation with the inverse
  // prev.
  for (const Halfedge h : mesh_.halfedges()) {
    const Halfedge n = mesh_.next(h);
    if (mesh_.prev(n) == h) continue;
    report(Rule::kNextPrevMismatch, h, [&] {
      return sentence::of("the next of {} is {}, whose prev is {}", h, n, mesh_.prev(n));
    });
  }
  check_missing_anchors();
  for (const Vertex v : mesh_.vertices()) {
    const Halfedge anchor = mesh_.vertex_halfedge(v);
    if (!anchor.valid() || mesh_.from_vertex(anchor) == v) continue;
    report(Rule::kAnchorElsewhere, v, [&] {
      return sentence::of("the anchor of {} is {}, which leaves {}", v, anchor,
                          mesh_.from_vertex(anchor));
    });
  }
  for (const Face f : mesh_.faces()) {
    const Halfedge first = mesh_.face_halfedge(f);
    if (mesh_.face(first) == f) continue;
    report(Rule::kFaceHalfedgeElsewhere, f, [&] {
      return sentence::of("the halfedge of {} is {}, which lies in {}", f, first,
                          mesh_.face(first));
    });
  }
}

template <class Mesh>
void LinkChecker<Mesh>::check_missing_anchors() {
  const auto lacks_anchor = [&](Vertex v) { return !mesh_.vertex_halfedge(v).valid(); };
  const bool none_lacks =
      std::none_of(mesh_.links().vertex_halfedge.begin(), mesh_.links().vertex_halfedge.end(),
                   [](Index anchor) { return anchor == kNone; });
  if (none_lacks) return;
  Array<Index> leaving;  // by vertex, one halfedge that leaves it
  if (!has_memory(leaving.resize(mesh_.vertex_slots(), kNone), "missing anchors")) return;
  for (const Halfedge h : mesh_.halfedges()) leaving[mesh_.from_vertex(h).index()] = h.index();
  for (const Vertex v : mesh_.vertices()) {
    if (!lacks_anchor(v) || leaving[v.index()] == kNone) continue;
    report(Rule::kMissingAnchor, v, [&] {
      return sentence::of("{} has no anchor, although {} leaves it", v,
                          Halfedge(leaving[v.index()]));
    });
  }
}

template <class Mesh>
void LinkChecker<Mesh>::check_loops_agree() {
  if (loops_agree(mesh_.links())) return;
  for (const Halfedge h : mesh_.halfedges()) {
    const Halfedge n = mesh_.next(h);
    if (mesh_.from_vertex(n) != mesh_.to_vertex(h)) {
      report(Rule::kToFromMismatch, h, [&] {
        return sentence::of("{} leads to {}, but its next, {}, leaves {}", h, mesh_.to_vertex(h), n,
                            mesh_.from_vertex(n));
      });
    }
    if (mesh_.face(n) != mesh_.face(h)) {
      report(Rule::kFaceMismatch, h, [&] {
        return sentence::of("{} lies in {}, but its next, {}, lies in {}", h, mesh_.face(h), n,
                            mesh_.face(n));
      });
    }
  }
}

template class LinkChecker<Connectivity>;
template class LinkChecker<BasicConnectivity<kPrevAtRunTime>>;

}  // namespace halfedge
