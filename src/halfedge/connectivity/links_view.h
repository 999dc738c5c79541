#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/links.h>

namespace halfedge {

/// The links of a mesh that stores all but prev, to be read, whatever else it stores: one type for
/// all of them, so that what is written for it is compiled once.
class LinksView {
 public:
  explicit LinksView(const Links& links) : links_(links) {}

  [[nodiscard]] const Links& links() const { return links_; }

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
  [[nodiscard]] Halfedge next_on_vertex(Halfedge h) const { return opposite(next(h)); }
  /// pre: live
  [[nodiscard]] bool is_boundary(Halfedge h) const { return !face(h).valid(); }
  [[nodiscard]] bool is_boundary(Vertex v) const {
    return !halfedge(v).valid() || is_boundary(halfedge(v));
  }

 private:
  const Links& links_;
};

}  // namespace halfedge
