// "Halfedge Data Structures" of CGAL's manual. Its example program is printed incompletely; this
// one does what its text says: it builds a loop, consisting of two halfedges, one vertex and two
// faces, and verifies its validity.

#include <halfedge/dialects/cgal_halfedgeds.h>

#include <iostream>

namespace {

using namespace halfedge::dialects::cgal;

struct Traits {
  typedef int Point_2;
};
typedef HalfedgeDS_default<Traits> HDS;
typedef HalfedgeDS_decorator<HDS> Decorator;

}  // namespace

int main() {
  HDS hds;
  Decorator decorator(hds);
  const Decorator::Halfedge_handle h = decorator.create_loop();

  const Polyhedron sizes(hds);
  std::cout << sizes.size_of_halfedges() << " halfedges, " << sizes.size_of_vertices()
            << " vertex, " << sizes.size_of_faces() << " faces\n"
            << "next is the halfedge itself: " << (h->next() == h ? "yes" : "no") << '\n'
            << "both ends are one vertex: "
            << (h->vertex() == h->opposite()->vertex() ? "yes" : "no") << '\n'
            << "the two faces are two: " << (h->face() != h->opposite()->face() ? "yes" : "no")
            << '\n';
  for (int level = 0; level <= 3; ++level) {
    std::cout << "valid at level " << level << ": "
              << (decorator.is_valid(false, level) ? "yes" : "no") << '\n';
  }
  return decorator.is_valid() ? 0 : 1;
}
