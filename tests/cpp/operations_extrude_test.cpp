// Faces extruded and inset, edges and vertices bevelled.

#include <gtest/gtest.h>
#include <halfedge/operations/bevel.h>
#include <halfedge/operations/extrude.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/built.h"
#include "support/polygon_lists.h"

namespace halfedge::test {
namespace {

using namespace operations;

// The unit cube; its faces as in cube(), its vertices at their corners.
Mesh unit_cube() {
  Shape shape = cube();
  const float at[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                          {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t i = 0; i < 3; ++i) shape.positions[3 * v + i] = at[v][i];
  }
  return reference_build(shape);
}

std::set<std::tuple<float, float, float>> positions_of(const Mesh& mesh) {
  std::set<std::tuple<float, float, float>> all;
  for (const Vertex v : mesh.vertices()) {
    const Point p = mesh.position(v);
    all.insert({p.x, p.y, p.z});
  }
  return all;
}

// The polygons with a ring of quads around one of them, whose corners are new.
Polys with_ring(const Mesh& before, Face f, const std::vector<Index>& corners) {
  Polys all;
  for (const Face other : before.faces()) {
    if (other != f) all.push_back(polygon_of(before, other));
  }
  const std::vector<Index> old = polygon_of(before, f);
  for (std::size_t i = 0; i < old.size(); ++i) {
    const std::size_t j = (i + 1) % old.size();
    all.push_back({old[i], old[j], corners[j], corners[i]});
  }
  all.push_back(corners);
  return all;
}

TEST(ExtrudeFace, SweepOverAllFaces) {
  for (const auto& [name, mesh] : meshes_to_sweep(6)) {
    SCOPED_TRACE(name);
    for (const Face f : mesh.faces()) {
      if (f.index() > 20) break;
      for (const bool is_inset : {false, true}) {
        bool done = false;
        const Mesh after = try_operation(
            mesh,
            [&](const Mesh& m) {
              return is_inset ? check_inset_face(m, f, 0.25) : check_extrude_face(m, f, 0.5);
            },
            [&](Mesh& m) { return is_inset ? inset_face(m, f, 0.25) : extrude_face(m, f, 0.5); },
            done);
        ASSERT_TRUE(done);
        const Index n = mesh.degree(f);
        EXPECT_EQ(after.vertex_count(), mesh.vertex_count() + n);
        EXPECT_EQ(after.edge_count(), mesh.edge_count() + 2 * n);
        std::vector<Index> corners;  // above those of f, in their order
        const Halfedge first = mesh.face_halfedge(f);
        for (const Halfedge h : mesh.loop_ccw(first)) {
          corners.push_back(after.to_vertex(after.next(h)).index());
        }
        EXPECT_EQ(in_order(polygons_of(after)), in_order(with_ring(mesh, f, corners)));
        EXPECT_EQ(in_order({polygon_of(after, f)}), in_order({corners}));
        ASSERT_FALSE(HasFailure());
      }
    }
  }
}

TEST(ExtrudeFace, MovesAlongTheNormal) {
  Mesh mesh = unit_cube();
  ASSERT_EQ(extrude_face(mesh, Face(1), 0.5).value(), Face(1));
  for (const Vertex v : mesh.face_vertices_ccw(Face(1))) EXPECT_EQ(mesh.position(v).z, 1.5F);
  ASSERT_TRUE(extrude_face(mesh, Face(0), -0.25).ok());  // which looks down: up into the cube
  for (const Vertex v : mesh.face_vertices_ccw(Face(0))) EXPECT_EQ(mesh.position(v).z, 0.25F);
  EXPECT_EQ(mesh.vertex_count(), 16U);
  EXPECT_EQ(mesh.face_count(), 14U);
  expect_valid_mesh(mesh);
}

TEST(InsetFace, ShrinksTowardsTheMean) {
  Mesh mesh = unit_cube();
  ASSERT_EQ(inset_face(mesh, Face(1), 0.5).value(), Face(1));
  std::set<std::pair<float, float>> corners;
  for (const Vertex v : mesh.face_vertices_ccw(Face(1))) {
    corners.insert({mesh.position(v).x, mesh.position(v).y});
    EXPECT_EQ(mesh.position(v).z, 1);
  }
  EXPECT_EQ(corners, (std::set<std::pair<float, float>>{
                         {0.25F, 0.25F}, {0.75F, 0.25F}, {0.75F, 0.75F}, {0.25F, 0.75F}}));
}

// One column of numbers by vertex, halfedge, face.
double value(const Mesh& mesh, ItemKind kind, const char* name, Index item) {
  return mesh.attributes().find(kind, name)->get(item, 0);
}

Mesh cube_with_values() {
  Mesh mesh = unit_cube();
  for (const ItemKind kind :
       {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
    for (const OnSplit policy : {OnSplit::kInterpolate, OnSplit::kCopy}) {
      const auto column =
          mesh.add_attribute(kind, name_of(policy), {.type = Scalar::kFloat64, .on_split = policy});
      for (Index i = 0; i < mesh.slots(kind); ++i) {
        column.value()->set(i, 0, double(16 * (i + 1) + 1000 * Index(kind)), nullptr);
      }
    }
  }
  return mesh;
}

TEST(ExtrudeFace, CopiesAttributes) {
  const Mesh before = cube_with_values();
  for (const bool is_inset : {false, true}) {
    Mesh mesh = copy_of(before);
    ASSERT_TRUE((is_inset ? inset_face(mesh, Face(1), 0.25) : extrude_face(mesh, Face(1), 2)).ok());
    double vertex_mean = 0;
    double corner_mean = 0;
    for (const Halfedge h : before.face_halfedges_ccw(Face(1))) {
      vertex_mean +=
          value(before, ItemKind::kVertex, "interpolate", before.to_vertex(h).index()) / 4;
      corner_mean += value(before, ItemKind::kHalfedge, "interpolate", h.index()) / 4;
    }
    const auto expected = [&](double own, double mean) {
      return is_inset ? 0.75 * own + 0.25 * mean : own;
    };
    for (const Halfedge h : before.face_halfedges_ccw(Face(1))) {
      const Halfedge spoke = mesh.next(h);
      const Halfedge inner = mesh.opposite(mesh.next(spoke));
      const Vertex v = mesh.to_vertex(h);
      const Vertex corner = mesh.to_vertex(spoke);
      ASSERT_EQ(mesh.face(inner), Face(1));
      EXPECT_EQ(value(mesh, ItemKind::kVertex, "interpolate", corner.index()),
                expected(value(before, ItemKind::kVertex, "interpolate", v.index()), vertex_mean));
      EXPECT_EQ(value(mesh, ItemKind::kVertex, "copy", corner.index()),
                value(before, ItemKind::kVertex, "copy", v.index()));
      EXPECT_EQ(value(mesh, ItemKind::kFace, "copy", mesh.face(h).index()),
                value(before, ItemKind::kFace, "copy", 1));
      EXPECT_EQ(value(mesh, ItemKind::kEdge, "copy", mesh.edge(inner).index()),
                value(before, ItemKind::kEdge, "copy", before.edge(h).index()));
      // Corners: below as before, above as computed, in the face on top and in both quads.
      const double own = value(before, ItemKind::kHalfedge, "interpolate", h.index());
      EXPECT_EQ(value(mesh, ItemKind::kHalfedge, "interpolate", h.index()), own);
      EXPECT_EQ(value(mesh, ItemKind::kHalfedge, "interpolate", mesh.opposite(spoke).index()), own);
      for (const Halfedge above : {inner, spoke, mesh.prev(mesh.opposite(spoke))}) {
        EXPECT_EQ(mesh.to_vertex(above), corner);
        EXPECT_EQ(value(mesh, ItemKind::kHalfedge, "interpolate", above.index()),
                  expected(own, corner_mean));
      }
    }
  }
}

// 50,000 sides: comparing each with each would take minutes.
TEST(InsetFace, OfAFaceWithManySides) {
  constexpr Index kSides = 50'000;
  std::vector<std::vector<Index>> faces(1);
  for (Index v = 0; v < kSides; ++v) faces[0].push_back(v);
  Mesh mesh = built({"", kSides, faces});
  const AttributeOptions options{.type = Scalar::kFloat64, .on_split = OnSplit::kInterpolate};
  for (const ItemKind kind : {ItemKind::kVertex, ItemKind::kHalfedge}) {
    Attribute* const column = mesh.add_attribute(kind, "number", options).value();
    for (Index i = 0; i < mesh.slots(kind); ++i) column->set(i, 0, double(i), nullptr);
  }
  double vertex_mean = 0;
  double corner_mean = 0;
  for (const Halfedge h : mesh.face_halfedges_ccw(Face(0))) {
    vertex_mean += double(mesh.to_vertex(h).index()) / kSides;
    corner_mean += double(h.index()) / kSides;
  }
  const std::clock_t start = std::clock();
  ASSERT_TRUE(inset_face(mesh, Face(0), 0.5).ok());
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 10);
  expect_valid(mesh, "inset");
  for (const Halfedge inner : mesh.face_halfedges_ccw(Face(0))) {
    const Halfedge spoke = mesh.prev(mesh.opposite(inner));
    const Halfedge outer = mesh.prev(spoke);
    EXPECT_NEAR(value(mesh, ItemKind::kVertex, "number", mesh.to_vertex(spoke).index()),
                (double(mesh.to_vertex(outer).index()) + vertex_mean) / 2, 1e-6);
    EXPECT_NEAR(value(mesh, ItemKind::kHalfedge, "number", spoke.index()),
                (double(outer.index()) + corner_mean) / 2, 1e-6);
  }
}

TEST(ExtrudeFace, Refusals) {
  Mesh mesh = unit_cube();
  add_attributes_of_all_kinds(mesh);
  for (const Vertex v : mesh.face_vertices_ccw(Face(0))) mesh.set_position(v, {1, 1, 1});
  const Snapshot before(mesh);
  const double infinity = std::numeric_limits<double>::infinity();
  expect_refused(extrude_face(mesh, Face(6), 1), "not-a-face", mesh, before);
  expect_refused(extrude_face(mesh, Face(1), infinity), "not-finite", mesh, before);
  const double far = std::numeric_limits<float>::max();
  Mesh near = copy_of(mesh);
  ASSERT_TRUE(extrude_face(near, Face(1), far));
  const Snapshot at_the_end(near);
  for (const Result<Face>& further :
       {extrude_face(near, Face(1), far), extrude_face(near, Face(1), 1e40)}) {
    expect_refused(further, "not-finite", near, at_the_end);
    EXPECT_EQ(further.error().witness.faces, std::vector<Index>{1});
  }
  const Result<Vertex> poked = poke(near, Face(1), far);
  expect_refused(poked, "not-finite", near, at_the_end);
  EXPECT_EQ(poked.error().message,
            "An offset of 3.40282e+38 takes face 1 to where positions fit no 32-bit floats, "
            "expected a smaller one.");
  EXPECT_TRUE(check_poke(near, Face(1), -far));
  const Result<Face> flat = extrude_face(mesh, Face(0), 1);
  expect_refused(flat, "degenerate-face", mesh, before);
  EXPECT_EQ(flat.error().witness.faces, std::vector<Index>{0});
  expect_refused(inset_face(mesh, Face(6), 0.5), "not-a-face", mesh, before);
  for (const double bad : {-0.01, 1.01, infinity, std::nan("")}) {
    expect_refused(inset_face(mesh, Face(1), bad), "out-of-range", mesh, before);
    expect_refused(bevel_vertex(mesh, Vertex(1), bad), "out-of-range", mesh, before);
    expect_refused(bevel_edge(mesh, Edge(1), bad), "out-of-range", mesh, before);
  }
  EXPECT_TRUE(extrude_face(mesh, Face(0), 0).ok());
}

// ---- bevel -------------------------------------------------------------------------------------

// Each face that has the old vertex gets the two new ones on its two sides there; the new vertices
// make a face. `on` names them by the vertex at the other end of their edge.
Polys with_vertex_cut_off(const Mesh& before, Vertex v, const std::map<Index, Index>& on,
                          const std::vector<Index>& face) {
  Polys all;
  for (const Face f : before.faces()) {
    const std::vector<Index> old = polygon_of(before, f);
    std::vector<Index> cut;
    for (std::size_t i = 0; i < old.size(); ++i) {
      if (old[i] != v.index()) {
        cut.push_back(old[i]);
      } else {
        cut.push_back(on.at(old[(i + old.size() - 1) % old.size()]));
        cut.push_back(on.at(old[(i + 1) % old.size()]));
      }
    }
    all.push_back(cut);
  }
  all.push_back(face);
  return all;
}

TEST(BevelVertex, SweepOverAllVertices) {
  int on_boundary = 0;
  int pinched_vertices = 0;
  int inside = 0;
  for (const auto& [name, mesh] : meshes_to_sweep(10)) {
    SCOPED_TRACE(name);
    for (const Vertex v : mesh.vertices()) {
      SCOPED_TRACE(v.index());
      if (v.index() > 30) break;
      bool done = false;
      const Mesh after = try_operation(
          mesh, [&](const Mesh& m) { return check_bevel_vertex(m, v, 0.25); },
          [&](Mesh& m) { return bevel_vertex(m, v, 0.25); }, done);
      const Index valence = mesh.is_isolated(v) ? 0 : mesh.valence(v);
      ASSERT_EQ(done, valence >= 3);
      if (!done) {
        EXPECT_EQ(check_bevel_vertex(mesh, v, 0.25).error().code, "valence-below-three");
        EXPECT_EQ(check_bevel_vertex(mesh, v, 0.25).error().witness.vertices,
                  std::vector<Index>{v.index()});
        continue;
      }
      ++(!mesh.is_manifold(v) ? pinched_vertices : mesh.is_boundary(v) ? on_boundary : inside);
      Mesh again = copy_of(mesh);
      const Face f = bevel_vertex(again, v, 0.25).value();
      EXPECT_EQ(again.degree(f), valence);
      std::map<Index, Index> on;
      for (const Halfedge h : mesh.outgoing_cw(v)) {
        on[mesh.to_vertex(h).index()] = again.from_vertex(h).index();
        const Point from = mesh.position(v);
        const Point to = mesh.position(mesh.to_vertex(h));
        const Point at = again.position(again.from_vertex(h));
        EXPECT_NEAR(at.x, 0.75 * double{from.x} + 0.25 * double{to.x}, 1e-6);
        EXPECT_NEAR(at.z, 0.75 * double{from.z} + 0.25 * double{to.z}, 1e-6);
      }
      EXPECT_EQ(again.from_vertex(mesh.vertex_halfedge(v)), v);
      std::vector<Index> expected_face;
      for (const Halfedge h : mesh.outgoing_ccw(v)) {
        expected_face.push_back(on[mesh.to_vertex(h).index()]);
      }
      EXPECT_EQ(in_order({polygon_of(again, f)}), in_order({expected_face}));
      EXPECT_EQ(in_order(polygons_of(after)),
                in_order(with_vertex_cut_off(mesh, v, on, expected_face)));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(on_boundary, 50);
  EXPECT_GT(pinched_vertices, 5);
}

TEST(BevelVertex, OfACube) {
  Mesh mesh = cube_with_values();
  const Mesh before = copy_of(mesh);
  const Face f = bevel_vertex(mesh, Vertex(6), 0.25).value();
  std::set<std::tuple<float, float, float>> corners;
  for (const Vertex v : mesh.face_vertices_ccw(f)) {
    const Point p = mesh.position(v);
    corners.insert({p.x, p.y, p.z});
  }
  EXPECT_EQ(corners, (std::set<std::tuple<float, float, float>>{
                         {0.75F, 1, 1}, {1, 0.75F, 1}, {1, 1, 0.75F}}));
  for (const Halfedge h : before.outgoing_cw(Vertex(6))) {
    const Vertex far = before.to_vertex(h);
    const Vertex corner = mesh.from_vertex(h);
    EXPECT_EQ(value(mesh, ItemKind::kVertex, "interpolate", corner.index()),
              0.75 * value(before, ItemKind::kVertex, "interpolate", 6) +
                  0.25 * value(before, ItemKind::kVertex, "interpolate", far.index()));
    // In both faces of the edge the corner is blended along the edge.
    const Halfedge o = before.opposite(h);
    EXPECT_EQ(value(mesh, ItemKind::kHalfedge, "interpolate", o.index()),
              0.75 * value(before, ItemKind::kHalfedge, "interpolate", o.index()) +
                  0.25 * value(before, ItemKind::kHalfedge, "interpolate", before.prev(o).index()));
    EXPECT_EQ(value(mesh, ItemKind::kHalfedge, "interpolate", mesh.prev(h).index()),
              0.75 * value(before, ItemKind::kHalfedge, "interpolate", before.prev(h).index()) +
                  0.25 * value(before, ItemKind::kHalfedge, "interpolate", h.index()));
  }
  EXPECT_EQ(value(mesh, ItemKind::kFace, "copy", f.index()),
            value(before, ItemKind::kFace, "copy",
                  before.face(before.opposite(before.vertex_halfedge(Vertex(6)))).index()));
}

TEST(BevelEdge, SweepOverAllEdges) {
  std::map<std::string, int> outcomes;
  for (const auto& [name, mesh] : meshes_to_sweep(10)) {
    SCOPED_TRACE(name);
    for (const Edge e : mesh.edges()) {
      SCOPED_TRACE(e.index());
      if (e.index() > 60) break;
      bool done = false;
      const Mesh after = try_operation(
          mesh, [&](const Mesh& m) { return check_bevel_edge(m, e, 0.25); },
          [&](Mesh& m) { return bevel_edge(m, e, 0.25); }, done);
      const Halfedge h = mesh.edge_halfedge(e);
      const Vertex a = mesh.from_vertex(h);
      const Vertex b = mesh.to_vertex(h);
      const Index splits = (mesh.valence(a) > 2 ? 1U : 0U) + (mesh.valence(b) > 2 ? 1U : 0U);
      ASSERT_EQ(done, !mesh.is_boundary(e) && splits > 0);
      ++outcomes[done ? std::to_string(splits)
                      : std::string(check_bevel_edge(mesh, e, 0.25).error().code)];
      if (!done) continue;
      EXPECT_EQ(after.vertex_count(), mesh.vertex_count() + splits);
      EXPECT_EQ(after.edge_count(), mesh.edge_count() + 1 + splits);
      EXPECT_EQ(after.face_count(), mesh.face_count() + 1);
      // Contracting the short sides in the lists of polygons gives back the polygons.
      Mesh again = copy_of(mesh);
      const Face f = bevel_edge(again, e, 0.25).value();
      EXPECT_EQ(again.degree(f), 2 + splits);
      std::map<Index, Index> back;
      for (const Halfedge side : again.face_halfedges_ccw(f)) {
        const Index v = again.to_vertex(side).index();
        if (v != a.index() && v != b.index()) {
          // Next to a on the new face, unless a stayed one.
          const bool of_a =
              mesh.valence(a) > 2 && (mesh.valence(b) == 2 || again.from_vertex(side) == a);
          back[v] = of_a ? a.index() : b.index();
        }
      }
      Polys contracted;
      for (const Face other : again.faces()) {
        if (other == f) continue;
        std::vector<Index> polygon = polygon_of(again, other);
        for (Index& v : polygon) v = back.count(v) > 0 ? back[v] : v;
        polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
        if (polygon.front() == polygon.back()) polygon.pop_back();
        contracted.push_back(polygon);
      }
      EXPECT_EQ(in_order(contracted), in_order(polygons_of(mesh)));
      // The faces beside the edge keep their degree.
      EXPECT_EQ(again.degree(again.face(h)), mesh.degree(mesh.face(h)));
      const Face other = mesh.face(mesh.opposite(h));
      EXPECT_EQ(again.degree(other), mesh.degree(other));
      EXPECT_EQ(again.face(Mesh::opposite(h)), f);
      // Short sides: on the boundary if the end is; else half of the other edges go to each vertex.
      const Halfedge o = Mesh::opposite(h);
      for (const bool at_a : {true, false}) {
        const Vertex end = at_a ? a : b;
        const Index others = mesh.valence(end) - 1;
        if (others < 2) continue;
        const Edge short_side = again.edge(at_a ? again.next(o) : again.prev(o));
        EXPECT_EQ(again.is_boundary(short_side), mesh.is_boundary(end));
        if (mesh.is_boundary(end)) continue;
        EXPECT_EQ(again.valence(end), 2 + (at_a ? others - others / 2 : others / 2));
      }
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(outcomes["2"], 200);
  EXPECT_GT(outcomes["1"], 5);
  EXPECT_GT(outcomes["boundary-edge"], 100);
  EXPECT_GT(outcomes["valence-below-three"], 2);
}

TEST(BevelEdge, OfACube) {
  Mesh mesh = cube_with_values();
  const Edge e = mesh.find_edge(Vertex(5), Vertex(6));
  const Face f = bevel_edge(mesh, e, 0.25).value();
  std::set<std::tuple<float, float, float>> corners;
  for (const Vertex v : mesh.face_vertices_ccw(f)) {
    const Point p = mesh.position(v);
    corners.insert({p.x, p.y, p.z});
  }
  EXPECT_EQ(corners, (std::set<std::tuple<float, float, float>>{
                         {1, 0, 0.75F}, {1, 1, 0.75F}, {0.75F, 0, 1}, {0.75F, 1, 1}}));
  EXPECT_EQ(positions_of(mesh).size(), 10U);
  // All six faces are still there: two have five corners.
  std::map<Index, int> degrees;
  for (const Face g : mesh.faces()) ++degrees[mesh.degree(g)];
  EXPECT_EQ(degrees, (std::map<Index, int>{{4, 5}, {5, 2}}));
  // Normal directions: each face of the cube is still in its plane.
  for (const Halfedge h : mesh.face_halfedges_ccw(f)) {
    EXPECT_FALSE(mesh.is_boundary(mesh.opposite(h)));
  }
}

TEST(BevelEdge, BlendsTheCornersThatMove) {
  const Mesh before = cube_with_values();
  Mesh mesh = copy_of(before);
  const Edge e = mesh.find_edge(Vertex(5), Vertex(6));
  const Halfedge h = mesh.edge_halfedge(e);
  const Halfedge o = Mesh::opposite(h);
  const auto corner = [](const Mesh& m, Halfedge of) {
    return value(m, ItemKind::kHalfedge, "interpolate", of.index());
  };
  const auto blended = [&](Halfedge own, Halfedge other) {
    return 0.75 * corner(before, own) + 0.25 * corner(before, other);
  };
  const double h_end = blended(h, before.next(h));
  const double h_begin = blended(before.prev(h), before.prev(before.prev(h)));
  const double o_end = blended(o, before.next(o));
  const double o_begin = blended(before.prev(o), before.prev(before.prev(o)));
  const Face f = bevel_edge(mesh, e, 0.25).value();
  EXPECT_EQ(corner(mesh, h), h_end);
  EXPECT_EQ(corner(mesh, mesh.prev(h)), h_begin);
  const Halfedge g = mesh.next(mesh.next(o));  // across the new face
  const Halfedge k = mesh.opposite(g);
  EXPECT_EQ(mesh.face(k), before.face(o));
  EXPECT_EQ(corner(mesh, k), o_end);
  EXPECT_EQ(corner(mesh, mesh.prev(k)), o_begin);
  // The new face: o, a short side, g, the other.
  EXPECT_EQ(corner(mesh, o), h_begin);
  EXPECT_EQ(corner(mesh, mesh.next(o)), o_end);
  EXPECT_EQ(corner(mesh, g), o_begin);
  EXPECT_EQ(corner(mesh, mesh.next(g)), h_end);
  EXPECT_EQ(value(mesh, ItemKind::kEdge, "copy", mesh.edge(k).index()),
            value(before, ItemKind::kEdge, "copy", e.index()));
  EXPECT_EQ(value(mesh, ItemKind::kFace, "copy", f.index()),
            value(before, ItemKind::kFace, "copy", before.face(h).index()));
}

TEST(BevelEdge, LeavesCornersBeyondASeam) {
  // A chart for each face. Of the three other faces at an apex those at the sides contain an edge
  // along which it moves; the middle one doesn't.
  Mesh mesh = reference_build(bipyramid(5));
  Attribute& uv = *mesh.add_attribute(ItemKind::kHalfedge, "uv",
                                      {.type = Scalar::kFloat64, .on_split = OnSplit::kInterpolate})
                       .value();
  for (const Halfedge h : mesh.halfedges()) {
    uv.set(h.index(), 0, 100 * mesh.face(h).index() + mesh.to_vertex(h).index(), nullptr);
  }
  const Mesh before = copy_of(mesh);
  const Halfedge h = Mesh::opposite(mesh.vertex_halfedge(Vertex(0)));
  const Vertex v = before.to_vertex(h);
  ASSERT_TRUE(bevel_edge(mesh, mesh.edge(h), 0.5).ok());
  const Halfedge beside = Mesh::opposite(before.next(h));
  const Face middle = before.face(before.next_on_vertex(beside));
  const double chart = 100 * before.face(beside).index();
  const double left = before.to_vertex(before.next(h)).index();
  EXPECT_EQ(uv.get(beside.index(), 0), chart + 0.5 * v.index() + 0.5 * left);
  int kept = 0;
  for (const Halfedge side : mesh.face_halfedges_ccw(middle)) {
    kept += int(uv.get(side.index(), 0) == 100 * middle.index() + v.index());
  }
  EXPECT_EQ(kept, 2);
}

TEST(BevelEdge, Refusals) {
  Mesh mesh = reference_build(mixed_polygons());
  add_attributes_of_all_kinds(mesh);
  const Snapshot before(mesh);
  expect_refused(bevel_edge(mesh, Edge(99), 0.5), "not-an-edge", mesh, before);
  expect_refused(bevel_vertex(mesh, Vertex(99), 0.5), "not-a-vertex", mesh, before);
  for (const Edge e : mesh.edges()) {
    if (!mesh.is_boundary(e)) continue;
    const Result<Face> refused = bevel_edge(mesh, e, 0.5);
    expect_refused(refused, "boundary-edge", mesh, before);
    EXPECT_EQ(refused.error().witness.edges, std::vector<Index>{e.index()});
  }
  Mesh two = reference_build(pillow());
  const Snapshot pillow_before(two);
  const Result<Face> refused = bevel_edge(two, Edge(1), 0.5);
  expect_refused(refused, "valence-below-three", two, pillow_before);
  EXPECT_EQ(refused.error().witness.edges, std::vector<Index>{1});
  EXPECT_EQ(refused.error().witness.vertices.size(), 2U);
}

TEST(ExtrudeAndBevel, WithoutPrev) {
  const Shape shape = grid_of("", 4, 4, [](Index x, Index y) { return (x + y) % 2 == 0; });
  const auto apply = [](auto& m) {
    EXPECT_TRUE(extrude_face(m, Face(3), 0.5).ok());
    EXPECT_TRUE(inset_face(m, Face(5), 0.5).ok());
    EXPECT_TRUE(bevel_vertex(m, Vertex(12), 0.25).ok());
    EXPECT_TRUE(bevel_vertex(m, Vertex(2), 0.25).ok());
    for (Edge e(0);; e = Edge(e.index() + 1)) {
      if (m.is_boundary(e)) continue;
      EXPECT_TRUE(bevel_edge(m, e, 0.25).ok());
      break;
    }
    EXPECT_FALSE(has_errors(validate(m)));
  };
  expect_same_without_prev(shape, apply);
}

}  // namespace
}  // namespace halfedge::test
