#include <gtest/gtest.h>
#include <halfedge/io/parse.h>
#include <halfedge/repair/repair.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace halfedge {
namespace {

/// Notes what it is told, and cancels when it is told the given stage.
struct Follower {
  std::vector<Stage> stages = {};
  std::vector<double> fractions = {};
  bool cancels = false;
  Stage cancels_at = Stage::kRead;

  [[nodiscard]] Progress progress() { return {&Follower::report, this}; }
  static bool report(void* context, Stage stage, double fraction) {
    auto& self = *static_cast<Follower*>(context);
    self.stages.push_back(stage);
    self.fractions.push_back(fraction);
    return !(self.cancels && stage == self.cancels_at);
  }
};

/// A strip of triangles, every tenth of them turned over if asked for.
std::string strip(int faces, bool clashing = false) {
  std::string text;
  for (int v = 0; v < faces + 2; ++v) {
    text += "v " + std::to_string(v / 2) + " " + std::to_string(v % 2) + " 0\n";
  }
  for (int f = 1; f <= faces; ++f) {
    const bool flips = (f % 2 == 0) != (clashing && f % 10 == 0);
    text += "f " + std::to_string(f) + " " + std::to_string(flips ? f + 2 : f + 1) + " " +
            std::to_string(flips ? f + 1 : f + 2) + "\n";
  }
  return text;
}

/// Four MiB and more.
std::string large() {
  const std::string line = "#" + std::string(1022, ' ') + "\n";
  std::string text = strip(4);
  for (int i = 0; i < 4 * 1024; ++i) text += line;
  return text;
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(Progress, OfReadingRisesAndIsToldEveryMebibyte) {
  const std::string text = large();
  Follower follower;
  ASSERT_TRUE(parse(bytes_of(text), std::nullopt, {.progress = follower.progress()}).ok());
  EXPECT_GE(follower.stages.size(), 3U);
  EXPECT_LE(follower.stages.size(), 4U);
  double last = 0;
  for (const double fraction : follower.fractions) {
    EXPECT_GT(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
  }
}

TEST(Progress, CancelsReading) {
  const std::string text = large();
  Follower follower{.cancels = true};
  const Result<ParsedFile> file =
      parse(bytes_of(text), std::nullopt, {.progress = follower.progress()});
  ASSERT_FALSE(file.ok());
  EXPECT_EQ(file.error().code, "cancelled");
  EXPECT_EQ(follower.stages.size(), 1U);
}

/// Repairs the strip, which is clashing.
bool repair(Follower& follower, Mesh& mesh, RepairReport& report) {
  const std::string text = strip(100, true);
  Result<ParsedFile> file = parse(bytes_of(text));
  return build_from_soup(mesh, file.value().soup.view(), {.progress = follower.progress()}, report);
}

TEST(Progress, TellsTheStepsOfARepair) {
  Follower follower;
  Mesh mesh;
  RepairReport report;
  ASSERT_TRUE(repair(follower, mesh, report));
  ASSERT_GE(follower.stages.size(), 3U);
  EXPECT_EQ(follower.stages.front(), Stage::kBuild);
  for (std::size_t i = 1; i < follower.stages.size(); ++i) {
    EXPECT_EQ(follower.stages[i], Stage::kRepair);
  }
  EXPECT_EQ(follower.fractions.back(), 1);
}

TEST(Progress, CancelsARepairOrABuild) {
  for (const Stage stage : {Stage::kBuild, Stage::kRepair}) {
    Follower follower{.cancels = true, .cancels_at = stage};
    Mesh mesh;
    RepairReport report;
    EXPECT_FALSE(repair(follower, mesh, report));
    ASSERT_EQ(report.problems.size(), 1U);
    EXPECT_EQ(report.problems[0].code, "cancelled");
    EXPECT_EQ(mesh.face_slots(), 0U);
    EXPECT_EQ(follower.stages.back(), stage);
  }
}

}  // namespace
}  // namespace halfedge
