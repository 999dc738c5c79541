#include <gtest/gtest.h>
#include <halfedge/algorithms/adjacency.h>
#include <halfedge/build/build.h>
#include <halfedge/decorator/complexes.h>
#include <halfedge/mesh.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge {
namespace {

using test::reference_build;
using test::Shape;
using Row = std::vector<Index>;

template <class Range>
Row collect(const Range& range) {
  Row row;
  for (const auto item : range) row.push_back(item.index());
  return row;
}

// Each kind of ring beside the circulators it must agree with.
struct Kind {
  Ring ring;
  const char* name;
  ItemKind centre;
  std::function<Row(const Mesh&, Index)> ccw;
  std::function<Row(const Mesh&, Index)> cw;
};

#define HALFEDGE_KIND(ring, Centre, stem)                                              \
  Kind {                                                                               \
    Ring::ring, #ring, kind_of(Centre{}),                                              \
        [](const Mesh& mesh, Index i) { return collect(mesh.stem##_ccw(Centre(i))); }, \
        [](const Mesh& mesh, Index i) { return collect(mesh.stem##_cw(Centre(i))); }   \
  }
#define HALFEDGE_EDGE_KIND(ring, stem)                                         \
  Kind {                                                                       \
    Ring::ring, #ring, ItemKind::kEdge,                                        \
        [](const Mesh& mesh, Index i) { return collect(mesh.stem(Edge(i))); }, \
        [](const Mesh& mesh, Index i) { return collect(mesh.stem(Edge(i))); }  \
  }

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      HALFEDGE_KIND(kVertexVertices, Vertex, vertex_vertices),
      HALFEDGE_KIND(kVertexOutgoing, Vertex, outgoing),
      HALFEDGE_KIND(kVertexIncoming, Vertex, incoming),
      HALFEDGE_KIND(kVertexEdges, Vertex, vertex_edges),
      HALFEDGE_KIND(kVertexFaces, Vertex, vertex_faces),
      HALFEDGE_KIND(kFaceVertices, Face, face_vertices),
      HALFEDGE_KIND(kFaceHalfedges, Face, face_halfedges),
      HALFEDGE_KIND(kFaceEdges, Face, face_edges),
      HALFEDGE_KIND(kFaceFaces, Face, face_faces),
      HALFEDGE_EDGE_KIND(kEdgeVertices, edge_vertices),
      HALFEDGE_EDGE_KIND(kEdgeHalfedges, edge_halfedges),
      HALFEDGE_EDGE_KIND(kEdgeFaces, edge_faces),
  };
  return all;
}

Index slots_of(const Mesh& mesh, ItemKind kind) {
  if (kind == ItemKind::kVertex) return mesh.vertex_slots();
  return kind == ItemKind::kFace ? mesh.face_slots() : mesh.edge_slots();
}

bool is_live(const Mesh& mesh, ItemKind kind, Index i) {
  if (kind == ItemKind::kVertex) return mesh.is_live(Vertex(i));
  return kind == ItemKind::kFace ? mesh.is_live(Face(i)) : mesh.is_live(Edge(i));
}

Row row_of(const Adjacency& adjacency, Index i) {
  const Index* items = adjacency.items.data();
  return {items + adjacency.offsets[i], items + adjacency.offsets[i + 1]};
}

// A mixed mesh with deleted slots of every kind: the second component is taken out.
Mesh mesh_with_deleted_slots() {
  Mesh mesh = reference_build(test::two_components());
  std::vector<Edge> edges;
  for (const Edge e : mesh.face_edges_ccw(Face(4))) edges.push_back(e);
  mesh.release(Face(4));
  for (const Edge e : edges) mesh.release(e);
  for (const Index v : {4U, 5U, 6U}) mesh.release(Vertex(v));
  return mesh;
}

void expect_as_circulators(const Mesh& mesh, const Kind& kind, Direction direction) {
  SCOPED_TRACE(std::string(kind.name) + (direction == Direction::kCcw ? " ccw" : " cw"));
  const auto& circulator = direction == Direction::kCcw ? kind.ccw : kind.cw;
  Adjacency all;
  const Result<void> done = adjacency(mesh, kind.ring, direction, all);
  ASSERT_TRUE(done.ok()) << done.error().message;
  const Index slots = slots_of(mesh, kind.centre);
  ASSERT_EQ(all.offsets.size(), slots + 1);
  EXPECT_EQ(all.offsets[0], 0U);
  EXPECT_EQ(all.items.size(), all.offsets[slots]);

  Row live;
  for (Index i = 0; i < slots; ++i) {
    const Row expected = is_live(mesh, kind.centre, i) ? circulator(mesh, i) : Row{};
    EXPECT_EQ(row_of(all, i), expected) << "around " << i;
    if (is_live(mesh, kind.centre, i)) live.insert(live.begin(), i);

    if (!is_live(mesh, kind.centre, i)) continue;
    Row buffer(expected.size() + 2, 12345);
    const Result<Index> length = write_ring(mesh, kind.ring, direction, i, buffer);
    ASSERT_TRUE(length.ok()) << length.error().message;
    EXPECT_EQ(length.value(), expected.size());
    buffer.resize(expected.size());
    EXPECT_EQ(buffer, expected);
  }

  if (!live.empty()) live.push_back(live.front());  // backwards, and one of them twice
  Adjacency some;
  const Result<void> listed = adjacency(mesh, kind.ring, direction, live, some);
  ASSERT_TRUE(listed.ok()) << listed.error().message;
  ASSERT_EQ(some.offsets.size(), live.size() + 1);
  EXPECT_EQ(some.items.size(), some.offsets[live.size()]);
  for (Index i = 0; i < live.size(); ++i) {
    EXPECT_EQ(row_of(some, i), circulator(mesh, live[i])) << "position " << i;
  }
}

TEST(Adjacency, ListsWhatTheCirculatorsVisitInTheirOrder) {
  for (const Shape& shape : test::all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = reference_build(shape);
    for (const Kind& kind : kinds()) {
      expect_as_circulators(mesh, kind, Direction::kCcw);
      expect_as_circulators(mesh, kind, Direction::kCw);
    }
  }
}

// 6561 vertices of valence 2 to 8 and more, some of them isolated, one of valence 40, holes.
Mesh large_irregular_mesh() {
  std::mt19937 random(5);
  Shape grid = test::grid_of("", 80, 80, [](Index, Index) { return true; });
  std::vector<std::vector<Index>> faces;
  for (const std::vector<Index>& quad : grid.faces) {
    const std::size_t i = random() % 2;
    if (random() % 20 == 0) continue;
    if (random() % 10 == 0) {
      faces.push_back(quad);
    } else {
      faces.push_back({quad[i], quad[i + 1], quad[i + 2]});
      faces.push_back({quad[i], quad[i + 2], quad[(i + 3) % 4]});
    }
  }
  for (Index i = 0; i < 39; ++i) faces.push_back({6561, 6562 + i, 6563 + i});
  return reference_build({"", 6605, std::move(faces)});
}

TEST(Adjacency, ListsTheRingsOfALargeMeshOfVaryingValences) {
  const Mesh mesh = large_irregular_mesh();
  for (const Kind& kind : kinds()) {
    expect_as_circulators(mesh, kind, Direction::kCcw);
    expect_as_circulators(mesh, kind, Direction::kCw);
  }
}

// Large enough for its rings to lie scattered; what is listed must not depend on that.
TEST(Adjacency, ListsTheRingsOfALargeMeshInNoOrder) {
  const Shape grid = test::triangle_grid(200, 200);
  const Shape in_no_order = test::with_random_names(test::in_random_order(grid));
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, in_no_order.polygons(), report));
  for (const Kind& kind : kinds()) {
    if (kind.ring != Ring::kVertexVertices && kind.ring != Ring::kFaceFaces) continue;
    for (const Direction direction : {Direction::kCcw, Direction::kCw}) {
      const auto& circulator = direction == Direction::kCcw ? kind.ccw : kind.cw;
      Adjacency all;
      ASSERT_TRUE(adjacency(mesh, kind.ring, direction, all).ok());
      ASSERT_EQ(all.offsets.size(), slots_of(mesh, kind.centre) + 1);
      for (Index i = 0; i < slots_of(mesh, kind.centre); ++i) {
        ASSERT_EQ(row_of(all, i), circulator(mesh, i)) << kind.name << " around " << i;
      }
    }
  }
}

TEST(Adjacency, NamesTheBrokenRingOfALargeMeshOfVaryingValences) {
  Mesh mesh = large_irregular_mesh();
  Vertex v(3000);
  while (mesh.valence(v) != 6 || mesh.is_boundary(v)) v = Vertex(v.index() + 1);
  const Halfedge anchor = mesh.vertex_halfedge(v);
  const Halfedge second = mesh.rotate_cw(anchor);
  const auto expect_broken = [&](Ring ring) {
    Adjacency result;
    const Result<void> done = adjacency(mesh, ring, Direction::kCw, result);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().message, "The ring around vertex " + std::to_string(v.index()) +
                                        " does not close: validate names the broken links.");
  };
  // Out of range in three ways; then round and round, past the anchor.
  for (const Index wrong : {mesh.halfedge_slots(), kNone, kDeleted, second.index()}) {
    const Halfedge from = wrong == second.index() ? mesh.opposite(second) : mesh.opposite(anchor);
    const Index right = mesh.next(from).index();
    mesh.mutable_links().next[from.index()] = wrong;
    expect_broken(Ring::kVertexVertices);
    expect_broken(Ring::kVertexFaces);
    mesh.mutable_links().next[from.index()] = right;
  }
}

TEST(Adjacency, NamesTheTriangleThatIsBroken) {
  Mesh mesh = reference_build(test::triangle_grid(6, 6));
  const Face f(17);
  const Halfedge first = mesh.face_halfedge(f);
  const Halfedge second = mesh.next(first);
  for (const Halfedge from : {first, second, mesh.next(second)}) {
    const Halfedge right = mesh.next(from);
    const Index past_first = second.index();
    for (const Index wrong : {mesh.halfedge_slots(), kNone, kDeleted, past_first}) {
      if (wrong == right.index()) continue;
      mesh.mutable_links().next[from.index()] = wrong;
      for (const Ring ring : {Ring::kFaceVertices, Ring::kFaceFaces}) {
        Adjacency result;
        const Result<void> done = adjacency(mesh, ring, Direction::kCcw, result);
        ASSERT_FALSE(done.ok()) << from.index() << " leads to " << wrong;
        EXPECT_EQ(done.error().message,
                  "The ring around face 17 does not close: validate names the broken links.");
      }
    }
    mesh.mutable_links().next[from.index()] = right.index();
  }
}

TEST(Adjacency, HasEmptyRowsForDeletedSlots) {
  const Mesh mesh = mesh_with_deleted_slots();
  for (const Kind& kind : kinds()) {
    expect_as_circulators(mesh, kind, Direction::kCcw);
    expect_as_circulators(mesh, kind, Direction::kCw);
  }
}

TEST(Adjacency, ReusesTheMemoryOfTheResult) {
  const Mesh mesh = reference_build(test::cube());
  Adjacency result;
  ASSERT_TRUE(adjacency(mesh, Ring::kVertexVertices, Direction::kCcw, result).ok());
  const Index* items = result.items.data();
  ASSERT_TRUE(adjacency(mesh, Ring::kFaceFaces, Direction::kCw, result).ok());
  EXPECT_EQ(result.items.data(), items);
}

TEST(Adjacency, WritesNoMoreOfARingThanFits) {
  const Mesh mesh = reference_build(test::disk(7));
  std::vector<Index> buffer(7, 12345);
  const Result<Index> length =
      write_ring(mesh, Ring::kVertexVertices, Direction::kCw, 0, std::span<Index>(buffer).first(3));
  ASSERT_TRUE(length.ok());
  EXPECT_EQ(length.value(), 7U);
  const Row all = collect(mesh.vertex_vertices_cw(Vertex(0)));
  EXPECT_EQ(buffer, (Row{all[0], all[1], all[2], 12345, 12345, 12345, 12345}));
}

TEST(Adjacency, RefusesItemsThatDoNotExistByName) {
  const Mesh mesh = mesh_with_deleted_slots();
  const std::vector<Index> out_of_range = {0, 1, 99};
  Adjacency result;
  Result<void> done = adjacency(mesh, Ring::kVertexFaces, Direction::kCcw, out_of_range, result);
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, "index-out-of-range");
  EXPECT_EQ(done.error().message, "Vertex 99 at position 2 does not exist, expected less than 7.");
  EXPECT_TRUE(result.offsets.empty());
  EXPECT_TRUE(result.items.empty());

  const std::vector<Index> deleted = {4};
  done = adjacency(mesh, Ring::kFaceEdges, Direction::kCcw, deleted, result);
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, "deleted-item");
  EXPECT_EQ(done.error().message, "Face 4 at position 0 is deleted.");

  const Result<Index> one = write_ring(mesh, Ring::kEdgeFaces, Direction::kCcw, kNone, {});
  ASSERT_FALSE(one.ok());
  EXPECT_EQ(one.error().code, "index-out-of-range");
}

TEST(Adjacency, NamesTheRingThatDoesNotClose) {
  Mesh mesh = reference_build(test::tetrahedron());
  const Halfedge anchor = mesh.vertex_halfedge(Vertex(2));
  // The walk around vertex 2 is led into a circle that never comes back to the anchor.
  const Halfedge second = mesh.rotate_cw(anchor);
  const Halfedge third = mesh.rotate_cw(second);
  mesh.mutable_links().next[mesh.opposite(third).index()] = second.index();
  for (const Ring ring : {Ring::kVertexVertices, Ring::kVertexFaces}) {
    Adjacency result;
    const Result<void> done = adjacency(mesh, ring, Direction::kCw, result);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, "corrupt-connectivity");
    EXPECT_TRUE(result.items.empty());
    const Result<Index> one = write_ring(mesh, ring, Direction::kCw, 2, {});
    ASSERT_FALSE(one.ok());
    EXPECT_EQ(one.error().message,
              "The ring around vertex 2 does not close: validate names the broken links.");
    const std::vector<Index> centres = {2};
    EXPECT_FALSE(adjacency(mesh, ring, Direction::kCw, centres, result).ok());
  }
}

TEST(Adjacency, SurvivesArraysOfDifferentLengths) {
  Mesh mesh = reference_build(test::cube());
  ASSERT_TRUE(mesh.mutable_links().face.resize(5));
  Adjacency result;
  const Result<void> done = adjacency(mesh, Ring::kVertexFaces, Direction::kCcw, result);
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, "corrupt-connectivity");
}

// Where most faces are triangles, these are told by their third step.
TEST(Adjacency, OfALoopAmongTrianglesHasOneItem) {
  Mesh mesh = reference_build(test::triangle_grid(6, 6));
  const Halfedge h = decorator::make_loop(mesh).value();
  Adjacency rows;
  for (const Kind& kind : kinds()) {
    if (kind.centre != ItemKind::kFace) continue;
    SCOPED_TRACE(kind.name);
    ASSERT_TRUE(adjacency(mesh, kind.ring, Direction::kCcw, rows));
    for (const Halfedge side : {h, mesh.opposite(h)}) {
      const Index f = mesh.face(side).index();
      ASSERT_EQ(rows.offsets[f + 1] - rows.offsets[f], 1U);
      EXPECT_EQ(Row{rows.items[rows.offsets[f]]}, kind.ccw(mesh, f));
    }
  }
}

}  // namespace
}  // namespace halfedge
