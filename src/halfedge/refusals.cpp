#include <halfedge/refusals.h>
#include <halfedge/sentence.h>

#include <utility>

namespace halfedge::refusals {

Failure refusal(const char* code, std::string text, Witness&& witness) {
  return {code, sentence::complete(std::move(text)), std::move(witness)};
}

Witness halfedges_of(std::initializer_list<Halfedge> halfedges) {
  Witness witness;
  for (const Halfedge h : halfedges) witness.halfedges.push_back(h.index());
  return witness;
}

Failure not_live(ItemKind kind, Index index, Index slots) {
  const std::string name = name_of(kind);
  const std::string article = kind == ItemKind::kEdge ? "an " : "a ";
  const std::string expected = sentence::of(", expected {}{} of this mesh", article, name);
  const char* code = kind == ItemKind::kVertex ? "not-a-vertex"
                     : kind == ItemKind::kEdge ? "not-an-edge"
                     : kind == ItemKind::kFace ? "not-a-face"
                                               : "not-a-halfedge";
  if (index == kNone) return refusal(code, sentence::of("the {} is empty{}", name, expected));
  Witness witness;
  (kind == ItemKind::kVertex ? witness.vertices
   : kind == ItemKind::kEdge ? witness.edges
   : kind == ItemKind::kFace ? witness.faces
                             : witness.halfedges) = {index};
  const std::string item = sentence::of("{} {}", name, index);
  return refusal(code,
                 index < slots ? sentence::of("{} is deleted{}", item, expected)
                               : sentence::of("{} is not in this mesh, expected an index below {}",
                                              item, slots),
                 std::move(witness));
}

Failure on_boundary(Halfedge h) {
  return refusal("boundary-halfedge",
                 sentence::of("{} has no face, expected a halfedge of a face", h),
                 halfedges_of({h}));
}

Failure off_boundary(Halfedge h, Face f) {
  return refusal("not-a-boundary-halfedge",
                 sentence::of("{} lies in {}, expected a halfedge without a face", h, f),
                 halfedges_of({h}));
}

Failure in_different_loops(Halfedge h, Halfedge g) {
  return refusal(
      "different-loops",
      sentence::of("{} is not reached by next from {}, expected two halfedges of one loop", g, h),
      halfedges_of({h, g}));
}

Failure in_same_loop(Halfedge h, Halfedge g) {
  return refusal("same-loop",
                 sentence::of("{} and {} lie in the same loop, expected two different loops", h, g),
                 halfedges_of({h, g}));
}

Failure edge_without_face(Halfedge h, const std::string& how) {
  const Edge edge(h.index() / 2);
  return refusal(
      "edge-without-face",
      sentence::of("{} would have no face on either side, {}, expected one at least", edge, how),
      {.edges = {edge.index()}});
}

Failure last_edge(Halfedge h, const std::string& what_is_left) {
  const Edge edge(h.index() / 2);
  return refusal(
      "last-edge",
      sentence::of("{} can't be removed: without it {} would have no halfedge", edge, what_is_left),
      {.edges = {edge.index()}});
}

Failure is_loop_edge(Halfedge h, Vertex v) {
  const Edge edge(h.index() / 2);
  return refusal("loop-edge",
                 sentence::of("{} leads from {} to itself, expected two different ends", edge, v),
                 {.vertices = {v.index()}, .edges = {edge.index()}});
}

Failure no_memory(const char* what) { return no_memory_for(what); }

}  // namespace halfedge::refusals
