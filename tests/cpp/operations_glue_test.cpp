// Gluing boundary edges, and cutting edges open.

#include <gtest/gtest.h>
#include <halfedge/operations/cut.h>
#include <halfedge/operations/glue.h>

#include <map>
#include <string>
#include <vector>

#include "support/polygon_lists.h"

namespace halfedge::test {
namespace {

using namespace operations;

std::vector<Halfedge> boundary_of(const Mesh& mesh) {
  std::vector<Halfedge> all;
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) all.push_back(h);
  }
  return all;
}

// The polygons after the ends of h and g became one: a mesh, with one edge less than before?
bool can_be_glued(const Mesh& mesh, Halfedge h, Halfedge g, PolygonList& glued) {
  std::map<Index, Index> kept;
  kept[mesh.from_vertex(g).index()] = mesh.to_vertex(h).index();
  kept[mesh.to_vertex(g).index()] = mesh.from_vertex(h).index();
  if (mesh.from_vertex(h) == mesh.from_vertex(g) || mesh.to_vertex(h) == mesh.to_vertex(g)) {
    return false;
  }
  glued = polygons_of(mesh);
  for (std::vector<Index>& polygon : glued) {
    for (Index& v : polygon) {
      if (kept.count(v) > 0) v = kept[v];
    }
  }
  return edges_of(glued).size() + 1 == mesh.edge_count() && is_mesh(glued);
}

TEST(Glue, SweepOverAllPairs) {
  std::map<std::string, int> codes;
  for (const auto& [name, mesh] : meshes_to_sweep(12)) {
    SCOPED_TRACE(name);
    std::vector<Halfedge> boundary = boundary_of(mesh);
    if (boundary.size() > 24) boundary.resize(24);
    for (const Halfedge h : boundary) {
      for (const Halfedge g : boundary) {
        SCOPED_TRACE(std::to_string(h.index()) + " " + std::to_string(g.index()));
        PolygonList expected;
        const bool can = can_be_glued(mesh, h, g, expected);
        const Result<void> check = check_glue(mesh, h, g);
        ++codes[check.ok() ? "done" : check.error().code];
        ASSERT_EQ(check.ok(), can) << (check.ok() ? "" : check.error().message);
        if (can && codes["done"] > 300 && h.index() % 5 != 0) continue;
        bool done = false;
        const Mesh glued = try_operation(
            mesh, [&](const Mesh& m) { return check_glue(m, h, g); },
            [&](Mesh& m) { return glue(m, h, g); }, done);
        if (!done) continue;
        EXPECT_EQ(canonical(polygons_of(glued)), canonical(expected));
        ASSERT_FALSE(HasFailure());
      }
    }
  }
}

TEST(Cut, SweepOverAllHalfedges) {
  std::map<std::string, int> codes;
  for (const auto& [name, mesh] : meshes_to_sweep(12)) {
    SCOPED_TRACE(name);
    for (const Halfedge h : mesh.halfedges()) {
      SCOPED_TRACE(h.index());
      if (mesh.edge_count() > 80 && h.index() % 7 != 0) continue;
      bool done = false;
      Mesh cut_open = try_operation(
          mesh, [&](const Mesh& m) { return check_cut(m, h); }, [&](Mesh& m) { return cut(m, h); },
          done);
      const Result<void> check = check_cut(mesh, h);
      ++codes[check.ok() ? "done" : check.error().code];
      const bool is_inside = !mesh.is_boundary(mesh.edge(h));
      EXPECT_EQ(done, is_inside && (mesh.is_boundary(mesh.from_vertex(h)) ||
                                    mesh.is_boundary(mesh.to_vertex(h))));
      if (!done) continue;
      const Index split = (mesh.is_boundary(mesh.from_vertex(h)) ? 1U : 0U) +
                          (mesh.is_boundary(mesh.to_vertex(h)) ? 1U : 0U);
      EXPECT_EQ(cut_open.vertex_count(), mesh.vertex_count() + split);
      EXPECT_EQ(cut_open.edge_count(), mesh.edge_count() + 1);
      EXPECT_EQ(cut_open.face_count(), mesh.face_count());
      // The new vertices where the old ones were, these are the old polygons.
      EXPECT_EQ(cut_open.face(h), mesh.face(h));
      Mesh again = copy_of(mesh);
      const Halfedge g = cut(again, h).value();
      EXPECT_TRUE(again.is_boundary(g) && again.is_boundary(Mesh::opposite(h)));
      ASSERT_TRUE(glue(again, Mesh::opposite(h), g).ok());
      expect_valid_mesh(again);
      EXPECT_EQ(canonical(polygons_of(again)), canonical(polygons_of(mesh)));
      ASSERT_FALSE(HasFailure());
    }
  }
}

}  // namespace
}  // namespace halfedge::test
