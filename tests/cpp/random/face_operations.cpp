#include <halfedge/operations/add_face.h>
#include <halfedge/operations/components.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/dissolve.h>
#include <halfedge/operations/holes.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/split_face.h>

#include "random/items.h"
#include "random/registry.h"

namespace halfedge::test {

namespace {

namespace ops = operations;

void draw_face(const Mesh& m, Draw& d, Call& c) {
  c.f = d.face(m);
  c.position = d.position();
  c.number = double(d.below(5)) / 4 - 0.5;
  c.option = d.one_in(2);
}
void draw_edge(const Mesh& m, Draw& d, Call& c) {
  c.e = d.edge(m);
  c.option = d.one_in(2);
}
void draw_vertex(const Mesh& m, Draw& d, Call& c) {
  c.v = d.vertex(m);
  c.option = d.one_in(2);
}

// Corners along a boundary loop, and then perhaps others.
void draw_corners(const Mesh& m, Draw& d, Call& c) {
  Halfedge h = d.boundary_halfedge(m);
  for (std::size_t along = m.is_live(h) ? d.below(5) : 0; along > 0; --along, h = m.next(h)) {
    c.corners.push_back(m.to_vertex(h));
  }
  const std::size_t fewest = c.corners.size() < 3 ? 3 - c.corners.size() : 0;
  for (std::size_t more = fewest + d.below(2); more > 0; --more) c.corners.push_back(d.vertex(m));
}

ops::DeleteOptions options_of(const Call& c) { return {.keep_isolated_vertices = c.option}; }

void add_edge_operations(Operations& all) {
  all.push_back(operation(
      "insert_edge", Growth::kGrows,
      [](const Mesh& m, Draw& d, Call& c) {
        c.h = d.one_in(2) ? d.halfedge(m) : d.boundary_halfedge(m);
        c.g = d.on_loop_of(m, c.h);
      },
      [](const auto& m, const Call& c) { return ops::check_insert_edge(m, c.h, c.g); },
      [](auto& m, const Call& c) { return outcome(ops::insert_edge(m, c.h, c.g)); }));

  all.push_back(operation(
      "remove_edge", Growth::kShrinks, draw_edge,
      [](const auto& m, const Call& c) { return ops::check_remove_edge(m, c.e); },
      [](auto& m, const Call& c) { return outcome(ops::remove_edge(m, c.e)); }));
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    items.add(c.e);
    const Face left = m.face(m.edge_halfedge(c.e, 0));
    const Face right = m.face(m.edge_halfedge(c.e, 1));
    items.add(right.valid() ? right : left);
    if (!left.valid()) items.add(right);
  };

  all.push_back(operation(
      "dissolve_edge", Growth::kShrinks, draw_edge,
      [](const auto& m, const Call& c) { return ops::check_dissolve_edge(m, c.e); },
      [](auto& m, const Call& c) { return outcome(ops::dissolve_edge(m, c.e)); }));
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    for (const Index side : {0U, 1U}) {
      add_edges_and_corners(m, m.face(m.edge_halfedge(c.e, side)), items);
    }
    items.add(m.face(m.edge_halfedge(c.e, 1)));
  };
}

void add_vertex_operations(Operations& all) {
  all.push_back(operation(
      "split_face", Growth::kGrows, draw_face,
      [](const auto& m, const Call& c) { return ops::check_split_face(m, c.f); },
      [](auto& m, const Call& c) { return outcome(ops::split_face(m, c.f, c.position)); }));

  all.push_back(operation(
      "poke", Growth::kGrows, draw_face,
      [](const auto& m, const Call& c) { return ops::check_poke(m, c.f, c.number); },
      [](auto& m, const Call& c) { return outcome(ops::poke(m, c.f, c.number)); }));

  all.push_back(operation(
      "dissolve_vertex", Growth::kShrinks, draw_vertex,
      [](const auto& m, const Call& c) { return ops::check_dissolve_vertex(m, c.v); },
      [](auto& m, const Call& c) { return outcome(ops::dissolve_vertex(m, c.v)); }));
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    items.add(c.v);
    for (const Halfedge h : m.outgoing_cw(c.v)) items.add(h);
    add_faces_around(m, c.v, items);
    items.faces.erase(m.face(m.opposite(m.vertex_halfedge(c.v))).index());
  };
}

void add_hole_operations(Operations& all) {
  all.push_back(operation(
      "add_face", Growth::kGrows, draw_corners,
      [](const auto& m, const Call& c) { return ops::check_add_face(m, c.corners); },
      [](auto& m, const Call& c) { return outcome(ops::add_face(m, c.corners)); }));
  all.back().euler = {};

  all.push_back(operation(
      "make_hole", Growth::kShrinks, draw_face,
      [](const auto& m, const Call& c) { return ops::check_make_hole(m, c.f); },
      [](auto& m, const Call& c) { return outcome(ops::make_hole(m, c.f)); }));
  all.back().euler = -1;
  all.back().deletes = [](const Mesh&, const Call& c, Items& items) { items.add(c.f); };

  all.push_back(operation(
      "fill_hole", Growth::kGrows,
      [](const Mesh& m, Draw& d, Call& c) { c.h = d.boundary_halfedge(m); },
      [](const auto& m, const Call& c) { return ops::check_fill_hole(m, c.h); },
      [](auto& m, const Call& c) { return outcome(ops::fill_hole(m, c.h)); }));
  all.back().euler = 1;
}

void add_deletions(Operations& all) {
  all.push_back(operation(
      "delete_face", Growth::kShrinks, draw_face,
      [](const auto& m, const Call& c) { return ops::check_delete_face(m, c.f); },
      [](auto& m, const Call& c) { return outcome(ops::delete_face(m, c.f, options_of(c))); }));
  all.back().euler = {};
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    items.add(c.f);
    add_edges_and_corners(m, c.f, items);
  };

  all.push_back(operation(
      "delete_edge", Growth::kShrinks, draw_edge,
      [](const auto& m, const Call& c) { return ops::check_delete_edge(m, c.e); },
      [](auto& m, const Call& c) { return outcome(ops::delete_edge(m, c.e, options_of(c))); }));
  all.back().euler = {};
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    for (const Index side : {0U, 1U}) {
      items.add(m.face(m.edge_halfedge(c.e, side)));
      add_edges_and_corners(m, m.face(m.edge_halfedge(c.e, side)), items);
    }
  };

  all.push_back(operation(
      "delete_vertex", Growth::kShrinks, draw_vertex,
      [](const auto& m, const Call& c) { return ops::check_delete_vertex(m, c.v); },
      [](auto& m, const Call& c) { return outcome(ops::delete_vertex(m, c.v, options_of(c))); }));
  all.back().euler = {};
  all.back().rarity = 2;
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    items.add(c.v);
    add_faces_around(m, c.v, items);
    for (const Halfedge h : m.outgoing_cw(c.v)) add_edges_and_corners(m, m.face(h), items);
  };

  all.push_back(operation(
      "delete_component", Growth::kShrinks, draw_vertex,
      [](const auto& m, const Call& c) { return ops::check_delete_component(m, c.v); },
      [](auto& m, const Call& c) { return outcome(ops::delete_component(m, c.v)); }));
  all.back().euler = {};
  all.back().everywhere = true;
  all.back().rarity = 20;
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    add_component(m, c.v, items);
  };

  all.push_back(operation(
      "keep_largest_components", Growth::kShrinks,
      [](const Mesh&, Draw& d, Call& c) { c.count = Index(1 + d.below(3)); },
      [](const auto&, const Call&) { return Result<void>{}; },
      [](auto& m, const Call& c) { return outcome(ops::keep_largest_components(m, c.count)); }));
  all.back().euler = {};
  all.back().everywhere = true;
  all.back().rarity = 10;
  all.back().deletes = [](const Mesh& m, const Call&, Items& items) { add_everything(m, items); };
}

}  // namespace

void add_face_operations(Operations& all) {
  add_edge_operations(all);
  add_vertex_operations(all);
  add_hole_operations(all);
  add_deletions(all);
}

}  // namespace halfedge::test
