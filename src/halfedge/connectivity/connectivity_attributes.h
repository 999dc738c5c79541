#pragma once

// The parts of BasicConnectivity that attributes need: how columns come to the mesh, and the stamps
// of generations, which are columns too.

#include <halfedge/connectivity/connectivity.h>

namespace halfedge {

template <Storage kStored>
Result<Attribute*> BasicConnectivity<kStored>::add_attribute(ItemKind kind, std::string_view name,
                                                             const AttributeOptions& options) {
  Result<Attribute*> added = add_column(kind, name, options);
  if (added) forget_redo();  // in which the column has no part
  return added;
}

template <Storage kStored>
Result<Attribute*> BasicConnectivity<kStored>::add_column(ItemKind kind, std::string_view name,
                                                          const AttributeOptions& options) {
  Result<Attribute*> added =
      attributes_.add(kind, name, options, kind == ItemKind::kMesh ? 0 : slots(kind));
  if (!added) return added;
  // Undo grows it in room that is there, as it does the links.
  if (history() != nullptr && !added.value()->reserve(capacity(kind))) {
    remove_attribute(kind, name);
    return no_memory_for("the attribute");
  }
  return added;
}

template <Storage kStored>
bool BasicConnectivity<kStored>::fit_attributes() {
  for (const ItemKind kind : kItemKinds) {
    if (!attributes_.reserve(kind, slots(kind))) return false;
    attributes_.resize(kind, slots(kind));
  }
  return true;
}

template <Storage kStored>
Result<void> BasicConnectivity<kStored>::enable_generations() {
  if (has_generations()) return {};
  constexpr ItemKind kKinds[] = {ItemKind::kVertex, ItemKind::kEdge, ItemKind::kFace};
  for (const ItemKind kind : kKinds) {
    const Result<Attribute*> added =
        add_column(kind, Attributes::kGenerationName,
                   {.type = Scalar::kUint32, .on_split = OnSplit::kDefault, .is_generation = true});
    if (added) continue;
    for (const ItemKind done : kKinds) {
      if (done == kind) return added.error();
      remove_attribute(done, Attributes::kGenerationName);
    }
  }
  attributes_.end_all_generations();  // those that were enabled before, if any
  // Steps from before have no stamps. Undone, they could bring back other items.
  if (journal_ != nullptr) journal_->forget_steps();
  return {};
}

template <Storage kStored>
template <class Item>
Index BasicConnectivity<kStored>::generation_of(Item item) const {
  const Attribute* stamps = attributes_.find(kind_of(item), Attributes::kGenerationName);
  return stamps == nullptr ? 0 : Index(stamps->get(item.index(), 0));
}

}  // namespace halfedge
