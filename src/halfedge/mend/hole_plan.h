#pragma once

#include <halfedge/mend/hole_triangles.h>

#include <cstddef>
#include <span>

namespace halfedge::mend {

/// Which triangles fill the boundary loops of a surface, one after another: it keeps its memory,
/// and what it knows of the faces around, in between.
///
/// HoleTriangles chooses them. Of loops near a plane, with more corners than it can weigh against
/// all others, the triangulation of the polygon is tried too, and the flatter of the two taken.
///
/// No diagonal joins two vertices that are joined already, or twice.
class HolePlan {
 public:
  static constexpr std::size_t kPlanar = 5000;

  using Outcome = HoleOutcome;
  static constexpr std::size_t kUnplanned = std::size_t(-1);

  /// Plans so that no fold is sharper than `max_angle`, in degrees, where it can be helped.
  HolePlan(const Surface& surface, double max_angle) : surface_(surface), triangles_(max_angle) {}

  /// Plans the loop of `first`. `joins` becomes the number of pairs of corners whose vertices are
  /// joined already, or the same. Triangles beside the loop can only add some: where there are as
  /// many as the last time, the plan would be the same, and there is none.
  /// pre: finite positions, three edges at least; faces beside it are as they were for the loops
  /// before. cost: that of HoleTriangles::choose and, of more than HoleTriangles::kExact corners up
  /// to kPlanar, that of PolygonTriangulator
  [[nodiscard]] Outcome run(Halfedge first, std::size_t& joins);

  /// The corners in the order in which they are cut off, of which corner 0 is where `first` leads.
  [[nodiscard]] std::span<const Index> ears() const { return ears_.span(); }
  /// The cosine of the largest angle between neighbouring normals.
  [[nodiscard]] double worst() const { return worst_; }

 private:
  struct Corner {
    Vertex vertex;
    Index index;
  };

  // Instead of worst(): below all cosines.
  static constexpr double kNoPlan = -2;

  [[nodiscard]] bool find_normal(Halfedge h, Vector& normal);
  [[nodiscard]] bool read_loop(Halfedge first);
  [[nodiscard]] bool list_forbidden();
  [[nodiscard]] Outcome plan();
  [[nodiscard]] bool try_planar();
  [[nodiscard]] Outcome forbid_repeated(bool& is_repeated);

  const Surface& surface_;
  Array<Index> known_;  // by face: where its normal is
  Array<Vector> normals_;
  Array<Vertex> vertices_;
  Array<Corner> order_;
  HoleTriangles triangles_;
  PolygonTriangulator triangulator_;
  Array<Index> ears_;
  double worst_ = 1;
};

}  // namespace halfedge::mend
