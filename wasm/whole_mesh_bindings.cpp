// What is done to a mesh as a whole: its room, its order, its components, and the degenerate
// complexes that it may hold: see operation_bindings.h.

#include <halfedge/connectivity/compact.h>
#include <halfedge/decorator/complexes.h>
#include <halfedge/operations/operations.h>
#include <halfedge/operations/reorder.h>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

namespace {

/// What is left to do when items were moved. The maps are JavaScript's to free.
val moved(AnyMesh& mesh, Index mode, Result<CompactMaps> maps) {
  if ((mode & kKeepStepOpen) == 0) mesh.end_step();
  write_layout(mesh);
  if (!maps) return failure(maps.error());
  val result = val::object();
  result.set("vertices", hand_over(maps.value().vertices));
  result.set("edges", hand_over(maps.value().edges));
  result.set("faces", hand_over(maps.value().faces));
  return result;
}

val compact_mesh(Address address, Index mode) {
  const bool has_reserve = Reserve::take_back();
  AnyMesh& mesh = mesh_at(address);
  return moved(mesh, mode, has_reserve ? compact(mesh) : no_memory_for("maps"));
}

/// `order` is an index into the VERTEX_ORDERS of web/src/construction.ts.
val reorder_mesh(Address address, Index mode, int order) {
  const bool has_reserve = Reserve::take_back();
  AnyMesh& mesh = mesh_at(address);
  if (!has_reserve) return moved(mesh, mode, no_memory_for("maps"));
  return moved(mesh, mode, order == 0 ? reorder(mesh) : reorder_breadth_first(mesh));
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
  return fits ? 0 : refuse(no_memory_for("so many items"));
}

HALFEDGE_EXPORT void clear(Address mesh) {
  AnyMesh& m = mesh_at(mesh);
  m.clear();
  write_layout(m);
}

EMSCRIPTEN_BINDINGS(halfedge_whole_mesh) {
  emscripten::function("compact", &compact_mesh);
  emscripten::function("reorder", &reorder_mesh);
}
