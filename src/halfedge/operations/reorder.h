#pragma once

#include <halfedge/algorithms/vertex_order.h>
#include <halfedge/attributes/attributes.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstddef>
#include <utility>

namespace halfedge {

/// What `reorder` is made of, whatever a mesh stores: where all items go when the vertices come in
/// a given order, and the arrays in that order.
class Reordering {
 public:
  /// All that can fail. `vertices` lists all live ones, each once; the slots are those of `mesh`.
  template <Storage kStored>
  [[nodiscard]] Result<void> plan(const BasicConnectivity<kStored>& mesh, Array<Index>&& vertices) {
    return plan(mesh.links(), mesh.attributes(), mesh.vertex_slots(), mesh.face_slots(),
                std::move(vertices));
  }
  /// Whether any item gets another index, or a slot is left out.
  [[nodiscard]] bool moves_anything() const;
  /// pre: planned for these, and nothing has changed since. Can't fail.
  void move_links(Links& links);
  void move_attributes(Attributes& attributes);
  void move_positions(Array<float>& positions);

  [[nodiscard]] CompactMaps& maps() { return maps_; }

  /// Plans and does it.
  template <class AnyMesh>
  [[nodiscard]] static Result<CompactMaps> run(AnyMesh& mesh, Result<Array<Index>> vertices) {
    if (!vertices) return vertices.error();
    Reordering order;
    Result<void> planned = order.plan(mesh, std::move(vertices).value());
    if (!planned) return planned;
    if (order.moves_anything()) {
      constexpr bool kHasPositions = requires { mesh.mutable_positions(); };
      if constexpr (kHasPositions) {
        if (mesh.history() != nullptr) Compaction::note_positions(mesh);
      }
      Compaction::rewrite(mesh, [&](Links& links, Attributes& attributes) {
        order.move_links(links);
        order.move_attributes(attributes);
      });
      if constexpr (kHasPositions) order.move_positions(mesh.mutable_positions());
    }
    return std::move(order.maps());
  }

 private:
  [[nodiscard]] Result<void> plan(const Links& links, const Attributes& attributes,
                                  std::size_t vertex_slots, std::size_t face_slots,
                                  Array<Index>&& vertices);
  [[nodiscard]] bool reserve(const Links& links, const Attributes& attributes,
                             std::size_t vertex_slots, std::size_t face_slots);
  void number_vertices();
  [[nodiscard]] bool number_faces(const Links& links);
  [[nodiscard]] bool number_edges(const Links& links);

  CompactMaps maps_;  // by old slot
  // By new slot, the old one.
  Array<Index> vertices_;
  Array<Index> edges_;
  Array<Index> faces_;
  Array<std::byte> old_;  // a copy of what is moved
};

/// Renumbers all items for locality: vertices along a Morton curve through their positions (see
/// morton_order), faces by the smallest of their vertices, edges by the smaller of their faces (by
/// the smaller of their vertices, if there are no faces). Those for which that is the same stay in
/// their order; edges without a face come last. What lies close together in space then lies close
/// together in memory: a mesh in random order is circulated several times as fast afterwards.
/// Deleted slots are left out, as by `compact`.
///
/// The builder can't number edges by face, as it has no say in the order of faces: groups of edges
/// by vertex are better unless faces come in an order that follows the vertices, as here.
///
/// It stays the same mesh: edges keep their sides, vertices their anchors, faces their first
/// halfedge, all items their attributes and positions. The maps say where each item went, as those
/// of `compact` do: by old slot, kNone for slots that were deleted. Where halfedges store no faces,
/// faces keep their order.
///
/// History notes it as it does `compact`, and generations end. A mesh that is in this order already
/// isn't changed, and that is no step of history. After an error nothing has changed.
///
/// pre: no live item refers to a deleted one (invariant 7); links that lead out of the arrays are
/// not followed, and empty afterwards
/// cost: O(slots); about half as much memory again as the mesh takes, the maps included
/// errors: out-of-memory
template <Storage kStored>
[[nodiscard]] Result<CompactMaps> reorder(BasicMesh<kStored>& mesh) {
  return Reordering::run(mesh, morton_order(mesh.positions(), mesh.links()));
}

/// The same by breadth-first search over the edges (see breadth_first_order): for meshes whose
/// positions say nothing, or that have none.
template <Storage kStored>
[[nodiscard]] Result<CompactMaps> reorder_breadth_first(BasicMesh<kStored>& mesh) {
  static_assert(kStored.vertex_halfedge, "a breadth-first search needs Storage::vertex_halfedge");
  return Reordering::run(mesh, breadth_first_order(mesh.links()));
}
template <Storage kStored>
[[nodiscard]] Result<CompactMaps> reorder_breadth_first(BasicConnectivity<kStored>& mesh) {
  static_assert(kStored.vertex_halfedge, "a breadth-first search needs Storage::vertex_halfedge");
  return Reordering::run(mesh, breadth_first_order(mesh.links()));
}

}  // namespace halfedge
