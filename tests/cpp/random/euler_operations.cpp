#include <halfedge/operations/flip.h>

#include "random/registry.h"

namespace halfedge::test {

void add_euler_operations(Operations& all) {
  namespace ops = operations;
  all.push_back(operation(
      "flip_edge", Growth::kKeeps, [](const Mesh& m, Draw& d, Call& c) { c.e = d.edge(m); },
      [](const auto& m, const Call& c) { return ops::check_flip_edge(m, c.e); },
      [](auto& m, const Call& c) { return outcome(ops::flip_edge(m, c.e)); }));
}

}  // namespace halfedge::test
