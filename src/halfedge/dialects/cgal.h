#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/dialects/cgal_handles.h>

#include <cstddef>

/// Our meshes under the names of CGAL's HalfedgeDS and Polyhedron_3, for programs and people that
/// come from there:
///
///   using Polyhedron = halfedge::dialects::cgal::Polyhedron<halfedge::Mesh>;
///   Polyhedron polyhedron(ours);
///   Polyhedron::Halfedge_around_vertex_circulator c = h->vertex_begin(), begin = c;
///   do use(c->opposite()->vertex()); while (++c != begin);
///
/// A halfedge is incident to the vertex it points to, so circulators around a vertex visit the
/// halfedges that arrive there, clockwise; those around a facet go counter-clockwise. Orders are
/// compared with CGAL 5.5 by the tests.
namespace halfedge::dialects::cgal {
inline namespace HALFEDGE_CHECKS {

/// One mesh of ours (`Mesh`, any of its storage variants, ...) read through CGAL's names. It is a
/// reference: nothing is stored or copied, and both names can be used at the same time. Handles and
/// circulators hold the address of the mesh, and are invalidated as ours are.
template <class Mesh>
class Polyhedron {
 public:
  using size_type = std::size_t;
  using Point_3 = cgal::Point_3;
  using Point = Point_3;
  using Vertex = VertexOf<Mesh>;
  using Halfedge = HalfedgeOf<Mesh>;
  using Facet = FacetOf<Mesh>;
  using Face = Facet;
  using Vertex_handle = Vertex;
  using Halfedge_handle = Halfedge;
  using Facet_handle = Facet;
  using Face_handle = Facet;
  using Halfedge_around_vertex_circulator = VertexCirculator<Mesh>;
  using Halfedge_around_facet_circulator = FacetCirculator<Mesh>;
  using Vertex_iterator = ItemIterator<Mesh, Vertex, halfedge::Vertex>;
  using Halfedge_iterator = ItemIterator<Mesh, Halfedge, halfedge::Halfedge>;
  /// One halfedge of each edge, its side 0.
  using Edge_iterator = ItemIterator<Mesh, Halfedge, halfedge::Edge>;
  using Facet_iterator = ItemIterator<Mesh, Facet, halfedge::Face>;

  // Nothing can be changed through these names, so that the const forms are the same.
  using Vertex_const_handle = Vertex_handle;
  using Halfedge_const_handle = Halfedge_handle;
  using Facet_const_handle = Facet_handle;
  using Face_const_handle = Facet_handle;
  using Halfedge_around_vertex_const_circulator = Halfedge_around_vertex_circulator;
  using Halfedge_around_facet_const_circulator = Halfedge_around_facet_circulator;
  using Vertex_const_iterator = Vertex_iterator;
  using Halfedge_const_iterator = Halfedge_iterator;
  using Edge_const_iterator = Edge_iterator;
  using Facet_const_iterator = Facet_iterator;

  explicit Polyhedron(const Mesh& mesh) : mesh_(&mesh) {}
  Polyhedron(const Mesh&&) = delete;  // it would not outlive this

  /// Our handles under these names.
  [[nodiscard]] Vertex_handle operator()(halfedge::Vertex v) const { return {*mesh_, v}; }
  [[nodiscard]] Halfedge_handle operator()(halfedge::Halfedge h) const { return {*mesh_, h}; }
  [[nodiscard]] Facet_handle operator()(halfedge::Face f) const { return {*mesh_, f}; }

  [[nodiscard]] size_type size_of_vertices() const { return mesh_->vertex_count(); }
  [[nodiscard]] size_type size_of_halfedges() const { return mesh_->halfedge_count(); }
  [[nodiscard]] size_type size_of_facets() const { return mesh_->face_count(); }
  [[nodiscard]] size_type size_of_faces() const { return mesh_->face_count(); }
  /// Counted anew each time, O(halfedges); there is no need for normalize_border().
  [[nodiscard]] size_type size_of_border_halfedges() const {
    size_type count = 0;
    for (const halfedge::Halfedge h : mesh_->halfedges()) count += mesh_->is_boundary(h) ? 1U : 0U;
    return count;
  }
  /// An edge has a facet on at least one side.
  [[nodiscard]] size_type size_of_border_edges() const { return size_of_border_halfedges(); }

  [[nodiscard]] Vertex_iterator vertices_begin() const { return {*mesh_, 0}; }
  [[nodiscard]] Vertex_iterator vertices_end() const { return {*mesh_, mesh_->vertex_slots()}; }
  [[nodiscard]] Halfedge_iterator halfedges_begin() const { return {*mesh_, 0}; }
  [[nodiscard]] Halfedge_iterator halfedges_end() const {
    return {*mesh_, mesh_->halfedge_slots()};
  }
  [[nodiscard]] Edge_iterator edges_begin() const { return {*mesh_, 0}; }
  [[nodiscard]] Edge_iterator edges_end() const { return {*mesh_, mesh_->edge_slots()}; }
  [[nodiscard]] Facet_iterator facets_begin() const { return {*mesh_, 0}; }
  [[nodiscard]] Facet_iterator facets_end() const { return {*mesh_, mesh_->face_slots()}; }

  [[nodiscard]] bool is_closed() const { return size_of_border_halfedges() == 0; }
  [[nodiscard]] bool is_pure_triangle() const { return is_pure(3); }
  [[nodiscard]] bool is_pure_quad() const { return is_pure(4); }

 private:
  [[nodiscard]] bool is_pure(size_type degree) const {
    for (Facet_iterator f = facets_begin(); f != facets_end(); ++f) {
      if (f->facet_degree() != degree) return false;
    }
    return true;
  }

  const Mesh* mesh_;
};

}  // namespace HALFEDGE_CHECKS
}  // namespace halfedge::dialects::cgal
