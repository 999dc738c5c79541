// The faces of a mesh as triangles: those that `triangulate` makes, also where it would refuse.

#include <gtest/gtest.h>
#include <halfedge/halfedge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/copies.h"
#include "support/polygon_lists.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using Triangle = std::array<Index, 3>;
using Triangles = std::vector<Triangle>;

/// Where a triangle begins doesn't matter, nor their order.
Triangles in_order(Triangles triangles) {
  for (Triangle& t : triangles) t = std::min({t, {t[1], t[2], t[0]}, {t[2], t[0], t[1]}});
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Triangles triangles_of(const TriangleList& list) {
  EXPECT_EQ(list.corners.size(), 3 * list.faces.size());
  Triangles all(list.faces.size());
  for (std::size_t i = 0; i < list.corners.size(); ++i) all[i / 3][i % 3] = list.corners[i];
  return all;
}

template <Storage kStored>
Triangles triangles_of(const BasicMesh<kStored>& mesh) {
  return triangles_of(to_triangles(mesh).value());
}

/// The triangles of one face, from the list of all.
Triangles triangles_of(const TriangleList& list, Face f) {
  Triangles all;
  for (std::size_t i = 0; i < list.faces.size(); ++i) {
    const Index* const c = &list.corners[3 * i];
    if (list.faces[i] == f.index()) all.push_back({c[0], c[1], c[2]});
  }
  return all;
}

/// What `triangulate` makes of this face where it is the only one.
Triangles cut_alone(const Mesh& mesh, Face f) {
  const std::vector<Index> corners = polygon_of(mesh, f);
  std::vector<Index> numbers;
  for (Index i = 0; i < corners.size(); ++i) numbers.push_back(i);
  Mesh alone = reference_build(Shape("", Index(corners.size()), {numbers}));
  for (const Index i : numbers) alone.set_position(Vertex(i), mesh.position(Vertex(corners[i])));
  // The face of `alone` begins where that of the mesh does, for the choice between equals.
  alone.set_face_halfedge(Face(0), [&] {
    for (const Halfedge h : alone.face_halfedges_ccw(Face(0))) {
      if (alone.to_vertex(h) == Vertex(0)) return h;
    }
    return Halfedge{};
  }());
  EXPECT_TRUE(operations::triangulate(alone).ok());
  Triangles all;
  for (const std::vector<Index>& t : polygons_of(alone)) {
    all.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  }
  return in_order(all);
}

void expect_cut_as_alone(const Mesh& mesh) {
  const TriangleList list = to_triangles(mesh).value();
  EXPECT_TRUE(std::is_sorted(list.faces.begin(), list.faces.end()));
  std::size_t expected = 0;
  for (const Face f : mesh.faces()) {
    if (mesh.degree(f) < 3) continue;
    expected += mesh.degree(f) - 2;
    ASSERT_EQ(in_order(triangles_of(list, f)), cut_alone(mesh, f)) << f.index();
  }
  EXPECT_EQ(list.faces.size(), expected);
}

void scatter_vertices(Mesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> anywhere(-1, 1);
  for (const Vertex v : mesh.vertices()) {
    const float x = anywhere(random);
    const float y = anywhere(random);
    mesh.set_position(v, {x, y, 0.2F * anywhere(random)});
  }
}

TEST(Triangles, AreThoseThatTriangulateMakesOfEachFaceAlone) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = with_gaps(random_polygons(seed), seed);
    expect_cut_as_alone(mesh);
    scatter_vertices(mesh, seed);
    expect_cut_as_alone(mesh);
    ASSERT_FALSE(HasFailure());
  }
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_cut_as_alone(reference_build(shape));
  }
}

/// Whether no diagonal joins what is joined already, by an edge or by another diagonal.
bool diagonals_are_free(const Mesh& mesh) {
  const auto edges_of = [](const std::vector<Index>& corners) {
    std::set<std::pair<Index, Index>> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      edges.insert(std::minmax({corners[i], corners[(i + 1) % corners.size()]}));
    }
    return edges;
  };
  std::set<std::pair<Index, Index>> joined;
  for (const std::vector<Index>& face : polygons_of(mesh)) joined.merge(edges_of(face));
  const TriangleList list = to_triangles(mesh).value();
  for (const Face f : mesh.faces()) {
    const std::set<std::pair<Index, Index>> sides = edges_of(polygon_of(mesh, f));
    std::set<std::pair<Index, Index>> diagonals;
    for (const Triangle& t : triangles_of(list, f)) diagonals.merge(edges_of({t.begin(), t.end()}));
    for (const auto& diagonal : diagonals) {
      if (sides.count(diagonal) == 0 && !joined.insert(diagonal).second) return false;
    }
  }
  return true;
}

TEST(Triangles, AreThoseOfTheTriangulatedMeshWhereNoDiagonalIsInTheWay) {
  int free = 0;
  int in_the_way = 0;
  for (std::uint32_t seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = reference_build(random_polygons(seed));
    scatter_vertices(mesh, seed);
    if (!diagonals_are_free(mesh)) {
      ++in_the_way;
      continue;
    }
    ++free;
    const Triangles found = in_order(triangles_of(mesh));
    ASSERT_TRUE(operations::triangulate(mesh).ok());
    ASSERT_EQ(found, in_order(triangles_of(mesh)));
  }
  EXPECT_GT(free, 20);
  EXPECT_GT(in_the_way, 2);
}

/// Twice the area, in the plane z = 0.
double twice_area(const Mesh& mesh, const std::vector<Index>& corners) {
  double sum = 0;
  const Point o = mesh.position(Vertex(corners[0]));
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Point p = mesh.position(Vertex(corners[i]));
    const Point q = mesh.position(Vertex(corners[i + 1]));
    sum += (double{p.x} - double{o.x}) * (double{q.y} - double{o.y}) -
           (double{p.y} - double{o.y}) * (double{q.x} - double{o.x});
  }
  return sum;
}

/// Star-shaped polygons side by side, counter-clockwise, with many reflex corners.
Shape stars(std::uint32_t seed, Index most_corners) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Polys faces;
  std::vector<float> positions;
  for (int star = 0; star < 8; ++star) {
    const Index n = 4 + Index(random() % (most_corners - 3));
    std::vector<Index> corners;
    for (Index i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.6 * unit(random)) / n;
      const double radius = 0.3 + 2 * unit(random);
      corners.push_back(Index(positions.size() / 3));
      positions.push_back(float(6 * star + radius * std::cos(angle)));
      positions.push_back(float(radius * std::sin(angle)));
      positions.push_back(0);
    }
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(random() % n), corners.end());
    faces.push_back(corners);
  }
  Shape shape("stars", Index(positions.size() / 3), faces);
  shape.positions = positions;
  return shape;
}

TEST(Triangles, OfConcaveFacesCoverThemAndNeverFoldOver) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh mesh = reference_build(stars(seed, seed % 2 == 0 ? 12 : 90));
    const TriangleList list = to_triangles(mesh).value();
    for (const Face f : mesh.faces()) {
      const std::vector<Index> polygon = polygon_of(mesh, f);
      const Triangles triangles = triangles_of(list, f);
      ASSERT_EQ(triangles.size(), polygon.size() - 2);
      double sum = 0;
      for (const Triangle& t : triangles) {
        const double area = twice_area(mesh, {t.begin(), t.end()});
        EXPECT_GT(area, 0);
        sum += area;
      }
      EXPECT_NEAR(sum, twice_area(mesh, polygon), 1e-9 * sum);
    }
    ASSERT_FALSE(HasFailure());
  }
}

TEST(Triangles, AreThereWhereTriangulateRefuses) {
  // Two darts with the same four corners, back to back: both need 0-2.
  Mesh mesh = reference_build({"darts", 4, {{0, 1, 2, 3}, {3, 2, 1, 0}}});
  const Point points[] = {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  for (const Vertex v : mesh.vertices()) mesh.set_position(v, points[v.index()]);
  EXPECT_EQ(operations::check_triangulate(mesh).error().code, "no-triangulation");
  EXPECT_EQ(in_order(triangles_of(mesh)), (Triangles{{0, 1, 2}, {0, 2, 1}, {0, 2, 3}, {0, 3, 2}}));
}

TEST(Triangles, NameTheHalfedgesThatEndInTheirCorners) {
  Mesh mesh = with_gaps(random_polygons(7), 7);
  scatter_vertices(mesh, 7);
  const TriangleList vertices = to_triangles(mesh).value();
  const TriangleList halfedges = to_triangles(mesh, CornersAs::kHalfedges).value();
  ASSERT_EQ(halfedges.faces.size(), vertices.faces.size());
  ASSERT_EQ(halfedges.corners.size(), vertices.corners.size());
  ASSERT_GT(halfedges.faces.size(), 10U);
  for (std::size_t i = 0; i < halfedges.corners.size(); ++i) {
    const Halfedge h(halfedges.corners[i]);
    EXPECT_EQ(mesh.to_vertex(h).index(), vertices.corners[i]);
    EXPECT_EQ(mesh.face(h).index(), halfedges.faces[i / 3]);
    EXPECT_EQ(vertices.faces[i / 3], halfedges.faces[i / 3]);
  }
}

TEST(Triangles, OfSomeFacesComeInTheOrderOfTheseAndLeaveOutWhatIsNotThere) {
  const Mesh mesh = with_gaps(random_polygons(4), 4);
  const TriangleList all = to_triangles(mesh).value();
  std::vector<Index> faces = {kNone, mesh.face_slots(), mesh.face_slots() + 7};
  for (Index f = mesh.face_slots(); f-- > 0;) faces.insert(faces.end(), {f, f});
  ASSERT_LT(mesh.face_count(), mesh.face_slots());
  const TriangleList some = to_triangles(mesh, faces).value();
  std::size_t at = 0;
  for (const Index f : faces) {
    for (const Triangle& t : triangles_of(all, Face(f))) {
      ASSERT_LT(at, some.faces.size());
      EXPECT_EQ(some.faces[at], f);
      EXPECT_TRUE(std::equal(t.begin(), t.end(), &some.corners[3 * at])) << f;
      ++at;
    }
  }
  EXPECT_EQ(at, some.faces.size());
  EXPECT_EQ(at, 2 * all.faces.size());
  EXPECT_TRUE(to_triangles(mesh, std::span<const Index>{}).value().faces.empty());
  const Face first(all.faces[0]);
  const std::size_t corners = 3 * triangles_of(all, first).size();
  EXPECT_TRUE(std::ranges::equal(to_triangles(mesh, first).value().corners,
                                 all.corners.span().first(corners)));
}

TEST(Triangles, OfDegenerateComplexesAreNone) {
  Mesh mesh = reference_build(triangle_grid(5, 5));
  ASSERT_TRUE(decorator::make_segment(mesh).ok());
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(decorator::make_loop(mesh).ok());
  EXPECT_EQ(in_order(triangles_of(mesh)),
            in_order(triangles_of(reference_build(triangle_grid(5, 5)))));
  EXPECT_EQ(triangles_of(mesh).size(), 50U);
  EXPECT_TRUE(triangles_of(Mesh{}).empty());
  const std::vector<Index> loop = {mesh.face_slots() - 1};
  EXPECT_TRUE(to_triangles(mesh, loop).value().faces.empty());
  // More triangles than would be left if each face took two of the corners.
  Mesh first;
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(decorator::make_loop(first).ok());
  ASSERT_TRUE(append(first, reference_build(mixed_polygons())).ok());
  EXPECT_EQ(triangles_of(first).size(), triangles_of(reference_build(mixed_polygons())).size());
}

TEST(Triangles, OfEveryStorageWithAnchorsAndFacesAreTheSame) {
  const Mesh mesh = reference_build(random_polygons(3));
  BasicMesh<kWithoutPrev> lean;
  BasicMesh<kPrevAtRunTime> chosen;
  ASSERT_TRUE(append(lean, mesh).ok());
  ASSERT_TRUE(append(chosen, mesh).ok());
  EXPECT_EQ(triangles_of(lean), triangles_of(mesh));
  EXPECT_EQ(triangles_of(chosen), triangles_of(mesh));
}

TEST(Triangles, OfALargeMeshInNoOrderAreItsFaces) {
  const Shape shape = in_random_order(with_random_names(triangle_grid(160, 160)));
  Mesh mesh;
  BuildReport report;
  ASSERT_TRUE(build_from_polygons(mesh, shape.polygons(), report));
  const TriangleList list = to_triangles(mesh).value();
  ASSERT_EQ(list.faces.size(), mesh.face_count());
  for (const Face f : mesh.faces()) {
    ASSERT_EQ(list.faces[f.index()], f.index());
    const Index* corner = &list.corners[3 * std::size_t{f.index()}];
    for (const Vertex v : mesh.face_vertices_ccw(f)) ASSERT_EQ(*corner++, v.index());
  }
}

TEST(Triangles, AreAsManyWherePositionsAreNoNumbers) {
  const float wrong[] = {
      std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
      -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::max()};
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    Mesh mesh = reference_build(stars(std::uint32_t(random()), round % 3 == 0 ? 5 : 80));
    for (Index i = 0; i < 1 + random() % 40; ++i) {
      const Index v = Index(random() % mesh.vertex_slots());
      mesh.mutable_positions()[3 * v + random() % 3] = wrong[random() % 4];
    }
    if (round % 10 == 0) std::ranges::fill(mesh.mutable_positions(), wrong[round / 10 % 4]);
    const TriangleList list = to_triangles(mesh).value();
    for (const Face f : mesh.faces()) {
      const std::vector<Index> polygon = polygon_of(mesh, f);
      std::set<Index> used;
      const Triangles triangles = triangles_of(list, f);
      EXPECT_EQ(triangles.size(), polygon.size() - 2);
      for (const Triangle& t : triangles) used.insert(t.begin(), t.end());
      EXPECT_EQ(used, std::set<Index>(polygon.begin(), polygon.end()));
    }
    ASSERT_FALSE(HasFailure());
  }
}

TEST(Triangles, OfACorruptMeshAreAnErrorOrNameWhatIsThere) {
  std::mt19937 random(5);
  int errors = 0;
  const Mesh whole[] = {with_gaps(random_polygons(1), 3), with_gaps(random_polygons(2), 3),
                        reference_build(torus(5, 4)), reference_build(triangle_grid(5, 5))};
  for (int round = 0; round < 4000; ++round) {
    Mesh mesh = copy_of(whole[round % 4]);
    Links& links = mesh.mutable_links();
    Array<Index>* const arrays[] = {&links.next, &links.to_vertex, &links.face_halfedge};
    for (int i = 0; i < 2; ++i) {
      Array<Index>& array = *arrays[random() % 3];
      const Index values[] = {kNone, kDeleted, Index(random()), Index(random() % 60), 0};
      array[random() % array.size()] = values[random() % 5];
    }
    std::vector<Index> faces;
    for (Index f = 0; f < mesh.face_slots() + 2; ++f) faces.push_back(f);
    const CornersAs corners_as = round % 3 == 0 ? CornersAs::kHalfedges : CornersAs::kVertices;
    const Index corners =
        corners_as == CornersAs::kVertices ? mesh.vertex_slots() : mesh.halfedge_slots();
    const Result<TriangleList> all = to_triangles(mesh, corners_as);
    const Result<TriangleList> some = to_triangles(mesh, faces, corners_as);
    for (const Result<TriangleList>* result : {&all, &some}) {
      if (!*result) {
        ++errors;
        EXPECT_EQ(result->error().code, "corrupt-connectivity");
        EXPECT_EQ(result->error().witness.faces.size(), 1U);
        continue;
      }
      const TriangleList& list = result->value();
      ASSERT_EQ(list.corners.size(), 3 * list.faces.size());
      for (const Index corner : list.corners) ASSERT_LT(corner, corners);
      for (const Index f : list.faces) ASSERT_TRUE(mesh.is_live(Face(f)));
    }
  }
  EXPECT_GT(errors, 2000);

  Mesh broken = reference_build(cube());
  const Index h = broken.face_halfedge(Face(2)).index();
  for (Array<Index>* const links :
       {&broken.mutable_links().next, &broken.mutable_links().to_vertex}) {
    const Index was = std::exchange((*links)[h], 99);
    EXPECT_EQ(to_triangles(broken).error().message,
              "The ring around face 2 does not close, or leads to vertices that don't exist: "
              "validate names the broken links.");
    (*links)[h] = was;
  }
  EXPECT_TRUE(to_triangles(broken).ok());
  ASSERT_TRUE(broken.mutable_links().next.resize(3));
  EXPECT_EQ(to_triangles(broken).error().code, "corrupt-connectivity");
}

// Each face leads into the same long loop: what is walked must not be the square of that.
TEST(Triangles, OfManyFacesWithOneLoopEndSoon) {
  Mesh mesh = shapes::mesh_of(shapes::grid(20000, 1)).value();
  Links& links = mesh.mutable_links();
  for (Index h = 0; h < links.next.size(); ++h) {
    links.next[h] = h + 1 == links.next.size() ? 0 : h + 1;
  }
  EXPECT_EQ(to_triangles(mesh).error().code, "corrupt-connectivity");
}

// More triangles than a mesh of so many edges can have.
TEST(Triangles, OfManyFacesWithOneQuadAreThatQuadAgainAndAgain) {
  for (const bool of_quads : {false, true}) {
    Mesh mesh = of_quads ? reference_build(cube()) : reference_build(triangle_grid(5, 5));
    Links& links = mesh.mutable_links();
    const Index loop[] = {0, 2, 4, 6};
    for (std::size_t i = 0; i < 4; ++i) links.next[loop[i]] = loop[(i + 1) % 4];
    for (Index& h : links.face_halfedge) h = 2;
    const Result<TriangleList> list = to_triangles(mesh, CornersAs::kHalfedges);
    ASSERT_TRUE(list.ok());
    EXPECT_EQ(list.value().faces.size(), 2 * mesh.face_count());
    for (const Index h : list.value().corners) EXPECT_TRUE(h % 2 == 0 && h < 8) << h;
  }
}

}  // namespace
}  // namespace halfedge::test
