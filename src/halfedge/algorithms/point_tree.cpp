#include <halfedge/algorithms/point_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfedge {

namespace {

/// An order of all floats, with NaN behind the others.
bool comes_before(float a, float b) { return a < b || (a == a && b != b); }

}  // namespace

PointTree::Box PointTree::empty_box() {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  return {kFar, -kFar, kFar, -kFar};
}

// Points that aren't finite lie in no triangle, and would take the box with them.
void PointTree::Box::add(const PlanarPoint& p) {
  if (!std::isfinite(p.u) || !std::isfinite(p.v)) return;
  min_u = std::min(min_u, p.u);
  max_u = std::max(max_u, p.u);
  min_v = std::min(min_v, p.v);
  max_v = std::max(max_v, p.v);
}

PointTree::Box PointTree::box_of(const PlanarPoint (&triangle)[3]) {
  Box box = empty_box();
  for (const PlanarPoint& p : triangle) box.add(p);
  return box;
}

// False only if no point of the node's box lies in the triangle: if it is beside the other box, or
// if even the corner that is farthest to the left of a side of the triangle lies on its right.
bool PointTree::may_meet(const Box& node, const Box& box, const PlanarPoint (&triangle)[3]) {
  if (node.min_u > box.max_u || node.max_u < box.min_u) return false;
  if (node.min_v > box.max_v || node.max_v < box.min_v) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const PlanarPoint& a = triangle[i];
    const PlanarPoint& b = triangle[i == 2 ? 0 : i + 1];
    const PlanarPoint corner = {b.v < a.v ? node.max_u : node.min_u,
                                b.u > a.u ? node.max_v : node.min_v};
    if (turn_of(a, b, corner) < 0) return false;
  }
  return true;
}

bool PointTree::build(std::span<const PlanarPoint> points) {
  points_ = points;
  leaves_ = 1;
  while (kLeaf * leaves_ < points.size()) leaves_ *= 2;
  if (!order_.recreate(points.size()) || !leaf_of_.recreate(points.size()) ||
      !is_in_.recreate(points.size()) || !boxes_.recreate(2 * leaves_)) {
    return false;
  }
  std::fill(is_in_.begin(), is_in_.end(), false);
  std::fill(boxes_.begin(), boxes_.end(), empty_box());
  for (Index i = 0; i < points.size(); ++i) order_[i] = i;
  sort(0, leaves_);
  for (std::size_t i = 0; i < order_.size(); ++i) leaf_of_[order_[i]] = Index(i / kLeaf);
  return true;
}

// Divides the points of these leaves between the first and the second half of them, across the
// longer side of their box.
void PointTree::sort(std::size_t first_leaf, std::size_t end_leaf) {
  Index* const first = order_.begin() + kLeaf * first_leaf;
  Index* const end = order_.begin() + std::min(kLeaf * end_leaf, order_.size());
  const std::size_t middle_leaf = (first_leaf + end_leaf) / 2;
  if (end_leaf - first_leaf < 2) return;
  Index* const middle = order_.begin() + kLeaf * middle_leaf;
  if (middle < end) {
    Box box = empty_box();
    for (const Index* i = first; i < end; ++i) box.add(points_[*i]);
    const bool by_u = box.max_u - box.min_u > box.max_v - box.min_v;
    std::nth_element(first, middle, end, [&](Index a, Index b) {
      return by_u ? comes_before(points_[a].u, points_[b].u)
                  : comes_before(points_[a].v, points_[b].v);
    });
    sort(middle_leaf, end_leaf);
  }
  sort(first_leaf, middle_leaf);
}

std::span<const Index> PointTree::points_of_leaf(std::size_t leaf) const {
  const std::size_t begin = std::min(kLeaf * leaf, order_.size());
  return order_.span().subspan(begin, std::min(kLeaf, order_.size() - begin));
}

void PointTree::insert(Index point) {
  is_in_[point] = true;
  for (std::size_t node = leaves_ + leaf_of_[point]; node > 0; node /= 2) {
    boxes_[node].add(points_[point]);
  }
}

void PointTree::erase(Index point) {
  is_in_[point] = false;
  std::size_t node = leaves_ + leaf_of_[point];
  Box box = empty_box();
  for (const Index other : points_of_leaf(leaf_of_[point])) {
    if (is_in_[other]) box.add(points_[other]);
  }
  for (boxes_[node] = box; (node /= 2) > 0; boxes_[node] = box) {
    const Box& a = boxes_[2 * node];
    const Box& b = boxes_[2 * node + 1];
    box = {std::min(a.min_u, b.min_u), std::max(a.max_u, b.max_u), std::min(a.min_v, b.min_v),
           std::max(a.max_v, b.max_v)};
  }
}

}  // namespace halfedge
