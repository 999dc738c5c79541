// The operations by which shapes are modelled, one at a time: see operation_bindings.h.

#include <halfedge/operations/operations.h>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

HALFEDGE_EXPORT int dissolve_edge(Address mesh, Index mode, Index e) {
  return HALFEDGE_OPERATE(dissolve_edge, Edge(e));
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

HALFEDGE_EXPORT int triangulate_face(Address mesh, Index mode, Index f) {
  return HALFEDGE_OPERATE(triangulate, Face(f));
}

HALFEDGE_EXPORT int triangulate(Address mesh, Index mode) {
  return operate(
      mesh, mode, [](const auto& m) { return operations::check_triangulate(m); },
      [](auto& m) { return operations::triangulate(m); });
}

HALFEDGE_EXPORT int extrude_face(Address mesh, Index mode, Index f, double offset) {
  return HALFEDGE_OPERATE(extrude_face, Face(f), offset);
}

HALFEDGE_EXPORT int inset_face(Address mesh, Index mode, Index f, double fraction) {
  return HALFEDGE_OPERATE(inset_face, Face(f), fraction);
}

HALFEDGE_EXPORT int poke(Address mesh, Index mode, Index f, double offset) {
  return HALFEDGE_OPERATE(poke, Face(f), offset);
}

HALFEDGE_EXPORT int bevel_edge(Address mesh, Index mode, Index e, double amount) {
  return HALFEDGE_OPERATE(bevel_edge, Edge(e), amount);
}

HALFEDGE_EXPORT int bevel_vertex(Address mesh, Index mode, Index v, double amount) {
  return HALFEDGE_OPERATE(bevel_vertex, Vertex(v), amount);
}
