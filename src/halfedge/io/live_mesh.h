#pragma once

#include <halfedge/io/write.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfedge::io {

/// The live vertices and faces of a mesh, numbered without gaps, for writers of files.
class LiveMesh {
 public:
  LiveMesh(const WriteSource& source, std::vector<std::string>& notes)
      : source_(source), notes_(notes) {}

  /// Numbers and counts.
  [[nodiscard]] std::optional<Error> prepare();

  [[nodiscard]] Index vertex_count() const { return vertex_count_; }
  [[nodiscard]] Index face_count() const { return face_count_; }
  [[nodiscard]] Index largest_degree() const { return largest_degree_; }
  [[nodiscard]] std::uint64_t triangle_count() const { return triangle_count_; }

  /// Calls `visit(slot)` for each vertex.
  template <class Visit>
  void for_each_vertex(const Visit& visit) const {
    const auto slots = static_cast<Index>(source_.positions.size() / 3);
    for (Index v = 0; v < slots; ++v) {
      if (is_live(v)) visit(v);
    }
  }
  /// Calls `visit(slot, slots of its vertices)` for each face; number() tells what to write for
  /// them.
  template <class Visit>
  void for_each_face(const Visit& visit) const {
    for (std::size_t f = 0; f + 1 < source_.faces.offsets.size(); ++f) {
      const std::span<const Index> row = row_of(source_.faces, f);
      if (!row.empty()) visit(static_cast<Index>(f), row);
    }
  }
  /// Those that end at the vertices of a face, in their order. pre: the mesh has attributes by
  /// halfedge
  [[nodiscard]] std::span<const Index> halfedges(Index face) const {
    return row_of(source_.halfedges, face);
  }
  [[nodiscard]] Index number(Index slot) const { return numbers_.empty() ? slot : numbers_[slot]; }
  [[nodiscard]] const float* position(Index slot) const {
    return &source_.positions[3 * std::size_t{slot}];
  }
  [[nodiscard]] std::size_t vertex_slots() const { return source_.positions.size() / 3; }
  /// Whether there is an edge between two vertices. False where the neighbours aren't known.
  [[nodiscard]] bool are_joined(Index a, Index b) const;

  /// The attributes by this kind of item that are the user's.
  [[nodiscard]] std::vector<const Attribute*> attributes(ItemKind kind) const;
  /// The one of this name, for the writer to write it, or null if there is none or it doesn't fit.
  template <class Fits>
  [[nodiscard]] const Attribute* take(ItemKind kind, std::string_view name,
                                      const Fits& fits) const {
    const Attribute* const column =
        source_.attributes == nullptr ? nullptr : source_.attributes->find(kind, name);
    if (column == nullptr || column->is_generation() || !fits(*column)) return nullptr;
    taken_.push_back(column);
    return column;
  }
  /// Notes that an attribute isn't in the file, and why.
  void leave_out(const Attribute& attribute, const std::string& why) const;
  /// The same of all that weren't taken or left out.
  void leave_out_rest(const std::string& why) const;
  /// Notes what a reader will make of the file.
  void note(std::string sentence) const { notes_.push_back(std::move(sentence)); }
  /// Notes that it is in the file, but in another form.
  void note_change(const Attribute& attribute, const std::string& form) const;

 private:
  [[nodiscard]] static std::span<const Index> row_of(const Adjacency& rows, std::size_t i) {
    const Index begin = rows.offsets[i];
    return rows.items.span().subspan(begin, rows.offsets[i + 1] - begin);
  }
  [[nodiscard]] bool is_live(Index v) const {
    return source_.is_deleted.empty() || source_.is_deleted[v] == 0;
  }

  const WriteSource& source_;
  std::vector<std::string>& notes_;
  mutable std::vector<const Attribute*> taken_;  // or left out
  Array<Index> numbers_;                         // of vertices; empty if there are no gaps
  Index vertex_count_ = 0;
  Index face_count_ = 0;
  Index largest_degree_ = 0;
  std::uint64_t triangle_count_ = 0;
};

}  // namespace halfedge::io
