#pragma once

#include <halfedge/algorithms/planar.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <span>

namespace halfedge {

/// Points of a plane, some of which are in a set: finds those of the set that lie in a triangle,
/// without a look at most others. A k-d tree of all points, in which a node has the box of those in
/// the set: so it becomes finer as they leave it.
class PointTree {
 public:
  /// None is in the set. Keeps the span. False when memory is exhausted.
  /// cost: O(n log n), 17 bytes a point
  [[nodiscard]] bool build(std::span<const PlanarPoint> points);

  [[nodiscard]] bool contains(Index point) const { return is_in_[point]; }
  /// cost: O(log n)
  void insert(Index point);
  void erase(Index point);

  /// Whether `is_hit(point)` holds for one of the set, asked of all that lie in this triangle or on
  /// its sides, and of some others in the box around it.
  ///
  /// pre: the triangle turns left. cost: mostly O(sqrt(n)), and what is asked
  template <class Hit>
  [[nodiscard]] bool any_in(const PlanarPoint (&triangle)[3], const Hit& is_hit) const {
    const Box box = box_of(triangle);
    std::size_t stack[2 * kMostLevels];
    std::size_t size = 0;
    stack[size++] = 1;
    while (size > 0) {
      const std::size_t node = stack[--size];
      if (!may_meet(boxes_[node], box, triangle)) continue;
      if (node < leaves_) {
        stack[size++] = 2 * node + 1;
        stack[size++] = 2 * node;
        continue;
      }
      for (const Index point : points_of_leaf(node - leaves_)) {
        if (is_in_[point] && box.has(points_[point]) && is_hit(point)) return true;
      }
    }
    return false;
  }

 private:
  static constexpr std::size_t kLeaf = 4;         // points
  static constexpr std::size_t kMostLevels = 32;  // as many as there are bits in an index

  struct Box {
    float min_u;
    float max_u;
    float min_v;
    float max_v;

    [[nodiscard]] bool has(const PlanarPoint& p) const {
      return p.u >= min_u && p.u <= max_u && p.v >= min_v && p.v <= max_v;
    }
    void add(const PlanarPoint& p);
  };

  [[nodiscard]] static Box empty_box();
  [[nodiscard]] static Box box_of(const PlanarPoint (&triangle)[3]);
  [[nodiscard]] static bool may_meet(const Box& node, const Box& box,
                                     const PlanarPoint (&triangle)[3]);
  void sort(std::size_t first_leaf, std::size_t end_leaf);
  [[nodiscard]] std::span<const Index> points_of_leaf(std::size_t leaf) const;

  std::span<const PlanarPoint> points_;
  Array<Index> order_;    // leaf after leaf
  Array<Index> leaf_of_;  // by point
  Array<bool> is_in_;     // by point
  Array<Box> boxes_;      // by node: 1 is the root, 2 i and 2 i + 1 are below i
  std::size_t leaves_ = 0;
};

}  // namespace halfedge
