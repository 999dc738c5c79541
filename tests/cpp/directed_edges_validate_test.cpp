#include <gtest/gtest.h>
#include <halfedge/directed_edges/convert.h>
#include <halfedge/directed_edges/validate.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/directed_edges.h"

namespace halfedge::test {
namespace {

std::vector<std::string> codes_of(const DirectedEdgesMesh& mesh) {
  std::vector<std::string> codes;
  for (const Problem& problem : validate(mesh)) codes.emplace_back(problem.code);
  return codes;
}

TEST(DirectedEdgesValidate, NamesEachKindOfDamage) {
  using Codes = std::vector<std::string>;
  const auto damaged = [](const auto& damage) {
    DirectedEdgesMesh mesh = built({"two triangles", 4, {{0, 1, 2}, {2, 1, 3}}});
    damage(mesh.mutable_links());
    return codes_of(mesh);
  };
  EXPECT_EQ(damaged([](DirectedLinks&) {}), Codes{});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.to_vertex.pop_back(); }), Codes{"array-size"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.boundary_prev.pop_back(); }), Codes{"array-size"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.sides = 7; }), Codes{"array-size"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.sides = 12; }), Codes{"array-size"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.opposite[1] = 10; }), Codes{"index-out-of-range"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.opposite[1] = kNone; }), Codes{"empty-link"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.to_vertex[1] = 4; }), Codes{"index-out-of-range"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.boundary_next[0] = 5; }), Codes{"index-out-of-range"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.vertex_halfedge[0] = 10; }),
            Codes{"index-out-of-range"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.opposite[0] = 0; }),
            (Codes{"opposite-mismatch", "opposite-mismatch"}));
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.vertex_halfedge[0] = 2; }), Codes{"anchor-elsewhere"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.vertex_halfedge[0] = kNone; }),
            (Codes{"missing-anchor", "missing-anchor"}));
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.vertex_halfedge[0] = 1; }), Codes{"interior-anchor"});
  EXPECT_EQ(damaged([](DirectedLinks& l) { l.boundary_next[0] = 6; }),
            (Codes{"next-prev-mismatch"}));
  EXPECT_EQ(
      damaged([](DirectedLinks& l) {
        std::swap(l.opposite[0], l.opposite[1]);
        std::swap(l.opposite[6], l.opposite[7]);
      }),
      (Codes{"to-from-mismatch", "to-from-mismatch", "to-from-mismatch", "to-from-mismatch"}));
}

TEST(DirectedEdgesValidate, WarnsOfPinchedAndTellsOfIsolatedVertices) {
  EXPECT_EQ(codes_of(built(pinched(2))), std::vector<std::string>{"pinched-vertex"});
  EXPECT_EQ(codes_of(built(with_isolated_vertices())),
            (std::vector<std::string>(3, "isolated-vertex")));
}

TEST(DirectedEdgesValidate, ClosedFansThatShareAVertexAreUnreachable) {
  // Two tetrahedra; then vertex 4 of the second becomes vertex 0 of the first.
  DirectedEdgesMesh mesh = built(
      {"two tetrahedra",
       8,
       {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {4, 5, 6}, {4, 6, 7}, {4, 7, 5}, {5, 7, 6}}});
  DirectedLinks& links = mesh.mutable_links();
  std::replace(links.to_vertex.begin(), links.to_vertex.end(), 4U, 0U);
  links.vertex_halfedge[4] = kNone;
  const std::vector<Problem> problems = validate(mesh, 2);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].code, "unreachable-halfedge");
}

// The links that `validate` lets pass are those of a mesh, which the full validator accepts too.
TEST(DirectedEdgesValidate, AgreesWithTheFullValidatorOnRandomDamage) {
  int invalid = 0;
  int still_valid = 0;
  for (std::uint32_t seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    DirectedEdgesMesh mesh = built(seed % 2 == 0 ? triangle_grid(2, 2) : pinched(3));
    DirectedLinks& links = mesh.mutable_links();
    const std::vector<Array<Index>*> arrays = {&links.opposite, &links.to_vertex,
                                               &links.boundary_next, &links.boundary_prev,
                                               &links.vertex_halfedge};
    Array<Index>& array = *arrays[random() % arrays.size()];
    const std::size_t i = random() % array.size();
    const std::size_t j = random() % array.size();
    if (random() % 2 == 0) {
      std::swap(array[i], array[j]);
    } else {
      array[i] = Index(random() % 32) - 1;
    }
    const bool loops_hold = !has_errors(validate(mesh, 1));
    Mesh full;
    const Result<void> converted = to_mesh(mesh, full);
    ASSERT_EQ(bool(converted), loops_hold);
    if (!converted) {
      EXPECT_EQ(converted.error().code, "corrupt-connectivity");
      ++invalid;
      continue;
    }
    for (int level = 2; level <= kMaxValidationLevel; ++level) {
      EXPECT_EQ(has_errors(validate(mesh, level)), has_errors(validate(full, level))) << level;
    }
    ++still_valid;
  }
  EXPECT_GT(invalid, 1000);
  EXPECT_GT(still_valid, 100);
}

}  // namespace
}  // namespace halfedge::test
