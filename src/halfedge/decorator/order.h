#pragma once

#include <halfedge/decorator/edit.h>

#include <cstddef>
#include <utility>

namespace halfedge::decorator {

namespace internal {

/// The loop of `h` runs the other way; the values of a corner stay at the corner. Ends of edges are
/// the caller's.
template <class Mesh>
void reverse_loop(Mesh& mesh, Halfedge h) {
  Halfedge before = h;
  Halfedge at = mesh.next(h);
  while (at != h) {
    const Halfedge after = mesh.next(at);
    mesh.swap_corners(h, at);
    mesh.link(at, before);
    before = at;
    at = after;
  }
  mesh.link(h, before);
}

/// All loops along these edges, whose anchors are the caller's. pre: whole components; `seen` is
/// false for each halfedge slot
template <class Mesh, class Edges>
void reverse_loops(Mesh& mesh, const Edges& edges, Array<bool>& seen) {
  for (const Edge e : edges) {
    for (const Index side : {0U, 1U}) {
      const Halfedge h = mesh.edge_halfedge(e, side);
      if (seen[h.index()]) continue;
      for (const Halfedge on_loop : mesh.loop_ccw(h)) seen[on_loop.index()] = true;
      reverse_loop(mesh, h);
    }
  }
  for (const Edge e : edges) {
    const Halfedge h = mesh.edge_halfedge(e);
    const Vertex from = mesh.from_vertex(h);
    mesh.set_to_vertex(mesh.opposite(h), mesh.to_vertex(h));
    mesh.set_to_vertex(h, from);
  }
}

}  // namespace internal

/// Turns the surface inside out: every halfedge runs the other way along the loop it is in, so that
/// what was counter-clockwise is clockwise. Halfedges keep their edges and faces; attributes of a
/// corner go to the halfedge that ends there now. (CGAL: inside_out)
///
/// cost: O(slots), one byte for each halfedge slot. inverse: itself
/// errors: out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<void> inside_out(Mesh& mesh) {
  using namespace internal;
  Array<bool> seen;
  if (!seen.resize(mesh.halfedge_slots(), false)) return no_memory("the loops");
  if constexpr (StoresAnchors<Mesh>) {
    // The halfedge that arrives along the same loop, so that it is a boundary halfedge if the
    // anchor is.
    for (const Vertex v : mesh.vertices()) {
      if (mesh.is_isolated(v)) continue;
      mesh.set_vertex_halfedge(v, mesh.prev(mesh.vertex_halfedge(v)));
    }
  }
  reverse_loops(mesh, mesh.edges(), seen);
  return {};
}

/// What normalize_boundary did.
struct BoundaryOrder {
  /// By old halfedge slot: the new halfedge; empty for a deleted one.
  Array<Halfedge> new_halfedge;
  /// The first boundary edge; empty if there is none. All live edges from it on are boundary edges.
  Edge first_boundary_edge;
  Index boundary_edges = 0;
  /// More than boundary_edges where an edge has no face on either side.
  Index boundary_halfedges = 0;
};

/// Whether the boundary edges come after all others, and side 1 of each is a boundary halfedge.
/// (CGAL: normalized_border_is_valid). cost: O(edge slots)
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] bool is_boundary_normalized(const Mesh& mesh) {
  bool at_boundary = false;
  for (const Edge e : mesh.edges()) {
    at_boundary = at_boundary || mesh.is_boundary(e);
    if (at_boundary && !mesh.is_boundary(mesh.edge_halfedge(e, 1))) return false;
  }
  return true;
}

namespace internal {

/// array[new_of[i]] = array[i], its entries renumbered by new_of if `renumber`.
inline void permute(Array<Index>& array, const Array<Halfedge>& new_of, Array<Index>& scratch,
                    bool renumber) {
  for (std::size_t h = 0; h < array.size(); ++h) scratch[h] = array[h];
  for (std::size_t h = 0; h < array.size(); ++h) {
    if (!new_of[h].valid()) continue;  // a deleted slot stays where it is
    array[new_of[h].index()] = renumber ? new_of[scratch[h]].index() : scratch[h];
  }
}

/// All links, in place. `scratch` has an entry for each halfedge slot.
template <class Mesh>
void renumber_halfedges(Mesh& mesh, const Array<Halfedge>& new_of, Array<Index>& scratch) {
  Links& links = mesh.mutable_links();
  if constexpr (StoresAnchors<Mesh>) {
    for (const Vertex v : mesh.vertices()) {
      Index& anchor = links.vertex_halfedge[v.index()];
      if (anchor != kNone) anchor = new_of[anchor].index();
    }
  }
  if constexpr (StoresFaceHalfedges<Mesh>) {
    for (const Face f : mesh.faces()) {
      Index& first = links.face_halfedge[f.index()];
      first = new_of[first].index();
    }
  }
  permute(links.next, new_of, scratch, true);
  if (mesh.stores_prev()) permute(links.prev, new_of, scratch, true);
  permute(links.to_vertex, new_of, scratch, false);
  permute(links.face, new_of, scratch, false);
}

/// The values of edges and halfedges follow them. `place` has an entry for each halfedge slot.
template <class Mesh>
void renumber_attributes(Mesh& mesh, const Array<Halfedge>& new_of, Array<Index>& place) {
  for (const ItemKind kind : {ItemKind::kHalfedge, ItemKind::kEdge}) {
    const Index width = kind == ItemKind::kEdge ? 2 : 1;
    for (Attributes::Column& column : mesh.columns(kind)) {
      for (Index i = 0; i < column->slots(); ++i) {
        const Halfedge to = new_of[std::size_t{width} * i];
        place[i] = to.valid() ? to.index() / width : i;
      }
      for (Index i = 0; i < column->slots(); ++i) {
        while (place[i] != i) {
          column->swap(i, place[i], nullptr);
          std::swap(place[i], place[place[i]]);
        }
      }
    }
  }
}

}  // namespace internal

/// Renumbers the edges so that boundary edges come last, with the boundary halfedge on side 1; but
/// for that they stay in order. Deleted slots stay where they are. (CGAL: normalize_border)
///
/// Handles of edges and halfedges, and what is stored by edge or halfedge outside the mesh, change
/// as `new_halfedge` says; vertices and faces keep theirs. History is forgotten.
/// attributes: those of edges and halfedges move with them; generations end
/// post: is_boundary_normalized(mesh)
/// cost: O(slots), 8 bytes a halfedge of scratch memory. inverse: none; the same again changes
///       nothing
/// errors: out-of-memory
template <Editable Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] Result<BoundaryOrder> normalize_boundary(Mesh& mesh) {
  using namespace internal;
  BoundaryOrder order;
  Array<Index> scratch;
  if (!order.new_halfedge.resize(mesh.halfedge_slots(), Halfedge{}) ||
      !scratch.resize(mesh.halfedge_slots())) {
    return no_memory("the new order of the edges");
  }

  auto slot = mesh.edges().begin();  // the live slots in order are filled with the edges in order
  for (const bool boundary : {false, true}) {
    for (const Edge e : mesh.edges()) {
      if (mesh.is_boundary(e) != boundary) continue;
      const Halfedge h = mesh.edge_halfedge(e);
      const Index turned = boundary && !mesh.is_boundary(mesh.opposite(h)) ? 1 : 0;
      order.new_halfedge[h.index()] = mesh.edge_halfedge(*slot, turned);
      order.new_halfedge[mesh.opposite(h).index()] = mesh.edge_halfedge(*slot, 1 - turned);
      if (boundary) {
        if (!order.first_boundary_edge.valid()) order.first_boundary_edge = *slot;
        ++order.boundary_edges;
        order.boundary_halfedges +=
            mesh.is_boundary(h) && mesh.is_boundary(mesh.opposite(h)) ? 2U : 1U;
      }
      ++slot;
    }
  }
  renumber_halfedges(mesh, order.new_halfedge, scratch);
  renumber_attributes(mesh, order.new_halfedge, scratch);
  mesh.end_generations();
  return order;
}

}  // namespace halfedge::decorator
