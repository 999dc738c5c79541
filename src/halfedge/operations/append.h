#pragma once

#include <halfedge/algorithms/array_sizes.h>
#include <halfedge/algorithms/rings.h>
#include <halfedge/attributes/attributes.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <span>

namespace halfedge {

/// A mesh that is only read, whatever it stores. Good until it changes.
struct MeshView {
  RawLinks links;
  std::span<const float> positions;
  const Attributes* attributes;

  template <Storage kStored>
  explicit MeshView(const BasicMesh<kStored>& mesh)
      : links(mesh), positions(mesh.positions()), attributes(&mesh.attributes()) {}
};

/// What `append` is made of: what doesn't depend on the types, and what does on one.
namespace appending {

/// What becomes of the items of a mesh: 0 for live ones, kNone for those that were deleted.
/// errors: corrupt-connectivity, out-of-memory
[[nodiscard]] Result<CompactMaps> list_live(const RawLinks& links);

/// Room for all of them in one go. errors: too-large, out-of-memory
template <Storage kStored>
[[nodiscard]] Result<void> make_room(BasicMesh<kStored>& mesh, const CompactMaps& live);

/// pre: there is room, and `live` lists the items of `other`; it becomes the maps
template <Storage kStored>
void copy_items(BasicMesh<kStored>& mesh, const MeshView& other, CompactMaps& live);

}  // namespace appending

/// Adds a copy of `other`, which may be the same mesh: its live vertices, edges and faces with
/// their positions. The two parts are not joined. Slots of `mesh` that were deleted are taken
/// first; the items that are made then are in the order of `other`. The maps say where each item
/// went, by its slot in `other`; kNone for those that were deleted there. Edges keep their sides,
/// vertices their anchors, faces their first halfedge. Items of `mesh` keep their indices.
///
/// Of the attributes, those that both have (the same kind, name, type and number of components) are
/// copied. What only `mesh` has gets its default, what only `other` has is left out: add it to
/// `mesh` first if it should be kept.
///
/// History notes it, as part of the step underway. After an error nothing has changed.
/// cost: O(slots of other), amortised
/// errors: too-large, out-of-memory, corrupt-connectivity (of `other`)
template <Storage kStored, Storage kOther>
requires StoresSurface<BasicMesh<kStored>> && StoresSurface<BasicMesh<kOther>>
[[nodiscard]] Result<CompactMaps> append(BasicMesh<kStored>& mesh, const BasicMesh<kOther>& other) {
  if (Result<void> sizes = check_array_sizes(other); !sizes) return sizes.error();
  Result<CompactMaps> maps = appending::list_live(RawLinks(other));
  if (!maps) return maps.error();
  if (Result<void> room = appending::make_room(mesh, maps.value()); !room) return room.error();
  // Only now, as making room has moved the arrays where both are the same mesh.
  appending::copy_items(mesh, MeshView(other), maps.value());
  return maps;
}

}  // namespace halfedge
