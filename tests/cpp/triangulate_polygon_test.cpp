// Polygons of every ugly kind, cut into triangles: as many as there must be, none folded over.

#include <gtest/gtest.h>
#include <halfedge/algorithms/point_tree.h>
#include <halfedge/algorithms/rank_tree.h>
#include <halfedge/algorithms/triangulate_polygon.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/scaling.h"

namespace halfedge::test {
namespace {

using Polygon = std::vector<Point>;
using Triangles = std::vector<std::array<Index, 3>>;
using Outcome = PolygonTriangulator::Outcome;

Triangles triangles_of(std::size_t n, const Array<Index>& ears) {
  std::vector<Index> left;
  for (Index i = 0; i < n; ++i) left.push_back(i);
  Triangles all;
  const auto take = [&](std::size_t at) {
    all.push_back(
        {left[(at + left.size() - 1) % left.size()], left[at], left[(at + 1) % left.size()]});
    left.erase(left.begin() + std::ptrdiff_t(at));
  };
  for (const Index ear : ears) {
    take(std::size_t(std::find(left.begin(), left.end(), ear) - left.begin()));
  }
  take(1);
  return all;
}

Triangles triangulate(const Polygon& polygon, const std::vector<Diagonal>& forbidden = {}) {
  PolygonTriangulator triangulator;
  Array<Index> ears;
  EXPECT_EQ(triangulator.run(polygon, forbidden, ears), Outcome::kDone);
  EXPECT_EQ(ears.size(), polygon.size() - 3);
  return triangles_of(polygon.size(), ears);
}

double area(Point a, Point b, Point c) {
  return ((double{b.x} - double{a.x}) * (double{c.y} - double{a.y}) -
          (double{b.y} - double{a.y}) * (double{c.x} - double{a.x})) /
         2;
}

double area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += area(polygon[0], polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return sum;
}

// The sum of the areas is that of the polygon, and the smallest of them isn't negative: so no point
// is covered twice.
void expect_covered(const Polygon& polygon, bool strictly = true) {
  const Triangles triangles = triangulate(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0;
  for (const auto& t : triangles) {
    const double of_this = area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    EXPECT_TRUE(strictly ? of_this > 0 : of_this >= 0)
        << of_this << ": " << t[0] << " " << t[1] << " " << t[2];
    sum += std::abs(of_this);
  }
  EXPECT_NEAR(sum, area(polygon), 1e-9 * sum);
}

Polygon regular(std::size_t n) {
  Polygon polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * double(i) / double(n);
    polygon.push_back({float(std::cos(angle)), float(std::sin(angle)), 0});
  }
  return polygon;
}

Polygon star(std::size_t points) {
  Polygon polygon = regular(2 * points);
  for (std::size_t i = 1; i < polygon.size(); i += 2) {
    polygon[i].x *= 0.3F;
    polygon[i].y *= 0.3F;
  }
  return polygon;
}

Polygon comb(std::size_t teeth) {
  Polygon polygon = {{float(teeth), -1, 0}};
  for (std::size_t i = teeth; i-- > 0;) {
    polygon.push_back({float(i) + 1, 0, 0});
    polygon.push_back({float(i) + 0.9F, 10, 0});
    polygon.push_back({float(i) + 0.1F, 10, 0});
    polygon.push_back({float(i) + 0.05F, 0, 0});
  }
  polygon.push_back({0, -1, 0});
  return polygon;
}

Polygon spiral(std::size_t n) {
  Polygon polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = double(i) / double(n);
    const double angle = t * 40;
    polygon.push_back(
        {float((1 + t * 10) * std::cos(angle)), float((1 + t * 10) * std::sin(angle)), 0});
  }
  for (std::size_t i = n; i-- > 0;) {
    const double t = double(i) / double(n);
    const double angle = t * 40;
    polygon.push_back(
        {float((0.5 + t * 10) * std::cos(angle)), float((0.5 + t * 10) * std::sin(angle)), 0});
  }
  if (area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

// Around a point in random directions and distances: simple, with many concave corners.
Polygon random_star_shaped(std::uint32_t seed, std::size_t n) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> angles;
  for (std::size_t i = 0; i < n; ++i) {
    angles.push_back(2 * 3.14159265358979 * (double(i) + 0.9 * unit(random)) / double(n));
  }
  Polygon polygon;
  for (const double angle : angles) {
    const double r = 0.1 + unit(random);
    polygon.push_back({float(r * std::cos(angle)), float(r * std::sin(angle)), 0});
  }
  return polygon;
}

// The outline of a region of unit squares, grown at random: full of straight corners, with
// corridors and bays; corners that would touch are avoided.
Polygon random_outline(std::uint32_t seed, std::size_t squares, int grid) {
  std::mt19937 random(seed);
  std::set<std::pair<int, int>> region = {{grid / 2, grid / 2}};
  const auto in = [&](int x, int y) { return region.count({x, y}) > 0; };
  for (std::size_t tries = 0; region.size() < squares && tries < 100 * squares; ++tries) {
    auto at = region.begin();
    std::advance(at, std::ptrdiff_t(random() % region.size()));
    const int dx[] = {1, 0, -1, 0};
    const std::size_t side = random() % 4;
    const int x = at->first + dx[side];
    const int y = at->second + dx[(side + 3) % 4];
    if (in(x, y) || x < 0 || y < 0 || x >= grid || y >= grid) continue;
    // Around the square the region must be one run: then it stays simply connected, no corner
    // touches another.
    const int rx[] = {1, 1, 0, -1, -1, -1, 0, 1};
    const int ry[] = {0, 1, 1, 1, 0, -1, -1, -1};
    int runs = 0;
    for (int i = 0; i < 8; ++i) {
      runs += in(x + rx[i], y + ry[i]) && !in(x + rx[(i + 7) % 8], y + ry[(i + 7) % 8]) ? 1 : 0;
    }
    if (runs == 1) region.insert({x, y});
  }
  std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> edges;
  for (const auto& [x, y] : region) {
    const std::pair<int, int> corner[] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    for (int i = 0; i < 4; ++i) {
      if (edges.erase({corner[(i + 1) % 4], corner[i]}) == 0) {
        edges.insert({corner[i], corner[(i + 1) % 4]});
      }
    }
  }
  Polygon polygon;
  const std::pair<int, int> first = edges.begin()->first;
  std::pair<int, int> at = first;
  do {
    polygon.push_back({float(at.first), float(at.second), 0});
    at = edges.lower_bound({at, {-1000, -1000}})->second;
  } while (at != first);
  return polygon;
}

TEST(TriangulatePolygon, ConvexConcaveAndUgly) {
  for (const std::size_t n : {3U, 4U, 5U, 31U, 32U, 33U, 34U, 100U, 1000U}) {
    SCOPED_TRACE(n);
    expect_covered(regular(n));
  }
  for (const std::size_t n : {3U, 5U, 16U, 17U, 200U}) {
    SCOPED_TRACE(n);
    expect_covered(star(n));
    expect_covered(comb(n));
    expect_covered(spiral(10 * n));
  }
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_covered(random_star_shaped(seed, 4 + seed));
    expect_covered(random_outline(seed, 1 + seed, 24));
  }
}

TEST(TriangulatePolygon, AnyStartAndAnyPlane) {
  const Polygon flat = random_outline(7, 40, 24);
  for (std::size_t start = 0; start < flat.size(); start += 3) {
    Polygon turned = flat;
    std::rotate(turned.begin(), turned.begin() + std::ptrdiff_t(start), turned.end());
    expect_covered(turned);
    // The same in the other coordinate planes, seen from either side: the same triangles.
    const Triangles expected = triangulate(turned);
    for (const int axis : {0, 1}) {
      Polygon moved;
      for (const Point& p : turned) {
        moved.push_back(axis == 0 ? Point{5, p.x, p.y} : Point{p.y, 5, p.x});
      }
      EXPECT_EQ(triangulate(moved), expected);
    }
  }
}

TEST(TriangulatePolygon, SlightlyNonPlanarAndTilted) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> noise(-0.01F, 0.01F);
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Polygon flat = random_star_shaped(seed, 5 + 2 * seed);
    Polygon tilted;
    for (const Point& p : flat)
      tilted.push_back({p.x, p.y, 0.8F * p.x - 0.5F * p.y + noise(random)});
    PolygonTriangulator triangulator;
    Array<Index> ears;
    ASSERT_EQ(triangulator.run(tilted, {}, ears), Outcome::kDone);
    for (const auto& t : triangles_of(tilted.size(), ears)) {
      EXPECT_GT(area(flat[t[0]], flat[t[1]], flat[t[2]]), 0);
    }
  }
}

TEST(TriangulatePolygon, ShorterDiagonalOfAConvexQuadTheOnlyOneOfADart) {
  EXPECT_EQ(triangulate({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {0, 1, 0}}),
            (Triangles{{1, 2, 3}, {0, 1, 3}}));
  EXPECT_EQ(triangulate({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}),
            (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

// That a side is forbidden changes nothing, but for how a quad is cut.
TEST(TriangulatePolygon, QuadsAreCutAsAllOtherPolygonsAre) {
  std::mt19937 random(8);
  const float odd[] = {std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::infinity(), -0.0F, 1e-30F, 3e38F};
  int along_02 = 0;
  for (int round = 0; round < 20000; ++round) {
    Polygon quad(4);
    for (Point& p : quad) {
      for (float* const x : {&p.x, &p.y, &p.z}) *x = float(random() % 4);
      if (round % 7 == 0 && random() % 4 == 0) p.y = odd[random() % 5];
      if (round % 3 == 0) p.z = 0;
    }
    const Triangles triangles = triangulate(quad);
    ASSERT_EQ(triangles, triangulate(quad, {{0, 1}})) << round;
    along_02 += triangles[0] == std::array<Index, 3>{0, 1, 2} ? 1 : 0;
  }
  EXPECT_GT(along_02, 5000);
  EXPECT_LT(along_02, 15000);
}

// The shortest sum of diagonals of all triangulations without a fold, by trying all of them.
double best_length(const Polygon& polygon, std::vector<Index> left) {
  if (left.size() == 3) {
    return area(polygon[left[0]], polygon[left[1]], polygon[left[2]]) > 0 ? 0 : 1e9;
  }
  double best = 1e9;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const Point a = polygon[left[(i + left.size() - 1) % left.size()]];
    const Point c = polygon[left[(i + 1) % left.size()]];
    if (area(a, polygon[left[i]], c) <= 0) continue;
    std::vector<Index> rest = left;
    rest.erase(rest.begin() + std::ptrdiff_t(i));
    best = std::min(best, std::hypot(double{a.x} - double{c.x}, double{a.y} - double{c.y}) +
                              best_length(polygon, rest));
  }
  return best;
}

TEST(TriangulatePolygon, FewCornersHaveTheShortestDiagonals) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Polygon polygon = random_star_shaped(seed, 4 + seed % 5);
    std::vector<Index> all;
    for (Index i = 0; i < polygon.size(); ++i) all.push_back(i);
    PolygonTriangulator triangulator;
    Array<Index> ears;
    ASSERT_EQ(triangulator.run(polygon, {}, ears), Outcome::kDone);
    double length = 0;
    const Triangles triangles = triangles_of(polygon.size(), ears);
    for (std::size_t i = 0; i < ears.size(); ++i) {
      const Point a = polygon[triangles[i][0]];
      const Point c = polygon[triangles[i][2]];
      length += std::hypot(double{a.x} - double{c.x}, double{a.y} - double{c.y});
    }
    EXPECT_NEAR(length, best_length(polygon, all), 1e-6) << "seed " << seed;
  }
}

TEST(TriangulatePolygon, CornersOnALineAndInOnePlace) {
  // A square with points along its sides: no triangle without area.
  for (const std::size_t per_side : {2U, 5U, 20U, 100U}) {
    Polygon square;
    for (std::size_t i = 0; i < per_side; ++i) square.push_back({float(i), 0, 0});
    for (std::size_t i = 0; i < per_side; ++i) square.push_back({float(per_side), float(i), 0});
    for (std::size_t i = 0; i < per_side; ++i)
      square.push_back({float(per_side - i), float(per_side), 0});
    for (std::size_t i = 0; i < per_side; ++i) square.push_back({0, float(per_side - i), 0});
    expect_covered(square);
    Polygon doubled;  // each corner twice
    for (const Point& p : square) doubled.insert(doubled.end(), {p, p});
    expect_covered(doubled, false);
  }
  // A square with a square hole, by a cut that is passed twice.
  for (const int more : {0, 40}) {
    Polygon ring = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0},
                    {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}};
    for (int i = 0; i < more; ++i)
      ring.insert(ring.begin() + 1 + i, {float(9 * (i + 1)) / float(more + 1), 0, 0});
    expect_covered(ring, false);
  }
}

TEST(TriangulatePolygon, NoAreaOrCrossingStillGivesTriangles) {
  for (const std::size_t n : {4U, 10U, 33U, 500U}) {
    Polygon same(n);
    EXPECT_EQ(triangulate(same).size(), n - 2);
    Polygon line;
    for (std::size_t i = 0; i < n; ++i) line.push_back({float(i), float(i), 2 * float(i)});
    EXPECT_EQ(triangulate(line).size(), n - 2);
    Polygon crossing = regular(n);
    std::mt19937 random(5);
    std::shuffle(crossing.begin(), crossing.end(), random);
    EXPECT_EQ(triangulate(crossing).size(), n - 2);
    Polygon infinite = regular(n);
    infinite[1].x = INFINITY;
    infinite[2].y = NAN;
    EXPECT_EQ(triangulate(infinite).size(), n - 2);
  }
  // A bow-tie: its triangles cover the signed area, which is none.
  const Polygon bow_tie = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  double sum = 0;
  for (const auto& t : triangulate(bow_tie)) {
    sum += area(bow_tie[t[0]], bow_tie[t[1]], bow_tie[t[2]]);
  }
  EXPECT_NEAR(sum, 0, 1e-12);
}

TEST(TriangulatePolygon, NearlyFlatCornersAreToldExactly) {
  // Steps of one unit in the last place at coordinates of a million: double products lose them.
  const float x = 1e6F;
  const float step = 0.0625F;
  const Polygon thin = {{x, x, 0}, {x + 1, x + 1, 0}, {x + 2, x + 2 + step, 0}, {x, x + step, 0}};
  expect_covered(thin);
  const Polygon sliver = {
      {0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {16777216, 16777216, 0}, {8388608, 8388609, 0}};
  expect_covered(sliver);
}

TEST(TriangulatePolygon, ForbiddenDiagonalsAreAvoidedOrNamed) {
  const Polygon quad = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulate(quad, {{0, 2}}), (Triangles{{1, 2, 3}, {0, 1, 3}}));
  EXPECT_EQ(triangulate(quad, {{1, 3}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  PolygonTriangulator triangulator;
  Array<Index> ears;
  ASSERT_TRUE(ears.push_back(99));
  const std::vector<Diagonal> both = {{0, 2}, {1, 3}};
  EXPECT_EQ(triangulator.run(quad, both, ears), Outcome::kBlocked);
  EXPECT_TRUE(triangulator.blocked() == both[0] || triangulator.blocked() == both[1]);
  const Polygon dart = {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  const std::vector<Diagonal> only = {{0, 2}};
  EXPECT_EQ(triangulator.run(dart, only, ears), Outcome::kBlocked);
  EXPECT_EQ(triangulator.blocked(), only[0]);
  EXPECT_EQ(ears.size(), 1U);
  // Of many corners: all diagonals of one corner but those of a fan are left.
  const Polygon many = regular(100);
  std::vector<Diagonal> short_ones;
  for (Index i = 0; i + 2 < 100; ++i) {
    if (i % 3 != 0) short_ones.push_back({i, i + 2});
  }
  for (const auto& t : triangulate(many, short_ones)) {
    for (const auto& [a, b] : {std::pair(t[0], t[2]), std::pair(t[0], t[1])}) {
      const Diagonal diagonal{std::min(a, b), std::max(a, b)};
      EXPECT_FALSE(std::binary_search(short_ones.begin(), short_ones.end(), diagonal));
    }
  }
}

TEST(TriangulatePolygon, TenThousandCornersAreCovered) {
  for (const Polygon& polygon : {regular(10000), star(5000), comb(2500), spiral(5000),
                                 random_star_shaped(1, 10000), random_outline(1, 900, 100)}) {
    expect_covered(polygon);
  }
}

double seconds_to_cut(const Polygon& polygon) {
  PolygonTriangulator triangulator;
  Array<Index> ears;
  return seconds_of([&] { EXPECT_EQ(triangulator.run(polygon, {}, ears), Outcome::kDone); });
}

/// That 32 times as many corners take nowhere near 1024 times as long, as if each were compared
/// with each.
template <class MakePolygon>
void expect_almost_linear(std::size_t corners, const MakePolygon& make) {
  expect_at_most(
      300, [&] { return seconds_to_cut(make(corners / 32)); },
      [&] { return seconds_to_cut(make(corners)); });
}

TEST(TriangulatePolygon, TimeGrowsLittleFasterThanTheCorners) {
  const std::pair<const char*, std::function<Polygon(std::size_t)>> kinds[] = {
      {"star", [](std::size_t n) { return star(n / 2); }},
      {"comb", [](std::size_t n) { return comb(n / 4); }},
      {"spiral", [](std::size_t n) { return spiral(n / 2); }},
      {"random", [](std::size_t n) { return random_star_shaped(1, n); }}};
  for (const auto& [name, make] : kinds) {
    SCOPED_TRACE(name);
    expect_almost_linear(40'000, make);
  }
}

// There is no ear most of the time.
Polygon random_crossing(std::uint32_t seed, std::size_t n) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0, 1);
  Polygon polygon(n);
  for (Point& p : polygon) p = {unit(random), unit(random), 0};
  return polygon;
}

TEST(TriangulatePolygon, TimeOfCrossingPolygonsGrowsLittleFasterThanTheCorners) {
  expect_almost_linear(80'000, [](std::size_t n) { return random_crossing(1, n); });
}

// The rule by itself, with a look at all corners that are left: flat ones first, then those that
// turn left, then any, always the first from the one behind the last that was cut off.
TEST(TriangulatePolygon, OfCrossingPolygonsTheFirstCornerOfTheBestKindGoes) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // On a grid, so that some are flat.
    Polygon polygon = random_crossing(seed, 300);
    for (Point& p : polygon) p = {std::round(20 * p.x), std::round(20 * p.y), 0};
    if (area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
    PolygonTriangulator triangulator;
    Array<Index> ears;
    ASSERT_EQ(triangulator.run(polygon, {}, ears), Outcome::kDone);
    std::vector<Index> left(polygon.size());
    std::iota(left.begin(), left.end(), 0U);
    std::size_t start = 0;
    std::size_t without_ear = 0;
    for (std::size_t i = 0; left.size() > PolygonTriangulator::kSmall; ++i) {
      const auto at = [&](std::size_t k) { return polygon[left[k % left.size()]]; };
      const auto area_at = [&](std::size_t k) {
        return area(at(k + left.size() - 1), at(k), at(k + 1));
      };
      std::size_t expected = left.size();
      int best = 0;
      for (std::size_t k = start; k < start + left.size(); ++k) {
        const double turns = area_at(k);
        const int rank = turns == 0 ? 3 : turns > 0 ? 2 : 1;
        if (rank > best) {
          best = rank;
          expected = k % left.size();
        }
      }
      const auto cut = std::size_t(std::find(left.begin(), left.end(), ears[i]) - left.begin());
      const bool may_be_ear = area_at(cut) > 0;
      if (!may_be_ear) {
        ++without_ear;
        ASSERT_EQ(cut, expected) << i;
      }
      left.erase(left.begin() + std::ptrdiff_t(cut));
      start = cut % left.size();
    }
    EXPECT_GT(without_ear, 0U);
  }
}

TEST(RankTree, FindsTheNextOfTheHighestRank) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t n = 1 + random() % 70;
    RankTree tree;
    ASSERT_TRUE(tree.build(n));
    std::vector<int> ranks(n, 0);
    for (int round = 0; round < 300; ++round) {
      const Index changed = Index(random() % n);
      ranks[changed] = int(random() % 100) < 90 ? 0 : 1 + int(random() % 8);
      tree.set(changed, ranks[changed]);
      const int highest = *std::max_element(ranks.begin(), ranks.end());
      ASSERT_EQ(tree.highest(), highest);
      const Index from = Index(random() % n);
      for (int rank = 0; rank <= 8; ++rank) {
        Index expected = kNone;
        for (Index i = 0; rank > 0 && expected == kNone && i < n; ++i) {
          const Index item = Index((from + i) % n);
          if (ranks[item] == rank) expected = item;
        }
        ASSERT_EQ(tree.next(from, rank), expected) << "rank " << rank << " from " << from;
      }
    }
  }
}

TEST(PointTree, FindsWhatLiesInATriangle) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    // Many in the same place or on a line with others.
    const auto number = [&] { return float(random() % (seed % 3 == 0 ? 5 : 300)); };
    std::vector<PlanarPoint> points;
    for (std::size_t n = random() % 400; points.size() < n;) points.push_back({number(), number()});
    if (seed == 7 && !points.empty()) points[0] = {NAN, INFINITY};
    PointTree tree;
    ASSERT_TRUE(tree.build(points));
    std::vector<bool> is_in(points.size());
    for (int round = 0; round < 200; ++round) {
      for (int changes = 0; changes < 20 && !points.empty(); ++changes) {
        const auto i = Index(random() % points.size());
        is_in[i] ? tree.erase(i) : tree.insert(i);
        is_in[i] = !is_in[i];
      }
      PlanarPoint t[3] = {{number(), number()}, {number(), number()}, {number(), number()}};
      const int turns = turn_of(t[0], t[1], t[2]);
      if (turns == 0) continue;
      if (turns < 0) std::swap(t[1], t[2]);
      std::set<Index> expected;
      for (Index i = 0; i < points.size(); ++i) {
        EXPECT_EQ(tree.contains(i), is_in[i]);
        const PlanarPoint& p = points[i];
        const bool lies_inside = turn_of(t[0], t[1], p) >= 0 && turn_of(t[1], t[2], p) >= 0 &&
                                 turn_of(t[2], t[0], p) >= 0;
        if (is_in[i] && lies_inside) expected.insert(i);
      }
      std::set<Index> found;
      EXPECT_FALSE(tree.any_in(t, [&](Index i) {
        EXPECT_TRUE(found.insert(i).second);
        return false;
      }));
      EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
      EXPECT_EQ(tree.any_in(t, [&](Index i) { return expected.count(i) > 0; }), !expected.empty());
    }
  }
}

}  // namespace
}  // namespace halfedge::test
