// Attributes of a soup on the mesh that repairs made of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/attribute_file.h"

namespace halfedge {
namespace {

using test::values_of;
using Doubles = std::vector<double>;

Index below(std::mt19937& random, Index end) { return Index(random() % end); }

/// A column whose value is the index of its item.
SoupAttribute numbered(const char* name, SoupItem item, std::size_t count) {
  SoupAttribute column;
  column.name = name;
  column.item = item;
  column.type = Scalar::kUint32;
  column.on_split = OnSplit::kInterpolate;
  EXPECT_TRUE(column.values.resize(4 * count));
  for (Index i = 0; i < count; ++i) std::memcpy(&column.values[4 * std::size_t{i}], &i, 4);
  return column;
}

/// Repairs a soup, and looks for every item of the mesh where it came from.
void expect_to_follow(const std::vector<float>& positions, const std::vector<Index>& sizes,
                      const std::vector<Index>& corners, const RepairOptions& options) {
  const Polygons soup{positions, sizes, corners};
  Mesh mesh;
  RepairReport report;
  ASSERT_TRUE(build_from_soup(mesh, soup, options, report)) << report.problems[0].message;
  std::vector<SoupAttribute> columns;
  columns.push_back(numbered("v", SoupItem::kVertex, soup.vertex_count()));
  columns.push_back(numbered("c", SoupItem::kCorner, corners.size()));
  columns.push_back(numbered("f", SoupItem::kFace, soup.face_count()));
  ASSERT_TRUE(add_attributes(mesh, soup, &report, columns));
  const auto of_vertices = mesh.find_attribute(ItemKind::kVertex, "v")->values<Index>();
  const auto of_corners = mesh.find_attribute(ItemKind::kHalfedge, "c")->values<Index>();
  const auto of_faces = mesh.find_attribute(ItemKind::kFace, "f")->values<Index>();
  EXPECT_TRUE(std::equal(of_vertices.begin(), of_vertices.end(), report.vertex_origin.begin()));
  std::vector<Index> begin = {0};
  for (const Index size : sizes) begin.push_back(begin.back() + size);
  for (Index f = 0; f < mesh.face_slots(); ++f) {
    const Index source = of_faces[f];
    ASSERT_EQ(report.face_map[source], f);
    std::set<Index> seen;
    int down = 0;
    Index before = kNone;
    const Halfedge first = mesh.face_halfedge(Face(f));
    Halfedge h = first;
    do {
      const Index corner = of_corners[h.index()];
      ASSERT_TRUE(corner >= begin[source] && corner < begin[source + 1]) << report.summary;
      // At its place, and at its position unless welded with a tolerance.
      const Index origin = of_vertices[mesh.to_vertex(h).index()];
      EXPECT_EQ(report.vertex_map[corners[corner]], report.vertex_map[origin]);
      EXPECT_TRUE(seen.insert(corner).second);
      down += before != kNone && corner < before ? 1 : 0;
      before = corner;
      h = mesh.next(h);
    } while (h != first);
    // In order, or all in the opposite order, once round.
    const int steps = int(seen.size()) - 1;
    EXPECT_TRUE(down <= 1 || down >= steps - 1);
  }
}

TEST(Transfer, FollowsWeldsSplitsDropsAndTurns) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Index vertices = 4 + below(random, 12);
    std::vector<float> positions;
    for (Index i = 0; i < 3 * vertices; ++i) positions.push_back(float(below(random, 3)));
    if (seed % 7 == 0) positions[4] = std::nanf("");
    std::vector<Index> sizes;
    std::vector<Index> corners;
    const Index faces = 1 + below(random, 14);
    for (Index f = 0; f < faces; ++f) {
      sizes.push_back(seed % 3 == 0 ? 3 : below(random, 9));
      for (Index i = 0; i < sizes.back(); ++i) corners.push_back(below(random, vertices));
      if (below(random, 40) == 0 && !corners.empty()) corners.back() = 1000;
    }
    RepairOptions options;
    if (seed % 2 == 0) options.weld = seed % 4 == 0 ? 0 : 1.5;
    options.drop_isolated = seed % 5 == 0;
    expect_to_follow(positions, sizes, corners, options);
  }
}

TEST(Transfer, KeepsTheValuesOfTheCornerThatStays) {
  // The face goes to 3 and back, and repeats 2; the other one is turned over.
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 5, 5, 5};
  const std::vector<Index> sizes = {6, 3, 3};
  const std::vector<Index> corners = {0, 1, 4, 1, 2, 2, 0, 3, 2, 0, 1, 9};
  Mesh mesh;
  RepairReport report;
  const Polygons soup{positions, sizes, corners};
  ASSERT_TRUE(build_from_soup(mesh, soup, {}, report));
  std::vector<SoupAttribute> columns;
  columns.push_back(numbered("c", SoupItem::kCorner, corners.size()));
  ASSERT_TRUE(add_attributes(mesh, soup, &report, columns));
  const Doubles values = values_of(mesh, ItemKind::kHalfedge, "c");
  EXPECT_TRUE((values == Doubles{0, 1, 4, 6, 8, 7}) || (values == Doubles{0, 4, 1, 6, 7, 8}))
      << testing::PrintToString(values);
}

}  // namespace
}  // namespace halfedge
