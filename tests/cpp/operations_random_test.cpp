// Random sequences of operations of all kinds, on meshes of each topology. After each step the mesh
// is valid, what the operation doesn't name is as it was, and a refusal has changed nothing; taken
// back step by step, all arrays are as they were, to the last byte.
//
// HALFEDGE_RANDOM_SEED=7 runs the sequences of one seed, HALFEDGE_RANDOM_STEPS=10000 longer ones,
// and tells how often each operation was done.

#include <gtest/gtest.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/connectivity/convert.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "random/checks.h"
#include "random/operation.h"
#include "support/complexes.h"
#include "support/invariants.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
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

std::string to_string(const Operation& op, const Call& call) {
  std::string text = op.name + "(";
  const auto add = [&](const char* name, auto item) {
    if (item.valid()) text += std::string(name) + " " + std::to_string(item.index()) + ", ";
  };
  add("v", call.v);
  add("h", call.h);
  add("g", call.g);
  add("e", call.e);
  add("f", call.f);
  for (const Halfedge h : call.path) add("", h);
  for (const Vertex v : call.corners) add("", v);
  return text + (call.option ? "option)" : ")");
}

// Draws operations and their arguments so that the mesh stays about as large as `size` edges.
class Sequence {
 public:
  Sequence(std::uint32_t seed, Index size) : draw_(seed), size_(size) {}

  std::pair<const Operation*, Call> next(const Mesh& mesh) {
    const Operations& all = all_operations();
    const bool shrink = draw_.below(2 * size_) < mesh.edge_count();
    for (;;) {
      const Operation& op = all[draw_.below(all.size())];
      if (op.growth == (shrink ? Growth::kGrows : Growth::kShrinks)) continue;
      if (!draw_.one_in(op.rarity)) continue;
      Call call;
      op.draw(mesh, draw_, call);
      return {&op, call};
    }
  }
  bool one_in(std::size_t count) { return draw_.one_in(count); }

 private:
  Draw draw_;
  Index size_;
};

Mesh copy_with_attributes(const Mesh& mesh) {
  Mesh copy = copy_of(mesh);
  add_attributes_of_all_kinds(copy);
  EXPECT_TRUE(copy.enable_generations());
  EXPECT_TRUE(copy.enable_history());
  return copy;
}

void expect_success(const Mesh& before, const Mesh& after, const Operation& op, const Call& call) {
  const std::vector<Problem> problems = validate(after);
  for (const Problem& problem : problems) {
    EXPECT_NE(problem.severity, Severity::kError) << problem.message;
  }
  if (has_errors(problems)) return;
  if (op.euler) {
    EXPECT_EQ(euler_characteristic(after) - euler_characteristic(before), *op.euler);
  }
  expect_only_named_items_deleted(before, after, op, call);
  expect_rest_unchanged(before, after, op, call);
  expect_defined_values(after);
}

// How often each operation was done and refused.
using Tally = std::map<std::string, std::pair<std::size_t, std::size_t>>;

void run_sequence(Mesh& mesh, Sequence& sequence, std::size_t steps, Tally& tally) {
  std::vector<Snapshot> states{Snapshot(mesh)};
  for (std::size_t step = 0; step < steps; ++step) {
    if (sequence.one_in(40)) {
      ASSERT_TRUE(compact(mesh));
      mesh.end_step();
      if (mesh.history()->undo_count() == states.size()) states.emplace_back(mesh);
      ASSERT_FALSE(has_errors(validate(mesh)));
      continue;
    }
    const auto [op, call] = sequence.next(mesh);
    SCOPED_TRACE("step " + std::to_string(step) + ": " + to_string(*op, call));
    const Mesh before = copy_of(mesh);
    const Result<void> can = op->check(mesh, call);
    const Result<void> done = op->run(mesh, call);
    mesh.end_step();
    auto& [successes, refusals] = tally[op->name];
    ++(done.ok() ? successes : refusals);
    ASSERT_EQ(can.ok(), done.ok()) << (can.ok() ? done : can).error().message;
    if (!done.ok()) {
      EXPECT_EQ(can.error().code, done.error().code);
      EXPECT_EQ(can.error().message, done.error().message);
      expect_refused(done, can.error().code, mesh, states.back());
      ASSERT_EQ(mesh.history()->undo_count() + 1, states.size());
    } else {
      expect_success(before, mesh, *op, call);
      if (mesh.halfedge_slots() < 160 && step % 4 == 0) {
        EXPECT_TRUE(Invariants(mesh).hold());
      }
      const Snapshot now(mesh);
      ASSERT_EQ(mesh.history()->undo_count() + 1, states.size() + (now == states.back() ? 0 : 1));
      if (!(now == states.back())) states.push_back(now);
    }
    if (testing::Test::HasFailure()) return;
  }

  const std::size_t undoable = states.size() - 1;
  ASSERT_EQ(mesh.history()->undo_count(), undoable);
  for (std::size_t step = undoable; step > 0; --step) {
    ASSERT_TRUE(mesh.undo());
    ASSERT_TRUE(Snapshot(mesh) == states[step - 1]) << "after taking back step " << step;
  }
  ASSERT_FALSE(mesh.undo());
  for (std::size_t step = 1; step <= undoable; ++step) {
    ASSERT_TRUE(mesh.redo());
    ASSERT_TRUE(Snapshot(mesh) == states[step]) << "after doing step " << step << " again";
  }
}

TEST(RandomOperations, KeepTheMeshValidAndCanBeTakenBack) {
  const std::size_t steps = number_from("HALFEDGE_RANDOM_STEPS", 500);
  Tally tally;
  for (const std::uint32_t seed : seeds()) {
    for (auto& [name, start] : meshes(seed)) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Mesh mesh = copy_with_attributes(start);
      Sequence sequence(seed, std::max<Index>(40, mesh.edge_count()));
      run_sequence(mesh, sequence, steps, tally);
      if (testing::Test::HasFailure()) return;
    }
  }
  for (const Operation& op : all_operations()) {
    const auto [successes, refusals] = tally[op.name];
    if (std::getenv("HALFEDGE_RANDOM_STEPS") != nullptr) {
      std::cout << "  " << op.name << ": " << successes << " done, " << refusals << " refused\n";
    } else {
      EXPECT_GT(successes, 0U) << op.name << " was never done";
    }
  }
}

// All links but prev, and the positions.
void expect_same(const Mesh& mesh, const MeshWithoutPrev& other) {
  const auto same = [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  };
  EXPECT_TRUE(same(mesh.links().next, other.links().next));
  EXPECT_TRUE(same(mesh.links().to_vertex, other.links().to_vertex));
  EXPECT_TRUE(same(mesh.links().face, other.links().face));
  EXPECT_TRUE(same(mesh.links().vertex_halfedge, other.links().vertex_halfedge));
  EXPECT_TRUE(same(mesh.links().face_halfedge, other.links().face_halfedge));
  EXPECT_TRUE(same(mesh.positions(), other.positions()));
  for (const ItemKind kind :
       {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
    for (std::size_t i = 0; i < mesh.attributes().of(kind).size(); ++i) {
      EXPECT_TRUE(
          same(mesh.attributes().of(kind)[i]->bytes(), other.attributes().of(kind)[i]->bytes()))
          << mesh.attributes().of(kind)[i]->name();
    }
  }
}

TEST(RandomOperations, DoTheSameToAMeshWithoutPrev) {
  const std::size_t steps = number_from("HALFEDGE_RANDOM_STEPS", 500);
  for (const std::uint32_t seed : seeds()) {
    for (auto& [name, start] : meshes(seed)) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Mesh mesh = copy_of(start);
      add_attributes_of_all_kinds(mesh);
      MeshWithoutPrev other;
      ASSERT_TRUE(convert(copy_of(mesh), other));
      Sequence sequence(seed + 100, std::max<Index>(40, mesh.edge_count()));
      for (std::size_t step = 0; step < steps; ++step) {
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
