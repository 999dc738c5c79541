#include <halfedge/mend/hole_plan.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cmath>

namespace halfedge::mend {

namespace {

// The steps of what a fold costs: cosines of 30, 60, ... degrees.
constexpr double kSteps[] = {0.8660254, 0.5, 0, -0.5, -0.8660254};
constexpr int kFoldOfThin = 4;
// Vertices that a loop passes again and again are not worth more.
constexpr std::size_t kMaxForbidden = 1'000'000;

Vector unit(const Vector& a, double scale) {
  const double size = length(a);
  if (!(size > scale)) return {};
  return {a[0] / size, a[1] / size, a[2] / size};
}

// Newell's, of the face of `h`.
Vector face_normal(const Surface& surface, Halfedge h) {
  const Vector origin = point_of(surface, surface.to_vertex(h));
  Vector sum = {};
  double longest = 0;
  Vector last = {};
  for (Halfedge on_loop = surface.next(h); on_loop != h; on_loop = surface.next(on_loop)) {
    const Vector p = point_of(surface, surface.to_vertex(on_loop)) - origin;
    const Vector n = cross(last, p);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
    longest = std::max(longest, dot(p, p));
    last = p;
  }
  return unit(sum, kThin * longest);
}

}  // namespace

bool HolePlan::is_less(const Cost& a, const Cost& b) {
  return a.fold != b.fold ? a.fold < b.fold : a.rest < b.rest;
}

double HolePlan::cosine(const Vector& a, const Vector& b) {
  // Beside a face without a normal nothing can be told.
  if (dot(a, a) == 0 || dot(b, b) == 0) return 1;
  return dot(a, b);
}

void HolePlan::add_edge(Cost& cost, const Vector& a, const Vector& b, double edge_length) const {
  const double cos = cosine(a, b);
  int fold = 0;
  while (fold < 5 && cos < kSteps[fold]) ++fold;
  cost.fold = std::max(cost.fold, fold);
  cost.rest += 4 * (1 - cos) * edge_length;
}

// A thin triangle has the normal of what lies beyond its longer side, so that no fold hides behind
// it.
Vector HolePlan::normal_of(Index a, Index b, Index c, const Vector& beyond_ab,
                           const Vector& beyond_bc, Cost& cost) const {
  const Vector u = points_[b] - points_[a];
  const Vector v = points_[c] - points_[a];
  const Vector w = points_[c] - points_[b];
  const double longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
  const Vector normal = unit(cross(u, v), kThin * longest);
  if (dot(normal, normal) > 0) return normal;
  cost.fold = std::max(cost.fold, kFoldOfThin);
  const bool has_both = dot(beyond_ab, beyond_ab) > 0 && dot(beyond_bc, beyond_bc) > 0;
  if (has_both) return dot(u, u) >= dot(w, w) ? beyond_ab : beyond_bc;
  return dot(beyond_ab, beyond_ab) > 0 ? beyond_ab : beyond_bc;
}

// ---- the loop -------------------------------------------------------------------------------

bool HolePlan::read_loop(const Surface& surface, Halfedge first) {
  vertices_.clear();
  points_.clear();
  beyond_.clear();
  Halfedge h = first;
  do {
    const Halfedge after = surface.next(h);
    const Vertex v = surface.to_vertex(h);
    if (!vertices_.push_back(v) || !points_.push_back(point_of(surface, v)) ||
        !beyond_.push_back(face_normal(surface, Surface::opposite(after)))) {
      return false;
    }
    h = after;
  } while (h != first);
  return true;
}

// Lists the pairs of corners whose vertices are joined already, or the same.
bool HolePlan::list_forbidden(const Surface& surface) {
  const Index n = Index(vertices_.size());
  forbidden_.clear();
  if (!order_.resize(n)) return false;
  for (Index i = 0; i < n; ++i) order_[i] = {vertices_[i], i};
  introsort(order_.begin(), order_.end(), [](const Corner& a, const Corner& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.index < b.index;
  });
  const auto forbid = [&](Index corner, Vertex other) {
    const Corner* at = std::lower_bound(order_.begin(), order_.end(), other,
                                        [](const Corner& c, Vertex v) { return c.vertex < v; });
    for (; at != order_.end() && at->vertex == other; ++at) {
      const Diagonal pair{std::min(corner, at->index), std::max(corner, at->index)};
      if (pair.a == pair.b || pair.b - pair.a == 1 || pair.b - pair.a == n - 1) continue;
      if (forbidden_.size() > kMaxForbidden || !forbidden_.push_back(pair)) return false;
    }
    return true;
  };
  for (Index i = 0; i < n; ++i) {
    if (!forbid(i, vertices_[i])) return false;
    const Halfedge anchor = surface.halfedge(vertices_[i]);
    Halfedge out = anchor;
    do {
      if (!forbid(i, surface.to_vertex(out))) return false;
      out = surface.rotate_cw(out);
    } while (out != anchor);
  }
  introsort(forbidden_.begin(), forbidden_.end());
  return true;
}

bool HolePlan::is_forbidden(Index a, Index b) const {
  const Diagonal pair{std::min(a, b), std::max(a, b)};
  return std::binary_search(forbidden_.begin(), forbidden_.end(), pair);
}

// ---- cutting ears off -----------------------------------------------------------------------

void HolePlan::begin() {
  const std::size_t n = vertices_.size();
  for (std::size_t i = 0; i < n; ++i) {
    next_[i] = Index(i + 1 == n ? 0 : i + 1);
    prev_[i] = Index(i == 0 ? n - 1 : i - 1);
    side_[i] = beyond_[i];
    stamp_[i] = 0;
  }
}

void HolePlan::cut_off(Index corner, const Vector& normal) {
  const Index a = prev_[corner];
  const Index b = next_[corner];
  next_[a] = b;
  prev_[b] = a;
  side_[a] = normal;
  ++stamp_[a];
  ++stamp_[b];
  stamp_[corner] = kNone;
}

// Puts the ear at the corner on the heap, if it may be cut off.
bool HolePlan::look_at(Index corner) {
  const Index a = prev_[corner];
  const Index b = next_[corner];
  if (is_forbidden(a, b)) return true;
  Ear ear{.cost = {}, .corner = corner, .stamp = stamp_[corner]};
  const Vector normal = normal_of(a, corner, b, side_[a], side_[corner], ear.cost);
  add_edge(ear.cost, normal, side_[a], distance(a, corner));
  add_edge(ear.cost, normal, side_[corner], distance(corner, b));
  ear.cost.rest += distance(a, b);
  if (!heap_.push_back(ear)) return false;
  std::push_heap(heap_.begin(), heap_.end(),
                 [](const Ear& x, const Ear& y) { return is_less(y.cost, x.cost); });
  return true;
}

HolePlan::Outcome HolePlan::cut_ears() {
  heap_.clear();
  begin();
  std::size_t left = vertices_.size();
  for (Index i = 0; left > kExact && i < vertices_.size(); ++i) {
    if (!look_at(i)) return Outcome::kOutOfMemory;
  }
  Index start = 0;
  while (left > kExact) {
    if (heap_.empty()) return Outcome::kBlocked;
    std::pop_heap(heap_.begin(), heap_.end(),
                  [](const Ear& x, const Ear& y) { return is_less(y.cost, x.cost); });
    const Ear ear = heap_[heap_.size() - 1];
    heap_.pop_back();
    if (stamp_[ear.corner] != ear.stamp) continue;
    Cost cost;
    start = next_[ear.corner];
    const Index before = prev_[ear.corner];
    if (!ears_.push_back(ear.corner)) return Outcome::kOutOfMemory;
    cut_off(ear.corner,
            normal_of(before, ear.corner, start, side_[before], side_[ear.corner], cost));
    --left;
    if (!look_at(before) || !look_at(start)) return Outcome::kOutOfMemory;
  }
  rest_.clear();
  for (Index i = start; rest_.size() < left; i = next_[i]) (void)rest_.push_back(i);
  return Outcome::kDone;
}

// ---- choosing among all ---------------------------------------------------------------------

// The best triangle at the diagonal of two corners, on its side of those between.
void HolePlan::choose_between(std::size_t i, std::size_t j) {
  const std::size_t last = rest_.size() - 1;
  const bool is_whole = i == 0 && j == last;
  Choice& best = choice(i, j);
  best = {};
  if (!is_whole && is_forbidden(rest_[i], rest_[j])) return;
  const double base = is_whole ? 0 : distance(rest_[i], rest_[j]);
  for (std::size_t k = i + 1; k < j; ++k) {
    const Choice& left = choice(i, k);
    const Choice& right = choice(k, j);
    if (left.corner == kNone || right.corner == kNone) continue;
    const int fold = std::max(left.cost.fold, right.cost.fold);
    Cost cost{fold, left.cost.rest + right.cost.rest + base};
    if (best.corner != kNone && !is_less(cost, best.cost)) continue;
    const Vector normal = normal_of(rest_[i], rest_[k], rest_[j], left.normal, right.normal, cost);
    add_edge(cost, normal, left.normal, distance(rest_[i], rest_[k]));
    add_edge(cost, normal, right.normal, distance(rest_[k], rest_[j]));
    if (is_whole) add_edge(cost, normal, side_[rest_[last]], distance(rest_[i], rest_[j]));
    if (best.corner == kNone || is_less(cost, best.cost)) best = {cost, Index(k), normal};
  }
}

HolePlan::Outcome HolePlan::choose() {
  const std::size_t n = rest_.size();
  if (!choices_.resize(n * n)) return Outcome::kOutOfMemory;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    choice(i, i + 1) = {.cost = {}, .corner = Index(i), .normal = side_[rest_[i]]};
  }
  for (std::size_t gap = 2; gap < n; ++gap) {
    for (std::size_t i = 0; i + gap < n; ++i) choose_between(i, i + gap);
  }
  if (choice(0, n - 1).corner == kNone) return Outcome::kBlocked;
  if (!ears_.reserve(ears_.size() + n)) return Outcome::kOutOfMemory;
  list_ears(0, n - 1);
  ears_.pop_back();  // the last triangle is what is left
  return Outcome::kDone;
}

// As deep as there are corners, kExact at most.
void HolePlan::list_ears(std::size_t i, std::size_t j) {
  if (i + 1 == j) return;
  const std::size_t k = choice(i, j).corner;
  list_ears(i, k);
  list_ears(k, j);
  (void)ears_.push_back(rest_[k]);  // reserved
}

// ---- all of it ------------------------------------------------------------------------------

double HolePlan::worst_of(std::span<const Index> ears) {
  begin();
  double worst = 1;
  const auto look = [&](Index corner) {
    const Index a = prev_[corner];
    const Index b = next_[corner];
    Cost cost;
    const Vector normal = normal_of(a, corner, b, side_[a], side_[corner], cost);
    worst = std::min({worst, cosine(normal, side_[a]), cosine(normal, side_[corner])});
    if (next_[b] == a) worst = std::min(worst, cosine(normal, side_[b]));
    return normal;
  };
  Index left = 0;
  for (const Index corner : ears) {
    left = next_[corner];
    cut_off(corner, look(corner));
  }
  (void)look(left);
  return worst;
}

// Replaces the plan by that of the polygon, if that is flatter. False when memory is exhausted.
bool HolePlan::try_planar() {
  Array<Point> points;
  Array<Index> ears;
  for (const Vector& p : points_) {
    if (!points.push_back({float(p[0]), float(p[1]), float(p[2])})) return false;
  }
  const auto outcome = triangulator_.run(points.span(), forbidden_.span(), ears);
  if (outcome == PolygonTriangulator::Outcome::kOutOfMemory) return false;
  if (outcome == PolygonTriangulator::Outcome::kBlocked) return true;
  const double worst = worst_of(ears.span());
  if (worst <= worst_) return true;
  // It avoids what is forbidden if it can, but doesn't promise to.
  begin();
  for (const Index corner : ears) {
    if (is_forbidden(prev_[corner], next_[corner])) return true;
    cut_off(corner, {});
  }
  worst_ = worst;
  return ears_.assign(ears.span());
}

HolePlan::Outcome HolePlan::plan() {
  ears_.clear();
  const Outcome cut = cut_ears();
  if (cut == Outcome::kOutOfMemory) return cut;
  const Outcome chosen = cut == Outcome::kDone ? choose() : cut;
  if (chosen == Outcome::kOutOfMemory) return chosen;
  worst_ = chosen == Outcome::kDone ? worst_of(ears_.span()) : -2;
  const bool is_large = vertices_.size() > kExact && vertices_.size() <= kPlanar;
  if (is_large && !try_planar()) return Outcome::kOutOfMemory;
  return worst_ < -1.5 ? Outcome::kBlocked : Outcome::kDone;
}

// Where a loop passes a vertex more than once, two diagonals may join the same two: one of them is
// forbidden then.
HolePlan::Outcome HolePlan::forbid_repeated(bool& is_repeated) {
  struct Join {
    Vertex a;
    Vertex b;
    Diagonal diagonal;
  };
  Array<Join> joins;
  begin();
  for (const Index corner : ears_) {
    const Diagonal d{std::min(prev_[corner], next_[corner]),
                     std::max(prev_[corner], next_[corner])};
    const Vertex a = vertices_[d.a];
    const Vertex b = vertices_[d.b];
    if (!joins.push_back({std::min(a, b), std::max(a, b), d})) return Outcome::kOutOfMemory;
    cut_off(corner, {});
  }
  introsort(joins.begin(), joins.end(), [](const Join& x, const Join& y) {
    if (x.a != y.a) return x.a < y.a;
    return x.b != y.b ? x.b < y.b : x.diagonal < y.diagonal;
  });
  is_repeated = false;
  for (std::size_t i = 1; i < joins.size(); ++i) {
    if (joins[i].a != joins[i - 1].a || joins[i].b != joins[i - 1].b) continue;
    is_repeated = true;
    if (!forbidden_.push_back(joins[i].diagonal)) return Outcome::kOutOfMemory;
  }
  introsort(forbidden_.begin(), forbidden_.end());
  return Outcome::kDone;
}

HolePlan::Outcome HolePlan::run(const Surface& surface, Halfedge first) {
  if (!read_loop(surface, first)) return Outcome::kOutOfMemory;
  const std::size_t n = vertices_.size();
  if (!next_.resize(n) || !prev_.resize(n) || !stamp_.resize(n) || !side_.resize(n) ||
      !rest_.reserve(kExact)) {
    return Outcome::kOutOfMemory;
  }
  if (!list_forbidden(surface)) {
    return forbidden_.size() > kMaxForbidden ? Outcome::kBlocked : Outcome::kOutOfMemory;
  }
  constexpr int kTries = 8;
  for (int i = 0; i < kTries; ++i) {
    Outcome outcome = plan();
    if (outcome != Outcome::kDone) return outcome;
    bool is_repeated = false;
    outcome = forbid_repeated(is_repeated);
    if (outcome != Outcome::kDone || !is_repeated) return outcome;
  }
  return Outcome::kBlocked;
}

}  // namespace halfedge::mend
