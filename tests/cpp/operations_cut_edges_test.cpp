// Cutting along sets of edges, compared with fans told apart corner by corner.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/operations/cut.h>
#include <halfedge/operations/deletion.h>
#include <halfedge/operations/glue.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/cut_open.h"
#include "support/edge_sets.h"
#include "support/polygon_lists.h"
#include "support/same_but_prev.h"

namespace halfedge::test {
namespace {

using namespace operations;

std::vector<std::pair<std::string, Mesh>> meshes_to_cut(Index random_ones) {
  std::vector<std::pair<std::string, Mesh>> meshes = meshes_to_sweep(random_ones);
  meshes.emplace_back("torus of 8 by 8", reference_build(torus(8, 8)));
  meshes.emplace_back("genus two", genus_two());
  // Fans of several faces at one vertex, with free slots between the live ones.
  Mesh fans = reference_build(triangle_grid(4, 4));
  for (const Index f : {13U, 19U, 3U}) EXPECT_TRUE(delete_face(fans, Face(f)).ok());
  meshes.emplace_back("grid with holes that meet", std::move(fans));
  for (std::size_t i = meshes.size() - 3; i < meshes.size(); ++i) {
    add_attributes_of_all_kinds(meshes[i].second);
  }
  return meshes;
}

std::vector<Halfedge> cut_all(Mesh& mesh, const std::vector<Edge>& edges) {
  const Array<Halfedge> copies = cut_edges(mesh, edges).value();
  return {copies.begin(), copies.end()};
}

TEST(CutEdges, MakesAVertexOfEachFanAndSharesWhatIsNotCut) {
  std::map<std::string_view, int> codes;
  int pinched_cuts = 0;
  for (const auto& [name, mesh] : meshes_to_cut(24)) {
    for (std::uint32_t seed = 0; seed < 16; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const std::vector<Edge> edges = draw_edges(mesh, random);
      const std::string_view code = expected_code(mesh, edges);
      ++codes[code];
      std::vector<Halfedge> copies;
      bool done = false;
      const Mesh after = try_operation(
          mesh,
          [&](const Mesh& m) {
            Result<void> can = check_cut_edges(m, edges);
            EXPECT_EQ(can ? "done" : can.error().code, code);
            return can;
          },
          [&](Mesh& m) {
            Result<Array<Halfedge>> result = cut_edges(m, edges);
            if (result) copies.assign(result.value().begin(), result.value().end());
            return result;
          },
          done);
      ASSERT_EQ(done, code == "done");
      if (!done) continue;
      const std::set<Edge> cut(edges.begin(), edges.end());
      const Origins origins = expect_is_cut(mesh, after, cut);
      expect_copies(mesh, after, origins, edges, copies);
      for (const Edge e : edges) {
        if (!mesh.is_manifold(mesh.to_vertex(mesh.edge_halfedge(e)))) ++pinched_cuts;
      }
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(codes["done"], 300);
  EXPECT_GT(codes["no-boundary-end"], 20);
  EXPECT_GT(codes["repeated-edge"], 2);
  EXPECT_GT(codes["boundary-edge"], 0);
  EXPECT_GT(codes["not-an-edge"], 0);
  EXPECT_GT(pinched_cuts, 20);
}

TEST(CutEdges, TheOrderOfTheListDoesNotMatter) {
  for (const auto& [name, mesh] : meshes_to_cut(20)) {
    for (std::uint32_t seed = 100; seed < 106; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      std::vector<Edge> edges = draw_edges(mesh, random);
      if (expected_code(mesh, edges) != "done") continue;
      Mesh first = copy_of(mesh);
      const std::vector<Halfedge> copies = cut_all(first, edges);
      std::map<Edge, Halfedge> copy_of_edge;
      for (std::size_t i = 0; i < edges.size(); ++i) copy_of_edge[edges[i]] = copies[i];
      for (int again = 0; again < 3; ++again) {
        std::shuffle(edges.begin(), edges.end(), random);
        Mesh other = copy_of(mesh);
        const std::vector<Halfedge> others = cut_all(other, edges);
        ASSERT_TRUE(Snapshot(other) == Snapshot(first));
        for (std::size_t i = 0; i < edges.size(); ++i) EXPECT_EQ(others[i], copy_of_edge[edges[i]]);
      }
    }
  }
}

// The steps of which it consists, one edge at a time, from either side and in any order, come to
// the same faces and fans: cut_edges takes one of these orders.
TEST(CutEdges, EdgesOneByOneInAnyOrderAndDirection) {
  int done = 0;
  for (const auto& [name, mesh] : meshes_to_cut(20)) {
    for (std::uint32_t seed = 200; seed < 212; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const std::vector<Edge> edges = draw_edges(mesh, random);
      if (expected_code(mesh, edges) != "done") continue;
      Mesh after = copy_of(mesh);
      ASSERT_TRUE(steps::make_room(after, 2 * Index(edges.size()), Index(edges.size()), 0));
      for (const Edge e : edges) {
        (void)operations::internal::cut_edge(after, mesh.edge_halfedge(e, Index(random() % 2)));
      }
      expect_valid_mesh(after);
      (void)expect_is_cut(mesh, after, {edges.begin(), edges.end()});
      ASSERT_FALSE(HasFailure());
      ++done;
    }
  }
  EXPECT_GT(done, 150);
}

TEST(CutEdges, WithoutPrev) {
  for (const auto& [name, mesh] : meshes_to_cut(10)) {
    for (std::uint32_t seed = 300; seed < 306; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const std::vector<Edge> edges = draw_edges(mesh, random);
      Mesh after = copy_of(mesh);
      BasicMesh<kWithoutPrev> light;
      ASSERT_TRUE(convert(copy_of(mesh), light));
      ASSERT_TRUE(light.enable_history());
      const Snapshot before(light);
      const Result<void> can = check_cut_edges(light, edges);
      const Result<Array<Halfedge>> copies = cut_edges(light, edges);
      const Result<Array<Halfedge>> expected = cut_edges(after, edges);
      ASSERT_EQ(copies.ok(), expected.ok());
      ASSERT_EQ(can.ok(), expected.ok());
      if (!expected.ok()) {
        EXPECT_EQ(copies.error().message, expected.error().message);
        EXPECT_EQ(can.error().message, expected.error().message);
        EXPECT_TRUE(Snapshot(light) == before);
        continue;
      }
      EXPECT_TRUE(same(copies.value(), expected.value()));
      expect_same_but_prev(after, light);
      EXPECT_FALSE(has_errors(validate(light)));
      light.end_step();
      EXPECT_EQ(light.undo(), !edges.empty());
      EXPECT_TRUE(Snapshot(light) == before);
      ASSERT_FALSE(HasFailure());
    }
  }
}

// Of complexes with loops, several edges between two vertices, and faces on both sides of an edge.
TEST(CutEdges, DegenerateComplexesStayValid) {
  int done = 0;
  for (const auto& [name, mesh] : all_complexes()) {
    for (std::uint32_t seed = 400; seed < 410; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const std::vector<Edge> edges = draw_edges(mesh, random);
      const std::string_view code = expected_code(mesh, edges);
      Mesh after = copy_of(mesh);
      const Result<Array<Halfedge>> copies = cut_edges(after, edges);
      if (code != "done") {
        expect_refused(copies, code, after, Snapshot(mesh));
        continue;
      }
      ASSERT_TRUE(copies.ok()) << copies.error().message;
      expect_valid_complex(after);
      (void)expect_is_cut(mesh, after, {edges.begin(), edges.end()});
      ASSERT_FALSE(HasFailure());
      ++done;
    }
  }
  EXPECT_GT(done, 50);
}

TEST(CutEdges, ANetIsADisk) {
  std::vector<std::pair<std::string, Mesh>> meshes;
  for (const Shape& shape : {tetrahedron(), cube(), torus(4, 3), torus(6, 6, 1), annulus(5)}) {
    meshes.emplace_back(shape.name, reference_build(shape));
  }
  meshes.emplace_back("genus two", genus_two());
  for (auto& [name, mesh] : meshes) {
    SCOPED_TRACE(name);
    ASSERT_TRUE(cut_edges(mesh, edges_of_net(mesh)).ok());
    expect_valid_mesh(mesh);
    EXPECT_EQ(euler_characteristic(mesh), 1);
    EXPECT_EQ(boundary_loops(mesh).value().size(), 1U);
    EXPECT_EQ(connected_components(mesh).value().list.size(), 1U);
  }
}

TEST(CutEdges, AllOfThemLeaveTheFacesApart) {
  Mesh mesh = genus_two();
  const Index faces = mesh.face_count();
  ASSERT_TRUE(cut_edges(mesh, inner_edges(mesh)).ok());
  expect_valid_mesh(mesh);
  EXPECT_EQ(mesh.vertex_count(), 4 * faces);
  EXPECT_EQ(mesh.edge_count(), 4 * faces);
  EXPECT_EQ(connected_components(mesh).value().list.size(), faces);
}

TEST(CutEdges, OneEdgeIsCutAsByCut) {
  for (const auto& [name, mesh] : meshes_to_sweep(8)) {
    SCOPED_TRACE(name);
    for (const Edge e : mesh.edges()) {
      Mesh one = copy_of(mesh);
      Mesh other = copy_of(mesh);
      const Result<Halfedge> g = cut(one, mesh.edge_halfedge(e));
      const Result<Array<Halfedge>> copies = cut_edges(other, std::vector<Edge>{e});
      ASSERT_EQ(copies.ok(), g.ok());
      EXPECT_TRUE(Snapshot(one) == Snapshot(other));
      if (!g.ok()) {
        EXPECT_EQ(copies.error().code, g.error().code);
      } else {
        EXPECT_EQ(copies.value()[0], g.value());
      }
    }
  }
}

std::vector<Edge> edges_between(const Mesh& mesh, const std::vector<std::pair<Index, Index>>& all) {
  std::vector<Edge> edges;
  for (const auto& [a, b] : all) {
    edges.push_back(mesh.find_edge(Vertex(a), Vertex(b)));
    EXPECT_TRUE(edges.back().valid()) << a << " - " << b;
  }
  return edges;
}

// A grid of 5 by 5 vertices, cut along a T inside, and glued again from the tips on.
TEST(CutEdges, ATreeInsideLeavesOneSlit) {
  Mesh mesh = reference_build(quad_grid(4, 4));
  const Mesh before = copy_of(mesh);
  const std::vector<Edge> edges = edges_between(mesh, {{12, 17}, {11, 12}, {12, 13}});
  const std::vector<Halfedge> copies = cut_all(mesh, edges);
  EXPECT_EQ(mesh.vertex_count(), 27U);  // 12 three times
  EXPECT_EQ(mesh.edge_count(), before.edge_count() + 3);
  EXPECT_EQ(boundary_loops(mesh).value().size(), 2U);
  std::set<Halfedge> slit;
  for (const Halfedge on_slit : mesh.loop_ccw(copies[0])) slit.insert(on_slit);
  EXPECT_EQ(slit.size(), 6U);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(slit.count(copies[i]), 1U);
    EXPECT_EQ(slit.count(Mesh::opposite(mesh.edge_halfedge(edges[i]))), 1U);
  }
  const auto glue_from = [&](Index tip, std::size_t count) {
    const Halfedge h = mesh.vertex_halfedge(Vertex(tip));
    ASSERT_TRUE(glue_path(mesh, h, mesh.prev(h), count).ok());
  };
  glue_from(17, 1);
  glue_from(11, 2);
  expect_valid_mesh(mesh);
  EXPECT_EQ(mesh.vertex_count(), before.vertex_count());
  EXPECT_EQ(mesh.edge_count(), before.edge_count());
  EXPECT_EQ(boundary_loops(mesh).value().size(), 1U);
}

TEST(CutEdges, AnEmptyListChangesNothing) {
  Mesh mesh = reference_build(torus(4, 3));
  add_attributes_of_all_kinds(mesh);
  ASSERT_TRUE(mesh.enable_history());
  const Snapshot before(mesh);
  const std::uint64_t version = mesh.version();
  EXPECT_TRUE(check_cut_edges(mesh, {}).ok());
  EXPECT_EQ(cut_edges(mesh, {}).value().size(), 0U);
  mesh.end_step();
  EXPECT_TRUE(Snapshot(mesh) == before);
  EXPECT_EQ(mesh.version(), version);
  EXPECT_FALSE(mesh.undo());
}

TEST(CutEdges, Refusals) {
  Mesh mesh = reference_build(quad_grid(4, 4));
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  const auto refuse = [&](const std::vector<Edge>& edges, std::string_view code,
                          const Witness& witness, std::string_view message) {
    const Result<void> can = check_cut_edges(mesh, edges);
    const Result<Array<Halfedge>> refused = cut_edges(mesh, edges);
    expect_refused(refused, code, mesh, before);
    ASSERT_FALSE(can.ok());
    EXPECT_EQ(can.error().code, code);
    EXPECT_EQ(refused.error().witness, witness);
    EXPECT_EQ(refused.error().message, message);
  };
  const std::vector<Edge> path = edges_between(mesh, {{6, 7}, {7, 8}});
  const Edge on_boundary = edges_between(mesh, {{0, 1}})[0];
  const Edge alone = edges_between(mesh, {{17, 18}})[0];
  const std::string name = "Edge " + std::to_string(path[1].index());
  refuse({path[0], path[1], Edge(999)}, "not-an-edge", {.edges = {999}},
         "Edge 999 is not in this mesh, expected an index below 40.");
  refuse({path[0], path[1], Edge{}}, "not-an-edge", {},
         "The edge is empty, expected an edge of this mesh.");
  refuse({path[1], path[0], path[1]}, "repeated-edge", {.edges = {path[1].index()}},
         name + " occurs twice in the list, expected different edges.");
  const Halfedge h = mesh.edge_halfedge(alone);
  const Index a = mesh.from_vertex(h).index();
  const Index b = mesh.to_vertex(h).index();
  refuse({path[0], alone, path[1]}, "no-boundary-end",
         {.vertices = {a, b}, .edges = {alone.index()}},
         "Edge " + std::to_string(alone.index()) + " would become two edges between vertex " +
             std::to_string(a) + " and vertex " + std::to_string(b) +
             ", which are both inside, expected an end on the boundary, or at another edge of the "
             "list.");
  const Result<Array<Halfedge>> boundary =
      cut_edges(mesh, std::vector<Edge>{path[0], path[1], on_boundary});
  expect_refused(boundary, "boundary-edge", mesh, before);
  EXPECT_EQ(boundary.error().witness.edges, (std::vector<Index>{on_boundary.index()}));
}

}  // namespace
}  // namespace halfedge::test
