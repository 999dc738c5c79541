// What adds, moves and deletes items one by one: see operation_bindings.h.

#include <halfedge/operations/operations.h>

#include <array>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

/// Room for a short list of items, which then needs no block of its own.
HALFEDGE_EXPORT Address short_list() {
  static std::array<Index, 64> items;
  return reinterpret_cast<Address>(items.data());
}

HALFEDGE_EXPORT int add_vertex(Address mesh, Index mode, double x, double y, double z) {
  return apply(mesh, mode, [=](auto& m) -> Result<Vertex> {
    const Vertex v = m.add_vertex(*position_if_given(kAt, x, y, z));
    if (!v.valid()) return no_memory_for("a vertex");
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
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_delete_vertex(m, Vertex(v)); },
      [=](auto& m) { return operations::delete_vertex(m, Vertex(v), {(mode & kOption) != 0}); });
}

HALFEDGE_EXPORT int delete_edge(Address mesh, Index mode, Index e) {
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_delete_edge(m, Edge(e)); },
      [=](auto& m) { return operations::delete_edge(m, Edge(e), {(mode & kOption) != 0}); });
}

HALFEDGE_EXPORT int delete_face(Address mesh, Index mode, Index f) {
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_delete_face(m, Face(f)); },
      [=](auto& m) { return operations::delete_face(m, Face(f), {(mode & kOption) != 0}); });
}
