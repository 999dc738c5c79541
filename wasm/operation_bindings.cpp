// The operations on edges, faces and vertices of halfedge/operations: see operation_bindings.h.

#include "operation_bindings.h"

#include <halfedge/operations/operations.h>

using namespace halfedge;
using namespace halfedge::bindings;

HALFEDGE_EXPORT int flip_edge(Address mesh, Index mode, Index e) {
  return HALFEDGE_OPERATE(flip_edge, Edge(e));
}

HALFEDGE_EXPORT int insert_edge(Address mesh, Index mode, Index h, Index g) {
  return HALFEDGE_OPERATE(insert_edge, Halfedge(h), Halfedge(g));
}

HALFEDGE_EXPORT int remove_edge(Address mesh, Index mode, Index e) {
  return HALFEDGE_OPERATE(remove_edge, Edge(e));
}

HALFEDGE_EXPORT int dissolve_edge(Address mesh, Index mode, Index e) {
  return HALFEDGE_OPERATE(dissolve_edge, Edge(e));
}

HALFEDGE_EXPORT int split_face(Address mesh, Index mode, Index f, double x, double y, double z) {
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_split_face(m, Face(f)); },
      [=](auto& m) {
        return operations::split_face(m, Face(f), position_if_given(mode, x, y, z));
      });
}

HALFEDGE_EXPORT int dissolve_vertex(Address mesh, Index mode, Index v) {
  return HALFEDGE_OPERATE(dissolve_vertex, Vertex(v));
}

HALFEDGE_EXPORT int make_hole(Address mesh, Index mode, Index f) {
  return HALFEDGE_OPERATE(make_hole, Face(f));
}

HALFEDGE_EXPORT int fill_hole(Address mesh, Index mode, Index h) {
  return HALFEDGE_OPERATE(fill_hole, Halfedge(h));
}

EMSCRIPTEN_BINDINGS(halfedge_operations) {
  // Takes the refusal away, with its memory.
  emscripten::function(
      "lastRefusal", +[] {
        const RoomForReport room;
        const Error error = std::move(*std::exchange(last_refusal, std::nullopt));
        return to_problem(error);
      });
}
