#pragma once

#include <halfedge/mend/measure.h>

#include <cstddef>

namespace halfedge::mend {

/// The boxes of components, to be asked which of them are around another one.
class BoxTree {
 public:
  explicit BoxTree(const Array<Extent>& extents) : extents_(extents) {}

  /// One more of the extents, finite. False when memory is exhausted.
  [[nodiscard]] bool add(Index extent) { return order_.push_back(extent); }
  /// After the last one. False when memory is exhausted. O(n log^2 n)
  [[nodiscard]] bool build();

  /// Calls `visit` with each whose box has that of `inner` inside, or is the same.
  template <class Visit>
  void for_each_around(const Extent& inner, const Visit& visit) const {
    look(0, order_.size(), inner, visit);
  }

 private:
  struct Box {
    Vector low;
    Vector high;
  };

  [[nodiscard]] static bool is_inside(const Extent& inner, const Vector& low, const Vector& high) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (inner.low[k] < low[k] || inner.high[k] > high[k]) return false;
    }
    return true;
  }
  void divide(std::size_t begin, std::size_t end);

  // The one in the middle of a range stands for it, the halves are its children: so the tree is as
  // deep as the logarithm.
  template <class Visit>
  void look(std::size_t begin, std::size_t end, const Extent& inner, const Visit& visit) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    if (!is_inside(inner, bounds_[middle].low, bounds_[middle].high)) return;
    const Extent& own = extents_[order_[middle]];
    if (is_inside(inner, own.low, own.high)) visit(order_[middle]);
    look(begin, middle, inner, visit);
    look(middle + 1, end, inner, visit);
  }

  const Array<Extent>& extents_;
  Array<Index> order_;
  Array<Box> bounds_;  // of the range that each stands for
};

}  // namespace halfedge::mend
