// Many operations in a row: the same as a plain loop.

#include <gtest/gtest.h>
#include <halfedge/operations/operations.h>

#include <span>
#include <string>
#include <vector>

#include "support/complexes.h"

namespace halfedge::test {
namespace {

using namespace operations;

template <class Item>
std::vector<Item> all_slots(Index count) {
  std::vector<Item> items;
  for (Index i = 0; i < count; ++i) items.emplace_back(i);
  return items;
}

/// What `edit` says of each item, in a plain loop and in `for_each`; the meshes are the same then.
template <class Item, class Edit>
void expect_same_as_a_loop(const Mesh& mesh, const std::vector<Item>& items, const Edit& edit) {
  Mesh looped = copy_of(mesh);
  std::vector<std::string> expected;
  for (const Item item : items) expected.push_back(edit(looped, item));

  Mesh fetched = copy_of(mesh);
  std::vector<std::string> said;
  for_each(fetched, std::span<const Item>(items),
           [&](Item item) { said.push_back(edit(fetched, item)); });
  EXPECT_EQ(said, expected);
  EXPECT_TRUE(Snapshot(fetched) == Snapshot(looped));
}

template <class Result>
std::string code_of(const Result& result) {
  return std::string(result ? "" : result.error().code);
}

TEST(ForEach, IsTheSameAsALoopThatAddsAndDeletesWhatIsYetToCome) {
  for (const auto& [name, mesh] : all_complexes()) {
    SCOPED_TRACE(name);
    const auto faces = all_slots<Face>(mesh.face_slots() + 3);  // three of them don't exist
    expect_same_as_a_loop(mesh, faces, [](Mesh& m, Face f) { return code_of(split_face(m, f)); });
    expect_same_as_a_loop(mesh, faces, [](Mesh& m, Face f) {
      if (f.index() % 3 != 0) return code_of(split_face(m, f));
      const Face later(f.index() + 2);
      return m.is_live(later) ? code_of(delete_face(m, later)) : std::string("gone");
    });
    const auto edges = all_slots<Edge>(mesh.edge_slots() + 3);
    expect_same_as_a_loop(mesh, edges, [](Mesh& m, Edge e) { return code_of(flip_edge(m, e)); });
    expect_same_as_a_loop(mesh, edges, [](Mesh& m, Edge e) {
      return m.is_live(e) ? code_of(collapse(m, m.edge_halfedge(e))) : std::string("gone");
    });
  }
}

TEST(ForEach, CallsForEachItemOnceInOrder) {
  const Mesh mesh = reference_build(triangle_grid(3, 3));
  for (Index count = 0; count <= mesh.face_count(); ++count) {
    const auto faces = all_slots<Face>(count);
    std::vector<Face> called;
    for_each(mesh, std::span<const Face>(faces), [&](Face f) { called.push_back(f); });
    EXPECT_EQ(called, faces);
  }
  const std::vector<Face> empty_handle{Face{}};
  for_each(mesh, std::span<const Face>(empty_handle), [](Face f) { EXPECT_FALSE(f.valid()); });
}

TEST(ForEach, WorksWithoutPrev) {
  BasicMesh<kWithoutPrev> light;
  ASSERT_TRUE(convert(reference_build(triangle_grid(3, 3)), light));
  const Index edges = light.edge_slots();
  Index flipped = 0;
  for_each(light, std::span<const Edge>(all_slots<Edge>(edges)),
           [&](Edge e) { flipped += flip_edge(light, e).ok() ? 1 : 0; });
  EXPECT_GT(flipped, 0U);
  EXPECT_TRUE(validate(light).empty());
}

TEST(ForEach, TakesAVectorAnArrayAndASpan) {
  const Mesh mesh = reference_build(pillow());
  std::vector<Edge> edges = all_slots<Edge>(mesh.edge_slots());
  const Edge two[] = {edges[2], edges[0]};
  std::vector<Edge> seen;
  const auto see = [&](Edge e) { seen.push_back(e); };
  for_each(mesh, edges, see);
  EXPECT_EQ(seen, edges);
  for_each(mesh, two, see);
  for_each(mesh, std::span(edges).first(1), see);
  for_each(mesh, std::span<const Edge>(edges).last(1), see);
  edges.insert(edges.end(), {edges[2], edges[0], edges[0], edges[2]});
  EXPECT_EQ(seen, edges);
}

}  // namespace
}  // namespace halfedge::test
