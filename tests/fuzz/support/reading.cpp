#include "support/reading.h"

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/repair/transfer.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "support/memory.h"
#include "support/repairing.h"
#include "support/round_trip.h"
#include "support/whole_soup.h"

namespace halfedge::fuzz {
namespace {

// The soup and its attributes, arrays while they grow, and a few sentences.
constexpr std::size_t kMemoryPerByte = 48;
constexpr std::size_t kMemoryAtLeast = 1U << 16U;

void expect_place(const Error& error, std::size_t size) {
  const std::string& message = error.message;
  const bool line = message.starts_with("line ");
  if (!line && !message.starts_with("byte ")) return;  // about the whole file
  const std::size_t place = std::stoul(message.substr(5));
  EXPECT_LE(place, size + 1) << message;
  EXPECT_GE(place, line ? 1U : 0U) << message;
}

void expect_whole(const ParsedFile& file, const ParseOptions& options) {
  const PolygonSoup& soup = file.soup;
  test::expect_whole(soup, !options.for_repair);
  if (!options.attributes) EXPECT_TRUE(file.attributes.empty());
  for (const SoupAttribute& column : file.attributes) {
    EXPECT_FALSE(column.name.empty());
    const std::size_t items[] = {soup.positions.size() / 3, soup.corners.size(),
                                 soup.view().face_count()};
    const std::size_t count = items[std::size_t(column.item)];
    const std::size_t rows = column.values.size() / column.stride();
    ASSERT_EQ(column.values.size() % column.stride(), 0U) << column.name;
    if (column.rows.empty()) {
      ASSERT_LE(rows, count) << column.name;
    } else {
      ASSERT_LE(column.rows.size(), count) << column.name;
    }
    for (const Index row : column.rows) ASSERT_TRUE(row < rows || row == kNone) << column.name;
  }
}

void expect_lines(std::span<const std::uint8_t> bytes, const ParsedFile& file) {
  const Index count = Index(file.soup.view().face_count());
  const std::vector<Index> faces = {0, count / 2, count};
  const std::vector<std::size_t> lines = lines_of_faces(bytes, file.format, faces);
  ASSERT_EQ(lines.size(), faces.size());
  for (const std::size_t line : lines) EXPECT_LE(line, bytes.size() + 1);
  EXPECT_EQ(lines[2], 0U);
  if (!file.binary && count > 0) {
    EXPECT_GE(lines[0], 1U);
    EXPECT_GE(lines[1], 1U);
  }
}

void expect_strict_verdict(const Polygons& polygons) {
  Mesh mesh;
  BuildReport report;
  const bool built = build_from_polygons(mesh, polygons, report);
  EXPECT_EQ(built, report.problem_count == 0);
  EXPECT_GE(report.problem_count, report.problems.size());
  for (const Error& problem : report.problems) expect_sentence(problem);
  if (built) {
    EXPECT_TRUE(test::errors_of(mesh).empty());
  } else {
    EXPECT_EQ(mesh.vertex_slots(), 0U);
  }
}

// GoogleTest prints the failure before this hears of it.
class StopAtFailure : public testing::EmptyTestEventListener {
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (result.failed()) std::abort();
  }
};

}  // namespace

void expect_sentence(const Error& error) {
  ASSERT_FALSE(error.code.empty());
  ASSERT_GE(error.message.size(), 10U) << error.code;
  for (const char c : error.message) ASSERT_TRUE(c >= ' ' && c <= '~') << error.message;
  ASSERT_LE(error.message.size(), 1000U) << error.message;
}

void stop_at_failures() {
  [[maybe_unused]] static const bool installed = [] {
    testing::UnitTest::GetInstance()->listeners().Append(new StopAtFailure);
    return true;
  }();
}

namespace {

void expect_same_polygons(const Result<ParsedFile>& other, const PolygonSoup& soup) {
  ASSERT_TRUE(other) << other.error().message;
  const PolygonSoup& same = other.value().soup;
  EXPECT_TRUE(std::ranges::equal(std::as_bytes(soup.positions.span()),
                                 std::as_bytes(same.positions.span())));
  EXPECT_TRUE(std::ranges::equal(soup.sizes, same.sizes));
  EXPECT_TRUE(std::ranges::equal(soup.corners, same.corners));
}

// Whether attributes are read decides nothing about the polygons, nor does repair where the file
// has no fault.
void expect_same_with_other_options(std::span<const std::uint8_t> bytes, const Reader& read,
                                    ParseOptions options, const PolygonSoup& soup) {
  options.attributes = false;
  expect_same_polygons(read(bytes, options), soup);
  if (options.for_repair) return;
  options.for_repair = true;
  expect_same_polygons(read(bytes, options), soup);
}

void expect_file(std::span<const std::uint8_t> bytes, const Reader& read,
                 const ParseOptions& options) {
  const MemoryMeter meter;
  Result<ParsedFile> result = read(bytes, options);
  EXPECT_LE(meter.peak(), kMemoryPerByte * bytes.size() + kMemoryAtLeast);
  if (!result) {
    expect_sentence(result.error());
    expect_place(result.error(), bytes.size());
    return;
  }
  ParsedFile file = std::move(result).value();
  for (const std::string& note : file.notes) expect_sentence({"note", note});
  expect_whole(file, options);
  expect_lines(bytes, file);
  expect_same_with_other_options(bytes, read, options, file.soup);
  const Polygons polygons = file.soup.view();
  expect_strict_verdict(polygons);
  test::Repaired repaired(polygons);
  test::expect_sound(polygons, repaired);
  const Result<void> added =
      add_attributes(repaired.mesh, polygons, &repaired.report, file.attributes);
  EXPECT_TRUE(added) << added.error().message;
  expect_round_trips(repaired.mesh);
}

}  // namespace

int expect_read(std::span<const std::uint8_t> bytes, const Reader& read) {
  stop_at_failures();
  expect_file(bytes, read, {});
  expect_file(bytes, read, {.for_repair = true});
  return 0;
}

}  // namespace halfedge::fuzz
