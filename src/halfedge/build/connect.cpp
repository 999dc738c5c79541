#include <halfedge/build/buckets.h>
#include <halfedge/build/connect.h>
#include <halfedge/build/each_face.h>
#include <halfedge/build/fans.h>
#include <halfedge/build/groups.h>
#include <halfedge/build/match_bucket.h>
#include <halfedge/build/order.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/inlining.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace halfedge {

namespace {

// What belongs to a corner or a halfedge is fetched when those so many places before are at work.
constexpr Index kAhead = 96;

// Touches what is needed for these places of groups, if their sides are scattered. Where no side
// lies, there is anything.
HALFEDGE_NOINLINE void touch_places(std::span<const Index> places, std::span<const Index> edge_to,
                                    std::span<const Index> halfedge_of) {
  const Index sides = Index(halfedge_of.size());
  if (!are_scattered(places[1], places.back(), sides)) return;
  for (std::size_t i = 0; i < places.size(); i += 2) {
    touch(&edge_to[std::min(places[i], Index(edge_to.size() - 1))]);
    touch(&halfedge_of[std::min(places[i + 1], sides - 1)]);
  }
}

// Finds the halfedge of each side by matching sides in groups (groups.h), and links faces then. The
// halfedge of a side that runs up is its place. One that runs down takes the opposite of the one
// that it matches. If it matches none, no face is on the other side of its edge, for which there
// are two places of its group, as a rule, that no other edge has.
template <bool kTriangles, bool kPrev>
class SideConnector {
 public:
  // `fetches`: whether to ask for memory ahead where sides are placed and faces linked, too. While
  // sides are matched, it is asked for in any case.
  SideConnector(const Polygons& polygons, Links& links, bool fetches)
      : polygons_(polygons), links_(links), fetches_(fetches) {}

  // Inlined, all instances of it take half as much code again.
  HALFEDGE_NOINLINE_IN_WASM ConnectResult run() {
    Array<Index>& scratch = links_.vertex_halfedge;
    bool repeated = false;
    if (!groups_.count<kTriangles>(polygons_, scratch, repeated)) {
      return ConnectResult::kOutOfMemory;
    }
    if (repeated) return ConnectResult::kNotManifold;
    if (groups_.end() > kMaxSlots) return ConnectResult::kTooLarge;
    if (!make_room()) return ConnectResult::kOutOfMemory;
    const bool is_divided = kTriangles && kPrev && Buckets::pay(polygons_) &&
                            buckets_.set_up(groups_, polygons_.vertex_count());
    bool is_manifold = false;
    if (is_divided) {
      is_manifold = match_divided_sides();
    } else {
      place_sides();
      is_manifold = groups_.match(scratch, Places{to_, halfedge_of_, *this});
    }
    if (is_out_of_memory_) return ConnectResult::kOutOfMemory;
    if (!is_manifold) return ConnectResult::kNotManifold;
    const ConnectResult added = add_unforeseen_edges();
    if (added != ConnectResult::kDone) return added;
    if (is_divided) {
      link_divided_faces();
    } else {
      link_faces();
    }
    if constexpr (!kPrev) write_faces();
    return ConnectResult::kDone;
  }

 private:
  // What lies at the places of groups. By value, so that loops keep it in registers.
  struct Places {
    Index* to;
    Index* halfedge_of;
    SideConnector& connector;

    [[gnu::always_inline]] void fetch(Index place, const Index* edge_to) const {
      prefetch(edge_to + to[place]);
      prefetch(halfedge_of + to[place + 1]);
    }
    void touch(Index begin, Index end, std::span<const Index> edge_to) const {
      touch_places({to + begin, end - begin}, edge_to, {halfedge_of, connector.groups_.end()});
    }
    [[nodiscard]] Index high_up(Index place) const { return to[place]; }
    // The place, odd as it is, will be a halfedge that leads to `low`, of one edge or another.
    [[nodiscard]] Index take_down(Index place, Index low) const {
      return std::exchange(to[place], low);
    }
    [[nodiscard]] Index high_down(Index side) const { return halfedge_of[side]; }
    void join(Index up, Index side) const { halfedge_of[side] = up + 1; }
    void add(Index side, Index low, Index high, Index place) const {
      connector.add_edge(side, low, high, place);
    }
    void close(Index up, Index low, bool is_single) const {
      to[up + 1] = low;
      if (is_single) connector.mark_boundary(up + 1);
    }
  };

  [[nodiscard]] auto halfedge_arrays() const {
    if constexpr (kPrev) {
      return std::array{&links_.next, &links_.to_vertex, &links_.face, &links_.prev};
    } else {
      return std::array{&links_.next, &links_.to_vertex, &links_.face};
    }
  }

  // A mesh that lacks room for the groups gets a little more, so that a few edges after them cost
  // no reallocation; add_unforeseen_edges() gives back what isn't used.
  [[nodiscard]] bool make_room() {
    std::size_t count = std::max<std::size_t>(groups_.end(), sides());
    for (const Array<Index>* array : halfedge_arrays()) is_fresh_ |= array->capacity() < count;
    if (is_fresh_) count += 4 * std::size_t(std::sqrt(double(count))) + 64;
    for (Array<Index>* array : halfedge_arrays()) {
      if (!array->recreate(count)) return false;
    }
    use_arrays();
    return links_.face_halfedge.recreate(polygons_.face_count());
  }

  // `halfedge_of_` borrows an array that is written last: `prev`, or `face` if there is no `prev`.
  void use_arrays() {
    next_ = links_.next.data();
    to_ = links_.to_vertex.data();
    face_ = links_.face.data();
    halfedge_of_ = kPrev ? links_.prev.data() : face_;
  }

  // ---- places

  // What is known of a side until it is matched:
  //
  //                       side runs up         side runs down
  //   to_[place]          its larger vertex    its number
  //   halfedge_of_[side]  its place            its larger vertex
  //
  // So only one array is written in the order of groups, which is the slow one.
  HALFEDGE_NOINLINE void place_sides() {
    const Index fetching =
        fetches_ && is_large() ? corners_before_last(Groups::kPlacingAhead + 3) : 0;
    Index first = 0;
    for_each_face<kTriangles>(polygons_, [&](Index, const Index* corners, auto size) {
      if (kCanPrefetch && first < fetching) groups_.fetch_places(corners, to_);
      for (Index i = 0; i < size; ++i) {
        place_side(first + i, corners[i], corners[i + 1 == size ? 0 : i + 1]);
      }
      first += size;
    });
  }

  [[gnu::always_inline]] void place_side(Index side, Index from, Index to) {
    const DirectedSide direction(from, to);
    Index& next_place = groups_.next_place(direction);
    const Index place = next_place;
    next_place = place + 2;
    to_[place] = direction.pick(to, side);
    halfedge_of_[side] = direction.pick(place, from);
  }

  // Numbers sides as their buckets keep them, and finds their halfedges bucket by bucket. Their
  // vertices lie in arrays that are written later, and so do the lists of sides until faces are
  // linked.
  HALFEDGE_NOINLINE bool match_divided_sides() {
    Index* const low_of = next_;
    Index* const high_of = face_;
    buckets_.divide(polygons_, links_.face_halfedge.span(), [=](Index slot, Index low, Index high) {
      low_of[slot] = low;
      high_of[slot] = high;
    });
    BucketMatcher matcher(groups_, low_of, high_of, halfedge_of_, to_);
    bool is_manifold = true;
    buckets_.for_each_bucket([&](const Bucket& bucket) {
      is_manifold = is_manifold && matcher.match(bucket, unforeseen_);
    });
    is_out_of_memory_ = matcher.is_out_of_memory();
    Array<Index>& marks = links_.vertex_halfedge;
    std::fill(marks.begin(), marks.end(), kNone);
    return is_manifold && sort_unforeseen(unforeseen_, marks);
  }

  [[nodiscard]] std::size_t sides() const { return polygons_.corners.size(); }
  [[nodiscard]] bool is_large() const { return polygons_.vertex_count() >= kTooManyForCache; }

  // How many corners there are before the last ones, so many of them.
  [[nodiscard]] Index corners_before_last(std::size_t count) const {
    return Index(sides() - std::min(sides(), count));
  }

  // The edge of a side that runs down and is alone.
  HALFEDGE_NOINLINE void add_edge(Index side, Index low, Index high, Index place) {
    if (place == kNone) {
      is_out_of_memory_ |= !unforeseen_.push_back({side, low, high});
      return;
    }
    halfedge_of_[side] = place + 1;
    to_[place] = high;
    mark_boundary(place);
  }

  // Without `prev`, faces have no array yet.
  void mark_boundary([[maybe_unused]] Index h) {
    if constexpr (kPrev) face_[h] = kNone;
  }

  // Gives arrays the size that they need now, and no more memory if they were made for this mesh.
  [[nodiscard]] ConnectResult add_unforeseen_edges() {
    const std::size_t count = groups_.end() + 2 * unforeseen_.size();
    if (count > kMaxSlots) return ConnectResult::kTooLarge;
    for (Array<Index>* array : halfedge_arrays()) {
      if (!array->resize(count)) return ConnectResult::kOutOfMemory;
    }
    use_arrays();
    Index h = groups_.end();
    for (const UnforeseenEdge& edge : unforeseen_) {
      to_[h] = edge.high;
      to_[h + 1] = edge.low;
      mark_boundary(h);
      halfedge_of_[edge.side] = h + 1;
      h += 2;
    }
    if (!is_fresh_) return ConnectResult::kDone;
    for (Array<Index>* array : halfedge_arrays()) array->shrink_to_fit();
    use_arrays();
    return ConnectResult::kDone;
  }

  // ---- links

  // Isolated vertices have their anchor: kNone, as no edge led to them when sides were matched.
  void link_faces() {
    Index* const anchors = links_.vertex_halfedge.data();
    Index* const firsts = links_.face_halfedge.data();
    const Index* halfedges = halfedge_of_;
    const Index* const fetching = halfedges + (fetches_ ? corners_before_last(kAhead + 3) : 0);
    Index* const far_anchors = is_large() ? anchors : nullptr;
    for_each_face<kTriangles>(polygons_, [&](Index f, const Index* corners, auto size) {
      if (kCanPrefetch && halfedges < fetching) {
        fetch_links(halfedges + kAhead, corners + kAhead, far_anchors);
      }
      Index before = halfedges[size - 1];
      firsts[f] = before;
      for (Index i = 0; i < size; ++i) {
        const Index h = halfedges[i];
        next_[before] = h;
        if constexpr (kPrev) face_[h] = f;
        anchors[corners[i]] = h;
        before = h;
      }
      halfedges += size;
    });
  }

  // As link_faces(). What a side links its halfedge to is kept in its bucket first, and written
  // bucket by bucket then: what belongs to the halfedges of one fits into the cache.
  HALFEDGE_NOINLINE void link_divided_faces() {
    anchor_at_divided_sides();
    Index* const firsts = links_.face_halfedge.data();
    Index* const next = next_;
    Index* const face = face_;
    const Index* const halfedge_of = halfedge_of_;
    buckets_.for_each_triangle(links_.face_halfedge.span(), [=](Index f, const auto& slots) {
      Index before = slots[2];
      firsts[f] = halfedge_of[before];
      for (Index i = 0; i < 3; ++i) {
        next[before] = halfedge_of[slots[i]];
        face[slots[i]] = f;
        before = slots[i];
      }
    });
    Index* const kept = groups_.scratch().data();  // set_up() has seen to it that there is room
    buckets_.for_each_bucket([=](const Bucket& bucket) {
      const Index count = bucket.end - bucket.begin;
      std::copy_n(next + bucket.begin, count, kept);
      std::copy_n(face + bucket.begin, count, kept + count);
      std::fill_n(face + bucket.begin, count, kNone);  // boundary halfedges, but for the others
      const auto link = [=](Index side, Index end) {
        for (; side < end; ++side) {
          const Index h = halfedge_of[side];
          next[h] = kept[side - bucket.begin];
          face[h] = kept[count + side - bucket.begin];
        }
      };
      link(bucket.begin, bucket.ups_end);
      link(bucket.downs_begin, bucket.downs_end);
    });
  }

  // Anchors each vertex on the halfedge of its last side. In a pass of its own: what is scattered
  // over all vertices and what goes to all buckets drive each other out of the cache.
  HALFEDGE_NOINLINE void anchor_at_divided_sides() {
    Index* const anchors = links_.vertex_halfedge.data();
    const Index* const corners = polygons_.corners.data();
    buckets_.for_each_triangle(links_.face_halfedge.span(), [=](Index f, const auto& slots) {
      for (Index i = 0; i < 3; ++i) anchors[corners[3 * std::size_t{f} + i]] = slots[i];
    });
    for (Index& anchor : links_.vertex_halfedge) {
      if (anchor != kNone) anchor = halfedge_of_[anchor];
    }
  }

  // `anchors` can be null.
  [[gnu::always_inline]] void fetch_links(const Index* halfedges, const Index* corners,
                                          const Index* anchors) const {
    for (int i = 0; i < 3; ++i) {
      prefetch(next_ + halfedges[i]);
      if constexpr (kPrev) prefetch(face_ + halfedges[i]);
    }
    if (anchors == nullptr) return;
    for (int i = 0; i < 3; ++i) prefetch(anchors + corners[i]);
  }

  // Where `face` has held something else until now.
  void write_faces() {
    std::fill(links_.face.begin(), links_.face.end(), kNone);
    for (Index f = 0; f < links_.face_halfedge.size(); ++f) {
      const Index first = links_.face_halfedge[f];
      Index h = first;
      do {
        face_[h] = f;
        h = next_[h];
      } while (h != first);
    }
  }

  const Polygons& polygons_;
  Links& links_;
  const bool fetches_;
  Groups groups_;
  Buckets buckets_;
  Array<UnforeseenEdge> unforeseen_;
  bool is_out_of_memory_ = false;
  bool is_fresh_ = false;
  Index* next_ = nullptr;
  Index* to_ = nullptr;
  Index* face_ = nullptr;
  Index* halfedge_of_ = nullptr;  // by side
};

// Four steps to a round: what counts the rounds takes a third of the time else.
void write_prev(Links& links, [[maybe_unused]] bool fetches) {
  const Index* const next = links.next.data();
  Index* const prev = links.prev.data();
  const Index count = Index(links.next.size());
  Index h = 0;
  if constexpr (kCanPrefetch) {  // WebAssembly gains nothing by four steps to a round
    const Index fetching = fetches && count > kAhead + 3 ? count - kAhead - 3 : 0;
    for (; count - h >= 4; h += 4) {
      if (h < fetching) {
        for (Index i = h; i < h + 4; ++i) prefetch(prev + next[i + kAhead]);
      }
      for (Index i = h; i < h + 4; ++i) prev[next[i]] = i;
    }
  }
  for (; h < count; ++h) prev[next[h]] = h;
}

}  // namespace

template <bool kPrev>
ConnectResult connect(const Polygons& polygons, Links& links) {
  const bool fetches = kCanPrefetch && !lie_in_rows(polygons);
  const ConnectResult result = polygons.are_triangles()
                                   ? SideConnector<true, kPrev>(polygons, links, fetches).run()
                                   : SideConnector<false, kPrev>(polygons, links, fetches).run();
  if (result != ConnectResult::kDone) return result;
  const bool is_closed = links.next.size() == polygons.corners.size();
  if (!is_closed && !join_open_fans(links)) return ConnectResult::kOutOfMemory;
  if constexpr (kPrev) write_prev(links, fetches);
  if (!each_vertex_has_one_cycle(links)) return ConnectResult::kNotManifold;
  return ConnectResult::kDone;
}

template ConnectResult connect<true>(const Polygons& polygons, Links& links);
template ConnectResult connect<false>(const Polygons& polygons, Links& links);

}  // namespace halfedge
