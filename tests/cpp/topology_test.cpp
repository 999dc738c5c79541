#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/mesh.h>

#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

struct Numbers {
  std::int64_t euler = 0;
  std::size_t loops = 0;
  std::size_t components = 0;
  std::int64_t genus = 0;

  friend bool operator==(const Numbers&, const Numbers&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Numbers& n) {
    return out << "chi " << n.euler << ", " << n.loops << " boundary loops, " << n.components
               << " components, genus " << n.genus;
  }
};

Numbers numbers_of(const Mesh& mesh) {
  const Result<Components> components = connected_components(mesh);
  EXPECT_TRUE(components.ok());
  return {euler_characteristic(mesh), boundary_loops(mesh).value().size(),
          components.value().list.size(), genus(mesh).value()};
}

TEST(Topology, OfEachKindOfSurface) {
  EXPECT_EQ(numbers_of(Mesh{}), (Numbers{0, 0, 0, 0}));
  EXPECT_EQ(numbers_of(reference_build(triangle())), (Numbers{1, 1, 1, 0}));
  EXPECT_EQ(numbers_of(reference_build(disk(7))), (Numbers{1, 1, 1, 0}));
  EXPECT_EQ(numbers_of(reference_build(pillow())), (Numbers{2, 0, 1, 0}));
  EXPECT_EQ(numbers_of(reference_build(cube())), (Numbers{2, 0, 1, 0}));
  EXPECT_EQ(numbers_of(reference_build(annulus(5))), (Numbers{0, 2, 1, 0}));
  EXPECT_EQ(numbers_of(reference_build(torus(5, 4))), (Numbers{0, 0, 1, 1}));
  EXPECT_EQ(numbers_of(reference_build(torus(5, 4, 1))), (Numbers{-1, 1, 1, 1}));
  EXPECT_EQ(numbers_of(reference_build(two_components())), (Numbers{3, 1, 2, 0}));
}

TEST(Topology, OfAPinchedVertexIsThatOfOneComponentWithOneLoop) {
  EXPECT_EQ(numbers_of(reference_build(pinched(2))), (Numbers{1, 1, 1, 0}));
  EXPECT_EQ(numbers_of(reference_build(pinched(5))), (Numbers{1, 1, 1, 0}));
}

TEST(Topology, OfIsolatedVerticesCountsThemInTheEulerCharacteristicOnly) {
  const Mesh mesh = reference_build(with_isolated_vertices());
  EXPECT_EQ(numbers_of(mesh), (Numbers{4, 1, 1, 0}));
  const Components components = connected_components(mesh).value();
  const std::vector<Index> expected = {kNone, 0, 0, kNone, 0, kNone};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), components.of_vertex.begin(),
                         components.of_vertex.end()));
}

TEST(Topology, ListsComponentsByTheirSmallestVertex) {
  const Mesh mesh = reference_build({"three", 10, {{9, 1, 8}, {2, 7, 3}, {5, 6, 0}, {1, 9, 4}}});
  const Components components = connected_components(mesh).value();
  const std::vector<Index> of_vertex = {0, 1, 2, 2, 1, 0, 0, 2, 1, 1};
  const std::vector<Index> of_face = {1, 2, 0, 1};
  EXPECT_TRUE(std::equal(of_vertex.begin(), of_vertex.end(), components.of_vertex.begin(),
                         components.of_vertex.end()));
  EXPECT_TRUE(std::equal(of_face.begin(), of_face.end(), components.of_face.begin(),
                         components.of_face.end()));
  ASSERT_EQ(components.list.size(), 3U);
  const Component& strip = components.list[1];
  EXPECT_EQ(strip.vertices, 4U);
  EXPECT_EQ(strip.edges, 5U);
  EXPECT_EQ(strip.faces, 2U);
  EXPECT_EQ(strip.boundary_loops, 1U);
  EXPECT_EQ(strip.euler_characteristic(), 1);
  EXPECT_EQ(strip.genus(), 0);
}

TEST(Topology, SkipsDeletedSlots) {
  Mesh mesh = reference_build(two_components());
  std::vector<Edge> edges;
  for (const Edge e : mesh.face_edges_ccw(Face(4))) edges.push_back(e);
  mesh.release(Face(4));
  for (const Edge e : edges) mesh.release(e);
  for (const Index v : {4U, 5U, 6U}) mesh.release(Vertex(v));
  EXPECT_EQ(numbers_of(mesh), (Numbers{2, 0, 1, 0}));
  EXPECT_TRUE(is_closed(mesh));
  const Components components = connected_components(mesh).value();
  EXPECT_EQ(components.of_vertex[5], kNone);
  EXPECT_EQ(components.of_face[4], kNone);
}

TEST(Topology, ListsTheSmallestHalfedgeOfEachBoundaryLoop) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh mesh = reference_build(random_polygons(seed));
    std::vector<Halfedge> expected;
    for (const Halfedge h : mesh.halfedges()) {
      if (!mesh.is_boundary(h)) continue;
      bool smallest = true;
      for (const Halfedge other : mesh.loop_ccw(h)) smallest = smallest && h <= other;
      if (smallest) expected.push_back(h);
    }
    const Array<Halfedge> loops = boundary_loops(mesh).value();
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), loops.begin(), loops.end()));
  }
}

// Components by spreading along edges until nothing changes.
std::vector<Index> spread(const Mesh& mesh) {
  std::vector<Index> smallest(mesh.vertex_slots());
  std::iota(smallest.begin(), smallest.end(), 0U);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Halfedge h : mesh.halfedges()) {
      const Index from = smallest[mesh.from_vertex(h).index()];
      Index& to = smallest[mesh.to_vertex(h).index()];
      if (from < to) {
        to = from;
        changed = true;
      }
    }
  }
  return smallest;
}

int fans_at(const Mesh& mesh, Vertex v) {
  int fans = 0;
  for (const Halfedge h : mesh.outgoing_cw(v)) fans += mesh.is_boundary(h) ? 1 : 0;
  return fans;
}

TEST(Topology, CountsComponentsOfRandomMeshes) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh mesh = reference_build(random_polygons(seed));
    const std::vector<Index> smallest = spread(mesh);
    std::map<Index, Component> expected;  // by smallest vertex
    for (const Vertex v : mesh.vertices()) {
      if (!mesh.is_isolated(v)) ++expected[smallest[v.index()]].vertices;
    }
    for (const Edge e : mesh.edges()) {
      ++expected[smallest[mesh.to_vertex(mesh.edge_halfedge(e)).index()]].edges;
    }
    for (const Face f : mesh.faces()) {
      ++expected[smallest[mesh.to_vertex(mesh.face_halfedge(f)).index()]].faces;
    }
    const Array<Halfedge> loops = boundary_loops(mesh).value();
    for (const Halfedge h : loops) {
      ++expected[smallest[mesh.to_vertex(h).index()]].boundary_loops;
    }

    // Three fans and more at a vertex can be joined in another order than on the torus.
    bool any_fans_order = false;
    for (const Vertex v : mesh.vertices()) {
      any_fans_order = any_fans_order || fans_at(mesh, v) > 2;
    }

    const Components components = connected_components(mesh).value();
    ASSERT_EQ(components.list.size(), expected.size());
    Index i = 0;
    for (const auto& [vertex, component] : expected) {
      EXPECT_EQ(components.of_vertex[vertex], i);
      EXPECT_EQ(components.list[i].vertices, component.vertices);
      EXPECT_EQ(components.list[i].edges, component.edges);
      EXPECT_EQ(components.list[i].faces, component.faces);
      EXPECT_EQ(components.list[i].boundary_loops, component.boundary_loops);
      EXPECT_EQ(component.euler_characteristic(),
                2 - 2 * component.genus() - std::int64_t{component.boundary_loops});
      EXPECT_GE(component.genus(), 0);
      if (!any_fans_order) {
        EXPECT_LE(component.genus(), 1);  // a piece of a torus
      }
      ++i;
    }
  }
}

TEST(Topology, TellsClosedTriangleAndQuadMeshes) {
  struct Expected {
    Shape shape;
    bool closed, triangles, quads;
  };
  const Expected cases[] = {{no_faces(), true, true, true},
                            {triangle(), false, true, false},
                            {pillow(), true, true, false},
                            {cube(), true, false, true},
                            {torus(4, 3), true, false, true},
                            {torus(4, 3, 1), false, false, true},
                            {mixed_polygons(), false, false, false},
                            {{"pentagon", 5, {{0, 1, 2, 3, 4}}}, false, false, false},
                            {{"hexagon", 6, {{0, 1, 2, 3, 4, 5}}}, false, false, false}};
  for (const Expected& expected : cases) {
    SCOPED_TRACE(expected.shape.name);
    const Mesh mesh = reference_build(expected.shape);
    EXPECT_EQ(is_closed(mesh), expected.closed);
    EXPECT_EQ(is_triangle_mesh(mesh), expected.triangles);
    EXPECT_EQ(is_quad_mesh(mesh), expected.quads);
  }
}

// A single halfedge that is its own next must not count as three corners of a lap, nor two as four.
TEST(Topology, DoesNotTakeALapTwiceForATriangle) {
  Mesh loop;
  const Vertex v = loop.new_vertex();
  const Halfedge h = loop.new_edge(v, v);
  for (const Halfedge side : {h, loop.opposite(h)}) {
    loop.link(side, side);
    loop.set_face(side, loop.new_face(side));
  }
  EXPECT_FALSE(is_triangle_mesh(loop));
  Mesh segment;
  const Halfedge s = segment.new_edge(segment.new_vertex(), segment.new_vertex());
  const Face f = segment.new_face(s);
  segment.set_face(s, f);
  segment.set_face(segment.opposite(s), f);
  EXPECT_FALSE(is_quad_mesh(segment));
  loop.set_vertex_halfedge(v, h);
  EXPECT_EQ(numbers_of(loop), (Numbers{2, 0, 1, 0}));
}

TEST(Topology, RefusesACorruptMeshWithASentence) {
  Mesh mesh = reference_build(quad_grid(2, 2));
  const Halfedge boundary = boundary_loops(mesh).value()[0];
  mesh.mutable_links().next[boundary.index()] = 1000;
  const Result<Array<Halfedge>> loops = boundary_loops(mesh);
  ASSERT_FALSE(loops.ok());
  EXPECT_EQ(loops.error().code, "corrupt-connectivity");
  EXPECT_EQ(loops.error().message,
            "The next of halfedge " + std::to_string(boundary.index()) +
                " breaks the invariants of a mesh: validate names what is wrong.");
  EXPECT_FALSE(connected_components(mesh).ok());
  EXPECT_FALSE(genus(mesh).ok());

  // By way of a halfedge that has a face; then round and round in a part of the loop.
  mesh = reference_build(quad_grid(2, 2));
  const Halfedge inside = mesh.opposite(boundary);
  mesh.mutable_links().next[inside.index()] = mesh.next(boundary).index();
  mesh.mutable_links().next[boundary.index()] = inside.index();
  EXPECT_FALSE(boundary_loops(mesh).ok());
  Mesh circle = reference_build(quad_grid(2, 2));
  const Halfedge first = boundary_loops(circle).value()[0];
  const Halfedge last = circle.prev(first);
  circle.mutable_links().next[last.index()] = circle.next(first).index();
  EXPECT_FALSE(boundary_loops(circle).ok());
}

}  // namespace
}  // namespace halfedge::test
