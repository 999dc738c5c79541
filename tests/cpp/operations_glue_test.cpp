// Gluing boundary edges, and cutting edges open.

#include <gtest/gtest.h>
#include <halfedge/operations/cut.h>
#include <halfedge/operations/glue.h>

#include <array>
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

std::vector<Halfedge> boundary_of(const Mesh& mesh) {
  std::vector<Halfedge> all;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) all.push_back(h);
  }
  return all;
}

// The polygons after the ends of h and g became one: a mesh, with one edge less than before?
bool can_be_glued(const Mesh& mesh, Halfedge h, Halfedge g, Polys& glued) {
  std::map<Index, Index> kept;
  kept[mesh.from_vertex(g).index()] = mesh.to_vertex(h).index();
  kept[mesh.to_vertex(g).index()] = mesh.from_vertex(h).index();
  if (mesh.from_vertex(h) == mesh.from_vertex(g) || mesh.to_vertex(h) == mesh.to_vertex(g)) {
    return false;
  }
  glued = polygons_of(mesh);
  for (std::vector<Index>& polygon : glued) {
    for (Index& v : polygon) {
      if (kept.count(v) > 0) v = kept[v];
    }
  }
  return edges_of(glued).size() + 1 == mesh.edge_count() && is_mesh(glued);
}

TEST(Glue, SweepOverAllPairs) {
  std::map<std::string_view, int> codes;
  for (const auto& [name, mesh] : meshes_to_sweep(12)) {
    SCOPED_TRACE(name);
    std::vector<Halfedge> boundary = boundary_of(mesh);
    if (boundary.size() > 24) boundary.resize(24);
    for (const Halfedge h : boundary) {
      for (const Halfedge g : boundary) {
        SCOPED_TRACE(std::to_string(h.index()) + " " + std::to_string(g.index()));
        Polys expected;
        const bool can = can_be_glued(mesh, h, g, expected);
        const Result<void> check = check_glue(mesh, h, g);
        ++codes[check.ok() ? "done" : check.error().code];
        ASSERT_EQ(check.ok(), can) << (check.ok() ? "" : check.error().message);
        if (can && codes["done"] > 300 && h.index() % 5 != 0) continue;
        bool done = false;
        const Mesh glued = try_operation(
            mesh, [&](const Mesh& m) { return check_glue(m, h, g); },
            [&](Mesh& m) { return glue(m, h, g); }, done);
        if (!done) continue;
        EXPECT_EQ(in_order(polygons_of(glued)), in_order(expected));
        ASSERT_FALSE(HasFailure());
      }
    }
  }
}

TEST(Cut, SweepOverAllHalfedges) {
  std::map<std::string_view, int> codes;
  for (const auto& [name, mesh] : meshes_to_sweep(12)) {
    SCOPED_TRACE(name);
    for (const Halfedge h : mesh.halfedges()) {
      SCOPED_TRACE(h.index());
      if (mesh.edge_count() > 80 && h.index() % 7 != 0) continue;
      bool done = false;
      Mesh cut_open = try_operation(
          mesh, [&](const Mesh& m) { return check_cut(m, h); }, [&](Mesh& m) { return cut(m, h); },
          done);
      const Result<void> check = check_cut(mesh, h);
      ++codes[check.ok() ? "done" : check.error().code];
      const bool is_inside = !mesh.is_boundary(mesh.edge(h));
      EXPECT_EQ(done, is_inside && (mesh.is_boundary(mesh.from_vertex(h)) ||
                                    mesh.is_boundary(mesh.to_vertex(h))));
      if (!done) continue;
      const Index split = (mesh.is_boundary(mesh.from_vertex(h)) ? 1U : 0U) +
                          (mesh.is_boundary(mesh.to_vertex(h)) ? 1U : 0U);
      EXPECT_EQ(cut_open.vertex_count(), mesh.vertex_count() + split);
      EXPECT_EQ(cut_open.edge_count(), mesh.edge_count() + 1);
      EXPECT_EQ(cut_open.face_count(), mesh.face_count());
      // The new vertices where the old ones were, these are the old polygons.
      EXPECT_EQ(cut_open.face(h), mesh.face(h));
      Mesh again = copy_of(mesh);
      const Halfedge g = cut(again, h).value();
      EXPECT_TRUE(again.is_boundary(g) && again.is_boundary(Mesh::opposite(h)));
      ASSERT_TRUE(glue(again, Mesh::opposite(h), g).ok());
      expect_valid_mesh(again);
      EXPECT_EQ(in_order(polygons_of(again)), in_order(polygons_of(mesh)));
      ASSERT_FALSE(HasFailure());
    }
  }
}

Halfedge halfedge(const Mesh& mesh, Index from, Index to) {
  const Halfedge h = mesh.find_halfedge(Vertex(from), Vertex(to));
  EXPECT_TRUE(h.valid()) << from << " -> " << to;
  return h;
}

Polys polygons_with(const Mesh& mesh, const std::map<Index, Index>& renamed) {
  Polys all = polygons_of(mesh);
  for (std::vector<Index>& polygon : all) {
    for (Index& v : polygon) v = renamed.count(v) > 0 ? renamed.at(v) : v;
  }
  return all;
}

//     2 --- 3     7
//     |     |   / |
//     |     |  6  |
//     0 --- 1   \ |        a quad and a triangle apart
//                 5
Shape quad_and_triangle() { return {"quad and triangle", 8, {{0, 1, 3, 2}, {6, 5, 7}}}; }

TEST(Glue, JoinsTwoComponentsAlongAnEdge) {
  Mesh mesh = reference_build(quad_and_triangle());
  add_attributes_of_all_kinds(mesh);
  const Mesh before = copy_of(mesh);
  const Halfedge h = halfedge(mesh, 3, 1);  // the boundary runs against the faces
  const Halfedge g = halfedge(mesh, 6, 7);
  EXPECT_EQ(glue(mesh, h, g).value(), mesh.edge(h));
  expect_valid_mesh(mesh);
  EXPECT_EQ(in_order(polygons_of(mesh)), in_order({{0, 1, 3, 2}, {1, 5, 3}}));
  EXPECT_TRUE(mesh.is_deleted(Vertex(6)) && mesh.is_deleted(Vertex(7)));
  EXPECT_TRUE(mesh.is_deleted(mesh.edge(g)));
  EXPECT_EQ(mesh.position(Vertex(1)), before.position(Vertex(1)));
  EXPECT_EQ(mesh.position(Vertex(3)), before.position(Vertex(3)));
  // The corner where h ends now is that of the triangle; all that stays has its values.
  for (const ItemKind kind : {ItemKind::kVertex, ItemKind::kEdge, ItemKind::kHalfedge}) {
    for (const auto& column : mesh.attributes().of(kind)) {
      const Attribute& old = *before.attributes().find(kind, column->name());
      if (kind == ItemKind::kVertex) {
        EXPECT_EQ(column->get(1, 0), old.get(1, 0));
      } else if (kind == ItemKind::kEdge) {
        EXPECT_EQ(column->get(mesh.edge(h).index(), 0), old.get(mesh.edge(h).index(), 0));
      } else {
        const Halfedge from = column->belongs_to_corners() ? Mesh::opposite(g) : h;
        EXPECT_EQ(column->get(h.index(), 0), old.get(from.index(), 0));
        EXPECT_EQ(column->get(Mesh::opposite(h).index(), 0), old.get(Mesh::opposite(h).index(), 0));
      }
    }
  }
}

TEST(Glue, RefusalsNameTheItems) {
  Mesh mesh = reference_build(quad_and_triangle());
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  const Halfedge h = halfedge(mesh, 3, 1);
  expect_refused(glue(mesh, Halfedge(99), h), "not-a-halfedge", mesh, before);
  expect_refused(glue(mesh, h, Halfedge{}), "not-a-halfedge", mesh, before);
  const Result<Edge> inner = glue(mesh, h, Mesh::opposite(h));
  expect_refused(inner, "not-a-boundary-halfedge", mesh, before);
  EXPECT_EQ(inner.error().witness.halfedges, std::vector<Index>{Mesh::opposite(h).index()});
  expect_refused(glue(mesh, h, h), "repeated-vertex", mesh, before);
  // Neighbours on one face: 1 would become 0.
  const Result<Edge> neighbours = glue(mesh, h, halfedge(mesh, 2, 3));
  ASSERT_FALSE(neighbours.ok());
  EXPECT_TRUE(Snapshot(mesh) == before);
  // Opposite sides of the quad: 0 and 1, which are joined, would be one vertex.
  const Result<Edge> sides = glue(mesh, h, halfedge(mesh, 0, 2));
  expect_refused(sides, "edge-exists", mesh, before);
  EXPECT_EQ(sides.error().witness.edges.size(), 1U);
  const Halfedge joining = mesh.edge_halfedge(Edge(sides.error().witness.edges[0]));
  EXPECT_EQ((std::set<Index>{mesh.from_vertex(joining).index(), mesh.to_vertex(joining).index()}),
            (std::set<Index>(sides.error().witness.vertices.begin(),
                             sides.error().witness.vertices.end())));
}

TEST(Glue, RefusesASecondEdgeBetweenTwoVertices) {
  // Two triangles: 1 and 3 would become one vertex, and both are joined to 2.
  Mesh mesh = reference_build({"", 4, {{0, 1, 2}, {0, 2, 3}}});
  const Snapshot before(mesh);
  const Result<Edge> refused = glue(mesh, halfedge(mesh, 1, 0), halfedge(mesh, 0, 3));
  expect_refused(refused, "duplicate-edge", mesh, before);
  EXPECT_EQ(refused.error().witness.vertices, (std::vector<Index>{1, 2}));
  EXPECT_EQ(
      (std::set<Index>(refused.error().witness.edges.begin(), refused.error().witness.edges.end())),
      (std::set<Index>{mesh.find_edge(Vertex(1), Vertex(2)).index(),
                       mesh.find_edge(Vertex(3), Vertex(2)).index()}));
}

TEST(Glue, RefusesAFaceWithAVertexTwice) {
  // An octagon: its sides 0-1 and 4-5, glued, would give it two vertices twice.
  Mesh mesh = reference_build({"", 8, {{0, 1, 2, 3, 4, 5, 6, 7}}});
  const Snapshot before(mesh);
  const Result<Edge> refused = glue(mesh, halfedge(mesh, 1, 0), halfedge(mesh, 5, 4));
  expect_refused(refused, "repeated-vertex", mesh, before);
  EXPECT_EQ(refused.error().witness.faces, std::vector<Index>{0});
  EXPECT_EQ(refused.error().witness.vertices.size(), 2U);
}

TEST(Glue, ClosesAConeButNotBesideOtherFaces) {
  // Four triangles around 0, not closed; with or without another triangle at 0.
  for (const bool beside : {false, true}) {
    Polys faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    if (beside) faces.push_back({0, 6, 7});
    Mesh mesh = reference_build({"", 8, faces});
    const Snapshot before(mesh);
    const Halfedge h = halfedge(mesh, 1, 0);
    const Halfedge g = halfedge(mesh, 0, 5);
    const Result<Edge> glued = glue(mesh, h, g);
    if (!beside) {
      ASSERT_TRUE(glued.ok());
      EXPECT_FALSE(mesh.is_boundary(Vertex(0)));
      EXPECT_EQ(mesh.valence(Vertex(0)), 4U);
      expect_valid_mesh(mesh);
    } else {
      expect_refused(glued, "pinched-vertex", mesh, before);
      EXPECT_EQ(glued.error().witness.vertices, std::vector<Index>{0});
      EXPECT_EQ(glued.error().witness.halfedges, (std::vector<Index>{h.index(), g.index()}));
    }
  }
}

TEST(Glue, JoinsFansOfAPinchedVertexInAnyOrder) {
  // Five fans at 0: any two become one, the others stay beside it.
  const Mesh mesh = reference_build(pinched(5));
  for (Index i = 0; i < 5; ++i) {
    for (Index j = 0; j < 5; ++j) {
      Mesh glued = copy_of(mesh);
      const Result<Edge> edge =
          glue(glued, halfedge(mesh, 1 + 2 * i, 0), halfedge(mesh, 0, 2 + 2 * j));
      EXPECT_EQ(edge.ok(), i != j);
      if (!edge.ok()) continue;
      expect_valid_mesh(glued);
      EXPECT_EQ(glued.valence(Vertex(0)), 9U);
      EXPECT_EQ(in_order(polygons_of(glued)),
                in_order(polygons_with(mesh, {{2 + 2 * j, 1 + 2 * i}})));
    }
  }
}

// ---- paths -------------------------------------------------------------------------------------

std::vector<Halfedge> path_of(const Mesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Halfedge> path;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    path.push_back(halfedge(mesh, vertices[i], vertices[i + 1]));
  }
  return path;
}

TEST(CutPath, MakesASlitInsideAndGlueClosesIt) {
  // A grid of 5 by 5 vertices; the path 6-7-8-13 inside.
  Mesh mesh = reference_build(quad_grid(4, 4));
  add_attributes_of_all_kinds(mesh);
  const Mesh before = copy_of(mesh);
  const std::vector<Halfedge> path = path_of(mesh, {6, 7, 8, 13});
  const Halfedge g = cut_path(mesh, path).value();
  expect_valid_mesh(mesh);
  EXPECT_EQ(mesh.vertex_count(), 27U);  // 7 and 8 twice
  EXPECT_EQ(mesh.edge_count(), before.edge_count() + 3);
  Index length = 0;
  for ([[maybe_unused]] const Halfedge on_slit : mesh.loop_ccw(g)) ++length;
  EXPECT_EQ(length, 6U);
  // What is on the left keeps its vertices, copies lie where they did.
  for (const Halfedge h : path) {
    EXPECT_EQ(mesh.face(h), before.face(h));
    EXPECT_EQ(mesh.to_vertex(h), before.to_vertex(h));
    EXPECT_TRUE(mesh.is_boundary(Mesh::opposite(h)));
    EXPECT_EQ(polygon_of(mesh, mesh.face(h)), polygon_of(before, mesh.face(h)));
  }
  const std::map<Index, Index> copies = {{25, 7}, {26, 8}};
  EXPECT_EQ(in_order(polygons_with(mesh, copies)), in_order(polygons_of(before)));
  for (const auto& [copy, original] : copies) {
    EXPECT_EQ(mesh.position(Vertex(copy)), mesh.position(Vertex(original)));
    for (const auto& column : mesh.attributes().of(ItemKind::kVertex)) {
      if (column->on_split() != OnSplit::kDefault) {
        EXPECT_EQ(column->get(copy, 0), column->get(original, 0));
      }
    }
  }
  // Alone, none of the edges could be glued; together they can.
  const Halfedge h = Mesh::opposite(path.back());
  EXPECT_EQ(check_glue(mesh, Mesh::opposite(path[1]), mesh.prev(g)).error().code, "duplicate-edge");
  EXPECT_EQ(glue_path(mesh, h, g, 3).value(), mesh.edge(h));
  expect_valid_mesh(mesh);
  EXPECT_EQ(polygons_of(mesh), polygons_of(before));
  EXPECT_EQ(LiveItems(mesh).vertices, LiveItems(before).vertices);
}

TEST(CutPath, FromBoundaryToBoundaryDivides) {
  Mesh mesh = reference_build(quad_grid(4, 4));
  const Halfedge g = cut_path(mesh, path_of(mesh, {2, 7, 12, 17, 22})).value();
  expect_valid_mesh(mesh);
  EXPECT_EQ(mesh.vertex_count(), 30U);
  const Counts counts(mesh);
  EXPECT_EQ(counts.components, 2);
  EXPECT_TRUE(mesh.is_boundary(g));
}

TEST(CutPath, AClosedPathCutsAHandle) {
  Mesh mesh = reference_build(torus(4, 3));
  const std::vector<Halfedge> around = path_of(mesh, {0, 1, 2, 3, 0});
  ASSERT_TRUE(cut_path(mesh, around).ok());
  expect_valid_mesh(mesh);
  EXPECT_EQ(mesh.vertex_count(), 16U);
  EXPECT_EQ(mesh.edge_count(), 28U);
  EXPECT_EQ(Counts(mesh).genus(), 0);
}

TEST(CutPath, RandomPathsKeepTheMeshValid) {
  int cut = 0;
  for (const auto& [name, mesh] : meshes_to_sweep(20)) {
    SCOPED_TRACE(name);
    if (mesh.edge_count() == 0) continue;
    std::mt19937 random(7);
    std::vector<Halfedge> all;
    for (const Halfedge h : mesh.halfedges()) all.push_back(h);
    for (int tries = 0; tries < 20; ++tries) {
      std::vector<Halfedge> path = {all[random() % all.size()]};
      for (std::size_t more = random() % 6; more > 0; --more) {
        std::vector<Halfedge> choices;
        for (const Halfedge h : mesh.outgoing_cw(mesh.to_vertex(path.back()))) choices.push_back(h);
        path.push_back(choices[random() % choices.size()]);
      }
      bool done = false;
      const Mesh after = try_operation(
          mesh, [&](const Mesh& m) { return check_cut_path(m, path); },
          [&](Mesh& m) { return cut_path(m, path); }, done);
      std::set<Edge> edges;
      bool is_inside = true;
      for (const Halfedge h : path) {
        edges.insert(mesh.edge(h));
        is_inside = is_inside && !mesh.is_boundary(mesh.edge(h));
      }
      const bool has_end =
          mesh.is_boundary(mesh.from_vertex(path[0])) || mesh.is_boundary(mesh.to_vertex(path[0]));
      EXPECT_EQ(done, is_inside && edges.size() == path.size() && (path.size() > 1 || has_end));
      cut += done ? 1 : 0;
      EXPECT_EQ(after.edge_count(), mesh.edge_count() + (done ? path.size() : 0));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(cut, 100);
}

TEST(CutPath, Refusals) {
  Mesh mesh = reference_build(quad_grid(4, 4));
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  expect_refused(cut_path(mesh, {}), "not-a-path", mesh, before);
  std::vector<Halfedge> path = path_of(mesh, {6, 7, 8});
  path.push_back(halfedge(mesh, 12, 13));
  const Result<Halfedge> jump = cut_path(mesh, path);
  expect_refused(jump, "not-a-path", mesh, before);
  EXPECT_EQ(jump.error().witness.halfedges, (std::vector<Index>{path[1].index(), path[2].index()}));
  path[2] = Mesh::opposite(path[1]);
  const Result<Halfedge> back = cut_path(mesh, path);
  expect_refused(back, "not-a-path", mesh, before);
  EXPECT_EQ(back.error().witness.edges, std::vector<Index>{mesh.edge(path[1]).index()});
  path = path_of(mesh, {12, 13, 18, 17, 12, 13});  // an edge again, later
  const Result<Halfedge> around = cut_path(mesh, path);
  expect_refused(around, "not-a-path", mesh, before);
  EXPECT_EQ(around.error().witness.edges, std::vector<Index>{mesh.edge(path[0]).index()});
  path = path_of(mesh, {1, 2, 7});
  const Result<Halfedge> boundary = cut_path(mesh, path);
  expect_refused(boundary, "boundary-edge", mesh, before);
  EXPECT_EQ(boundary.error().witness.edges, std::vector<Index>{mesh.edge(path[0]).index()});
  path = {halfedge(mesh, 6, 7)};
  const Result<Halfedge> inside = cut_path(mesh, path);
  expect_refused(inside, "no-boundary-end", mesh, before);
  EXPECT_EQ(inside.error().witness.vertices, (std::vector<Index>{6, 7}));
  EXPECT_EQ(inside.error().witness.edges, std::vector<Index>{mesh.edge(path[0]).index()});
  expect_refused(cut(mesh, path[0]), "no-boundary-end", mesh, before);
  expect_refused(cut(mesh, Halfedge(999)), "not-a-halfedge", mesh, before);
  path.push_back(Halfedge{});
  expect_refused(cut_path(mesh, path), "not-a-halfedge", mesh, before);
}

TEST(GluePath, Refusals) {
  Mesh mesh = reference_build(annulus(5));
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  const Halfedge h = halfedge(mesh, 0, 1);
  const Halfedge g = halfedge(mesh, 6, 5);
  ASSERT_TRUE(mesh.is_boundary(h) && mesh.is_boundary(g));
  expect_refused(glue_path(mesh, h, g, 0), "not-a-path", mesh, before);
  expect_refused(glue_path(mesh, h, g, 5), "repeated-vertex", mesh, before);  // a whole loop
  expect_refused(glue_path(mesh, h, g, 1'000'000), "repeated-vertex", mesh, before);
  expect_refused(glue_path(mesh, h, mesh.next(h), 2), "repeated-vertex", mesh, before);
  expect_refused(glue_path(mesh, Mesh::opposite(h), g, 2), "not-a-boundary-halfedge", mesh, before);
  expect_refused(glue_path(mesh, h, Halfedge{}, 2), "not-a-halfedge", mesh, before);
}

// A vertex can't become two, nor two others one, though no edge or face would tell.
TEST(GluePath, RefusesAVertexTwiceOnAPath) {
  const auto refuse = [](const Shape& shape, const std::array<Index, 2>& h,
                         const std::array<Index, 2>& g, std::size_t n, Index repeated) {
    Mesh mesh = reference_build(shape);
    add_attributes_of_all_kinds(mesh);
    const Snapshot before(mesh);
    const Result<Edge> refused =
        glue_path(mesh, halfedge(mesh, h[0], h[1]), halfedge(mesh, g[0], g[1]), n);
    expect_refused(refused, "repeated-vertex", mesh, before);
    if (refused.ok()) return;
    EXPECT_EQ(refused.error().witness.vertices, std::vector<Index>{repeated});
    EXPECT_TRUE(refused.error().witness.faces.empty());
  };
  // A strip of five quads, vertices 0 to 5 below; and two triangles that share vertex 12, around
  // which one boundary loop leads: 12 14 13 12 16 15.
  std::vector<std::vector<Index>> faces = quad_grid(5, 1).faces;
  faces.insert(faces.end(), {{12, 13, 14}, {12, 15, 16}});
  const Shape strip_and_pinch("strip and pinched vertex", 17, faces);
  const Mesh mesh = reference_build(strip_and_pinch);
  const Halfedge after_pinch = mesh.next(halfedge(mesh, 13, 12));
  ASSERT_EQ(after_pinch, halfedge(mesh, 12, 16));
  refuse(strip_and_pinch, {14, 13}, {5, 4}, 5, 12);
  refuse(strip_and_pinch, {5, 4}, {14, 13}, 5, 12);
  // Around a disk both ways, further than half.
  refuse(disk(7), {2, 1}, {4, 3}, 4, 7);
}

TEST(GluePath, SweepAgreesWithPolygons) {
  int done_count = 0;
  for (const auto& [name, mesh] : meshes_to_sweep(10)) {
    SCOPED_TRACE(name);
    const std::vector<Halfedge> boundary = boundary_of(mesh);
    for (std::size_t i = 0; i < boundary.size(); i += 1 + boundary.size() / 12) {
      for (std::size_t j = 0; j < boundary.size(); j += 1 + boundary.size() / 12) {
        for (const std::size_t n : {2U, 3U}) {
          bool done = false;
          const Mesh after = try_operation(
              mesh, [&](const Mesh& m) { return check_glue_path(m, boundary[i], boundary[j], n); },
              [&](Mesh& m) { return glue_path(m, boundary[i], boundary[j], n); }, done);
          ASSERT_FALSE(HasFailure()) << boundary[i].index() << " " << boundary[j].index();
          if (!done) continue;
          ++done_count;
          EXPECT_EQ(after.edge_count() + n, mesh.edge_count());
          std::map<Index, Index> kept;
          Halfedge h = boundary[i];
          Halfedge g = boundary[j];
          for (std::size_t k = 0; k < n; ++k, h = mesh.next(h), g = mesh.prev(g)) {
            kept[mesh.from_vertex(g).index()] = mesh.to_vertex(h).index();
            kept[mesh.to_vertex(g).index()] = mesh.from_vertex(h).index();
          }
          EXPECT_EQ(in_order(polygons_of(after)), in_order(polygons_with(mesh, kept)));
        }
      }
    }
  }
  EXPECT_GT(done_count, 200);
}

TEST(GlueAndCut, WithoutPrev) {
  const auto apply = [](auto& m) {
    const auto at = [&](Index from, Index to) { return m.find_halfedge(Vertex(from), Vertex(to)); };
    const std::array<Halfedge, 3> path = {at(6, 7), at(7, 8), at(8, 13)};
    const Halfedge g = cut_path(m, path).value();
    EXPECT_FALSE(has_errors(validate(m)));
    EXPECT_TRUE(glue_path(m, m.opposite(path[2]), g, 3).ok());
    EXPECT_FALSE(has_errors(validate(m)));
    const Halfedge cut_off = cut(m, at(2, 7)).value();
    EXPECT_FALSE(has_errors(validate(m)));
    EXPECT_TRUE(glue(m, m.next(cut_off), cut_off).ok());
    EXPECT_FALSE(has_errors(validate(m)));
  };
  expect_same_without_prev(quad_grid(4, 4), apply);
}

}  // namespace
}  // namespace halfedge::test
