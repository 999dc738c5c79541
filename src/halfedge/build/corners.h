#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace halfedge {

/// How the corners of an index buffer lie in its faces: which comes next, which face is it. Two
/// forms of one interface, so that the builder is one template and triangles cost no lookup.
class TriangleCorners {
 public:
  [[nodiscard]] static Index face(Index c) { return c / 3; }
  [[nodiscard]] static Index next(Index c) { return c % 3 == 2 ? c - 2 : c + 1; }
  [[nodiscard]] static Index prev(Index c) { return c % 3 == 0 ? c + 2 : c - 1; }
  /// Whether `c` is the first corner of its face.
  [[nodiscard]] static bool is_first(Index c) { return c % 3 == 0; }
};

/// Faces of any size, as one bit for each corner (set at the first corner of a face) and one count
/// for each 64 of them: a twelfth of what a face index for each corner would take.
class PolygonCorners {
 public:
  /// pre: no size is 0, the sizes add up to `corner_count` <= kMaxSlots
  /// Returns false when memory is exhausted.
  [[nodiscard]] bool assign(std::span<const Index> sizes, std::size_t corner_count) {
    const std::size_t words = corner_count / 64 + 1;
    if (!firsts_.recreate(words) || !faces_before_.recreate(words)) return false;
    for (std::uint64_t& word : firsts_) word = 0;
    std::size_t corner = 0;
    for (const Index size : sizes) {
      set_first(corner);
      corner += size;
    }
    set_first(corner);  // where the next face would begin
    Index faces = 0;
    for (std::size_t i = 0; i < words; ++i) {
      faces_before_[i] = faces;
      faces += Index(std::popcount(firsts_[i]));
    }
    return true;
  }

  [[nodiscard]] bool is_first(Index c) const { return (firsts_[c / 64] >> c % 64 & 1U) != 0; }
  [[nodiscard]] Index face(Index c) const {
    const std::uint64_t up_to_c = firsts_[c / 64] << (63 - c % 64);
    return faces_before_[c / 64] + Index(std::popcount(up_to_c)) - 1;
  }
  [[nodiscard]] Index next(Index c) const { return is_first(c + 1) ? first_of(c) : c + 1; }
  [[nodiscard]] Index prev(Index c) const { return is_first(c) ? end_of(c) - 1 : c - 1; }

 private:
  void set_first(std::size_t c) { firsts_[c / 64] |= std::uint64_t{1} << c % 64; }

  // Both scan 64 corners a step, so over a whole mesh they cost next to nothing.
  [[nodiscard]] Index first_of(Index c) const {
    Index i = c / 64;
    std::uint64_t word = firsts_[i] & ~std::uint64_t{0} >> (63 - c % 64);
    while (word == 0) word = firsts_[--i];
    return i * 64 + 63 - Index(std::countl_zero(word));
  }
  [[nodiscard]] Index end_of(Index c) const {
    Index i = (c + 1) / 64;
    std::uint64_t word = firsts_[i] & ~std::uint64_t{0} << (c + 1) % 64;
    while (word == 0) word = firsts_[++i];
    return i * 64 + Index(std::countr_zero(word));
  }

  Array<std::uint64_t> firsts_;
  Array<Index> faces_before_;
};

}  // namespace halfedge
