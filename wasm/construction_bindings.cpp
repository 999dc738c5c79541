// What adds, moves and deletes items one by one, and puts them in order: see operation_bindings.h.

#include <halfedge/connectivity/compact.h>
#include <halfedge/decorator/complexes.h>
#include <halfedge/operations/operations.h>

#include <array>
#include <limits>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

namespace {

Error no_room_for(const char* what) {
  return {"out-of-memory", std::string("memory is exhausted: no room for ") + what};
}

/// The maps are JavaScript's to free.
val compact_mesh(Address address, Index mode) {
  const bool has_reserve = Reserve::take_back();
  return visit_mesh(address, [=](auto& mesh) {
    Result<CompactMaps> maps = has_reserve ? compact(mesh) : no_room_for("maps");
    if ((mode & kKeepStepOpen) == 0) mesh.end_step();
    write_layout(mesh);
    if (!maps) return failure(maps.error());
    val result = val::object();
    result.set("vertices", hand_over(maps.value().vertices));
    result.set("edges", hand_over(maps.value().edges));
    result.set("faces", hand_over(maps.value().faces));
    return result;
  });
}

}  // namespace

/// Room for a short list of items, which then needs no block of its own.
HALFEDGE_EXPORT Address short_list() {
  static std::array<Index, 64> items;
  return reinterpret_cast<Address>(items.data());
}

HALFEDGE_EXPORT int add_vertex(Address mesh, Index mode, double x, double y, double z) {
  return apply(mesh, mode, [=](auto& m) -> Result<Vertex> {
    const Vertex v = m.add_vertex(*position_if_given(kAt, x, y, z));
    if (!v.valid()) return no_room_for("a vertex");
    return v;
  });
}

HALFEDGE_EXPORT int set_position(Address mesh, Index mode, Index v, double x, double y, double z) {
  return apply(mesh, mode, [=](auto& m) {
    Result<void> live = operations::check_live(m, Vertex(v));
    if (live) m.set_position(Vertex(v), *position_if_given(kAt, x, y, z));
    return live;
  });
}

HALFEDGE_EXPORT int add_face(Address mesh, Index mode, Address corners, std::size_t count) {
  return HALFEDGE_OPERATE(add_face, items_at<Vertex>(corners, count));
}

HALFEDGE_EXPORT int delete_vertex(Address mesh, Index mode, Index v) {
  return apply(mesh, mode, [=](auto& m) {
    return operations::delete_vertex(m, Vertex(v), {(mode & kOption) != 0});
  });
}

HALFEDGE_EXPORT int delete_edge(Address mesh, Index mode, Index e) {
  return apply(mesh, mode, [=](auto& m) {
    return operations::delete_edge(m, Edge(e), {(mode & kOption) != 0});
  });
}

HALFEDGE_EXPORT int delete_face(Address mesh, Index mode, Index f) {
  return apply(mesh, mode, [=](auto& m) {
    return operations::delete_face(m, Face(f), {(mode & kOption) != 0});
  });
}

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
  return visit_mesh(mesh, [=](auto& m) {
    const bool fits = m.reserve(vertices, edges, faces);
    write_layout(m);
    return fits ? 0 : refuse(no_room_for("so many items"));
  });
}

HALFEDGE_EXPORT void clear(Address mesh) {
  visit_mesh(mesh, [](auto& m) {
    m.clear();
    write_layout(m);
  });
}

EMSCRIPTEN_BINDINGS(halfedge_construction) { emscripten::function("compact", &compact_mesh); }
