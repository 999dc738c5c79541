// Handles cut and closed, loops joined, tubes; orientations reversed.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/operations/loops.h>
#include <halfedge/operations/orientation.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support/polygon_lists.h"

namespace halfedge::test {
namespace {

using namespace operations;

Halfedge halfedge(const Mesh& mesh, Index from, Index to) {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  EXPECT_TRUE(h.valid()) << from << " -> " << to;
  return h;
}

std::vector<Halfedge> loop_of(const Mesh& mesh, Halfedge h) {
  std::vector<Halfedge> all;
  for (const Halfedge on_loop : mesh.loop_ccw(h)) all.push_back(on_loop);
  return all;
}

// One halfedge of each loop.
std::vector<Halfedge> loops_of(const Mesh& mesh, std::size_t most) {
  std::vector<Halfedge> all;
  std::set<Halfedge> seen;
  for (const Halfedge h : mesh.halfedges()) {
    if (seen.count(h) > 0) continue;
    for (const Halfedge on_loop : mesh.loop_ccw(h)) seen.insert(on_loop);
    all.push_back(h);
  }
  std::mt19937 random(1);
  std::shuffle(all.begin(), all.end(), random);
  if (all.size() > most) all.resize(most);
  return all;
}

// The polygons without the faces of h and g, the vertices of g's loop renamed to those of h's.
Polys joined_polygons(const Mesh& mesh, Halfedge h, Halfedge g) {
  std::map<Index, Index> kept;
  Halfedge on_g = g;
  for (const Halfedge on_h : mesh.loop_ccw(h)) {
    kept[mesh.from_vertex(on_g).index()] = mesh.to_vertex(on_h).index();
    on_g = mesh.prev(on_g);
  }
  Polys all;
  for (const Face f : mesh.faces()) {
    if (f == mesh.face(h) || f == mesh.face(g)) continue;
    std::vector<Index> polygon = polygon_of(mesh, f);
    for (Index& v : polygon) v = kept.count(v) > 0 ? kept[v] : v;
    all.push_back(polygon);
  }
  return all;
}

TEST(JoinLoop, SweepOverPairsOfLoops) {
  std::map<std::string_view, int> codes;
  for (auto& [name, mesh] : meshes_to_sweep(12)) {
    SCOPED_TRACE(name);
    const std::vector<Halfedge> loops = loops_of(mesh, 14);
    for (const Halfedge h : loops) {
      for (const Halfedge g : loops) {
        SCOPED_TRACE(std::to_string(h.index()) + " " + std::to_string(g.index()));
        bool done = false;
        const Mesh joined = try_operation(
            mesh, [&](const Mesh& m) { return check_join_loop(m, h, g); },
            [&](Mesh& m) { return join_loop(m, h, g); }, done);
        const std::string_view code = done ? "done" : check_join_loop(mesh, h, g).error().code;
        ++codes[code];
        if (done) {
          EXPECT_EQ(in_order(polygons_of(joined)), in_order(joined_polygons(mesh, h, g)));
        } else if (code == "edge-exists" || code == "duplicate-edge" ||
                   (code == "repeated-vertex" &&
                    !check_join_loop(mesh, h, g).error().witness.faces.empty())) {
          // As many edges fewer as the loops are long, and a mesh? Then it was refused in error.
          const Polys polygons = joined_polygons(mesh, h, g);
          const std::size_t n = loop_of(mesh, h).size();
          EXPECT_FALSE(is_mesh(polygons) && edges_of(polygons).size() + n == mesh.edge_count());
        }
        ASSERT_FALSE(HasFailure());
      }
    }
  }
  EXPECT_GT(codes["done"], 100);
  EXPECT_GT(codes["edge-exists"], 5);
  EXPECT_GT(codes["duplicate-edge"], 5);
  EXPECT_GT(codes["repeated-vertex"], 5);
  EXPECT_GT(codes["same-loop"], 5);
  EXPECT_GT(codes["different-degrees"], 5);
  EXPECT_GT(codes["edge-without-face"], 0);
}

TEST(SplitLoop, CutsAHandleAndJoinLoopBringsItBack) {
  Mesh mesh = reference_build(torus(4, 3));
  add_attributes_of_all_kinds(mesh);
  const Mesh before = copy_of(mesh);
  const std::array<Halfedge, 3> cycle = {halfedge(mesh, 0, 4), halfedge(mesh, 4, 8),
                                         halfedge(mesh, 8, 0)};
  EXPECT_EQ(genus(mesh).value(), 1);
  const Halfedge g = split_loop(mesh, cycle).value();
  expect_valid_mesh(mesh);
  EXPECT_EQ(genus(mesh).value(), 0);
  EXPECT_EQ(mesh.face_count(), 14U);
  EXPECT_EQ(mesh.degree(mesh.face(g)), 3U);
  EXPECT_EQ(join_loop(mesh, cycle[0], g).value(), cycle[0]);
  expect_valid_mesh(mesh);
  EXPECT_EQ(genus(mesh).value(), 1);
  EXPECT_EQ(in_order(polygons_of(mesh)), in_order(polygons_of(before)));
  EXPECT_TRUE(LiveItems(mesh) == LiveItems(before));
}

TEST(SplitLoop, SweepOverFacesAsCycles) {
  int done_count = 0;
  for (const auto& [name, mesh] : meshes_to_sweep(8)) {
    SCOPED_TRACE(name);
    for (const Halfedge h : loops_of(mesh, 10)) {
      const std::vector<Halfedge> cycle = loop_of(mesh, h);
      bool done = false;
      const Mesh split = try_operation(
          mesh, [&](const Mesh& m) { return check_split_loop(m, cycle); },
          [&](Mesh& m) { return split_loop(m, cycle); }, done);
      std::set<Vertex> vertices;
      for (const Halfedge on_cycle : cycle) vertices.insert(mesh.to_vertex(on_cycle));
      EXPECT_EQ(done, vertices.size() == cycle.size());
      if (!done) continue;
      ++done_count;
      EXPECT_EQ(split.face_count(), mesh.face_count() + 2);
      EXPECT_EQ(split.edge_count(), mesh.edge_count() + cycle.size());
      Mesh again = copy_of(mesh);
      const Halfedge g = split_loop(again, cycle).value();
      ASSERT_TRUE(join_loop(again, cycle[0], g).ok());
      EXPECT_TRUE(LiveItems(again) == LiveItems(mesh));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(done_count, 100);
}

TEST(SplitLoop, Refusals) {
  Mesh mesh = reference_build(torus(4, 3));
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  const Halfedge h = halfedge(mesh, 0, 4);
  std::vector<Halfedge> cycle;
  expect_refused(split_loop(mesh, cycle), "not-a-cycle", mesh, before);
  cycle = {h, halfedge(mesh, 8, 0)};
  const Result<Halfedge> refused = split_loop(mesh, cycle);
  expect_refused(refused, "not-a-cycle", mesh, before);
  EXPECT_EQ(refused.error().witness.halfedges, (std::vector<Index>{h.index(), cycle[1].index()}));
  cycle = {h, Mesh::opposite(h)};
  expect_refused(split_loop(mesh, cycle), "not-a-cycle", mesh, before);
  cycle = {h, Halfedge(999)};
  expect_refused(split_loop(mesh, cycle), "not-a-halfedge", mesh, before);
  cycle = {h,
           halfedge(mesh, 4, 8),
           halfedge(mesh, 8, 0),
           halfedge(mesh, 0, 1),
           halfedge(mesh, 1, 2),
           halfedge(mesh, 2, 3),
           halfedge(mesh, 3, 0)};
  const Result<Halfedge> repeated = split_loop(mesh, cycle);
  expect_refused(repeated, "repeated-vertex", mesh, before);
  EXPECT_EQ(repeated.error().witness.vertices, std::vector<Index>{0});
}

TEST(JoinLoop, RefusesNeighbouringFacesOfATube) {
  // A prism of four sides: its ends are joined by edges, so that they can't be glued.
  Mesh mesh = reference_build(cube());
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  const Result<Halfedge> ends = join_loop(mesh, halfedge(mesh, 0, 3), halfedge(mesh, 7, 4));
  expect_refused(ends, "edge-exists", mesh, before);
  const Edge joining(ends.error().witness.edges.at(0));
  EXPECT_EQ(mesh.find_edge(Vertex(ends.error().witness.vertices.at(0)),
                           Vertex(ends.error().witness.vertices.at(1))),
            joining);
  expect_refused(join_loop(mesh, Halfedge(0), Halfedge{}), "not-a-halfedge", mesh, before);
  const Halfedge h = mesh.face_halfedge(Face(0));
  expect_refused(join_loop(mesh, h, mesh.next(h)), "same-loop", mesh, before);
}

// ---- bridge ------------------------------------------------------------------------------------

Polys bridged_polygons(const Mesh& mesh, Halfedge h, Halfedge g) {
  Polys all;
  for (const Face f : mesh.faces()) {
    if (f != mesh.face(h) && f != mesh.face(g)) all.push_back(polygon_of(mesh, f));
  }
  Halfedge on_g = g;
  for (const Halfedge on_h : mesh.loop_ccw(h)) {
    all.push_back({mesh.from_vertex(on_h).index(), mesh.to_vertex(on_h).index(),
                   mesh.from_vertex(on_g).index(), mesh.to_vertex(on_g).index()});
    on_g = mesh.prev(on_g);
  }
  return all;
}

TEST(Bridge, SweepOverPairsOfLoops) {
  std::map<std::string_view, int> codes;
  for (const auto& [name, mesh] : meshes_to_sweep(12)) {
    SCOPED_TRACE(name);
    const std::vector<Halfedge> loops = loops_of(mesh, 12);
    for (const Halfedge h : loops) {
      for (const Halfedge g : loops) {
        SCOPED_TRACE(std::to_string(h.index()) + " " + std::to_string(g.index()));
        bool done = false;
        const Mesh bridged = try_operation(
            mesh, [&](const Mesh& m) { return check_bridge(m, h, g); },
            [&](Mesh& m) { return bridge(m, h, g); }, done);
        ++codes[done ? "done" : check_bridge(mesh, h, g).error().code];
        const std::size_t n = loop_of(mesh, h).size();
        const Polys polygons = bridged_polygons(mesh, h, g);
        const bool fits = n == loop_of(mesh, g).size() && is_mesh(polygons) &&
                          edges_of(polygons).size() == mesh.edge_count() + n;
        // Faces that share a vertex are refused, though some of them could be joined with a twist.
        if (done || check_bridge(mesh, h, g).error().code != "repeated-vertex") {
          EXPECT_EQ(done, fits);
        }
        if (!done) continue;
        EXPECT_EQ(in_order(polygons_of(bridged)), in_order(polygons));
        Mesh again = copy_of(mesh);
        const Halfedge s = bridge(again, h, g).value();
        EXPECT_TRUE(again.next(h) == s && again.next(s) == g);
        bool removed = false;
        const Mesh without = try_operation(
            again, [&](const Mesh& m) { return check_remove_bridge(m, s); },
            [&](Mesh& m) { return remove_bridge(m, s); }, removed);
        ASSERT_TRUE(removed);
        Polys closed = polygons_of(mesh);
        for (const Halfedge end : {h, g}) {
          if (!mesh.is_boundary(end)) continue;
          closed.push_back(corners_of(mesh, end));
          std::rotate(closed.back().begin(), closed.back().begin() + 1, closed.back().end());
        }
        EXPECT_EQ(in_order(polygons_of(without)), in_order(closed));
        ASSERT_FALSE(HasFailure());
      }
    }
  }
  EXPECT_GT(codes["done"], 100);
  EXPECT_GT(codes["edge-exists"], 5);
  EXPECT_GT(codes["repeated-vertex"], 5);
  EXPECT_GT(codes["same-loop"], 5);
  EXPECT_GT(codes["different-degrees"], 5);
}

TEST(Bridge, AddsAHandleOrJoinsComponents) {
  Mesh grid = reference_build(torus(6, 6));
  const Halfedge h = grid.face_halfedge(Face(0));
  const Halfedge g = grid.face_halfedge(Face(21));
  ASSERT_TRUE(bridge(grid, h, g).ok());
  EXPECT_EQ(genus(grid).value(), 2);
  Mesh two = reference_build(two_tori());
  ASSERT_TRUE(
      bridge(two, two.face_halfedge(Face(0)), two.face_halfedge(Face(two.face_count() - 1))).ok());
  EXPECT_EQ(connected_components(two).value().list.size(), 1U);
  EXPECT_EQ(genus(two).value(), 2);
}

TEST(Bridge, KeepsCornersAndCopiesTheFace) {
  Mesh mesh = reference_build(two_tori());
  for (const OnSplit policy : {OnSplit::kInterpolate, OnSplit::kCopy}) {
    for (const ItemKind kind : {ItemKind::kHalfedge, ItemKind::kFace}) {
      const auto column = mesh.add_attribute(kind, name_of(policy), {.on_split = policy});
      for (Index i = 0; i < mesh.slots(kind); ++i) column.value()->set(i, 0, i + 1, nullptr);
    }
  }
  const Mesh before = copy_of(mesh);
  const Halfedge h = mesh.face_halfedge(Face(2));
  const Halfedge g = mesh.face_halfedge(Face(20));
  const std::vector<Halfedge> on_h = loop_of(mesh, h);
  const std::vector<Halfedge> on_g = loop_of(mesh, g);
  std::map<Vertex, Index> corner;
  for (const auto& loop : {on_h, on_g}) {
    for (const Halfedge of : loop) corner[mesh.to_vertex(of)] = of.index() + 1;
  }
  ASSERT_TRUE(bridge(mesh, h, g).ok());
  for (const Halfedge of : on_h) {
    const Face quad = mesh.face(of);
    EXPECT_EQ(mesh.attributes().find(ItemKind::kFace, "copy")->get(quad.index(), 0), 3);
    for (const Halfedge side : mesh.face_halfedges_ccw(quad)) {
      EXPECT_EQ(mesh.attributes().find(ItemKind::kHalfedge, "interpolate")->get(side.index(), 0),
                corner[mesh.to_vertex(side)]);
    }
  }
}

TEST(Bridge, Refusals) {
  Mesh mesh = reference_build(cube());
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  const Result<Halfedge> joined = bridge(mesh, halfedge(mesh, 0, 3), halfedge(mesh, 7, 4));
  expect_refused(joined, "edge-exists", mesh, before);
  EXPECT_EQ(joined.error().witness.edges.size(), 1U);
  expect_refused(bridge(mesh, Halfedge(99), Halfedge(0)), "not-a-halfedge", mesh, before);
  const Result<Halfedge> touching =
      bridge(mesh, mesh.face_halfedge(Face(0)), mesh.face_halfedge(Face(2)));
  expect_refused(touching, "repeated-vertex", mesh, before);
}

TEST(RemoveBridge, SweepOverAllHalfedges) {
  std::map<std::string_view, int> codes;
  std::vector<std::pair<std::string, Mesh>> meshes = meshes_to_sweep(12);
  meshes.emplace_back("torus 5 x 7", reference_build(torus(5, 7)));
  for (const auto& [name, mesh] : meshes) {
    SCOPED_TRACE(name);
    for (const Halfedge s : mesh.halfedges()) {
      SCOPED_TRACE(s.index());
      bool done = false;
      const Mesh after = try_operation(
          mesh, [&](const Mesh& m) { return check_remove_bridge(m, s); },
          [&](Mesh& m) { return remove_bridge(m, s); }, done);
      ++codes[done ? "done" : check_remove_bridge(mesh, s).error().code];
      if (!done) continue;
      // The faces but for the ring, and one face along each of its sides.
      std::set<Face> ring;
      Polys ends(2);
      for (Halfedge spoke = s; ring.insert(mesh.face(spoke)).second;) {
        ends[0].push_back(mesh.from_vertex(spoke).index());
        ends[1].insert(ends[1].begin(), mesh.to_vertex(spoke).index());
        spoke = mesh.next(mesh.next(mesh.opposite(spoke)));
      }
      for (const Face f : mesh.faces()) {
        if (ring.count(f) == 0) ends.push_back(polygon_of(mesh, f));
      }
      EXPECT_EQ(polys_of(after), in_order(ends));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(codes["done"], 100);
  EXPECT_GT(codes["boundary-edge"], 100);
  EXPECT_GT(codes["not-a-quad"], 100);
}

TEST(RemoveBridge, RefusalsNameTheRing) {
  Mesh mesh = reference_build(quad_grid(3, 3));
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  const Halfedge inner = halfedge(mesh, 5, 6);
  const Result<Halfedge> open = remove_bridge(mesh, inner);
  expect_refused(open, "boundary-edge", mesh, before);
  EXPECT_EQ(open.error().witness.edges.size(), 1U);
  EXPECT_TRUE(mesh.is_boundary(Edge(open.error().witness.edges[0])));
  expect_refused(remove_bridge(mesh, Halfedge{}), "not-a-halfedge", mesh, before);

  Mesh solid = reference_build(tetrahedron());
  const Snapshot solid_before(solid);
  const Result<Halfedge> triangles = remove_bridge(solid, Halfedge(0));
  expect_refused(triangles, "not-a-quad", solid, solid_before);
  EXPECT_EQ(triangles.error().witness.faces, std::vector<Index>{solid.face(Halfedge(0)).index()});

  Mesh two = reference_build({"", 4, {{0, 1, 2, 3}, {3, 2, 1, 0}}});
  const Snapshot two_before(two);
  const Result<Halfedge> ring = remove_bridge(two, Halfedge(0));
  expect_refused(ring, "degree-below-three", two, two_before);
  EXPECT_EQ(ring.error().witness.faces.size(), 2U);

  // A closed strip of quads that passes its own vertices again: a torus of four by three, sheared,
  // has one ring of twelve quads.
  Polys faces;
  for (Index i = 0; i < 13; ++i) {
    faces.push_back({i, (i + 1) % 13, (i + 6) % 13, (i + 5) % 13});
  }
  Mesh sheared = reference_build({"", 13, faces});
  expect_valid_mesh(sheared);
  const Snapshot sheared_before(sheared);
  const Result<Halfedge> meets = remove_bridge(sheared, Halfedge(0));
  expect_refused(meets, "repeated-vertex", sheared, sheared_before);
  EXPECT_EQ(meets.error().witness.vertices.size(), 1U);
}

// ---- reverse -----------------------------------------------------------------------------------

// For each corner, by its face and vertex: the values that belong to it.
std::map<std::pair<Index, Index>, std::vector<double>> corner_values(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, std::vector<double>> all;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) continue;
    std::vector<double>& values = all[{mesh.face(h).index(), mesh.to_vertex(h).index()}];
    for (const auto& column : mesh.attributes().of(ItemKind::kHalfedge)) {
      if (!column->belongs_to_corners()) continue;
      for (Index i = 0; i < column->components(); ++i) {
        values.push_back(column->get(h.index(), i));
      }
    }
  }
  return all;
}

Polys reversed(Polys polygons) {
  for (std::vector<Index>& polygon : polygons) std::reverse(polygon.begin(), polygon.end());
  return in_order(polygons);
}

TEST(Reverse, TurnsAllPolygonsAroundAndBack) {
  for (const auto& [name, mesh] : meshes_to_sweep(12)) {
    SCOPED_TRACE(name);
    bool done = false;
    Mesh turned = try_operation(
        mesh, [](const Mesh&) { return Result<void>(); },
        [](Mesh& m) { return operations::reverse(m); }, done);
    ASSERT_TRUE(done);
    EXPECT_EQ(in_order(polygons_of(turned)), reversed(polygons_of(mesh)));
    EXPECT_EQ(corner_values(turned), corner_values(mesh));
    for (const Halfedge h : mesh.halfedges()) {
      EXPECT_EQ(turned.face(h), mesh.face(h));
      // What doesn't belong to corners stays with the halfedge.
      for (const auto& column : mesh.attributes().of(ItemKind::kHalfedge)) {
        if (column->belongs_to_corners()) continue;
        EXPECT_EQ(turned.attributes().find(ItemKind::kHalfedge, column->name())->get(h.index(), 0),
                  column->get(h.index(), 0));
      }
    }
    ASSERT_TRUE(operations::reverse(turned).ok());
    EXPECT_TRUE(Snapshot(turned) == Snapshot(mesh));
  }
}

TEST(ReverseComponent, LeavesTheOthersAlone) {
  for (const auto& [name, mesh] : meshes_to_sweep(12)) {
    if (mesh.edge_count() == 0) continue;
    SCOPED_TRACE(name);
    const Result<Components> components = connected_components(mesh);
    ASSERT_TRUE(components);
    for (const Halfedge h : loops_of(mesh, 4)) {
      bool done = false;
      Mesh turned = try_operation(
          mesh, [&](const Mesh& m) { return check_reverse_component(m, h); },
          [&](Mesh& m) { return reverse_component(m, h); }, done);
      ASSERT_TRUE(done);
      const Index component = components.value().of_vertex[mesh.to_vertex(h).index()];
      Polys expected;
      for (const Face f : mesh.faces()) {
        std::vector<Index> polygon = polygon_of(mesh, f);
        if (components.value().of_face[f.index()] == component) {
          std::reverse(polygon.begin(), polygon.end());
        }
        expected.push_back(polygon);
      }
      EXPECT_EQ(in_order(polygons_of(turned)), in_order(expected));
      EXPECT_EQ(corner_values(turned), corner_values(mesh));
      EXPECT_EQ(reverse_component(turned, h).value(), components.value().list[component].edges);
      EXPECT_TRUE(Snapshot(turned) == Snapshot(mesh));
      ASSERT_FALSE(HasFailure());
    }
  }
  Mesh mesh = reference_build(cube());
  const Snapshot before(mesh);
  expect_refused(reverse_component(mesh, Halfedge(99)), "not-a-halfedge", mesh, before);
}

TEST(LoopsAndOrientation, WithoutPrev) {
  const auto apply = [](auto& m) {
    const auto at = [&](Index from, Index to) { return m.find_halfedge(Vertex(from), Vertex(to)); };
    const std::array<Halfedge, 3> cycle = {at(0, 6), at(6, 12), at(12, 18)};
    const std::array<Halfedge, 6> around = {cycle[0],   cycle[1],   cycle[2],
                                            at(18, 24), at(24, 30), at(30, 0)};
    const Halfedge g = split_loop(m, around).value();
    EXPECT_FALSE(has_errors(validate(m)));
    EXPECT_TRUE(join_loop(m, around[0], g).ok());
    EXPECT_FALSE(has_errors(validate(m)));
    const Halfedge s = bridge(m, m.face_halfedge(Face(0)), m.face_halfedge(Face(21))).value();
    EXPECT_FALSE(has_errors(validate(m)));
    EXPECT_TRUE(operations::reverse(m).ok());
    EXPECT_FALSE(has_errors(validate(m)));
    EXPECT_EQ(reverse_component(m, s).value(), m.edge_count());
    EXPECT_TRUE(remove_bridge(m, s).ok());
    EXPECT_FALSE(has_errors(validate(m)));
  };
  expect_same_without_prev(torus(6, 6), apply);
}

}  // namespace
}  // namespace halfedge::test
