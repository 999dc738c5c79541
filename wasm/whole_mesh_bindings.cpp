// What is done to a mesh as a whole: its room, its order, its components, and the degenerate
// complexes that it may hold: see operation_bindings.h.

#include <halfedge/connectivity/compact.h>
#include <halfedge/decorator/complexes.h>
#include <halfedge/operations/operations.h>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

namespace {

/// The maps are JavaScript's to free.
val compact_mesh(Address address, Index mode) {
  const bool has_reserve = Reserve::take_back();
  AnyMesh& mesh = mesh_at(address);
  Result<CompactMaps> maps = has_reserve ? compact(mesh) : no_room_for("maps");
  if ((mode & kKeepStepOpen) == 0) mesh.end_step();
  write_layout(mesh);
  if (!maps) return failure(maps.error());
  val result = val::object();
  result.set("vertices", hand_over(maps.value().vertices));
  result.set("edges", hand_over(maps.value().edges));
  result.set("faces", hand_over(maps.value().faces));
  return result;
}

}  // namespace

HALFEDGE_EXPORT int delete_isolated_vertices(Address mesh, Index mode) {
  return apply(mesh, mode,
               [](auto& m) { return Result<Index>(operations::delete_isolated_vertices(m)); });
}

HALFEDGE_EXPORT int delete_component(Address mesh, Index mode, int kind, Index item) {
  return apply(mesh, mode, [=](auto& m) -> Result<Index> {
    switch (static_cast<ItemKind>(kind)) {
      case ItemKind::kVertex:
        return operations::delete_component(m, Vertex(item));
      case ItemKind::kHalfedge:
        return operations::delete_component(m, Halfedge(item));
      case ItemKind::kEdge:
        return operations::delete_component(m, Edge(item));
      case ItemKind::kFace:
        return operations::delete_component(m, Face(item));
      case ItemKind::kMesh:
        break;
    }
    return Index{0};
  });
}

HALFEDGE_EXPORT int keep_largest_components(Address mesh, Index mode, Index keep) {
  return apply(mesh, mode, [=](auto& m) { return operations::keep_largest_components(m, keep); });
}

HALFEDGE_EXPORT int make_loop(Address mesh, Index mode) {
  return apply(mesh, mode, [](auto& m) { return decorator::make_loop(m); });
}

HALFEDGE_EXPORT int make_segment(Address mesh, Index mode) {
  return apply(mesh, mode, [](auto& m) { return decorator::make_segment(m); });
}

HALFEDGE_EXPORT int reserve(Address mesh, Index vertices, Index edges, Index faces) {
  if (!Reserve::take_back()) return kNoRoom;
  AnyMesh& m = mesh_at(mesh);
  const bool fits = m.reserve(vertices, edges, faces);
  write_layout(m);
  return fits ? 0 : refuse(no_room_for("so many items"));
}

HALFEDGE_EXPORT void clear(Address mesh) {
  AnyMesh& m = mesh_at(mesh);
  m.clear();
  write_layout(m);
}

EMSCRIPTEN_BINDINGS(halfedge_whole_mesh) { emscripten::function("compact", &compact_mesh); }
