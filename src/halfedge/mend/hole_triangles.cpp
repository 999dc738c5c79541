#include <halfedge/mend/hole_triangles.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace halfedge::mend {

namespace {

// The steps of what a fold costs: cosines of 30, 60, ... degrees.
constexpr double kSteps[] = {0.8660254, 0.5, 0, -0.5, -0.8660254};
constexpr double kFoldOfThin = kSteps[3];

}  // namespace

bool Hole::forbids(const Diagonal& diagonal) const {
  return std::binary_search(forbidden.begin(), forbidden.end(), diagonal);
}

// Whether a fold is sharper than is allowed is a step of its own, so that none is chosen that is
// where another isn't.
HoleTriangles::HoleTriangles(double max_angle) {
  std::copy(std::begin(kSteps), std::end(kSteps), steps_.begin());
  steps_.back() = std::cos(max_angle / kDegreesPerRadian);
  std::sort(steps_.begin(), steps_.end(), std::greater<>());
}

bool HoleTriangles::prepare() {
  const std::size_t n = hole_.points.size();
  return next_.resize(n) && prev_.resize(n) && stamp_.resize(n) && side_.resize(n) &&
         rest_.reserve(kExact);
}

HoleOutcome HoleTriangles::choose(Array<Index>& ears) {
  ears.clear();
  const HoleOutcome cut = cut_ears(ears);
  return cut == HoleOutcome::kDone ? choose_among_all(ears) : cut;
}

int HoleTriangles::steps_to(double cosine) const {
  int steps = 0;
  for (const double step : steps_) steps += cosine < step ? 1 : 0;
  return steps;
}

bool HoleTriangles::is_less(const Cost& a, const Cost& b) {
  return a.fold != b.fold ? a.fold < b.fold : a.rest < b.rest;
}

double HoleTriangles::cosine(const Vector& a, const Vector& b) {
  // Beside a face without a normal nothing can be told.
  if (dot(a, a) == 0 || dot(b, b) == 0) return 1;
  return dot(a, b);
}

void HoleTriangles::add_edge(Cost& cost, const Vector& a, const Vector& b,
                             double edge_length) const {
  const double cos = cosine(a, b);
  cost.fold = std::max(cost.fold, steps_to(cos));
  cost.rest += 4 * (1 - cos) * edge_length;
}

// A thin triangle has the normal of what lies beyond its longer side, so that no fold hides behind
// it.
Vector HoleTriangles::normal_of(Index a, Index b, Index c, const Vector& beyond_ab,
                                const Vector& beyond_bc, Cost& cost) const {
  const Vector u = hole_.points[b] - hole_.points[a];
  const Vector v = hole_.points[c] - hole_.points[a];
  const Vector w = hole_.points[c] - hole_.points[b];
  const double longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
  const Vector normal = unit_vector(cross(u, v), kThin * longest);
  if (dot(normal, normal) > 0) return normal;
  cost.fold = std::max(cost.fold, steps_to(std::nextafter(kFoldOfThin, -1)));
  const bool has_both = dot(beyond_ab, beyond_ab) > 0 && dot(beyond_bc, beyond_bc) > 0;
  if (has_both) return dot(u, u) >= dot(w, w) ? beyond_ab : beyond_bc;
  return dot(beyond_ab, beyond_ab) > 0 ? beyond_ab : beyond_bc;
}

// ---- cutting ears off -----------------------------------------------------------------------

void HoleTriangles::begin_cutting() {
  make_ring(next_, prev_);
  std::copy(hole_.beyond.begin(), hole_.beyond.end(), side_.begin());
  std::fill(stamp_.begin(), stamp_.end(), 0);
}

void HoleTriangles::cut_off(Index corner, const Vector& normal) {
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
bool HoleTriangles::look_at(Index corner) {
  const Index a = prev_[corner];
  const Index b = next_[corner];
  if (hole_.forbids(diagonal(a, b))) return true;
  Ear ear{.cost = {}, .corner = corner, .stamp = stamp_[corner]};
  const Vector normal = normal_of(a, corner, b, side_[a], side_[corner], ear.cost);
  add_edge(ear.cost, normal, side_[a], distance(a, corner));
  add_edge(ear.cost, normal, side_[corner], distance(corner, b));
  ear.cost.rest += distance(a, b);
  if (!heap_.push_back(ear)) return false;
  std::push_heap(heap_.begin(), heap_.end(), CostsMore());
  return true;
}

HoleOutcome HoleTriangles::cut_ears(Array<Index>& ears) {
  heap_.clear();
  begin_cutting();
  std::size_t left = hole_.points.size();
  for (Index i = 0; left > kExact && i < hole_.points.size(); ++i) {
    if (!look_at(i)) return HoleOutcome::kOutOfMemory;
  }
  Index start = 0;
  while (left > kExact) {
    if (heap_.empty()) return HoleOutcome::kBlocked;
    std::pop_heap(heap_.begin(), heap_.end(), CostsMore());
    const Ear ear = heap_[heap_.size() - 1];
    heap_.pop_back();
    if (stamp_[ear.corner] != ear.stamp) continue;
    Cost cost;
    start = next_[ear.corner];
    const Index before = prev_[ear.corner];
    if (!ears.push_back(ear.corner)) return HoleOutcome::kOutOfMemory;
    cut_off(ear.corner,
            normal_of(before, ear.corner, start, side_[before], side_[ear.corner], cost));
    --left;
    if (!look_at(before) || !look_at(start)) return HoleOutcome::kOutOfMemory;
  }
  rest_.clear();
  for (Index i = start; rest_.size() < left; i = next_[i]) (void)rest_.push_back(i);
  return HoleOutcome::kDone;
}

double HoleTriangles::worst_of(std::span<const Index> ears) {
  begin_cutting();
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

// ---- choosing among all ---------------------------------------------------------------------

// The best triangle at the diagonal of two corners, on its side of those between.
void HoleTriangles::choose_between(std::size_t i, std::size_t j) {
  const std::size_t last = rest_.size() - 1;
  const bool is_whole = i == 0 && j == last;
  Choice& best = choice(i, j);
  best = {};
  if (!is_whole && hole_.forbids(diagonal(rest_[i], rest_[j]))) return;
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

HoleOutcome HoleTriangles::choose_among_all(Array<Index>& ears) {
  const std::size_t n = rest_.size();
  if (!choices_.resize(n * n)) return HoleOutcome::kOutOfMemory;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    choice(i, i + 1) = {.cost = {}, .corner = Index(i), .normal = side_[rest_[i]]};
  }
  for (std::size_t gap = 2; gap < n; ++gap) {
    for (std::size_t i = 0; i + gap < n; ++i) choose_between(i, i + gap);
  }
  if (choice(0, n - 1).corner == kNone) return HoleOutcome::kBlocked;
  if (!ears.reserve(ears.size() + n)) return HoleOutcome::kOutOfMemory;
  list_ears(0, n - 1, ears);
  ears.pop_back();  // the last triangle is what is left
  return HoleOutcome::kDone;
}

// As deep as there are corners, kExact at most.
void HoleTriangles::list_ears(std::size_t i, std::size_t j, Array<Index>& ears) {
  if (i + 1 == j) return;
  const std::size_t k = choice(i, j).corner;
  list_ears(i, k, ears);
  list_ears(k, j, ears);
  (void)ears.push_back(rest_[k]);  // reserved
}

}  // namespace halfedge::mend
