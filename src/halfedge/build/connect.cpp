#include <halfedge/build/connect.h>
#include <halfedge/build/each_face.h>
#include <halfedge/build/fans.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/inlining.h>
#include <halfedge/prefetch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace halfedge {

namespace {

// From so many vertices on, what belongs to one doesn't stay in the cache: it is fetched when the
// corners so many places before are at work.
constexpr std::size_t kTooManyForCache = 300'000;
constexpr std::size_t kAhead = 48;

// A side of a face *runs up* if it leads from the smaller vertex of its edge to the larger, else it
// runs down. The sides of all edges of which a vertex is the smaller one, its *group*, are brought
// together, and with them their edges get their numbers:
//
//   count   how many sides of each group run up, and down; the larger number is that of its edges
//   place   each side in its group: those that run up at even halfedges, those that run down at odd
//           ones, each as they come
//   match   group by group, the sides that run down to those that run up, by their larger vertex
//   link    face by face, the halfedges of its sides
//
// The halfedge of a side that runs up is where it was placed. One that runs down takes the opposite
// of the one that it matches. If it matches none, its edge has no face on the other side, and takes
// a place of the group that is left, or one after all groups.
//
// Nothing is searched for, so that there is no branch which can't be predicted, and no valence that
// takes longer. In a manifold no two sides of a group run the same way to the same vertex: of those
// that do, the second finds the place of its larger vertex taken.
template <bool kTriangles, bool kPrev>
class SideConnector {
 public:
  SideConnector(const Polygons& polygons, Links& links)
      : polygons_(polygons), links_(links), vertices_(polygons.vertex_count()) {}

  // Inlined, all instances of it take half as much code again.
  HALFEDGE_NOINLINE_IN_WASM ConnectResult run() {
    if (!count_sides()) return ConnectResult::kOutOfMemory;
    if (is_refused_) return ConnectResult::kNotManifold;
    begin_groups();
    if (groups_end_ > kMaxSlots) return ConnectResult::kTooLarge;
    if (!make_room()) return ConnectResult::kOutOfMemory;
    place_sides();
    if (!match_sides()) return ConnectResult::kOutOfMemory;
    if (is_refused_) return ConnectResult::kNotManifold;
    const ConnectResult added = add_unforeseen_edges();
    if (added != ConnectResult::kDone) return added;
    link_faces();
    if constexpr (!kPrev) write_faces();
    return ConnectResult::kDone;
  }

 private:
  // ---- count

  // An edge, and which way a side runs along it. Without a branch, which couldn't be predicted, and
  // which compilers make of std::min.
  struct Direction {
    Index low;
    Index high;
    Index down;  // 1 if the side runs down

    Direction(Index from, Index to)
        : low(std::min(from, to)), high(from + to - low), down(Index{from > to}) {}
    // The two places of a vertex in `places_`: of its sides that run up, and of those that run
    // down.
    [[nodiscard]] std::size_t place() const { return std::size_t{2} * low + down; }
  };

  // False when memory is exhausted. Refuses faces that have a vertex twice.
  [[nodiscard]] bool count_sides() {
    Array<Index>& last_faces = links_.vertex_halfedge;  // scratch: the last face of a vertex so far
    if (!places_.resize(2 * vertices_, 0) || !last_faces.recreate(vertices_)) return false;
    if (!kTriangles) std::fill(last_faces.begin(), last_faces.end(), kNone);
    Index* const counts = places_.data();
    [[maybe_unused]] Index* const last_face = last_faces.data();
    Index repeats = 0;
    for_each_face<kTriangles>(
        polygons_, [=, &repeats]([[maybe_unused]] Index f, const Index* corners, auto size) {
          if constexpr (kTriangles) {
            repeats |= Index{corners[0] == corners[1]} | Index{corners[1] == corners[2]} |
                       Index{corners[2] == corners[0]};
          }
          for (Index i = 0; i < size; ++i) {
            const Index from = corners[i];
            if constexpr (!kTriangles) {
              repeats |= Index{last_face[from] == f};
              last_face[from] = f;
            }
            counts[Direction(from, corners[i + 1 == size ? 0 : i + 1]).place()] += 2;
          }
        });
    is_refused_ = repeats != 0;
    return true;
  }

  // Makes of each two numbers of sides the halfedges at which the first of them will be placed.
  void begin_groups() {
    Index begin = 0;
    for (std::size_t i = 0; i < places_.size(); i += 2) {
      const Index size = std::max(places_[i], places_[i + 1]);
      places_[i] = begin;
      places_[i + 1] = begin + 1;
      begin += size;
    }
    groups_end_ = begin;
  }

  // ---- place

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
    std::size_t count = std::max<std::size_t>(groups_end_, polygons_.corners.size());
    for (const Array<Index>* array : halfedge_arrays()) is_fresh_ |= array->capacity() < count;
    if (is_fresh_) count += 4 * std::size_t(std::sqrt(double(count))) + 64;
    for (Array<Index>* array : halfedge_arrays()) {
      if (!array->recreate(count)) return false;
    }
    use_arrays();
    return links_.face_halfedge.recreate(polygons_.face_count());
  }

  // Until faces are linked, two arrays hold what is needed on the way there. The one of the sides
  // is written last: `face` if there is no `prev`.
  void use_arrays() {
    next_ = links_.next.data();
    to_ = links_.to_vertex.data();
    face_ = links_.face.data();
    side_at_ = next_;
    halfedge_of_ = kPrev ? links_.prev.data() : face_;
  }

  void place_sides() {
    Index side = 0;
    for_each_face<kTriangles>(polygons_, [&](Index, const Index* corners, auto size) {
      if constexpr (kCanPrefetch) fetch_places(corners, side);
      for (Index i = 0; i < size; ++i) {
        place(side + i, corners[i], corners[i + 1 == size ? 0 : i + 1]);
      }
      side += size;
    });
  }

  void place(Index side, Index from, Index to) {
    const Direction direction(from, to);
    Index& next_place = places_[direction.place()];
    const Index h = next_place;
    next_place = h + 2;
    to_[h] = direction.high;
    side_at_[h] = side;
    halfedge_of_[side] = h;
  }

  // What the sides of three corners need that come later, if it is far from what they need now.
  [[gnu::always_inline]] void fetch_places(const Index* corners, Index side) const {
    if (vertices_ < kTooManyForCache || polygons_.corners.size() - side <= 2 * kAhead + 3) return;
    const Index* const ahead = corners + kAhead;
    const Index* const far_ahead = ahead + kAhead;
    if (are_near(corners[0], far_ahead[0])) return;
    for (int i = 0; i < 3; ++i) {
      prefetch(&places_[Direction(far_ahead[i], far_ahead[i + 1]).place()]);
      const Index h = places_[Direction(ahead[i], ahead[i + 1]).place()];
      prefetch(to_ + h);
      prefetch(side_at_ + h);
    }
  }

  // ---- match

  // A group has the halfedges [begin, end). The sides of `low` that run up lie at even ones before
  // up_end, those that run down at odd ones before down_end.
  struct Group {
    Index low;
    Index begin;
    Index up_end;
    Index down_end;

    [[nodiscard]] Index end() const { return std::max(up_end, down_end); }
    [[nodiscard]] bool has(Index h) const { return h - begin < end() - begin; }
  };

  // A side that runs down, and whose edge no place is left for in its group.
  struct Unforeseen {
    Index side;
    Index low;
    Index high;
  };

  // False when memory is exhausted.
  [[nodiscard]] bool match_sides() {
    Array<Index>& edges = links_.vertex_halfedge;  // scratch, see match_group
    std::fill(edges.begin(), edges.end(), kNone);
    Index clashes = 0;
    Index begin = 0;
    for (Index low = 0; low < vertices_; ++low) {
      const Index* const ends = &places_[2 * std::size_t{low}];
      const Group group{low, begin, ends[0], ends[1] - 1};
      clashes |= match_group(group, edges.data());
      begin = group.end();
    }
    is_refused_ = clashes != 0;
    return fits_;
  }

  // `edge_to` holds for each vertex the halfedge of this group that leads there: an even one whose
  // opposite is free, an odd one if it isn't. What it holds of other groups counts for nothing.
  // Returns 1 if two sides run the same way along an edge.
  [[nodiscard]] Index match_group(const Group& group, Index* edge_to) {
    Index clashes = 0;
    for (Index h = group.begin; h != group.up_end; h += 2) {
      if constexpr (kCanPrefetch) fetch_matches(h, edge_to);
      Index& edge = edge_to[to_[h]];
      clashes |= Index{group.has(edge)};
      edge = h;
    }
    Index free = group.up_end;
    Index unmatched = 0;
    for (Index h = group.begin; h != group.down_end; h += 2) {
      const Index side = side_at_[h + 1];
      const Index high = to_[h + 1];
      to_[h + 1] = group.low;
      Index& edge = edge_to[high];
      const Index found = edge;
      if (group.has(found)) {
        clashes |= found & 1U;
        halfedge_of_[side] = found | 1U;
        edge = found | 1U;
      } else {
        edge = group.begin + 1;
        free = add_edge(group, free, side, high);
        ++unmatched;
      }
    }
    if (group.up_end + 2 * unmatched != group.down_end) close_upward_edges(group, edge_to);
    return clashes;
  }

  // Gives a side that runs down, and matches none, the edge at `free`, if that is in its group.
  // Returns the next free one.
  HALFEDGE_NOINLINE Index add_edge(const Group& group, Index free, Index side, Index high) {
    if (free >= group.down_end) {
      fits_ &= unforeseen_.push_back({side, group.low, high});
      return free;
    }
    halfedge_of_[side] = free + 1;
    to_[free] = high;
    mark_boundary(free);
    return free + 2;
  }

  // The edges of those that run up and no side runs down to.
  void close_upward_edges(const Group& group, const Index* edge_to) {
    for (Index h = group.begin; h != group.up_end; h += 2) {
      to_[h + 1] = group.low;
      if (edge_to[to_[h]] == h) mark_boundary(h + 1);
    }
  }

  // Without `prev`, faces have no array yet.
  void mark_boundary([[maybe_unused]] Index h) {
    if constexpr (kPrev) face_[h] = kNone;
  }

  // What is needed for the groups that come later.
  [[gnu::always_inline]] void fetch_matches(Index h, const Index* edge_to) const {
    const Index ahead = h + 64;
    if (ahead >= groups_end_) return;
    prefetch(edge_to + to_[ahead]);
    prefetch(halfedge_of_ + side_at_[ahead + 1]);
  }

  // Sees to it that arrays have the size that they need, and no more memory if it was made for
  // them.
  [[nodiscard]] ConnectResult add_unforeseen_edges() {
    const std::size_t count = groups_end_ + 2 * unforeseen_.size();
    if (count > kMaxSlots) return ConnectResult::kTooLarge;
    for (Array<Index>* array : halfedge_arrays()) {
      if (!array->resize(count)) return ConnectResult::kOutOfMemory;
      if (is_fresh_) array->shrink_to_fit();
    }
    use_arrays();
    Index h = groups_end_;
    for (const Unforeseen& edge : unforeseen_) {
      to_[h] = edge.high;
      to_[h + 1] = edge.low;
      mark_boundary(h);
      halfedge_of_[edge.side] = h + 1;
      h += 2;
    }
    return ConnectResult::kDone;
  }

  // ---- link

  void link_faces() {
    Index* const anchors = links_.vertex_halfedge.data();
    Index* const firsts = links_.face_halfedge.data();
    std::fill(anchors, anchors + vertices_, kNone);
    const Index* side = halfedge_of_;
    for_each_face<kTriangles>(polygons_, [&](Index f, const Index* corners, auto size) {
      if constexpr (kCanPrefetch) fetch_links(side);
      Index before = side[size - 1];
      firsts[f] = before;
      for (Index i = 0; i < size; ++i) {
        const Index h = side[i];
        next_[before] = h;
        if constexpr (kPrev) face_[h] = f;
        anchors[corners[i]] = h;
        before = h;
      }
      side += size;
    });
  }

  [[gnu::always_inline]] void fetch_links(const Index* side) const {
    if (std::size_t(halfedge_of_ + polygons_.corners.size() - side) <= kAhead + 3) return;
    for (std::size_t i = kAhead; i < kAhead + 3; ++i) {
      prefetch(next_ + side[i]);
      if constexpr (kPrev) prefetch(face_ + side[i]);
    }
  }

  // Where `face` held something else until now.
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
  std::size_t vertices_;
  Array<Index> places_;
  Index groups_end_ = 0;
  Array<Unforeseen> unforeseen_;
  bool is_refused_ = false;
  bool fits_ = true;
  bool is_fresh_ = false;
  Index* next_ = nullptr;
  Index* to_ = nullptr;
  Index* face_ = nullptr;
  Index* side_at_ = nullptr;      // the side at each halfedge that has one which runs down
  Index* halfedge_of_ = nullptr;  // of each side
};

bool all_triangles(std::span<const Index> sizes) {
  Index different = 0;
  for (const Index size : sizes) different |= size ^ 3U;
  return different == 0;
}

void write_prev(Links& links) {
  const Index* const next = links.next.data();
  Index* const prev = links.prev.data();
  const Index count = Index(links.next.size());
  for (Index h = 0; h < count; ++h) prev[next[h]] = h;
}

}  // namespace

template <bool kPrev>
ConnectResult connect(const Polygons& polygons, Links& links) {
  const ConnectResult result = all_triangles(polygons.sizes)
                                   ? SideConnector<true, kPrev>(polygons, links).run()
                                   : SideConnector<false, kPrev>(polygons, links).run();
  if (result != ConnectResult::kDone) return result;
  const bool is_closed = links.next.size() == polygons.corners.size();
  if (!is_closed && !join_open_fans(links)) return ConnectResult::kOutOfMemory;
  if constexpr (kPrev) write_prev(links);
  if (!each_vertex_has_one_cycle(links)) return ConnectResult::kNotManifold;
  return ConnectResult::kDone;
}

template ConnectResult connect<true>(const Polygons& polygons, Links& links);
template ConnectResult connect<false>(const Polygons& polygons, Links& links);

}  // namespace halfedge
