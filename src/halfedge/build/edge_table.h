#pragma once

#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace halfedge {

/// A hash table of edges by their two vertices, over memory that is lent to it. A slot holds the
/// even halfedge of an edge, which leads from the smaller vertex to the larger, or kNone.
///
/// pre: 16 slots or more, of which at most three quarters are used; then a look-up is expected to
/// be O(1), also of edges that were chosen to collide
class EdgeTable {
 public:
  explicit EdgeTable(std::span<Index> empty_slots) : slots_(empty_slots) {}

  /// The slot that holds the edge, else the empty one where it belongs.
  [[nodiscard]] Index& slot(Index low, Index high, const Index* to_vertex) const {
    // Sixteen neighbours in number are neighbours in the table, in one line of the cache: they are
    // often needed together.
    std::uint32_t hash = (low * 0x85EB'CA6BU ^ (high / kNear)) * 0x9E37'79B1U;
    for (std::uint32_t jumps = 0;; ++jumps) {
      std::size_t i =
          std::size_t(std::uint64_t{hash} * (slots_.size() / kNear) >> 32U) * kNear + high % kNear;
      const std::size_t run = jumps < kMaxJumps ? kRun : slots_.size();
      for (std::size_t step = 0; step < run; ++step) {
        const Index h = slots_[i];
        if (h == kNone || (to_vertex[h] == high && to_vertex[h + 1] == low)) return slots_[i];
        i = i + 1 == slots_.size() ? 0 : i + 1;
      }
      // So long a run is no accident; edges that were chosen to meet here don't meet elsewhere too.
      std::uint64_t other = (std::uint64_t{low} << 32U | high) * 0x9E37'79B9'7F4A'7C15U + jumps;
      other = (other ^ (other >> 32U)) * 0xBF58'476D'1CE4'E5B9U;
      hash = std::uint32_t(other >> 32U);
    }
  }

 private:
  static constexpr std::uint32_t kNear = 16;
  static constexpr std::size_t kRun = 64;
  static constexpr std::uint32_t kMaxJumps = 32;
  std::span<Index> slots_;
};

}  // namespace halfedge
