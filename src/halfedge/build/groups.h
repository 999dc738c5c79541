#pragma once

#include <halfedge/build/each_face.h>
#include <halfedge/build/order.h>
#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace halfedge {

/// A side of a face by its edge: it *runs up* if it leads from the smaller vertex of the edge to
/// the larger, else it runs down. The sign of their difference tells, as vertices are below 2^31:
/// compilers make no branch of that, which couldn't be predicted.
struct DirectedSide {
  Index down;  ///< all bits set if the side runs down, else none
  Index low;

  DirectedSide(Index from, Index to)
      : down(Index(std::int32_t(to - from) >> 31)), low(from + ((to - from) & down)) {}

  /// One of both, without a branch.
  [[nodiscard]] Index pick(Index if_up, Index if_down) const {
    return if_up ^ ((if_up ^ if_down) & down);
  }
};

/// The sides of all faces, brought together by the smaller vertices of their edges: the *group* of
/// a vertex. There are three edges to a group on average.
///
/// Sides get places, which are numbered from group to group: those that run up have the even ones
/// of their group, those that run down the odd ones, each in the order in which they come. So the
/// place of a side that runs up, and the one after it, can be numbers of the halfedges of its edge.
///
/// Then each group is matched by itself, by the larger vertices. Nothing is searched for in all of
/// this: what processors can't predict is how large a group is, not where each side is found, and
/// vertices of any valence take as long.
class Groups {
 public:
  /// Sets up the groups of all sides. `repeated` tells whether a polygon has a vertex twice;
  /// match() finds triangles that do. `last_face` is scratch, and has one entry for each vertex
  /// after that. False when memory is exhausted.
  template <bool kTriangles>
  [[nodiscard]] bool count(const Polygons& polygons, Array<Index>& last_face, bool& repeated);

  /// The place after those of all groups.
  [[nodiscard]] Index end() const { return end_; }

  /// The first place of the group of `low`, or end() if it is the number of vertices.
  /// pre: no side that runs down has a place
  [[nodiscard]] Index begin_of(Index low) const { return next_places_of(low)[1] - 1; }

  /// The place of the next side of this direction, to be moved on by 2 when it is taken.
  [[nodiscard]] Index& next_place(const DirectedSide& side) {
    return next_[2 * side.low - side.down];
  }

  /// The place of the next side of `low` that runs up, as next_place().
  [[nodiscard]] Index& next_up_place(Index low) { return next_[2 * std::size_t{low}]; }

  /// What next_place() refers to, two words for each vertex: of sides that run up, and of those
  /// that run down. A loop that calls other functions, too, keeps this in a register.
  [[nodiscard]] Index* next_places() { return next_.data(); }

  /// How many corners before their sides are placed their groups are asked for; half as many
  /// before, what lies at their places.
  static constexpr Index kPlacingAhead = 192;

  /// Asks for what it will take to place the sides of three corners that come later, if it is far
  /// from what is needed now: their groups, and the words of `at_places` that belong to them. Which
  /// of the corners are the smaller ones of their sides isn't looked at: to ask for too much costs
  /// less. pre: kPlacingAhead + 3 corners lie there
  [[gnu::always_inline]] void fetch_places(const Index* corners, const Index* at_places) const {
    const Index* const ahead = corners + kPlacingAhead / 2;
    const Index* const far_ahead = corners + kPlacingAhead;
    if (are_near(corners[0], far_ahead[0])) return;
    for (int i = 0; i < 3; ++i) {
      prefetch(next_places_of(far_ahead[i]));
      prefetch(at_places + *next_places_of(ahead[i]));
    }
  }

  /// Matches the sides of each group, once all have got their places. `edge_to` is scratch, and has
  /// one entry for each vertex. False if two sides run the same way along an edge, or one leads
  /// from a vertex to itself.
  ///
  /// `places` knows what lies there:
  ///   fetch(place, edge_to)      this place, and the next, will be needed soon: called where there
  ///                              is an instruction to ask for memory ahead
  ///   touch(begin, end, edge_to) these places will be needed next, though no side may lie there:
  ///                              called where there is none
  ///   high_up(place)             the larger vertex of a side that runs up
  ///   take_down(place, low)      the side there, one that runs down; called once
  ///   high_down(side)            its larger vertex
  ///   join(up, side)             the side at this place and that one are those of an edge
  ///   add(side, low, high, place)   this one is the only side of its edge; `place` is the first of
  ///                              two in its group that no other edge has, or kNone
  ///   close(up, low, is_single)  called for all sides of a group that run up, if some of them are
  ///                              the only sides of their edges, or repeat another one
  template <class Places>
  [[nodiscard]] bool match(Array<Index>& edge_to, Places places) const;

  /// Two words for each vertex, for other use once all groups are matched.
  [[nodiscard]] std::span<Index> scratch() { return next_.span(); }

 private:
  // Where the next places of a group lie: of its sides that run up, and behind it of those that run
  // down.
  [[nodiscard]] const Index* next_places_of(Index low) const {
    return next_.data() + std::size_t{2} * low;
  }

  // The places of a group are [begin, begin + size). The sides of `low` that run up have the even
  // ones before `up_end`, those that run down the odd ones before `down_end`.
  struct Group {
    Index low;
    Index begin;
    Index size;
    Index up_end;
    Index down_end;

    [[nodiscard]] bool has(Index place) const { return place - begin < size; }
  };

  // What lies so many places ahead is fetched into the cache. Or so many places are touched, which
  // are those of so many groups on average.
  static constexpr Index kAhead = 128;
  static constexpr Index kGroupsAhead = kAhead / 6;

  template <class Places>
  [[nodiscard]] Index match_group(const Group& group, Index* edge_to, const Places& places) const;

  Array<Index> next_;  // two places for each vertex, see next_place(), and two after all
  Index end_ = 0;
};

template <bool kTriangles>
bool Groups::count(const Polygons& polygons, Array<Index>& last_face, bool& repeated) {
  const std::size_t vertices = polygons.vertex_count();
  if (!next_.resize(2 * vertices + 2, 0) || !last_face.recreate(vertices)) return false;
  if (!kTriangles) std::fill(last_face.begin(), last_face.end(), kNone);
  [[maybe_unused]] Index* const last = last_face.data();
  [[maybe_unused]] Index repeats = 0;
  const auto count_sides = [&]([[maybe_unused]] Index f, const Index* corners, auto size) {
    for (Index i = 0; i < size; ++i) {
      const Index from = corners[i];
      if constexpr (!kTriangles) {
        repeats |= Index{last[from] == f};
        last[from] = f;
      }
      next_place({from, corners[i + 1 == size ? 0 : i + 1]}) += 2;
    }
  };
  for_each_face<kTriangles>(polygons, count_sides);
  repeated = repeats != 0;

  for (std::size_t i = 0; i < next_.size(); i += 2) {
    const Index size = std::max(next_[i], next_[i + 1]);
    next_[i] = end_;
    next_[i + 1] = end_ + 1;
    end_ += size;
  }
  return true;
}

template <class Places>
bool Groups::match(Array<Index>& edge_to, Places places) const {
  std::fill(edge_to.begin(), edge_to.end(), kNone);
  const Index vertices = Index(edge_to.size());
  Index clashes = 0;
  Index begin = 0;
  for (Index low = 0; low < vertices;) {
    if (!kCanPrefetch && end_ - begin > kAhead) {
      places.touch(begin, begin + kAhead, edge_to.span());
    }
    const Index stop = kCanPrefetch ? vertices : std::min(vertices, low + kGroupsAhead);
    for (; low < stop; ++low) {
      const Index* const next = next_places_of(low);
      const Index up_end = next[0];
      const Index down_end = next[1] - 1;
      const Index size = std::max(up_end, down_end) - begin;
      clashes |= match_group({low, begin, size, up_end, down_end}, edge_to.data(), places);
      begin += size;
    }
  }
  return clashes == 0;
}

// `edge_to` holds for each vertex the place of the edge of this group that leads there: the even
// one as long as a side that runs down can match it, the odd one then. What it holds of other
// groups counts for nothing.
//
// Where two sides run up along an edge, only the second can be matched. So there are none if as
// many are matched as run up, and where fewer are, it takes another look at each.
template <class Places>
Index Groups::match_group(const Group& group, Index* edge_to, const Places& places) const {
  for (Index up = group.begin; up != group.up_end; up += 2) {
    if constexpr (kCanPrefetch) {
      if (up + kAhead < end_) places.fetch(up + kAhead, edge_to);
    }
    edge_to[places.high_up(up)] = up;
  }
  if (group.has(edge_to[group.low])) return 1;  // a side from a vertex to itself
  Index free = group.up_end;
  Index added = 0;
  for (Index down = group.begin + 1; down != group.down_end + 1; down += 2) {
    const Index side = places.take_down(down, group.low);
    const Index high = places.high_down(side);
    const Index up = edge_to[high];
    if (group.has(up) && up % 2 == 0) {
      edge_to[high] = up + 1;
      places.join(up, side);
    } else if (group.has(up)) {
      return 1;
    } else {
      const bool fits = free < group.down_end;
      edge_to[high] = group.begin + 1;
      places.add(side, group.low, high, fits ? free : kNone);
      free += fits ? 2 : 0;
      ++added;
    }
  }
  Index clashes = 0;
  if (group.up_end + 2 * added != group.down_end) {
    for (Index up = group.begin; up != group.up_end; up += 2) {
      const Index edge = edge_to[places.high_up(up)];
      clashes |= Index{edge != up && edge != up + 1};
      places.close(up, group.low, edge == up);
    }
  }
  return clashes;
}

}  // namespace halfedge
