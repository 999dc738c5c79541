// All repairs one after another, on whatever there is.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/io/parse.h>
#include <halfedge/repair/repair.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "support/data_files.h"
#include "support/mending.h"
#include "support/sweep.h"

namespace halfedge::test {
namespace {

using mend::Code;

/// In the order that docs/repairs.md recommends.
template <class Mesh>
Result<mend::Report> repair(Mesh& mesh, int which) {
  switch (which) {
    case 0:
      return mend::split_pinched_vertices(mesh);
    case 1:
      return mend::stitch_boundaries(mesh, {.tolerance = 1e-6});
    case 2:
      return mend::remove_degenerate_faces(mesh);
    case 3:
      return mend::drop_small_components(mesh, {.faces = 3, .diagonal = 0.01});
    case 4:
      return mend::fill_holes(mesh, {.max_edges = 60});
    default:
      return mend::orient_outward(mesh, {.open = true, .nested = mesh.face_count() < 10'000});
  }
}
constexpr int kRepairs = 6;

TEST(AllRepairs, KeepTheirContractOnMeshesOfAllTopologies) {
  for (auto& [name, mesh] : meshes_to_sweep(60)) {
    SCOPED_TRACE(name);
    for (int which = 0; which < kRepairs; ++which) {
      SCOPED_TRACE(which);
      Mesh alone = copy_of(mesh);
      (void)mended(alone, [=](auto& m) { return repair(m, which); });
    }
    for (int which = 0; which < kRepairs; ++which) {
      SCOPED_TRACE(which);
      (void)mended(mesh, [=](auto& m) { return repair(m, which); });
    }
  }
}

// Positions from a small grid, so that vertices coincide, edges have no length and faces no area.
TEST(AllRepairs, KeepTheirContractWhereVerticesCoincide) {
  std::array<std::size_t, mend::kCodeCount> counts{};
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Shape shape = random_polygons(seed);
    const std::uint32_t places = 2 + seed % 4;
    for (float& coordinate : shape.positions) coordinate = float(random() % places);
    Mesh mesh = reference_build(shape);
    for (int i = 0; i < 8; ++i) {
      const int which = int(random() % kRepairs);
      SCOPED_TRACE(which);
      const mend::Report report = mended(mesh, [=](auto& m) { return repair(m, which); });
      for (std::size_t code = 0; code < counts.size(); ++code) counts[code] += report.counts[code];
      ASSERT_FALSE(HasFailure());
    }
  }
  for (std::size_t code = 0; code < counts.size(); ++code) {
    const bool is_rare = Code(code) == Code::kUnfillableHole || Code(code) == Code::kLargeHole;
    if (is_rare || Code(code) == Code::kOpenComponent) continue;
    EXPECT_GT(counts[code], 0U) << name_of(Code(code)) << " was never met";
  }
}

TEST(AllRepairs, LeaveAValidMeshOfEveryNastyFile) {
  HALFEDGE_NEEDS_DATA();
  std::size_t checked = 0;
  std::size_t touched = 0;
  for (const auto& path : data_files("nasty", {".obj", ".off", ".ply", ".stl"})) {
    SCOPED_TRACE(path.filename());
    const Result<ParsedFile> file = parse_file(path);
    if (!file) continue;
    Mesh mesh;
    RepairReport soup;
    ASSERT_TRUE(build_from_soup(mesh, file.value().soup.view(), {}, soup));
    ASSERT_TRUE(mesh.enable_history());
    const Snapshot before(mesh);
    for (int which = 0; which < kRepairs; ++which) {
      SCOPED_TRACE(which);
      const Result<mend::Report> report = repair(mesh, which);
      ASSERT_TRUE(report) << report.error().message;
      const std::vector<Problem> problems = validate(mesh);
      ASSERT_FALSE(has_errors(problems)) << problems[0].message;
      touched += report.value().summary != "Nothing to repair." ? 1 : 0;
      mesh.end_step();
    }
    while (mesh.undo()) {
    }
    EXPECT_TRUE(Snapshot(mesh) == before);
    ++checked;
  }
  EXPECT_GE(checked, 50U);
  EXPECT_GE(touched, 50U);
}

// What a soup of triangles becomes by stitching is what the builder welds it to.
TEST(AllRepairs, StitchASoupAsTheBuilderWeldsIt) {
  HALFEDGE_NEEDS_DATA();
  std::size_t checked = 0;
  for (const auto& path : data_files("good", {".off", ".stl"})) {
    SCOPED_TRACE(path.filename());
    if (std::filesystem::file_size(path) > 800'000) continue;
    const Result<ParsedFile> file = parse_file(path);
    if (!file) continue;
    Mesh welded;
    RepairReport soup;
    ASSERT_TRUE(build_from_soup(welded, file.value().soup.view(), {.weld = 0}, soup));
    if (soup.count(RepairCode::kEdgeWithManyFaces) > 0 || soup.verdicts.size() > 0) continue;
    Mesh apart = soup_of(welded);
    const Result<mend::Report> report = mend::stitch_boundaries(apart);
    ASSERT_TRUE(report);
    expect_sound(apart);
    EXPECT_EQ(apart.edge_count(), welded.edge_count()) << report.value().summary;
    EXPECT_EQ(boundary_loops(apart).value().size(), boundary_loops(welded).value().size());
    ++checked;
  }
  EXPECT_GE(checked, 20U);
}

}  // namespace
}  // namespace halfedge::test
