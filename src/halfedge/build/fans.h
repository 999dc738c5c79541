#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/connectivity/links.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace halfedge {

// A fan is a maximal run of faces around a vertex, each joined to the next by an edge: closed, or
// open with a boundary halfedge at both ends.

/// Joins the open fans of each vertex into one cycle, in the order of the vertices that their
/// outgoing boundary halfedges lead to, and anchors the vertex on the first of these. So the
/// boundary halfedges get their `next`.
///
/// pre: all other links but `prev` are set; no two faces run along an edge in the same direction
/// cost: O(halfedges), and sorting the fans of pinched vertices. False when memory is exhausted.
[[nodiscard]] bool join_open_fans(Links& links);

/// Whether all halfedges that leave a vertex are reached by rotating from its anchor, for every
/// vertex: false if a closed fan shares its vertex with another fan.
///
/// pre: `next` is a permutation, each anchor leaves its vertex
/// cost: O(halfedges)
[[nodiscard]] bool each_vertex_has_one_cycle(const Links& links);

/// Walks around vertices that go on together. One walk is a chain of loads, each waiting for the
/// one before it; several at once wait together.
template <class Rotate>
class LongWalks {
 public:
  explicit LongWalks(const Rotate& rotate_cw) : rotate_cw_(rotate_cw) {}

  /// Takes over a walk that began at `anchor` and has come to `at`. Returns how many steps walks
  /// took meanwhile: none unless there was no room for one more.
  std::size_t take(Index anchor, Index at) {
    keep(anchor, at);
    return count_ == kMost ? finish() : 0;
  }

  /// Goes on to the ends of all walks. Returns how many steps they took.
  std::size_t finish() {
    std::size_t steps = 0;
    while (count_ >= 4) steps += walk<4>();
    while (count_ >= 2) steps += walk<2>();
    if (count_ == 1) steps += walk<1>();
    return steps;
  }

 private:
  /// Goes on with so many of the walks, the last ones, until some of them end. Returns how many
  /// steps they took. Their number is known to the compiler so that registers hold where they are.
  template <std::size_t kWalks>
  std::size_t walk() {
    count_ -= kWalks;
    std::array<Index, kWalks> anchor;
    std::array<Index, kWalks> at;
    std::copy_n(anchors_.begin() + count_, kWalks, anchor.begin());
    std::copy_n(at_.begin() + count_, kWalks, at.begin());
    std::size_t steps = 0;
    for (bool all_go_on = true; all_go_on; steps += kWalks) {
      for (std::size_t i = 0; i < kWalks; ++i) {
        at[i] = rotate_cw_(at[i]);
        all_go_on &= at[i] != anchor[i];
      }
    }
    for (std::size_t i = 0; i < kWalks; ++i) {
      if (at[i] != anchor[i]) keep(anchor[i], at[i]);
    }
    return steps;
  }

  void keep(Index anchor, Index at) {
    anchors_[count_] = anchor;
    at_[count_] = at;
    ++count_;
  }

  static constexpr std::size_t kMost = 8;

  const Rotate& rotate_cw_;
  std::array<Index, kMost> anchors_{};
  std::array<Index, kMost> at_{};
  std::size_t count_ = 0;
};

/// `each_vertex_has_one_cycle`, however the links are stored: `anchors` by vertex, and
/// `rotate_cw(h)` is the next halfedge that leaves the vertex of `h`.
///
/// Walks around many vertices in step, as the end of one walk can't be predicted. Where only a few
/// of them go on, these do by themselves.
template <class Rotate>
[[nodiscard]] bool each_vertex_has_one_cycle(std::span<const Index> anchors, std::size_t halfedges,
                                             const Rotate& rotate_cw) {
  constexpr Index kLanes = kCanPrefetch ? 32 : 64;  // 64 take longer natively, in natural order
  constexpr Index kFew = kLanes / 8;
  constexpr int kUsualSteps = 10;
  constexpr int kMostSteps = 64;
  if (halfedges == 0) return true;
  LongWalks<Rotate> long_walks(rotate_cw);  // around vertices of higher valence
  std::size_t reached = 0;
  for (std::size_t v = 0; v < anchors.size(); v += kLanes) {
    std::array<Index, kLanes> anchor;
    std::array<Index, kLanes> at;
    std::array<Index, kLanes> walking;
    for (std::size_t i = 0; i < kLanes; ++i) {
      anchor[i] = v + i < anchors.size() ? anchors[v + i] : kNone;
      walking[i] = anchor[i] != kNone ? 1 : 0;
      at[i] = walking[i] != 0 ? anchor[i] : 0;
    }
    Index left = kLanes;
    for (int steps = 0; steps < kMostSteps && left > (steps < kUsualSteps ? 0 : kFew); ++steps) {
      left = 0;
      for (std::size_t i = 0; i < kLanes; ++i) {
        reached += walking[i];
        at[i] = rotate_cw(at[i]);
        walking[i] &= Index{at[i] != anchor[i]};
        left += walking[i];
      }
    }
    for (std::size_t i = 0; left != 0 && i < kLanes; ++i) {
      if (walking[i] != 0) reached += long_walks.take(anchor[i], at[i]);
    }
  }
  return reached + long_walks.finish() == halfedges;
}

}  // namespace halfedge
