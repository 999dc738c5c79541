#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/result.h>
#include <halfedge/sentence.h>

#include <initializer_list>
#include <string>

/// The sentences in which more than one folder refuses.
namespace halfedge::refusals {

/// `sentence` begins in lower case, or with a number, and gets its full stop here.
[[nodiscard]] HALFEDGE_COLD Failure refusal(const char* code, std::string sentence,
                                            Witness&& witness = {});

[[nodiscard]] Witness halfedges_of(std::initializer_list<Halfedge> halfedges);

/// not-a-vertex, not-a-halfedge, not-an-edge, not-a-face
[[nodiscard]] Failure not_live(ItemKind kind, Index index, Index slots);
/// boundary-halfedge, not-a-boundary-halfedge
[[nodiscard]] Failure on_boundary(Halfedge h);
[[nodiscard]] Failure off_boundary(Halfedge h, Face f);
/// different-loops, same-loop
[[nodiscard]] Failure in_different_loops(Halfedge h, Halfedge g);
[[nodiscard]] Failure in_same_loop(Halfedge h, Halfedge g);
/// edge-without-face: what the operation would make of `edge`, which lies at `h`.
[[nodiscard]] Failure edge_without_face(Halfedge h, const std::string& how);
/// last-edge: there would be nothing left to hold the items that should stay.
[[nodiscard]] Failure last_edge(Halfedge h, const std::string& what_is_left);
/// loop-edge
[[nodiscard]] Failure is_loop_edge(Halfedge h, Vertex v);
/// out-of-memory
[[nodiscard]] Failure no_memory(const char* what);

}  // namespace halfedge::refusals
