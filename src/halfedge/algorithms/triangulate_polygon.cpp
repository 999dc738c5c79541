#include <halfedge/algorithms/projection.h>
#include <halfedge/algorithms/quad.h>
#include <halfedge/algorithms/triangulate_polygon.h>

#include <algorithm>
#include <utility>

namespace halfedge {

namespace {

/// Of corners, where there is no ear; 0 is that of one whose diagonal is forbidden.
enum Rank : std::uint8_t { kRight = 1, kLeft = 2, kFlat = 3 };

}  // namespace

void make_ring(Array<Index>& next, Array<Index>& prev) {
  const std::size_t n = next.size();
  for (std::size_t i = 0; i < n; ++i) {
    next[i] = Index(i + 1 == n ? 0 : i + 1);
    prev[i] = Index(i == 0 ? n - 1 : i - 1);
  }
}

bool PolygonTriangulator::project_points() {
  if (!planar_.recreate(points_.size())) return false;
  const Projection projection(points_);
  for (std::size_t i = 0; i < points_.size(); ++i) planar_[i] = projection(points_[i]);
  return true;
}

int PolygonTriangulator::turn(Index a, Index b, Index c) const {
  return turn_of(planar_[a], planar_[b], planar_[c]);
}

double PolygonTriangulator::distance(Index a, Index b) const {
  return diagonal_length(points_[a], points_[b]);
}

bool PolygonTriangulator::is_forbidden(Index a, Index b) const {
  if (forbidden_.empty()) return false;
  const Diagonal diagonal = a < b ? Diagonal{a, b} : Diagonal{b, a};
  return std::binary_search(forbidden_.begin(), forbidden_.end(), diagonal);
}

PolygonTriangulator::Outcome PolygonTriangulator::run(std::span<const Point> points,
                                                      std::span<const Diagonal> forbidden,
                                                      Array<Index>& ears) {
  points_ = points;
  forbidden_ = forbidden;
  const std::size_t before = ears.size();
  const Outcome outcome = cut(ears);
  if (outcome != Outcome::kDone) (void)ears.resize(before);
  return outcome;
}

PolygonTriangulator::Outcome PolygonTriangulator::cut(Array<Index>& ears) {
  const std::size_t n = points_.size();
  if (n == 4 && forbidden_.empty()) {
    return ears.push_back(ear_of_quad(points_.first<4>())) ? Outcome::kDone : Outcome::kOutOfMemory;
  }
  if (!project_points() || !ears.reserve(ears.size() + n)) return Outcome::kOutOfMemory;
  if (n > kSmall) {
    if (const Outcome outcome = cut_to_few(ears); outcome != Outcome::kDone) return outcome;
  }
  rest_.clear();
  if (!rest_.reserve(kSmall) || !choices_.reserve(kSmall * kSmall)) return Outcome::kOutOfMemory;
  const std::size_t left = std::min(n, kSmall);
  Index corner = start_;
  for (std::size_t i = 0; i < left; ++i) {
    (void)rest_.push_back(left == n ? Index(i) : corner);
    if (left < n) corner = next_[corner];
  }
  if (!choose_diagonals()) return Outcome::kBlocked;
  list_ears(0, left - 1, ears);
  ears.pop_back();  // the last three corners are left
  return Outcome::kDone;
}

// ---- few corners ------------------------------------------------------------------------------

// What the diagonal between corners i and j costs; a side of the polygon costs nothing.
PolygonTriangulator::Cost PolygonTriangulator::side_cost(std::size_t i, std::size_t j) {
  if (j - i == 1 || j - i + 1 == rest_.size()) return {};
  return {is_forbidden(rest_[i], rest_[j]) ? Cost::kForbidden : 0, distance(rest_[i], rest_[j])};
}

// A simple polygon cut into triangles which all turn left isn't covered twice anywhere, so that
// nothing needs to be known of crossings. (Klincsek, Minimal triangulations of polygonal domains,
// 1980)
bool PolygonTriangulator::choose_diagonals() {
  const std::size_t n = rest_.size();
  (void)choices_.resize(kSmall * kSmall);  // reserved
  for (std::size_t i = 0; i + 1 < n; ++i) choice(i, i + 1) = {};
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t j = i + span;
      Choice best;
      for (std::size_t k = i + 1; k < j; ++k) {
        const int turns = turn(rest_[i], rest_[k], rest_[j]);
        Cost cost = choice(i, k).cost + choice(k, j).cost;
        cost.faults += turns < 0 ? Cost::kFlip : turns == 0 ? Cost::kFlat : 0;
        if (best.corner == kNone || cost < best.cost) best = {cost, Index(k)};
      }
      best.cost = best.cost + side_cost(i, j);
      choice(i, j) = best;
    }
  }
  if (!choice(0, n - 1).cost.has_forbidden()) return true;
  find_blocked(0, n - 1);
  return false;
}

void PolygonTriangulator::list_ears(std::size_t i, std::size_t j, Array<Index>& ears) {
  if (j - i < 2) return;
  const std::size_t k = choice(i, j).corner;
  list_ears(i, k, ears);
  list_ears(k, j, ears);
  (void)ears.push_back(rest_[k]);  // in the room made by run
}

void PolygonTriangulator::find_blocked(std::size_t i, std::size_t j) {
  if (j - i < 2) return;
  if (side_cost(i, j).has_forbidden()) {
    blocked_ = {std::min(rest_[i], rest_[j]), std::max(rest_[i], rest_[j])};
    return;
  }
  const std::size_t k = choice(i, j).corner;
  const bool is_before = choice(i, k).cost.has_forbidden();
  find_blocked(is_before ? i : k, is_before ? k : j);
}

// ---- many corners -----------------------------------------------------------------------------

// Until kSmall corners are left.
PolygonTriangulator::Outcome PolygonTriangulator::cut_to_few(Array<Index>& ears) {
  if (!begin_cutting()) return Outcome::kOutOfMemory;
  for (std::size_t left = points_.size(); left > kSmall; --left) {
    Index corner = best_ear();
    if (corner == kNone) {
      if (!is_ranked_ && !rank_corners()) return Outcome::kOutOfMemory;
      corner = any_corner();
    }
    if (corner == kNone) return Outcome::kBlocked;
    (void)ears.push_back(corner);  // in the room made by cut
    if (!cut_off(corner)) return Outcome::kOutOfMemory;
  }
  return Outcome::kDone;
}

bool PolygonTriangulator::begin_cutting() {
  const std::size_t n = points_.size();
  if (!next_.recreate(n) || !prev_.recreate(n) || !stamp_.recreate(n) ||
      !concave_.build(std::as_const(planar_).span())) {
    return false;
  }
  ears_.clear();
  start_ = 0;
  is_ranked_ = false;
  blocked_ = {};
  make_ring(next_, prev_);
  std::fill(stamp_.begin(), stamp_.end(), 0);
  for (Index i = 0; i < n; ++i) {
    if (turn(prev_[i], i, next_[i]) <= 0) concave_.insert(i);
  }
  for (Index i = 0; i < n; ++i) {
    if (!look_at(i)) return false;
  }
  return true;
}

// Whether corner w, which lies where `corner` does, has a neighbour strictly between the two sides
// of the triangle there.
bool PolygonTriangulator::enters(Index w, Index corner, Index following, Index before) const {
  for (const Index neighbour : {prev_[w], next_[w]}) {
    if (turn(corner, following, neighbour) > 0 && turn(corner, before, neighbour) < 0) return true;
  }
  return false;
}

// Whether corner w keeps the triangle a, b, c, which turns left, from being cut off.
bool PolygonTriangulator::lies_inside(Index w, Index a, Index b, Index c) const {
  const int of_ab = turn(a, b, w);
  if (of_ab < 0) return false;
  const int of_bc = turn(b, c, w);
  if (of_bc < 0) return false;
  const int of_ca = turn(c, a, w);
  if (of_ca < 0) return false;
  if (of_ab > 0 && of_bc > 0) return true;  // inside, or on the diagonal
  if (planar_[w] == planar_[a]) return enters(w, a, b, c);
  if (planar_[w] == planar_[b]) return enters(w, b, c, a);
  if (planar_[w] == planar_[c]) return enters(w, c, a, b);
  // On a side: touching it from outside is no harm.
  const Index from = of_ab == 0 ? a : b;
  const Index to = of_ab == 0 ? b : c;
  return turn(from, to, prev_[w]) > 0 || turn(from, to, next_[w]) > 0;
}

// If anything lies inside, a concave corner does: the one farthest from the diagonal.
bool PolygonTriangulator::is_ear(Index corner) {
  const Index a = prev_[corner];
  const Index c = next_[corner];
  if (turn(a, corner, c) <= 0) return false;
  return !concave_.any_in({planar_[a], planar_[corner], planar_[c]}, [&](Index w) {
    return w != a && w != corner && w != c && lies_inside(w, a, corner, c);
  });
}

// Puts a corner among the ears if it is one now. False when memory is exhausted.
bool PolygonTriangulator::look_at(Index corner) {
  if (!is_ear(corner)) return true;
  if (is_forbidden(prev_[corner], next_[corner])) {
    const Index a = prev_[corner];
    const Index b = next_[corner];
    blocked_ = {std::min(a, b), std::max(a, b)};
    return true;
  }
  if (!ears_.push_back({distance(prev_[corner], next_[corner]), corner, stamp_[corner]})) {
    return false;
  }
  std::push_heap(ears_.begin(), ears_.end(), CutsLonger());
  return true;
}

Index PolygonTriangulator::best_ear() {
  while (!ears_.empty()) {
    std::pop_heap(ears_.begin(), ears_.end(), CutsLonger());
    const Ear ear = ears_[ears_.size() - 1];
    ears_.pop_back();
    if (ear.stamp == stamp_[ear.corner]) return ear.corner;
  }
  return kNone;
}

bool PolygonTriangulator::cut_off(Index corner) {
  const Index a = prev_[corner];
  const Index b = next_[corner];
  next_[a] = b;
  prev_[b] = a;
  ++stamp_[corner];
  if (concave_.contains(corner)) concave_.erase(corner);
  start_ = b;
  if (is_ranked_) ranks_.set(corner, 0);
  for (const Index neighbour : {a, b}) {
    ++stamp_[neighbour];
    if (is_ranked_) rank(neighbour);
    const bool is_concave = turn(prev_[neighbour], neighbour, next_[neighbour]) <= 0;
    if (is_concave == concave_.contains(neighbour)) continue;
    is_concave ? concave_.insert(neighbour) : concave_.erase(neighbour);
  }
  return look_at(a) && look_at(b);
}

// ---- no ear -----------------------------------------------------------------------------------

// Where a polygon crosses itself, or has no area, there may be no ear: a corner on a line then, or
// one that turns left, or just any. The first of them from `start_` on.
Index PolygonTriangulator::any_corner() const {
  const int highest = ranks_.highest();
  if (highest < kFlat && blocked_.a != kNone) return kNone;
  return ranks_.next(start_, highest);
}

bool PolygonTriangulator::rank_corners() {
  if (!ranks_.build(points_.size())) return false;
  is_ranked_ = true;
  Index corner = start_;
  do {
    rank(corner);
    corner = next_[corner];
  } while (corner != start_);
  return true;
}

void PolygonTriangulator::rank(Index corner) {
  const Index a = prev_[corner];
  const Index b = next_[corner];
  const int turns = turn(a, corner, b);
  const int free = turns == 0 ? kFlat : turns > 0 ? kLeft : kRight;
  ranks_.set(corner, is_forbidden(a, b) ? 0 : free);
}

}  // namespace halfedge
