#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <string>
#include <utility>
#include <vector>

#include "support/built.h"
#include "support/canonical.h"
#include "support/random_polygons.h"
#include "support/shapes.h"
#include "support/storages.h"

namespace halfedge::test {
namespace {

std::vector<Shape> many_shapes() {
  std::vector<Shape> shapes = all_shapes();
  shapes.push_back(disk(100));  // found by a table, not by search
  for (std::uint32_t seed = 0; seed < 20; ++seed) shapes.push_back(random_polygons(seed));
  return shapes;
}

template <class Range>
std::vector<Index> collect(const Range& range) {
  std::vector<Index> items;
  for (const auto item : range) items.push_back(item.index());
  return items;
}

template <class Range>
std::vector<Index> backwards(const Range& range, std::size_t count) {
  std::vector<Index> items;
  auto circulator = range.circulator();
  for (std::size_t i = 0; i < count; ++i, --circulator) items.push_back((*circulator).index());
  return items;
}

// Compares what `ring(mesh)` shows in both meshes.
template <class AnyMesh>
auto same_in(const AnyMesh& mesh, const Mesh& whole) {
  return [&](const auto& ring) { EXPECT_EQ(collect(ring(mesh)), collect(ring(whole))); };
}
// The same, and back again.
template <class AnyMesh>
auto same_both_ways_in(const AnyMesh& mesh, const Mesh& whole) {
  return [&](const auto& ring) {
    const std::vector<Index> expected = collect(ring(whole));
    EXPECT_EQ(collect(ring(mesh)), expected);
    EXPECT_EQ(backwards(ring(mesh), expected.size()), backwards(ring(whole), expected.size()));
  };
}

template <class AnyMesh>
void expect_same_vertex_rings(const AnyMesh& mesh, const Mesh& whole, Vertex v) {
  if constexpr (StoresAnchors<AnyMesh>) {
    const auto same = same_in(mesh, whole);
    same([&](const auto& m) { return m.outgoing_cw(v); });
    same([&](const auto& m) { return m.outgoing_ccw(v); });
    same([&](const auto& m) { return m.incoming_cw(v); });
    same([&](const auto& m) { return m.incoming_ccw(v); });
    same([&](const auto& m) { return m.vertex_vertices_cw(v); });
    same([&](const auto& m) { return m.vertex_vertices_ccw(v); });
    same([&](const auto& m) { return m.vertex_edges_cw(v); });
    same([&](const auto& m) { return m.vertex_edges_ccw(v); });
    EXPECT_EQ(mesh.valence(v), whole.valence(v));
    if constexpr (StoresFaces<AnyMesh>) {
      same([&](const auto& m) { return m.vertex_faces_cw(v); });
      same([&](const auto& m) { return m.vertex_faces_ccw(v); });

      EXPECT_EQ(mesh.is_boundary(v), whole.is_boundary(v));
      EXPECT_EQ(mesh.is_manifold(v), whole.is_manifold(v));
    }
  }
  const auto same = same_both_ways_in(mesh, whole);
  for (const Halfedge start : whole.outgoing_cw(v)) {
    same([&](const auto& m) { return m.outgoing_cw(v, start); });
    same([&](const auto& m) { return m.outgoing_ccw(v, start); });
    same([&](const auto& m) { return m.incoming_cw(v, start); });
    same([&](const auto& m) { return m.incoming_ccw(v, start); });
    same([&](const auto& m) { return m.vertex_vertices_cw(v, start); });
    same([&](const auto& m) { return m.vertex_vertices_ccw(v, start); });
    same([&](const auto& m) { return m.vertex_edges_cw(v, start); });
    same([&](const auto& m) { return m.vertex_edges_ccw(v, start); });
    if constexpr (StoresFaces<AnyMesh>) {
      same([&](const auto& m) { return m.vertex_faces_cw(v, start); });
      same([&](const auto& m) { return m.vertex_faces_ccw(v, start); });
    }
  }
}

template <class AnyMesh>
void expect_same_face_rings(const AnyMesh& mesh, const Mesh& whole, Face f) {
  if constexpr (StoresFaceHalfedges<AnyMesh>) {
    const auto same = same_in(mesh, whole);
    same([&](const auto& m) { return m.face_vertices_cw(f); });
    same([&](const auto& m) { return m.face_vertices_ccw(f); });
    same([&](const auto& m) { return m.face_halfedges_cw(f); });
    same([&](const auto& m) { return m.face_halfedges_ccw(f); });
    same([&](const auto& m) { return m.face_edges_cw(f); });
    same([&](const auto& m) { return m.face_edges_ccw(f); });
    EXPECT_EQ(mesh.degree(f), whole.degree(f));
    if constexpr (StoresFaces<AnyMesh>) {
      same([&](const auto& m) { return m.face_faces_cw(f); });
      same([&](const auto& m) { return m.face_faces_ccw(f); });
    }
  }
  const auto same = same_both_ways_in(mesh, whole);
  for (const Halfedge start : whole.face_halfedges_ccw(f)) {
    same([&](const auto& m) { return m.face_vertices_cw(f, start); });
    same([&](const auto& m) { return m.face_vertices_ccw(f, start); });
    same([&](const auto& m) { return m.face_halfedges_cw(f, start); });
    same([&](const auto& m) { return m.face_halfedges_ccw(f, start); });
    same([&](const auto& m) { return m.face_edges_cw(f, start); });
    same([&](const auto& m) { return m.face_edges_ccw(f, start); });
    if constexpr (StoresFaces<AnyMesh>) {
      const auto shown = same_in(mesh, whole);  // a face without neighbours has no way back
      shown([&](const auto& m) { return m.face_faces_cw(f, start); });
      shown([&](const auto& m) { return m.face_faces_ccw(f, start); });
    }
  }
}

template <Storage kStored>
void expect_same_as_whole(const Shape& shape) {
  const Mesh whole = built<Mesh>(shape);
  const auto mesh = built<BasicMesh<kStored>>(shape);
  EXPECT_EQ(mesh.vertex_count(), whole.vertex_count());
  EXPECT_EQ(mesh.edge_count(), whole.edge_count());
  EXPECT_EQ(mesh.face_count(), kStored.face || kStored.face_halfedge ? whole.face_count() : 0);
  EXPECT_EQ(collect(mesh.vertices()), collect(whole.vertices()));
  for (const Halfedge h : whole.halfedges()) {
    EXPECT_EQ(mesh.next(h), whole.next(h));
    EXPECT_EQ(mesh.prev(h), whole.prev(h));
    EXPECT_EQ(mesh.rotate_ccw(h), whole.rotate_ccw(h));
    EXPECT_EQ(mesh.prev_on_vertex(h), whole.prev_on_vertex(h));
    EXPECT_EQ(mesh.from_vertex(h), whole.from_vertex(h));
    EXPECT_EQ(collect(mesh.loop_ccw(h)), collect(whole.loop_ccw(h)));
    EXPECT_EQ(collect(mesh.loop_cw(h)), collect(whole.loop_cw(h)));
    if constexpr (kStored.face) {
      EXPECT_EQ(mesh.face(h), whole.face(h));
    }
  }
  for (const Edge e : whole.edges()) {
    EXPECT_EQ(collect(mesh.edge_vertices(e)), collect(whole.edge_vertices(e)));
    EXPECT_EQ(collect(mesh.edge_halfedges(e)), collect(whole.edge_halfedges(e)));
    if constexpr (kStored.face) {
      EXPECT_EQ(collect(mesh.edge_faces(e)), collect(whole.edge_faces(e)));
    }
  }
  for (const Vertex v : whole.vertices()) expect_same_vertex_rings(mesh, whole, v);
  for (const Face f : whole.faces()) expect_same_face_rings(mesh, whole, f);
}

/// All sixteen ways to leave links out.
template <class Kind>
class StorageOptions : public testing::Test {};
TYPED_TEST_SUITE(StorageOptions, AllStorages);

TYPED_TEST(StorageOptions, GiveTheSameFromEveryCirculator) {
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_same_as_whole<TypeParam::kStorage>(shape);
  }
}

TYPED_TEST(StorageOptions, AreValidWhereTheWholeMeshIs) {
  constexpr Storage kStored = TypeParam::kStorage;
  // Without any link of faces, the boundary loops of a shape count as faces.
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    const auto mesh = built<BasicMesh<kStored>>(shape);
    const int level = kStored.face || kStored.face_halfedge ? 4 : 3;
    for (const Problem& problem : validate(mesh, level)) {
      EXPECT_NE(problem.severity, Severity::kError) << problem.message;
    }
  }
}

TYPED_TEST(StorageOptions, AreCompletedToTheSameMesh) {
  constexpr Storage kStored = TypeParam::kStorage;
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    const Canonical expected(built<Mesh>(shape));
    Mesh whole;
    auto mesh = built<BasicMesh<kStored>>(shape);
    ASSERT_TRUE(convert(std::move(mesh), whole));
    EXPECT_EQ(mesh.vertex_count(), 0U);
    EXPECT_TRUE(mesh.positions().empty());
    const Canonical completed(whole);
    EXPECT_EQ(completed.positions, expected.positions);
    if (!kStored.face && !kStored.face_halfedge) continue;  // faces are numbered anew
    EXPECT_EQ(completed.sides, expected.sides);
    EXPECT_EQ(completed.anchors, expected.anchors);
    if (kStored.face_halfedge) {
      EXPECT_EQ(completed.firsts, expected.firsts);
    }
  }
}

TYPED_TEST(StorageOptions, AreBuiltByHand) {
  constexpr Storage kStored = TypeParam::kStorage;
  BasicConnectivity<kStored> mesh;
  Vertex v[3];
  for (Vertex& vertex : v) vertex = mesh.new_vertex();
  Halfedge side[3];
  for (int i = 0; i < 3; ++i) side[i] = mesh.new_edge(v[i], v[(i + 1) % 3]);
  for (int i = 0; i < 3; ++i) {
    mesh.link(side[i], side[(i + 1) % 3]);
    mesh.link(mesh.opposite(side[(i + 1) % 3]), mesh.opposite(side[i]));
    if constexpr (kStored.vertex_halfedge) {
      mesh.set_vertex_halfedge(v[(i + 1) % 3], mesh.opposite(side[i]));
    }
  }
  if constexpr (kStored.face) {
    const Face f = mesh.new_face(side[0]);
    for (const Halfedge h : side) mesh.set_face(h, f);
    EXPECT_EQ(mesh.face_count(), 1U);
    EXPECT_TRUE(mesh.is_boundary(mesh.edge(side[1])));
  }
  EXPECT_EQ(mesh.vertex_count(), 3U);
  EXPECT_EQ(mesh.edge_count(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(mesh.prev(side[(i + 1) % 3]), side[i]);
  if constexpr (kStored.face || !kStored.face_halfedge) {
    EXPECT_TRUE(validate(mesh, 3).empty());
  }
}

TYPED_TEST(StorageOptions, TakeTheMemoryThatTheyPromise) {
  constexpr Storage kStored = TypeParam::kStorage;
  const auto mesh = built<BasicMesh<kStored>>(torus(64, 64));
  const Links& links = mesh.links();
  std::size_t bytes = 0;
  for (const Array<Index>* array : {&links.next, &links.prev, &links.to_vertex, &links.face,
                                    &links.vertex_halfedge, &links.face_halfedge}) {
    bytes += sizeof(Index) * array->capacity();
  }
  // A torus of quads has 4 halfedges and 1 face to a vertex.
  const std::size_t expected =
      4 * (2 * 4 + (kStored.prev ? 4 : 0) + (kStored.face ? 4 : 0) +
           (kStored.face_halfedge ? 1 : 0) + (kStored.vertex_halfedge ? 1 : 0));
  EXPECT_EQ(bytes, 64 * 64 * expected);
}

// ---- without prev: what users of a large mesh choose ----------------------------------------

std::vector<Index> indices(const Array<Index>& array) { return {array.begin(), array.end()}; }

TEST(StorageOptions, WithoutPrevGiveTheSameListsInOneCall) {
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh whole = built<Mesh>(shape);
    const auto mesh = built<BasicMesh<kWithoutPrev>>(shape);
    for (int i = 0; i <= int(Ring::kEdgeFaces); ++i) {
      const Ring ring = Ring(i);
      for (const Direction direction : {Direction::kCcw, Direction::kCw}) {
        Adjacency expected;
        Adjacency found;
        ASSERT_TRUE(adjacency(whole, ring, direction, expected));
        ASSERT_TRUE(adjacency(mesh, ring, direction, found));
        EXPECT_EQ(indices(found.offsets), indices(expected.offsets)) << i;
        EXPECT_EQ(indices(found.items), indices(expected.items)) << i;
        if (shape.faces.empty()) continue;
        const std::vector<Index> centres{0, 0};
        ASSERT_TRUE(adjacency(whole, ring, direction, centres, expected));
        ASSERT_TRUE(adjacency(mesh, ring, direction, centres, found));
        EXPECT_EQ(indices(found.items), indices(expected.items)) << i;
        for (std::size_t room = 0; room < 9; ++room) {
          std::vector<Index> ours(room, 77);
          std::vector<Index> theirs(room, 77);
          EXPECT_EQ(write_ring(mesh, ring, direction, 0, ours).value(),
                    write_ring(whole, ring, direction, 0, theirs).value());
          EXPECT_EQ(ours, theirs) << i;
        }
      }
    }
  }
}

TEST(StorageOptions, WithoutPrevHaveTheSameTopology) {
  for (const Shape& shape : many_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh whole = built<Mesh>(shape);
    const auto mesh = built<BasicMesh<kWithoutPrev>>(shape);
    EXPECT_EQ(euler_characteristic(mesh), euler_characteristic(whole));
    EXPECT_EQ(genus(mesh).value(), genus(whole).value());
    EXPECT_EQ(is_closed(mesh), is_closed(whole));
    EXPECT_EQ(is_quad_mesh(mesh), is_quad_mesh(whole));
    EXPECT_EQ(boundary_loops(mesh).value().size(), boundary_loops(whole).value().size());
    EXPECT_EQ(indices(connected_components(mesh).value().of_face),
              indices(connected_components(whole).value().of_face));
  }
}

TEST(StorageOptions, NeedACompactMeshWhereTheyCannotMarkDeletedItems) {
  Mesh mesh = built<Mesh>(with_isolated_vertices());
  mesh.release(Vertex(0));
  BasicMesh<kWithoutAnchors> reduced;
  const Result<void> refused = convert(std::move(mesh), reduced);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "deleted-item");
  EXPECT_EQ(mesh.vertex_count(), 5U) << "a refused conversion changes nothing";
  EXPECT_EQ(mesh.positions().size(), 18U);
  ASSERT_TRUE(compact(mesh));
  ASSERT_TRUE(convert(std::move(mesh), reduced));
  EXPECT_EQ(reduced.vertex_count(), 5U);
}

TEST(StorageOptions, LosePositionsOnTheWayToAConnectivity) {
  Mesh mesh = built<Mesh>(cube());
  Connectivity connectivity;
  ASSERT_TRUE(convert(std::move(mesh), connectivity));
  EXPECT_EQ(connectivity.face_count(), 6U);
  EXPECT_TRUE(mesh.positions().empty());
  EXPECT_TRUE(validate(mesh).empty());

  mesh = built<Mesh>(tetrahedron());
  ASSERT_TRUE(convert(std::move(connectivity), mesh));
  EXPECT_EQ(mesh.positions().size(), 3 * 8U);
  EXPECT_EQ(mesh.position(Vertex(0)), Point());
  EXPECT_EQ(mesh.position(Vertex(7)), Point());
  EXPECT_TRUE(validate(mesh).empty());
}

TEST(StorageOptions, KeepTheirPositionsWhereAConnectivityIsRefused) {
  Mesh mesh = built<Mesh>(with_isolated_vertices());
  mesh.release(Vertex(0));
  BasicConnectivity<kWithoutAnchors> reduced;
  ASSERT_FALSE(convert(std::move(mesh), reduced));
  EXPECT_EQ(mesh.positions().size(), 18U);
}

TEST(StorageOptions, AreTheSameAfterAConversionToThemselves) {
  Mesh mesh = built<Mesh>(cube());
  ASSERT_TRUE(convert(std::move(mesh), mesh));
  EXPECT_EQ(mesh.face_count(), 6U);
  EXPECT_EQ(mesh.positions().size(), 3 * 8U);
  EXPECT_TRUE(validate(mesh).empty());
}

TEST(StorageOptions, FindBrokenLinksWithoutFollowingThem) {
  const auto broken = [](auto&& damage) {
    auto mesh = built<BasicMesh<kWithoutPrev>>(quad_grid(3, 3));
    damage(mesh.mutable_links());
    return has_errors(validate(mesh));
  };
  EXPECT_FALSE(broken([](Links&) {}));
  EXPECT_TRUE(broken([](Links& links) { links.next[5] = 1'000'000; }));
  EXPECT_TRUE(broken([](Links& links) { links.next[5] = links.next[7]; }));
  EXPECT_TRUE(broken([](Links& links) { links.to_vertex[5] = 1'000'000; }));
  EXPECT_TRUE(broken([](Links& links) { (void)links.to_vertex.resize(3); }));
  EXPECT_TRUE(broken([](Links& links) { links.face_halfedge[0] = 1'000'000; }));
}

}  // namespace
}  // namespace halfedge::test
