#pragma once

#include <halfedge/algorithms/topology.h>
#include <halfedge/operations/operations.h>
#include <halfedge/result.h>

#include <span>

namespace halfedge::mend {

/// A mesh while it is mended, whatever it stores: so the repairs are compiled once. What they read
/// are the links, which stay where they are; what they change goes through the operations, and so
/// into history. Where a function has the name of an operation it is that operation.
class Surface {
 public:
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  // ---- reading ------------------------------------------------------------------------------

  [[nodiscard]] const Links& links() const { return links_; }
  [[nodiscard]] std::span<const float> positions() const { return positions_.span(); }

  [[nodiscard]] Index vertex_slots() const { return Index(links_.vertex_halfedge.size()); }
  [[nodiscard]] Index halfedge_slots() const { return Index(links_.next.size()); }
  [[nodiscard]] Index edge_slots() const { return halfedge_slots() / 2; }
  [[nodiscard]] Index face_slots() const { return Index(links_.face_halfedge.size()); }
  [[nodiscard]] bool is_live(Vertex v) const {
    return !is_deleted_link(links_.vertex_halfedge[v.index()]);
  }
  [[nodiscard]] bool is_live(Halfedge h) const { return !is_deleted_link(links_.next[h.index()]); }
  [[nodiscard]] bool is_live(Edge e) const { return is_live(Halfedge(2 * e.index())); }
  [[nodiscard]] bool is_live(Face f) const {
    return !is_deleted_link(links_.face_halfedge[f.index()]);
  }

  [[nodiscard]] Halfedge next(Halfedge h) const { return Halfedge(links_.next[h.index()]); }
  [[nodiscard]] static Halfedge opposite(Halfedge h) { return Halfedge(h.index() ^ 1U); }
  [[nodiscard]] static Edge edge(Halfedge h) { return Edge(h.index() / 2); }
  [[nodiscard]] Vertex to_vertex(Halfedge h) const { return Vertex(links_.to_vertex[h.index()]); }
  [[nodiscard]] Vertex from_vertex(Halfedge h) const { return to_vertex(opposite(h)); }
  [[nodiscard]] Face face(Halfedge h) const { return Face(links_.face[h.index()]); }
  [[nodiscard]] Halfedge halfedge(Vertex v) const {
    return Halfedge(links_.vertex_halfedge[v.index()]);
  }
  [[nodiscard]] Halfedge halfedge(Face f) const {
    return Halfedge(links_.face_halfedge[f.index()]);
  }
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return next(opposite(h)); }
  /// pre: live
  [[nodiscard]] bool is_boundary(Halfedge h) const { return !face(h).valid(); }
  [[nodiscard]] bool is_boundary(Vertex v) const {
    return !halfedge(v).valid() || is_boundary(halfedge(v));
  }
  [[nodiscard]] Point position(Vertex v) const {
    const float* p = &positions_[3 * std::size_t{v.index()}];
    return {p[0], p[1], p[2]};
  }

  [[nodiscard]] virtual Halfedge prev(Halfedge h) const = 0;
  [[nodiscard]] virtual Result<Components> components() const = 0;
  [[nodiscard]] virtual Result<Array<Halfedge>> boundary_loops() const = 0;

  // ---- operations -----------------------------------------------------------------------------

  [[nodiscard]] virtual Result<void> check_glue(Halfedge h, Halfedge g) const = 0;
  [[nodiscard]] virtual Result<Edge> glue_path(Halfedge h, Halfedge g, std::size_t n) = 0;
  [[nodiscard]] virtual Result<Vertex> collapse(Halfedge h) = 0;
  [[nodiscard]] virtual Result<Edge> flip_edge(Edge e) = 0;
  [[nodiscard]] virtual Result<Face> remove_edge(Edge e) = 0;
  [[nodiscard]] virtual Result<Index> triangulate(Face f) = 0;
  virtual void delete_face(Face f) = 0;

  // ---- steps of which repairs consist ---------------------------------------------------------

  /// As operations have it: so many items can be made then. False when memory is exhausted.
  [[nodiscard]] virtual bool make_room(Index vertices, Index edges, Index faces) = 0;
  /// A face on the boundary loop of `h`. pre: room for it; level 4 allows it
  virtual void fill_hole(Halfedge h) = 0;
  /// As decorator::split_face. pre: room for it; level 4 allows it
  virtual Halfedge split_face(Halfedge h, Halfedge g) = 0;
  /// The fan of faces at `v` from the boundary halfedge `first`, which leaves it, to `end`, which
  /// arrives, gets a copy of `v`. Other fans are the caller's to link. Empty when memory is
  /// exhausted.
  [[nodiscard]] virtual Vertex split_fan(Vertex v, Halfedge first, Halfedge end) = 0;
  virtual void link(Halfedge h, Halfedge n) = 0;
  virtual void set_anchor(Vertex v, Halfedge h) = 0;
  /// Turns over whole components, of which these are the edges. False when memory is exhausted.
  [[nodiscard]] virtual bool reverse(std::span<const Edge> edges) = 0;
  /// Gives the slots back; what refers to them is the caller's.
  virtual void release(Vertex v) = 0;
  virtual void release(Edge e) = 0;
  virtual void release(Face f) = 0;

 protected:
  Surface(const Links& links, const Array<float>& positions)
      : links_(links), positions_(positions) {}
  ~Surface() = default;

 private:
  const Links& links_;
  const Array<float>& positions_;
};

/// The surface of a mesh.
template <Storage kStored>
class SurfaceOf final : public Surface {
 public:
  using Mesh = BasicMesh<kStored>;

  explicit SurfaceOf(Mesh& mesh) : Surface(mesh.links(), mesh.mutable_positions()), mesh_(mesh) {}

  Halfedge prev(Halfedge h) const override { return mesh_.prev(h); }
  Result<Components> components() const override { return connected_components(mesh_); }
  Result<Array<Halfedge>> boundary_loops() const override {
    return halfedge::boundary_loops(mesh_);
  }

  Result<void> check_glue(Halfedge h, Halfedge g) const override {
    return operations::check_glue(mesh_, h, g);
  }
  Result<Edge> glue_path(Halfedge h, Halfedge g, std::size_t n) override {
    return n == 1 ? operations::glue(mesh_, h, g) : operations::glue_path(mesh_, h, g, n);
  }
  Result<Vertex> collapse(Halfedge h) override { return operations::collapse(mesh_, h); }
  Result<Edge> flip_edge(Edge e) override { return operations::flip_edge(mesh_, e); }
  Result<Face> remove_edge(Edge e) override { return operations::remove_edge(mesh_, e); }
  Result<Index> triangulate(Face f) override { return operations::triangulate(mesh_, f); }
  void delete_face(Face f) override { (void)operations::delete_face(mesh_, f); }

  bool make_room(Index vertices, Index edges, Index faces) override {
    return decorator::internal::make_room(mesh_, vertices, edges, faces);
  }
  void fill_hole(Halfedge h) override { (void)decorator::fill_hole(mesh_, h); }
  Halfedge split_face(Halfedge h, Halfedge g) override {
    return decorator::split_face(mesh_, h, g).value();
  }
  Vertex split_fan(Vertex v, Halfedge first, Halfedge end) override {
    if (!make_room(1, 0, 0)) return {};
    const Vertex copy = decorator::internal::copy_vertex(mesh_, v);
    for (Halfedge in = Mesh::opposite(first);; in = mesh_.next_on_vertex(in)) {
      mesh_.set_to_vertex(in, copy);
      if (in == end) break;
    }
    mesh_.link(end, first);
    mesh_.set_vertex_halfedge(copy, first);
    return copy;
  }
  void link(Halfedge h, Halfedge n) override { mesh_.link(h, n); }
  void set_anchor(Vertex v, Halfedge h) override { mesh_.set_vertex_halfedge(v, h); }
  bool reverse(std::span<const Edge> edges) override {
    Array<bool> seen;
    if (!seen.resize(mesh_.halfedge_slots(), false)) return false;
    operations::internal::reverse_edges(mesh_, edges, seen);
    return true;
  }
  void release(Vertex v) override { mesh_.release(v); }
  void release(Edge e) override { mesh_.release(e); }
  void release(Face f) override { mesh_.release(f); }

 private:
  Mesh& mesh_;
};

}  // namespace halfedge::mend
