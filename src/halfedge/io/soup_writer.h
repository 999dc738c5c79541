#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/inlining.h>
#include <halfedge/io/text_scanner.h>
#include <halfedge/progress.h>
#include <halfedge/result.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halfedge::io {

/// Where some vertices, or some faces, start in the file: filled in by a reader that is asked for
/// them.
class Places {
 public:
  /// `items` in ascending order.
  explicit Places(std::span<const Index> items)
      : items_(items), positions_(items.size(), nullptr) {}

  /// The next item wanted; nothing is as large as the answer when there is no more.
  [[nodiscard]] std::size_t next() const {
    return found_ == items_.size() ? static_cast<std::size_t>(-1) : items_[found_];
  }
  /// `item` starts at `position`.
  void found(std::size_t item, const char* position) {
    while (next() == item) positions_[found_++] = position;
  }
  /// `count` items from `first` on start at `position` and every `stride` bytes behind it.
  void found(std::size_t first, std::size_t count, const std::uint8_t* position,
             std::size_t stride);
  /// One for each item; null where the file has no such item.
  [[nodiscard]] std::span<const char* const> positions() const { return positions_; }

 private:
  std::span<const Index> items_;
  std::vector<const char*> positions_;
  std::size_t found_ = 0;
};

/// What a reader is asked to find, if anything.
struct WantedPlaces {
  Places* vertices = nullptr;
  Places* faces = nullptr;
};

/// Collects what a reader finds, and reads on as long as there is memory. Growth is amortised.
class SoupWriter {
 public:
  explicit SoupWriter(const WantedPlaces& wanted) : wanted_(wanted) {
    look_for_next_vertex();
    look_for_next_face();
  }

  [[nodiscard]] std::size_t vertex_count() const { return soup_.positions.size() / 3; }
  [[nodiscard]] std::size_t face_count() const { return faces_; }
  [[nodiscard]] std::size_t corner_count() const { return soup_.corners.size(); }
  /// Of the face that is being written.
  [[nodiscard]] std::size_t corners_of_face() const { return soup_.corners.size() - face_start_; }
  [[nodiscard]] Index largest_index() const { return largest_; }
  /// An allocation failed, and what was written since is lost; or reading was cancelled.
  [[nodiscard]] bool out_of_memory() const { return out_of_memory_; }
  [[nodiscard]] bool cancelled() const { return cancelled_; }
  /// For an allocation of the reader's own.
  void set_out_of_memory() { out_of_memory_ = true; }

  /// Room for these, so that they need not grow.
  void reserve(std::size_t vertices, std::size_t corners) {
    if (!soup_.positions.reserve(3 * vertices) || !soup_.corners.reserve(corners)) {
      out_of_memory_ = true;
    }
  }
  void add_vertex(float x, float y, float z) {
    float* const p = append(soup_.positions, 3);
    if (p == nullptr) return;
    p[0] = x;
    p[1] = y;
    p[2] = z;
  }
  /// Room for so many more vertices, three numbers each, for the caller to fill in; or null.
  [[nodiscard]] float* add_vertices(std::size_t count) {
    return append(soup_.positions, 3 * count);
  }
  /// `progress` is told from now on how much of these bytes has been read.
  void follow(std::span<const std::uint8_t> bytes, const Progress& progress) {
    bytes_ = bytes;
    progress_ = progress;
    if (progress.report != nullptr) next_report_ = address_of(bytes.data()) + kReportEvery;
  }
  /// The reader has come to `position`, and goes on unless that is cancelled (see out_of_memory).
  void reached(const void* position) {
    if (address_of(position) >= next_report_) report(position);
  }
  /// The next vertex starts at `position`.
  void begin_vertex(const char* position) {
    if (soup_.positions.size() != next_wanted_position_) return;
    wanted_.vertices->found(vertex_count(), position);
    look_for_next_vertex();
  }
  /// Each of the next `count` vertices starts `stride` bytes behind the one before.
  HALFEDGE_NOINLINE void begin_vertices(std::size_t count, const std::uint8_t* position,
                                        std::size_t stride);
  /// The next face starts at `position`.
  void begin_face(const char* position) {
    if (faces_ != next_wanted_face_) return;
    wanted_.faces->found(faces_, position);
    look_for_next_face();
  }
  /// The same of faces.
  HALFEDGE_NOINLINE void begin_faces(std::size_t count, const std::uint8_t* position,
                                     std::size_t stride);
  void add_corner(Index vertex) {
    largest_ = std::max(largest_, vertex);
    if (Index* const p = append(soup_.corners, 1)) *p = vertex;
  }
  /// The next corner is one of a vertex that the file does not have, for a repair to name: an index
  /// that no mesh has, with the same 32 bits where that is possible. `spell` makes what the file
  /// has there, if it is no plain number; it is called where those don't tell it.
  [[nodiscard]] Index missing_vertex(std::int64_t vertex) {
    return missing_vertex(vertex, [vertex] { return std::to_string(vertex); });
  }
  template <class Spell>
  [[nodiscard]] Index missing_vertex(std::int64_t vertex, const Spell& spell) {
    if (vertex >= 0 && vertex <= INT64_C(0xFFFF'FFFF)) return static_cast<Index>(vertex);
    if (can_name()) soup_.missing.add(corner_count(), spell());
    return vertex >= INT32_MIN && vertex < 0 ? static_cast<Index>(vertex) : kNone;
  }
  /// A face of three corners, in one go.
  void add_triangle(Index a, Index b, Index c) {
    largest_ = std::max({largest_, a, b, c});
    if (Index* const p = append(soup_.corners, 3)) {
      p[0] = a;
      p[1] = b;
      p[2] = c;
    }
    end_face();
  }
  /// Room for so many triangles, three corners each, for the caller to fill in; or null.
  /// pre: all faces are triangles, and nobody asks for the largest index
  [[nodiscard]] Index* add_triangles(std::size_t count) {
    Index* const corners = append(soup_.corners, 3 * count);
    if (corners == nullptr) return nullptr;
    faces_ += count;
    face_start_ = soup_.corners.size();
    return corners;
  }
  /// Sizes are kept from the first face on that is no triangle.
  void end_face() {
    const std::size_t size = corners_of_face();
    if (size != 3 || !soup_.sizes.empty()) add_size(static_cast<Index>(size));
    ++faces_;
    face_start_ = soup_.corners.size();
  }

  [[nodiscard]] PolygonSoup& soup() { return soup_; }

 private:
  static constexpr std::size_t kNothing = static_cast<std::size_t>(-1);
  static constexpr std::uintptr_t kReportEvery = std::uintptr_t{1} << 20;

  [[nodiscard]] static std::uintptr_t address_of(const void* position) {
    return reinterpret_cast<std::uintptr_t>(position);
  }
  void report(const void* position);
  HALFEDGE_COLD bool can_name() const;
  void look_for_next_vertex() {
    const Places* const vertices = wanted_.vertices;
    if (vertices == nullptr) return;
    const std::size_t next = vertices->next();
    next_wanted_position_ = next == kNothing ? kNothing : 3 * next;
  }
  void look_for_next_face() {
    if (wanted_.faces != nullptr) next_wanted_face_ = wanted_.faces->next();
  }
  void add_size(Index size) {
    if (soup_.sizes.empty() && !soup_.sizes.resize(faces_, 3)) out_of_memory_ = true;
    if (Index* const p = append(soup_.sizes, 1)) *p = size;
  }
  /// Room for `count` new elements, or null. Where half as much again is too much, an eighth may
  /// do; less would copy the array time and again.
  template <class T>
  [[nodiscard]] T* append(Array<T>& array, std::size_t count) {
    const std::size_t size = array.size();
    const std::size_t needed = size + count;
    if (needed > array.capacity() && !array.reserve(needed + size / 2 + 96) &&
        !array.reserve(needed + size / 8)) {
      out_of_memory_ = true;
      return nullptr;
    }
    (void)array.resize(needed);  // there is room
    return array.data() + size;
  }

  PolygonSoup soup_;
  std::size_t faces_ = 0;
  std::size_t face_start_ = 0;
  Index largest_ = 0;
  bool out_of_memory_ = false;
  bool cancelled_ = false;
  WantedPlaces wanted_;
  std::size_t next_wanted_position_ = kNothing;
  std::size_t next_wanted_face_ = kNothing;
  std::span<const std::uint8_t> bytes_;
  Progress progress_;
  std::uintptr_t next_report_ = UINTPTR_MAX;
};

/// "line N: " before a message about what the cursor stands at.
[[nodiscard]] HALFEDGE_COLD Error error_at(const TextScanner& text, std::string_view code,
                                           const std::string& message);
/// "line N: expected …, found …"; truncated at the end of the file, else parse-error.
[[nodiscard]] Error unexpected(const TextScanner& text, const std::string& expected);
/// index-out-of-range: "line N: corner … of face … is …", for the caller to say what was expected.
[[nodiscard]] Error index_error(const TextScanner& text, std::size_t corner, std::size_t face);
/// "byte N: " before a message about a binary file.
[[nodiscard]] HALFEDGE_COLD Error error_at_byte(std::size_t offset, std::string_view code,
                                                const std::string& message);
[[nodiscard]] inline Error no_memory_for_attributes() {
  return {"out-of-memory", "memory was exhausted after the file had been read"};
}
/// Memory is exhausted, reading was cancelled, or the counts are beyond 32-bit indices; else
/// nothing. The soup is freed with an error, which needs memory itself.
[[nodiscard]] std::optional<Error> check_size(SoupWriter& out);

}  // namespace halfedge::io
