#pragma once

#include <halfedge/algorithms/triangulate_polygon.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/links.h>
#include <halfedge/result.h>

#include <cstddef>
#include <cstdint>
#include <span>

/// What triangulate decides before it changes anything.
namespace halfedge::operations::internal {

/// A hash table of edges that will be, by their two vertices. It takes linear time for any edges,
/// also for those that someone chose who has read how they are hashed.
class PlannedEdges {
 public:
  [[nodiscard]] bool contains(Vertex a, Vertex b);
  /// False when memory is exhausted. pre: not there yet
  [[nodiscard]] bool insert(Vertex a, Vertex b);

 private:
  [[nodiscard]] std::size_t slot_of(std::uint64_t key);
  [[nodiscard]] bool rebuild(std::size_t slots);

  Array<std::uint64_t> slots_;  // a power of two
  std::size_t count_ = 0;
  std::size_t steps_ = 0;  // past slots of other edges, since the table was built
  std::uint64_t seed_ = 0;
};

/// How faces are cut into triangles, one after another, so that no two diagonals join the same
/// vertices, nor two that are joined already.
class FacePlan {
 public:
  /// Plans the face of the loop of `first`, and appends to `ears` (see PolygonTriangulator, corner
  /// 0 is where `first` leads). Without positions all points are the same; with others to come,
  /// these know its diagonals. errors: no-triangulation, out-of-memory
  [[nodiscard]] Result<void> add(const Links& links, std::span<const float> positions,
                                 Halfedge first, bool has_others);

  /// The corners of all faces that were added, in the order in which they are cut off.
  [[nodiscard]] const Array<Index>& ears() const { return ears_; }
  /// The most corners that one had.
  [[nodiscard]] std::size_t largest() const { return largest_; }

 private:
  void list_diagonals(std::size_t begin);
  [[nodiscard]] bool forbid_existing(const Links& links);

  PolygonTriangulator triangulator_;
  PlannedEdges planned_;
  Array<Index> ears_;
  Array<Vertex> corners_;
  Array<Point> points_;
  Array<Diagonal> diagonals_;
  Array<Diagonal> forbidden_;
  Array<Index> next_;
  Array<Index> prev_;
  std::size_t largest_ = 0;
};

/// The edge between two vertices, or empty. cost: O(the smaller of their valences)
[[nodiscard]] Edge find_edge(const Links& links, Vertex a, Vertex b);

}  // namespace halfedge::operations::internal
