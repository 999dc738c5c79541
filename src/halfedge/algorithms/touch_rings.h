#pragma once

#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/rings.h>

/// What is done before rings are walked that lie scattered in memory, as on a mesh whose vertices
/// and faces are in no order.
///
/// A lap is a chain of loads, each waiting for the one before it, and a processor looks ahead over
/// the ends of few laps. So some rings are walked in step first, for nothing but to fill the cache:
/// as many loads are underway then as there are rings. The laps themselves find all of it there.
namespace halfedge {

/// So many rings are touched together.
inline constexpr Index kRingsTouched = 64;

/// Where the rings of one kind lie. A step leads from h to `steps[h ^ before] ^ after`, and what it
/// shows stands in `items[h]`, or in that of the opposite of h beside it.
struct RingLayout {
  const Index* firsts = nullptr;  // by centre
  const Index* steps = nullptr;
  const Index* items = nullptr;
  Index centres = 0;
  Index halfedges = 0;
  Index before = 0;
  Index after = 0;
  Index length = 0;  // of most rings, where all faces are triangles
};

/// Of rings of edges it is empty: they are never scattered.
[[nodiscard]] RingLayout layout_of(const RawLinks& links, Ring ring, Direction direction);

/// Whether the halfedges of a ring lie so far apart that it pays to touch them. Looks at a few
/// rings, and at none of a small mesh, which is in the cache.
[[nodiscard]] bool are_scattered(const RingLayout& rings);

/// Touches what the rings of the next kRingsTouched centres consist of, if there are so many. Stays
/// within the arrays, whatever these hold.
/// pre: are_scattered(rings)
void touch_rings(const RingLayout& rings, Index centre);

/// For a loop over centres in order that takes one lap around each: touches the rings of the next
/// kRingsTouched centres when the loop reaches the first of them, if these are scattered.
class RingToucher {
 public:
  RingToucher(const RawLinks& links, Ring ring, Direction direction);

  void reach(Index centre) {
    if (centre >= untouched_) [[unlikely]]
      touch_from(centre);
  }

 private:
  void touch_from(Index centre);

  RingLayout rings_;
  Index untouched_;  // the first centre whose ring is to be touched, or kNone
};

}  // namespace halfedge
