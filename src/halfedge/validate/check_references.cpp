#include <halfedge/sentence.h>
#include <halfedge/validate/checker.h>

#include <string>

namespace halfedge {

template <class Mesh>
void ReferenceChecker<Mesh>::check_array_sizes() {
  const Links& links = mesh_.links();
  const std::size_t size = links.next.size();
  check_halfedge_array("prev", links.prev.size(), size);
  check_halfedge_array("to_vertex", links.to_vertex.size(), size);
  check_halfedge_array("face", links.face.size(), size);
  if (size % 2 != 0) {
    problems_.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
      return sentence::of(
          "next has {} entries, expected an even number: the two halfedges of an edge lie side by "
          "side",
          size);
    });
  }
  check_addressable("next", size);
  check_addressable("vertex_halfedge", links.vertex_halfedge.size());
  check_addressable("face_halfedge", links.face_halfedge.size());
}

template <class Mesh>
void ReferenceChecker<Mesh>::check_halfedge_array(const char* name, std::size_t size,
                                                  std::size_t expected) {
  if (size == expected) return;
  problems_.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
    return sentence::of("{} has {} entries, expected {}: one for each halfedge, as next has", name,
                        size, expected);
  });
}

template <class Mesh>
void ReferenceChecker<Mesh>::check_addressable(const char* name, std::size_t size) {
  if (size <= kMaxSlots) return;
  problems_.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
    return sentence::of(
        "{} has {} entries, expected at most {}: the sign bit marks empty and deleted links", name,
        size, kMaxSlots);
  });
}

template <class Mesh>
void ReferenceChecker<Mesh>::check_references() {
  const Links& links = mesh_.links();
  const std::size_t before = problems_.error_count();
  check_free_list(ItemKind::kVertex, mesh_.free_vertices(), links.vertex_halfedge, 1);
  check_free_list(ItemKind::kEdge, mesh_.free_edges(), links.next, 2);
  check_free_list(ItemKind::kFace, mesh_.free_faces(), links.face_halfedge, 1);
  // Where nothing is deleted, what is in range is live, and need not be visited to be sure.
  const bool all_live = problems_.error_count() == before && mesh_.free_vertices().count == 0 &&
                        mesh_.free_edges().count == 0 && mesh_.free_faces().count == 0;
  for (Index e = 0; e < mesh_.edge_slots(); ++e) {
    const Halfedge h = mesh_.edge_halfedge(Edge(e));
    if (all_live && is_in_range(h) && is_in_range(mesh_.opposite(h))) continue;
    check_edge_references(Edge(e));
  }
  for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
    const Index anchor = links.vertex_halfedge[v];
    if (anchor == kNone || is_deleted_link(anchor)) continue;
    check_link("anchor", Vertex(v), Halfedge(anchor));
  }
  for (Index f = 0; f < mesh_.face_slots(); ++f) {
    const Index first = links.face_halfedge[f];
    if (!is_deleted_link(first)) check_link("halfedge", Face(f), Halfedge(first));
  }
}

// A chain with as many entries as there are deleted slots, all of them deleted, and with an end
// visits none twice, so it holds them all.
template <class Mesh>
void ReferenceChecker<Mesh>::check_free_list(ItemKind kind, const FreeList& list,
                                             const Array<Index>& links, std::size_t stride) {
  const std::size_t slots = links.size() / stride;
  Index deleted = 0;
  for (std::size_t slot = 0; slot < slots; ++slot) {
    deleted += is_deleted_link(links[slot * stride]) ? 1U : 0U;
  }
  const auto complain = [&](Index slot, const std::string& what) {
    problems_.add(Rule::kFreeList, kind, slot, [&] {
      return sentence::of("the chain of deleted {} slots {}", name_of(kind), what);
    });
  };
  if (deleted != list.count) {
    return complain(kNone,
                    sentence::of("should have {} entries, but {} slots are marked as deleted",
                                 list.count, deleted));
  }
  Index length = 0;
  for (Index slot = list.head; slot != kNone; ++length) {
    if (slot >= slots) {
      return complain(kNone, sentence::of("leads to slot {} of {}", slot, slots));
    }
    const Index link = links[slot * stride];
    if (!is_deleted_link(link)) {
      return complain(slot, sentence::of("leads to slot {}, which is not deleted", slot));
    }
    if (length == deleted) {
      return complain(slot, sentence::of("runs in a circle through slot {}", slot));
    }
    slot = next_free_slot(link);
  }
  if (length != deleted) {
    complain(kNone, sentence::of("ends after {} of {} deleted slots", length, deleted));
  }
}

template <class Mesh>
bool ReferenceChecker<Mesh>::is_in_range(Halfedge h) const {
  return mesh_.next(h).index() < mesh_.halfedge_slots() &&
         mesh_.prev(h).index() < mesh_.halfedge_slots() &&
         mesh_.to_vertex(h).index() < mesh_.vertex_slots() &&
         (mesh_.face(h).index() < mesh_.face_slots() || mesh_.is_boundary(h));
}

template <class Mesh>
void ReferenceChecker<Mesh>::check_edge_references(Edge e) {
  const Links& all = mesh_.links();
  const std::size_t first = mesh_.edge_halfedge(e).index();
  unsigned deleted = 0;
  for (const Array<Index>* links : {&all.next, &all.prev, &all.to_vertex, &all.face}) {
    for (const std::size_t h : {first, first + 1}) {
      deleted += is_deleted_link((*links)[h]) ? 1U : 0U;
    }
  }
  if (deleted == 8) return;
  if (deleted != 0) {
    return report(Rule::kHalfDeletedEdge, e, [&] {
      return sentence::of(
          "{} is half deleted: {} of the 8 links of its halfedges are marked as deleted, expected "
          "all or none",
          e, deleted);
    });
  }
  for (const Index side : {0U, 1U}) {
    const Halfedge h = mesh_.edge_halfedge(e, side);
    check_link("next", h, mesh_.next(h));
    check_link("prev", h, mesh_.prev(h));
    check_link("to-vertex", h, mesh_.to_vertex(h));
    if (!mesh_.is_boundary(h)) check_link("face", h, mesh_.face(h));
  }
}

template <class Mesh>
template <class Item, class Target>
void ReferenceChecker<Mesh>::check_link(const char* name, Item item, Target target) {
  if (mesh_.is_live(target)) return;
  const auto subject = [&] { return sentence::of("the {} of {}", name, item); };
  if (!target.valid()) {
    report(Rule::kEmptyLink, item, [&] {
      return sentence::of("{} is empty, expected a {}", subject(), name_of(kind_of(target)));
    });
  } else if (target.index() >= mesh_.slots(Target{})) {
    report(Rule::kIndexOutOfRange, item, [&] {
      return sentence::of("{} is {}, expected less than {}", subject(), target,
                          mesh_.slots(Target{}));
    });
  } else {
    report(Rule::kDeletedReference, item,
           [&] { return sentence::of("{} is {}, which is deleted", subject(), target); });
  }
}

template class ReferenceChecker<Connectivity>;
template class ReferenceChecker<BasicConnectivity<kPrevAtRunTime>>;

}  // namespace halfedge
