// Demands of the reference documents that no other test shows by itself; docs/structure-rows.md
// lists all of them.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/connectivity/circulators.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/built.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

template <class Range>
auto listed(const Range& range) {
  std::vector<decltype(*range.begin())> items;
  for (const auto item : range) items.push_back(item);
  return items;
}

// Whether one list is the other, begun elsewhere.
template <class Item>
bool is_turned(std::vector<Item> a, const std::vector<Item>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a == b) return true;
    std::rotate(a.begin(), a.begin() + 1, a.end());
  }
  return a == b;
}

// S1: an array for each kind of item is data for each item of that kind.
TEST(StructureRows, DataIsAttachedToVerticesHalfedgesEdgesAndFaces) {
  const Mesh mesh = built(mixed_polygons());
  std::vector<Index> faces_of_vertex(mesh.vertex_slots(), 0);
  std::vector<Index> corner_of_halfedge(mesh.halfedge_slots(), kNone);
  std::vector<Index> faces_of_edge(mesh.edge_slots(), 0);
  std::vector<Index> corners_of_face(mesh.face_slots(), 0);
  for (const Face f : mesh.faces()) {
    for (const Halfedge h : mesh.face_halfedges_ccw(f)) {
      corner_of_halfedge[h.index()] = corners_of_face[f.index()]++;
      ++faces_of_edge[mesh.edge(h).index()];
      ++faces_of_vertex[mesh.to_vertex(h).index()];
    }
  }
  for (const Vertex v : mesh.vertices()) {
    EXPECT_EQ(faces_of_vertex[v.index()], listed(mesh.vertex_faces_cw(v)).size());
  }
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_EQ(corner_of_halfedge[h.index()] == kNone, mesh.is_boundary(h));
  }
  for (const Edge e : mesh.edges()) {
    EXPECT_EQ(faces_of_edge[e.index()], mesh.is_boundary(e) ? 1U : 2U);
  }
  for (const Face f : mesh.faces()) EXPECT_EQ(corners_of_face[f.index()], mesh.degree(f));
}

// S2
TEST(StructureRows, AnyOutgoingHalfedgeWillDoForAVertexInTheInterior) {
  for (const Shape& shape : {cube(), disk(7), torus(5, 4), mixed_polygons()}) {
    SCOPED_TRACE(shape.name);
    Mesh mesh = built(shape);
    for (const Vertex v : mesh.vertices()) {
      if (mesh.is_boundary(v)) continue;
      const std::vector<Vertex> ring = listed(mesh.vertex_vertices_cw(v));
      for (const Halfedge h : listed(mesh.outgoing_cw(v))) {
        mesh.set_vertex_halfedge(v, h);
        EXPECT_TRUE(is_turned(listed(mesh.vertex_vertices_cw(v)), ring));
        EXPECT_FALSE(mesh.is_boundary(v));
      }
    }
    EXPECT_FALSE(has_errors(validate(mesh)));
  }
}

// S3
TEST(StructureRows, AnyHalfedgeWillDoForAFace) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    Mesh mesh = built(shape);
    for (const Face f : mesh.faces()) {
      const std::vector<Vertex> corners = listed(mesh.face_vertices_ccw(f));
      for (const Halfedge h : listed(mesh.face_halfedges_ccw(f))) {
        mesh.set_face_halfedge(f, h);
        EXPECT_EQ(mesh.to_vertex(h), *mesh.face_vertices_ccw(f).begin());
        EXPECT_TRUE(is_turned(listed(mesh.face_vertices_ccw(f)), corners));
      }
    }
    EXPECT_FALSE(has_errors(validate(mesh)));
  }
}

// A mesh that counts how many of its links are read.
class Counting {
 public:
  explicit Counting(const Mesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] Halfedge next(Halfedge h) const { return ++reads, mesh_.next(h); }
  [[nodiscard]] Halfedge prev(Halfedge h) const { return ++reads, mesh_.prev(h); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const { return mesh_.opposite(h); }
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return next(opposite(h)); }
  [[nodiscard]] Halfedge rotate_ccw(Halfedge h) const { return opposite(prev(h)); }
  [[nodiscard]] Vertex to_vertex(Halfedge h) const { return ++reads, mesh_.to_vertex(h); }
  [[nodiscard]] Edge edge(Halfedge h) const { return mesh_.edge(h); }
  [[nodiscard]] std::uint64_t version() const { return mesh_.version(); }

  mutable int reads = 0;

 private:
  const Mesh& mesh_;
};

// What each step of a lap reads, and what showing an item there reads.
template <class Walk, class View>
void expect_reads(const Mesh& mesh, Halfedge start, int on_a_step, int to_show) {
  const Counting counting(mesh);
  Circulator<Counting, Walk, View> circulator(counting, start);
  do {
    counting.reads = 0;
    ++circulator;
    ASSERT_EQ(counting.reads, on_a_step);
    (void)*circulator;
    ASSERT_EQ(counting.reads, on_a_step + to_show);
    counting.reads = 0;
    --circulator;
    ASSERT_EQ(counting.reads, on_a_step);
    ++circulator;
  } while (circulator.halfedge() != start);
}

// S8: whatever the valence, the degree, and whether the boundary is near.
TEST(StructureRows, AStepOfACirculatorReadsOneLink) {
  std::vector<Shape> shapes = all_shapes();
  shapes.push_back(disk(1000));
  for (const Shape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = built(shape);
    for (const Vertex v : mesh.vertices()) {
      if (mesh.is_isolated(v)) continue;
      const Halfedge h = mesh.vertex_halfedge(v);
      expect_reads<walk::RotateCw, view::ToVertex>(mesh, h, 1, 1);
      expect_reads<walk::RotateCcw, view::ToVertex>(mesh, h, 1, 1);
      expect_reads<walk::RotateCw, view::Self>(mesh, h, 1, 0);
      expect_reads<walk::RotateCw, view::Opposite>(mesh, h, 1, 0);
      expect_reads<walk::RotateCcw, view::ItsEdge>(mesh, h, 1, 0);
      expect_reads<walk::LoopCcw, view::ToVertex>(mesh, h, 1, 1);
      expect_reads<walk::LoopCw, view::ItsEdge>(mesh, h, 1, 0);
    }
  }
}

// S8: an item takes as much whatever its valence or degree is.
TEST(StructureRows, RecordsHaveAFixedSize) {
  const auto expect_fixed = [](const Shape& shape) {
    const Mesh mesh = built(shape);
    const Links& links = mesh.links();
    const std::size_t by_halfedge =
        links.next.size() + links.prev.size() + links.to_vertex.size() + links.face.size();
    EXPECT_EQ(by_halfedge, 4U * mesh.halfedge_count());
    EXPECT_EQ(links.vertex_halfedge.size(), mesh.vertex_count());
    EXPECT_EQ(links.face_halfedge.size(), mesh.face_count());
  };
  for (const Shape& shape : all_shapes()) expect_fixed(shape);
  expect_fixed(disk(1000));
}

}  // namespace
}  // namespace halfedge::test
