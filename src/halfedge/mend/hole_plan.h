#pragma once

#include <halfedge/algorithms/triangulate_polygon.h>
#include <halfedge/mend/measure.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

namespace halfedge::mend {

inline constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

/// Which triangles fill the boundary loops of a surface, one after another: it keeps its memory,
/// and what it knows of the faces around, in between.
///
/// Up to kExact corners the largest angle between the normals of neighbouring triangles, those of
/// the mesh around included, is a small one, in steps of 30 degrees and one at the angle that is
/// allowed; among those of one step, diagonals are short and edges flat. This is dynamic
/// programming over the pairs of corners (Barequet and Sharir 1995, with the weights of Liepa
/// 2003), which keeps one triangle for each diagonal: the best on its own side, not always the one
/// that suits the other side best. Of more corners, the best ear by the same measure is cut off
/// until so many are left; and of those near a plane, the triangulation of the polygon is tried
/// too, and the flatter of the two taken.
///
/// No diagonal joins two vertices that are joined already, or twice.
class HolePlan {
 public:
  static constexpr std::size_t kExact = 200;
  static constexpr std::size_t kPlanar = 5000;

  enum class Outcome : std::uint8_t { kDone, kSame, kBlocked, kOutOfMemory };
  static constexpr std::size_t kUnplanned = std::size_t(-1);

  /// Plans so that no fold is sharper than `max_angle`, in degrees, where it can be helped.
  HolePlan(const Surface& surface, double max_angle);

  /// Plans the loop of `first`. `joins` becomes the number of pairs of corners whose vertices are
  /// joined already, or the same. Triangles beside the loop can only add some: where there are as
  /// many as the last time, the plan would be the same, and there is none.
  /// pre: finite positions, three edges at least; faces beside it are as they were for the loops
  /// before. cost: O(n^3) of n <= kExact corners, else O(n log n + kExact^3) and,
  /// up to kPlanar, that of PolygonTriangulator
  [[nodiscard]] Outcome run(Halfedge first, std::size_t& joins);

  /// The corners in the order in which they are cut off, of which corner 0 is where `first` leads.
  [[nodiscard]] std::span<const Index> ears() const { return ears_.span(); }
  /// The cosine of the largest angle between neighbouring normals.
  [[nodiscard]] double worst() const { return worst_; }

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
  struct Corner {
    Vertex vertex;
    Index index;
  };

  // Instead of worst(): below all cosines.
  static constexpr double kNoPlan = -2;

  [[nodiscard]] static bool is_less(const Cost& a, const Cost& b);
  [[nodiscard]] static double cosine(const Vector& a, const Vector& b);
  [[nodiscard]] int steps_to(double cosine) const;
  void add_edge(Cost& cost, const Vector& a, const Vector& b, double edge_length) const;

  [[nodiscard]] bool find_normal(Halfedge h, Vector& normal);
  [[nodiscard]] bool read_loop(Halfedge first);
  [[nodiscard]] bool list_forbidden();
  [[nodiscard]] bool is_forbidden(Index a, Index b) const;
  [[nodiscard]] Vector normal_of(Index a, Index b, Index c, const Vector& beyond_ab,
                                 const Vector& beyond_bc, Cost& cost) const;
  [[nodiscard]] double distance(Index a, Index b) const { return length(points_[a] - points_[b]); }

  [[nodiscard]] Outcome plan();
  [[nodiscard]] Outcome cut_ears();
  [[nodiscard]] bool look_at(Index corner);
  [[nodiscard]] Outcome choose();
  void choose_between(std::size_t i, std::size_t j);
  [[nodiscard]] Choice& choice(std::size_t i, std::size_t j) {
    return choices_[i * rest_.size() + j];
  }
  void list_ears(std::size_t i, std::size_t j);
  [[nodiscard]] bool try_planar();
  void begin_cutting();
  void cut_off(Index corner, const Vector& normal);
  [[nodiscard]] double worst_of(std::span<const Index> ears);
  [[nodiscard]] Outcome forbid_repeated(bool& is_repeated);

  const Surface& surface_;
  std::array<double, 6> steps_{};  // cosines, from the smallest angle on
  PolygonTriangulator triangulator_;
  Array<Index> known_;  // by face: where its normal is
  Array<Vector> normals_;
  Array<Vertex> vertices_;
  Array<Vector> points_;
  Array<Vector> beyond_;  // by corner: the normal beyond the side from it to the next
  Array<Diagonal> forbidden_;
  Array<Corner> order_;
  Array<Index> ears_;
  double worst_ = 1;

  // What is left while corners are cut off.
  Array<Index> next_;
  Array<Index> prev_;
  Array<Index> stamp_;
  Array<Vector> side_;  // as beyond_
  Array<Ear> heap_;

  Array<Index> rest_;  // the corners that are chosen among, kExact at most
  Array<Choice> choices_;
};

}  // namespace halfedge::mend
