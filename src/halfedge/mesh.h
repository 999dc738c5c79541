#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/connectivity.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>

namespace halfedge {

/// A point or a vector of three floats.
struct Point {
  float x = 0;
  float y = 0;
  float z = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

/// A connectivity whose vertices have positions: three floats for each vertex slot, xyz
/// interleaved. `Mesh` stores all links; others leave some out (see Storage).
///
/// A reference to its connectivity is for reading: what is new or undone through that one gets no
/// positions.
template <Storage kStored>
class BasicMesh : public BasicConnectivity<kStored> {
  using Base = BasicConnectivity<kStored>;

 public:
  using Base::free_vertices;
  using Base::vertex_slots;

  BasicMesh() = default;
  BasicMesh(BasicMesh&&) noexcept = default;
  BasicMesh& operator=(BasicMesh&&) noexcept = default;
  BasicMesh(const BasicMesh&) = delete;  // a copy can fail: use assign()
  BasicMesh& operator=(const BasicMesh&) = delete;
  ~BasicMesh() = default;

  [[nodiscard]] Point position(Vertex v) const {
    const float* p = &positions_[3 * std::size_t{v.index()}];
    return {p[0], p[1], p[2]};
  }
  /// Any floats are taken, here and by operations that get positions. `validate` at kGeometryLevel
  /// tells which aren't finite.
  void set_position(Vertex v, Point p) {
    float* stored = &positions_[3 * std::size_t{v.index()}];
    if (this->history() != nullptr) note_position(v);
    stored[0] = p.x;
    stored[1] = p.y;
    stored[2] = p.z;
  }

  /// 3 * vertex_slots() floats.
  [[nodiscard]] std::span<const float> positions() const { return positions_.span(); }
  /// The array of positions(), for code that goes on reading while it grows.
  [[nodiscard]] const Array<float>& position_array() const { return positions_; }
  /// Writes through it are not part of history.
  [[nodiscard]] Array<float>& mutable_positions() { return positions_; }

  /// An isolated vertex at `p`; empty when memory is exhausted.
  [[nodiscard]] Vertex add_vertex(Point p) {
    const std::size_t slots = vertex_slots() + (free_vertices().count == 0 ? 1 : 0);
    if (3 * slots > positions_.capacity() && !positions_.reserve(4 * slots + 48)) return {};
    const Vertex v = Base::new_vertex();
    if (!v.valid()) return {};
    (void)positions_.resize(3 * slots, 0.0F);  // reserved above
    set_position(v, p);
    return v;
  }

  /// As the connectivity's, at `p`.
  [[nodiscard]] Vertex append_vertex(Point p) {
    const Vertex v = Base::append_vertex();
    const std::size_t x = 3 * std::size_t{v.index()};
    positions_.grow_to(x + 3);
    positions_[x] = p.x;
    positions_[x + 1] = p.y;
    positions_[x + 2] = p.z;
    return v;
  }

  /// As the connectivity's, at the origin.
  [[nodiscard]] Vertex new_vertex() { return add_vertex({}); }

  [[nodiscard]] bool reserve(Index vertices, Index edges, Index faces) {
    return Base::reserve(vertices, edges, faces) && positions_.reserve(3 * std::size_t{vertices});
  }
  void clear() {
    positions_.clear();
    Base::clear();
  }
  /// Becomes a copy of `other`. False when memory is exhausted; then it is empty.
  [[nodiscard]] bool assign(const BasicMesh& other) {
    if (this == &other) return true;
    if (positions_.assign(other.positions_.span()) && Base::assign(other)) return true;
    clear();
    return false;
  }

  /// As the connectivity's, with positions.
  bool undo() {
    return Base::undo([this](const Journal::Note& note) { exchange(note); });
  }
  bool redo() {
    return Base::redo([this](const Journal::Note& note) { exchange(note); });
  }

 private:
  friend class Compaction;

  void note_position(Vertex v) {
    if (this->history() == nullptr) return;
    Index words[3];
    std::memcpy(words, &positions_[3 * std::size_t{v.index()}], sizeof words);
    this->journal().record_position(v.index(), words);
  }

  void exchange(const Journal::Note& note) {
    switch (note.field) {
      case Field::kPosition: {
        float* const stored = &positions_[3 * std::size_t{note.index}];
        Index words[3];
        std::memcpy(words, stored, sizeof words);
        std::memcpy(stored, note.words, sizeof words);
        std::memcpy(note.words, words, sizeof words);
        return;
      }
      case Field::kVertexSlots:
        // In room that was there before.
        (void)positions_.resize(3 * std::size_t{note.words[0]}, 0.0F);
        break;
      case Field::kNewVertices:
        return exchange_new_vertices(note);
      default:
        break;
    }
    Base::exchange(note);
  }

  // The positions are the first to be dropped, and the last to be there again.
  void exchange_new_vertices(const Journal::Note& note) {
    Journal& journal = this->journal();
    const std::size_t kept = 3 * std::size_t{std::min(note.words[0], vertex_slots())};
    const std::size_t changed = 3 * std::size_t{std::max(note.words[0], vertex_slots())} - kept;
    if (note.words[0] < vertex_slots()) {
      journal.keep_dropped(positions_.begin() + kept, changed);
      positions_.grow_to(kept);
      Base::exchange(note);
    } else {
      Base::exchange(note);
      positions_.grow_to(kept + changed);
      std::memcpy(positions_.begin() + kept, journal.take_dropped(changed),
                  changed * sizeof(float));
    }
  }

  Array<float> positions_;
};

using Mesh = BasicMesh<kEverything>;

/// A mesh type with positions that the operations look after: ours. One that is built on a
/// connectivity, and has another geometry, looks after that itself.
template <class Mesh>
concept HasPositions = requires(const Mesh& mesh, std::remove_const_t<Mesh>& changed, Vertex v) {
  mesh.position(v);
  changed.mutable_positions();
};

}  // namespace halfedge
