#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/built.h"
#include "support/canonical.h"
#include "support/random_polygons.h"
#include "support/shapes.h"
#include "support/storages.h"

// The contract of docs/variants.md: what stays valid through insertion, removal, reserve, compact.

namespace halfedge::test {
namespace {

/// What each live item of a mesh says of itself, as far as it is stored.
struct Snapshot {
  std::vector<std::tuple<Index, Index, Index, Index, Index>> halfedges;
  std::vector<std::pair<Index, Index>> anchors;
  std::vector<std::pair<Index, Index>> firsts;
  std::vector<Point> positions;

  friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

/// Of the items below these counts of slots, so that items added later don't show.
template <class AnyMesh>
Snapshot snapshot(const AnyMesh& mesh, Index vertices, Index halfedges, Index faces) {
  Snapshot result;
  for (const Halfedge h : mesh.halfedges()) {
    if (h.index() >= halfedges) break;
    Index face = kNone;
    if constexpr (StoresFaces<AnyMesh>) face = mesh.face(h).index();
    result.halfedges.emplace_back(h.index(), mesh.next(h).index(), mesh.prev(h).index(),
                                  mesh.to_vertex(h).index(), face);
  }
  for (const Vertex v : mesh.vertices()) {
    if (v.index() >= vertices) break;
    result.positions.push_back(mesh.position(v));
    if constexpr (StoresAnchors<AnyMesh>) {
      result.anchors.emplace_back(v.index(), mesh.vertex_halfedge(v).index());
    }
  }
  for (const Face f : mesh.faces()) {
    if (f.index() >= faces) break;
    if constexpr (StoresFaceHalfedges<AnyMesh>) {
      result.firsts.emplace_back(f.index(), mesh.face_halfedge(f).index());
    }
  }
  return result;
}

template <class Kind>
class Stability : public testing::Test {};
TYPED_TEST_SUITE(Stability, AllStorages);

TYPED_TEST(Stability, HandlesStayThroughReserveAndInsertion) {
  auto mesh = built<BasicMesh<TypeParam::kStorage>>(torus(5, 4, 1));
  const Index vertices = mesh.vertex_slots();
  const Index halfedges = mesh.halfedge_slots();
  const Index faces = mesh.face_slots();
  const Snapshot before = snapshot(mesh, vertices, halfedges, faces);
  ASSERT_TRUE(mesh.reserve(5000, 5000, 5000));
  EXPECT_EQ(snapshot(mesh, vertices, halfedges, faces), before);
  for (int i = 0; i < 10'000; ++i) {
    const Vertex a = mesh.add_vertex({1, 2, 3});
    const Halfedge h = mesh.new_edge(a, mesh.new_vertex());
    if constexpr (TypeParam::kStorage.face) (void)mesh.new_face(h);
  }
  EXPECT_EQ(mesh.edge_count(), halfedges / 2 + 10'000);
  EXPECT_EQ(snapshot(mesh, vertices, halfedges, faces), before);
}

TYPED_TEST(Stability, HandlesStayThroughRemovalAndSlotsAreTakenAgain) {
  constexpr Storage kStored = TypeParam::kStorage;
  auto mesh = built<BasicMesh<kStored>>(cube());
  const Index vertices = mesh.vertex_slots();
  const Index halfedges = mesh.halfedge_slots();
  const Index faces = mesh.face_slots();
  const Snapshot before = snapshot(mesh, vertices, halfedges, faces);

  const Vertex a = mesh.new_vertex();
  const Vertex b = mesh.new_vertex();
  const Edge e = mesh.edge(mesh.new_edge(a, b));
  mesh.release(e);
  EXPECT_TRUE(mesh.is_deleted(e));
  EXPECT_FALSE(mesh.is_live(e));
  EXPECT_EQ(mesh.edge(mesh.new_edge(b, a)), e) << "a deleted slot is taken again";
  if constexpr (kStored.vertex_halfedge) {
    mesh.release(a);
    EXPECT_FALSE(mesh.is_live(a));
    EXPECT_EQ(mesh.new_vertex(), a);
  }
  if constexpr (kStored.face && kStored.face_halfedge) {
    const Face f = mesh.new_face(mesh.edge_halfedge(e));
    mesh.release(f);
    EXPECT_FALSE(mesh.is_live(f));
    EXPECT_EQ(mesh.new_face(mesh.edge_halfedge(e)), f);
  }
  EXPECT_EQ(snapshot(mesh, vertices, halfedges, faces), before);
}

/// Two shapes in one, and which items belong to the second, which is then deleted.
struct TwoParts {
  Shape kept;
  Shape both;

  TwoParts(Shape first, const Shape& second) : kept(std::move(first)), both(interleaved(second)) {}

  template <class AnyMesh>
  void delete_second(AnyMesh& mesh) const {
    const auto is_second = [](Vertex v) { return v.index() % 2 == 1; };
    if constexpr (StoresFaceHalfedges<AnyMesh>) {
      for (Index f = 0; f < mesh.face_slots(); ++f) {
        if (is_second(mesh.to_vertex(mesh.face_halfedge(Face(f))))) mesh.release(Face(f));
      }
    }
    for (Index e = 0; e < mesh.edge_slots(); ++e) {
      if (is_second(mesh.to_vertex(mesh.edge_halfedge(Edge(e))))) mesh.release(Edge(e));
    }
    for (Index v = 1; v < mesh.vertex_slots(); v += 2) mesh.release(Vertex(v));
  }

 private:
  // Even vertices are those of the first; faces come in turn.
  [[nodiscard]] Shape interleaved(const Shape& second) const {
    std::vector<std::vector<Index>> faces;
    for (std::size_t f = 0; f < std::max(kept.faces.size(), second.faces.size()); ++f) {
      for (const Index part : {0U, 1U}) {
        const Shape& shape = part == 0 ? kept : second;
        if (f >= shape.faces.size()) continue;
        faces.push_back(shape.faces[f]);
        for (Index& v : faces.back()) v = 2 * v + part;
      }
    }
    return {"two parts", 2 * std::max(kept.vertices, second.vertices), std::move(faces)};
  }
};

TEST(Stability, CompactClosesTheGapsAndSaysWhereItemsWent) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TwoParts parts(random_polygons(2 * seed), random_polygons(2 * seed + 1));
    Mesh mesh = built<Mesh>(parts.both);
    Mesh original;
    ASSERT_TRUE(original.assign(mesh));
    parts.delete_second(mesh);
    const Canonical before(mesh);
    const std::uint64_t version = mesh.version();

    Result<CompactMaps> result = compact(mesh);
    ASSERT_TRUE(result);
    const CompactMaps& maps = result.value();
    EXPECT_NE(mesh.version(), version);
    EXPECT_TRUE(validate(mesh, 3).empty());
    EXPECT_EQ(mesh.vertex_slots(), mesh.vertex_count());
    EXPECT_EQ(mesh.edge_slots(), mesh.edge_count());
    EXPECT_EQ(mesh.face_slots(), mesh.face_count());
    EXPECT_EQ(mesh.positions().size(), 3 * mesh.vertex_count());
    EXPECT_EQ(mesh.face_count(), parts.kept.faces.size());

    ASSERT_EQ(maps.vertices.size(), original.vertex_slots());
    for (const Vertex v : original.vertices()) {
      ASSERT_EQ(maps(v).valid(), v.index() % 2 == 0);
      if (!maps(v).valid()) continue;
      EXPECT_EQ(mesh.position(maps(v)), original.position(v));
    }
    for (const Halfedge h : original.halfedges()) {
      if (!maps(h).valid()) continue;
      EXPECT_EQ(mesh.next(maps(h)), maps(original.next(h)));
      EXPECT_EQ(mesh.prev(maps(h)), maps(original.prev(h)));
      EXPECT_EQ(mesh.to_vertex(maps(h)), maps(original.to_vertex(h)));
      EXPECT_EQ(mesh.edge(maps(h)), maps(original.edge(h)));
      EXPECT_EQ(mesh.face(maps(h)), maps(original.face(h)));  // empty on the boundary
    }
    EXPECT_FALSE(maps(Vertex{}).valid() || maps(Halfedge{}).valid() || maps(Edge{}).valid());
    for (const Face f : original.faces()) {
      if (!maps(f).valid()) continue;
      EXPECT_EQ(mesh.face_halfedge(maps(f)), maps(original.face_halfedge(f)));
    }
  }
}

TEST(Stability, CompactOfAReducedMeshIsTheReducedCompactMesh) {
  const TwoParts parts(random_polygons(3), random_polygons(4));
  Mesh whole = built<Mesh>(parts.both);
  auto mesh = built<BasicMesh<kWithoutPrev>>(parts.both);
  parts.delete_second(whole);
  parts.delete_second(mesh);
  ASSERT_TRUE(compact(whole));
  ASSERT_TRUE(compact(mesh));
  Mesh completed;
  ASSERT_TRUE(convert(std::move(mesh), completed));
  EXPECT_EQ(Canonical(completed).sides, Canonical(whole).sides);
  EXPECT_EQ(Canonical(completed).anchors, Canonical(whole).anchors);
  EXPECT_EQ(Canonical(completed).firsts, Canonical(whole).firsts);
}

/// A torus whose vertices aren't numbered as they lie.
template <class AnyMesh>
AnyMesh scattered_torus() {
  auto mesh = built<AnyMesh>(torus(6, 5, 1));
  Array<float>& positions = mesh.mutable_positions();
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = float(i * i % 101);
  return mesh;
}

TYPED_TEST(Stability, ReorderOfAReducedMeshLeavesTheSameMesh) {
  constexpr Storage kStored = TypeParam::kStorage;
  const Mesh before = scattered_torus<Mesh>();
  auto mesh = scattered_torus<BasicMesh<kStored>>();
  const CompactMaps maps = reorder(mesh).value();
  if constexpr (kStored.face || kStored.face_halfedge) {
    EXPECT_EQ(mesh.face_count(), before.face_count());
  }
  for (const Vertex v : before.vertices()) {
    EXPECT_EQ(mesh.position(maps(v)), before.position(v));
    if constexpr (kStored.vertex_halfedge) {
      EXPECT_EQ(mesh.vertex_halfedge(maps(v)), maps(before.vertex_halfedge(v)));
    }
  }
  for (const Halfedge h : before.halfedges()) {
    EXPECT_EQ(mesh.next(maps(h)), maps(before.next(h)));
    EXPECT_EQ(mesh.prev(maps(h)), maps(before.prev(h)));
    EXPECT_EQ(mesh.to_vertex(maps(h)), maps(before.to_vertex(h)));
    if constexpr (kStored.face) {
      EXPECT_EQ(mesh.face(maps(h)), maps(before.face(h)));
    }
  }
  if constexpr (kStored.face_halfedge) {
    for (const Face f : before.faces()) {
      EXPECT_EQ(mesh.face_halfedge(maps(f)), maps(before.face_halfedge(f)));
    }
  }
}

// The order needs faces of halfedges; without them, edges go by their vertices.
TYPED_TEST(Stability, ReorderOfAReducedMeshIsTheReducedReorderedMesh) {
  constexpr Storage kStored = TypeParam::kStorage;
  Mesh whole = scattered_torus<Mesh>();
  auto mesh = scattered_torus<BasicMesh<kStored>>();
  const CompactMaps of_whole = reorder(whole).value();
  const CompactMaps maps = reorder(mesh).value();
  for (const Vertex v : whole.vertices()) EXPECT_EQ(maps(v), of_whole(v));
  Index before = 0;
  for (const Halfedge h : whole.halfedges()) {
    if constexpr (kStored.face) {
      EXPECT_EQ(maps(h), of_whole(h));
    } else {
      const Index low = std::min(mesh.to_vertex(h), mesh.to_vertex(mesh.opposite(h))).index();
      EXPECT_LE(before, low);
      before = low;
    }
  }
}

TEST(Stability, CompactOfACompactMeshChangesNoIndex) {
  Mesh mesh = built<Mesh>(torus(4, 3));
  const Snapshot before = snapshot(mesh, kNone, kNone, kNone);
  Result<CompactMaps> maps = compact(mesh);
  ASSERT_TRUE(maps);
  EXPECT_EQ(snapshot(mesh, kNone, kNone, kNone), before);
  EXPECT_EQ(maps.value()(Halfedge(7)), Halfedge(7));
}

}  // namespace
}  // namespace halfedge::test
