// Values at corners, such as texture coordinates, where they are those of the vertices: they stay
// so through whatever leaves vertices where they are, or blends corners as it blends positions.

#include <gtest/gtest.h>
#include <halfedge/mend/mend.h>
#include <halfedge/operations/bevel.h>
#include <halfedge/operations/collapse.h>
#include <halfedge/operations/cut.h>
#include <halfedge/operations/dissolve.h>
#include <halfedge/operations/extrude.h>
#include <halfedge/operations/flip.h>
#include <halfedge/operations/glue.h>
#include <halfedge/operations/insert_edge.h>
#include <halfedge/operations/orientation.h>
#include <halfedge/operations/split_edge.h>
#include <halfedge/operations/split_face.h>
#include <halfedge/operations/split_vertex.h>
#include <halfedge/operations/triangulate.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/sweep.h"

namespace halfedge::test {
namespace {

namespace ops = operations;

float coordinate(Point p, Index axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Which sides have the values of corners.
enum class Sides { kOfFaces, kAll };

/// Corners have the positions of their vertices, and their indices; other sides something else.
Mesh with_positions_at_corners(const Shape& shape, Sides sides) {
  Mesh mesh = reference_build(shape);
  Attribute& uv =
      *mesh.add_attribute(
               ItemKind::kHalfedge, "uv",
               {.type = Scalar::kFloat64, .components = 3, .on_split = OnSplit::kInterpolate})
           .value();
  Attribute& label =
      *mesh.add_attribute(ItemKind::kHalfedge, "label",
                          {.type = Scalar::kUint32, .on_split = OnSplit::kCopyCorner})
           .value();
  for (const Halfedge h : mesh.halfedges()) {
    const bool is_labelled = sides == Sides::kAll || !mesh.is_boundary(h);
    label.set(h.index(), 0, is_labelled ? mesh.to_vertex(h).index() : 999, nullptr);
    for (const Index axis : {0U, 1U, 2U}) {
      const float at = coordinate(mesh.position(mesh.to_vertex(h)), axis);
      const bool has_it = sides == Sides::kAll || !mesh.is_boundary(h);
      uv.set(h.index(), axis, has_it ? double(at) : -999, nullptr);
    }
  }
  return mesh;
}

/// The first of these sides that has another value than the position of its vertex.
Halfedge first_wrong(const Mesh& mesh, Sides sides) {
  const Attribute& uv = *mesh.find_attribute(ItemKind::kHalfedge, "uv");
  for (const Halfedge h : mesh.halfedges()) {
    if (sides == Sides::kOfFaces && mesh.is_boundary(h)) continue;
    for (const Index axis : {0U, 1U, 2U}) {
      const double at = double(coordinate(mesh.position(mesh.to_vertex(h)), axis));
      if (!(std::abs(uv.get(h.index(), axis) - at) <= 1e-5 * (1 + std::abs(at)))) return h;
    }
  }
  return {};
}

/// The first of these sides that leads to a vertex which is where it was, with the label of
/// another.
Halfedge first_mislabelled(const Mesh& before, const Mesh& mesh, Sides sides) {
  const Attribute& label = *mesh.find_attribute(ItemKind::kHalfedge, "label");
  for (const Halfedge h : mesh.halfedges()) {
    if (sides == Sides::kOfFaces && mesh.is_boundary(h)) continue;
    const Vertex v = mesh.to_vertex(h);
    if (v.index() >= before.vertex_slots() || before.position(v) != mesh.position(v)) continue;
    if (label.get(h.index(), 0) != v.index()) return h;
  }
  return {};
}

/// Applies `operate` to each item that `items` lists, each time to a copy of each of many meshes.
/// Returns how often it was done.
template <class Items, class Operate>
int expect_corners_follow(const Items& items, const Operate& operate,
                          Sides sides = Sides::kOfFaces) {
  int done = 0;
  std::vector<Shape> shapes = all_shapes();
  for (std::uint32_t seed = 0; seed < 8; ++seed) shapes.push_back(random_polygons(seed));
  for (const Shape& shape : shapes) {
    if (shape.faces.size() > 60) continue;  // what is done takes quadratic time
    const Mesh mesh = with_positions_at_corners(shape, sides);
    EXPECT_FALSE(first_wrong(mesh, sides).valid());
    for (const auto item : items(mesh)) {
      Mesh after = copy_of(mesh);
      if (!operate(after, item).ok()) continue;
      ++done;
      Halfedge wrong = first_wrong(after, sides);
      if (!wrong.valid()) wrong = first_mislabelled(mesh, after, sides);
      EXPECT_FALSE(wrong.valid()) << shape.name << ", item " << item.index() << ": corner "
                                  << wrong.index() << " at vertex "
                                  << after.to_vertex(wrong).index();
      if (wrong.valid()) return done;
    }
  }
  return done;
}

Point point_on(const Mesh& mesh, Halfedge h, double t) {
  return steps::blend(mesh.position(mesh.from_vertex(h)), mesh.position(mesh.to_vertex(h)), t);
}

Point point_on(const Mesh& mesh, Edge e, double t) {
  return point_on(mesh, mesh.edge_halfedge(e), t);
}

constexpr auto kVertices = [](const Mesh& mesh) { return mesh.vertices(); };
constexpr auto kHalfedges = [](const Mesh& mesh) { return mesh.halfedges(); };
constexpr auto kEdges = [](const Mesh& mesh) { return mesh.edges(); };
constexpr auto kFaces = [](const Mesh& mesh) { return mesh.faces(); };

TEST(Corners, FollowTheVerticesThatBevelsMove) {
  for (const double amount : {0.0, 0.25, 1.0}) {
    EXPECT_GT(expect_corners_follow(
                  kVertices, [&](Mesh& m, Vertex v) { return ops::bevel_vertex(m, v, amount); }),
              50);
    EXPECT_GT(expect_corners_follow(kEdges,
                                    [&](Mesh& m, Edge e) { return ops::bevel_edge(m, e, amount); }),
              50);
  }
}

TEST(Corners, OfOpenSidesFollowTheVerticesThatMove) {
  for (const double t : {0.0, 0.25, 1.0}) {
    const auto collapse = [&](Mesh& m, Halfedge h) {
      return ops::collapse(m, h, point_on(m, h, t));
    };
    EXPECT_GT(expect_corners_follow(kHalfedges, collapse, Sides::kAll), 50);
    const auto bevel_edge = [&](Mesh& m, Edge e) { return ops::bevel_edge(m, e, t); };
    EXPECT_GT(expect_corners_follow(kEdges, bevel_edge, Sides::kAll), 50);
    const auto bevel_vertex = [&](Mesh& m, Vertex v) { return ops::bevel_vertex(m, v, t); };
    EXPECT_GT(expect_corners_follow(kVertices, bevel_vertex, Sides::kAll), 50);
  }
}

TEST(Corners, StayWithTheVerticesThatDissolvingLeaves) {
  EXPECT_GT(expect_corners_follow(kVertices,
                                  [](Mesh& m, Vertex v) { return ops::dissolve_vertex(m, v); }),
            50);
  EXPECT_GT(expect_corners_follow(kEdges, [](Mesh& m, Edge e) { return ops::dissolve_edge(m, e); }),
            50);
  EXPECT_GT(expect_corners_follow(kEdges, [](Mesh& m, Edge e) { return ops::remove_edge(m, e); }),
            50);
}

TEST(Corners, LieWhereEdgesAreCut) {
  EXPECT_GT(
      expect_corners_follow(
          kEdges, [](Mesh& m, Edge e) { return ops::split_edge(m, e, point_on(m, e, 0.25)); }),
      50);
  EXPECT_GT(expect_corners_follow(kEdges,
                                  [](Mesh& m, Edge e) {
                                    return ops::insert_vertex_on_edge(m, e, point_on(m, e, 0.75));
                                  }),
            50);
  EXPECT_GT(expect_corners_follow(
                kEdges,
                [](Mesh& m, Edge e) {
                  const Vertex v = ops::insert_vertex_on_edge(m, e, point_on(m, e, 0.75)).value();
                  return ops::remove_vertex_on_edge(m, v);
                }),
            50);
  EXPECT_GT(expect_corners_follow(kHalfedges,
                                  [](Mesh& m, Halfedge h) {
                                    const Halfedge k = decorator::split_edge(m, h, 0.25).value();
                                    return decorator::join_edge(
                                        m, h.index() % 2 == 0 ? k : m.opposite(m.next(k)));
                                  }),
            50);
}

TEST(Corners, StayWhereFacesAreCut) {
  EXPECT_GT(expect_corners_follow(kEdges, [](Mesh& m, Edge e) { return ops::flip_edge(m, e); }),
            50);
  EXPECT_GT(expect_corners_follow(kFaces, [](Mesh& m, Face f) { return ops::split_face(m, f); }),
            50);
  EXPECT_GT(expect_corners_follow(kFaces, [](Mesh& m, Face f) { return ops::triangulate(m, f); }),
            50);
  EXPECT_GT(
      expect_corners_follow(kFaces, [](Mesh& m, Face f) { return ops::inset_face(m, f, 0.25); }),
      50);
  const auto with_faces = [](const Mesh& mesh) {
    std::vector<Halfedge> sides;
    for (const Halfedge h : mesh.halfedges()) {
      if (!mesh.is_boundary(h)) sides.push_back(h);
    }
    return sides;
  };
  EXPECT_GT(expect_corners_follow(
                with_faces,
                [](Mesh& m, Halfedge h) { return ops::insert_edge(m, h, m.next(m.next(h))); }),
            20);
}

TEST(Corners, StayWithTheFacesWhereAMeshIsCutOpenAndSewn) {
  EXPECT_GT(expect_corners_follow(kHalfedges, [](Mesh& m, Halfedge h) { return ops::cut(m, h); }),
            50);
  EXPECT_GT(expect_corners_follow(kHalfedges,
                                  [](Mesh& m, Halfedge h) -> Result<mend::Report> {
                                    const Result<Halfedge> g = ops::cut(m, h);
                                    if (!g) return g.error();
                                    return mend::stitch_boundaries(m, {.tolerance = 0});
                                  }),
            50);
  EXPECT_GT(expect_corners_follow(kHalfedges,
                                  [](Mesh& m, Halfedge h) -> Result<Edge> {
                                    const Result<Halfedge> g = ops::cut(m, h);
                                    if (!g) return g.error();
                                    return ops::glue(m, Mesh::opposite(h), g.value());
                                  }),
            50);
  EXPECT_GT(
      expect_corners_follow(kFaces, [](Mesh& m, Face) { return mend::split_pinched_vertices(m); }),
      50);
  EXPECT_GT(expect_corners_follow(kFaces,
                                  [](Mesh& m, Face) -> Result<mend::Report> {
                                    EXPECT_TRUE(ops::reverse(m).ok());
                                    return mend::orient_outward(m, {});
                                  }),
            50);
}

TEST(Corners, FollowTheVerticesOfACollapse) {
  for (const double t : {0.0, 0.5, 1.0}) {
    EXPECT_GT(expect_corners_follow(
                  kHalfedges,
                  [&](Mesh& m, Halfedge h) { return ops::collapse(m, h, point_on(m, h, t)); }),
              50);
  }
  EXPECT_GT(
      expect_corners_follow(kHalfedges, [](Mesh& m, Halfedge h) { return ops::collapse(m, h); }),
      50);
  EXPECT_GT(
      expect_corners_follow(
          kHalfedges, [](Mesh& m, Halfedge h) { return ops::split_vertex(m, h, m.rotate_cw(h)); }),
      50);
}

}  // namespace
}  // namespace halfedge::test
