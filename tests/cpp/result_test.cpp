#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <cstddef>
#include <type_traits>

#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

TEST(Result, HandsOverWhatALoopCanGoOver) {
  const Mesh mesh = reference_build(quad_grid(3, 3));
  std::size_t loops = 0;
  for (const Halfedge h : boundary_loops(mesh).value()) loops += mesh.is_boundary(h) ? 1 : 0;
  EXPECT_EQ(loops, 1U);
}

TEST(Result, HandsOverAnErrorThatALoopCanGoOver) {
  const auto refuse = []() -> Result<Index> { return Error{"a-code", "Long", {.faces = {7, 9}}}; };
  std::size_t sum = 0;
  for (const Index f : refuse().error().witness.faces) sum += f;
  EXPECT_EQ(sum, 16U);
  const auto refuse_all = []() -> Result<void> { return Error{"a-code", "No", {.edges = {5}}}; };
  for (const Index e : refuse_all().error().witness.edges) sum += e;
  EXPECT_EQ(sum, 21U);
}

// What an operation returns can't be taken for a handle of another kind, either.
static_assert(std::is_constructible_v<Result<Vertex>, Result<Vertex>>);
static_assert(std::is_constructible_v<Result<Vertex>, Result<void>>);
static_assert(std::is_constructible_v<Result<Index>, Result<Vertex>>);
static_assert(!std::is_constructible_v<Result<Face>, Result<Vertex>>);
static_assert(!std::is_constructible_v<Result<Edge>, Result<Halfedge>>);

TEST(Result, PassesTheErrorOfAnotherOneOn) {
  const auto passed_on = [](Result<void> can) -> Result<Index> { return can; };
  const Result<Index> result = passed_on(Error{"a-code", "A sentence.", {.vertices = {7}}});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, "a-code");
  EXPECT_EQ(result.error().message, "A sentence.");
  EXPECT_EQ(result.error().witness, (Witness{.vertices = {7}}));

  const auto without_value = [](Result<Index> found) -> Result<void> { return found; };
  EXPECT_TRUE(without_value(Index{7}));
  const Result<void> refused = without_value(Error{"a-code", "A sentence.", {}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "a-code");
}

}  // namespace
}  // namespace halfedge::test
