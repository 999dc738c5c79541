#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "support/complexes.h"
#include "support/copies.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

template <class Mesh>
std::vector<Index> all_faces(const Mesh& mesh) {
  std::vector<Index> faces;
  for (const Face f : mesh.faces()) faces.push_back(f.index());
  return faces;
}

/// Where each slot of `mesh` went.
CompactMaps maps_of(const Mesh& mesh, const ItemSet& items) {
  CompactMaps maps;
  const auto fill = [](Array<Index>& map, Index slots, const Array<Index>& kept) {
    EXPECT_TRUE(map.resize(slots, kNone));
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    for (Index i = 0; i < kept.size(); ++i) map[kept[i]] = i;
  };
  fill(maps.vertices, mesh.vertex_slots(), items.vertices);
  fill(maps.edges, mesh.edge_slots(), items.edges);
  fill(maps.faces, mesh.face_slots(), items.faces);
  return maps;
}

/// The mesh after all other faces were deleted one by one, in random order, and vertices that no
/// face is at. Faces that can't be deleted are added to `faces`.
Mesh with_others_deleted(const Mesh& mesh, std::vector<Index>& faces, std::mt19937& random) {
  Mesh rest = copy_of(mesh);
  std::vector<Index> others;
  for (const Index f : all_faces(mesh)) {
    if (std::find(faces.begin(), faces.end(), f) == faces.end()) others.push_back(f);
  }
  std::shuffle(others.begin(), others.end(), random);
  for (const Index f : others) {
    if (!operations::delete_face(rest, Face(f))) faces.push_back(f);
  }
  for (const Vertex v : mesh.vertices()) {
    if (rest.is_live(v) && rest.is_isolated(v)) rest.release(v);
  }
  return rest;
}

Index gaps_at(const Mesh& mesh, Vertex v) {
  Index gaps = 0;
  for (const Halfedge h : mesh.outgoing_cw(v)) gaps += mesh.is_boundary(h) ? 1 : 0;
  return gaps;
}

/// That `part` has the links of `rest`, where each of them went.
void expect_same_links(const Mesh& part, const Mesh& rest, const CompactMaps& maps) {
  ASSERT_EQ(part.vertex_slots(), rest.vertex_count());
  ASSERT_EQ(part.edge_slots(), rest.edge_count());
  ASSERT_EQ(part.face_slots(), rest.face_count());
  for (const Vertex v : rest.vertices()) {
    const Vertex to = maps(v);
    ASSERT_EQ(part.position(to), rest.position(v));
    // With several gaps at a vertex, its anchor lies in any of them.
    if (gaps_at(rest, v) < 2) ASSERT_EQ(part.vertex_halfedge(to), maps(rest.vertex_halfedge(v)));
    ASSERT_EQ(part.is_boundary(to), rest.is_boundary(v));
  }
  for (const Halfedge h : rest.halfedges()) {
    ASSERT_EQ(part.next(maps(h)), maps(rest.next(h)));
    ASSERT_EQ(part.prev(maps(h)), maps(rest.prev(h)));
    ASSERT_EQ(part.to_vertex(maps(h)), maps(rest.to_vertex(h)));
    ASSERT_EQ(part.face(maps(h)), maps(rest.face(h)));
  }
  for (const Face f : rest.faces()) {
    ASSERT_EQ(part.face_halfedge(maps(f)), maps(rest.face_halfedge(f)));
  }
}

TEST(Extract, LeavesWhatIsLeftWhenAllOtherFacesAreDeleted) {
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < 60; ++seed) shapes.push_back(random_polygons(seed));
  std::mt19937 random(1);
  int pinched_vertices = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE(shapes[i].name + ", " + std::to_string(i));
    const Mesh mesh = with_gaps(shapes[i], std::uint32_t(i));
    for (const unsigned of_8 : {1U, 4U, 7U, 8U}) {
      std::vector<Index> faces;
      for (const Index f : all_faces(mesh)) {
        if (random() % 8 < of_8) faces.push_back(f);
      }
      const Mesh rest = with_others_deleted(mesh, faces, random);
      Mesh part;
      const Result<ItemSet> items = extract(mesh, faces, part);
      ASSERT_TRUE(items.ok()) << items.error().message;
      EXPECT_FALSE(has_errors(validate(part, 2)));
      expect_same_links(part, rest, maps_of(mesh, items.value()));
      for (const Vertex v : part.vertices()) pinched_vertices += gaps_at(part, v) > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(pinched_vertices, 100);  // else the hard case wasn't there
}

TEST(Extract, OfAllFacesIsACompactCopyWithTheSameAnchors) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = with_gaps(random_polygons(seed), seed);
    for (Index v = 0; v < mesh.vertex_slots(); ++v) {
      if (mesh.is_live(Vertex(v)) && mesh.is_isolated(Vertex(v))) mesh.release(Vertex(v));
    }
    Mesh part;
    const ItemSet items = extract(mesh, all_faces(mesh), part).value();
    EXPECT_FALSE(has_errors(validate(part, 2)));
    expect_copy(part, mesh, maps_of(mesh, items));
  }
}

TEST(Extract, TakesFacesInAnyOrderAndWithRepetitions) {
  const Mesh mesh = with_gaps(torus(6, 5, 1), 4);
  std::vector<Index> faces = all_faces(mesh);
  faces.resize(faces.size() / 2);
  Mesh part;
  const ItemSet items = extract(mesh, faces, part).value();
  faces.insert(faces.end(), faces.begin(), faces.end());
  std::shuffle(faces.begin(), faces.end(), std::mt19937(1));
  Mesh again;
  const ItemSet same = extract(mesh, faces, again).value();
  EXPECT_TRUE(
      std::equal(items.faces.begin(), items.faces.end(), same.faces.begin(), same.faces.end()));
  EXPECT_EQ(Snapshot(again), Snapshot(part));
}

TEST(Extract, TakesHandlesAsWellAsIndices) {
  const Mesh mesh = reference_build(torus(6, 5, 1));
  const std::vector<Index> indices = {7, 3, 8};
  const std::vector<Face> faces = {Face(7), Face(3), Face(8)};
  Mesh of_indices;
  Mesh of_faces;
  (void)extract(mesh, indices, of_indices).value();
  (void)extract(mesh, faces, of_faces).value();
  EXPECT_EQ(Snapshot(of_faces), Snapshot(of_indices));
  EXPECT_EQ(of_faces.face_count(), 3U);
  Mesh of_one;
  EXPECT_EQ(extract(mesh, Face(7), of_one).value().faces[0], 7U);
  EXPECT_EQ(of_one.face_count(), 1U);
  // What another function returned.
  ASSERT_TRUE(extract(mesh, star(mesh, {.vertices = Vertex(4)}).value().faces, of_one));
  EXPECT_EQ(of_one.vertex_count(), 9U);
}

TEST(Extract, OfNoFacesIsTheEmptyMesh) {
  const Mesh mesh = reference_build(cube());
  Mesh part = reference_build(tetrahedron());
  const ItemSet items = extract(mesh, {}, part).value();
  EXPECT_EQ(items.vertices.size() + items.edges.size() + items.faces.size(), 0U);
  EXPECT_EQ(part.vertex_slots() + part.halfedge_slots() + part.face_slots(), 0U);
  EXPECT_TRUE(part.positions().empty());
}

TEST(Extract, CanReplaceTheMeshItIsTakenFrom) {
  Mesh mesh = with_gaps(torus(6, 5, 1), 4);
  const std::vector<Index> faces = {all_faces(mesh)[3], all_faces(mesh)[0]};
  Mesh part;
  (void)extract(mesh, faces, part).value();
  ASSERT_TRUE(mesh.enable_history());
  const ItemSet items = extract(mesh, faces, mesh).value();
  EXPECT_EQ(mesh.face_slots(), 2U);
  EXPECT_EQ(items.faces.size(), 2U);
  EXPECT_EQ(Snapshot(mesh), Snapshot(part));
  EXPECT_EQ(mesh.history(), nullptr);
}

TEST(Extract, WorksAcrossStorageOptions) {
  const Mesh whole = with_gaps(torus(6, 5, 1), 4);
  std::vector<Index> faces = all_faces(whole);
  faces.resize(faces.size() / 2);
  Mesh part;
  (void)extract(whole, faces, part).value();
  BasicMesh<kWithoutPrev> lean;
  (void)extract(whole, faces, lean).value();
  EXPECT_TRUE(lean.links().prev.empty());
  for (const bool stores_prev : {true, false}) {
    BasicMesh<kPrevAtRunTime> either;
    either.choose_prev(stores_prev);
    (void)extract(whole, faces, either).value();
    EXPECT_EQ(either.stores_prev(), stores_prev);
    EXPECT_EQ(either.links().prev.size(), stores_prev ? part.halfedge_slots() : 0U);
    EXPECT_FALSE(has_errors(validate(either, 2)));
    Mesh again;
    (void)extract(lean, all_faces(lean), again).value();
    EXPECT_EQ(Snapshot(again), Snapshot(part));
  }
}

TEST(Extract, CopiesAttributesOfAllKindsWithTheirOptions) {
  Mesh mesh = reference_build(torus(5, 4, 1));
  ASSERT_TRUE(mesh.enable_generations());
  constexpr Scalar kTypes[] = {Scalar::kFloat64, Scalar::kInt8, Scalar::kUint32, Scalar::kFloat32};
  constexpr ItemKind kKinds[] = {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge,
                                 ItemKind::kFace};
  const double default_value[] = {3, 7};
  for (std::size_t k = 0; k < 4; ++k) {
    Attribute& column = *mesh.add_attribute(kKinds[k], "two numbers",
                                            {.type = kTypes[k],
                                             .components = 2,
                                             .on_split = OnSplit::kCopy,
                                             .default_value = default_value})
                             .value();
    for (Index i = 0; i < column.slots(); ++i) {
      column.set(i, 0, i, nullptr);
      column.set(i, 1, 120 - i, nullptr);
    }
  }
  Mesh part;
  const std::vector<Index> faces = {7, 8, 13};
  const ItemSet items = extract(mesh, faces, part).value();
  for (std::size_t k = 0; k < 4; ++k) {
    const Attribute* const column = part.find_attribute(kKinds[k], "two numbers");
    ASSERT_NE(column, nullptr);
    EXPECT_EQ(column->type(), kTypes[k]);
    EXPECT_EQ(column->on_split(), OnSplit::kCopy);
    EXPECT_EQ(column->components(), 2U);
    EXPECT_EQ(column->slots(), part.slots(kKinds[k]));
    EXPECT_EQ(column->default_value(0), 3);
    EXPECT_EQ(column->default_value(1), 7);
    for (Index i = 0; i < column->slots(); ++i) {
      const Index from = kKinds[k] == ItemKind::kVertex     ? items.vertices[i]
                         : kKinds[k] == ItemKind::kFace     ? items.faces[i]
                         : kKinds[k] == ItemKind::kHalfedge ? 2 * items.edges[i / 2] + i % 2
                                                            : items.edges[i];
      EXPECT_EQ(column->get(i, 0), from);
      EXPECT_EQ(column->get(i, 1), 120.0 - from);
    }
    EXPECT_EQ(part.find_attribute(kKinds[k], "generation"), nullptr);
  }
  // New items get the default: the column is as good as one that was added.
  EXPECT_EQ(
      part.find_attribute(ItemKind::kVertex, "two numbers")->get(part.add_vertex({}).index(), 1),
      7);
}

TEST(Extract, NamesTheFaceThatIsNone) {
  Mesh mesh = reference_build(cube());
  ASSERT_TRUE(operations::delete_face(mesh, Face(2)));
  Mesh part = reference_build(tetrahedron());
  const Snapshot before(part);
  const std::vector<Index> missing = {1, 9};
  const std::vector<Index> deleted = {1, 3, 2};
  const Result<ItemSet> of_missing = extract(mesh, missing, part);
  const Result<ItemSet> of_deleted = extract(mesh, deleted, part);
  EXPECT_EQ(of_missing.error().code, "index-out-of-range");
  EXPECT_EQ(of_missing.error().message,
            "Face 9 at position 1 does not exist, expected less than 6.");
  EXPECT_EQ(of_deleted.error().code, "deleted-item");
  EXPECT_EQ(of_deleted.error().message, "Face 2 at position 2 is deleted.");
  EXPECT_EQ(Snapshot(part), before);
}

TEST(Extract, OfACorruptMeshIsAnErrorOrHasLinksThatLeadToItems) {
  std::mt19937 random(1);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    Mesh mesh = with_gaps(round % 2 == 0 ? cube() : torus(5, 4, 1), 2);
    std::vector<Index> faces = all_faces(mesh);
    faces.resize(faces.size() / 2);
    Links& links = mesh.mutable_links();
    Array<Index>* const arrays[] = {&links.next, &links.to_vertex, &links.face,
                                    &links.vertex_halfedge, &links.face_halfedge};
    for (unsigned i = 0; i <= random() % 3; ++i) {
      Array<Index>& array = *arrays[random() % 5];
      const std::size_t at = random() % array.size();
      if (is_deleted_link(array[at])) continue;
      array[at] = random() % 3 == 0 ? Index(random()) : Index(random() % 40);
    }
    std::erase_if(faces, [&](Index f) { return mesh.is_deleted(Face(f)); });
    Mesh part;
    const Result<ItemSet> items = extract(mesh, faces, part);
    if (!items) {
      EXPECT_EQ(items.error().code, "corrupt-connectivity");
      EXPECT_EQ(part.halfedge_slots(), 0U);
      ++refused;
      continue;
    }
    for (const Halfedge h : part.halfedges()) {
      ASSERT_LT(part.next(h).index(), part.halfedge_slots());
      ASSERT_EQ(part.prev(part.next(h)), h);
      ASSERT_LT(part.to_vertex(h).index(), part.vertex_slots());
      ASSERT_TRUE(part.is_boundary(h) || part.face(h).index() < part.face_slots());
    }
    for (const Vertex v : part.vertices()) {
      ASSERT_LT(part.vertex_halfedge(v).index(), part.halfedge_slots());
    }
    for (const Face f : part.faces()) {
      ASSERT_LT(part.face_halfedge(f).index(), part.halfedge_slots());
    }
  }
  EXPECT_GT(refused, 500);
  EXPECT_LT(refused, 2900);
}

}  // namespace
}  // namespace halfedge::test
