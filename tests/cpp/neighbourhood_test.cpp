#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

// The definitions once more, by sets: slow, and without a walk around a vertex.

using Indices = std::vector<Index>;

struct Set {
  std::set<Index> vertices, edges, faces;

  Set() = default;
  explicit Set(const ItemSet& items)
      : vertices(items.vertices.begin(), items.vertices.end()),
        edges(items.edges.begin(), items.edges.end()),
        faces(items.faces.begin(), items.faces.end()) {
    // In ascending order, each once.
    EXPECT_TRUE(
        std::equal(vertices.begin(), vertices.end(), items.vertices.begin(), items.vertices.end()));
    EXPECT_TRUE(std::equal(edges.begin(), edges.end(), items.edges.begin(), items.edges.end()));
    EXPECT_TRUE(std::equal(faces.begin(), faces.end(), items.faces.begin(), items.faces.end()));
  }
  friend bool operator==(const Set&, const Set&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Set& set) {
    for (const auto* items : {&set.vertices, &set.edges, &set.faces}) {
      out << "{";
      for (const Index item : *items) out << item << " ";
      out << "} ";
    }
    return out;
  }
};

Set closure_by_sets(const Mesh& mesh, const Set& set) {
  Set all = set;
  for (const Index f : set.faces) {
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.face(h) == Face(f)) all.edges.insert(mesh.edge(h).index());
    }
  }
  for (const Index e : all.edges) {
    for (const Index side : {0U, 1U}) {
      all.vertices.insert(mesh.to_vertex(mesh.edge_halfedge(Edge(e), side)).index());
    }
  }
  return all;
}

bool meet(const std::set<Index>& a, const std::set<Index>& b) {
  return std::any_of(a.begin(), a.end(), [&](Index item) { return b.count(item) > 0; });
}
bool meet(const Set& a, const Set& b) {
  return meet(a.vertices, b.vertices) || meet(a.edges, b.edges) || meet(a.faces, b.faces);
}

Set star_by_sets(const Mesh& mesh, const Set& set) {
  Set all;
  for (const Vertex v : mesh.vertices()) {
    if (set.vertices.count(v.index()) > 0) all.vertices.insert(v.index());
  }
  for (const Edge e : mesh.edges()) {
    Set one;
    one.edges = {e.index()};
    if (meet(closure_by_sets(mesh, one), set)) all.edges.insert(e.index());
  }
  for (const Face f : mesh.faces()) {
    Set one;
    one.faces = {f.index()};
    if (meet(closure_by_sets(mesh, one), set)) all.faces.insert(f.index());
  }
  return all;
}

Set link_by_sets(const Mesh& mesh, const Set& set) {
  Set all = closure_by_sets(mesh, star_by_sets(mesh, set));
  const Set without = star_by_sets(mesh, closure_by_sets(mesh, set));
  for (const Index v : without.vertices) all.vertices.erase(v);
  for (const Index e : without.edges) all.edges.erase(e);
  for (const Index f : without.faces) all.faces.erase(f);
  return all;
}

std::vector<Shape> meshes() {
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < 4; ++seed) shapes.push_back(random_polygons(seed));
  return shapes;
}

// The same mesh with slots in between that are deleted.
Mesh with_gaps(const Shape& shape) {
  Mesh mesh = reference_build(shape);
  const Vertex a = mesh.new_vertex();
  const Vertex b = mesh.new_vertex();
  const Edge e = mesh.edge(mesh.new_edge(a, b));
  mesh.release(e);
  mesh.release(a);
  return mesh;
}

TEST(Neighbourhood, OfRandomSetsIsThatOfTheDefinitions) {
  std::uint32_t seed = 0;
  for (const Shape& shape : meshes()) {
    SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
    const Mesh mesh = with_gaps(shape);
    BasicMesh<kWithoutPrev> lean;
    Mesh copy;
    ASSERT_TRUE(copy.assign(mesh));
    ASSERT_TRUE(convert(std::move(copy), lean).ok());
    std::mt19937 random(seed++);
    for (int round = 0; round < 12; ++round) {
      Set set;
      for (const Vertex v : mesh.vertices()) {
        if (random() % 12 == 0) set.vertices.insert(v.index());
      }
      for (const Edge e : mesh.edges()) {
        if (random() % 20 == 0) set.edges.insert(e.index());
      }
      for (const Face f : mesh.faces()) {
        if (random() % 20 == 0) set.faces.insert(f.index());
      }
      Indices vertices(set.vertices.begin(), set.vertices.end());
      vertices.insert(vertices.end(), vertices.begin(), vertices.end());
      const Indices edges(set.edges.rbegin(), set.edges.rend());
      const Indices faces(set.faces.begin(), set.faces.end());
      const Items items{vertices, edges, faces};
      EXPECT_EQ(Set(star(mesh, items).value()), star_by_sets(mesh, set));
      EXPECT_EQ(Set(closure(mesh, items).value()), closure_by_sets(mesh, set));
      EXPECT_EQ(Set(link(mesh, items).value()), link_by_sets(mesh, set));
      EXPECT_EQ(Set(link(lean, items).value()), link_by_sets(mesh, set));
    }
  }
}

TEST(Neighbourhood, OfOneItemIsWhatTextbooksDraw) {
  const Mesh mesh = reference_build(triangle_grid(4, 4));  // 5 x 5 vertices
  const Indices centre = {12};
  const ItemSet around = star(mesh, {.vertices = centre}).value();
  EXPECT_EQ(around.vertices.size(), 1U);
  EXPECT_EQ(around.edges.size(), 6U);
  EXPECT_EQ(around.faces.size(), 6U);
  const ItemSet ring = link(mesh, {.vertices = centre}).value();
  EXPECT_EQ(ring.vertices.size(), 6U);
  EXPECT_EQ(ring.edges.size(), 6U);
  EXPECT_EQ(ring.faces.size(), 0U);
  const ItemSet path = link(mesh, {.vertices = Indices{2}}).value();
  EXPECT_EQ(path.vertices.size(), path.edges.size() + 1);
  const Indices edge = {mesh.find_edge(Vertex(12), Vertex(13)).index()};
  const ItemSet across = link(mesh, {.edges = edge}).value();
  EXPECT_EQ(across.vertices.size(), 2U);
  EXPECT_EQ(across.edges.size(), 0U);
  EXPECT_EQ(Set(star(mesh, {}).value()), Set{});
}

TEST(Neighbourhood, KRingHasRowsByDistance) {
  std::uint32_t seed = 0;
  for (const Shape& shape : meshes()) {
    SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
    const Mesh mesh = with_gaps(shape);
    std::mt19937 random(seed++);
    Indices sources;
    for (const Vertex v : mesh.vertices()) {
      if (random() % 7 == 0) sources.insert(sources.end(), {v.index(), v.index()});
    }
    // Distances by relaxing all edges until nothing changes.
    std::vector<Index> distance(mesh.vertex_slots(), kNone);
    for (const Index v : sources) distance[v] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (const Halfedge h : mesh.halfedges()) {
        const Index from = distance[mesh.from_vertex(h).index()];
        Index& to = distance[mesh.to_vertex(h).index()];
        if (from == kNone || to <= from + 1) continue;
        to = from + 1;
        changed = true;
      }
    }
    for (const Index k : {0U, 1U, 2U, 5U, kNone}) {
      const Adjacency rows = k_ring(mesh, sources, k).value();
      std::map<Index, std::set<Index>> expected;
      for (const Vertex v : mesh.vertices()) {
        const Index d = distance[v.index()];
        if (d != kNone && d <= k) expected[d].insert(v.index());
      }
      ASSERT_EQ(rows.offsets.size(), expected.size() + 1) << "k = " << k;
      for (Index d = 0; d < expected.size(); ++d) {
        const auto begin = rows.items.begin() + rows.offsets[d];
        const auto end = rows.items.begin() + rows.offsets[d + 1];
        EXPECT_EQ(std::set<Index>(begin, end), expected[d]) << "k = " << k << ", row " << d;
        EXPECT_EQ(std::size_t(end - begin), expected[d].size());
      }
    }
  }
}

// A vertex is no edge, and an index alone could be of anything.
static_assert(std::is_convertible_v<Vertex, ItemSpan<Vertex>>);
static_assert(!std::is_convertible_v<Vertex, ItemSpan<Edge>>);
static_assert(!std::is_convertible_v<std::vector<Vertex>, ItemSpan<Edge>>);
static_assert(!std::is_convertible_v<Index, ItemSpan<Vertex>>);

TEST(Neighbourhood, TakesHandlesAsWellAsIndices) {
  const Mesh mesh = reference_build(triangle_grid(4, 4));
  const Indices vertices = {12, 3};
  const Indices edges = {7, 2, 9};
  const Indices faces = {5, 1};
  const std::vector<Vertex> same_vertices = {Vertex(12), Vertex(3)};
  const std::array same_edges = {Edge(7), Edge(2), Edge(9)};
  const Face same_faces[] = {Face(5), Face(1)};

  const Adjacency rows = k_ring(mesh, vertices, 2).value();
  const Adjacency same_rows = k_ring(mesh, same_vertices, 2).value();
  EXPECT_TRUE(std::ranges::equal(rows.items, same_rows.items));
  EXPECT_TRUE(std::ranges::equal(rows.offsets, same_rows.offsets));

  const Items items = {vertices, edges, faces};
  const Items same_items = {same_vertices, same_edges, same_faces};
  EXPECT_EQ(Set(star(mesh, items).value()), Set(star(mesh, same_items).value()));
  EXPECT_EQ(Set(closure(mesh, items).value()), Set(closure(mesh, same_items).value()));
  EXPECT_EQ(Set(link(mesh, items).value()), Set(link(mesh, same_items).value()));
}

TEST(Neighbourhood, TakesOneHandle) {
  const Mesh mesh = reference_build(triangle_grid(4, 4));
  const Vertex v(12);
  EXPECT_EQ(k_ring(mesh, v, 1).value().items.size(), 7U);
  EXPECT_EQ(star(mesh, {.vertices = v}).value().faces.size(), 6U);
  EXPECT_EQ(closure(mesh, {.faces = Face(0)}).value().edges.size(), 3U);
  EXPECT_EQ(link(mesh, {.edges = mesh.find_edge(v, Vertex(13))}).value().vertices.size(), 2U);
  EXPECT_EQ(k_ring(mesh, Vertex(99), 1).error().message,
            "Vertex 99 at position 0 does not exist, expected less than 25.");
  EXPECT_EQ(k_ring(mesh, Vertex(), 1).error().code, "index-out-of-range");
}

TEST(Neighbourhood, RefusesItemsThatAreNone) {
  const Mesh mesh = with_gaps(tetrahedron());
  const Indices deleted = {0, 4};
  const Indices unknown = {0, 99};
  EXPECT_EQ(k_ring(mesh, deleted, 1).error().message, "Vertex 4 at position 1 is deleted.");
  EXPECT_EQ(k_ring(mesh, unknown, 1).error().code, "index-out-of-range");
  EXPECT_EQ(star(mesh, {.vertices = deleted}).error().code, "deleted-item");
  EXPECT_EQ(link(mesh, {.edges = unknown}).error().message,
            "Edge 99 at position 1 does not exist, expected less than 7.");
  EXPECT_EQ(closure(mesh, {.faces = unknown}).error().code, "index-out-of-range");
}

TEST(Neighbourhood, OfACorruptMeshIsAnErrorOrSomeItems) {
  std::mt19937 random(11);
  int errors = 0;
  for (int round = 0; round < 3000; ++round) {
    Mesh mesh = reference_build(round % 2 == 0 ? torus(5, 4, 1) : triangle_grid(4, 3));
    Links& links = mesh.mutable_links();
    Array<Index>* const arrays[] = {&links.next, &links.to_vertex,       &links.prev,
                                    &links.face, &links.vertex_halfedge, &links.face_halfedge};
    for (int i = 0; i < 3; ++i) {
      Array<Index>& array = *arrays[random() % 6];
      const Index values[] = {kNone, kDeleted, Index(random()), Index(random() % 60), 0};
      array[random() % array.size()] = values[random() % 5];
    }
    const Indices all = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    const Items items{all, all, all};
    for (const bool ok : {k_ring(mesh, all, kNone).ok(), star(mesh, items).ok(),
                          closure(mesh, items).ok(), link(mesh, items).ok()}) {
      errors += ok ? 0 : 1;
    }
  }
  EXPECT_GT(errors, 1000);
}

}  // namespace
}  // namespace halfedge::test
