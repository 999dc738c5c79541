#include <halfedge/operations/cut.h>
#include <halfedge/operations/glue.h>
#include <halfedge/operations/loops.h>
#include <halfedge/operations/orientation.h>

#include <algorithm>
#include <set>

#include "random/items.h"
#include "random/registry.h"

namespace halfedge::test {

namespace {

namespace ops = operations;

void draw_path(const Mesh& m, Draw& d, Call& c) { c.path = d.path(m); }

// Those of a path, of which some branch off; seldom one twice.
void draw_edges(const Mesh& m, Draw& d, Call& c) {
  std::set<Edge> drawn;
  for (std::size_t paths = 1 + d.below(3); paths > 0; --paths) {
    for (const Halfedge h : d.path(m)) drawn.insert(h.valid() ? m.edge(h) : Edge{});
  }
  c.edges.assign(drawn.begin(), drawn.end());
  if (d.one_in(20)) c.edges.push_back(c.edges[d.below(c.edges.size())]);
  if (d.one_in(20)) c.edges.clear();
}

// Two of one boundary loop, often side by side or a few apart, or of two.
void draw_boundary(const Mesh& m, Draw& d, Call& c) {
  c.h = d.boundary_halfedge(m);
  c.g = d.one_in(2) ? d.boundary_halfedge(m) : d.on_loop_of(m, c.h);
  c.count = Index(d.below(4));
}

// Of loops with as many halfedges if there are such.
void draw_two_loops(const Mesh& m, Draw& d, Call& c) {
  c.h = d.halfedge(m);
  c.g = d.halfedge(m);
  const auto length = [&](Halfedge h) {
    Index count = 0;
    for ([[maybe_unused]] const Halfedge on_loop : m.loop_ccw(h)) ++count;
    return count;
  };
  for (int tries = 0; tries < 20 && m.is_live(c.h) && m.is_live(c.g); ++tries) {
    if (length(c.h) == length(c.g)) return;
    c.g = d.halfedge(m);
  }
}

void add_glue_operations(Operations& all) {
  all.push_back(operation(
      "cut", Growth::kGrows, [](const Mesh& m, Draw& d, Call& c) { c.h = d.halfedge(m); },
      [](const auto& m, const Call& c) { return ops::check_cut(m, c.h); },
      [](auto& m, const Call& c) { return outcome(ops::cut(m, c.h)); }));
  all.back().euler = {};

  all.push_back(operation(
      "cut_path", Growth::kGrows, draw_path,
      [](const auto& m, const Call& c) { return ops::check_cut_path(m, c.path); },
      [](auto& m, const Call& c) { return outcome(ops::cut_path(m, c.path)); }));
  all.back().euler = {};

  all.push_back(operation(
      "cut_edges", Growth::kGrows, draw_edges,
      [](const auto& m, const Call& c) { return ops::check_cut_edges(m, c.edges); },
      [](auto& m, const Call& c) { return outcome(ops::cut_edges(m, c.edges)); }));
  all.back().euler = {};

  const auto deletes = [](const Mesh& m, const Call& c, Items& items) {
    Halfedge g = c.g;
    for (Index i = 0; i < std::max<Index>(1, c.count); ++i) {
      items.add(g);
      items.add(m.from_vertex(g));
      items.add(m.to_vertex(g));
      g = m.prev(g);
    }
  };
  all.push_back(operation(
      "glue", Growth::kShrinks,
      [](const Mesh& m, Draw& d, Call& c) {
        draw_boundary(m, d, c);
        c.count = 1;
      },
      [](const auto& m, const Call& c) { return ops::check_glue(m, c.h, c.g); },
      [](auto& m, const Call& c) { return outcome(ops::glue(m, c.h, c.g)); }));
  all.back().euler = {};
  all.back().deletes = deletes;

  all.push_back(operation(
      "glue_path", Growth::kShrinks, draw_boundary,
      [](const auto& m, const Call& c) { return ops::check_glue_path(m, c.h, c.g, c.count); },
      [](auto& m, const Call& c) { return outcome(ops::glue_path(m, c.h, c.g, c.count)); }));
  all.back().euler = {};
  all.back().deletes = deletes;
}

void add_loop_operations(Operations& all) {
  all.push_back(operation(
      "split_loop", Growth::kGrows, draw_path,
      [](const auto& m, const Call& c) { return ops::check_split_loop(m, c.path); },
      [](auto& m, const Call& c) { return outcome(ops::split_loop(m, c.path)); }));
  all.back().euler = 2;

  all.push_back(operation(
      "join_loop", Growth::kShrinks, draw_two_loops,
      [](const auto& m, const Call& c) { return ops::check_join_loop(m, c.h, c.g); },
      [](auto& m, const Call& c) { return outcome(ops::join_loop(m, c.h, c.g)); }));
  all.back().euler = {};
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    add_loop(m, c.g, items);
    items.add(m.face(c.h));
    items.add(m.face(c.g));
  };

  all.push_back(operation(
      "bridge", Growth::kGrows, draw_two_loops,
      [](const auto& m, const Call& c) { return ops::check_bridge(m, c.h, c.g); },
      [](auto& m, const Call& c) { return outcome(ops::bridge(m, c.h, c.g)); }));
  all.back().euler = {};
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    items.add(m.face(c.h));
    items.add(m.face(c.g));
  };

  all.push_back(operation(
      "remove_bridge", Growth::kShrinks,
      [](const Mesh& m, Draw& d, Call& c) { c.h = d.halfedge(m); },
      [](const auto& m, const Call& c) { return ops::check_remove_bridge(m, c.h); },
      [](auto& m, const Call& c) { return outcome(ops::remove_bridge(m, c.h)); }));
  all.back().euler = 2;
  all.back().everywhere = true;  // the ring may lead around the whole mesh
  all.back().deletes = [](const Mesh& m, const Call& c, Items& items) {
    Halfedge spoke = c.h;
    do {
      items.add(spoke);
      items.add(m.face(spoke));
      spoke = m.opposite(m.next(m.next(spoke)));
    } while (spoke != c.h);
  };
}

void add_orientation_operations(Operations& all) {
  all.push_back(operation(
      "reverse", Growth::kKeeps, [](const Mesh&, Draw&, Call&) {},
      [](const auto&, const Call&) { return Result<void>{}; },
      [](auto& m, const Call&) { return outcome(ops::reverse(m)); }));
  all.back().everywhere = true;
  all.back().rarity = 10;

  all.push_back(operation(
      "reverse_component", Growth::kKeeps,
      [](const Mesh& m, Draw& d, Call& c) { c.h = d.halfedge(m); },
      [](const auto& m, const Call& c) { return ops::check_reverse_component(m, c.h); },
      [](auto& m, const Call& c) { return outcome(ops::reverse_component(m, c.h)); }));
  all.back().everywhere = true;
  all.back().rarity = 5;
}

}  // namespace

void add_seam_operations(Operations& all) {
  add_glue_operations(all);
  add_loop_operations(all);
  add_orientation_operations(all);
}

}  // namespace halfedge::test
