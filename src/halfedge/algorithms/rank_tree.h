#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace halfedge {

/// Items in a ring, each with a rank from 0 to 8: finds the next one of the highest rank.
///
/// A binary tree over the items, in which a node has the ranks that occur below it, a bit for each.
class RankTree {
 public:
  /// All have rank 0. False when memory is exhausted.
  /// cost: O(n), up to 4 bytes an item
  [[nodiscard]] bool build(std::size_t items) {
    leaves_ = std::bit_ceil(items);
    if (!ranks_.recreate(2 * leaves_)) return false;
    std::fill(ranks_.begin(), ranks_.end(), std::uint8_t{0});
    return true;
  }

  /// cost: O(log n)
  void set(Index item, int rank) {
    std::size_t node = leaves_ + item;
    ranks_[node] = rank == 0 ? std::uint8_t{0} : std::uint8_t(1U << (rank - 1));
    while ((node /= 2) > 0) {
      ranks_[node] = std::uint8_t(ranks_[2 * node] | ranks_[2 * node + 1]);
    }
  }

  /// The highest rank of all. cost: O(1)
  [[nodiscard]] int highest() const { return int(std::bit_width(ranks_[1])); }

  /// The first item that has this rank, `from` or behind it, and behind the last one from the first
  /// on; kNone if none has. cost: O(log n)
  [[nodiscard]] Index next(Index from, int rank) const {
    if (rank == 0) return kNone;
    const unsigned bit = 1U << (rank - 1);
    std::size_t node = leaves_ + from;
    while (node > 1 && (ranks_[node] & bit) == 0) {
      // To what lies behind: the sibling of a left child, or that of the first such ancestor.
      while (node > 1 && node % 2 == 1) node /= 2;
      if (node > 1) ++node;
    }
    if ((ranks_[node] & bit) == 0) return kNone;
    while (node < leaves_) node = 2 * node + ((ranks_[2 * node] & bit) == 0 ? 1 : 0);
    return Index(node - leaves_);
  }

 private:
  Array<std::uint8_t> ranks_;  // by node: 1 is the root, 2 i and 2 i + 1 are below i
  std::size_t leaves_ = 0;
};

}  // namespace halfedge
