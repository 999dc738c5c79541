// The operations by which shapes are modelled: see operation_bindings.h.

#include <halfedge/operations/operations.h>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

HALFEDGE_EXPORT int triangulate_face(Address mesh, Index mode, Index f) {
  return HALFEDGE_OPERATE(triangulate, Face(f));
}

HALFEDGE_EXPORT int triangulate(Address mesh, Index mode) {
  return operate(
      mesh, mode, [](const auto& m) { return operations::check_triangulate(m); },
      [](auto& m) { return operations::triangulate(m); });
}
