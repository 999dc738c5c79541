#pragma once

#include <halfedge/mend/surface.h>
#include <halfedge/operations/operations.h>
#include <halfedge/validate/validate.h>

#include <span>
#include <vector>

namespace halfedge::mend {

/// Of problems at level 4.
[[nodiscard]] Result<void> first_error(const std::vector<Problem>& problems);

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

  Result<void> check_valid() const override { return first_error(validate(mesh_)); }

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
    return steps::make_room(mesh_, vertices, edges, faces);
  }
  void fill_hole(Halfedge h) override { (void)decorator::fill_hole(mesh_, h); }
  Halfedge split_face(Halfedge h, Halfedge g) override {
    return decorator::split_face(mesh_, h, g).value();
  }
  Vertex split_fan(Vertex v, Halfedge first, Halfedge end) override {
    if (!make_room(1, 0, 0)) return {};
    const Vertex copy = steps::copy_vertex(mesh_, v);
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
