// The operations of halfedge/operations, and the two changes that are none: of positions, and the
// end of a step. See operation_bindings.h.

#include "operation_bindings.h"

#include <halfedge/operations/operations.h>

using namespace halfedge;
using namespace halfedge::bindings;

HALFEDGE_EXPORT int flip_edge(Address mesh, Index mode, Index e) {
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_flip_edge(m, Edge(e)); },
      [=](auto& m) { return operations::flip_edge(m, Edge(e)); });
}

HALFEDGE_EXPORT int set_position(Address mesh, Index mode, Index v, double x, double y, double z) {
  return apply(mesh, mode, [=](auto& m) {
    m.set_position(Vertex(v), *position_if_given(kAt, x, y, z));
    return Result<void>();
  });
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
