#include <halfedge/algorithms/vertex_order.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace halfedge {

namespace {

Error out_of_memory() { return no_memory_for("an order of the vertices"); }

[[nodiscard]] bool is_live(const Links& links, std::size_t v) {
  return links.vertex_halfedge.empty() || !is_deleted_link(links.vertex_halfedge[v]);
}

// The cells of the box of all live vertices. Cubes, so that curves run equally long along all axes.
class Grid {
 public:
  Grid(std::span<const float> positions, const Links& links) {
    std::array<float, 3> most;
    least_.fill(std::numeric_limits<float>::max());
    most.fill(std::numeric_limits<float>::lowest());
    for (std::size_t v = 0; v < positions.size() / 3; ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float p = positions[3 * v + axis];
        if (!std::isfinite(p) || !is_live(links, v)) continue;
        least_[axis] = std::min(least_[axis], p);
        most[axis] = std::max(most[axis], p);
      }
    }
    double longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      longest = std::max(longest, double(most[axis]) - double(least_[axis]));
    }
    if (longest > 0) cells_per_unit_ = kCells / longest;
  }

  /// The place of the cell of a point on the curve: the bits of its coordinates in turn.
  [[nodiscard]] std::uint64_t place(const float* point) const {
    return 4 * spread(cell(point, 0)) + 2 * spread(cell(point, 1)) + spread(cell(point, 2));
  }

 private:
  static constexpr double kCells = double{1U << 21U};  // along an axis

  [[nodiscard]] std::uint64_t cell(const float* point, std::size_t axis) const {
    const double cells = (double(point[axis]) - double(least_[axis])) * cells_per_unit_;
    if (!(cells > 0)) return 0;  // NaN, too
    return std::uint64_t(std::min(cells, kCells - 1));
  }

  // Of 21 bits the i-th goes to place 3 i.
  [[nodiscard]] static std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 32U) & 0x001F'0000'0000'FFFF;
    bits = (bits | bits << 16U) & 0x001F'0000'FF00'00FF;
    bits = (bits | bits << 8U) & 0x100F'00F0'0F00'F00F;
    bits = (bits | bits << 4U) & 0x10C3'0C30'C30C'30C3;
    return (bits | bits << 2U) & 0x1249'2492'4924'9249;
  }

  std::array<float, 3> least_;
  double cells_per_unit_ = 0;
};

// Items with keys of 64 bits, sorted by one digit after the other, the lowest first.
class RadixSort {
 public:
  [[nodiscard]] bool reserve(std::size_t count) {
    return keys_.resize(count) && items_.resize(count) && sorted_keys_.resize(count) &&
           sorted_items_.resize(count);
  }

  /// pre: there is room
  void add(std::uint64_t key, Index item) {
    keys_[size_] = key;
    items_[size_++] = item;
    for (std::size_t digit = 0; digit < kDigits; ++digit) ++counts_[digit][at(key, digit)];
  }

  /// Stable. cost: O(items) for each digit that they don't have in common
  [[nodiscard]] Array<Index> sorted() {
    for (std::size_t digit = 0; digit < kDigits; ++digit) {
      if (size_ > 0 && counts_[digit][at(keys_[0], digit)] < size_) sort_by(digit);
    }
    items_.grow_to(size_);
    return std::move(items_);
  }

 private:
  static constexpr std::size_t kDigits = 8;

  [[nodiscard]] static std::size_t at(std::uint64_t key, std::size_t digit) {
    return std::size_t(key >> (8 * digit) & 0xFFU);
  }

  void sort_by(std::size_t digit) {
    std::array<Index, 256>& ends = counts_[digit];
    Index end = 0;
    for (Index& count : ends) end += std::exchange(count, end);
    for (std::size_t i = 0; i < size_; ++i) {
      const Index to = ends[at(keys_[i], digit)]++;
      sorted_keys_[to] = keys_[i];
      sorted_items_[to] = items_[i];
    }
    std::swap(keys_, sorted_keys_);
    std::swap(items_, sorted_items_);
  }

  std::size_t size_ = 0;
  Array<std::uint64_t> keys_;
  Array<Index> items_;
  Array<std::uint64_t> sorted_keys_;
  Array<Index> sorted_items_;
  std::array<std::array<Index, 256>, kDigits> counts_ = {};
};

}  // namespace

Result<Array<Index>> morton_order(std::span<const float> positions, const Links& links) {
  const std::size_t slots = positions.size() / 3;
  RadixSort sort;
  if (!sort.reserve(slots)) return out_of_memory();
  const Grid grid(positions, links);
  for (std::size_t v = 0; v < slots; ++v) {
    if (is_live(links, v)) sort.add(grid.place(&positions[3 * v]), Index(v));
  }
  return sort.sorted();
}

Result<Array<Index>> breadth_first_order(const Links& links) {
  const Array<Index>& anchors = links.vertex_halfedge;
  Array<Index> order;
  Array<bool> seen;
  if (!order.reserve(anchors.size()) || !seen.resize(anchors.size(), false)) return out_of_memory();
  const auto list = [&](Index v) {
    if (v >= seen.size() || seen[v] || !is_live(links, v)) return;
    seen[v] = true;
    order.grow_to(order.size() + 1);
    order[order.size() - 1] = v;
  };
  // A halfedge leaves one vertex: more steps are only taken if rings are broken.
  std::size_t steps = links.next.size();
  std::size_t done = 0;
  for (Index seed = 0; seed < anchors.size(); ++seed) {
    list(seed);
    for (; done < order.size(); ++done) {
      const Index anchor = anchors[order[done]];
      Index h = anchor;
      for (; h < links.next.size() && steps > 0; --steps) {
        list(links.to_vertex[h]);
        h = links.next[h ^ 1U];
        if (h == anchor) break;
      }
    }
  }
  return order;
}

}  // namespace halfedge
