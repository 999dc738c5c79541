// Attributes and generations. A column is named by its address, which is good until it is removed;
// JavaScript reads its values in place. What is called for each item is a plain export: see
// operation_bindings.h.

#include <halfedge/attributes/attributes.h>

#include <string>
#include <string_view>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

namespace {

Attribute& attribute_at(Address address) { return *reinterpret_cast<Attribute*>(address); }

std::string_view text_at(Address address, std::size_t count) {
  return {reinterpret_cast<const char*>(address), count};
}

/// The name is UTF-8. `kind`, `type` and `on_split` are values of their enums.
val add_attribute(Address mesh, int kind, Address name, std::size_t name_count, int type,
                  Index components, int on_split, Address defaults, std::size_t default_count) {
  if (!Reserve::take_back()) return failure(no_room_for_a_mesh());
  const AttributeOptions options{.type = static_cast<Scalar>(type),
                                 .components = components,
                                 .on_split = static_cast<OnSplit>(on_split),
                                 .default_value = array_at<double>(defaults, default_count)};
  Result<Attribute*> added =
      mesh_at(mesh).add_attribute(static_cast<ItemKind>(kind), text_at(name, name_count), options);
  if (!added) return failure(added.error());
  return success("attribute", val(reinterpret_cast<Address>(added.value())));
}

void remove_attribute(Address mesh, Address attribute) {
  const ItemKind kind = attribute_at(attribute).kind();
  const std::string name(attribute_at(attribute).name());  // which goes with it
  mesh_at(mesh).remove_attribute(kind, name);
}

/// All columns but those of generations.
val list_attributes(Address mesh) {
  const RoomForReport room;
  val list = val::array();
  const AnyMesh& m = mesh_at(mesh);
  for (const ItemKind kind : kItemKinds) {
    for (const auto& column : m.attributes().of(kind)) {
      if (column->is_generation()) continue;
      val item = val::object();
      item.set("attribute", reinterpret_cast<Address>(column.get()));
      item.set("kind", static_cast<int>(kind));
      item.set("name", letters_of(column->name()));
      item.set("type", static_cast<int>(column->type()));
      item.set("components", column->components());
      item.set("onSplit", static_cast<int>(column->on_split()));
      list.call<void>("push", item);
    }
  }
  return list;
}

val enable_generations(Address mesh) {
  if (!Reserve::take_back()) return failure(no_room_for_a_mesh());
  const Result<void> result = mesh_at(mesh).enable_generations();
  return result ? val::object() : failure(result.error());
}

void disable_generations(Address mesh) { mesh_at(mesh).disable_generations(); }

}  // namespace

/// Where the values lie.
HALFEDGE_EXPORT Address attribute_values(Address attribute) {
  return reinterpret_cast<Address>(attribute_at(attribute).bytes().data());
}

/// Where the default of an item lies.
HALFEDGE_EXPORT Address attribute_default(Address attribute) {
  return reinterpret_cast<Address>(attribute_at(attribute).default_value().data());
}

HALFEDGE_EXPORT int set_attribute(Address mesh, Index mode, Address attribute, Index item,
                                  Index component, double value) {
  return apply(mesh, mode, [=](auto& m) {
    Attribute& column = attribute_at(attribute);
    if (column.kind() == ItemKind::kVertex) {
      m.set_attribute(column, Vertex(item), component, value);
    } else if (column.kind() == ItemKind::kHalfedge) {
      m.set_attribute(column, Halfedge(item), component, value);
    } else if (column.kind() == ItemKind::kEdge) {
      m.set_attribute(column, Edge(item), component, value);
    } else {
      m.set_attribute(column, Face(item), component, value);
    }
    return Result<void>();
  });
}

HALFEDGE_EXPORT int has_generations(Address mesh) { return int{mesh_at(mesh).has_generations()}; }

/// The stamp of an item; 0 while there are none.
HALFEDGE_EXPORT Index generation(Address mesh, int kind, Index item) {
  const AnyMesh& m = mesh_at(mesh);
  switch (static_cast<ItemKind>(kind)) {
    case ItemKind::kVertex:
      return m.generation(Vertex(item));
    case ItemKind::kHalfedge:
      return m.generation(Halfedge(item));
    case ItemKind::kEdge:
      return m.generation(Edge(item));
    case ItemKind::kFace:
      return m.generation(Face(item));
    case ItemKind::kMesh:
      break;
  }
  return Index{0};
}

EMSCRIPTEN_BINDINGS(halfedge_attributes) {
  using emscripten::function;

  function("addAttribute", &add_attribute);
  function("removeAttribute", &remove_attribute);
  function("listAttributes", &list_attributes);
  function("enableGenerations", &enable_generations);
  function("disableGenerations", &disable_generations);
}
