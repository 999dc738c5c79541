#include <halfedge/build/groups.h>
#include <halfedge/directed_edges/connect.h>
#include <halfedge/prefetch.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace halfedge {

namespace {

// Groups are fetched into the cache so many corners before they are needed.
constexpr std::size_t kAhead = 48;

constexpr Index kFacesTogether = 32;

/// An upward side in its group: where it leads, and its halfedge.
struct Entry {
  Index high;
  Index halfedge;

  friend bool operator<(const Entry& a, const Entry& b) { return a.high < b.high; }
};

/// A downward side, from `high` to `low`.
struct Side {
  Index low;
  Index high;
  Index halfedge;
  Index upward;  // the other side of its edge, or kNone
};

// Finds the opposites in two passes over the faces. A side runs *up* if it leads from the smaller
// vertex of its edge to the larger. The first pass writes all upward sides into the groups of their
// smaller vertices (see groups.h), three to a group on average; the second looks each downward side
// up there. What is then left over on either side is the boundary.
//
// The groups take just as much memory as the corners, so they lie in `to_vertex`, which is written
// last; the only scratch memory is where they begin.
class TriangleConnector {
 public:
  TriangleConnector(const Polygons& triangles, DirectedLinks& links)
      : corners_(triangles.corners.data()),
        sides_(Index(triangles.corners.size())),
        triangles_(triangles),
        links_(links) {
    links.sides = sides_;
  }

  ConnectResult run() {
    bool repeated = false;
    if (!count_groups<true>(triangles_, links_.vertex_halfedge, groups_, repeated)) {
      return ConnectResult::kOutOfMemory;
    }
    if (repeated) return ConnectResult::kNotManifold;
    if (!make_room()) return ConnectResult::kOutOfMemory;
    place_upward_sides();
    if (groups_.in_large > 0) {
      const ConnectResult sorted = sort_large_groups();
      if (sorted != ConnectResult::kDone) return sorted;
    }
    if (!match_downward_sides()) return ConnectResult::kNotManifold;
    const Index boundary = sides_ - 2 * matched_;
    if (boundary > 0 && an_upward_side_repeats()) return ConnectResult::kNotManifold;
    if (std::uint64_t{sides_} + boundary > kMaxSlots) return ConnectResult::kTooLarge;
    return write_corners_and_boundary(boundary);
  }

 private:
  // A mesh that lacks memory gets a little more, so that a few boundary loops cost no reallocation;
  // `write_corners_and_boundary` gives back what isn't used.
  [[nodiscard]] bool make_room() {
    const std::size_t least = std::max<std::size_t>(sides_, groups_.end());
    is_fresh_ = std::min(links_.opposite.capacity(), links_.to_vertex.capacity()) < least;
    const std::size_t count =
        is_fresh_ ? least + 4 * std::size_t(std::sqrt(double(least))) + 64 : least;
    if (!links_.opposite.recreate(count) || !links_.to_vertex.recreate(count)) return false;
    opposite_ = links_.opposite.data();
    table_ = links_.to_vertex.data();
    ends_ = groups_.begin.data();
    groups_end_ = groups_.end();
    return true;
  }

  // ---- first pass

  // Without a branch on the direction, which can't be predicted: downward sides are written, too,
  // to a place after all groups. Makes `ends_` what its name says.
  void place_upward_sides() {
    Index* const anchors = links_.vertex_halfedge.data();
    std::fill(anchors, anchors + links_.vertex_halfedge.size(), kNone);
    for (Index h = 0; h < sides_; h += 3) {
      const Index a = corners_[h];
      const Index b = corners_[h + 1];
      const Index c = corners_[h + 2];
      prefetch_groups(h);
      place(c, a, h);
      place(a, b, h + 1);
      place(b, c, h + 2);
      anchors[c] = h;
      anchors[a] = h + 1;
      anchors[b] = h + 2;
    }
  }

  void place(Index from, Index to, Index h) {
    const bool up = from < to;
    const Index end = ends_[from];
    Index* const entry = up ? table_ + end : not_upward_.data();
    entry[0] = to;
    entry[1] = h;
    ends_[from] = end + (up ? 2 : 0);
    opposite_[h] = kNone;
  }

  // Where vertices are in no order, nearly all the time is spent waiting for the lines of a group.
  [[gnu::always_inline]] void prefetch_groups(Index h) const {
    if (sides_ - h < kAhead + 3) return;
    const Index* const ahead = corners_ + h + kAhead;
    prefetch(table_ + ends_[ahead[0]]);
    prefetch(table_ + ends_[ahead[1]]);
    prefetch(table_ + ends_[ahead[2]]);
  }

  // ---- second pass

  [[nodiscard]] Index begin_of(Index low) const { return low == 0 ? 0 : ends_[low - 1]; }

  // By the vertices they lead to, so that they can be searched by halves.
  ConnectResult sort_large_groups() {
    Array<Entry> entries;
    for (Index low = 0; low < links_.vertex_halfedge.size(); ++low) {
      Index* const begin = table_ + begin_of(low);
      Index* const end = table_ + ends_[low];
      if (!is_large(Index(end - begin))) continue;
      if (!entries.recreate(std::size_t(end - begin) / 2)) return ConnectResult::kOutOfMemory;
      const Index* from = begin;
      for (Entry& entry : entries) {
        entry = {from[0], from[1]};
        from += 2;
      }
      introsort(entries.begin(), entries.end());
      Index* to = begin;
      for (const Entry& entry : entries) {
        if (to != begin && to[-2] == entry.high) return ConnectResult::kNotManifold;
        *to++ = entry.high;
        *to++ = entry.halfedge;
      }
    }
    return ConnectResult::kDone;
  }

  [[nodiscard]] static bool is_large(Index size) { return size > Groups::kSearched; }

  // Some faces at a time, in three steps, so that each step asks for the memory of the next: the
  // groups of their downward sides, again without a branch on the direction; the upward sides
  // there; their opposites. False if two sides of an edge run in the same direction.
  [[nodiscard]] bool match_downward_sides() {
    bool clashes = false;
    for (Index first = 0; first < sides_;) {
      const Index last = first + std::min<Index>(3 * kFacesTogether, sides_ - first);
      collect_downward_sides(first, last);
      for (Index i = 0; i < downward_count_; ++i) clashes |= !find_upward_side(downward_[i]);
      for (Index i = 0; i < downward_count_; ++i) {
        const Side& side = downward_[i];
        opposite_[side.halfedge] = side.upward;
        if (side.upward == kNone) continue;
        opposite_[side.upward] = side.halfedge;
        ++matched_;
      }
      first = last;
    }
    return !clashes;
  }

  void collect_downward_sides(Index first, Index last) {
    Index count = 0;
    const auto collect = [&](Index from, Index to, Index h) {
      downward_[count] = {to, from, h, kNone};
      prefetch(table_ + begin_of(from > to ? to : from));
      count += from > to ? 1 : 0;
    };
    for (Index h = first; h < last; h += 3) {
      const Index a = corners_[h];
      const Index b = corners_[h + 1];
      const Index c = corners_[h + 2];
      collect(c, a, h);
      collect(a, b, h + 1);
      collect(b, c, h + 2);
    }
    downward_count_ = count;
  }

  // Takes the upward side from its group, if it is there. False if it has been taken before.
  [[nodiscard]] bool find_upward_side(Side& side) {
    const Index entry = find(side.low, side.high);
    if (entry == kNone) return true;
    side.upward = std::exchange(table_[entry + 1], kNone);
    if (side.upward == kNone) return false;
    prefetch(opposite_ + side.upward);
    return true;
  }

  // The entry of the side from `low` to `high`, or kNone. Most are among the first four, which are
  // compared without a branch, whether they belong to the group or not.
  [[nodiscard]] Index find(Index low, Index high) const {
    const Index begin = begin_of(low);
    const Index end = ends_[low];
    if (begin + 8 > groups_end_) return find_beyond(begin, begin, end, high);
    const Index* const key = table_ + begin;
    const Index no_0 = Index{key[0] != high};
    const Index no_1 = no_0 & Index{key[2] != high};
    const Index no_2 = no_1 & Index{key[4] != high};
    const Index no_3 = no_2 & Index{key[6] != high};
    const Index entry = begin + 2 * (no_0 + no_1 + no_2 + no_3);
    if (no_3 == 0 && entry < end) return entry;
    return find_beyond(begin, begin + 8, end, high);
  }

  // As find, from the entry `unseen` on.
  [[nodiscard]] Index find_beyond(Index begin, Index unseen, Index end, Index high) const {
    if (is_large(end - begin)) return find_sorted(begin, end, high);
    for (Index entry = unseen; entry < end; entry += 2) {
      if (table_[entry] == high) return entry;
    }
    return kNone;
  }

  [[nodiscard]] Index find_sorted(Index begin, Index end, Index high) const {
    for (Index count = (end - begin) / 2; count > 1;) {
      const Index half = count / 2;
      begin += table_[begin + 2 * half] <= high ? 2 * half : 0;
      count -= half;
    }
    return table_[begin] == high ? begin : kNone;
  }

  // Whether two upward sides lead from one vertex to the same other. If both found a downward side,
  // these clashed; so it is enough to look at sides that didn't. In sorted groups none repeats.
  [[nodiscard]] bool an_upward_side_repeats() const {
    for (Index h = 0; h < sides_; ++h) {
      if (opposite_[h] != kNone) continue;
      const Index to = corners_[h];
      const Index from = corners_[h % 3 == 0 ? h + 2 : h - 1];
      const Index end = ends_[from];
      if (from > to || is_large(end - begin_of(from))) continue;
      Index times = 0;
      for (Index entry = begin_of(from); entry != end; entry += 2) {
        times += Index{table_[entry] == to};
      }
      if (times > 1) return true;
    }
    return false;
  }

  // ---- the boundary

  ConnectResult write_corners_and_boundary(Index boundary) {
    const std::size_t halfedges = std::size_t{sides_} + boundary;
    if (!links_.opposite.resize(halfedges) || !links_.to_vertex.resize(halfedges) ||
        !links_.boundary_next.recreate(boundary) || !links_.boundary_prev.recreate(boundary)) {
      return ConnectResult::kOutOfMemory;
    }
    if (is_fresh_) {
      links_.opposite.shrink_to_fit();
      links_.to_vertex.shrink_to_fit();
    }
    Index* const opposite = links_.opposite.data();
    Index* const to = links_.to_vertex.data();
    std::copy(corners_, corners_ + sides_, to);
    if (boundary == 0) return ConnectResult::kDone;
    Index b = sides_;
    for (Index h = 0; h < sides_; ++h) {
      if (opposite[h] != kNone) continue;
      opposite[h] = b;
      opposite[b] = h;
      to[b] = links_.from_vertex(h);
      ++b;
    }
    return join_open_fans(links_);
  }

  const Index* corners_;
  Index sides_;
  const Polygons& triangles_;
  DirectedLinks& links_;
  Groups groups_;
  Index* opposite_ = nullptr;
  Index* table_ = nullptr;
  Index* ends_ = nullptr;  // of the groups
  Index groups_end_ = 0;
  std::array<Index, 2> not_upward_{};
  Index matched_ = 0;
  std::array<Side, std::size_t{3} * kFacesTogether>
      downward_;  // of the faces that are being matched
  Index downward_count_ = 0;
  bool is_fresh_ = false;
};

}  // namespace

ConnectResult connect_triangles(const Polygons& triangles, DirectedLinks& links) {
  const ConnectResult result = TriangleConnector(triangles, links).run();
  if (result != ConnectResult::kDone) return result;
  return each_vertex_has_one_cycle(links) ? ConnectResult::kDone : ConnectResult::kNotManifold;
}

}  // namespace halfedge
