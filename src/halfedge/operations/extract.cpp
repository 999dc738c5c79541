#include <halfedge/operations/extract.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace halfedge::extracting {

namespace {

Error out_of_memory() { return no_memory_for("a mesh of these faces"); }

Error corrupt() {
  return {"corrupt-connectivity",
          "The links around these faces break the invariants of a mesh: validate names them."};
}

// Where the items of a mesh are in the part, by slot; kNone for those that are left out, and for
// what is no slot.
class PartMap {
 public:
  [[nodiscard]] bool create(Index slots, const Array<Index>& kept) {
    if (!places_.resize(slots, kNone)) return false;
    for (Index i = 0; i < kept.size(); ++i) places_[kept[i]] = i;
    return true;
  }
  [[nodiscard]] Index operator[](Index slot) const {
    return slot < places_.size() ? places_[slot] : kNone;
  }

 private:
  Array<Index> places_;
};

class PartWriter {
 public:
  PartWriter(const RawLinks& mesh, const ItemSet& items, Links& part)
      : mesh_(mesh), items_(items), part_(part), steps_(mesh.halfedge_slots()) {}

  // False when memory is exhausted.
  [[nodiscard]] bool make_room(bool stores_prev) {
    const std::size_t halfedges = 2 * std::size_t{items_.edges.size()};
    return vertices_.create(mesh_.slots(Vertex{}), items_.vertices) &&
           edges_.create(mesh_.slots(Edge{}), items_.edges) &&
           faces_.create(mesh_.slots(Face{}), items_.faces) && part_.next.resize(halfedges) &&
           (!stores_prev || part_.prev.resize(halfedges, kNone)) &&
           part_.to_vertex.resize(halfedges) && part_.face.resize(halfedges) &&
           part_.vertex_halfedge.resize(items_.vertices.size(), kNone) &&
           part_.face_halfedge.resize(items_.faces.size());
  }

  // False if the links are corrupt.
  [[nodiscard]] bool write() {
    if (!write_halfedges() || !write_anchors()) return false;
    for (Index i = 0; i < part_.face_halfedge.size(); ++i) {
      // One of those around the face, whose edges are all kept.
      part_.face_halfedge[i] = halfedge(mesh_.stored_halfedge(Face(items_.faces[i])));
    }
    return true;
  }

 private:
  [[nodiscard]] Index halfedge(Halfedge h) const {
    const Index e = edges_[RawLinks::edge(h).index()];
    return e == kNone ? kNone : 2 * e + h.index() % 2;
  }

  // The halfedge after `h` in the part: beyond the edges that are left out, in the same gap.
  // Empty if the links are corrupt.
  [[nodiscard]] Index halfedge_after(Halfedge h) {
    Halfedge n = mesh_.next(h);
    while (mesh_.contain(n) && halfedge(n) == kNone) {
      if (steps_-- == 0) return kNone;  // each halfedge is passed once
      n = mesh_.rotate_cw(n);
    }
    return halfedge(n);
  }

  [[nodiscard]] bool write_halfedges() {
    for (Index i = 0; i < part_.next.size(); ++i) {
      const Halfedge h(2 * items_.edges[i / 2] + i % 2);
      const Index n = halfedge_after(h);
      const Index v = vertices_[mesh_.to_vertex(h).index()];
      if (n == kNone || v == kNone) return false;
      part_.next[i] = n;
      if (!part_.prev.empty()) part_.prev[n] = i;
      part_.to_vertex[i] = v;
      part_.face[i] = faces_[mesh_.face(h).index()];
    }
    return std::find(part_.prev.begin(), part_.prev.end(), kNone) == part_.prev.end();
  }

  [[nodiscard]] bool write_anchors() {
    Array<Index>& anchors = part_.vertex_halfedge;
    for (Index i = 0; i < anchors.size(); ++i) {
      anchors[i] = halfedge(mesh_.stored_halfedge(Vertex(items_.vertices[i])));
    }
    for (Index i = 0; i < part_.face.size(); ++i) {
      if (part_.face[i] != kNone) continue;
      Index& anchor = anchors[part_.to_vertex[i ^ 1U]];
      if (anchor == kNone || part_.face[anchor] != kNone) anchor = i;
    }
    return std::find(anchors.begin(), anchors.end(), kNone) == anchors.end();
  }

  const RawLinks& mesh_;
  const ItemSet& items_;
  Links& part_;
  Index steps_;
  PartMap vertices_;
  PartMap edges_;
  PartMap faces_;
};

}  // namespace

Result<ItemSet> copy_surface(const RawLinks& mesh, std::span<const float> positions,
                             std::span<const Index> faces, bool stores_prev, Links& links,
                             Array<float>& part_positions) {
  Result<ItemSet> closure = surroundings(mesh, Surroundings::kClosure, {.faces = faces});
  if (!closure) return closure;
  const ItemSet& items = closure.value();
  PartWriter writer(mesh, items, links);
  if (!writer.make_room(stores_prev) ||
      !part_positions.resize(3 * std::size_t{items.vertices.size()})) {
    return out_of_memory();
  }
  if (!writer.write()) return corrupt();
  for (std::size_t i = 0; i < items.vertices.size(); ++i) {
    const std::size_t v = items.vertices[i];
    for (std::size_t k = 0; k < 3; ++k) part_positions[3 * i + k] = positions[3 * v + k];
  }
  return closure;
}

void copy_values(const Attribute& from, const ItemSet& items, Attribute& to) {
  const ItemKind kind = from.kind();
  const std::span<const Index> kept = kind == ItemKind::kVertex ? items.vertices.span()
                                      : kind == ItemKind::kFace ? items.faces.span()
                                                                : items.edges.span();
  // Both sides of an edge lie side by side.
  const std::size_t size = from.stride() * (kind == ItemKind::kHalfedge ? 2 : 1);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    std::memcpy(to.bytes().data() + size * i, from.bytes().data() + size * kept[i], size);
  }
}

}  // namespace halfedge::extracting
