#include <halfedge/operations/bevel.h>
#include <halfedge/operations/extrude.h>

#include "random/registry.h"

namespace halfedge::test {

namespace {

namespace ops = operations;

// From -0.25 to 1.25, so that some are out of range.
double fraction(Draw& d) { return double(d.below(13)) / 8 - 0.25; }

void draw_face(const Mesh& m, Draw& d, Call& c) {
  c.f = d.face(m);
  c.number = fraction(d);
}

}  // namespace

void add_form_operations(Operations& all) {
  all.push_back(operation(
      "extrude_face", Growth::kGrows, draw_face,
      [](const auto& m, const Call& c) { return ops::check_extrude_face(m, c.f, c.number); },
      [](auto& m, const Call& c) { return outcome(ops::extrude_face(m, c.f, c.number)); }));

  all.push_back(operation(
      "inset_face", Growth::kGrows, draw_face,
      [](const auto& m, const Call& c) { return ops::check_inset_face(m, c.f, c.number); },
      [](auto& m, const Call& c) { return outcome(ops::inset_face(m, c.f, c.number)); }));

  all.push_back(operation(
      "bevel_vertex", Growth::kGrows,
      [](const Mesh& m, Draw& d, Call& c) {
        c.v = d.vertex(m);
        c.number = fraction(d);
      },
      [](const auto& m, const Call& c) { return ops::check_bevel_vertex(m, c.v, c.number); },
      [](auto& m, const Call& c) { return outcome(ops::bevel_vertex(m, c.v, c.number)); }));
  all.back().moves = true;

  all.push_back(operation(
      "bevel_edge", Growth::kGrows,
      [](const Mesh& m, Draw& d, Call& c) {
        c.e = d.edge(m);
        c.number = fraction(d);
      },
      [](const auto& m, const Call& c) { return ops::check_bevel_edge(m, c.e, c.number); },
      [](auto& m, const Call& c) { return outcome(ops::bevel_edge(m, c.e, c.number)); }));
  all.back().moves = true;
}

}  // namespace halfedge::test
