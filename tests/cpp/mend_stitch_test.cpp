// Stitching boundary edges, and splitting pinched vertices.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/operations/append.h>

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
  for (std::size_t length = 2; length < 7; ++length) {
    Result<Mesh> grid = shapes::mesh_of(shapes::grid(9, 2, shapes::Faces::kTriangles));
    Mesh mesh = std::move(grid).value();
    const Counts3 whole = counts_of(mesh);
    std::vector<Halfedge> path;
    for (std::size_t i = 0; i < length; ++i) {
      path.push_back(mesh.find_halfedge(Vertex(Index(11 + i)), Vertex(Index(12 + i))));
    }
    ASSERT_TRUE(operations::cut_path(mesh, path));
    EXPECT_EQ(mesh.vertex_count(), whole[0] + length - 1);
    const mend::Report report = mended(mesh, stitch);
    EXPECT_EQ(counts_of(mesh), whole) << length;
    EXPECT_EQ(report.count(Code::kStitchedEdge), length);
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
            "Edge 6 lies together with 2 other boundary edges, expected one: which to glue it to "
            "can't be told.");
  EXPECT_EQ(report.problems[0].witness.edges, (std::vector<Index>{6}));
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

TEST(StitchBoundaries, LeavesEdgesThatRunTheSameWay) {
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}},
                      {{0, 1, 2}, {3, 4, 5}});
  const mend::Report report = mended(mesh, stitch);
  EXPECT_EQ(counts_of(mesh), (Counts3{6, 6, 2}));
  EXPECT_EQ(report.summary, "1 edge left between faces of opposite orientation.");
  EXPECT_EQ(report.problems[0].code, "opposite-orientation");
  EXPECT_EQ(report.problems[0].witness.edges, (std::vector<Index>{4, 5}));
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
            "Edge 0 and edge 3 lie together but can't be glued: Edge 2 and edge 1 would both join "
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
    ASSERT_TRUE(mend::split_pinched_vertices(mesh));
    const mend::Report report = mended(mesh, stitch);
    EXPECT_EQ(counts_of(mesh), whole) << report.summary;
  }
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

}  // namespace
}  // namespace halfedge::test
