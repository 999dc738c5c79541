#pragma once

#include <halfedge/connectivity/connectivity.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/decorator/decorator.h>
#include <halfedge/dialects/cgal.h>
#include <halfedge/result.h>
#include <halfedge/validate/validate.h>

/// CGAL's HalfedgeDS and its decorator, for the program of its manual:
///
///   struct Traits { typedef int Point_2; };
///   typedef HalfedgeDS_default<Traits> HDS;
///   typedef HalfedgeDS_decorator<HDS> Decorator;
///   HDS hds;
///   Decorator decorator(hds);
///   decorator.create_loop();
///   assert(decorator.is_valid());
namespace halfedge::dialects::cgal {
inline namespace HALFEDGE_CHECKS {

/// A combinatorial structure: of the traits CGAL asks only for the type of points, and it has none.
template <class Traits>
using HalfedgeDS_default = Connectivity;

/// The operations of halfedge/decorator under CGAL's names, on any mesh of ours that they take. It
/// is a reference to the mesh. Where an operation can't be done (a precondition, in CGAL) it has
/// changed nothing and returns an empty handle, or false; our own function would say why.
template <class HDS>
class HalfedgeDS_decorator {
 public:
  using Halfedge_handle = HalfedgeOf<HDS>;

  explicit HalfedgeDS_decorator(HDS& hds) : hds_(&hds) {}

  /// One closed edge: two halfedges, one vertex, two faces.
  Halfedge_handle create_loop() { return handle(decorator::make_loop(*hds_)); }
  /// One open edge: two halfedges, two vertices, one face.
  Halfedge_handle create_segment() { return handle(decorator::make_segment(*hds_)); }

  Halfedge_handle split_face(Halfedge h, Halfedge g) {
    return handle(decorator::split_face(*hds_, h, g));
  }
  Halfedge_handle join_face(Halfedge h) { return handle(decorator::join_face(*hds_, h)); }
  Halfedge_handle split_vertex(Halfedge h, Halfedge g) {
    return handle(decorator::split_vertex(*hds_, h, g));
  }
  Halfedge_handle join_vertex(Halfedge h) { return handle(decorator::join_vertex(*hds_, h)); }
  Halfedge_handle create_center_vertex(Halfedge h) {
    return handle(decorator::create_center_vertex(*hds_, h));
  }
  Halfedge_handle erase_center_vertex(Halfedge h) {
    return handle(decorator::erase_center_vertex(*hds_, h));
  }
  Halfedge_handle split_loop(Halfedge h, Halfedge i, Halfedge j) {
    return handle(decorator::split_loop(*hds_, h, i, j));
  }
  Halfedge_handle join_loop(Halfedge h, Halfedge g) {
    return handle(decorator::join_loop(*hds_, h, g));
  }
  Halfedge_handle make_hole(Halfedge h) { return handle(decorator::make_hole(*hds_, h)); }
  Halfedge_handle fill_hole(Halfedge h) { return handle(decorator::fill_hole(*hds_, h)); }
  Halfedge_handle add_face_to_border(Halfedge h, Halfedge g) {
    return handle(decorator::add_face_to_boundary(*hds_, h, g));
  }
  Halfedge_handle flip_edge(Halfedge h) { return handle(decorator::flip_edge(*hds_, h)); }
  bool erase_face(Halfedge h) { return decorator::erase_face(*hds_, h).ok(); }
  bool inside_out() { return decorator::inside_out(*hds_).ok(); }
  bool normalize_border() { return decorator::normalize_boundary(*hds_).ok(); }

  /// At CGAL's levels. `verbose` is taken and not looked at: `validate` says what is wrong, in
  /// sentences.
  [[nodiscard]] bool is_valid([[maybe_unused]] bool verbose = false, int level = 0) const {
    return !has_errors(validate(*hds_, level));
  }

 private:
  [[nodiscard]] Halfedge_handle handle(const Result<Halfedge>& result) const {
    return result.ok() ? Halfedge_handle(*hds_, result.value()) : Halfedge_handle();
  }

  HDS* hds_;
};

}  // namespace HALFEDGE_CHECKS
}  // namespace halfedge::dialects::cgal
