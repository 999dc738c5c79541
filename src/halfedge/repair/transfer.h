#pragma once

#include <halfedge/attributes/attribute.h>
#include <halfedge/build/polygons.h>
#include <halfedge/build/soup_attribute.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/links.h>
#include <halfedge/mesh.h>
#include <halfedge/repair/repair.h>
#include <halfedge/result.h>

#include <cstddef>
#include <span>

namespace halfedge {

/// Carries values from the items of a soup to those of the mesh that was made of it.
class Transfer {
 public:
  /// `report` is that of the repair, or null after a strict build, where items keep their indices.
  Transfer(const Links& links, const Polygons& soup, const RepairReport* report)
      : links_(links), soup_(soup), report_(report) {}

  /// Gives `to`, a column of the mesh, the values of `from`, which may be used up by that. What
  /// comes from nowhere keeps its default. False when memory is exhausted.
  [[nodiscard]] bool fill(Attribute& to, SoupAttribute& from);

 private:
  [[nodiscard]] bool find_faces();
  [[nodiscard]] bool find_corners();
  [[nodiscard]] bool match(Index halfedge, std::size_t begin, std::size_t size);
  [[nodiscard]] bool follow(std::size_t begin, std::size_t size);

  const Links& links_;
  const Polygons& soup_;
  const RepairReport* report_;
  Array<Index> faces_;    // by face of the mesh: that of the soup
  Array<Index> corners_;  // by halfedge: the corner of the soup in which it ends, or kNone
  Array<Index> loop_;     // of the face that is matched
};

/// Adds the columns beside a soup to the mesh that was built of it, as its attributes. They follow
/// their items where a repair has welded, doubled, dropped or turned over: what was welded has the
/// value of the vertex whose position it has; a copy has that of its original; a corner keeps its
/// own. Halfedges without a face have what the face has that follows on them around their vertex;
/// in a mesh that doesn't store which these are, zeros.
///
/// `report` is that of `build_from_soup`, or null after a strict build. The columns are used up one
/// after the other, so that memory is needed for one more at most.
/// pre: `mesh` is as it was built of `soup`. cost: O(values)
/// errors: attribute-exists, bad-attribute, out-of-memory; the columns before stay then, none of
///         them half filled
template <Storage kStored>
[[nodiscard]] Result<void> add_attributes(BasicMesh<kStored>& mesh, const Polygons& soup,
                                          const RepairReport* report,
                                          std::span<SoupAttribute> columns) {
  static_assert(kStored.face_halfedge, "corners and faces are found by their start halfedges");
  constexpr ItemKind kKinds[] = {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kFace};
  Transfer transfer(mesh.links(), soup, report);
  for (SoupAttribute& from : columns) {
    Result<Attribute*> to = mesh.add_attribute(
        kKinds[std::size_t(from.item)], from.name,
        {.type = from.type, .components = from.components, .on_split = from.on_split});
    if (!to) return to;
    const bool is_filled = transfer.fill(*to.value(), from);
    from.values.reset();
    from.rows.reset();
    if (!is_filled) {
      mesh.remove_attribute(kKinds[std::size_t(from.item)], from.name);
      return no_memory_for("the attributes of the file's mesh");
    }
  }
  return {};
}

}  // namespace halfedge
