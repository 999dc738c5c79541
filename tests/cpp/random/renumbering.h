#pragma once

#include <gtest/gtest.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/operations/reorder.h>
#include <halfedge/validate/validate.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "random/operation.h"
#include "support/complexes.h"
#include "support/renumbered.h"

/// What gives items other slots. These are no operations like the others: all handles of before are
/// of other items afterwards, or of none, and only the maps tell which.
namespace halfedge::test {

enum class Renumbering : std::uint8_t { kCompact, kReorder, kReorderBreadthFirst };

inline constexpr std::array kRenumberings = {Renumbering::kCompact, Renumbering::kReorder,
                                             Renumbering::kReorderBreadthFirst};

inline const char* name_of(Renumbering how) {
  constexpr const char* kNames[] = {"compact", "reorder", "reorder_breadth_first"};
  return kNames[std::size_t(how)];
}

template <class AnyMesh>
Result<CompactMaps> renumber(AnyMesh& mesh, Renumbering how) {
  switch (how) {
    case Renumbering::kCompact:
      return compact(mesh);
    case Renumbering::kReorder:
      return reorder(mesh);
    case Renumbering::kReorderBreadthFirst:
      break;
  }
  return reorder_breadth_first(mesh);
}

/// All items have other stamps than before; or the same, if nothing has changed.
template <class Item>
void expect_generations_ended(const Mesh& mesh, const Mesh& before, const CompactMaps& maps,
                              bool has_changed) {
  for (Index old = 0; old < before.slots(Item{}); ++old) {
    if (before.is_deleted(Item(old))) continue;
    const bool is_same = mesh.generation(maps(Item(old))) == before.generation(Item(old));
    EXPECT_EQ(is_same, !has_changed) << name_of(kind_of(Item{})) << " " << old;
  }
}

/// Renumbers a mesh, and says whether that has changed any of its arrays: it is valid and the same,
/// but for its slots. pre: generations are enabled
inline bool expect_renumbers(Mesh& mesh, Renumbering how) {
  const Mesh before = copy_of(mesh);
  const Snapshot arrays(mesh);
  const std::uint64_t version = mesh.version();
  Result<CompactMaps> done = renumber(mesh, how);
  EXPECT_TRUE(done);
  if (!done) return false;
  const CompactMaps maps = std::move(done).value();
  const bool has_changed = !(Snapshot(mesh) == arrays);
  EXPECT_EQ(mesh.version() != version, has_changed);
  EXPECT_FALSE(has_errors(validate(mesh)));
  expect_renumbered(mesh, before, maps);
  expect_generations_ended<Vertex>(mesh, before, maps, has_changed);
  expect_generations_ended<Edge>(mesh, before, maps, has_changed);
  expect_generations_ended<Face>(mesh, before, maps, has_changed);
  return has_changed;
}

}  // namespace halfedge::test
