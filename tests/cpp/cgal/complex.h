#pragma once

// CGAL before ours: its templates call a function `halfedge`, and must not find our namespace.
#include <CGAL/HalfedgeDS_const_decorator.h>
#include <CGAL/HalfedgeDS_decorator.h>
#include <CGAL/HalfedgeDS_default.h>
#include <CGAL/HalfedgeDS_items_2.h>
#include <halfedge/mesh.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "support/matching.h"

namespace halfedge::test {

struct NoGeometry {
  using Point_2 = int;
};
/// CGAL's list-like halfedge data structure with all links.
using Theirs = CGAL::HalfedgeDS_default<NoGeometry, CGAL::HalfedgeDS_items_2>;
using TheirDecorator = CGAL::HalfedgeDS_decorator<Theirs>;
using TheirHalfedge = Theirs::Halfedge_handle;
using TheirVertex = Theirs::Vertex_handle;
using TheirFace = Theirs::Face_handle;

/// CGAL's complex as `Matching` sees it. Items are named by their addresses.
struct TheirView {
  using H = const Theirs::Halfedge*;
  using V = const void*;
  using F = const void*;

  const Theirs& complex;

  [[nodiscard]] static H next(H h) { return &*h->next(); }
  [[nodiscard]] static H opposite(H h) { return &*h->opposite(); }
  [[nodiscard]] static V vertex(H h) { return &*h->vertex(); }
  [[nodiscard]] static F face(H h) { return h->is_border() ? nullptr : &*h->face(); }
  [[nodiscard]] static F no_face() { return nullptr; }
  [[nodiscard]] std::size_t vertices() const { return complex.size_of_vertices(); }
  [[nodiscard]] std::size_t halfedges() const { return complex.size_of_halfedges(); }
  [[nodiscard]] std::size_t faces() const { return complex.size_of_faces(); }
};

/// A CGAL complex with the links of one of our meshes, and its items by our indices. Isolated
/// vertices and deleted slots are left out.
class Mirror {
 public:
  using Halfedges = std::map<Index, TheirHalfedge>;

  explicit Mirror(const Mesh& mesh) {
    for (const Edge e : mesh.edges()) {
      const Halfedge h = mesh.edge_halfedge(e);
      const TheirHalfedge made = complex.edges_push_back(Theirs::Halfedge(), Theirs::Halfedge());
      halfedges[h.index()] = made;
      halfedges[mesh.opposite(h).index()] = made->opposite();
    }
    for (const Vertex v : mesh.vertices()) {
      if (!mesh.is_isolated(v)) vertices[v.index()] = complex.vertices_push_back(Theirs::Vertex());
    }
    for (const Face f : mesh.faces()) faces[f.index()] = complex.faces_push_back(Theirs::Face());
    for (const Halfedge h : mesh.halfedges()) copy_links(mesh, h);
    for (const auto& [v, vertex] : vertices) {
      vertex->set_halfedge(halfedges.at(mesh.opposite(mesh.vertex_halfedge(Vertex(v))).index()));
    }
    for (const auto& [f, face] : faces) {
      face->set_halfedge(halfedges.at(mesh.face_halfedge(Face(f)).index()));
    }
  }
  Mirror(const Mirror&) = delete;
  Mirror& operator=(const Mirror&) = delete;

  /// Compares with our mesh after both were changed in the same way; `ours` and `theirs` were
  /// returned. What is new is then known by our indices as well. The first difference, or "".
  std::string follow(const Mesh& mesh, Halfedge ours, TheirHalfedge theirs) {
    using Match = Matching<View<Mesh>, TheirView>;
    typename Match::Matched matched;
    for (const auto& [h, handle] : halfedges) {
      // An edge that was deleted and whose slot was taken again in one operation doesn't occur.
      if (mesh.is_live(Halfedge(h))) matched.emplace_back(h, &*handle);
    }
    if (ours.valid()) matched.emplace_back(ours.index(), &*theirs);
    if (complex.size_of_halfedges() != mesh.halfedge_count())
      return "the numbers of halfedges differ";
    Match match(View<Mesh>{mesh}, TheirView{complex});
    std::string difference = match.run(matched);
    std::map<const void*, TheirHalfedge> handles;
    for (auto it = complex.halfedges_begin(); it != complex.halfedges_end(); ++it)
      handles[&*it] = it;
    halfedges.clear();
    for (const auto& [h, address] : match.halfedges()) halfedges[h] = handles.at(address);
    return difference;
  }

  Theirs complex;
  Halfedges halfedges;
  std::map<Index, TheirVertex> vertices;
  std::map<Index, TheirFace> faces;

 private:
  using Base = Theirs::Halfedge::Base;

  void copy_links(const Mesh& mesh, Halfedge h) {
    const TheirHalfedge made = halfedges.at(h.index());
    made->Base::set_next(halfedges.at(mesh.next(h).index()));
    made->Base::set_prev(halfedges.at(mesh.prev(h).index()));
    made->Base::set_vertex(vertices.at(mesh.to_vertex(h).index()));
    if (!mesh.is_boundary(h)) made->Base::set_face(faces.at(mesh.face(h).index()));
  }
};

/// What their checker says.
inline bool they_accept(const Theirs& complex, int level) {
  return CGAL::HalfedgeDS_const_decorator<Theirs>(complex).is_valid(false, level);
}

}  // namespace halfedge::test
