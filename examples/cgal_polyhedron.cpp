// "Halfedge of a Polyhedral Surface" of CGAL's reference manual, in CGAL's names: the access
// functions of a halfedge, both circulators, border halfedges, and prev() with and without storage.

#include <halfedge/build/build.h>
#include <halfedge/connectivity/convert.h>
#include <halfedge/dialects/cgal.h>
#include <halfedge/mesh.h>

#include <ios>
#include <iostream>
#include <string>
#include <utility>

namespace {

using Mesh = halfedge::Mesh;
using MeshWithoutPrev = halfedge::BasicMesh<halfedge::kWithoutPrev>;
using Polyhedron = halfedge::dialects::cgal::Polyhedron<Mesh>;
using Halfedge_handle = Polyhedron::Halfedge_handle;
using Facet_handle = Polyhedron::Facet_handle;

// A box without its lid 4-5-6-7.
//
//      7───────6
//     ╱│      ╱│        z y
//    4───────5 │        │╱
//    │ 3─────│─2        └─ x
//    │╱      │╱
//    0───────1
constexpr float kPositions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0,
                                0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
constexpr halfedge::Index kSizes[] = {4, 4, 4, 4, 4};
constexpr halfedge::Index kCorners[] = {0, 3, 2, 1, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
constexpr const char* kNames[] = {"bottom", "front", "right", "back", "left"};

std::string name_of(halfedge::Vertex v) { return std::to_string(v.index()); }
// Of the polyhedron, and of the one that doesn't store prev.
template <class M>
std::string name_of(halfedge::dialects::cgal::HalfedgeOf<M> h) {
  return name_of(h->opposite()->vertex()) + ">" + name_of(h->vertex());
}
std::string name_of(Facet_handle f) {
  return f == Facet_handle() ? "none" : kNames[halfedge::Face(f).index()];
}

// Each is equal to what stands in brackets in the manual.
void print_access_functions(Halfedge_handle h) {
  std::cout << "halfedge " << name_of(h) << "\n  opposite " << name_of(h->opposite()) << "\n  next "
            << name_of(h->next()) << "\n  prev " << name_of(h->prev()) << "\n  vertex "
            << name_of(h->vertex()) << "\n  facet " << name_of(h->facet()) << "\n  next_on_vertex "
            << name_of(h->next_on_vertex()) << " = " << name_of(h->next()->opposite())
            << "\n  prev_on_vertex " << name_of(h->prev_on_vertex()) << " = "
            << name_of(h->opposite()->prev()) << "\n  is_border " << h->is_border()
            << "\n  is_border_edge " << h->is_border_edge() << '\n';
}

template <class Circulator>
void print_forwards(const char* title, Circulator c) {
  std::cout << title << ':';
  const Circulator begin = c;
  do {
    std::cout << ' ' << name_of(*c);
  } while (++c != begin);
  std::cout << '\n';
}

// A circulator has no end: this one goes back two laps.
template <class Circulator>
void print_backwards(const char* title, Circulator c) {
  std::cout << title << ':';
  const Circulator begin = c;
  for (int laps = 0; laps < 2; laps += c == begin ? 1 : 0) {
    --c;
    std::cout << ' ' << name_of(*c);
  }
  std::cout << '\n';
}

}  // namespace

int main() {
  Mesh box;
  halfedge::BuildReport report;
  if (!halfedge::build_from_polygons(box, {kPositions, kSizes, kCorners}, report)) {
    std::cerr << report.problems[0].message << '\n';
    return 1;
  }
  std::cout << std::boolalpha;
  const Polyhedron polyhedron(box);
  const halfedge::Halfedge front_to_5 = box.find_halfedge(halfedge::Vertex(1), halfedge::Vertex(5));
  const Halfedge_handle h = polyhedron(front_to_5);
  print_access_functions(h);
  print_forwards("clockwise around vertex 5", h->vertex_begin());
  print_backwards("and back", h->vertex_begin());
  print_forwards("counterclockwise around the front", h->facet_begin());
  print_backwards("and back", h->facet_begin());

  const Halfedge_handle border = h->next()->opposite();
  print_access_functions(border);
  print_forwards("along the hole", border->facet_begin());

  MeshWithoutPrev without_prev;
  const halfedge::Result<void> converted = halfedge::convert(std::move(box), without_prev);
  if (!converted) {
    std::cerr << converted.error().message << '\n';
    return 1;
  }
  const auto searched = halfedge::dialects::cgal::Polyhedron(without_prev)(front_to_5);
  std::cout << "where prev is not stored, a search finds prev " << name_of(searched->prev())
            << " and prev_on_vertex " << name_of(searched->prev_on_vertex()) << '\n';
}
