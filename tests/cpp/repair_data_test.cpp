// The collection of test meshes: what is clean stays as it is, what is nasty becomes a mesh.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/repair/repair.h>

#include <algorithm>
#include <map>
#include <string>

#include "support/data_files.h"
#include "support/repairing.h"

namespace halfedge::test {
namespace {

const std::vector<std::string> kFormats{".obj", ".off", ".ply", ".stl"};

TEST(RepairOfTheCollection, ChangesNothingInGoodFiles) {
  HALFEDGE_NEEDS_DATA();
  std::size_t checked = 0;
  for (const auto& path : data_files("good", kFormats)) {
    SCOPED_TRACE(path.filename());
    if (std::filesystem::file_size(path) > 1'000'000) continue;
    const Result<ParsedFile> file = parse_file(path);
    if (!file) continue;
    const Polygons polygons = file.value().soup.view();
    const Repaired result(polygons);
    expect_sound(polygons, result);
    EXPECT_TRUE(result.report.verdicts.empty());
    Mesh strict;
    BuildReport report;
    ASSERT_TRUE(build_from_polygons(strict, polygons, report));
    EXPECT_TRUE(std::equal(strict.links().next.begin(), strict.links().next.end(),
                           result.mesh.links().next.begin(), result.mesh.links().next.end()));
    ++checked;
  }
  EXPECT_GE(checked, 90U);
}

TEST(RepairOfTheCollection, MakesAValidMeshOfEveryNastyFileThatCanBeRead) {
  HALFEDGE_NEEDS_DATA();
  std::size_t checked = 0;
  for (const auto& path : data_files("nasty", kFormats)) {
    SCOPED_TRACE(path.filename());
    const Result<ParsedFile> file = parse_file(path);
    if (!file) continue;
    const Polygons polygons = file.value().soup.view();
    for (const RepairOptions& options :
         {RepairOptions{}, RepairOptions{.weld = 0, .drop_isolated = true}}) {
      const Repaired result(polygons, options);
      expect_sound(polygons, result);
    }
    ++checked;
  }
  EXPECT_GE(checked, 50U);
}

struct Expected {
  Index vertices;
  Index faces;
  std::size_t components;
  std::size_t loops;
  std::string summary;
};

TEST(RepairOfTheCollection, MakesOfKnownDefectsWhatIsExpected) {
  HALFEDGE_NEEDS_DATA();
  const std::map<std::string, Expected> table = {
      {"hourglass_ico.obj", {24, 40, 2, 0, "1 pinched vertex split, 1 vertex added as a copy."}},
      {"lionstatue_orientation.obj", {31825, 63338, 1, 1, "2 faces turned over."}},
      {"moebius.obj",
       {285, 224, 1, 1, "4 edges of one-sided surfaces cut, 5 vertices added as copies."}},
      {"syn_obj_klein.obj",
       {35, 30, 1, 2, "5 edges of one-sided surfaces cut, 5 vertices added as copies."}},
      {"syn_obj_two_tets_shared_edge.obj",
       {8, 8, 2, 0, "1 edge with more than two faces cut, 2 vertices added as copies."}},
      {"syn_off_dup_face_reversed.off", {8, 6, 1, 0, "1 duplicate face left out."}},
      {"syn_off_flipped_face.off", {8, 6, 1, 0, "1 face turned over."}},
      {"syn_off_nan.off",
       {7, 3, 1, 1, "1 vertex without a finite position left out, 3 faces that used it left out."}},
      {"syn_off_two_gon.off", {8, 5, 1, 1, "1 face with fewer than 3 corners left out."}},
      {"box_longline.obj",
       {8, 6, 1, 0, "1 face that used a vertex twice simplified, 1 face turned over."}},
  };
  for (const auto& [name, expected] : table) {
    SCOPED_TRACE(name);
    const Result<ParsedFile> file = parse_file(data_folder() / "nasty" / name);
    ASSERT_TRUE(file);
    const Repaired result(file.value().soup.view());
    EXPECT_EQ(result.mesh.vertex_count(), expected.vertices);
    EXPECT_EQ(result.mesh.face_count(), expected.faces);
    EXPECT_EQ(connected_components(result.mesh).value().list.size(), expected.components);
    EXPECT_EQ(boundary_loops(result.mesh).value().size(), expected.loops);
    EXPECT_EQ(result.report.summary, expected.summary);
  }
}

}  // namespace
}  // namespace halfedge::test
