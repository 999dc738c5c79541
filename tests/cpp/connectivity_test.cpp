#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/reference_build.h"
#include "support/same_but_prev.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

void expect_valid(const Mesh& mesh) {
  for (const Problem& problem : validate(mesh)) ADD_FAILURE() << problem.message;
}

// Whether two meshes are equal slot by slot, deleted slots included.
void expect_same_arrays(const Mesh& a, const Mesh& b) {
  expect_same_but_prev(a, b);
  EXPECT_TRUE(same(a.links().prev, b.links().prev));
  EXPECT_EQ(a.free_vertices().head, b.free_vertices().head);
  EXPECT_EQ(a.free_edges().head, b.free_edges().head);
  EXPECT_EQ(a.free_faces().head, b.free_faces().head);
}

//      2
//     . .
//    . f .     e0: 0 -> 1, e1: 1 -> 2, e2: 2 -> 0; side 0 of each lies in f
//   0 . . 1
Mesh triangle_by_hand() {
  Mesh mesh;
  const Vertex a = mesh.add_vertex({0, 0, 0});
  const Vertex b = mesh.add_vertex({1, 0, 0});
  const Vertex c = mesh.add_vertex({0, 1, 0});
  const Halfedge ab = mesh.new_edge(a, b);
  const Halfedge bc = mesh.new_edge(b, c);
  const Halfedge ca = mesh.new_edge(c, a);
  const Face f = mesh.new_face(ca);
  for (const Halfedge h : {ab, bc, ca}) mesh.set_face(h, f);
  mesh.link(ab, bc);
  mesh.link(bc, ca);
  mesh.link(ca, ab);
  mesh.link(mesh.opposite(ab), mesh.opposite(ca));
  mesh.link(mesh.opposite(ca), mesh.opposite(bc));
  mesh.link(mesh.opposite(bc), mesh.opposite(ab));
  mesh.set_vertex_halfedge(a, ab);
  mesh.set_vertex_halfedge(b, bc);
  mesh.set_vertex_halfedge(c, ca);
  return mesh;
}

TEST(Connectivity, ATriangleIsBuiltByHand) {
  Mesh mesh = triangle_by_hand();
  for (const Vertex v : mesh.vertices()) mesh.adjust_anchor(v);
  expect_valid(mesh);
  EXPECT_EQ(mesh.vertex_count(), 3U);
  EXPECT_EQ(mesh.edge_count(), 3U);
  EXPECT_EQ(mesh.halfedge_count(), 6U);
  EXPECT_EQ(mesh.face_count(), 1U);
  EXPECT_EQ(mesh.position(Vertex(1)), (Point{1, 0, 0}));
  expect_same_arrays(mesh, [] {
    Mesh same = triangle_by_hand();
    same.set_vertex_halfedge(Vertex(0), Halfedge(5));
    same.set_vertex_halfedge(Vertex(1), Halfedge(1));
    same.set_vertex_halfedge(Vertex(2), Halfedge(3));
    return same;
  }());
}

TEST(Connectivity, ANewEdgeIsALoopOfItsOwn) {
  Mesh mesh;
  const Vertex a = mesh.new_vertex();
  const Vertex b = mesh.new_vertex();
  const Halfedge h = mesh.new_edge(a, b);
  const Halfedge o = mesh.opposite(h);
  EXPECT_EQ(h, mesh.edge_halfedge(mesh.edge(h), 0));
  EXPECT_EQ(mesh.from_vertex(h), a);
  EXPECT_EQ(mesh.to_vertex(h), b);
  EXPECT_EQ(mesh.next(h), o);
  EXPECT_EQ(mesh.next(o), h);
  EXPECT_EQ(mesh.prev(h), o);
  EXPECT_EQ(mesh.prev(o), h);
  EXPECT_TRUE(mesh.is_boundary(h));
  EXPECT_TRUE(mesh.is_boundary(o));
  EXPECT_TRUE(mesh.is_isolated(a));
  EXPECT_TRUE(mesh.is_isolated(b));
}

TEST(Connectivity, AdjustAnchorFindsTheBoundaryHalfedge) {
  Mesh mesh = reference_build(quad_grid(3, 3));
  const Halfedge boundary = mesh.vertex_halfedge(Vertex(1));
  ASSERT_TRUE(mesh.is_boundary(boundary));
  for (const Halfedge start : {mesh.rotate_cw(boundary), mesh.rotate_ccw(boundary), boundary}) {
    mesh.set_vertex_halfedge(Vertex(1), start);
    mesh.adjust_anchor(Vertex(1));
    EXPECT_EQ(mesh.vertex_halfedge(Vertex(1)), boundary);
  }
  const Halfedge interior = mesh.vertex_halfedge(Vertex(5));
  mesh.adjust_anchor(Vertex(5));
  EXPECT_EQ(mesh.vertex_halfedge(Vertex(5)), interior);

  Mesh isolated = reference_build(with_isolated_vertices());
  isolated.adjust_anchor(Vertex(0));
  EXPECT_TRUE(isolated.is_isolated(Vertex(0)));
}

TEST(Connectivity, ReleasedSlotsAreReusedLastOneFirst) {
  Mesh mesh = triangle_by_hand();
  for (int i = 0; i < 3; ++i) (void)mesh.add_vertex({});
  mesh.release(Vertex(3));
  mesh.release(Vertex(5));
  EXPECT_EQ(mesh.vertex_count(), 4U);
  EXPECT_EQ(mesh.vertex_slots(), 6U);
  EXPECT_FALSE(mesh.is_live(Vertex(3)));
  EXPECT_TRUE(mesh.is_live(Vertex(4)));
  EXPECT_EQ(mesh.add_vertex({7, 8, 9}), Vertex(5));
  EXPECT_EQ(mesh.position(Vertex(5)), (Point{7, 8, 9}));
  EXPECT_EQ(mesh.new_vertex(), Vertex(3));
  EXPECT_EQ(mesh.new_vertex(), Vertex(6));
  EXPECT_EQ(mesh.positions().size(), 21U);
  EXPECT_TRUE(mesh.is_isolated(Vertex(3)));

  mesh.release(Face(0));
  mesh.release(Edge(0));
  mesh.release(Edge(2));
  EXPECT_EQ(mesh.face_count(), 0U);
  EXPECT_EQ(mesh.edge_count(), 1U);
  EXPECT_FALSE(mesh.is_live(Halfedge(0)));
  EXPECT_FALSE(mesh.is_live(Halfedge(1)));
  EXPECT_FALSE(mesh.is_live(Edge(2)));
  EXPECT_EQ(mesh.edge(mesh.new_edge(Vertex(3), Vertex(4))), Edge(2));
  EXPECT_EQ(mesh.edge(mesh.new_edge(Vertex(3), Vertex(4))), Edge(0));
  EXPECT_EQ(mesh.edge(mesh.new_edge(Vertex(3), Vertex(4))), Edge(3));
  EXPECT_EQ(mesh.new_face(Halfedge(0)), Face(0));
  EXPECT_EQ(mesh.new_face(Halfedge(0)), Face(1));
}

TEST(Connectivity, EverySlotCanBeReleasedAndTakenAgain) {
  Mesh mesh = reference_build(cube());
  for (const Index f : {0U, 1U, 2U, 3U, 4U, 5U}) mesh.release(Face(f));
  for (Index e = 0; e < 12; ++e) mesh.release(Edge(e));
  for (Index v = 0; v < 8; ++v) mesh.release(Vertex(v));
  EXPECT_TRUE(mesh.vertices().empty());
  EXPECT_TRUE(mesh.halfedges().empty());
  EXPECT_TRUE(mesh.edges().empty());
  EXPECT_TRUE(mesh.faces().empty());
  EXPECT_EQ(validate(mesh).size(), 0U);
  for (Index v = 8; v-- > 0;) EXPECT_EQ(mesh.new_vertex(), Vertex(v));
  for (Index e = 12; e-- > 0;) EXPECT_EQ(mesh.edge(mesh.new_edge(Vertex(0), Vertex(1))), Edge(e));
  for (Index f = 6; f-- > 0;) EXPECT_EQ(mesh.new_face(Halfedge(0)), Face(f));
  EXPECT_EQ(mesh.vertex_slots(), 8U);
  EXPECT_EQ(mesh.edge_slots(), 12U);
  EXPECT_EQ(mesh.face_slots(), 6U);
}

TEST(Connectivity, TheVersionChangesWithEveryChange) {
  Mesh mesh = triangle_by_hand();
  std::uint64_t last = mesh.version();
  const auto expect_changed = [&](const char* what) {
    EXPECT_NE(mesh.version(), last) << what;
    last = mesh.version();
  };
  (void)mesh.new_vertex();
  expect_changed("new_vertex");
  const Halfedge h = mesh.new_edge(Vertex(0), Vertex(3));
  expect_changed("new_edge");
  const Face f = mesh.new_face(h);
  expect_changed("new_face");
  mesh.link(h, h);
  expect_changed("link");
  mesh.set_to_vertex(h, Vertex(0));
  expect_changed("set_to_vertex");
  mesh.set_face(h, f);
  expect_changed("set_face");
  mesh.set_vertex_halfedge(Vertex(3), h);
  expect_changed("set_vertex_halfedge");
  mesh.set_face_halfedge(f, h);
  expect_changed("set_face_halfedge");
  (void)mesh.mutable_links();
  expect_changed("mutable_links");
  mesh.release(f);
  expect_changed("release a face");
  mesh.release(mesh.edge(h));
  expect_changed("release an edge");
  mesh.release(Vertex(3));
  expect_changed("release a vertex");
  (void)mesh.new_vertex();
  expect_changed("reuse a vertex");
  ASSERT_TRUE(mesh.assign(reference_build(cube())));
  expect_changed("assign");
  mesh.clear();
  expect_changed("clear");

  Mesh other = triangle_by_hand();
  const std::uint64_t last_of_other = other.version();
  mesh = std::move(other);
  expect_changed("move");
  EXPECT_NE(other.version(), last_of_other);  // NOLINT(bugprone-use-after-move)
  mesh.set_position(Vertex(0), {1, 2, 3});
  EXPECT_EQ(mesh.version(), last) << "a position is no connectivity";
  ASSERT_TRUE(mesh.reserve(100, 100, 100));
  EXPECT_EQ(mesh.version(), last) << "reserve changes no item";
}

TEST(Connectivity, ReservesNoMoreItemsThanThereCanBe) {
  Mesh mesh;
  EXPECT_FALSE(mesh.reserve(kMaxSlots + 1, 0, 0));
  EXPECT_FALSE(mesh.reserve(0, kMaxSlots / 2 + 1, 0));  // 2^31 halfedges, or none of 32 bits
  EXPECT_FALSE(mesh.reserve(0, 1U << 31U, 0));
  EXPECT_FALSE(mesh.reserve(0, 0, kMaxSlots + 1));
}

TEST(Connectivity, AssignCopiesSlotBySlot) {
  Mesh original = reference_build(two_components());
  original.release(Vertex(6));
  original.release(Face(4));
  Mesh copy = reference_build(cube());
  ASSERT_TRUE(copy.assign(original));
  expect_same_arrays(copy, original);
  EXPECT_EQ(copy.vertex_count(), original.vertex_count());
  ASSERT_TRUE(copy.assign(copy));
  expect_same_arrays(copy, original);
  EXPECT_EQ(copy.new_vertex(), Vertex(6));
  EXPECT_FALSE(original.is_live(Vertex(6)));
}

TEST(Connectivity, MovesLeaveAnEmptyMesh) {
  Mesh mesh = triangle_by_hand();
  const Mesh moved = std::move(mesh);
  EXPECT_EQ(moved.face_count(), 1U);
  EXPECT_EQ(mesh.vertex_slots(), 0U);  // NOLINT(bugprone-use-after-move): what is promised
  EXPECT_EQ(mesh.vertex_count(), 0U);
}

TEST(Connectivity, AMeshWithDeletedSlotsMovesWithItsFreeLists) {
  Mesh mesh = reference_build(two_components());
  mesh.release(Face(4));
  Mesh moved = std::move(mesh);
  EXPECT_EQ(moved.face_count(), 4U);
  EXPECT_EQ(mesh.face_count(), 0U);  // NOLINT(bugprone-use-after-move): what is promised
  EXPECT_EQ(moved.new_face(Halfedge(0)), Face(4));
}

TEST(Connectivity, ClearForgetsItemsAndDeletedSlots) {
  Mesh mesh = reference_build(cube());
  mesh.release(Vertex(3));
  mesh.clear();
  EXPECT_EQ(mesh.vertex_slots(), 0U);
  EXPECT_EQ(mesh.vertex_count(), 0U);
  EXPECT_EQ(mesh.halfedge_slots(), 0U);
  EXPECT_EQ(mesh.face_slots(), 0U);
  EXPECT_EQ(mesh.positions().size(), 0U);
  EXPECT_EQ(mesh.new_vertex(), Vertex(0));
  EXPECT_EQ(validate(mesh).size(), 1U);  // isolated
}

TEST(Connectivity, NavigatesAsTheFigureShows) {
  const Mesh mesh = reference_build(quad_grid(3, 3));
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_EQ(mesh.opposite(mesh.opposite(h)), h);
    EXPECT_EQ(mesh.edge(h), mesh.edge(mesh.opposite(h)));
    EXPECT_EQ(mesh.from_vertex(h), mesh.to_vertex(mesh.opposite(h)));
    EXPECT_EQ(mesh.from_vertex(mesh.rotate_cw(h)), mesh.from_vertex(h));
    EXPECT_EQ(mesh.rotate_ccw(mesh.rotate_cw(h)), h);
    EXPECT_EQ(mesh.to_vertex(mesh.next_on_vertex(h)), mesh.to_vertex(h));
    EXPECT_EQ(mesh.prev_on_vertex(mesh.next_on_vertex(h)), h);
    EXPECT_EQ(mesh.next_on_vertex(h), mesh.opposite(mesh.rotate_cw(mesh.opposite(h))));
  }
}

TEST(Connectivity, KnowsTheBoundary) {
  const Mesh mesh = reference_build(quad_grid(3, 3));
  for (const Vertex v : mesh.vertices()) {
    const Index i = v.index();
    EXPECT_EQ(mesh.is_boundary(v), i != 5 && i != 6 && i != 9 && i != 10) << i;
    EXPECT_TRUE(mesh.is_manifold(v));
  }
  for (const Face f : mesh.faces()) EXPECT_EQ(mesh.is_boundary(f), f != Face(4));
  EXPECT_TRUE(mesh.is_boundary(mesh.find_edge(Vertex(0), Vertex(1))));
  EXPECT_FALSE(mesh.is_boundary(mesh.find_edge(Vertex(1), Vertex(5))));
  EXPECT_TRUE(mesh.is_boundary(mesh.find_halfedge(Vertex(1), Vertex(0))));
  EXPECT_FALSE(mesh.is_boundary(mesh.find_halfedge(Vertex(0), Vertex(1))));

  const Mesh bowtie = reference_build(pinched(2));
  EXPECT_FALSE(bowtie.is_manifold(Vertex(0)));
  EXPECT_TRUE(bowtie.is_manifold(Vertex(1)));
  const Mesh isolated = reference_build(with_isolated_vertices());
  EXPECT_TRUE(isolated.is_boundary(Vertex(0)));
  EXPECT_TRUE(isolated.is_manifold(Vertex(0)));
}

TEST(Connectivity, FindsHalfedgesByTheirEnds) {
  const Mesh mesh = reference_build(quad_grid(3, 3));
  const Halfedge h = mesh.find_halfedge(Vertex(5), Vertex(6));
  ASSERT_TRUE(h.valid());
  EXPECT_EQ(mesh.from_vertex(h), Vertex(5));
  EXPECT_EQ(mesh.to_vertex(h), Vertex(6));
  EXPECT_EQ(mesh.find_halfedge(Vertex(6), Vertex(5)), mesh.opposite(h));
  EXPECT_EQ(mesh.find_edge(Vertex(6), Vertex(5)), mesh.edge(h));
  EXPECT_FALSE(mesh.find_halfedge(Vertex(5), Vertex(10)).valid());
  EXPECT_FALSE(mesh.find_edge(Vertex(5), Vertex(5)).valid());
}

TEST(Connectivity, FindsTheHalfedgesOfAllPairsOfVerticesAndNoOthers) {
  const Shape shapes[] = {quad_grid(3, 3), bipyramid(30), pyramid(30), pinched(9),
                          with_isolated_vertices()};
  for (const Shape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = reference_build(shape);
    std::map<std::pair<Vertex, Vertex>, Halfedge> expected;
    for (const Halfedge h : mesh.halfedges()) {
      expected[{mesh.from_vertex(h), mesh.to_vertex(h)}] = h;
    }
    for (const Vertex a : mesh.vertices()) {
      for (const Vertex b : mesh.vertices()) {
        const auto found = expected.find({a, b});
        EXPECT_EQ(mesh.find_halfedge(a, b), found == expected.end() ? Halfedge{} : found->second);
      }
    }
  }
}

TEST(Connectivity, FindsTheEdgesOfHubsFromTheirOtherEnds) {
  // Around the hubs alone it would be ten thousand million steps.
  const Index valence = 100'000;
  const Mesh mesh = reference_build(bipyramid(valence));
  Index missing = 0;
  for (Index i = 1; i <= valence; ++i) {
    for (const Vertex hub : {Vertex(0), Vertex(valence + 1)}) {
      missing += mesh.find_halfedge(hub, Vertex(i)).valid() ? 0U : 1U;
      missing += mesh.find_halfedge(Vertex(i), hub).valid() ? 0U : 1U;
    }
  }
  EXPECT_EQ(missing, 0U);
}

TEST(Connectivity, KnowsLiveHandlesFromOthers) {
  const Mesh mesh = reference_build(cube());
  EXPECT_TRUE(mesh.is_live(Vertex(7)));
  EXPECT_FALSE(mesh.is_live(Vertex(8)));
  EXPECT_FALSE(mesh.is_live(Vertex{}));
  EXPECT_TRUE(mesh.is_live(Halfedge(23)));
  EXPECT_FALSE(mesh.is_live(Halfedge(24)));
  EXPECT_FALSE(mesh.is_live(Edge(12)));
  EXPECT_FALSE(mesh.is_live(Edge{}));
  EXPECT_FALSE(mesh.is_live(Face(6)));
}

#if !defined(NDEBUG)
TEST(ConnectivityDeathTest, AssertsThatHandlesHaveASlot) {
  const Mesh mesh = triangle_by_hand();
  const char* sentence = "Assertion|assertion";
  for (const Index i : {Index{6}, kNone}) {
    EXPECT_DEATH((void)mesh.to_vertex(Halfedge(i)), sentence);
    EXPECT_DEATH((void)mesh.face(Halfedge(i)), sentence);
    EXPECT_DEATH((void)mesh.next(Halfedge(i)), sentence);
    EXPECT_DEATH((void)mesh.prev(Halfedge(i)), sentence);
    EXPECT_DEATH((void)mesh.vertex_halfedge(Vertex(i)), sentence);
    EXPECT_DEATH((void)mesh.position(Vertex(i)), sentence);
    EXPECT_DEATH((void)mesh.face_halfedge(Face(i)), sentence);
  }
}

// Links of deleted items lead out of all arrays, so that none can be followed.
TEST(ConnectivityDeathTest, AssertsWhereALinkOfADeletedItemIsFollowed) {
  Mesh mesh = triangle_by_hand();
  const Vertex v = mesh.add_vertex({});
  mesh.release(v);
  mesh.release(Face(0));
  mesh.release(Edge(0));
  const char* sentence = "Assertion|assertion";
  for (const Halfedge h : {Halfedge(0), Halfedge(1)}) {
    EXPECT_FALSE(mesh.is_live(h));
    EXPECT_DEATH((void)mesh.vertex_halfedge(mesh.to_vertex(h)), sentence);
    EXPECT_DEATH((void)mesh.face_halfedge(mesh.face(h)), sentence);
    EXPECT_DEATH((void)mesh.next(mesh.next(h)), sentence);
    EXPECT_DEATH((void)mesh.prev(mesh.prev(h)), sentence);
    EXPECT_FALSE(mesh.is_boundary(h));
  }
  EXPECT_FALSE(mesh.is_live(v));
  EXPECT_DEATH((void)mesh.valence(v), sentence);
  EXPECT_FALSE(mesh.is_live(Face(0)));
  EXPECT_DEATH((void)mesh.degree(Face(0)), sentence);
}
#endif

TEST(DeletedLinks, KeepTheSignBitForEverySlot) {
  for (const Index next_free : {0U, 1U, kMaxSlots - 1}) {
    const Index link = kDeleted - 1 - next_free;
    EXPECT_TRUE(is_deleted_link(link));
    EXPECT_EQ(next_free_slot(link), next_free);
  }
  EXPECT_TRUE(is_deleted_link(kDeleted));
  EXPECT_EQ(next_free_slot(kDeleted), kNone);
  EXPECT_FALSE(is_deleted_link(kNone));
  EXPECT_FALSE(is_deleted_link(kMaxSlots - 1));
}

TEST(Array, ReportsARequestThatNoMemoryCanMeetAndKeepsItsContents) {
  Array<Index> array;
  ASSERT_TRUE(array.resize(3, 7));
  const std::size_t too_many = std::numeric_limits<std::size_t>::max() / sizeof(Index);
  EXPECT_FALSE(array.reserve(too_many));
  EXPECT_FALSE(array.resize(too_many));
  EXPECT_FALSE(array.resize(too_many, 1));
  EXPECT_EQ(array.size(), 3U);
  EXPECT_EQ(array[2], 7U);
  EXPECT_FALSE(array.recreate(too_many));
  EXPECT_TRUE(array.empty());
}

TEST(Array, GrowsAndShrinks) {
  Array<Index> array;
  for (Index i = 0; i < 100; ++i) ASSERT_TRUE(array.push_back(i));
  for (Index i = 0; i < 100; ++i) EXPECT_EQ(array[i], i);
  while (array.size() < array.capacity()) ASSERT_TRUE(array.push_back(0));
  ASSERT_TRUE(array.push_back(array[42]));  // a value from the array that has to move
  EXPECT_EQ(array[array.size() - 1], 42U);
  array.pop_back();
  ASSERT_TRUE(array.resize(2));
  ASSERT_TRUE(array.resize(4, array[1]));
  EXPECT_EQ(array[3], 1U);
  Array<Index> copy;
  ASSERT_TRUE(copy.assign(array.span()));
  EXPECT_EQ(copy.size(), 4U);
  EXPECT_EQ(copy[3], 1U);
  array.clear();
  EXPECT_TRUE(array.empty());
  EXPECT_GT(array.capacity(), 0U);
  array.reset();
  EXPECT_EQ(array.capacity(), 0U);
  ASSERT_TRUE(array.assign({}));
}

}  // namespace
}  // namespace halfedge::test
