#pragma once

#include <halfedge/algorithms/topology.h>
#include <halfedge/connectivity/links.h>
#include <halfedge/connectivity/links_view.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <span>

namespace halfedge::mend {

/// The links and positions of a mesh, to be read, whatever else it stores.
class SurfaceView : public LinksView {
 public:
  SurfaceView(const Links& links, const Array<float>& positions)
      : LinksView(links), positions_(positions) {}

  [[nodiscard]] std::span<const float> positions() const { return positions_.span(); }
  [[nodiscard]] Point position(Vertex v) const {
    const float* p = &positions_[3 * std::size_t{v.index()}];
    return {p[0], p[1], p[2]};
  }

 private:
  const Array<float>& positions_;
};

/// A mesh while it is mended, whatever it stores: so the repairs are compiled once. What they read
/// are the links, which stay where they are; what they change goes through the operations, and so
/// into history. Where a function has the name of an operation it is that operation.
class Surface : public SurfaceView {
 public:
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  // ---- reading ------------------------------------------------------------------------------

  [[nodiscard]] virtual Halfedge prev(Halfedge h) const = 0;
  [[nodiscard]] virtual Result<Components> components() const = 0;
  [[nodiscard]] virtual Result<Array<Halfedge>> boundary_loops() const = 0;

  /// Whether it is valid at level 4: else corrupt-connectivity, with what is wrong first; or
  /// out-of-memory. Bytes that were tampered with may be read as a mesh that is not, and that an
  /// operation makes worse.
  [[nodiscard]] virtual Result<void> check_valid() const = 0;

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
  using SurfaceView::SurfaceView;
  ~Surface() = default;
};

}  // namespace halfedge::mend
