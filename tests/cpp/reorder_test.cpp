#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/complexes.h"
#include "support/copies.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/renumbered.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

void scatter_positions(Mesh& mesh, std::mt19937& random) {
  for (float& p : mesh.mutable_positions()) p = float(random() % 1000);
}

/// Faces in the order of their smallest vertices, edges in that of the smaller of their faces.
void expect_grouped(const Mesh& mesh) {
  Index before = 0;
  for (const Face f : mesh.faces()) {
    Index smallest = kNone;
    for (const Vertex v : mesh.face_vertices_ccw(f)) smallest = std::min(smallest, v.index());
    EXPECT_LE(before, smallest) << "face " << f.index();
    before = smallest;
  }
  before = 0;
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e);
    const Index smaller = std::min(mesh.face(h).index(), mesh.face(mesh.opposite(h)).index());
    EXPECT_LE(before, smaller) << "edge " << e.index();
    before = smaller;
  }
}

TEST(Reorder, LeavesTheSameMeshInOtherSlots) {
  std::uint32_t seed = 0;
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = with_gaps(shape, seed++);
    scatter_positions(mesh, random);
    add_attributes_of_all_kinds(mesh);
    const Mesh before = copy_of(mesh);
    const CompactMaps maps = reorder(mesh).value();
    expect_valid_complex(mesh);
    expect_renumbered(mesh, before, maps);
    expect_grouped(mesh);
  }
}

// Pinched and isolated vertices, boundaries, deleted items, faces of 3 to 12 corners.
TEST(Reorder, LeavesPolygonMeshesValid) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = reference_build(random_polygons(seed));
    scatter_positions(mesh, random);
    for (Index f = 0; f < mesh.face_slots(); ++f) {
      if (random() % 5 != 0) continue;
      ASSERT_TRUE(operations::delete_face(mesh, Face(f)));
    }
    add_attributes_of_all_kinds(mesh);
    const Mesh before = copy_of(mesh);
    const CompactMaps maps = reorder(mesh).value();
    EXPECT_FALSE(has_errors(validate(mesh, kMaxValidationLevel)));
    EXPECT_TRUE(mesh.halfedge_slots() > 160 || Invariants(mesh).hold());
    expect_renumbered(mesh, before, maps);
    expect_grouped(mesh);

    Mesh by_links = copy_of(before);
    const CompactMaps other_maps = reorder_breadth_first(by_links).value();
    expect_renumbered(by_links, before, other_maps);
    expect_grouped(by_links);
  }
}

TEST(Reorder, NumbersVerticesInTheirOrder) {
  Mesh mesh = reference_build(torus(6, 5));
  std::mt19937 random(1);
  scatter_positions(mesh, random);
  const Array<Index> order = morton_order(mesh.positions(), mesh.links()).value();
  const Array<Index> by_links = breadth_first_order(mesh.links()).value();
  Mesh other = copy_of(mesh);
  const CompactMaps maps = reorder(mesh).value();
  const CompactMaps other_maps = reorder_breadth_first(other).value();
  for (Index v = 0; v < order.size(); ++v) {
    EXPECT_EQ(maps.vertices[order[v]], v);
    EXPECT_EQ(other_maps.vertices[by_links[v]], v);
  }
}

/// Meshes whose vertices lie in a grid of so many columns, numbered at random.
Mesh shuffled_grid(Index columns) {
  const Shape grid = triangle_grid(columns, columns);
  std::mt19937 random(1);
  std::vector<Index> name(grid.vertices);
  std::iota(name.begin(), name.end(), 0U);
  std::shuffle(name.begin(), name.end(), random);
  std::vector<std::vector<Index>> faces = grid.faces;
  for (std::vector<Index>& face : faces) {
    for (Index& v : face) v = name[v];
  }
  std::shuffle(faces.begin(), faces.end(), random);
  Mesh mesh = reference_build({"shuffled grid", grid.vertices, std::move(faces)});
  for (Index v = 0; v < grid.vertices; ++v) {
    mesh.set_position(Vertex(name[v]), {float(v % (columns + 1)), float(v / (columns + 1)), 0});
  }
  return mesh;
}

/// How far it is in memory from a halfedge to the next one, and to its face, on average.
double mean_step(const Mesh& mesh) {
  double sum = 0;
  for (const Halfedge h : mesh.halfedges()) {
    sum += std::abs(double(h.index()) - double(mesh.next(h).index()));
    if (!mesh.is_boundary(h)) sum += std::abs(double(h.index()) - 3 * mesh.face(h).index());
  }
  return sum / mesh.halfedge_count();
}

TEST(Reorder, BringsTogetherWhatWasFarApart) {
  Mesh mesh = shuffled_grid(100);
  EXPECT_GT(mean_step(mesh), 20'000);
  Mesh by_links = copy_of(mesh);
  ASSERT_TRUE(reorder(mesh));
  EXPECT_LT(mean_step(mesh), 2'000);
  ASSERT_TRUE(reorder_breadth_first(by_links));
  EXPECT_LT(mean_step(by_links), 2'000);
}

TEST(Reorder, OfAMeshInOrderChangesNothingAndIsNoStep) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = with_gaps(random_polygons(seed), seed);
    scatter_positions(mesh, random);
    ASSERT_TRUE(reorder(mesh));
    ASSERT_TRUE(mesh.enable_history());
    const Snapshot before(mesh);
    const std::uint64_t version = mesh.version();
    const CompactMaps maps = reorder(mesh).value();
    EXPECT_TRUE(Snapshot(mesh) == before);
    EXPECT_EQ(mesh.version(), version);
    EXPECT_FALSE(mesh.history()->has_open_step());
    for (const Array<Index>* map : {&maps.vertices, &maps.edges, &maps.faces}) {
      for (Index i = 0; i < map->size(); ++i) ASSERT_EQ((*map)[i], i);
    }
  }
}

TEST(Reorder, OfFewOrNoItemsIsNothingSpecial) {
  Mesh mesh;
  ASSERT_TRUE(reorder(mesh));
  ASSERT_TRUE(reorder_breadth_first(mesh));
  EXPECT_EQ(mesh.version(), 0U);
  for (const float x : {2.0F, 0.0F, 1.0F}) ASSERT_TRUE(mesh.add_vertex({x, 0, 0}).valid());
  const CompactMaps maps = reorder(mesh).value();
  EXPECT_EQ((std::vector<Index>(maps.vertices.begin(), maps.vertices.end())),
            (std::vector<Index>{2, 0, 1}));
  for (Index v = 0; v < 3; ++v) {
    EXPECT_TRUE(mesh.is_isolated(Vertex(v)));
    EXPECT_EQ(mesh.position(Vertex(v)).x, float(v));
    mesh.release(Vertex(v));
  }
  ASSERT_TRUE(reorder(mesh));
  EXPECT_EQ(mesh.vertex_slots(), 0U);
  EXPECT_EQ(mesh.free_vertices().count, 0U);
  EXPECT_TRUE(mesh.positions().empty());
}

TEST(Reorder, NumbersEdgesByTheirVerticesWhereThereAreNoFaces) {
  Mesh mesh;
  for (Index i = 0; i < 20; ++i) ASSERT_TRUE(decorator::make_segment(mesh));
  for (Index f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_deleted(Face(f))) mesh.release(Face(f));
  }
  for (const Halfedge h : mesh.halfedges()) mesh.set_face(h, Face());
  std::mt19937 random(1);
  scatter_positions(mesh, random);
  ASSERT_TRUE(reorder(mesh));
  Index before = 0;
  for (const Edge e : mesh.edges()) {
    const Halfedge h = mesh.edge_halfedge(e);
    const Index low = std::min(mesh.from_vertex(h), mesh.to_vertex(h)).index();
    EXPECT_LE(before, low) << "edge " << e.index();
    before = low;
  }
}

TEST(Reorder, KeepsPositionsThatAreNoNumbers) {
  Mesh mesh = reference_build(torus(4, 3));
  const float values[] = {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), 0, -0.0F};
  std::size_t i = 0;
  for (float& p : mesh.mutable_positions()) p = values[i++ * 7 % 5];
  const Mesh before = copy_of(mesh);
  const CompactMaps maps = reorder(mesh).value();
  EXPECT_FALSE(has_errors(validate(mesh, 3)));
  for (const Vertex v : before.vertices()) {
    EXPECT_EQ(std::memcmp(&mesh.positions()[3 * maps(v).index()],
                          &before.positions()[3 * v.index()], 3 * sizeof(float)),
              0);
  }
}

TEST(Reorder, IsUndoneAndRedoneExactly) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Mesh mesh = with_gaps(random_polygons(seed), seed);
    add_attributes_of_all_kinds(mesh);
    ASSERT_TRUE(mesh.enable_generations());
    ASSERT_TRUE(mesh.enable_history());
    const Vertex late = mesh.add_vertex({-1, -1, -1});
    mesh.end_step();
    scatter_positions(mesh, random);
    const Snapshot before(mesh);
    const CompactMaps maps = reorder(mesh).value();
    const Vertex moved = maps(late);
    mesh.set_position(moved, {5, 5, 5});
    const Snapshot after(mesh);
    mesh.end_step();
    EXPECT_EQ(mesh.history()->undo_count(), 2U) << "a part of the step underway";
    ASSERT_TRUE(mesh.undo());
    EXPECT_TRUE(Snapshot(mesh) == before);
    ASSERT_TRUE(mesh.undo());
    ASSERT_TRUE(mesh.redo());
    ASSERT_TRUE(mesh.redo());
    EXPECT_TRUE(Snapshot(mesh) == after);
  }
}

TEST(Reorder, EndsGenerationsWhereItMovesSomething) {
  Mesh mesh = reference_build(torus(4, 3));
  std::mt19937 random(1);
  scatter_positions(mesh, random);
  ASSERT_TRUE(mesh.enable_generations());
  const Index before = mesh.generation(Face(0));
  ASSERT_TRUE(reorder(mesh));
  const Index after = mesh.generation(Face(0));
  EXPECT_NE(after, before);
  ASSERT_TRUE(reorder(mesh));
  EXPECT_EQ(mesh.generation(Face(0)), after);
}

TEST(Reorder, LeavesTheArraysWhereTheyAre) {
  Mesh mesh = with_gaps(torus(6, 5), 1);
  ASSERT_TRUE(mesh.reserve(500, 1000, 500));
  const Index* const next = mesh.links().next.data();
  const float* const positions = mesh.positions().data();
  std::mt19937 random(1);
  scatter_positions(mesh, random);
  ASSERT_TRUE(reorder(mesh));
  EXPECT_EQ(mesh.links().next.data(), next);
  EXPECT_GE(mesh.links().next.capacity(), 2000U);
  EXPECT_EQ(mesh.positions().data(), positions);
}

TEST(Reorder, BreadthFirstNeedsNoPositions) {
  const Mesh mesh = reference_build(random_polygons(5));
  Connectivity links;
  ASSERT_TRUE(links.assign(mesh));
  const CompactMaps maps = reorder_breadth_first(links).value();
  EXPECT_EQ(links.edge_count(), mesh.edge_count());
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_EQ(links.next(maps(h)), maps(mesh.next(h)));
    EXPECT_EQ(links.to_vertex(maps(h)), maps(mesh.to_vertex(h)));
  }
}

// The sanitizers look on.
TEST(Reorder, DoesNotFollowLinksOutOfTheArrays) {
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    Mesh mesh = reference_build(torus(4, 3, 1));
    scatter_positions(mesh, random);
    Links& links = mesh.mutable_links();
    for (Array<Index>* array : {&links.next, &links.prev, &links.to_vertex, &links.face,
                                &links.vertex_halfedge, &links.face_halfedge}) {
      Index& link = (*array)[random() % array->size()];
      link = Index(random() % 2 == 0 ? random() % 60 : random());
    }
    const CompactMaps maps = reorder(mesh).value();
    EXPECT_EQ(maps.vertices.size(), 12U);
    EXPECT_LE(mesh.edge_slots(), 24U);
    EXPECT_LE(mesh.face_slots(), 11U);
  }
}

}  // namespace
}  // namespace halfedge::test
