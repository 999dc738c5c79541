#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/result.h>

#include <initializer_list>
#include <string>

/// The sentences in which the operations of the decorator refuse.
namespace halfedge::decorator::internal {

[[nodiscard]] inline std::string number(Index index) { return std::to_string(index); }

/// "halfedge 7"
template <class Tag>
[[nodiscard]] std::string text(Handle<Tag> item) {
  return std::string(name_of(kind_of(item))) + " " + number(item.index());
}

/// `sentence` begins in lower case, or with a number, and gets its full stop here.
[[nodiscard]] Error refusal(const char* code, std::string sentence, Witness witness = {});

[[nodiscard]] Witness halfedges_of(std::initializer_list<Halfedge> halfedges);

/// not-a-vertex, not-a-halfedge, not-an-edge, not-a-face
[[nodiscard]] Error not_live(ItemKind kind, Index index, Index slots);
/// boundary-halfedge, not-a-boundary-halfedge
[[nodiscard]] Error on_boundary(Halfedge h);
[[nodiscard]] Error off_boundary(Halfedge h, Face f);
/// different-loops, same-loop
[[nodiscard]] Error in_different_loops(Halfedge h, Halfedge g);
[[nodiscard]] Error in_same_loop(Halfedge h, Halfedge g);
/// edge-without-face: what the operation would make of `edge`, which lies at `h`.
[[nodiscard]] Error edge_without_face(Halfedge h, const std::string& how);
/// last-edge: there would be nothing left to hold the items that should stay.
[[nodiscard]] Error last_edge(Halfedge h, const std::string& what_is_left);
/// loop-edge
[[nodiscard]] Error is_loop_edge(Halfedge h, Vertex v);
/// out-of-memory
[[nodiscard]] Error no_memory(const char* what);

}  // namespace halfedge::decorator::internal
