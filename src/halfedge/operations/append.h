#pragma once

#include <halfedge/algorithms/array_sizes.h>
#include <halfedge/algorithms/rings.h>
#include <halfedge/attributes/attributes.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstddef>
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

/// How many items of each kind.
struct Counts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
};

/// The live items. errors: corrupt-connectivity, if their links lead to others
[[nodiscard]] Result<Counts> count_live(const RawLinks& links);

/// How many slots a mesh has when so many items were added. errors: too-large
template <Storage kStored>
[[nodiscard]] Result<Counts> slots_with(const BasicConnectivity<kStored>& mesh,
                                        const Counts& added);

/// Room for all of them in one go. False when memory is exhausted.
template <Storage kStored>
[[nodiscard]] bool make_room(BasicMesh<kStored>& mesh, const Counts& slots);

/// 0 for live items, kNone for those that were deleted. False when memory is exhausted.
[[nodiscard]] bool list_live(const RawLinks& links, CompactMaps& live);

/// pre: there is room, and `live` lists the items of `other`; it becomes the maps
template <Storage kStored>
void copy_items(BasicMesh<kStored>& mesh, const MeshView& other, CompactMaps& live);

/// How many slots `mesh` has afterwards: all that can be known before memory is asked for.
template <Storage kStored, Storage kOther>
[[nodiscard]] Result<Counts> count_slots(const BasicMesh<kStored>& mesh,
                                         const BasicMesh<kOther>& other) {
  if (Result<void> sizes = check_array_sizes(other); !sizes) return sizes;
  const Result<Counts> added = count_live(RawLinks(other));
  return added ? slots_with(mesh, added.value()) : added;
}

[[nodiscard]] Error out_of_memory();

}  // namespace appending

/// Whether append(mesh, other) can be done: else corrupt-connectivity (of `other`), too-large.
/// cost: O(slots of other)
template <Storage kStored, Storage kOther>
requires StoresSurface<BasicMesh<kStored>> && StoresSurface<BasicMesh<kOther>>
[[nodiscard]] Result<void> check_append(const BasicMesh<kStored>& mesh,
                                        const BasicMesh<kOther>& other) {
  Result<appending::Counts> slots = appending::count_slots(mesh, other);
  if (!slots) return slots;
  return {};
}

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
/// errors: those of check_append, out-of-memory
template <Storage kStored, Storage kOther>
requires StoresSurface<BasicMesh<kStored>> && StoresSurface<BasicMesh<kOther>>
[[nodiscard]] Result<CompactMaps> append(BasicMesh<kStored>& mesh, const BasicMesh<kOther>& other) {
  Result<appending::Counts> slots = appending::count_slots(mesh, other);
  if (!slots) return slots;
  CompactMaps maps;
  if (!appending::list_live(RawLinks(other), maps) || !appending::make_room(mesh, slots.value())) {
    return appending::out_of_memory();
  }
  // Only now, as making room has moved the arrays where both are the same mesh.
  appending::copy_items(mesh, MeshView(other), maps);
  return maps;
}

}  // namespace halfedge
