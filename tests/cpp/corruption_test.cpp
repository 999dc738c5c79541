#include <gtest/gtest.h>
#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "support/copies.h"
#include "support/invariants.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

// The arrays of a mesh can be written to, from JavaScript above all. Whatever is in them, nothing
// here may hang, or read or write out of bounds: these tests are for a build with sanitizers.
namespace halfedge::test {
namespace {

using Random = std::mt19937;

Index below(Random& random, std::size_t count) { return Index(random() % count); }

// What a link might hold: something in range mostly, something odd at times.
Index any_link(Random& random, std::size_t slots) {
  switch (below(random, 8)) {
    case 0:
      return kNone;
    case 1:
      return kDeleted - below(random, slots + 3);
    case 2:
      return Index(slots) + below(random, 3);
    case 3:
      return Index(random());
    default:
      return below(random, slots + 1);
  }
}

std::vector<Array<Index>*> arrays_of(Links& links) {
  return {&links.next,         &links.prev, &links.to_vertex, &links.face, &links.vertex_halfedge,
          &links.face_halfedge};
}

// Everything that promises to survive a corrupt mesh. Its results are right or errors.
void run_everything(const Mesh& mesh, bool valid) {
  for (int level = 0; level <= kGeometryLevel; ++level) {
    EXPECT_TRUE(!valid || !has_errors(validate(mesh, level)));
  }
  EXPECT_TRUE(boundary_loops(mesh).ok() || !valid);
  EXPECT_TRUE(connected_components(mesh).ok() || !valid);
  EXPECT_TRUE(genus(mesh).ok() || !valid);
  (void)euler_characteristic(mesh);
  (void)is_closed(mesh);
  (void)is_triangle_mesh(mesh);
  (void)is_quad_mesh(mesh);
  std::vector<Index> centres;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) centres.push_back(v);
  for (int ring = int(Ring::kVertexVertices); ring <= int(Ring::kEdgeFaces); ++ring) {
    for (const Direction direction : {Direction::kCcw, Direction::kCw}) {
      Adjacency result;
      EXPECT_TRUE(adjacency(mesh, Ring(ring), direction, result).ok() || !valid);
      (void)adjacency(mesh, Ring(ring), direction, centres, result);
      Index buffer[3];
      for (const Index centre : centres)
        (void)write_ring(mesh, Ring(ring), direction, centre, buffer);
    }
  }
}

TEST(Corruption, GarbageInAllArraysIsSurvived) {
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh mesh;
    const Index size = 2 * below(random, 12);
    const Index slots[] = {size, size, size, size, below(random, 9), below(random, 9)};
    const bool ragged = below(random, 4) == 0;
    std::size_t i = 0;
    for (Array<Index>* array : arrays_of(mesh.mutable_links())) {
      ASSERT_TRUE(array->resize(slots[i++] + (ragged ? below(random, 3) : 0)));
      for (Index& link : *array) link = any_link(random, size);
    }
    ASSERT_TRUE(mesh.mutable_positions().resize(3 * std::size_t{mesh.vertex_slots()}, 0));
    run_everything(mesh, Invariants(mesh).hold());
  }
}

// A valid mesh with a few links changed, or cut short: found exactly if an invariant is broken.
TEST(Corruption, FewWrongLinksAreFoundIfAndOnlyIfTheyBreakAnInvariant) {
  const std::vector<Shape> shapes = all_shapes();
  int still_valid = 0;
  for (std::uint32_t seed = 0; seed < 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::size_t pick = below(random, shapes.size() + 4);
    Mesh mesh = reference_build(pick < shapes.size() ? shapes[pick] : random_polygons(seed));
    if (below(random, 3) == 0) {  // a free list
      for (int i = 0; i < 3; ++i) (void)mesh.new_vertex();
      for (Index i = 1; i <= 3; ++i) mesh.release(Vertex(mesh.vertex_slots() - i));
    }
    const std::vector<Array<Index>*> arrays = arrays_of(mesh.mutable_links());
    for (Index writes = 1 + below(random, 3); writes > 0; --writes) {
      Array<Index>& array = *arrays[below(random, arrays.size())];
      if (array.empty()) continue;
      if (below(random, 40) == 0) {
        ASSERT_TRUE(array.resize(below(random, array.size())));
      } else {
        array[below(random, array.size())] = any_link(random, mesh.halfedge_slots());
      }
    }
    const bool valid = Invariants(mesh).hold();
    const std::vector<Problem> problems = validate(mesh);
    EXPECT_EQ(!has_errors(problems), valid) << (problems.empty() ? "" : problems[0].message);
    still_valid += valid ? 1 : 0;
    run_everything(mesh, valid);
  }
  // Such as another anchor of an interior vertex, or another first halfedge of a face.
  EXPECT_GT(still_valid, 15);
}

// Two links of a kind exchanged: nothing is out of range, all is in the wrong place.
TEST(Corruption, ExchangedLinksAreFoundIfAndOnlyIfTheyBreakAnInvariant) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh mesh = reference_build(random_polygons(seed));
    Array<Index>& array = *arrays_of(mesh.mutable_links())[below(random, 6)];
    if (array.empty()) continue;
    std::swap(array[below(random, array.size())], array[below(random, array.size())]);
    const bool valid = Invariants(mesh).hold();
    EXPECT_EQ(!has_errors(validate(mesh)), valid);
    run_everything(mesh, valid);
  }
}

// With gaps of all kinds to close, and some more or fewer of them by what is written.
TEST(Corruption, CompactDoesNotFollowLinksOutOfTheArrays) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh mesh = with_gaps(random_polygons(seed), seed);
    const Index slots = mesh.vertex_slots();
    Links& links = mesh.mutable_links();
    for (Index writes = 1 + below(random, 6); writes > 0; --writes) {
      Array<Index>& array = *arrays_of(links)[below(random, 6)];
      if (!array.empty()) array[below(random, array.size())] = any_link(random, array.size());
    }
    EXPECT_EQ(compact(mesh).value().vertices.size(), slots);
    const auto all_lead = [](const Array<Index>& array, Index end) {
      return std::ranges::all_of(array, [&](Index link) { return link == kNone || link < end; });
    };
    EXPECT_TRUE(all_lead(links.next, mesh.halfedge_slots()));
    EXPECT_TRUE(all_lead(links.prev, mesh.halfedge_slots()));
    EXPECT_TRUE(all_lead(links.to_vertex, mesh.vertex_slots()));
    EXPECT_TRUE(all_lead(links.face, mesh.face_slots()));
    EXPECT_TRUE(all_lead(links.vertex_halfedge, mesh.halfedge_slots()));
    EXPECT_TRUE(all_lead(links.face_halfedge, mesh.halfedge_slots()));
    run_everything(mesh, false);
  }
}

}  // namespace
}  // namespace halfedge::test
