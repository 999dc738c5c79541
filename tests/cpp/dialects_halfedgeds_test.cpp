// The decorator of CGAL's HalfedgeDS in CGAL's names: the program of its manual, and that each name
// stands for the operation that it should.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/dialects/cgal_halfedgeds.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "support/same_links.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

namespace cgal = dialects::cgal;

struct Traits {
  typedef int Point_2;
};
typedef cgal::HalfedgeDS_default<Traits> HDS;
typedef cgal::HalfedgeDS_decorator<HDS> Decorator;
typedef Decorator::Halfedge_handle Handle;

TEST(CgalHalfedgeDS, BuildsTheLoopOfTheManualAndVerifiesIt) {
  HDS hds;
  Decorator decorator(hds);
  const Handle h = decorator.create_loop();
  EXPECT_EQ(hds.halfedge_count(), 2U);
  EXPECT_EQ(hds.vertex_count(), 1U);
  EXPECT_EQ(hds.face_count(), 2U);
  EXPECT_EQ(h->next(), h);
  EXPECT_EQ(h->vertex(), h->opposite()->vertex());
  EXPECT_NE(h->face(), h->opposite()->face());
  for (int level = 0; level <= 3; ++level) EXPECT_TRUE(decorator.is_valid(false, level));
  EXPECT_FALSE(decorator.is_valid(false, 4));
}

TEST(CgalHalfedgeDS, BuildsTheSegment) {
  HDS hds;
  Decorator decorator(hds);
  const Handle h = decorator.create_segment();
  EXPECT_EQ(hds.halfedge_count(), 2U);
  EXPECT_EQ(hds.vertex_count(), 2U);
  EXPECT_EQ(hds.face_count(), 1U);
  EXPECT_EQ(h->next(), h->opposite());
  EXPECT_TRUE(decorator.is_valid(false, 3));
}

TEST(CgalHalfedgeDS, TellsABrokenStructure) {
  HDS hds;
  Decorator decorator(hds);
  const Handle h = decorator.create_segment();
  hds.link(h, h);
  EXPECT_FALSE(decorator.is_valid());
}

// Runs an operation by CGAL's name and one by ours on equal meshes.
struct Both {
  std::function<bool(cgal::HalfedgeDS_decorator<Mesh>&)> by_their_name;
  std::function<bool(Mesh&)> by_ours;
};

// The cube without its bottom, so that there are a boundary and vertices of valence three.
Mesh open_cube() {
  Shape shape = cube();
  shape.faces.erase(shape.faces.begin());
  const Shape open("open cube", shape.vertices, shape.faces);
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, open.polygons(), report));
  return mesh;
}

bool same_links(const Mesh& a, const Mesh& b) {
  const Links& x = a.links();
  const Links& y = b.links();
  return same(x.next, y.next) && same(x.prev, y.prev) && same(x.to_vertex, y.to_vertex) &&
         same(x.face, y.face) && same(x.vertex_halfedge, y.vertex_halfedge) &&
         same(x.face_halfedge, y.face_halfedge);
}

TEST(CgalHalfedgeDS, NamesOurOperations) {
  const Mesh mesh = open_cube();
  const Halfedge h = mesh.find_halfedge(Vertex(4), Vertex(5));  // of the top
  const Halfedge g = mesh.next(mesh.next(h));
  const Halfedge rim = mesh.vertex_halfedge(Vertex(0));
  const Halfedge j = mesh.opposite(mesh.prev(mesh.opposite(h)));
  const auto halfedge = [](const Result<Halfedge>& result) { return result.ok(); };
  const std::vector<Both> operations = {
      {[&](auto& d) { return d.split_face(h, g) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::split_face(m, h, g)); }},
      {[&](auto& d) { return d.join_face(h) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::join_face(m, h)); }},
      {[&](auto& d) { return d.split_vertex(h, mesh.opposite(mesh.next(h))) != nullptr; },
       [&](Mesh& m) {
         return halfedge(decorator::split_vertex(m, h, mesh.opposite(mesh.next(h))));
       }},
      {[&](auto& d) { return d.join_vertex(h) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::join_vertex(m, h)); }},
      {[&](auto& d) { return d.create_center_vertex(h) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::create_center_vertex(m, h)); }},
      {[&](auto& d) { return d.erase_center_vertex(h) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::erase_center_vertex(m, h)); }},
      {[&](auto& d) { return d.make_hole(h) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::make_hole(m, h)); }},
      {[&](auto& d) { return d.fill_hole(rim) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::fill_hole(m, rim)); }},
      {[&](auto& d) { return d.add_face_to_border(rim, mesh.next(mesh.next(rim))) != nullptr; },
       [&](Mesh& m) {
         return halfedge(decorator::add_face_to_boundary(m, rim, mesh.next(mesh.next(rim))));
       }},
      {[&](auto& d) { return d.join_loop(h, j) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::join_loop(m, h, j)); }},
      {[&](auto& d) { return d.split_loop(h, mesh.next(h), g) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::split_loop(m, h, mesh.next(h), g)); }},
      {[&](auto& d) { return d.flip_edge(h) != nullptr; },
       [&](Mesh& m) { return halfedge(decorator::flip_edge(m, h)); }},
      {[&](auto& d) { return d.erase_face(h); },
       [&](Mesh& m) { return decorator::erase_face(m, h).ok(); }},
      {[&](auto& d) { return d.inside_out(); },
       [&](Mesh& m) { return decorator::inside_out(m).ok(); }},
      {[&](auto& d) { return d.normalize_border(); },
       [&](Mesh& m) { return decorator::normalize_boundary(m).ok(); }},
  };
  int done = 0;
  for (std::size_t i = 0; i < operations.size(); ++i) {
    SCOPED_TRACE("operation " + std::to_string(i));
    Mesh theirs = open_cube();
    Mesh ours = open_cube();
    cgal::HalfedgeDS_decorator<Mesh> named(theirs);
    const bool could = operations[i].by_ours(ours);
    EXPECT_EQ(operations[i].by_their_name(named), could);
    EXPECT_TRUE(same_links(theirs, ours));
    EXPECT_TRUE(named.is_valid(false, 3));
    done += could && !same_links(mesh, ours) ? 1 : 0;
  }
  EXPECT_GE(done, 11);
}

TEST(CgalHalfedgeDS, ReturnsAnEmptyHandleAndChangesNothingWhereCgalHasAPrecondition) {
  Mesh mesh = open_cube();
  const Mesh before = open_cube();
  cgal::HalfedgeDS_decorator<Mesh> named(mesh);
  const Halfedge rim = mesh.vertex_halfedge(Vertex(0));
  EXPECT_EQ(named.fill_hole(mesh.opposite(rim)), nullptr);
  EXPECT_EQ(named.make_hole(rim), nullptr);
  EXPECT_FALSE(named.erase_face(rim));
  EXPECT_TRUE(same_links(mesh, before));
}

}  // namespace
}  // namespace halfedge::test
