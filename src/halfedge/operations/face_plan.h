#pragma once

#include <halfedge/algorithms/polygon_cutter.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/links.h>
#include <halfedge/result.h>

#include <cstddef>
#include <span>

/// What triangulate decides before it changes anything.
namespace halfedge::operations::internal {

/// How faces are cut into triangles, one after another, so that no two diagonals join the same
/// vertices, nor two that are joined already.
class FacePlan {
 public:
  /// Plans the face of the loop of `first`, and appends to `ears` (see PolygonTriangulator, corner
  /// 0 is where `first` leads). Without positions all points are the same; with others to come,
  /// these know its diagonals. errors: no-triangulation, out-of-memory
  [[nodiscard]] Result<void> add(const Links& links, std::span<const float> positions,
                                 Halfedge first, bool has_others);

  /// A halfedge of each face that was added and is to be cut.
  [[nodiscard]] const Array<Halfedge>& loops() const { return loops_; }
  /// Their corners, loop by loop, in the order in which they are cut off.
  [[nodiscard]] const Array<Index>& ears() const { return ears_; }
  /// The most corners that one had.
  [[nodiscard]] std::size_t largest() const { return largest_; }

 private:
  PolygonCutter cutter_;
  Array<Halfedge> loops_;
  Array<Index> ears_;
  Array<Vertex> corners_;
  Array<Point> points_;
  std::size_t largest_ = 0;
};

/// Plans all faces. Where those before it leave a face no way, it goes before them, and all are
/// planned anew; but no face does so twice, and no more than a few do.
[[nodiscard]] Result<void> plan_all(const Links& links, std::span<const float> positions,
                                    FacePlan& plan);

/// The edge between two vertices, or empty. cost: O(the smaller of their valences)
[[nodiscard]] Edge find_edge(const Links& links, Vertex a, Vertex b);

}  // namespace halfedge::operations::internal
