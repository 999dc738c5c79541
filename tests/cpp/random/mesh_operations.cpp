#include <halfedge/operations/append.h>
#include <halfedge/operations/triangulate.h>

#include "random/registry.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {

void add_mesh_operations(Operations& all) {
  namespace ops = operations;
  const auto always = [](const auto&, const Call&) { return Result<void>{}; };
  const auto no_arguments = [](const Mesh&, Draw&, Call&) {};
  all.push_back(operation(
      "add_vertex", Growth::kGrows,
      [](const Mesh&, Draw& d, Call& c) { c.position = d.position(); }, always,
      [](auto& m, const Call& c) {
        (void)m.add_vertex(c.position.value_or(Point{1, 2, 3}));
        return Result<void>{};
      }));
  all.back().euler = 1;
  all.back().rarity = 3;

  all.push_back(operation("append", Growth::kGrows, no_arguments, always, [](auto& m, const Call&) {
    static const Mesh added = reference_build(mixed_polygons());
    return outcome(append(m, added));
  }));
  all.back().euler = 1;
  all.back().rarity = 15;

  all.push_back(operation(
      "triangulate", Growth::kGrows, [](const Mesh& m, Draw& d, Call& c) { c.f = d.face(m); },
      [](const auto& m, const Call& c) { return ops::check_triangulate(m, c.f); },
      [](auto& m, const Call& c) { return outcome(ops::triangulate(m, c.f)); }));

  all.push_back(operation(
      "triangulate all", Growth::kGrows, no_arguments,
      [](const auto& m, const Call&) { return ops::check_triangulate(m); },
      [](auto& m, const Call&) { return outcome(ops::triangulate(m)); }));
  all.back().everywhere = true;
  all.back().rarity = 20;
}

}  // namespace halfedge::test
