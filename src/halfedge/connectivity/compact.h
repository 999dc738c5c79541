#pragma once

#include <halfedge/connectivity/connectivity.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstddef>

namespace halfedge {

/// Where `compact`, `reorder` and `append` moved items to, by old slot; kNone for slots that were
/// deleted.
struct CompactMaps {
  Array<Index> vertices;
  Array<Index> edges;
  Array<Index> faces;

  /// Where an item went; empty for one that was deleted, and for an empty handle, as the face of a
  /// boundary halfedge.
  [[nodiscard]] Vertex operator()(Vertex old) const {
    return old.valid() ? Vertex(vertices[old.index()]) : old;
  }
  [[nodiscard]] Edge operator()(Edge old) const {
    return old.valid() ? Edge(edges[old.index()]) : old;
  }
  [[nodiscard]] Face operator()(Face old) const {
    return old.valid() ? Face(faces[old.index()]) : old;
  }
  /// Sides keep theirs: the halfedge on side 0 of an edge is on side 0 of where the edge went.
  [[nodiscard]] Halfedge operator()(Halfedge old) const {
    if (!old.valid()) return old;
    const Index e = edges[old.index() >> 1U];
    return e == kNone ? Halfedge{} : Halfedge(2 * e + (old.index() & 1U));
  }
};

/// Where the links to items of one kind lead afterwards, by where the items went. Those that lead
/// out of the arrays, as an empty one does, or to a deleted item, lead nowhere then. The lowest
/// bits of a link stay: that of a halfedge is its side.
template <unsigned kKeptBits = 0>
struct MovedLink {
  const Array<Index>& map;

  [[nodiscard]] Index operator()(Index old) const {
    const Index item = old >> kKeptBits;
    const Index now = item < map.size() ? map[item] : kNone;
    return now == kNone ? kNone : (now << kKeptBits) + (old - (item << kKeptBits));
  }
};
using MovedHalfedge = MovedLink<1>;

/// The parts of `compact` and of `reorder`, which write the links of a mesh.
class Compaction {
 public:
  /// Where everything goes. All that can fail.
  template <Storage kStored>
  [[nodiscard]] static Result<CompactMaps> plan(const BasicConnectivity<kStored>& mesh) {
    CompactMaps maps;
    if (!number_live<Vertex>(mesh, maps.vertices) || !number_live<Edge>(mesh, maps.edges) ||
        !number_live<Face>(mesh, maps.faces)) {
      return no_memory_for("the maps of compact()");
    }
    return maps;
  }

  template <Storage kStored>
  [[nodiscard]] static bool has_gaps(const BasicConnectivity<kStored>& mesh) {
    return mesh.free_vertices_.count + mesh.free_edges_.count + mesh.free_faces_.count > 0;
  }

  template <Storage kStored>
  static void run(BasicConnectivity<kStored>& mesh, const CompactMaps& maps) {
    rewrite(mesh, [&](Links& links, Attributes& attributes) {
      const MovedLink<> vertex{maps.vertices};
      const MovedHalfedge halfedge{maps.edges};
      const MovedLink<> face{maps.faces};
      move_down<1>(maps.vertices, links.vertex_halfedge, halfedge);
      move_down<1>(maps.faces, links.face_halfedge, halfedge);
      move_down<2>(maps.edges, links.to_vertex, vertex);
      move_down<2>(maps.edges, links.face, face);
      move_down<2>(maps.edges, links.prev, halfedge);
      move_down<2>(maps.edges, links.next, halfedge);
      attributes.compact(ItemKind::kVertex, maps.vertices);
      attributes.compact(ItemKind::kHalfedge, maps.edges);
      attributes.compact(ItemKind::kEdge, maps.edges);
      attributes.compact(ItemKind::kFace, maps.faces);
    });
  }

  /// Calls `move(links, attributes)`, which gives all live items other slots without gaps; as one
  /// change, noted by history.
  template <Storage kStored, class Move>
  static void rewrite(BasicConnectivity<kStored>& mesh, const Move& move) {
    if (mesh.history() != nullptr) note_all(mesh);
    move(mesh.links_, mesh.attributes_);
    mesh.attributes_.end_all_generations();
    mesh.free_vertices_ = mesh.free_edges_ = mesh.free_faces_ = FreeList{};
    ++mesh.version_;
  }

  template <Storage kStored>
  static void note_positions(BasicMesh<kStored>& mesh) {
    mesh.journal().end_new();
    for (Index v = 0; v < mesh.vertex_slots(); ++v) mesh.note_position(Vertex(v));
  }

  /// Moves the slots of `array`, `kWidth` to an item, to where `map` says, never upwards.
  template <std::size_t kWidth, class T, class Convert>
  static void move_down(const Array<Index>& map, Array<T>& array, const Convert& convert) {
    if (array.empty()) return;
    std::size_t end = 0;
    for (std::size_t old = 0; old < map.size(); ++old) {
      if (map[old] == kNone) continue;
      for (std::size_t i = 0; i < kWidth; ++i) {
        array[end + i] = convert(array[kWidth * old + i]);
      }
      end += kWidth;
    }
    (void)array.resize(end);  // no larger than it is
  }

 private:
  // Sizes last: they are the first that undo restores.
  template <Storage kStored>
  static void note_all(BasicConnectivity<kStored>& mesh) {
    mesh.journal_->end_new();
    const auto note_words = [&](Field field, const Array<Index>& array) {
      mesh.journal_->record_words(field, 0, array.data(), array.size());
    };
    const Links& links = mesh.links_;
    note_words(Field::kNext, links.next);
    note_words(Field::kPrev, links.prev);
    note_words(Field::kToVertex, links.to_vertex);
    note_words(Field::kFace, links.face);
    note_words(Field::kVertexHalfedge, links.vertex_halfedge);
    note_words(Field::kFaceHalfedge, links.face_halfedge);
    mesh.attributes_.note_all(*mesh.journal_);
    mesh.note(Field::kFreeListOfVertices, mesh.free_vertices_);
    mesh.note(Field::kFreeListOfEdges, mesh.free_edges_);
    mesh.note(Field::kFreeListOfFaces, mesh.free_faces_);
    mesh.note(Field::kVertexSlots, 0, mesh.vertex_slots());
    mesh.note(Field::kHalfedgeSlots, 0, mesh.halfedge_slots());
    mesh.note(Field::kFaceSlots, 0, mesh.face_slots());
  }

  template <class Item>
  [[nodiscard]] static bool number_live(const auto& mesh, Array<Index>& map) {
    if (!map.resize(mesh.slots(Item{}))) return false;
    Index live = 0;
    for (Index i = 0; i < map.size(); ++i) map[i] = mesh.is_deleted(Item(i)) ? kNone : live++;
    return true;
  }
};

/// Closes the gaps of deleted slots. Live items keep their order, and the sides of an edge theirs;
/// the maps say where each went. The memory stays reserved. After an error nothing has changed,
/// and nothing does where no slot is deleted: that is no step of history then.
///
/// pre: no live item refers to a deleted one (invariant 7); links that lead out of the arrays are
/// not followed, and empty afterwards
/// cost: O(slots), and 4 bytes a vertex, edge and face for the maps
/// errors: out-of-memory
template <Storage kStored>
[[nodiscard]] Result<CompactMaps> compact(BasicConnectivity<kStored>& mesh) {
  Result<CompactMaps> maps = Compaction::plan(mesh);
  if (maps && Compaction::has_gaps(mesh)) Compaction::run(mesh, maps.value());
  return maps;
}

/// The same with positions.
template <Storage kStored>
[[nodiscard]] Result<CompactMaps> compact(BasicMesh<kStored>& mesh) {
  Result<CompactMaps> maps = Compaction::plan(mesh);
  if (!maps || !Compaction::has_gaps(mesh)) return maps;
  if (mesh.history() != nullptr) Compaction::note_positions(mesh);
  Compaction::run(mesh, maps.value());
  Compaction::move_down<3>(maps.value().vertices, mesh.mutable_positions(),
                           [](float coordinate) { return coordinate; });
  return maps;
}

}  // namespace halfedge
