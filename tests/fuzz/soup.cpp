// Any polygons, strict and repaired with any options.
//
// An input is: options, number of vertices, three coordinates for each, then faces: the number of
// corners, and a vertex for each.

#include "support/soup.h"

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/connectivity/storage.h>
#include <halfedge/repair/repair.h>

#include <limits>
#include <vector>

#include "support/input.h"
#include "support/invariants.h"
#include "support/memory.h"
#include "support/reading.h"
#include "support/repairing.h"
#include "support/round_trip.h"

namespace halfedge::fuzz {
namespace {

// Repair takes some 80 bytes a corner, and arrays that grow count twice.
constexpr std::size_t kMemoryPerItem = 400;
// Sentences, of which there are at most as many as are listed.
constexpr std::size_t kMemoryAtLeast = std::size_t{2} << 20U;

RepairOptions options_of(Input& input) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::optional<double> kWelds[] = {std::nullopt, 0.0,   0.011, 1.5,      1e-300,
                                              1e300,        -1e-9, kNaN,  kInfinity};
  RepairOptions options;
  options.weld = kWelds[input.byte() % std::size(kWelds)];
  options.drop_isolated = input.flag();
  return options;
}

template <class Mesh>
bool builds(const Polygons& polygons) {
  Mesh mesh;
  BuildReport report;
  const bool built = build_from_polygons(mesh, polygons, report);
  EXPECT_EQ(built, report.problem_count == 0);
  EXPECT_EQ(report.problems.size(), std::min(report.problem_count, BuildReport::kMaxListed));
  for (const Error& problem : report.problems) expect_sentence(problem);
  if (!built) {
    EXPECT_EQ(mesh.vertex_slots(), 0U);
    return false;
  }
  EXPECT_FALSE(has_errors(validate(mesh)));
  EXPECT_EQ(mesh.face_count(), polygons.face_count());
  EXPECT_EQ(mesh.vertex_count(), polygons.vertex_count());
  return true;
}

// A mesh that came out of a repair needs none.
void expect_nothing_left(const Mesh& mesh) {
  Soup again;
  again.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (const Face f : mesh.faces()) {
    again.sizes.push_back(0);
    for (const Vertex v : mesh.face_vertices_ccw(f)) {
      ++again.sizes.back();
      again.corners.push_back(v.index());
    }
  }
  EXPECT_TRUE(builds<Mesh>(again.view()));
  const test::Repaired repaired(again.view());
  EXPECT_TRUE(repaired.report.verdicts.empty()) << repaired.report.summary;
}

void expect_repaired(const Polygons& polygons, const RepairOptions& options, bool needs_none) {
  Mesh mesh;
  RepairReport report;
  if (!build_from_soup(mesh, polygons, options, report)) {
    EXPECT_FALSE(report.problems.empty());
    for (const Error& problem : report.problems) {
      expect_sentence(problem);
      EXPECT_TRUE(problem.code == "bad-size" || problem.code == "bad-tolerance") << problem.code;
    }
    EXPECT_EQ(mesh.vertex_slots(), 0U);
    return;
  }
  const test::Repaired repaired(polygons, options);
  test::expect_sound(polygons, repaired);
  EXPECT_TRUE(test::Invariants(repaired.mesh).hold());
  EXPECT_FALSE(report.summary.empty());
  for (const Error& problem : report.problems) expect_sentence(problem);
  if (needs_none && !options.weld) {
    EXPECT_TRUE(report.verdicts.empty()) << report.summary;
  }
  if (options.drop_isolated) {
    for (const Vertex v : mesh.vertices()) EXPECT_FALSE(mesh.is_isolated(v));
  }
  expect_nothing_left(repaired.mesh);
  expect_round_trips(repaired.mesh);
}

}  // namespace
}  // namespace halfedge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halfedge;
  using namespace halfedge::fuzz;
  stop_at_failures();
  Input input({data, size});
  const std::uint8_t oddities = input.byte() % 8;
  const RepairOptions options = options_of(input);
  const Soup soup = soup_of(input, oddities);
  const std::size_t enough = kMemoryPerItem * soup.items() + kMemoryAtLeast;
  {
    const MemoryMeter meter;
    Mesh mesh;
    BuildReport report;
    (void)build_from_polygons(mesh, soup.view(), report);
    EXPECT_LE(meter.peak(), enough);
  }
  {
    const MemoryMeter meter;
    Mesh mesh;
    RepairReport report;
    (void)build_from_soup(mesh, soup.view(), options, report);
    EXPECT_LE(meter.peak(), enough);
  }
  const bool built = builds<Mesh>(soup.view());
  EXPECT_EQ(builds<BasicMesh<kWithoutPrev>>(soup.view()), built);
  expect_repaired(soup.view(), options, built);
  return 0;
}
