#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstddef>
#include <string>

/// The structs of Max McGuire's article "The Half-Edge Data Structure" (2000), word for word, so
/// that its C programs, and others of that style, run on our meshes unchanged:
///
///   auto copied = mcguire::copy(mesh);
///   if (!copied) return fail(copied.error().message);
///   HE_vert* vert = copied.value().vert(v);
///   HE_edge* edge = vert->edge;
///   do {
///     // do something with edge, edge->pair or edge->face
///     edge = edge->pair->next;
///   } while (edge != vert->edge);
namespace halfedge::dialects::mcguire {

struct HE_edge;
struct HE_face;

struct HE_vert {
  float x;
  float y;
  float z;

  HE_edge* edge;  // one of the half-edges emanating from the vertex; null if there is none
};

struct HE_edge {
  HE_vert* vert;  // vertex at the end of the half-edge
  HE_edge* pair;  // oppositely oriented adjacent half-edge
  HE_face* face;  // face the half-edge borders; null on the boundary, which the article excludes
  HE_edge* next;  // next half-edge around the face, or around the boundary loop
};

struct HE_face {
  HE_edge* edge;  // one of the half-edges bordering the face
};

/// A mesh as these structs, which point at each other: a copy of what the mesh was when it was
/// made, free to be edited, that doesn't follow the mesh. It takes 32 bytes a halfedge, 24 a vertex
/// and 8 a face where pointers have 8 bytes: 232 bytes a vertex of a closed triangle mesh, beside
/// the 120 of the mesh itself. Moving it leaves all pointers good.
class HE_mesh {
 public:
  /// The structs of our items; of deleted ones the pointers are null.
  [[nodiscard]] HE_vert* vert(Vertex v) { return &verts_[v.index()]; }
  [[nodiscard]] HE_edge* edge(Halfedge h) { return &edges_[h.index()]; }
  [[nodiscard]] HE_face* face(Face f) { return &faces_[f.index()]; }
  [[nodiscard]] const HE_vert* vert(Vertex v) const { return &verts_[v.index()]; }
  [[nodiscard]] const HE_edge* edge(Halfedge h) const { return &edges_[h.index()]; }
  [[nodiscard]] const HE_face* face(Face f) const { return &faces_[f.index()]; }

  /// Our items of these structs; the empty item of null. pre: they are of this mesh
  [[nodiscard]] Vertex item(const HE_vert* vert) const { return Vertex(slot(vert, verts_)); }
  [[nodiscard]] Halfedge item(const HE_edge* edge) const { return Halfedge(slot(edge, edges_)); }
  [[nodiscard]] Face item(const HE_face* face) const { return Face(slot(face, faces_)); }

  [[nodiscard]] std::size_t bytes() const {
    return verts_.size() * sizeof(HE_vert) + edges_.size() * sizeof(HE_edge) +
           faces_.size() * sizeof(HE_face);
  }

 private:
  template <class M>
  friend Result<HE_mesh> copy(const M& mesh);

  template <class T>
  [[nodiscard]] static Index slot(const T* item, const Array<T>& items) {
    return item == nullptr ? kNone : static_cast<Index>(item - items.data());
  }

  Array<HE_vert> verts_;
  Array<HE_edge> edges_;
  Array<HE_face> faces_;
};

/// Copies a mesh into the structs, in one pass over its items. Vertices of a mesh without positions
/// lie at the origin. `prev` is neither needed nor copied.
///
/// Codes: out-of-memory.
template <class M>
[[nodiscard]] Result<HE_mesh> copy(const M& mesh) {
  HE_mesh copy;
  if (!copy.verts_.resize(mesh.vertex_slots(), HE_vert{}) ||
      !copy.edges_.resize(mesh.halfedge_slots(), HE_edge{}) ||
      !copy.faces_.resize(mesh.face_slots(), HE_face{})) {
    return Error{"out-of-memory", "A copy of " + std::to_string(mesh.halfedge_slots()) +
                                      " halfedges as structs does not fit in memory."};
  }
  for (const Vertex v : mesh.vertices()) {
    HE_vert& vert = *copy.vert(v);
    if constexpr (requires { mesh.position(v); }) {
      const Point p = mesh.position(v);
      vert = {p.x, p.y, p.z, nullptr};
    }
    const Halfedge anchor = mesh.vertex_halfedge(v);
    vert.edge = anchor.valid() ? copy.edge(anchor) : nullptr;
  }
  for (const Halfedge h : mesh.halfedges()) {
    const Face f = mesh.face(h);
    *copy.edge(h) = {copy.vert(mesh.to_vertex(h)), copy.edge(mesh.opposite(h)),
                     f.valid() ? copy.face(f) : nullptr, copy.edge(mesh.next(h))};
  }
  for (const Face f : mesh.faces()) copy.face(f)->edge = copy.edge(mesh.face_halfedge(f));
  return copy;
}

}  // namespace halfedge::dialects::mcguire
