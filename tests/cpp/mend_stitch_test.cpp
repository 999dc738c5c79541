// Stitching boundary edges, and splitting pinched vertices.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/operations/append.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/mending.h"

namespace halfedge::test {
namespace {

using mend::Code;

const auto stitch = [](auto& mesh) { return mend::stitch_boundaries(mesh); };
auto stitch_within(double tolerance) {
  return [=](auto& mesh) {
    return mend::stitch_boundaries(mesh, mend::StitchOptions{.tolerance = tolerance});
  };
}
const auto split = [](auto& mesh) { return mend::split_pinched_vertices(mesh); };

using Counts3 = std::array<Index, 3>;

/// What is left is on the boundary, and can't be glued if the report says so.
void expect_true(const mend::Report& report, const Mesh& mesh) {
  for (const Error& problem : report.problems) {
    std::vector<Halfedge> sides;
    for (const Index e : problem.witness.edges) {
      ASSERT_TRUE(mesh.is_live(Edge(e))) << problem.message;
      const Halfedge h = mesh.edge_halfedge(Edge(e));
      sides.push_back(mesh.is_boundary(h) ? h : mesh.opposite(h));
      EXPECT_TRUE(mesh.is_boundary(sides.back())) << problem.message;
    }
    if (problem.code != "unstitchable-edge") continue;
    ASSERT_EQ(sides.size(), 2U);
    EXPECT_FALSE(operations::check_glue(mesh, sides[0], sides[1])) << problem.message;
  }
}

TEST(StitchBoundaries, JoinsTwoTrianglesAtTheirCommonEdge) {
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                      {{0, 1, 2}, {3, 4, 5}});
  const mend::Report report = mended(mesh, stitch);
  EXPECT_EQ(counts_of(mesh), (Counts3{4, 5, 2}));
  EXPECT_EQ(report.summary, "1 edge stitched.");
  ASSERT_EQ(report.edges.size(), 1U);
  EXPECT_EQ(Edge(report.edges[0]), mesh.find_edge(Vertex(1), Vertex(2)));
  EXPECT_FALSE(mesh.is_boundary(Edge(report.edges[0])));
  EXPECT_TRUE(report.problems.empty());
}

TEST(StitchBoundaries, LeavesVerticesApartThatMerelyTouch) {
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
                      {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(mended(mesh, stitch).summary, "Nothing to repair.");
  EXPECT_EQ(counts_of(mesh), (Counts3{6, 6, 2}));
}

TEST(StitchBoundaries, MakesTheMeshAgainOfItsFaces) {
  using shapes::Caps;
  for (const Result<PolygonSoup>& shape :
       {shapes::tetrahedron(), shapes::cube(), shapes::octahedron(), shapes::icosahedron(),
        shapes::dodecahedron(), shapes::prism(7), shapes::cone(9, Caps::kFans),
        shapes::cylinder(5, 3, Caps::kOpen), shapes::grid(4, 3), shapes::torus(5, 4),
        shapes::uv_sphere(6, 5), shapes::ico_sphere(2)}) {
    const Result<Mesh> whole = shapes::mesh_of(shape);
    ASSERT_TRUE(whole);
    Mesh mesh = soup_of(whole.value());
    const mend::Report report = mended(mesh, stitch);
    EXPECT_EQ(counts_of(mesh), counts_of(whole.value()));
    EXPECT_EQ(report.count(Code::kStitchedEdge), report.edges.size());
    EXPECT_TRUE(report.problems.empty()) << report.problems[0].message;
    EXPECT_EQ(connected_components(mesh).value().list.size(), 1U);
  }
}

// What a slit of any length is: no edge of it can be glued alone where both ends are closed.
TEST(StitchBoundaries, ClosesSlitsOfAnyLength) {
  for (const Index length : {2U, 3U, 4U, 5U, 6U, 40U}) {
    for (const bool is_reversed : {false, true}) {
      SCOPED_TRACE(length);
      Mesh mesh = shapes::mesh_of(shapes::grid(length + 2, 2, shapes::Faces::kTriangles)).value();
      const Counts3 whole = counts_of(mesh);
      std::vector<Halfedge> path;
      for (Index i = 0; i < length; ++i) {
        const Vertex v(length + 4 + (is_reversed ? length - i : i));
        const Vertex w(is_reversed ? v.index() - 1 : v.index() + 1);
        path.push_back(mesh.find_halfedge(v, w));
      }
      ASSERT_TRUE(operations::cut_path(mesh, path));
      EXPECT_EQ(mesh.vertex_count(), whole[0] + length - 1);
      const mend::Report report = mended(mesh, stitch);
      EXPECT_EQ(counts_of(mesh), whole) << report.summary;
      EXPECT_EQ(report.count(Code::kStitchedEdge), length);
    }
  }
}

TEST(StitchBoundaries, TakesVerticesWithinTheToleranceAsOne) {
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1.01F, 0}, {1, 0.01F, 0}, {1, 1, 0}},
                      {{0, 1, 2}, {3, 4, 5}});
  Mesh too_far = copy_of(mesh);
  EXPECT_EQ(mended(too_far, stitch_within(0.009)).summary, "Nothing to repair.");
  EXPECT_EQ(mended(mesh, stitch_within(0.011)).summary, "1 edge stitched.");
  EXPECT_EQ(mesh.position(Vertex(1)), (Point{1, 0, 0})) << "the first edge stays where it is";
  EXPECT_EQ(mesh.position(Vertex(2)), (Point{0, 1, 0}));
}

TEST(StitchBoundaries, LeavesThreeEdgesInOnePlace) {
  Mesh mesh = mesh_of({{0, 0, 0},
                       {1, 0, 0},
                       {0, 1, 0},
                       {1, 0, 0},
                       {0, 0, 0},
                       {0, -1, 0},
                       {1, 0, 0},
                       {0, 0, 0},
                       {0, 0, 1}},
                      {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
  const mend::Report report = mended(mesh, stitch);
  EXPECT_EQ(counts_of(mesh), (Counts3{9, 9, 3}));
  EXPECT_EQ(report.count(Code::kAmbiguousEdge), 3U);
  ASSERT_EQ(report.problems.size(), 3U);
  EXPECT_EQ(report.problems[0].code, "ambiguous-edge");
  EXPECT_EQ(report.problems[0].message,
            "Edge 0 lies together with 2 other boundary edges, expected one: which to glue it to "
            "can't be told.");
  EXPECT_EQ(report.problems[0].witness.edges, (std::vector<Index>{0}));
  EXPECT_EQ(report.summary, "3 edges left which several others fit.");
}

TEST(StitchBoundaries, KeepsTwoCubesApartThatShareAnEdge) {
  Mesh both = shapes::mesh_of(shapes::cube()).value();
  Mesh other = copy_of(both);
  for (const Vertex v : other.vertices()) {
    const Point p = other.position(v);
    other.set_position(v, {p.x + 1, p.y + 1, p.z});
  }
  ASSERT_TRUE(append(both, other));
  Mesh mesh = soup_of(both);
  const mend::Report report = mended(mesh, stitch);
  EXPECT_EQ(counts_of(mesh), (Counts3{16, 24, 12}));
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(report.summary, "24 edges stitched.");
}

/// Rows of cubes in two opposite quadrants around an axis, on which they meet in `length` edges: as
/// many boxes of quads, of which no two faces share a vertex.
Mesh boxes_along_an_axis(Index length, bool is_reversed) {
  std::vector<Point> points;
  std::vector<std::vector<Index>> faces;
  const auto add_face = [&](const std::vector<Point>& corners) {
    faces.emplace_back();
    for (const Point& p : corners) {
      faces.back().push_back(Index(points.size()));
      points.push_back(p);
    }
  };
  for (const float side : {1.0F, -1.0F}) {
    const auto corner = [&](std::size_t i, Index z) {
      return Point{i % 4 == 1 || i % 4 == 2 ? side : 0, i % 4 > 1 ? side : 0, float(z)};
    };
    for (Index z = 0; z < length; ++z) {
      for (std::size_t i = 0; i < 4; ++i) {
        add_face({corner(i, z), corner(i + 1, z), corner(i + 1, z + 1), corner(i, z + 1)});
      }
    }
    add_face({corner(3, 0), corner(2, 0), corner(1, 0), corner(0, 0)});
    add_face({corner(0, length), corner(1, length), corner(2, length), corner(3, length)});
  }
  if (is_reversed) std::reverse(faces.begin(), faces.end());
  return mesh_of(points, faces);
}

TEST(StitchBoundaries, KeepsTwoBoxesApartThatShareARowOfEdges) {
  for (Index length = 1; length <= 6; ++length) {
    for (const bool is_reversed : {false, true}) {
      SCOPED_TRACE(std::to_string(length) + (is_reversed ? ", reversed" : ""));
      Mesh mesh = boxes_along_an_axis(length, is_reversed);
      const mend::Report report = mended(mesh, stitch);
      EXPECT_TRUE(is_closed(mesh)) << report.summary;
      EXPECT_EQ(counts_of(mesh), (Counts3{8 * (length + 1), 16 * length + 8, 8 * length + 4}));
      EXPECT_EQ(connected_components(mesh).value().list.size(), 2U);
      EXPECT_TRUE(report.problems.empty());
      if (length == 1) continue;
      // And those edges alone, of both boxes.
      const Counts3 whole = counts_of(mesh);
      for (int box = 0; box < 2; ++box) {
        std::vector<Halfedge> path;
        for (Index z = 0; z < length; ++z) {
          for (const Halfedge h : mesh.halfedges()) {
            const Point from = mesh.position(mesh.from_vertex(h));
            const bool is_next = from == Point{0, 0, float(z)} &&
                                 mesh.position(mesh.to_vertex(h)) == Point{0, 0, from.z + 1} &&
                                 !mesh.is_boundary(mesh.edge(h));
            const bool follows = path.empty() || mesh.to_vertex(path.back()) == mesh.from_vertex(h);
            if (is_next && follows && path.size() == z) path.push_back(h);
          }
        }
        ASSERT_EQ(path.size(), length);
        ASSERT_TRUE(operations::cut_path(mesh, path));
      }
      EXPECT_EQ(mended(mesh, stitch).summary, std::to_string(2 * length) + " edges stitched.");
      EXPECT_EQ(counts_of(mesh), whole);
    }
  }
}

// A cube, and two triangles along one of its edges, whose partners are told once that of the cube
// is closed.
TEST(StitchBoundaries, JoinsTheTwoThatAreLeftOfFour) {
  for (const bool same_way : {false, true}) {
    Mesh mesh = soup_of(shapes::mesh_of(shapes::cube()).value());
    const Point a = mesh.position(mesh.from_vertex(Halfedge(0)));
    const Point b = mesh.position(mesh.to_vertex(Halfedge(0)));
    Mesh fins = same_way ? mesh_of({a, b, {9, 0, 0}, a, b, {0, 9, 0}}, {{0, 1, 2}, {3, 4, 5}})
                         : mesh_of({a, b, {9, 0, 0}, a, b, {0, 9, 0}}, {{0, 1, 2}, {4, 3, 5}});
    ASSERT_TRUE(append(mesh, fins));
    const mend::Report report = mended(mesh, stitch);
    EXPECT_EQ(report.count(Code::kAmbiguousEdge), 0U) << report.problems[0].message;
    if (same_way) {
      EXPECT_EQ(report.summary,
                "12 edges stitched, 1 edge left between faces of opposite orientation.");
      EXPECT_EQ(counts_of(mesh), (Counts3{14, 18, 8}));
    } else {
      EXPECT_EQ(report.summary, "13 edges stitched.");
      EXPECT_EQ(counts_of(mesh), (Counts3{12, 17, 8}));
    }
  }
}

// Not valid at level 4, but what can be read from bytes.
/// An edge with a face on neither side.
Halfedge add_bare_edge(Mesh& mesh, const Point& from, const Point& to) {
  const Vertex u = mesh.new_vertex();
  const Vertex v = mesh.new_vertex();
  const Halfedge h = mesh.new_edge(u, v);
  mesh.set_vertex_halfedge(u, h);
  mesh.set_vertex_halfedge(v, mesh.opposite(h));
  mesh.set_position(u, from);
  mesh.set_position(v, to);
  return h;
}

// Its two sides lie together and run opposite ways.
TEST(StitchBoundaries, LeavesEdgesWithoutFacesAlone) {
  Mesh cube = soup_of(shapes::mesh_of(shapes::cube()).value());
  const Halfedge h = add_bare_edge(cube, cube.position(cube.from_vertex(Halfedge(0))),
                                   cube.position(cube.to_vertex(Halfedge(0))));
  const Result<mend::Report> closed = mend::stitch_boundaries(cube);
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed.value().summary, "12 edges stitched.");
  EXPECT_EQ(cube.edge_count(), 13U);
  EXPECT_EQ(cube.next(h), cube.opposite(h));

  Mesh triangle = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  (void)add_bare_edge(triangle, {0, 0, 0}, {1, 0, 0});
  (void)add_bare_edge(triangle, {5, 0, 0}, {6, 0, 0});
  const Result<mend::Report> open = mend::stitch_boundaries(triangle);
  ASSERT_TRUE(open);
  EXPECT_EQ(open.value().summary, "Nothing to repair.");
  EXPECT_EQ(triangle.edge_count(), 5U);
}

TEST(StitchBoundaries, LeavesEdgesThatRunTheSameWay) {
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}},
                      {{0, 1, 2}, {3, 4, 5}});
  const mend::Report report = mended(mesh, stitch);
  EXPECT_EQ(counts_of(mesh), (Counts3{6, 6, 2}));
  EXPECT_EQ(report.summary, "1 edge left between faces of opposite orientation.");
  EXPECT_EQ(report.problems[0].code, "opposite-orientation");
  EXPECT_EQ(report.problems[0].witness.edges, (std::vector<Index>{0, 2}));
}

// A quad folded onto itself, of which each half would be a face with a corner twice.
TEST(StitchBoundaries, SaysWhatNoMeshAllows) {
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 2, 3}});
  const mend::Report report = mended(mesh, stitch);
  EXPECT_EQ(counts_of(mesh), (Counts3{4, 4, 1}));
  EXPECT_EQ(report.count(Code::kUnstitchableEdge), 2U);
  EXPECT_EQ(report.summary, "2 edges left that can't be glued.");
  ASSERT_EQ(report.problems.size(), 2U);
  EXPECT_EQ(report.problems[0].message,
            "Edge 3 and edge 0 lie together but can't be glued: Edge 2 and edge 1 would both join "
            "vertex 3 and vertex 2, expected one edge between two vertices.");
}

TEST(StitchBoundaries, IgnoresPositionsThatAreNoNumbers) {
  const float nan = std::nanf("");
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                      {{0, 1, 2}, {3, 4, 5}});
  mesh.set_position(Vertex(1), {nan, 0, 0});
  mesh.set_position(Vertex(4), {nan, 0, 0});
  const Result<mend::Report> report = mend::stitch_boundaries(mesh);
  ASSERT_TRUE(report);
  EXPECT_EQ(report.value().summary, "Nothing to repair.");
}

TEST(StitchBoundaries, PutsCutMeshesTogetherAgain) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Result<Mesh> made = shapes::mesh_of(
        seed % 2 == 0 ? shapes::ico_sphere(2) : shapes::torus(8, 6, shapes::Faces(seed % 4 / 2)));
    Mesh mesh = std::move(made).value();
    const Counts3 whole = counts_of(mesh);
    for (int i = 0; i < 150; ++i) {
      const Halfedge h(Index(random() % mesh.halfedge_slots()));
      const Halfedge path[] = {h, mesh.next(h)};
      (void)operations::cut(mesh, h);
      if (i % 10 == 0) (void)operations::cut_path(mesh, path);
    }
    ASSERT_GT(mesh.edge_count(), whole[1]);
    Mesh pinched = copy_of(mesh);
    ASSERT_TRUE(mend::split_pinched_vertices(mesh));
    const mend::Report report = mended(mesh, stitch);
    EXPECT_EQ(counts_of(mesh), whole) << report.summary;
    expect_true(mended(pinched, stitch), pinched);
  }
}

// Edges of soups whose vertices lie at few places, so that most places have several.
TEST(StitchBoundaries, SaysOfNoStitchedEdgeThatItIsLeft) {
  std::size_t left = 0;
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::uint32_t places = 5 + seed % 40;
    std::vector<Point> points;
    std::vector<std::vector<Index>> faces;
    for (Index f = 0; f < 3 * places; ++f) {
      faces.emplace_back();
      const auto first = std::uint32_t(random() % places);
      for (Index i = 0; i < 3 + f % 2; ++i) {
        faces.back().push_back(Index(points.size()));
        points.push_back({float((first + i * (1 + std::uint32_t(random() % 2))) % places), 0, 0});
      }
    }
    Mesh mesh = mesh_of(points, faces);
    const mend::Report report = mended(mesh, stitch);
    expect_true(report, mesh);
    left += report.count(Code::kUnstitchableEdge);
    EXPECT_EQ(mended(mesh, stitch).count(Code::kStitchedEdge), 0U) << "all is done at once";
    if (HasFailure()) break;
  }
  EXPECT_GT(left, 100U);
}

TEST(SplitPinchedVertices, GivesEachFanItsOwn) {
  Mesh mesh = reference_build(pinched(5));
  ASSERT_EQ(counts_of(mesh), (Counts3{11, 15, 5}));
  const mend::Report report = mended(mesh, split);
  EXPECT_EQ(counts_of(mesh), (Counts3{15, 15, 5}));
  EXPECT_EQ(report.summary, "1 pinched vertex split.");
  ASSERT_EQ(report.vertices.size(), 4U);
  for (const Index v : report.vertices) {
    EXPECT_EQ(mesh.position(Vertex(v)), mesh.position(Vertex(0)));
    EXPECT_EQ(mesh.valence(Vertex(v)), 2U);
  }
  for (const Vertex v : mesh.vertices()) EXPECT_TRUE(mesh.is_manifold(v));
  EXPECT_EQ(boundary_loops(mesh).value().size(), 5U);
}

TEST(SplitPinchedVertices, CopiesTheAttributes) {
  Mesh mesh = reference_build(pinched(2));
  const mend::Report report = mended(mesh, split);
  ASSERT_EQ(report.vertices.size(), 1U);
  for (const auto& column : mesh.attributes().of(ItemKind::kVertex)) {
    for (Index i = 0; i < column->components(); ++i) {
      const double expected = column->on_split() == OnSplit::kDefault ? 0 : column->get(0, i);
      EXPECT_EQ(column->get(report.vertices[0], i), expected) << column->name();
    }
  }
}

TEST(SplitPinchedVertices, LeavesWhatIsNotPinched) {
  for (const Shape& shape : {cube(), disk(7), annulus(5), quad_grid(3, 3)}) {
    Mesh mesh = reference_build(shape);
    EXPECT_EQ(mended(mesh, split).summary, "Nothing to repair.");
    EXPECT_EQ(mesh.vertex_count(), shape.vertices);
  }
}

// Rows of quads that touch at many vertices, each of which is between more than one pair of gaps.
TEST(SplitPinchedVertices, SplitsManyInOneMesh) {
  Mesh mesh = reference_build(quad_grid(7, 7));
  for (Index f = 0; f < 49; ++f) {
    if ((f / 7 + f % 7) % 2 == 1) {
      ASSERT_TRUE(operations::delete_face(mesh, Face(f)));
    }
  }
  ASSERT_EQ(mesh.face_count(), 25U);
  const mend::Report report = mended(mesh, split);
  EXPECT_EQ(counts_of(mesh), (Counts3{100, 100, 25}));
  EXPECT_EQ(report.count(Code::kSplitVertex), 36U);
  EXPECT_EQ(connected_components(mesh).value().list.size(), 25U);
  EXPECT_EQ(mended(mesh, stitch).summary, "Nothing to repair.") << "they touch in vertices alone";
}

TEST(SplitPinchedVertices, HandlesTwoThousandFansAtOneVertex) {
  Mesh mesh = reference_build(pinched(2000));
  EXPECT_EQ(mended(mesh, split).vertices.size(), 1999U);
}

TEST(Stitch, RefusesATolerance) {
  for (const double tolerance : {std::nan(""), -1.0, std::numeric_limits<double>::infinity()}) {
    Mesh mesh;
    const Result<mend::Report> report = stitch_within(tolerance)(mesh);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, "bad-tolerance");
    EXPECT_TRUE(report.error().message.ends_with("; expected a finite number from 0."));
  }
}

}  // namespace
}  // namespace halfedge::test
