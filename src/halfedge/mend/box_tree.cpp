#include <halfedge/mend/box_tree.h>
#include <halfedge/sort.h>

#include <algorithm>

namespace halfedge::mend {

bool BoxTree::build() {
  if (!bounds_.resize(order_.size())) return false;
  divide(0, order_.size());
  return true;
}

// In half across the longest side.
void BoxTree::divide(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  Box box{extents_[order_[begin]].low, extents_[order_[begin]].high};
  for (std::size_t i = begin + 1; i < end; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], extents_[order_[i]].low[k]);
      box.high[k] = std::max(box.high[k], extents_[order_[i]].high[k]);
    }
  }
  bounds_[middle] = box;
  const Vector size = box.high - box.low;
  const auto axis = std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
  introsort(order_.begin() + begin, order_.begin() + end, [&](Index a, Index b) {
    const double low_a = extents_[a].low[axis];
    const double low_b = extents_[b].low[axis];
    return low_a != low_b ? low_a < low_b : a < b;
  });
  divide(begin, middle);
  divide(middle + 1, end);
}

}  // namespace halfedge::mend
