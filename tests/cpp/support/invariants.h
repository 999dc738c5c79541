#pragma once

#include <halfedge/mesh.h>

#include <algorithm>
#include <set>
#include <vector>

namespace halfedge::test {

/// The invariants of a polygon mesh, each written down as its definition says, in quadratic time
/// and without a thought for speed: what `validate` at level 4 is compared with. Those of a
/// complex, which may be degenerate, are what it checks at level 3.
class Invariants {
 public:
  explicit Invariants(const Mesh& mesh) : mesh_(mesh), links_(mesh.links()) {}

  [[nodiscard]] bool hold() const {
    return arrays_fit() && free_lists_fit() && references_are_live() &&
           next_and_prev_are_inverse() && vertices_hold() && faces_hold() && edges_hold();
  }
  [[nodiscard]] bool hold_for_complex() {
    of_polygons_ = false;
    const bool all_hold = hold();
    of_polygons_ = true;
    return all_hold;
  }

 private:
  [[nodiscard]] bool arrays_fit() const {
    const std::size_t size = links_.next.size();
    return size % 2 == 0 && links_.prev.size() == size && links_.to_vertex.size() == size &&
           links_.face.size() == size &&
           mesh_.positions().size() == 3 * links_.vertex_halfedge.size();
  }

  [[nodiscard]] static bool fits(const FreeList& list, const std::vector<Index>& links) {
    std::set<Index> deleted;
    for (Index slot = 0; slot < links.size(); ++slot) {
      if (is_deleted_link(links[slot])) deleted.insert(slot);
    }
    if (deleted.size() != list.count) return false;
    Index slot = list.head;
    while (deleted.erase(slot) == 1) slot = next_free_slot(links[slot]);
    return deleted.empty() && slot == kNone;
  }

  [[nodiscard]] bool free_lists_fit() const {
    std::vector<Index> next_of_side_0;
    for (std::size_t h = 0; h < links_.next.size(); h += 2)
      next_of_side_0.push_back(links_.next[h]);
    const Array<Index>& anchors = links_.vertex_halfedge;
    const Array<Index>& firsts = links_.face_halfedge;
    return fits(mesh_.free_vertices(), {anchors.begin(), anchors.end()}) &&
           fits(mesh_.free_edges(), next_of_side_0) &&
           fits(mesh_.free_faces(), {firsts.begin(), firsts.end()});
  }

  [[nodiscard]] bool references_are_live() const {
    for (Index h = 0; h < links_.next.size(); ++h) {
      const bool deleted = is_deleted_link(links_.next[h & ~Index{1}]);
      for (const Array<Index>* links :
           {&links_.next, &links_.prev, &links_.to_vertex, &links_.face}) {
        if (is_deleted_link((*links)[h]) != deleted) return false;
      }
      if (deleted) continue;
      const Halfedge halfedge(h);
      if (!mesh_.is_live(mesh_.next(halfedge)) || !mesh_.is_live(mesh_.prev(halfedge)) ||
          !mesh_.is_live(mesh_.to_vertex(halfedge)) ||
          (links_.face[h] != kNone && !mesh_.is_live(mesh_.face(halfedge)))) {
        return false;
      }
    }
    for (const Vertex v : mesh_.vertices()) {
      if (!mesh_.is_isolated(v) && !mesh_.is_live(mesh_.vertex_halfedge(v))) return false;
    }
    for (const Face f : mesh_.faces()) {
      if (!mesh_.is_live(mesh_.face_halfedge(f))) return false;
    }
    return true;
  }

  [[nodiscard]] bool next_and_prev_are_inverse() const {
    for (const Halfedge h : mesh_.halfedges()) {
      const Halfedge n = mesh_.next(h);
      if (mesh_.prev(n) != h || mesh_.next(mesh_.prev(h)) != h) return false;
      if (mesh_.from_vertex(n) != mesh_.to_vertex(h) || mesh_.face(n) != mesh_.face(h))
        return false;
    }
    return true;
  }

  [[nodiscard]] bool vertices_hold() const {
    for (const Vertex v : mesh_.vertices()) {
      std::set<Halfedge> leaving;
      bool on_boundary = false;
      for (const Halfedge h : mesh_.halfedges()) {
        if (mesh_.from_vertex(h) != v) continue;
        leaving.insert(h);
        on_boundary = on_boundary || mesh_.is_boundary(h);
      }
      if (leaving.empty() != mesh_.is_isolated(v)) return false;
      std::set<Vertex> ring;
      const Halfedge anchor = mesh_.vertex_halfedge(v);
      for (Halfedge h = anchor; leaving.erase(h) == 1; h = mesh_.rotate_cw(h)) {
        const bool is_first = ring.insert(mesh_.to_vertex(h)).second;
        if (of_polygons_ && !is_first) return false;  // a duplicate halfedge
      }
      if (!leaving.empty()) return false;
      if (anchor.valid() && mesh_.from_vertex(anchor) != v) return false;
      if (on_boundary && !mesh_.is_boundary(anchor)) return false;
    }
    return true;
  }

  [[nodiscard]] bool faces_hold() const {
    for (const Face f : mesh_.faces()) {
      std::set<Halfedge> in_face;
      std::set<Vertex> corners;
      for (const Halfedge h : mesh_.halfedges()) {
        if (mesh_.face(h) != f) continue;
        in_face.insert(h);
        const bool is_first = corners.insert(mesh_.to_vertex(h)).second;
        if (of_polygons_ && !is_first) return false;
      }
      if (of_polygons_ && corners.size() < 3) return false;
      for (Halfedge h = mesh_.face_halfedge(f); in_face.erase(h) == 1;) h = mesh_.next(h);
      if (!in_face.empty()) return false;
      if (mesh_.face(mesh_.face_halfedge(f)) != f) return false;
    }
    return true;
  }

  [[nodiscard]] bool edges_hold() const {
    for (const Edge e : mesh_.edges()) {
      const Face f = mesh_.face(mesh_.edge_halfedge(e, 0));
      const bool is_same = f == mesh_.face(mesh_.edge_halfedge(e, 1));
      if (is_same && (of_polygons_ || !f.valid())) return false;
    }
    return true;
  }

  const Mesh& mesh_;
  const Links& links_;
  bool of_polygons_ = true;
};

}  // namespace halfedge::test
