// History: undo, redo, steps. Numbers in, a number out: see operation_bindings.h.

#include <limits>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

namespace {

/// Limits as JavaScript has them, where more than there can be is Infinity.
HistoryLimits limits_of(double steps, double bytes) {
  constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
  const auto limit = [](double number) {
    return number < static_cast<double>(kMost) ? static_cast<std::size_t>(number) : kMost;
  };
  return {limit(steps), limit(bytes)};
}

}  // namespace

/// 0 if memory is exhausted.
HALFEDGE_EXPORT int enable_history(Address mesh, double steps, double bytes) {
  if (!Reserve::take_back()) return 0;
  return int{mesh_at(mesh).enable_history(limits_of(steps, bytes))};
}

HALFEDGE_EXPORT void disable_history(Address mesh) { mesh_at(mesh).disable_history(); }

HALFEDGE_EXPORT void limit_history(Address mesh, double steps, double bytes) {
  mesh_at(mesh).limit_history(limits_of(steps, bytes));
}

HALFEDGE_EXPORT void forget_history(Address mesh) { mesh_at(mesh).forget_history(); }

/// Steps that can be undone, redone, and the bytes of all, for `which` 0, 1 and 2. 0 where it is
/// off.
HALFEDGE_EXPORT double history_size(Address mesh, int which) {
  const AnyMesh& m = mesh_at(mesh);
  const Journal* journal = m.history();
  if (journal == nullptr) return 0;
  if (which == 2) return static_cast<double>(journal->bytes());
  return static_cast<double>(which == 0 ? journal->undo_count() : journal->redo_count());
}

HALFEDGE_EXPORT void end_step(Address mesh) { mesh_at(mesh).end_step(); }

/// Takes back what was written since the end of the last step, and forgets it.
HALFEDGE_EXPORT void abandon_step(Address mesh) {
  AnyMesh& m = mesh_at(mesh);
  if (m.history() != nullptr && m.history()->has_open_step()) {
    m.undo();
    m.forget_redo();
  }
  write_layout(m);
}

/// Whether there was a step.
HALFEDGE_EXPORT int undo(Address mesh) {
  AnyMesh& m = mesh_at(mesh);
  const bool done = m.undo();
  write_layout(m);
  return int{done};
}

HALFEDGE_EXPORT int redo(Address mesh) {
  AnyMesh& m = mesh_at(mesh);
  const bool done = m.redo();
  write_layout(m);
  return int{done};
}
