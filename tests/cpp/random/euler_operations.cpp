#include <halfedge/operations/collapse.h>
#include <halfedge/operations/flip.h>
#include <halfedge/operations/split_edge.h>
#include <halfedge/operations/split_vertex.h>

#include "random/registry.h"

namespace halfedge::test {

namespace {

namespace ops = operations;

ops::LinkCondition condition_of(const Call& call) {
  return call.option ? ops::LinkCondition::kPermissive : ops::LinkCondition::kStrict;
}

ops::SplitSides sides_of(const Call& call) {
  return {ops::SplitSide(call.count % 3), ops::SplitSide(call.count / 3)};
}

void draw_edge(const Mesh& mesh, Draw& draw, Call& call) {
  call.e = draw.edge(mesh);
  call.position = draw.position();
}

void add_edge_operations(Operations& all) {
  all.push_back(operation(
      "flip_edge", Growth::kKeeps, draw_edge,
      [](const auto& m, const Call& c) { return ops::check_flip_edge(m, c.e); },
      [](auto& m, const Call& c) { return outcome(ops::flip_edge(m, c.e)); }));

  all.push_back(operation(
      "insert_vertex_on_edge", Growth::kGrows, draw_edge,
      [](const auto& m, const Call& c) { return ops::check_insert_vertex_on_edge(m, c.e); },
      [](auto& m, const Call& c) {
        return outcome(ops::insert_vertex_on_edge(m, c.e, c.position));
      }));

  all.push_back(operation(
      "remove_vertex_on_edge", Growth::kShrinks,
      [](const Mesh& m, Draw& d, Call& c) {
        for (int tries = 0; tries < 20; ++tries) {  // few vertices have two edges
          c.v = d.vertex(m);
          if (m.is_live(c.v) && m.valence(c.v) == 2) return;
        }
      },
      [](const auto& m, const Call& c) { return ops::check_remove_vertex_on_edge(m, c.v); },
      [](auto& m, const Call& c) { return outcome(ops::remove_vertex_on_edge(m, c.v)); }));
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    items.add(c.v);
    for (const Halfedge h : m.outgoing_cw(c.v)) items.add(h);
  };

  all.push_back(operation(
      "split_edge", Growth::kGrows, draw_edge,
      [](const auto& m, const Call& c) { return ops::check_split_edge(m, c.e); },
      [](auto& m, const Call& c) { return outcome(ops::split_edge(m, c.e, c.position)); }));
}

}  // namespace

void add_euler_operations(Operations& all) {
  add_edge_operations(all);

  all.push_back(operation(
      "collapse", Growth::kShrinks,
      [](const Mesh& m, Draw& d, Call& c) {
        c.h = d.halfedge(m);
        c.position = d.position();
        c.option = d.one_in(2);
      },
      [](const auto& m, const Call& c) { return ops::check_collapse(m, c.h, condition_of(c)); },
      [](auto& m, const Call& c) {
        return outcome(ops::collapse(m, c.h, c.position, condition_of(c)));
      }));
  all.back().moves = true;
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    items.add(m.from_vertex(c.h));
    items.add(c.h);
    for (const Halfedge side : {c.h, m.opposite(c.h)}) {
      if (m.is_boundary(side) || m.degree(m.face(side)) > 3) continue;
      items.add(m.face(side));
      items.add(side == c.h ? m.prev(side) : m.next(side));
    }
  };

  all.push_back(operation(
      "split_vertex", Growth::kGrows,
      [](const Mesh& m, Draw& d, Call& c) {
        c.h = d.halfedge(m);
        c.g = d.around_start_of(m, c.h);
        c.count = Index(d.below(9));
        c.position = d.position();
      },
      [](const auto& m, const Call& c) {
        return ops::check_split_vertex(m, c.h, c.g, sides_of(c));
      },
      [](auto& m, const Call& c) {
        return outcome(ops::split_vertex(m, c.h, c.g, c.position, sides_of(c)));
      }));
}

}  // namespace halfedge::test
