#pragma once

#include <halfedge/build/buckets.h>
#include <halfedge/build/groups.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

namespace halfedge {

/// A side that runs down, alone along its edge, for which its group has no places.
struct UnforeseenEdge {
  Index side;
  Index low;
  Index high;
};

/// Matches the sides of a bucket, as Groups::match does, and with the same halfedges for them. All
/// that it needs of a bucket fits into the cache. So a side that runs down looks for its partner
/// among those of its group that run up, all at once; no other sides get places.
class BucketMatcher {
 public:
  /// The sides by their slots, with the smaller and the larger vertices of their edges. What is
  /// found goes into `halfedge_of` by slot, and into `to_vertex` by halfedge.
  BucketMatcher(Groups& groups, const Index* low_of, const Index* high_of, Index* halfedge_of,
                Index* to_vertex)
      : groups_(groups),
        low_of_(low_of),
        high_of_(high_of),
        halfedge_of_(halfedge_of),
        to_vertex_(to_vertex) {}

  /// False if two sides run the same way along an edge, but for edges that are added to
  /// `unforeseen`; or if one leads from a vertex to itself.
  [[nodiscard]] bool match(const Bucket& bucket, Array<UnforeseenEdge>& unforeseen);

  [[nodiscard]] bool is_out_of_memory() const { return is_out_of_memory_; }

 private:
  [[nodiscard]] bool place_ups(const Bucket& bucket);
  [[nodiscard]] bool match_downs(const Bucket& bucket, Array<UnforeseenEdge>& unforeseen,
                                 Index& matched);
  [[nodiscard]] bool close_ups(const Bucket& bucket);
  void add(Index side, Array<UnforeseenEdge>& unforeseen);

  Groups& groups_;
  const Index* low_of_;
  const Index* high_of_;
  Index* halfedge_of_;
  Index* to_vertex_;
  bool is_out_of_memory_ = false;
};

/// Brings edges of all buckets into the order in which Groups::match finds them: by their smaller
/// vertices, then as their sides come. `marks` has an entry for each vertex, not one of which is a
/// vertex. False if two of them are the same.
[[nodiscard]] bool sort_unforeseen(Array<UnforeseenEdge>& edges, Array<Index>& marks);

}  // namespace halfedge
