#pragma once

#include <gtest/gtest.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "support/copies.h"

/// What holds after `compact` and `reorder`, which give items other slots.
namespace halfedge::test {

/// That the bytes of each item have moved with it; stamps of generations haven't.
template <class Item>
void expect_attributes(const Mesh& mesh, const Mesh& before, const CompactMaps& maps) {
  constexpr ItemKind kKind = kind_of(Item{});
  const std::span<const Attributes::Column> columns = mesh.attributes().of(kKind);
  ASSERT_EQ(columns.size(), before.attributes().of(kKind).size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Attribute& was = *before.attributes().of(kKind)[i];
    ASSERT_EQ(columns[i]->slots(), mesh.slots(kKind));
    if (was.is_generation()) continue;
    for (Index old = 0; old < before.slots(kKind); ++old) {
      if (before.is_deleted(Item(old))) continue;
      ASSERT_EQ(columns[i]->value(maps(Item(old)).index()), was.value(old))
          << name_of(kKind) << " " << old << ", " << was.name();
    }
  }
}

/// That live items have gone to slots of their own, of which there are no others.
inline void expect_permutation(const Array<Index>& map, Index live) {
  std::vector<Index> slots;
  for (const Index slot : map) {
    if (slot != kNone) slots.push_back(slot);
  }
  std::sort(slots.begin(), slots.end());
  std::vector<Index> all(live);
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(slots, all);
}

/// That `mesh` is `before`, whose items are where the maps say, and has no gaps.
inline void expect_renumbered(const Mesh& mesh, const Mesh& before, const CompactMaps& maps) {
  EXPECT_EQ(mesh.vertex_slots(), before.vertex_count());
  EXPECT_EQ(mesh.edge_slots(), before.edge_count());
  EXPECT_EQ(mesh.face_slots(), before.face_count());
  EXPECT_EQ(mesh.vertex_count(), before.vertex_count());
  EXPECT_EQ(mesh.edge_count(), before.edge_count());
  EXPECT_EQ(mesh.face_count(), before.face_count());
  EXPECT_EQ(mesh.positions().size(), 3 * std::size_t{mesh.vertex_slots()});
  ASSERT_EQ(maps.vertices.size(), before.vertex_slots());
  ASSERT_EQ(maps.edges.size(), before.edge_slots());
  ASSERT_EQ(maps.faces.size(), before.face_slots());
  expect_permutation(maps.vertices, before.vertex_count());
  expect_permutation(maps.edges, before.edge_count());
  expect_permutation(maps.faces, before.face_count());
  expect_copy(mesh, before, maps);
  expect_attributes<Vertex>(mesh, before, maps);
  expect_attributes<Halfedge>(mesh, before, maps);
  expect_attributes<Edge>(mesh, before, maps);
  expect_attributes<Face>(mesh, before, maps);
}

}  // namespace halfedge::test
