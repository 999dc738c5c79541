#include <halfedge/algorithms/projection.h>
#include <halfedge/algorithms/quad.h>

#include <cstddef>

namespace halfedge {

namespace {

// Of the two triangles beside a diagonal: how many fold over, how many have no area.
struct DiagonalCost {
  int flips;
  int flat;
  double length;

  [[nodiscard]] bool operator<(const DiagonalCost& other) const {
    if (flips != other.flips) return flips < other.flips;
    if (flat != other.flat) return flat < other.flat;
    return length < other.length;
  }
};

DiagonalCost cost_of(int turn, int other, double length) {
  return {(turn < 0 ? 1 : 0) + (other < 0 ? 1 : 0), (turn == 0 ? 1 : 0) + (other == 0 ? 1 : 0),
          length};
}

}  // namespace

Index ear_of_quad(std::span<const Point, 4> points) {
  const Projection projection(points);
  PlanarPoint planar[4];
  for (std::size_t i = 0; i < 4; ++i) planar[i] = projection(points[i]);
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
    return turn_of(planar[a], planar[b], planar[c]);
  };
  const DiagonalCost along_02 =
      cost_of(turn(0, 1, 2), turn(0, 2, 3), diagonal_length(points[0], points[2]));
  const DiagonalCost along_13 =
      cost_of(turn(1, 2, 3), turn(0, 1, 3), diagonal_length(points[1], points[3]));
  return along_02 < along_13 ? 1 : 2;
}

}  // namespace halfedge
