#pragma once

#include <gtest/gtest.h>
#include <halfedge/validate/validate.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "random/checks.h"
#include "random/operation.h"
#include "random/renumbering.h"
#include "support/complexes.h"
#include "support/invariants.h"
#include "support/reference_build.h"
#include "support/shapes.h"

/// Sequences of operations that are checked after each step, and taken back at the end.
namespace halfedge::test {

inline std::string to_string(const Operation& op, const Call& call) {
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
  for (const Edge e : call.edges) add("", e);
  for (const Vertex v : call.corners) add("", v);
  return text + (call.option ? "option)" : ")");
}

/// Draws operations and their arguments so that the mesh stays about as large as `size` edges.
class Sequence {
 public:
  Sequence(Draw draw, Index size) : draw_(draw), size_(size) {}

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
  /// How the items are renumbered before the next operation; seldom at all.
  std::optional<Renumbering> renumbering() {
    if (!draw_.one_in(30)) return std::nullopt;
    return kRenumberings[draw_.below(kRenumberings.size())];
  }
  [[nodiscard]] bool ends() const { return draw_.used_up(); }

 private:
  Draw draw_;
  Index size_;
};

inline Mesh copy_with_attributes(const Mesh& mesh) {
  Mesh copy = copy_of(mesh);
  add_attributes_of_all_kinds(copy);
  EXPECT_TRUE(copy.enable_generations());
  EXPECT_TRUE(copy.enable_history());
  return copy;
}

/// What must hold after an operation that was done.
inline void expect_success(const Mesh& before, const Mesh& after, const Operation& op,
                           const Call& call) {
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
  expect_copied_values<Vertex>(before, after);
  expect_copied_values<Halfedge>(before, after);
  expect_copied_values<Edge>(before, after);
  expect_copied_values<Face>(before, after);
  expect_corner_values_stay(before, after);
}

/// How often each operation and renumbering was done, and how often it was refused.
using Tally = std::map<std::string, std::pair<std::size_t, std::size_t>>;

/// Does so many steps, or those that there are; then takes them back, and does them again.
inline void run_sequence(Mesh& mesh, Sequence& sequence, std::size_t steps, Tally& tally) {
  std::vector<Snapshot> states{Snapshot(mesh)};
  for (std::size_t step = 0; step < steps && !sequence.ends(); ++step) {
    if (const std::optional<Renumbering> how = sequence.renumbering()) {
      SCOPED_TRACE("step " + std::to_string(step) + ": " + name_of(*how));
      if (expect_renumbers(mesh, *how)) {
        states.emplace_back(mesh);
        ++tally[name_of(*how)].first;
      }
      mesh.end_step();
      ASSERT_EQ(mesh.history()->undo_count() + 1, states.size());
      if (testing::Test::HasFailure()) return;
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

}  // namespace halfedge::test
