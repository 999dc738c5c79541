#pragma once

#include <halfedge/connectivity/circulators.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/dialects/openmesh_iterators.h>
#include <halfedge/dialects/openmesh_points.h>
#include <halfedge/mesh.h>

#include <type_traits>

/// Our meshes under OpenMesh's names, for programs and people that come from there:
///
///   using MyMesh = halfedge::dialects::openmesh::PolyMesh<halfedge::Mesh>;
///   MyMesh mesh(ours);
///   for (MyMesh::VertexVertexIter vv = mesh.vv_iter(v); vv.is_valid(); ++vv) use(*vv);
///
/// The orders, starts and default directions are OpenMesh 9's, and compared with it by the tests:
/// around a vertex clockwise, around a face counter-clockwise, and `cw` and `ccw` ranges are the
/// reverse of each other. Where OpenMesh 9 reads out of bounds, around an isolated vertex, ranges
/// are empty. Not here: adding faces, properties and smart handles; our own API has its own way.
namespace halfedge::dialects::openmesh {
inline namespace HALFEDGE_CHECKS {

/// One mesh of ours (`Mesh`, any of its storage variants, a `Connectivity`, ...; const or not) with
/// OpenMesh's functions. It is a reference: nothing is stored or copied, and both names can be used
/// at the same time.
template <class M>
class PolyMesh {
  using Ours = std::remove_const_t<M>;

 public:
  using VertexHandle = openmesh::VertexHandle;
  using HalfedgeHandle = openmesh::HalfedgeHandle;
  using EdgeHandle = openmesh::EdgeHandle;
  using FaceHandle = openmesh::FaceHandle;
  using Scalar = float;
  using Point = openmesh::Vec3f;
  static constexpr VertexHandle InvalidVertexHandle{};
  static constexpr HalfedgeHandle InvalidHalfedgeHandle{};
  static constexpr EdgeHandle InvalidEdgeHandle{};
  static constexpr FaceHandle InvalidFaceHandle{};

  explicit PolyMesh(M& mesh) : mesh_(&mesh) {}
  explicit PolyMesh(const M&& mesh) = delete;  // it would be gone

  // ---- counts and items ---------------------------------------------------------------------

  /// Slots, deleted ones included, as in OpenMesh before garbage_collection().
  [[nodiscard]] std::size_t n_vertices() const { return mesh_->vertex_slots(); }
  [[nodiscard]] std::size_t n_halfedges() const { return mesh_->halfedge_slots(); }
  [[nodiscard]] std::size_t n_edges() const { return mesh_->edge_slots(); }
  [[nodiscard]] std::size_t n_faces() const { return mesh_->face_slots(); }

  [[nodiscard]] static VertexHandle vertex_handle(unsigned i) { return Vertex(i); }
  [[nodiscard]] static HalfedgeHandle halfedge_handle(unsigned i) { return Halfedge(i); }
  [[nodiscard]] static EdgeHandle edge_handle(unsigned i) { return Edge(i); }
  [[nodiscard]] static FaceHandle face_handle(unsigned i) { return Face(i); }
  /// False also of a deleted item, which OpenMesh takes for valid before garbage_collection().
  template <class Item>
  [[nodiscard]] bool is_valid_handle(NamedHandle<Item> handle) const {
    return mesh_->is_live(static_cast<Item>(handle));
  }

  // ---- links (1)-(7) --------------------------------------------------------------------------

  [[nodiscard]] HalfedgeHandle halfedge_handle(VertexHandle v) const {
    return mesh_->vertex_halfedge(v);
  }
  [[nodiscard]] HalfedgeHandle halfedge_handle(FaceHandle f) const {
    return mesh_->face_halfedge(f);
  }
  [[nodiscard]] HalfedgeHandle halfedge_handle(EdgeHandle e, unsigned side) const {
    return mesh_->edge_halfedge(e, side);
  }
  [[nodiscard]] VertexHandle to_vertex_handle(HalfedgeHandle h) const {
    return mesh_->to_vertex(h);
  }
  [[nodiscard]] VertexHandle from_vertex_handle(HalfedgeHandle h) const {
    return mesh_->from_vertex(h);
  }
  [[nodiscard]] FaceHandle face_handle(HalfedgeHandle h) const { return mesh_->face(h); }
  [[nodiscard]] FaceHandle opposite_face_handle(HalfedgeHandle h) const {
    return mesh_->face(mesh_->opposite(h));
  }
  [[nodiscard]] EdgeHandle edge_handle(HalfedgeHandle h) const { return mesh_->edge(h); }
  [[nodiscard]] HalfedgeHandle next_halfedge_handle(HalfedgeHandle h) const {
    return mesh_->next(h);
  }
  [[nodiscard]] HalfedgeHandle prev_halfedge_handle(HalfedgeHandle h) const {
    return mesh_->prev(h);
  }
  [[nodiscard]] HalfedgeHandle opposite_halfedge_handle(HalfedgeHandle h) const {
    return mesh_->opposite(h);
  }
  [[nodiscard]] HalfedgeHandle cw_rotated_halfedge_handle(HalfedgeHandle h) const {
    return mesh_->rotate_cw(h);
  }
  [[nodiscard]] HalfedgeHandle ccw_rotated_halfedge_handle(HalfedgeHandle h) const {
    return mesh_->rotate_ccw(h);
  }

  // ---- queries ----------------------------------------------------------------------------------

  [[nodiscard]] bool is_boundary(HalfedgeHandle h) const { return mesh_->is_boundary(Halfedge(h)); }
  [[nodiscard]] bool is_boundary(EdgeHandle e) const { return mesh_->is_boundary(Edge(e)); }
  [[nodiscard]] bool is_boundary(VertexHandle v) const { return mesh_->is_boundary(Vertex(v)); }
  /// With `check_vertex` a face that touches the boundary with a corner counts as well.
  [[nodiscard]] bool is_boundary(FaceHandle f, bool check_vertex = false) const {
    if (mesh_->is_boundary(Face(f))) return true;
    if (!check_vertex) return false;
    for (const Vertex v : mesh_->face_vertices_ccw(f)) {
      if (mesh_->is_boundary(v)) return true;
    }
    return false;
  }
  [[nodiscard]] bool is_isolated(VertexHandle v) const { return mesh_->is_isolated(v); }
  [[nodiscard]] bool is_manifold(VertexHandle v) const { return mesh_->is_manifold(v); }
  [[nodiscard]] unsigned valence(VertexHandle v) const { return mesh_->valence(v); }
  [[nodiscard]] unsigned valence(FaceHandle f) const { return mesh_->degree(f); }
  [[nodiscard]] HalfedgeHandle find_halfedge(VertexHandle a, VertexHandle b) const {
    return mesh_->find_halfedge(a, b);
  }
  [[nodiscard]] Point point(VertexHandle v) const { return mesh_->position(v); }

  // ---- low-level changes: after them, adjust_outgoing_halfedge() where boundaries moved -------

  void set_point(VertexHandle v, Point p) { mesh_->set_position(v, p); }
  [[nodiscard]] VertexHandle new_vertex() { return mesh_->new_vertex(); }
  [[nodiscard]] HalfedgeHandle new_edge(VertexHandle from, VertexHandle to) {
    return mesh_->new_edge(from, to);
  }
  /// A face that still needs its halfedge.
  [[nodiscard]] FaceHandle new_face() { return mesh_->new_face(Halfedge()); }
  void set_halfedge_handle(VertexHandle v, HalfedgeHandle h) { mesh_->set_vertex_halfedge(v, h); }
  void set_halfedge_handle(FaceHandle f, HalfedgeHandle h) { mesh_->set_face_halfedge(f, h); }
  void set_vertex_handle(HalfedgeHandle h, VertexHandle v) { mesh_->set_to_vertex(h, v); }
  void set_face_handle(HalfedgeHandle h, FaceHandle f) { mesh_->set_face(h, f); }
  void set_boundary(HalfedgeHandle h) { mesh_->set_face(h, Face()); }
  void set_isolated(VertexHandle v) { mesh_->set_vertex_halfedge(v, Halfedge()); }
  /// Sets the link back as well.
  void set_next_halfedge_handle(HalfedgeHandle h, HalfedgeHandle next) { mesh_->link(h, next); }
  /// The outgoing halfedge of a boundary vertex becomes a boundary halfedge.
  void adjust_outgoing_halfedge(VertexHandle v) { mesh_->adjust_anchor(v); }

  // ---- circulators --------------------------------------------------------------------------
  // For each kind xx: xx_iter(item), xx_begin(item), xx_end(item), xx_range(item), and the same
  // with `cw` and `ccw`: xx_cwiter, xx_cwbegin, xx_cwend, xx_cw_range. The const forms, cxx_iter
  // and so on, are the same, since no circulator changes the mesh.

#define HALFEDGE_OPENMESH_FORM(Iter, Center, iter, first, last, range)            \
  [[nodiscard]] Iter iter(Center item) const { return begin_of<Iter>(item); }     \
  [[nodiscard]] Iter c##iter(Center item) const { return begin_of<Iter>(item); }  \
  [[nodiscard]] Iter first(Center item) const { return begin_of<Iter>(item); }    \
  [[nodiscard]] Iter c##first(Center item) const { return begin_of<Iter>(item); } \
  [[nodiscard]] Iter last(Center item) const { return end_of<Iter>(item); }       \
  [[nodiscard]] Iter c##last(Center item) const { return end_of<Iter>(item); }    \
  [[nodiscard]] IterRange<Iter> range(Center item) const { return range_of<Iter>(item); }

#define HALFEDGE_OPENMESH_CIRCULATOR(xx, Kind, Center, DefaultWalk, CwWalk, CcwWalk, Shown) \
  using Kind##Iter = LapIter<Ours, walk::DefaultWalk, view::Shown>;                         \
  using Kind##CWIter = LapIter<Ours, walk::CwWalk, view::Shown>;                            \
  using Kind##CCWIter = LapIter<Ours, walk::CcwWalk, view::Shown>;                          \
  using Const##Kind##Iter = Kind##Iter;                                                     \
  using Const##Kind##CWIter = Kind##CWIter;                                                 \
  using Const##Kind##CCWIter = Kind##CCWIter;                                               \
  HALFEDGE_OPENMESH_FORM(Kind##Iter, Center, xx##_iter, xx##_begin, xx##_end, xx##_range)   \
  HALFEDGE_OPENMESH_FORM(Kind##CWIter, Center, xx##_cwiter, xx##_cwbegin, xx##_cwend,       \
                         xx##_cw_range)                                                     \
  HALFEDGE_OPENMESH_FORM(Kind##CCWIter, Center, xx##_ccwiter, xx##_ccwbegin, xx##_ccwend,   \
                         xx##_ccw_range)

  // clang-format off
  HALFEDGE_OPENMESH_CIRCULATOR(vv, VertexVertex, VertexHandle, RotateCw, RotateCw, RotateCcw, ToVertex)
  HALFEDGE_OPENMESH_CIRCULATOR(voh, VertexOHalfedge, VertexHandle, RotateCw, RotateCw, RotateCcw, Self)
  HALFEDGE_OPENMESH_CIRCULATOR(vih, VertexIHalfedge, VertexHandle, RotateCw, RotateCw, RotateCcw, Opposite)
  HALFEDGE_OPENMESH_CIRCULATOR(ve, VertexEdge, VertexHandle, RotateCw, RotateCw, RotateCcw, ItsEdge)
  HALFEDGE_OPENMESH_CIRCULATOR(vf, VertexFace, VertexHandle, RotateCw, RotateCw, RotateCcw, ItsFace)
  HALFEDGE_OPENMESH_CIRCULATOR(fv, FaceVertex, FaceHandle, LoopCcw, LoopCw, LoopCcw, ToVertex)
  HALFEDGE_OPENMESH_CIRCULATOR(fh, FaceHalfedge, FaceHandle, LoopCcw, LoopCw, LoopCcw, Self)
  HALFEDGE_OPENMESH_CIRCULATOR(fe, FaceEdge, FaceHandle, LoopCcw, LoopCw, LoopCcw, ItsEdge)
  HALFEDGE_OPENMESH_CIRCULATOR(ff, FaceFace, FaceHandle, LoopCcw, LoopCw, LoopCcw, OppositeFace)
  HALFEDGE_OPENMESH_CIRCULATOR(hl, HalfedgeLoop, HalfedgeHandle, LoopCcw, LoopCw, LoopCcw, Self)
  // clang-format on

#undef HALFEDGE_OPENMESH_CIRCULATOR
#undef HALFEDGE_OPENMESH_FORM

  /// The lap that begins at an outgoing halfedge, the one that begins at an incoming halfedge.
  [[nodiscard]] auto voh_range(HalfedgeHandle h) const { return lap<VertexOHalfedgeIter>(h); }
  [[nodiscard]] auto voh_cw_range(HalfedgeHandle h) const { return lap<VertexOHalfedgeCWIter>(h); }
  [[nodiscard]] auto voh_ccw_range(HalfedgeHandle h) const {
    return lap<VertexOHalfedgeCCWIter>(h);
  }
  [[nodiscard]] auto vih_range(HalfedgeHandle h) const {
    return lap<VertexIHalfedgeIter>(mesh_->opposite(h));
  }
  [[nodiscard]] auto vih_cw_range(HalfedgeHandle h) const {
    return lap<VertexIHalfedgeCWIter>(mesh_->opposite(h));
  }
  [[nodiscard]] auto vih_ccw_range(HalfedgeHandle h) const {
    return lap<VertexIHalfedgeCCWIter>(mesh_->opposite(h));
  }

  // ---- linear iterators: live items only --------------------------------------------------------

#define HALFEDGE_OPENMESH_ITEMS(items, Kind)                              \
  using Kind##Iter = ItemIter<Ours, halfedge::Kind>;                      \
  using Const##Kind##Iter = Kind##Iter;                                   \
  [[nodiscard]] Kind##Iter items##_begin() const { return {*mesh_, 0}; }  \
  [[nodiscard]] Kind##Iter items##_sbegin() const { return {*mesh_, 0}; } \
  [[nodiscard]] Kind##Iter items##_end() const {                          \
    return {*mesh_, mesh_->slots(halfedge::Kind())};                      \
  }                                                                       \
  [[nodiscard]] IterRange<Kind##Iter> items() const { return {items##_begin(), items##_end()}; }

  HALFEDGE_OPENMESH_ITEMS(vertices, Vertex)
  HALFEDGE_OPENMESH_ITEMS(halfedges, Halfedge)
  HALFEDGE_OPENMESH_ITEMS(edges, Edge)
  HALFEDGE_OPENMESH_ITEMS(faces, Face)

#undef HALFEDGE_OPENMESH_ITEMS

 private:
  // Where a lap begins: as our circulators, so that cw and ccw are the reverse of each other.
  template <class Walk>
  [[nodiscard]] Halfedge first_of(VertexHandle v) const {
    const Halfedge anchor = mesh_->vertex_halfedge(v);
    if constexpr (std::is_same_v<Walk, walk::RotateCw>) return anchor;
    return anchor.valid() ? mesh_->rotate_ccw(anchor) : anchor;
  }
  template <class Walk>
  [[nodiscard]] Halfedge first_of(FaceHandle f) const {
    const Halfedge first = mesh_->face_halfedge(f);
    if constexpr (std::is_same_v<Walk, walk::LoopCcw>) return first;
    return mesh_->prev(first);
  }
  template <class Walk>
  [[nodiscard]] Halfedge first_of(HalfedgeHandle h) const {
    return h;
  }

  template <class Iter>
  [[nodiscard]] Iter begin_of(auto item) const {
    return {*mesh_, first_of<typename Iter::Walk>(item)};
  }
  template <class Iter>
  [[nodiscard]] Iter end_of(auto item) const {
    return {*mesh_, first_of<typename Iter::Walk>(item), true};
  }
  template <class Iter>
  [[nodiscard]] IterRange<Iter> range_of(auto item) const {
    return lap<Iter>(first_of<typename Iter::Walk>(item));
  }
  template <class Iter>
  [[nodiscard]] IterRange<Iter> lap(Halfedge first) const {
    return {{*mesh_, first}, {*mesh_, first, true}};
  }

  M* mesh_;
};

}  // namespace HALFEDGE_CHECKS
}  // namespace halfedge::dialects::openmesh
