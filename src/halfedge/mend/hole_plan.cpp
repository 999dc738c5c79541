#include <halfedge/mend/hole_plan.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <utility>

namespace halfedge::mend {

namespace {

// Vertices that a loop passes again and again are not worth more.
constexpr std::size_t kMaxForbidden = 1'000'000;

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
  return unit_vector(sum, kThin * longest);
}

}  // namespace

// Of the face beyond a side. A large face has many of them, so that its normal is kept. False when
// memory is exhausted.
bool HolePlan::find_normal(Halfedge h, Vector& normal) {
  const Index f = surface_.face(h).index();
  if (f >= known_.size() && !known_.resize(surface_.face_slots(), kNone)) return false;
  if (known_[f] == kNone) {
    known_[f] = Index(normals_.size());
    if (!normals_.push_back(face_normal(surface_, h))) return false;
  }
  normal = normals_[known_[f]];
  return true;
}

bool HolePlan::read_loop(Halfedge first) {
  Hole& hole = triangles_.hole();
  vertices_.clear();
  hole.points.clear();
  hole.beyond.clear();
  Halfedge h = first;
  do {
    const Halfedge after = surface_.next(h);
    const Vertex v = surface_.to_vertex(h);
    const Halfedge o = Surface::opposite(after);
    Vector normal = {};
    if ((!surface_.is_boundary(o) && !find_normal(o, normal)) || !vertices_.push_back(v) ||
        !hole.points.push_back(point_of(surface_, v)) || !hole.beyond.push_back(normal)) {
      return false;
    }
    h = after;
  } while (h != first);
  return true;
}

// Lists the pairs of corners whose vertices are joined already, or the same.
bool HolePlan::list_forbidden() {
  Hole& hole = triangles_.hole();
  const Index n = Index(vertices_.size());
  hole.forbidden.clear();
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
      if (hole.forbidden.size() > kMaxForbidden || !hole.forbidden.push_back(pair)) return false;
    }
    return true;
  };
  for (Index i = 0; i < n; ++i) {
    if (!forbid(i, vertices_[i])) return false;
    const Halfedge anchor = surface_.halfedge(vertices_[i]);
    Halfedge out = anchor;
    do {
      if (!forbid(i, surface_.to_vertex(out))) return false;
      out = surface_.rotate_cw(out);
    } while (out != anchor);
  }
  introsort(hole.forbidden.begin(), hole.forbidden.end());
  return true;
}

// Replaces the plan by that of the polygon, if that is flatter. False when memory is exhausted.
bool HolePlan::try_planar() {
  const Hole& hole = triangles_.hole();
  Array<Point> points;
  Array<Index> ears;
  for (const Vector& p : hole.points) {
    if (!points.push_back({float(p[0]), float(p[1]), float(p[2])})) return false;
  }
  const auto outcome = triangulator_.run(points.span(), hole.forbidden.span(), ears);
  if (outcome == PolygonTriangulator::Outcome::kOutOfMemory) return false;
  if (outcome == PolygonTriangulator::Outcome::kBlocked) return true;
  const double worst = triangles_.worst_of(ears.span());
  if (worst <= worst_) return true;
  // It avoids what is forbidden if it can, but doesn't promise to.
  const auto is_allowed = [&](const Diagonal& diagonal) { return !hole.forbids(diagonal); };
  if (!triangles_.for_each_diagonal(ears.span(), is_allowed)) return true;
  worst_ = worst;
  return ears_.assign(ears.span());
}

HolePlan::Outcome HolePlan::plan() {
  const Outcome chosen = triangles_.choose(ears_);
  if (chosen == Outcome::kOutOfMemory) return chosen;
  worst_ = chosen == Outcome::kDone ? triangles_.worst_of(ears_.span()) : kNoPlan;
  const bool is_large = vertices_.size() > HoleTriangles::kExact && vertices_.size() <= kPlanar;
  if (is_large && !try_planar()) return Outcome::kOutOfMemory;
  return worst_ == kNoPlan ? Outcome::kBlocked : Outcome::kDone;
}

// Where a loop passes a vertex more than once, two diagonals may join the same two: one of them is
// forbidden then.
HolePlan::Outcome HolePlan::forbid_repeated(bool& is_repeated) {
  Hole& hole = triangles_.hole();
  struct Join {
    Vertex a;
    Vertex b;
    Diagonal diagonal;
  };
  Array<Join> joins;
  const bool fits = triangles_.for_each_diagonal(ears_.span(), [&](const Diagonal& diagonal) {
    const Vertex a = vertices_[diagonal.a];
    const Vertex b = vertices_[diagonal.b];
    return joins.push_back({std::min(a, b), std::max(a, b), diagonal});
  });
  if (!fits) return Outcome::kOutOfMemory;
  introsort(joins.begin(), joins.end(), [](const Join& x, const Join& y) {
    if (x.a != y.a) return x.a < y.a;
    return x.b != y.b ? x.b < y.b : x.diagonal < y.diagonal;
  });
  is_repeated = false;
  for (std::size_t i = 1; i < joins.size(); ++i) {
    if (joins[i].a != joins[i - 1].a || joins[i].b != joins[i - 1].b) continue;
    is_repeated = true;
    if (!hole.forbidden.push_back(joins[i].diagonal)) return Outcome::kOutOfMemory;
  }
  introsort(hole.forbidden.begin(), hole.forbidden.end());
  return Outcome::kDone;
}

HolePlan::Outcome HolePlan::run(Halfedge first, std::size_t& joins) {
  if (!read_loop(first) || !triangles_.prepare()) return Outcome::kOutOfMemory;
  const bool is_listed = list_forbidden();
  const std::size_t before = std::exchange(joins, triangles_.hole().forbidden.size());
  if (!is_listed && joins <= kMaxForbidden) return Outcome::kOutOfMemory;
  if (joins == before) return Outcome::kSame;
  if (!is_listed) return Outcome::kBlocked;
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
