#pragma once

#include <halfedge/algorithms/triangulate_polygon.h>
#include <halfedge/mend/measure.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

namespace halfedge::mend {

inline constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

/// The corners of a loop that is to be filled, and between which of them no diagonal may lie.
struct Hole {
  Array<Vector> points;
  Array<Vector> beyond;       // by corner: the normal beyond the side from it to the next
  Array<Diagonal> forbidden;  // sorted

  [[nodiscard]] bool forbids(const Diagonal& diagonal) const;
};

enum class HoleOutcome : std::uint8_t { kDone, kSame, kBlocked, kOutOfMemory };

/// Chooses the triangles that fill a hole, one hole after another: it keeps its memory in between.
///
/// Up to kExact corners the largest angle between the normals of neighbouring triangles, those of
/// the mesh around included, is a small one, in steps of 30 degrees and one at the angle that is
/// allowed; among those of one step, diagonals are short and edges flat. This is dynamic
/// programming over the pairs of corners (Barequet and Sharir 1995, with the weights of Liepa
/// 2003), which keeps one triangle for each diagonal: the best on its own side, not always the one
/// that suits the other side best. Of more corners, the best ear by the same measure is cut off
/// until so many are left.
class HoleTriangles {
 public:
  static constexpr std::size_t kExact = 200;

  /// Chooses so that no fold is sharper than `max_angle`, in degrees, where it can be helped.
  explicit HoleTriangles(double max_angle);

  /// To be written before the rest is called; prepare() after its corners are there.
  [[nodiscard]] Hole& hole() { return hole_; }
  /// False when memory is exhausted.
  [[nodiscard]] bool prepare();

  /// Writes the corners in the order in which they are cut off. Never kSame.
  /// cost: O(n^3) of n <= kExact corners, else O(n log n + kExact^3)
  [[nodiscard]] HoleOutcome choose(Array<Index>& ears);

  /// The cosine of the largest angle between neighbouring normals, if these are cut off.
  [[nodiscard]] double worst_of(std::span<const Index> ears);

  /// Calls `visit` with the diagonal that cuts each of these off, until that returns false; as this
  /// does then.
  template <class Visit>
  [[nodiscard]] bool for_each_diagonal(std::span<const Index> ears, const Visit& visit) {
    begin_cutting();
    for (const Index corner : ears) {
      if (!visit(diagonal(prev_[corner], next_[corner]))) return false;
      cut_off(corner, {});
    }
    return true;
  }

 private:
  struct Cost {
    int fold = 0;     // the largest angle, in steps
    double rest = 0;  // lengths, with a surcharge for angles
  };
  struct Choice {
    Cost cost;
    Index corner = kNone;
    Vector normal = {};  // of the triangle at the diagonal
  };
  struct Ear {
    Cost cost;
    Index corner = kNone;
    Index stamp = 0;
  };
  struct CostsMore {
    bool operator()(const Ear& a, const Ear& b) const { return is_less(b.cost, a.cost); }
  };
  [[nodiscard]] static Diagonal diagonal(Index a, Index b) {
    return {std::min(a, b), std::max(a, b)};
  }
  [[nodiscard]] static bool is_less(const Cost& a, const Cost& b);
  [[nodiscard]] static double cosine(const Vector& a, const Vector& b);
  [[nodiscard]] int steps_to(double cosine) const;
  void add_edge(Cost& cost, const Vector& a, const Vector& b, double edge_length) const;
  [[nodiscard]] Vector normal_of(Index a, Index b, Index c, const Vector& beyond_ab,
                                 const Vector& beyond_bc, Cost& cost) const;
  [[nodiscard]] double distance(Index a, Index b) const {
    return length(hole_.points[a] - hole_.points[b]);
  }

  void begin_cutting();
  void cut_off(Index corner, const Vector& normal);
  [[nodiscard]] bool look_at(Index corner);
  [[nodiscard]] HoleOutcome cut_ears(Array<Index>& ears);

  [[nodiscard]] HoleOutcome choose_among_all(Array<Index>& ears);
  void choose_between(std::size_t i, std::size_t j);
  [[nodiscard]] Choice& choice(std::size_t i, std::size_t j) {
    return choices_[i * rest_.size() + j];
  }
  void list_ears(std::size_t i, std::size_t j, Array<Index>& ears);

  Hole hole_;
  std::array<double, 6> steps_{};  // cosines, from the smallest angle on

  // What is left while corners are cut off.
  Array<Index> next_;
  Array<Index> prev_;
  Array<Index> stamp_;
  Array<Vector> side_;  // as Hole::beyond
  Array<Ear> heap_;

  Array<Index> rest_;  // the corners that are chosen among, kExact at most
  Array<Choice> choices_;
};

}  // namespace halfedge::mend
