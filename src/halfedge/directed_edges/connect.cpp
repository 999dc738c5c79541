#include <halfedge/build/groups.h>
#include <halfedge/build/order.h>
#include <halfedge/directed_edges/connect.h>
#include <halfedge/inlining.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace halfedge {

namespace {

// Finds the opposites by matching sides in groups (build/groups.h). The places take just as much
// memory as the corners of a closed mesh, so they lie in `to_vertex`. Later, what it takes to walk
// around vertices lies there. The corners are written last; where there are boundaries, they are
// needed in between.
class TriangleConnector {
 public:
  TriangleConnector(const Polygons& triangles, DirectedLinks& links)
      : triangles_(triangles),
        links_(links),
        corners_(triangles.corners.data()),
        sides_(Index(triangles.corners.size())) {
    links.sides = sides_;
  }

  ConnectResult run() {
    Array<Index>& scratch = links_.vertex_halfedge;
    bool repeated = false;
    if (!groups_.count<true>(triangles_, scratch, repeated)) return ConnectResult::kOutOfMemory;
    if (repeated) return ConnectResult::kNotManifold;
    if (!make_room()) return ConnectResult::kOutOfMemory;
    place_sides();
    if (!groups_.match(scratch, Places{corners_, side_at_, opposite_, *this}))
      return ConnectResult::kNotManifold;
    if (std::uint64_t{sides_} + boundary_ > kMaxSlots) return ConnectResult::kTooLarge;
    anchor_vertices();
    const ConnectResult added = add_boundary();
    if (added != ConnectResult::kDone) return added;
    const bool has_one_cycle = each_vertex_has_one_cycle(links_, links_.to_vertex.span());
    write_to_vertices();
    return has_one_cycle ? ConnectResult::kDone : ConnectResult::kNotManifold;
  }

 private:
  // What lies at the places of groups. By value, so that loops keep it in registers.
  struct Places {
    const Index* corners;
    const Index* side_at;
    Index* opposite;
    TriangleConnector& connector;

    [[gnu::always_inline]] void fetch(Index place, const Index*) const {
      for (const Index side : {side_at[place], side_at[place + 1]}) {
        prefetch(corners + side);
        prefetch(opposite + side);
      }
    }
    void touch(Index begin, Index end, std::span<const Index>) const {
      connector.touch_places(begin, end);
    }
    [[nodiscard]] Index high_up(Index place) const { return corners[side_at[place]]; }
    [[nodiscard]] Index take_down(Index place, Index) const { return side_at[place]; }
    [[nodiscard]] Index high_down(Index side) const { return corners[before(side)]; }
    void join(Index up, Index side) const {
      opposite[side_at[up]] = side;
      opposite[side] = side_at[up];
    }
    void add(Index side, Index, Index, Index) const { connector.leave(side); }
    void close(Index up, Index, bool is_single) const {
      if (is_single) connector.leave(side_at[up]);
    }
  };

  // Of the halfedges of its face the one before it, whose corner is the one that it leaves.
  [[nodiscard]] static Index before(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  // Touches what is needed for these places of groups, if their sides are scattered. Where no side
  // lies, there is anything.
  HALFEDGE_NOINLINE void touch_places(Index begin, Index end) const {
    if (!are_scattered(side_at_[begin + 1], side_at_[end - 1], sides_)) return;
    for (Index place = begin; place < end; ++place) {
      const Index side = std::min(side_at_[place], sides_ - 1);
      touch(corners_ + side);
      touch(opposite_ + side);
    }
  }

  // A side that has no other one.
  void leave(Index side) {
    opposite_[side] = kNone;
    ++boundary_;
  }

  // A mesh that lacks memory gets a little more, so that a few boundary loops cost no reallocation;
  // `add_boundary` gives back what isn't used.
  [[nodiscard]] bool make_room() {
    const std::size_t least = std::max<std::size_t>(sides_, groups_.end());
    is_fresh_ = std::min(links_.opposite.capacity(), links_.to_vertex.capacity()) < least;
    const std::size_t count =
        is_fresh_ ? least + 4 * std::size_t(std::sqrt(double(least))) + 64 : least;
    if (!links_.opposite.recreate(count) || !links_.to_vertex.recreate(count)) return false;
    opposite_ = links_.opposite.data();
    side_at_ = links_.to_vertex.data();
    return true;
  }

  void place_sides() {
    constexpr Index kFetching = Groups::kPlacingAhead + 3;
    const bool fetches = kCanPrefetch && triangles_.vertex_count() >= kTooManyForCache;
    const Index fetching = fetches && sides_ > kFetching ? sides_ - kFetching : 0;
    for (Index first = 0; first < sides_; first += 3) {
      const Index* const corners = corners_ + first;
      if (first < fetching) groups_.fetch_places(corners, side_at_);
      place_side(first, corners[2], corners[0]);
      place_side(first + 1, corners[0], corners[1]);
      place_side(first + 2, corners[1], corners[2]);
    }
  }

  [[gnu::always_inline]] void place_side(Index side, Index from, Index to) {
    Index& next_place = groups_.next_place({from, to});
    side_at_[next_place] = side;
    next_place += 2;
  }

  // Isolated ones have their anchor: kNone, as no edge led to them when sides were matched.
  void anchor_vertices() {
    Index* const anchors = links_.vertex_halfedge.data();
    for (Index first = 0; first < sides_; first += 3) {
      const Index* const corners = corners_ + first;
      anchors[corners[2]] = first;
      anchors[corners[0]] = first + 1;
      anchors[corners[1]] = first + 2;
    }
  }

  ConnectResult add_boundary() {
    const std::size_t halfedges = std::size_t{sides_} + boundary_;
    if (!links_.opposite.resize(halfedges) || !links_.to_vertex.resize(halfedges) ||
        !links_.boundary_next.recreate(boundary_) || !links_.boundary_prev.recreate(boundary_)) {
      return ConnectResult::kOutOfMemory;
    }
    if (is_fresh_) {
      links_.opposite.shrink_to_fit();
      links_.to_vertex.shrink_to_fit();
    }
    if (boundary_ == 0) return ConnectResult::kDone;
    Index* const opposite = links_.opposite.data();
    Index b = sides_;
    for (Index h = 0; h < sides_; ++h) {
      if (opposite[h] != kNone) continue;
      opposite[h] = b;
      opposite[b] = h;
      ++b;
    }
    write_to_vertices();
    return join_open_fans(links_);
  }

  void write_to_vertices() {
    Index* const to = links_.to_vertex.data();
    std::copy(corners_, corners_ + sides_, to);
    for (std::size_t b = sides_; b < links_.to_vertex.size(); ++b) {
      to[b] = links_.from_vertex(links_.opposite[b]);
    }
  }

  const Polygons& triangles_;
  DirectedLinks& links_;
  const Index* corners_;
  Index sides_;
  Groups groups_;
  Index boundary_ = 0;  // how many sides have no opposite
  bool is_fresh_ = false;
  Index* opposite_ = nullptr;
  Index* side_at_ = nullptr;  // by place
};

}  // namespace

ConnectResult connect_triangles(const Polygons& triangles, DirectedLinks& links) {
  return TriangleConnector(triangles, links).run();
}

}  // namespace halfedge
