#include <halfedge/mend/hole_plan.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

// What a triangle costs, and the two ways in which HolePlan chooses some.
namespace halfedge::mend {

namespace {

// The steps of what a fold costs: cosines of 30, 60, ... degrees.
constexpr double kSteps[] = {0.8660254, 0.5, 0, -0.5, -0.8660254};
constexpr double kFoldOfThin = kSteps[3];

}  // namespace

// Whether a fold is sharper than is allowed is a step of its own, so that none is chosen that is
// where another isn't.
HolePlan::HolePlan(const Surface& surface, double max_angle) : surface_(surface) {
  std::copy(std::begin(kSteps), std::end(kSteps), steps_.begin());
  steps_.back() = std::cos(max_angle / kDegreesPerRadian);
  std::sort(steps_.begin(), steps_.end(), std::greater<>());
}

int HolePlan::steps_to(double cosine) const {
  int steps = 0;
  for (const double step : steps_) steps += cosine < step ? 1 : 0;
  return steps;
}

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
  cost.fold = std::max(cost.fold, steps_to(cos));
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
  const Vector normal = unit_vector(cross(u, v), kThin * longest);
  if (dot(normal, normal) > 0) return normal;
  cost.fold = std::max(cost.fold, steps_to(std::nextafter(kFoldOfThin, -1)));
  const bool has_both = dot(beyond_ab, beyond_ab) > 0 && dot(beyond_bc, beyond_bc) > 0;
  if (has_both) return dot(u, u) >= dot(w, w) ? beyond_ab : beyond_bc;
  return dot(beyond_ab, beyond_ab) > 0 ? beyond_ab : beyond_bc;
}

// ---- cutting ears off -----------------------------------------------------------------------

void HolePlan::begin_cutting() {
  make_ring(next_, prev_);
  std::copy(beyond_.begin(), beyond_.end(), side_.begin());
  std::fill(stamp_.begin(), stamp_.end(), 0);
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
  std::push_heap(heap_.begin(), heap_.end(), CostsMore());
  return true;
}

HolePlan::Outcome HolePlan::cut_ears() {
  heap_.clear();
  begin_cutting();
  std::size_t left = vertices_.size();
  for (Index i = 0; left > kExact && i < vertices_.size(); ++i) {
    if (!look_at(i)) return Outcome::kOutOfMemory;
  }
  Index start = 0;
  while (left > kExact) {
    if (heap_.empty()) return Outcome::kBlocked;
    std::pop_heap(heap_.begin(), heap_.end(), CostsMore());
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

}  // namespace halfedge::mend
