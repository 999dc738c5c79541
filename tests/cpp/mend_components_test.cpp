// Repairs of whole components: outward orientation, and dropping small ones.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/mend/measure.h>
#include <halfedge/operations/append.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "support/mending.h"

namespace halfedge::test {
namespace {

using mend::Code;

auto orient_with(mend::OrientOptions options) {
  return [=](auto& mesh) { return mend::orient_outward(mesh, options); };
}
const auto orient = orient_with({});
auto drop_with(mend::DropOptions options) {
  return [=](auto& mesh) { return mend::drop_small_components(mesh, options); };
}

/// The sum over all faces, by Gauss.
double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const Face f : mesh.faces()) {
    const std::vector<Index> corners = corners_of(mesh, mesh.face_halfedge(f));
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Point a = mesh.position(Vertex(corners[0]));
      const Point b = mesh.position(Vertex(corners[i - 1]));
      const Point c = mesh.position(Vertex(corners[i]));
      volume += double(a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                       a.z * (b.x * c.y - b.y * c.x)) /
                6;
    }
  }
  return volume;
}

Mesh moved(Mesh mesh, float x, float scale = 1) {
  for (const Vertex v : mesh.vertices()) {
    const Point p = mesh.position(v);
    mesh.set_position(v, {x + scale * p.x, scale * p.y, scale * p.z});
  }
  return mesh;
}

Mesh cube_at(float x, float scale = 1) {
  return moved(shapes::mesh_of(shapes::cube()).value(), x, scale);
}

TEST(OrientOutward, TurnsAClosedComponentOver) {
  Mesh mesh = cube_at(0);
  ASSERT_TRUE(operations::reverse(mesh));
  EXPECT_NEAR(volume_of(mesh), -1, 1e-6);
  const mend::Report report = mended(mesh, orient);
  EXPECT_NEAR(volume_of(mesh), 1, 1e-6);
  EXPECT_EQ(report.summary, "1 component turned over.");
  EXPECT_EQ(report.faces.size(), 6U);
  EXPECT_EQ(mended(mesh, orient).summary, "Nothing to repair.");
}

TEST(OrientOutward, TurnsOverThoseComponentsThatNeedIt) {
  Mesh mesh;
  for (int i = 0; i < 7; ++i) ASSERT_TRUE(append(mesh, cube_at(float(3 * i))));
  for (const Index f : {0U, 12U, 36U}) {
    ASSERT_TRUE(operations::reverse_component(mesh, mesh.face_halfedge(Face(f))));
  }
  EXPECT_NEAR(volume_of(mesh), 1, 1e-4);
  const mend::Report report = mended(mesh, orient);
  EXPECT_EQ(report.count(Code::kReversedComponent), 3U);
  EXPECT_NEAR(volume_of(mesh), 7, 1e-4);
  std::vector<Index> turned;
  for (const Index first : {0U, 12U, 36U}) {
    for (Index f = first; f < first + 6; ++f) turned.push_back(f);
  }
  EXPECT_EQ(std::vector<Index>(report.faces.begin(), report.faces.end()), turned);
}

TEST(OrientOutward, SeesSmallComponentsFarAway) {
  Mesh mesh = cube_at(1e4F, 0.01F);
  ASSERT_TRUE(operations::reverse(mesh));
  EXPECT_EQ(mended(mesh, orient).count(Code::kReversedComponent), 1U);
  EXPECT_EQ(mended(mesh, orient).count(Code::kReversedComponent), 0U);
}

TEST(OrientOutward, LeavesWhatIsOpenOrFlat) {
  Mesh mesh = shapes::mesh_of(shapes::cylinder(8, 2, shapes::Caps::kOpen)).value();
  Mesh pillow = mesh_of({{9, 0, 0}, {10, 0, 0}, {9, 1, 0}}, {{0, 1, 2}, {2, 1, 0}});
  ASSERT_TRUE(append(mesh, pillow));
  ASSERT_TRUE(operations::reverse(mesh));
  const Snapshot before(mesh);
  const Result<mend::Report> report = mend::orient_outward(mesh);
  ASSERT_TRUE(report);
  EXPECT_TRUE(Snapshot(mesh) == before);
  EXPECT_EQ(report.value().summary, "1 open component left, 1 component without volume left.");
  ASSERT_EQ(report.value().problems.size(), 2U);
  EXPECT_EQ(report.value().problems[0].code, "open-component");
  EXPECT_EQ(report.value().problems[0].message,
            "The component of face 0, of 16 faces, has 2 boundary loops, expected none: what is "
            "open has no inside.");
  EXPECT_EQ(report.value().problems[1].code, "flat-component");
  EXPECT_EQ(report.value().problems[1].witness.faces, (std::vector<Index>{16}));
  (void)mended(mesh, orient);
}

TEST(OrientOutward, TurnsOpenComponentsAwayFromTheirCentreIfAsked) {
  for (const bool is_reversed : {false, true}) {
    Mesh mesh = moved(shapes::mesh_of(shapes::uv_sphere(12, 8)).value(), 5);
    for (int i = 0; i < 30; ++i) {
      ASSERT_TRUE(operations::delete_face(mesh, *mesh.faces().begin()));
    }
    if (is_reversed) {
      ASSERT_TRUE(operations::reverse(mesh));
    }
    const mend::Report report = mended(mesh, orient_with({.open = true}));
    EXPECT_EQ(report.count(Code::kReversedComponent), is_reversed ? 1U : 0U);
    EXPECT_EQ(report.count(Code::kOpenComponent), 0U);
  }
}

// Half a unit sphere, whose centre of area is half way up: the cone from there to the faces.
TEST(OrientOutward, MeasuresOpenComponentsFromTheirCentre) {
  Mesh mesh = moved(shapes::mesh_of(shapes::uv_sphere(96, 96)).value(), 7);
  for (Index i = 0; i < mesh.face_slots(); ++i) {
    const Face f(i);
    double height = 0;
    for (const Vertex v : mesh.face_vertices_ccw(f)) height += double{mesh.position(v).y};
    if (height < 0) {
      ASSERT_TRUE(operations::delete_face(mesh, f));
    }
  }
  Array<mend::Extent> extents;
  const mend::SurfaceOf<kEverything> surface(mesh);
  ASSERT_TRUE(mend::measure(surface, connected_components(mesh).value(), extents));
  ASSERT_EQ(extents.size(), 1U);
  EXPECT_NEAR(extents[0].volume, 1.5708, 0.005);
  EXPECT_NEAR(extents[0].area, 6.2832, 0.01);
  EXPECT_NEAR(extents[0].diagonal(), 3, 1e-5);
}

// A chevron with three flaps on its sides: the centre of the area is the same from whichever corner
// the chevron is cut into triangles.
TEST(OrientOutward, MeasuresConcaveFacesFromAnyCorner) {
  const std::vector<Point> chevron = {{0, -0.5F, 0}, {10.5F, 10, 0}, {10, 10, 0},
                                      {0, 0, 0},     {-10, 10, 0},   {-10.5F, 10, 0}};
  double volume = 0;
  for (std::size_t first = 0; first < 6; ++first) {
    SCOPED_TRACE(first);
    std::vector<Point> points;
    for (std::size_t i = 0; i < 6; ++i) points.push_back(chevron[(first + i) % 6]);
    const auto corner = [&](std::size_t i) { return Index((i + 6 - first) % 6); };
    points.insert(points.end(), {{7, 3, 4}, {-7, 3, 2}, {1, 9, -1}});
    Mesh mesh = mesh_of(points, {{0, 1, 2, 3, 4, 5},
                                 {corner(1), corner(0), 6},
                                 {corner(0), corner(5), 7},
                                 {corner(3), corner(2), 8}});
    Array<mend::Extent> extents;
    const mend::SurfaceOf<kEverything> surface(mesh);
    ASSERT_TRUE(mend::measure(surface, connected_components(mesh).value(), extents));
    if (first == 0) volume = extents[0].volume;
    EXPECT_NEAR(extents[0].volume, volume, 1e-9);
    EXPECT_GT(std::abs(volume), 1);
  }
}

TEST(OrientOutward, TakesNestedComponentsForCavitiesIfAsked) {
  for (unsigned turned = 0; turned < 8; ++turned) {
    SCOPED_TRACE(turned);
    Mesh mesh;
    for (unsigned i = 0; i < 3; ++i) {
      Mesh sphere = moved(shapes::mesh_of(shapes::ico_sphere(2)).value(), 0, float(1 << i));
      if ((turned >> i & 1U) != 0) {
        ASSERT_TRUE(operations::reverse(sphere));
      }
      ASSERT_TRUE(append(mesh, sphere));
    }
    ASSERT_TRUE(append(mesh, cube_at(9)));
    const double unit = volume_of(shapes::mesh_of(shapes::ico_sphere(2)).value());
    Mesh each = copy_of(mesh);
    (void)mended(each, orient);
    EXPECT_NEAR(volume_of(each), unit * (1 + 8 + 64) + 1, 1e-2);
    (void)mended(mesh, orient_with({.nested = true}));
    EXPECT_NEAR(volume_of(mesh), unit * (1 - 8 + 64) + 1, 1e-2);
  }
}

// A block with a notch, and a cube that touches it: outside, on the floor of the notch, or inside,
// as a cavity. Whatever face and corner of the cube comes first.
TEST(OrientOutward, TellsInsideFromOutsideWhereComponentsTouch) {
  const std::vector<std::array<float, 2>> outline = {{0, 0}, {10, 0}, {10, 10}, {8, 10},
                                                     {8, 2}, {2, 2},  {2, 10},  {0, 10}};
  const std::vector<std::vector<Index>> cube_faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                      {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  struct Case {
    Point at;
    float size;
    double volume;
  };
  for (const Case& placed : {Case{{4, 2, 4}, 2, 520 + 8}, Case{{4, 0, 4}, 1, 520 - 1},
                             Case{{4, 1, 4}, 1, 520 - 1}, Case{{2, 4, 4}, 1, 520 + 1}}) {
    for (std::size_t turn = 0; turn < 24; ++turn) {
      SCOPED_TRACE(testing::Message() << placed.at.x << ' ' << placed.at.y << ", turn " << turn);
      std::vector<Point> points;
      for (const float z : {0.F, 10.F}) {
        for (const auto& [x, y] : outline) points.push_back({x, y, z});
      }
      std::vector<std::vector<Index>> faces = {{7, 6, 5, 4, 3, 2, 1, 0},
                                               {8, 9, 10, 11, 12, 13, 14, 15}};
      for (Index i = 0; i < 8; ++i) {
        const Index j = (i + 1) % 8;
        faces.push_back({i, j, j + 8, i + 8});
      }
      for (Index i = 0; i < 8; ++i) {
        const float x = i % 4 == 1 || i % 4 == 2 ? placed.size : 0;
        const float y = i % 4 >= 2 ? placed.size : 0;
        const float z = i >= 4 ? placed.size : 0;
        points.push_back({placed.at.x + x, placed.at.y + y, placed.at.z + z});
      }
      for (std::size_t f = 0; f < 6; ++f) {
        std::vector<Index> corners = cube_faces[(f + turn / 4) % 6];
        std::rotate(corners.begin(), corners.begin() + long(turn % 4), corners.end());
        for (Index& v : corners) v += 16;
        faces.push_back(corners);
      }
      Mesh mesh = mesh_of(points, faces);
      (void)mended(mesh, orient_with({.nested = true}));
      EXPECT_NEAR(volume_of(mesh), placed.volume, 1e-3);
    }
  }
}

TEST(OrientOutward, LeavesCopiesInOnePlaceAsTheyAre) {
  Mesh mesh = cube_at(0);
  ASSERT_TRUE(append(mesh, cube_at(0)));
  EXPECT_EQ(mended(mesh, orient_with({.nested = true})).summary, "Nothing to repair.");
}

TEST(OrientOutward, IsSafeWithPositionsThatAreNoNumbers) {
  Mesh mesh = cube_at(0);
  mesh.set_position(Vertex(0), {std::nanf(""), 0, 0});
  const Result<mend::Report> report = mend::orient_outward(mesh, {.nested = true});
  ASSERT_TRUE(report);
  EXPECT_EQ(report.value().count(Code::kFlatComponent), 1U);
  EXPECT_EQ(
      report.value().problems[0].message,
      "The component of face 0, of 6 faces, has a position that is no finite number, expected "
      "a volume.");
}

TEST(DropSmallComponents, DropsThoseWithFewFaces) {
  Mesh mesh = cube_at(0);
  ASSERT_TRUE(append(mesh, shapes::mesh_of(shapes::tetrahedron()).value()));
  ASSERT_TRUE(append(mesh, shapes::mesh_of(shapes::ico_sphere(1)).value()));
  const Vertex isolated = mesh.add_vertex({7, 7, 7});
  const mend::Report report = mended(mesh, drop_with({.faces = 7}));
  EXPECT_EQ(counts_of(mesh), (std::array<Index, 3>{43, 120, 80}));
  EXPECT_TRUE(mesh.is_live(isolated));
  EXPECT_EQ(report.summary, "2 components dropped.");
  ASSERT_EQ(report.faces.size(), 10U);
  EXPECT_EQ(report.faces[9], 9U);
  EXPECT_EQ(mesh.free_faces().count, 10U);
}

TEST(DropSmallComponents, KeepsThoseWithJustEnough) {
  Mesh mesh = cube_at(0);
  EXPECT_EQ(mended(mesh, drop_with({.faces = 6})).summary, "Nothing to repair.");
  EXPECT_EQ(mended(mesh, drop_with({})).summary, "Nothing to repair.");
  EXPECT_EQ(mended(mesh, drop_with({.area = 1, .diagonal = 1})).summary, "Nothing to repair.");
  EXPECT_EQ(mesh.face_count(), 6U);
}

TEST(DropSmallComponents, DropsByShareOfTheLargestAreaOrDiagonal) {
  Mesh mesh;
  for (const float size : {1.0F, 0.5F, 0.2F, 0.1F}) {
    ASSERT_TRUE(append(mesh, cube_at(10 * size, size)));
  }
  Mesh by_area = copy_of(mesh);
  EXPECT_EQ(mended(by_area, drop_with({.area = 0.05})).summary, "2 components dropped.");
  Mesh by_diagonal = copy_of(mesh);
  EXPECT_EQ(mended(by_diagonal, drop_with({.diagonal = 0.15})).summary, "1 component dropped.");
  EXPECT_EQ(by_diagonal.face_count(), 18U);
}

// A chevron of area 10.25, of which the triangles that have its outer tip as a corner measure more,
// and a square of area 25.
TEST(DropSmallComponents, MeasuresConcaveFacesFromAnyCorner) {
  const std::vector<Point> chevron = {{0, -0.5F, 0}, {10.5F, 10, 0}, {10, 10, 0},
                                      {0, 0, 0},     {-10, 10, 0},   {-10.5F, 10, 0}};
  const std::vector<Point> square = {{20, 0, 0}, {25, 0, 0}, {25, 5, 0}, {20, 5, 0}};
  for (std::size_t first = 0; first < 6; ++first) {
    SCOPED_TRACE(first);
    std::vector<Point> points;
    for (std::size_t i = 0; i < 6; ++i) points.push_back(chevron[(first + i) % 6]);
    points.insert(points.end(), square.begin(), square.end());
    Mesh mesh = mesh_of(points, {{0, 1, 2, 3, 4, 5}, {6, 7, 8, 9}});
    Array<mend::Extent> extents;
    const mend::SurfaceOf<kEverything> surface(mesh);
    ASSERT_TRUE(mend::measure(surface, connected_components(mesh).value(), extents));
    EXPECT_NEAR(extents[0].area, 10.25, 1e-12);
    EXPECT_NEAR(extents[1].area, 25, 1e-12);
    (void)mended(mesh, drop_with({.area = 0.9}));
    EXPECT_TRUE(mesh.is_deleted(Face(0)));
    EXPECT_TRUE(mesh.is_live(Face(1)));
  }
}

TEST(DropSmallComponents, DropsADustOfMany) {
  Mesh mesh = soup_of(shapes::mesh_of(shapes::ico_sphere(5)).value());
  ASSERT_TRUE(append(mesh, cube_at(0)));
  EXPECT_EQ(mended(mesh, drop_with({.faces = 2})).summary, "20480 components dropped.");
  EXPECT_EQ(counts_of(mesh), (std::array<Index, 3>{8, 12, 6}));
}

TEST(DropSmallComponents, RefusesAShare) {
  for (const mend::DropOptions& options :
       {mend::DropOptions{.area = std::nan("")}, mend::DropOptions{.diagonal = -0.5}}) {
    Mesh mesh = cube_at(0);
    const Result<mend::Report> report = drop_with(options)(mesh);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, "bad-share");
    EXPECT_EQ(mesh.face_count(), 6U);
  }
  Mesh mesh = cube_at(0);
  EXPECT_EQ(drop_with({.area = 1.5})(mesh).error().message,
            "The least share of the area is 1.5; expected a number from 0 to 1.");
}

}  // namespace
}  // namespace halfedge::test
