#pragma once

#include <halfedge/algorithms/triangulate_polygon.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/sort.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace halfedge {

/// A hash table of edges that will be, by their two vertices. It takes linear time for any edges,
/// also for those that someone chose who has read how they are hashed.
class PlannedEdges {
 public:
  [[nodiscard]] bool contains(Vertex a, Vertex b);
  /// False when memory is exhausted. pre: not there yet
  [[nodiscard]] bool insert(Vertex a, Vertex b);

 private:
  [[nodiscard]] std::size_t slot_of(std::uint64_t key);
  [[nodiscard]] bool rebuild(std::size_t slots);

  Array<std::uint64_t> slots_;  // a power of two
  std::size_t count_ = 0;
  std::size_t steps_ = 0;  // past slots of other edges, since the table was built
  std::uint64_t seed_ = 0;
};

/// Cuts the polygons of a mesh into triangles, one after another, so that no diagonal joins
/// vertices that an edge joins already, or a diagonal of a polygon before.
class PolygonCutter {
 public:
  using Outcome = PolygonTriangulator::Outcome;

  /// Appends the ears of a polygon, as PolygonTriangulator does. `corners` are its vertices, at
  /// `points`; `is_edge(a, b)` tells whether an edge joins two of them. kBlocked: each way to cut
  /// it without a fold takes a diagonal that joins what is joined; `blocked()` is one of them. Of
  /// many corners not all ways are tried.
  ///
  /// pre: 3 corners or more
  template <class IsEdge>
  [[nodiscard]] Outcome cut(std::span<const Vertex> corners, std::span<const Point> points,
                            const IsEdge& is_edge, Array<Index>& ears);
  /// The same, along any diagonals: never kBlocked.
  [[nodiscard]] Outcome cut_anyhow(std::span<const Point> points, Array<Index>& ears);

  [[nodiscard]] Diagonal blocked() const { return triangulator_.blocked(); }

  /// Polygons to come know the diagonals of the last one, whose vertices these are. False when
  /// memory is exhausted.
  [[nodiscard]] bool keep_diagonals(std::span<const Vertex> corners);

  /// Calls `visit(i, j, k)` with the corners of each triangle of the last polygon, whose ears these
  /// are, in the order in which they are cut off.
  template <class Visit>
  void for_each_triangle(std::span<const Index> ears, const Visit& visit);

 private:
  [[nodiscard]] Outcome cut_once(std::span<const Point> points, Array<Index>& ears);
  template <class Visit>
  void cut_off(std::span<const Index> ears, const Visit& visit);

  PolygonTriangulator triangulator_;
  PlannedEdges planned_;
  Array<Diagonal> diagonals_;
  Array<Diagonal> forbidden_;
  Array<Index> next_;  // of the corners that are left
  Array<Index> prev_;
};

template <class IsEdge>
PolygonCutter::Outcome PolygonCutter::cut(std::span<const Vertex> corners,
                                          std::span<const Point> points, const IsEdge& is_edge,
                                          Array<Index>& ears) {
  const std::size_t begin = ears.size();
  forbidden_.clear();
  for (;;) {
    const Outcome outcome = cut_once(points, ears);
    if (outcome != Outcome::kDone) return outcome;
    const std::size_t known = forbidden_.size();
    for (const Diagonal& diagonal : diagonals_) {
      const Vertex a = corners[diagonal.a];
      const Vertex b = corners[diagonal.b];
      if (!is_edge(a, b) && !planned_.contains(a, b)) continue;
      if (!forbidden_.push_back(diagonal)) return Outcome::kOutOfMemory;
    }
    if (forbidden_.size() == known) return Outcome::kDone;
    introsort(forbidden_.begin(), forbidden_.end());
    (void)ears.resize(begin);  // fewer than there are
  }
}

template <class Visit>
void PolygonCutter::for_each_triangle(std::span<const Index> ears, const Visit& visit) {
  cut_off(ears, visit);
  const Index left = ears.empty() ? 0 : next_[ears.back()];
  visit(prev_[left], left, next_[left]);
}

/// Calls `visit(before, ear, after)` for each ear.
template <class Visit>
void PolygonCutter::cut_off(std::span<const Index> ears, const Visit& visit) {
  make_ring(next_, prev_);
  for (const Index ear : ears) {
    const Index before = prev_[ear];
    const Index after = next_[ear];
    visit(before, ear, after);
    next_[before] = after;
    prev_[after] = before;
  }
}

}  // namespace halfedge
