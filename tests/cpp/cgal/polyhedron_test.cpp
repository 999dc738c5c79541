// The CGAL dialect against CGAL: one program, written in CGAL's names, runs over their polyhedron
// and over ours, and both must say the same.

#include "cgal/polyhedron.h"

#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/dialects/cgal.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/random_polygons.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

using Dialect = dialects::cgal::Polyhedron<Mesh>;

// The program. It tells items by the order of their vertices and facets, which is that of the
// input on both sides. Which halfedge a vertex and a facet begin with is a matter of the builder:
// there, and only there, cycles are turned so that they begin with their smallest name.
template <class Polyhedron>
class Tour {
  using Vertex_handle = typename Polyhedron::Vertex_const_handle;
  using Halfedge_handle = typename Polyhedron::Halfedge_const_handle;
  using Facet_handle = typename Polyhedron::Facet_const_handle;
  using Around_vertex = typename Polyhedron::Halfedge_around_vertex_const_circulator;
  using Around_facet = typename Polyhedron::Halfedge_around_facet_const_circulator;
  using Names = std::vector<std::string>;

 public:
  explicit Tour(const Polyhedron& polyhedron) : p(polyhedron) {
    for (typename Polyhedron::Vertex_const_iterator v = p.vertices_begin(); v != p.vertices_end();
         ++v) {
      vertices.emplace(v, vertices.size());
    }
    for (typename Polyhedron::Facet_const_iterator f = p.facets_begin(); f != p.facets_end(); f++) {
      facets.emplace(f, facets.size());
    }
  }

  Names run() {
    say("sizes",
        {number(p.size_of_vertices()), number(p.size_of_halfedges()), number(p.size_of_facets()),
         number(p.is_closed()), number(p.is_pure_triangle()), number(p.is_pure_quad())});
    for (auto v = p.vertices_begin(); v != p.vertices_end(); ++v) vertex(v);
    for (auto f = p.facets_begin(); f != p.facets_end(); ++f) facet(f);
    std::map<std::string, Halfedge_handle> by_name;
    for (auto h = p.halfedges_begin(); h != p.halfedges_end(); ++h) by_name.emplace(name(h), h);
    for (const auto& [name, h] : by_name) halfedge(h);
    Names edges;
    for (auto e = p.edges_begin(); e != p.edges_end(); ++e) {
      edges.push_back(std::min(name(Halfedge_handle(e)), name(e->opposite())));
    }
    std::sort(edges.begin(), edges.end());
    say("edges", edges);
    return std::move(said);
  }

 private:
  static std::string number(std::size_t n) { return std::to_string(n); }
  std::string name(Vertex_handle v) const { return number(vertices.at(v)); }
  std::string name(Halfedge_handle h) const {
    return name(h->opposite()->vertex()) + ">" + name(h->vertex());
  }
  std::string name(Facet_handle f) const {
    return f == Facet_handle() ? "no facet" : "f" + number(facets.at(f));
  }

  void say(const std::string& question, const Names& answers) {
    std::string line = question + ":";
    for (const std::string& answer : answers) line += " " + answer;
    said.push_back(line);
  }

  static Names turned(Names cycle) {
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    return cycle;
  }

  // As the documents have it.
  template <class Circulator>
  Names forward(Circulator c) {
    Names items;
    const Circulator begin = c;
    do {
      items.push_back(name(Halfedge_handle(c)));
    } while (++c != begin);
    return items;
  }
  template <class Circulator>
  Names backward(Circulator c) {
    Names items;
    const Circulator begin = c;
    do {
      items.push_back(name(Halfedge_handle(c)) + " of " + name(c->facet()));
      c--;
    } while (c != begin);
    return items;
  }

  void vertex(Vertex_handle v) {
    say("vertex " + name(v), {number(v->vertex_degree()), number(v->degree()),
                              number(v->is_bivalent()), number(v->is_trivalent())});
    say("point", {std::to_string(v->point().x()), std::to_string(v->point().z())});
    std::ostringstream printed;
    printed << v->point();
    say("point printed", {printed.str()});
    say("coordinates", {std::to_string(v->point()[1]), std::to_string(v->point().cartesian(2))});
    say("halfedge", {name(v->halfedge()->vertex())});
    say("vertex_begin", turned(forward(v->vertex_begin())));
  }

  void facet(Facet_handle f) {
    say(name(f), {number(f->facet_degree()), number(f->size()), number(f->is_triangle()),
                  number(f->is_quad()), name(f->halfedge()->facet())});
    say("facet_begin", turned(forward(f->facet_begin())));
  }

  void halfedge(Halfedge_handle h) {
    say(name(h), {name(h->next()), name(h->prev()), name(h->opposite()), name(h->vertex()),
                  name(h->facet()), name(h->face()), name(h->next_on_vertex()),
                  name(h->prev_on_vertex()), number(h->is_border()), number(h->is_border_edge()),
                  number(h->vertex_degree()), number(h->facet_degree()), number(h->is_bivalent()),
                  number(h->is_trivalent()), number(h->is_triangle()), number(h->is_quad())});
    say("with a dot", {name((*h).next()), name((*h).next_on_vertex())});
    say("vertex_begin", forward(h->vertex_begin()));
    say("vertex_begin, back", backward(h->vertex_begin()));
    say("facet_begin", forward(h->facet_begin()));
    say("facet_begin, back", backward(h->facet_begin()));
    Around_vertex around_vertex = h->vertex_begin();
    Around_facet around_facet = h->facet_begin();
    say("post-increment",
        {name(Halfedge_handle(around_vertex++)), name(Halfedge_handle(around_facet++)),
         name(Halfedge_handle(around_vertex)), name(Halfedge_handle(around_facet)),
         name((*around_facet).vertex())});
    say("==", {number(around_vertex == h->vertex_begin()), number(around_facet == nullptr),
               number(Around_facet() == nullptr)});
  }

  const Polyhedron& p;
  std::map<Vertex_handle, std::size_t> vertices;
  std::map<Facet_handle, std::size_t> facets;
  Names said;
};

// Whether CGAL could build it and both say the same.
bool compare(const Shape& shape) {
  SCOPED_TRACE(shape.name);
  Mesh ours;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(ours, shape.polygons(), report)) << report.problems[0].message;
  // The boundary halfedge that follows at a pinched vertex is a matter of the builder.
  for (const Vertex v : ours.vertices()) {
    if (!ours.is_manifold(v)) return false;
  }
  CgalPolyhedron theirs;
  CgalBuilder builder(shape);
  theirs.delegate(builder);
  if (!builder.taken()) return false;

  const Dialect dialect(ours);
  const std::vector<std::string> said_by_theirs = Tour<CgalPolyhedron>(theirs).run();
  const std::vector<std::string> said_by_ours = Tour<Dialect>(dialect).run();
  EXPECT_EQ(said_by_ours.size(), said_by_theirs.size());
  for (std::size_t i = 0; i < std::min(said_by_ours.size(), said_by_theirs.size()); ++i) {
    EXPECT_EQ(said_by_ours[i], said_by_theirs[i]);
    if (said_by_ours[i] != said_by_theirs[i]) break;
  }
  theirs.normalize_border();
  EXPECT_EQ(dialect.size_of_border_halfedges(), theirs.size_of_border_halfedges());
  EXPECT_EQ(dialect.size_of_border_edges(), theirs.size_of_border_edges());
  return true;
}

TEST(CgalDialect, RunsTheSameProgramWithTheSameResultAsCgal) {
  int compared = 0;
  for (const Shape& shape : all_shapes()) compared += compare(shape) ? 1 : 0;
  EXPECT_GE(compared, 12);
}

TEST(CgalDialect, AgreesWithCgalOnRandomPolygons) {
  int compared = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed)
    compared += compare(random_polygons(seed)) ? 1 : 0;
  EXPECT_GE(compared, 10);
}

}  // namespace
}  // namespace halfedge::test
