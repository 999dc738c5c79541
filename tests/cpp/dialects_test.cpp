// What the dialects of CGAL and McGuire do beyond what CGAL's own polyhedron can be compared with;
// see also openmesh/dialect_test.cpp and cgal/polyhedron_test.cpp.

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/connectivity/convert.h>
#include <halfedge/dialects/cgal.h>
#include <halfedge/dialects/mcguire.h>
#include <halfedge/dialects/openmesh.h>
#include <halfedge/directed_edges/convert.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "support/built.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using Polyhedron = dialects::cgal::Polyhedron<Mesh>;

TEST(CgalDialect, GivesAnEmptyFacetOfABorderHalfedge) {
  const Mesh mesh = built(triangle());
  const Polyhedron polyhedron(mesh);
  const Polyhedron::Halfedge_handle h = polyhedron(mesh.vertex_halfedge(Vertex(0)));
  EXPECT_TRUE(h->is_border());
  EXPECT_TRUE(h->is_border_edge());
  EXPECT_EQ(h->facet(), Polyhedron::Facet_handle());
  EXPECT_EQ(h->facet(), nullptr);
  EXPECT_FALSE(h->opposite()->is_border());
  EXPECT_TRUE(h->opposite()->is_border_edge());
  EXPECT_EQ(h->opposite()->facet(), polyhedron(Face(0)));
}

TEST(CgalDialect, TakesTheDotAsTheDocumentWritesIt) {
  const Mesh mesh = built(cube());
  for (const Halfedge at : mesh.halfedges()) {
    const Polyhedron::Halfedge_handle h = Polyhedron(mesh)(at);
    EXPECT_EQ(h.next_on_vertex(), h.next()->opposite());
    EXPECT_EQ(h.prev_on_vertex(), h.opposite()->prev());
    EXPECT_EQ(Halfedge(h.next_on_vertex().prev_on_vertex()), at);
  }
}

TEST(CgalDialect, CirculatesEndlesslyBothWays) {
  const Mesh mesh = built(disk(7));
  const Polyhedron polyhedron(mesh);
  Polyhedron::Halfedge_around_vertex_circulator c = polyhedron(Vertex(0))->vertex_begin();
  std::vector<Vertex> twice;
  for (int i = 0; i < 14; ++i) twice.push_back((c++)->opposite()->vertex());
  EXPECT_TRUE(std::equal(twice.begin(), twice.begin() + 7, twice.begin() + 7));
  for (int i = 13; i >= 0; --i)
    EXPECT_EQ(Vertex((--c)->opposite()->vertex()), twice[std::size_t(i)]);
  std::vector<Vertex> ring;
  for (const Vertex w : mesh.vertex_vertices_cw(Vertex(0))) ring.push_back(w);
  EXPECT_EQ(ring, (std::vector<Vertex>(twice.begin(), twice.begin() + 7)));
}

TEST(CgalDialect, IsWalkedBackwardsByReverseIterators) {
  const Mesh mesh = built(disk(7));
  const Polyhedron polyhedron(mesh);
  std::vector<Vertex> backward;
  for (auto v = std::make_reverse_iterator(polyhedron.vertices_end());
       v != std::make_reverse_iterator(polyhedron.vertices_begin()); ++v) {
    const auto& vertex = *v;
    EXPECT_EQ(v->point(), vertex.point());
    backward.push_back(vertex);
  }
  std::vector<Vertex> expected;
  for (const Vertex v : mesh.vertices()) expected.insert(expected.begin(), v);
  EXPECT_EQ(backward, expected);

  const Polyhedron::Halfedge_around_vertex_circulator c = polyhedron(Vertex(0))->vertex_begin();
  const auto& before = *std::make_reverse_iterator(c);
  EXPECT_EQ(before, *std::prev(c));
}

TEST(CgalDialect, HasHandlesThatAreKeys) {
  const Mesh mesh = built(disk(7));
  const Polyhedron polyhedron(mesh);
  std::unordered_map<Polyhedron::Vertex_handle, std::size_t> degrees;
  std::unordered_set<Polyhedron::Halfedge_handle> halfedges;
  std::unordered_set<Polyhedron::Facet_handle> facets;
  for (auto v = polyhedron.vertices_begin(); v != polyhedron.vertices_end(); ++v) {
    degrees[v] = v->vertex_degree();
  }
  for (auto h = polyhedron.halfedges_begin(); h != polyhedron.halfedges_end(); ++h) {
    halfedges.insert(h);
  }
  for (auto f = polyhedron.facets_begin(); f != polyhedron.facets_end(); ++f) facets.insert(f);
  EXPECT_EQ(degrees.at(polyhedron(Vertex(0))), 7U);
  EXPECT_EQ(degrees.size(), 8U);
  EXPECT_EQ(halfedges.size(), 28U);
  EXPECT_EQ(facets.size(), 7U);
}

TEST(CgalDialect, HasNothingAroundAnIsolatedVertex) {
  Mesh mesh;
  const Polyhedron polyhedron(mesh);
  const Polyhedron::Vertex_handle v = polyhedron(mesh.add_vertex({1, 2, 3}));
  EXPECT_EQ(v->halfedge(), nullptr);
  EXPECT_EQ(v->vertex_begin(), nullptr);
  EXPECT_EQ(v->vertex_degree(), 0U);
  EXPECT_EQ(v->point().y(), 2.0F);
}

TEST(CgalDialect, StepsOverDeletedItems) {
  Mesh mesh = built(quad_grid(3, 1));
  const Face middle(1);
  std::vector<Halfedge> around;
  for (const Halfedge h : mesh.face_halfedges_ccw(middle)) around.push_back(h);
  for (const Halfedge h : around) mesh.set_face(h, Face());
  mesh.release(middle);
  const Polyhedron polyhedron(mesh);
  std::vector<Face> faces;
  for (Polyhedron::Facet_iterator f = polyhedron.facets_begin(); f != polyhedron.facets_end();
       ++f) {
    faces.push_back(f);
  }
  EXPECT_EQ(faces, (std::vector<Face>{Face(0), Face(2)}));
  Polyhedron::Facet_iterator last = polyhedron.facets_end();
  --last;
  EXPECT_EQ(Face(*last--), Face(2));
  EXPECT_EQ(Face(*last), Face(0));
  EXPECT_EQ(polyhedron.size_of_facets(), 2U);
}

TEST(CgalDialect, SearchesForPrevWhereItIsNotStored) {
  const Mesh mesh = built(mixed_polygons());
  BasicMesh<kWithoutPrev> without_prev;
  ASSERT_TRUE(convert(built(mixed_polygons()), without_prev));
  static_assert(!StoresPrev<BasicMesh<kWithoutPrev>>);
  const Polyhedron with(mesh);
  const dialects::cgal::Polyhedron without(without_prev);
  const dialects::openmesh::PolyMesh openmesh(without_prev);
  for (const Halfedge h : mesh.halfedges()) {
    EXPECT_EQ(Halfedge(without(h)->prev()), Halfedge(with(h)->prev()));
    EXPECT_EQ(Halfedge(without(h)->prev_on_vertex()), Halfedge(with(h)->prev_on_vertex()));
    EXPECT_EQ(openmesh.prev_halfedge_handle(h), mesh.prev(h));
  }
}

// All that the dialects tell of a mesh of ours, with its halfedges by their ends.
template <class M>
std::vector<std::string> told(const M& mesh) {
  std::vector<std::string> said;
  const auto name = [&](Halfedge h) {
    return std::to_string(mesh.from_vertex(h).index()) + ">" +
           std::to_string(mesh.to_vertex(h).index());
  };
  const dialects::openmesh::PolyMesh openmesh(mesh);
  const dialects::cgal::Polyhedron polyhedron(mesh);
  Result<dialects::mcguire::HE_mesh> copied = dialects::mcguire::copy(mesh);
  EXPECT_TRUE(copied.ok());
  const dialects::mcguire::HE_mesh& structs = copied.value();
  for (const auto v : openmesh.vertices()) {
    std::string line = "vertex " + std::to_string(v.idx()) + ":";
    for (const auto w : openmesh.vv_range(v)) line += " " + std::to_string(w.idx());
    for (const auto h : openmesh.voh_ccw_range(v)) line += " " + name(h);
    for (const auto h : openmesh.vih_range(v)) line += " " + name(h);
    for (const auto f : openmesh.vf_ccw_range(v)) line += " " + std::to_string(f.idx());
    const auto begin = polyhedron(v)->vertex_begin();
    if (begin != nullptr) {
      auto c = begin;
      do line += " " + name(*c);
      while (--c != begin);
    }
    const auto* vert = structs.vert(v);
    if (const auto* edge = vert->edge) {
      do {
        line += " " + name(structs.item(edge));
        edge = edge->pair->next;
      } while (edge != vert->edge);
    }
    said.push_back(line + (openmesh.is_boundary(v) ? " boundary" : ""));
  }
  for (const auto f : openmesh.faces()) {
    std::string line = "face " + std::to_string(f.idx()) + ":";
    for (const auto w : openmesh.fv_range(f)) line += " " + std::to_string(w.idx());
    for (const auto g : openmesh.ff_cw_range(f)) line += " " + std::to_string(g.idx());
    line += " " + name(polyhedron(f)->halfedge()->prev());
    said.push_back(line);
  }
  std::vector<std::string> edges;
  for (auto e = polyhedron.edges_begin(); e != polyhedron.edges_end(); ++e) {
    edges.push_back(std::min(name(e), name(e->opposite())) +
                    (e->is_border_edge() ? " border" : ""));
  }
  std::sort(edges.begin(), edges.end());
  said.insert(said.end(), edges.begin(), edges.end());
  said.push_back(std::to_string(polyhedron.size_of_vertices()) + " " +
                 std::to_string(polyhedron.size_of_halfedges()) + " " +
                 std::to_string(polyhedron.size_of_facets()));
  return said;
}

TEST(OpenMeshDialect, StepsBackByTheOlderFunctionsToo) {
  const Mesh mesh = built(quad_grid(3, 3));
  const dialects::openmesh::PolyMesh theirs(mesh);
  EXPECT_EQ(std::prev(theirs.vertices_end())->idx(), int(mesh.vertex_slots()) - 1);
  const auto ring = theirs.vv_range(Vertex(5));
  const std::vector<int> forward = [&] {
    std::vector<int> met;
    for (const auto w : ring) met.push_back(w.idx());
    return met;
  }();
  EXPECT_EQ(std::prev(ring.end())->idx(), forward.back());
  std::vector<int> backward;
  for (auto w = std::make_reverse_iterator(ring.end());
       w != std::make_reverse_iterator(ring.begin()); ++w) {
    backward.push_back((*w).idx());
  }
  EXPECT_EQ(backward, std::vector<int>(forward.rbegin(), forward.rend()));
}

TEST(OpenMeshDialect, MeetsNewItemsInDeletedSlotsAheadOnce) {
  Mesh mesh;
  for (int i = 0; i < 6; ++i) ASSERT_TRUE(mesh.new_vertex().valid());
  dialects::openmesh::PolyMesh<Mesh> theirs(mesh);
  std::vector<int> met;
  for (const auto v : theirs.vertices()) {
    met.push_back(v.idx());
    if (v.idx() == 1) {
      for (const Index deleted : {0U, 2U, 3U, 5U}) mesh.release(Vertex(deleted));
      mesh.release(Vertex(1));
      EXPECT_EQ(theirs.new_vertex().idx(), 1);  // behind
      EXPECT_EQ(theirs.new_vertex().idx(), 5);
    }
  }
  EXPECT_EQ(met, (std::vector<int>{0, 1, 4, 5}));
}

TEST(Dialects, TellTheSameOfEveryMeshTypeThatHasTheLinks) {
  int triangle_meshes = 0;
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = built(shape);
    const std::vector<std::string> expected = told(mesh);

    BasicMesh<kWithoutPrev> without_prev;
    ASSERT_TRUE(convert(built(shape), without_prev));
    EXPECT_EQ(told(without_prev), expected);

    Connectivity connectivity;
    ASSERT_TRUE(convert(built(shape), connectivity));
    EXPECT_EQ(told(connectivity), expected);

    DirectedEdgesMesh directed_edges;
    if (!from_mesh(mesh, directed_edges)) continue;  // for triangles only
    EXPECT_EQ(told(directed_edges), expected);
    ++triangle_meshes;
  }
  EXPECT_GE(triangle_meshes, 6);
}

// The article's structs.
class McGuireDialect : public testing::Test {
 protected:
  using HE_mesh = dialects::mcguire::HE_mesh;
  using HE_edge = dialects::mcguire::HE_edge;
  using HE_vert = dialects::mcguire::HE_vert;
  using HE_face = dialects::mcguire::HE_face;

  static HE_mesh copied(const Mesh& mesh) {
    Result<HE_mesh> copy = dialects::mcguire::copy(mesh);
    EXPECT_TRUE(copy.ok());
    return std::move(copy).value();
  }
};

TEST_F(McGuireDialect, LinksTheStructsAsTheMeshIsLinked) {
  for (const Shape& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Mesh mesh = built(shape);
    const HE_mesh copy = copied(mesh);
    for (const Halfedge h : mesh.halfedges()) {
      const HE_edge* edge = copy.edge(h);
      EXPECT_EQ(copy.item(edge), h);
      EXPECT_EQ(copy.item(edge->vert), mesh.to_vertex(h));
      EXPECT_EQ(copy.item(edge->pair), mesh.opposite(h));
      EXPECT_EQ(copy.item(edge->face), mesh.face(h));
      EXPECT_EQ(copy.item(edge->next), mesh.next(h));
    }
    for (const Vertex v : mesh.vertices()) {
      EXPECT_EQ(copy.item(copy.vert(v)->edge), mesh.vertex_halfedge(v));
      EXPECT_EQ((Point{copy.vert(v)->x, copy.vert(v)->y, copy.vert(v)->z}), mesh.position(v));
    }
    for (const Face f : mesh.faces()) {
      EXPECT_EQ(copy.item(copy.face(f)->edge), mesh.face_halfedge(f));
    }
  }
}

TEST_F(McGuireDialect, RunsTheLoopsOfTheArticleAsPrinted) {
  const Mesh mesh = built(torus(5, 4));
  HE_mesh copy = copied(mesh);
  for (const Vertex v : mesh.vertices()) {
    std::vector<Vertex> ring;
    HE_vert* vert = copy.vert(v);
    HE_edge* edge = vert->edge;
    do {
      ring.push_back(copy.item(edge->vert));
      edge = edge->pair->next;
    } while (edge != vert->edge);
    std::vector<Vertex> clockwise;
    for (const Vertex w : mesh.vertex_vertices_cw(v)) clockwise.push_back(w);
    EXPECT_EQ(ring, clockwise);
  }
  for (const Face f : mesh.faces()) {
    std::vector<Halfedge> loop;
    HE_face* face = copy.face(f);
    HE_edge* edge = face->edge;
    do {
      loop.push_back(copy.item(edge));
      edge = edge->next;
    } while (edge != face->edge);
    std::vector<Halfedge> counter_clockwise;
    for (const Halfedge h : mesh.face_halfedges_ccw(f)) counter_clockwise.push_back(h);
    EXPECT_EQ(loop, counter_clockwise);
  }
}

TEST_F(McGuireDialect, IsACopyThatMovesAndDoesNotFollowTheMesh) {
  Mesh mesh = built(cube());
  HE_mesh first = copied(mesh);
  const HE_edge* edge = first.edge(Halfedge(3));
  const HE_mesh moved = std::move(first);
  EXPECT_EQ(moved.edge(Halfedge(3)), edge);
  mesh.set_position(Vertex(2), {9, 9, 9});
  EXPECT_EQ(moved.vert(Vertex(2))->x, 2.0F / 8);
  moved.edge(Halfedge(0))->vert->x = 5;  // the structs are free to be edited
  EXPECT_NE(mesh.position(mesh.to_vertex(Halfedge(0))).x, 5.0F);
}

TEST_F(McGuireDialect, TakesThe232BytesAVertexThatItSays) {
  if (sizeof(void*) != 8) GTEST_SKIP() << "pointers of " << sizeof(void*) << " bytes";
  // Faces of a triangle mesh are 2 and halfedges 6 a vertex where it is closed and of genus 1.
  Shape triangles = torus(10, 10);
  std::vector<std::vector<Index>> faces;
  for (const std::vector<Index>& quad : triangles.faces) {
    faces.push_back({quad[0], quad[1], quad[2]});
    faces.push_back({quad[0], quad[2], quad[3]});
  }
  const Mesh mesh = built({"triangles", triangles.vertices, faces});
  EXPECT_EQ(copied(mesh).bytes(), 232U * mesh.vertex_count());
}

TEST_F(McGuireDialect, CopiesAConnectivityWithoutPositionsOrPrev) {
  const Mesh mesh = built(tetrahedron());
  BasicConnectivity<kWithoutPrev> bare;
  ASSERT_TRUE(convert(built(tetrahedron()), bare));
  Result<HE_mesh> copy = dialects::mcguire::copy(bare);
  ASSERT_TRUE(copy.ok());
  EXPECT_EQ(copy.value().vert(Vertex(1))->x, 0.0F);
  EXPECT_EQ(copy.value().item(copy.value().edge(Halfedge(1))->next), mesh.next(Halfedge(1)));
}

}  // namespace
}  // namespace halfedge::test
