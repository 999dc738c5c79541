#pragma once

#include <halfedge/algorithms/planar.h>
#include <halfedge/algorithms/point_tree.h>
#include <halfedge/algorithms/rank_tree.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace halfedge {

/// Two corners of a polygon, the smaller first.
struct Diagonal {
  Index a = kNone;
  Index b = kNone;

  friend auto operator<=>(const Diagonal&, const Diagonal&) = default;
};

/// Makes a ring of all corners of a polygon, some of which are to be cut off: writes which one
/// comes after each, and which before. pre: there is an element for each corner in both
void make_ring(Array<Index>& next, Array<Index>& prev);

/// Cuts polygons into triangles, one after another: it keeps its memory in between.
///
/// The polygon may be concave, and nearly planar only: it is seen along the axis that its normal is
/// nearest to. Corners may lie on a line, or in the same place. If it is simple, all triangles face
/// the way it does: none folds over; and none is without area as long as the polygon isn't. Of a
/// polygon that crosses itself the triangles are as many, and cover its signed area.
///
/// Up to kSmall corners the sum of the lengths of the diagonals is the smallest there is (of a
/// quad: the shorter diagonal); of more, the shortest diagonal that cuts off an ear comes first,
/// until so many corners are left.
class PolygonTriangulator {
 public:
  static constexpr std::size_t kSmall = 32;

  enum class Outcome : std::uint8_t { kDone, kBlocked, kOutOfMemory };

  /// Appends to `ears` the corners in the order in which they are cut off: each with its two
  /// neighbours at that time is a triangle, the last three corners are another. n - 3 numbers for n
  /// corners.
  ///
  /// `forbidden` lists diagonals that may not be used, in order. If a triangle would have to fold
  /// over without them, the outcome is kBlocked, `blocked()` one of them, and `ears` as before. So
  /// it may be of more than kSmall corners if another order of ears would do without them.
  ///
  /// pre: 3 corners or more
  /// cost: O(n^3) of n <= kSmall corners; of more O(n log n) and, for each corner, a look for
  ///       concave ones in its triangle: mostly O(log n), O(sqrt(n)) of long slivers. 40 bytes a
  ///       corner, and more; 4 more of a polygon that crosses itself
  [[nodiscard]] Outcome run(std::span<const Point> points, std::span<const Diagonal> forbidden,
                            Array<Index>& ears);

  [[nodiscard]] Diagonal blocked() const { return blocked_; }

 private:
  /// What a choice of diagonals costs: first what is bad about it, the worst first, in one number;
  /// fewer than 2^10 of each, since there are few corners.
  struct Cost {
    static constexpr std::uint32_t kFlat = 1;  // a triangle without area
    static constexpr std::uint32_t kForbidden = 1U << 10U;
    static constexpr std::uint32_t kFlip = 1U << 20U;

    std::uint32_t faults = 0;
    double length = 0;

    [[nodiscard]] bool has_forbidden() const { return (faults & (kFlip - kForbidden)) != 0; }
    [[nodiscard]] bool operator<(const Cost& other) const {
      return faults != other.faults ? faults < other.faults : length < other.length;
    }
    [[nodiscard]] Cost operator+(const Cost& other) const {
      return {faults + other.faults, length + other.length};
    }
  };
  struct Choice {
    Cost cost;
    Index corner = kNone;
  };
  struct Ear {
    double length = 0;
    Index corner = kNone;
    Index stamp = 0;
  };
  struct CutsLonger {
    bool operator()(const Ear& a, const Ear& b) const { return a.length > b.length; }
  };

  [[nodiscard]] Outcome cut(Array<Index>& ears);
  [[nodiscard]] bool project_points();
  [[nodiscard]] int turn(Index a, Index b, Index c) const;
  [[nodiscard]] double distance(Index a, Index b) const;
  [[nodiscard]] bool is_forbidden(Index a, Index b) const;

  // Few corners: dynamic programming over chains of corners.
  [[nodiscard]] bool choose_diagonals();
  [[nodiscard]] Choice& choice(std::size_t i, std::size_t j) { return choices_[i * kSmall + j]; }
  [[nodiscard]] Cost side_cost(std::size_t i, std::size_t j);
  void list_ears(std::size_t i, std::size_t j, Array<Index>& ears);
  void find_blocked(std::size_t i, std::size_t j);

  // Many corners: ears are cut off.
  [[nodiscard]] Outcome cut_to_few(Array<Index>& ears);
  [[nodiscard]] bool begin_cutting();
  [[nodiscard]] bool is_ear(Index corner);
  [[nodiscard]] bool lies_inside(Index w, Index a, Index b, Index c) const;
  [[nodiscard]] bool enters(Index w, Index corner, Index following, Index before) const;
  [[nodiscard]] bool look_at(Index corner);
  [[nodiscard]] Index best_ear();
  [[nodiscard]] bool cut_off(Index corner);

  // Where there is no ear.
  [[nodiscard]] bool rank_corners();
  void rank(Index corner);
  [[nodiscard]] Index any_corner() const;

  std::span<const Point> points_;
  std::span<const Diagonal> forbidden_;
  Diagonal blocked_;
  Array<PlanarPoint> planar_;
  Array<Index> rest_;  // the corners that are left, kSmall at most
  Array<Choice> choices_;
  Array<Index> next_;
  Array<Index> prev_;
  Array<Index> stamp_;  // of a corner: counts its changes
  PointTree concave_;   // those corners
  Array<Ear> ears_;     // a heap, and some that have changed since
  RankTree ranks_;      // of all corners, once there was no ear
  bool is_ranked_ = false;
  Index start_ = 0;  // a corner that is left
};

}  // namespace halfedge
