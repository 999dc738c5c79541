#pragma once

#include <halfedge/algorithms/array_sizes.h>
#include <halfedge/algorithms/neighbourhood.h>
#include <halfedge/algorithms/rings.h>
#include <halfedge/attributes/attributes.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/item_span.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <span>
#include <utility>

namespace halfedge {

/// What `extract` is made of.
namespace extracting {

/// Writes the links and positions of the part that `faces` make up; returns the items it copies.
[[nodiscard]] Result<ItemSet> copy_surface(const RawLinks& mesh, std::span<const float> positions,
                                           std::span<const Index> faces, bool stores_prev,
                                           Links& links, Array<float>& part_positions);

/// Fills an attribute of the part: item i gets the values of items[i].
void copy_values(const Attribute& from, const ItemSet& items, Attribute& to);

/// Gives the part the attributes of the mesh, but for generations. errors: out-of-memory
template <Storage kStored>
[[nodiscard]] Result<void> copy_attributes(const Attributes& attributes, const ItemSet& items,
                                           BasicMesh<kStored>& part) {
  for (const ItemKind kind : kItemKinds) {
    for (const Attributes::Column& column : attributes.of(kind)) {
      if (column->is_generation()) continue;
      double default_value[Attribute::kMaxComponents];
      for (Index c = 0; c < column->components(); ++c) default_value[c] = column->default_value(c);
      Result<Attribute*> added =
          part.add_attribute(kind, column->name(),
                             {.type = column->type(),
                              .components = column->components(),
                              .on_split = column->on_split(),
                              .default_value = std::span(default_value, column->components())});
      if (!added) return added;
      copy_values(*column, items, *added.value());
    }
  }
  return {};
}

}  // namespace extracting

/// Makes `out` a mesh of its own of some faces of `mesh`, which may be the same: of these faces, in
/// any order and with repetitions, and of their edges and vertices, with positions and attributes.
/// Where a face is left out there is a gap. Vertices whose faces are left out in between stay one
/// vertex, with several gaps.
///
/// Returns the items of `mesh` that `out` has copies of, in ascending order: vertex i of `out` is
/// vertex items.vertices[i] of `mesh`, and so on. Edges keep their sides, so that halfedge
/// 2 * i + side is 2 * items.edges[i] + side; faces keep their first halfedge, vertices their
/// anchor unless they are on the boundary now. (CGAL: copy_face_graph of a Face_filtered_graph;
/// VTK: vtkExtractCells)
///
/// After an error `out` is as it was; else it has no history and no generations.
/// cost: O(items of the part + valences at its boundary), and 4 bytes for each slot of `mesh`,
/// which are filled and given back
/// errors: index-out-of-range, deleted-item (the message names the position in `faces`);
/// corrupt-connectivity, if links of `mesh` that are followed break its invariants; out-of-memory
template <Storage kStored, Storage kOut>
requires StoresSurface<BasicMesh<kStored>> && StoresSurface<BasicMesh<kOut>>
[[nodiscard]] Result<ItemSet> extract(const BasicMesh<kStored>& mesh, ItemSpan<Face> faces,
                                      BasicMesh<kOut>& out) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  BasicMesh<kOut> part;
  if constexpr (kOut.prev_at_run_time) part.choose_prev(out.stores_prev());
  Result<ItemSet> items =
      extracting::copy_surface(RawLinks(mesh), mesh.positions(), faces.indices(),
                               part.stores_prev(), part.mutable_links(), part.mutable_positions());
  if (!items) return items;
  Result<void> done = extracting::copy_attributes(mesh.attributes(), items.value(), part);
  if (!done) return done;
  out = std::move(part);
  return items;
}

}  // namespace halfedge
