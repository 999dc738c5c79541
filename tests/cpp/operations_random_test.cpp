// Random sequences of operations of all kinds, on meshes of each topology, with items renumbered in
// between. After each step the mesh is valid, what the operation doesn't name is as it was, and a
// refusal has changed nothing; taken back step by step, all arrays are as they were, to the last
// byte.
//
// HALFEDGE_RANDOM_SEED=7 runs the sequences of one seed, HALFEDGE_RANDOM_STEPS=10000 longer ones,
// and tells how often each operation was done.

#include <gtest/gtest.h>
#include <halfedge/connectivity/convert.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "random/operation.h"
#include "random/renumbering.h"
#include "random/sequence.h"
#include "support/complexes.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/same_but_prev.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

std::size_t number_from(const char* variable, std::size_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::size_t(std::strtoul(text, nullptr, 10));
}

std::vector<std::uint32_t> seeds() {
  if (std::getenv("HALFEDGE_RANDOM_SEED") != nullptr) {
    return {std::uint32_t(number_from("HALFEDGE_RANDOM_SEED", 0))};
  }
  return {1, 2};
}

// Closed, bounded, of mixed polygons, pinched, in several components, and of genus 0, 1 and 2.
std::vector<std::pair<std::string, Mesh>> meshes(std::uint32_t seed) {
  std::vector<std::pair<std::string, Mesh>> all;
  for (const Shape& shape :
       {tetrahedron(), cube(), torus(4, 4), torus(5, 4, 1), annulus(5), pinched(3),
        mixed_polygons(), triangle_grid(4, 3), two_components(), random_polygons(seed)}) {
    all.emplace_back(shape.name, reference_build(shape));
  }
  all.emplace_back("genus two", genus_two());
  return all;
}

TEST(RandomOperations, KeepTheMeshValidAndCanBeTakenBack) {
  const std::size_t steps = number_from("HALFEDGE_RANDOM_STEPS", 500);
  Tally tally;
  for (const std::uint32_t seed : seeds()) {
    for (auto& [name, start] : meshes(seed)) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Mesh mesh = copy_with_attributes(start);
      Sequence sequence(Draw(seed), std::max<Index>(40, mesh.edge_count()));
      run_sequence(mesh, sequence, steps, tally);
      if (testing::Test::HasFailure()) return;
    }
  }
  std::vector<std::string> names;
  for (const Operation& op : all_operations()) names.push_back(op.name);
  for (const Renumbering how : kRenumberings) names.emplace_back(name_of(how));
  for (const std::string& name : names) {
    const auto [successes, refusals] = tally[name];
    if (std::getenv("HALFEDGE_RANDOM_STEPS") != nullptr) {
      std::cout << "  " << name << ": " << successes << " done, " << refusals << " refused\n";
    } else {
      EXPECT_GT(successes, 0U) << name << " was never done";
    }
  }
}

// All links but prev, the positions and the attributes.
void expect_same(const Mesh& mesh, const MeshWithoutPrev& other) {
  expect_same_but_prev(mesh, other);
  for (const ItemKind kind :
       {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
    for (std::size_t i = 0; i < mesh.attributes().of(kind).size(); ++i) {
      EXPECT_TRUE(
          same(mesh.attributes().of(kind)[i]->bytes(), other.attributes().of(kind)[i]->bytes()))
          << mesh.attributes().of(kind)[i]->name();
    }
  }
}

// This one without history.
TEST(RandomOperations, DoTheSameToAMeshWithoutPrev) {
  const std::size_t steps = number_from("HALFEDGE_RANDOM_STEPS", 500);
  for (const std::uint32_t seed : seeds()) {
    for (auto& [name, start] : meshes(seed)) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Mesh mesh = copy_of(start);
      add_attributes_of_all_kinds(mesh);
      ASSERT_TRUE(mesh.enable_generations());
      MeshWithoutPrev other;
      ASSERT_TRUE(convert(copy_of(mesh), other));
      Sequence sequence(Draw(seed + 100), std::max<Index>(40, mesh.edge_count()));
      for (std::size_t step = 0; step < steps; ++step) {
        if (const std::optional<Renumbering> how = sequence.renumbering()) {
          SCOPED_TRACE("step " + std::to_string(step) + ": " + name_of(*how));
          (void)expect_renumbers(mesh, *how);
          ASSERT_TRUE(renumber(other, *how));
          expect_same(mesh, other);
          if (testing::Test::HasFailure()) return;
          continue;
        }
        const auto [op, call] = sequence.next(mesh);
        SCOPED_TRACE("step " + std::to_string(step) + ": " + to_string(*op, call));
        const bool can = op->check_without_prev(other, call).ok();
        const Result<void> done = op->run(mesh, call);
        const Result<void> same = op->run_without_prev(other, call);
        ASSERT_EQ(can, done.ok());
        ASSERT_EQ(same.ok(), done.ok());
        if (done.ok()) {
          expect_same(mesh, other);
        } else {
          EXPECT_EQ(same.error().message, done.error().message);
        }
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

}  // namespace

}  // namespace halfedge::test
