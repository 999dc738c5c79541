#pragma once

// What operations write links with. See the declarations in BasicConnectivity.

#include <halfedge/connectivity/connectivity.h>

namespace halfedge {

template <Storage kStored>
class BasicConnectivity<kStored>::Writer {
 public:
  explicit Writer(BasicConnectivity& mesh) : mesh_(mesh) { ++mesh.version_; }

  void link(Halfedge h, Halfedge n) const {
    set_next(h, n);
    set_prev(n, h);
  }
  /// The halves of `link`.
  void set_next(Halfedge h, Halfedge n) const {
    write(Field::kNext, mesh_.links_.next, h.index(), n.index());
  }
  void set_prev([[maybe_unused]] Halfedge h, [[maybe_unused]] Halfedge p) const {
    if (mesh_.stores_prev()) {
      write(Field::kPrev, mesh_.links_.prev, h.index(), p.index());
    }
  }
  void set_to_vertex(Halfedge h, Vertex v) const {
    write(Field::kToVertex, mesh_.links_.to_vertex, h.index(), v.index());
  }
  /// Does nothing where faces aren't stored.
  void set_face([[maybe_unused]] Halfedge h, [[maybe_unused]] Face f) const {
    if constexpr (kStorage.face) {
      write(Field::kFace, mesh_.links_.face, h.index(), f.index());
    }
  }
  /// Does nothing where faces store no halfedge.
  void set_face_halfedge([[maybe_unused]] Face f, [[maybe_unused]] Halfedge h) const {
    if constexpr (kStorage.face_halfedge) {
      mesh_.write(Field::kFaceHalfedge, mesh_.links_.face_halfedge, f.index(), h.index());
    }
  }

 private:
  // As that of the mesh, but that no call is needed to find out that a halfedge is new.
  void write(Field field, Array<Index>& array, Index h, Index word) const {
    if (mesh_.journal_ != nullptr && array[h] != word && !mesh_.journal_->is_new_halfedge(h))
        [[unlikely]]
      mesh_.journal_->record_in_old_slots(field, h, {array[h]});
    array[h] = word;
  }

  BasicConnectivity& mesh_;
};

template <Storage kStored>
class BasicConnectivity<kStored>::UnnotedWriter {
 public:
  explicit UnnotedWriter(BasicConnectivity& mesh)
      : links_(mesh.links_), stores_prev_(mesh.stores_prev()) {}

  void link(Halfedge h, Halfedge n) const {
    set_next(h, n);
    set_prev(n, h);
  }
  void set_next(Halfedge h, Halfedge n) const { links_.next[h.index()] = n.index(); }
  void set_prev([[maybe_unused]] Halfedge h, [[maybe_unused]] Halfedge p) const {
    if (stores_prev_) links_.prev[h.index()] = p.index();
  }
  void set_to_vertex(Halfedge h, Vertex v) const { links_.to_vertex[h.index()] = v.index(); }
  void set_face([[maybe_unused]] Halfedge h, [[maybe_unused]] Face f) const {
    if constexpr (kStorage.face) links_.face[h.index()] = f.index();
  }
  void set_face_halfedge([[maybe_unused]] Face f, [[maybe_unused]] Halfedge h) const {
    if constexpr (kStorage.face_halfedge) links_.face_halfedge[f.index()] = h.index();
  }
  /// Does nothing where there are no anchors.
  void set_vertex_halfedge([[maybe_unused]] Vertex v, [[maybe_unused]] Halfedge h) const {
    if constexpr (kStorage.vertex_halfedge) links_.vertex_halfedge[v.index()] = h.index();
  }

 private:
  Links& links_;
  bool stores_prev_;
};

}  // namespace halfedge
