#include <halfedge/decorator/decorator.h>

#include "random/registry.h"

namespace halfedge::test {

namespace {

// The decorator allows degenerate complexes; this leaves polygons as they are.
void draw_halfedge(const Mesh& m, Draw& d, Call& c) { c.h = d.halfedge(m); }

}  // namespace

void add_decorator_operations(Operations& all) {
  all.push_back(operation(
      "decorator::split_edge", Growth::kGrows, draw_halfedge,
      [](const auto& m, const Call& c) { return decorator::check_split_edge(m, c.h); },
      [](auto& m, const Call& c) { return outcome(decorator::split_edge(m, c.h)); }));
}

}  // namespace halfedge::test
