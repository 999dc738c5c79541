#include <halfedge/operations/append.h>

#include "random/registry.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {

void add_mesh_operations(Operations& all) {
  const auto always = [](const auto&, const Call&) { return Result<void>{}; };
  all.push_back(operation(
      "add_vertex", Growth::kGrows,
      [](const Mesh&, Draw& d, Call& c) { c.position = d.position(); }, always,
      [](auto& m, const Call& c) {
        (void)m.add_vertex(c.position.value_or(Point{1, 2, 3}));
        return Result<void>{};
      }));
  all.back().euler = 1;
  all.back().rarity = 3;

  all.push_back(operation(
      "append", Growth::kGrows, [](const Mesh&, Draw&, Call&) {}, always,
      [](auto& m, const Call&) {
        static const Mesh added = reference_build(mixed_polygons());
        return outcome(append(m, added));
      }));
  all.back().euler = 1;
  all.back().rarity = 15;
}

}  // namespace halfedge::test
