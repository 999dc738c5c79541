#include <halfedge/repair/soup.h>
#include <halfedge/sort.h>
#include <halfedge/vector.h>

#include <algorithm>
#include <cmath>

namespace halfedge::repair {

namespace {

// Joins the sides of an edge with more than two faces, by twos that run opposite ways.
class CrowdMatcher {
 public:
  CrowdMatcher(Surface& surface, const Crowds& crowds) : surface_(surface), crowds_(crowds) {}

  [[nodiscard]] bool run() {
    if (!partner_.resize(crowds_.sides.size(), kNone) || !find_normals()) return false;
    Index begin = 0;
    for (const Index end : crowds_.end) {
      begin_ = begin;
      sides_ = crowds_.sides.span().subspan(begin, end - begin);
      if (!match_edge()) return false;
      begin = end;
    }
    // Not before: what ends a fan must be the same for all edges, in whatever order they come.
    for (std::size_t i = 0; i < partner_.size(); ++i) {
      if (partner_[i] != kNone) surface_.mate[crowds_.sides[i]] = partner_[i];
    }
    return true;
  }

 private:
  [[nodiscard]] bool match_edge() {
    const Index low = std::min(surface_.from(sides_[0]), surface_.to(sides_[0]));
    const Index high = std::max(surface_.from(sides_[0]), surface_.to(sides_[0]));
    if (!at_low_.recreate(sides_.size()) || !at_high_.recreate(sides_.size())) return false;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      at_low_[i] = place_of(end_of_fan(sides_[i], low));
      at_high_[i] = place_of(end_of_fan(sides_[i], high));
    }
    // Faces that close a fan at both ends of the edge belong together, then those at one.
    for (Index i = 0; i < sides_.size(); ++i) {
      if (at_low_[i] != kNone && at_low_[i] == at_high_[i]) join(i, at_low_[i]);
    }
    for (Index i = 0; i < sides_.size(); ++i) {
      if (at_low_[i] != kNone) join(i, at_low_[i]);
      if (at_high_[i] != kNone) join(i, at_high_[i]);
    }
    return join_by_angle(low, high);
  }

  void join(Index i, Index j) {
    if (!is_free(i) || !is_free(j) || i == j) return;
    if (surface_.runs_up(sides_[i]) == surface_.runs_up(sides_[j])) return;
    partner_[begin_ + i] = sides_[j];
    partner_[begin_ + j] = sides_[i];
  }
  [[nodiscard]] bool is_free(Index i) const { return partner_[begin_ + i] == kNone; }

  // The side at which the fan at `vertex` ends that begins with `side`.
  [[nodiscard]] Index end_of_fan(Index side, Index vertex) const {
    Index corner = surface_.corner_at(side, vertex);
    for (;;) {
      side = surface_.other_side(corner, side);
      const Index mate = surface_.mate[side];
      if (mate == kNone) return side;
      corner = surface_.corner_at(mate, vertex);
      side = mate;
    }
  }
  // Among the sides of the edge, which are in ascending order.
  [[nodiscard]] Index place_of(Index side) const {
    const auto found = std::lower_bound(sides_.begin(), sides_.end(), side);
    return found != sides_.end() && *found == side ? Index(found - sides_.begin()) : kNone;
  }

  // ---- by angle

  struct Leaf {
    double angle;
    Index place;
  };

  // Going around the edge counter-clockwise, seen from its larger vertex, a face that runs up has
  // the solid behind it, one that runs down before it: they are like closing and opening brackets,
  // in a circle.
  [[nodiscard]] bool join_by_angle(Index low, Index high) {
    leaves_.clear();
    for (Index i = 0; i < sides_.size(); ++i) {
      if (is_free(i) && !leaves_.push_back({0, i})) return false;
    }
    if (leaves_.size() < 2) return true;
    find_angles(vector(low, high));
    introsort(leaves_.begin(), leaves_.end(), [](const Leaf& a, const Leaf& b) {
      return a.angle != b.angle ? a.angle < b.angle : a.place < b.place;
    });
    Array<Index> open;
    for (int round = 0; round < 2; ++round) {
      for (const Leaf& leaf : leaves_) {
        if (!is_free(leaf.place)) continue;
        if (surface_.runs_up(sides_[leaf.place])) {
          if (open.empty()) continue;
          join(open[open.size() - 1], leaf.place);
          open.pop_back();
        } else if (round == 0 && !open.push_back(leaf.place)) {
          return false;
        }
      }
    }
    return true;
  }

  void find_angles(const Vector& axis) {
    std::size_t least = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(axis[k]) < std::abs(axis[least])) least = k;
    }
    Vector other{};
    other[least] = 1;
    const Vector e1 = cross(axis, other);
    const double length = std::sqrt(dot(axis, axis));
    const Vector e2 = cross(axis, e1);  // longer than e1 by `length`
    for (Leaf& leaf : leaves_) {
      const Vector into = into_face(sides_[leaf.place]);
      leaf.angle = std::atan2(dot(into, e2), dot(into, e1) * length);
      if (!std::isfinite(leaf.angle)) leaf.angle = 0;
    }
  }

  // From the side into its face, perpendicular to the side.
  [[nodiscard]] Vector into_face(Index side) const {
    const Index* const f = std::lower_bound(faces_.begin(), faces_.end(), surface_.face_of[side]);
    return cross(normals_[std::size_t(f - faces_.begin())],
                 vector(surface_.from(side), surface_.to(side)));
  }
  // Once for each face, which may have any number of sides here.
  [[nodiscard]] bool find_normals() {
    if (!faces_.reserve(crowds_.sides.size())) return false;
    for (const Index side : crowds_.sides) (void)faces_.push_back(surface_.face_of[side]);
    introsort(faces_.begin(), faces_.end());
    (void)faces_.resize(std::size_t(std::unique(faces_.begin(), faces_.end()) - faces_.begin()));
    if (!normals_.reserve(faces_.size())) return false;
    for (const Index f : faces_) (void)normals_.push_back(normal_of(f));
    return true;
  }
  [[nodiscard]] Vector normal_of(Index f) const {
    const Index end = surface_.faces.first[f + 1];
    Vector normal{};
    const Index first = surface_.faces.corners[surface_.faces.first[f]];
    for (Index c = surface_.faces.first[f] + 1; c + 1 < end; ++c) {
      const Vector part = cross(vector(first, surface_.faces.corners[c]),
                                vector(first, surface_.faces.corners[c + 1]));
      for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
    }
    return normal;
  }
  [[nodiscard]] Vector vector(Index from, Index to) const {
    const float* p = surface_.position(from);
    const float* q = surface_.position(to);
    return {double{q[0]} - double{p[0]}, double{q[1]} - double{p[1]}, double{q[2]} - double{p[2]}};
  }

  Surface& surface_;
  const Crowds& crowds_;
  Array<Index> partner_;   // by place in crowds_.sides: the side that it is joined to
  Array<Index> faces_;     // that have a side in crowds_.sides, in ascending order
  Array<Vector> normals_;  // of these
  // Of the edge at hand:
  Index begin_ = 0;
  std::span<const Index> sides_;
  Array<Index> at_low_;  // the place of the side at which the fan at the lower end ends, if any
  Array<Index> at_high_;
  Array<Leaf> leaves_;
};

}  // namespace

bool match_crowds(Surface& surface, const Crowds& crowds) {
  return CrowdMatcher(surface, crowds).run();
}

}  // namespace halfedge::repair
