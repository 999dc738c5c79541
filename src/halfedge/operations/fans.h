#pragma once

#include <halfedge/operations/requirements.h>

/// The faces around a vertex form fans: maximal rows of faces, each joined to the next by an edge.
/// One that is closed is alone. Others begin and end with boundary halfedges.
namespace halfedge::operations::internal {

/// The boundary halfedge in which the fan of faces ends, clockwise, that begins at `first`, a
/// boundary halfedge which leaves the same vertex. Its next is the first of the fan beside it.
template <class Mesh>
[[nodiscard]] Halfedge end_of_fan(const Mesh& mesh, Halfedge first) {
  Halfedge in = mesh.opposite(first);
  while (!mesh.is_boundary(in)) in = mesh.next_on_vertex(in);
  return in;
}

/// The next boundary halfedge clockwise that leaves the vertex which `h`, one itself, leaves; empty
/// if there is only one fan. O(valence)
template <class Mesh>
[[nodiscard]] Halfedge next_gap(const Mesh& mesh, Halfedge h) {
  Halfedge out = mesh.rotate_cw(h);
  while (!mesh.is_boundary(out)) out = mesh.rotate_cw(out);
  return out == h ? Halfedge{} : out;
}

}  // namespace halfedge::operations::internal
