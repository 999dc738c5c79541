#include <halfedge/build/match_bucket.h>
#include <halfedge/inlining.h>
#include <halfedge/sort.h>

#include <bit>
#include <cstring>
#include <span>
#include <utility>

namespace halfedge {

namespace {

constexpr Index kAtOnce = 16;

// Which of these places hold this vertex: a bit for each, of every second one. Without a branch,
// and all of them at once: compilers make no vectors of the loop.
[[gnu::always_inline]] inline Index places_with(Index vertex, const Index* places) {
#if defined(__GNUC__)
  using Four = Index __attribute__((vector_size(16)));
  Four words[4];
  std::memcpy(words, places, sizeof words);
  const Four sought = {vertex, vertex, vertex, vertex};
  const Four found = (Four(words[0] == sought) & Four{1U << 0, 0, 1U << 2, 0}) |
                     (Four(words[1] == sought) & Four{1U << 4, 0, 1U << 6, 0}) |
                     (Four(words[2] == sought) & Four{1U << 8, 0, 1U << 10, 0}) |
                     (Four(words[3] == sought) & Four{1U << 12, 0, 1U << 14, 0});
  return found[0] | found[2];
#else
  Index found = 0;
  for (Index i = 0; i < kAtOnce; i += 2) found |= Index{places[i] == vertex} << i;
  return found;
#endif
}

// The first of the places `begin`, `begin + 2`, ... before `end` that holds this vertex, or kNone.
[[gnu::always_inline]] inline Index find(Index vertex, std::span<const Index> places, Index begin,
                                         Index end) {
  for (; places.size() - begin >= kAtOnce; begin += kAtOnce) {
    const Index found = places_with(vertex, places.data() + begin);
    if (found != 0) {
      const Index place = begin + Index(std::countr_zero(found));
      return place < end ? place : kNone;
    }
    if (end - begin <= kAtOnce) return kNone;
  }
  for (; begin < end; begin += 2) {
    if (places[begin] == vertex) return begin;
  }
  return kNone;
}

}  // namespace

bool BucketMatcher::match(const Bucket& bucket, Array<UnforeseenEdge>& unforeseen) {
  if (!place_ups(bucket)) return false;
  Index matched = 0;
  if (!match_downs(bucket, unforeseen, matched)) return false;
  return matched == bucket.ups_end - bucket.begin || close_ups(bucket);
}

// The halfedge of a side that runs up is its place; that of the other side leads nowhere yet.
bool BucketMatcher::place_ups(const Bucket& bucket) {
  const Index* const low_of = low_of_;
  const Index* const high_of = high_of_;
  Index* const halfedge_of = halfedge_of_;
  Index* const to_vertex = to_vertex_;
  Index loops = 0;
  for (Index side = bucket.begin; side < bucket.ups_end; ++side) {
    const Index low = low_of[side];
    const Index high = high_of[side];
    Index& next_place = groups_.next_up_place(low);
    const Index place = next_place;
    next_place = place + 2;
    to_vertex[place] = high;
    to_vertex[place + 1] = kNone;
    halfedge_of[side] = place;
    loops |= Index{low == high};
  }
  return loops == 0;
}

bool BucketMatcher::match_downs(const Bucket& bucket, Array<UnforeseenEdge>& unforeseen,
                                Index& matched) {
  const Index* const low_of = low_of_;
  const Index* const high_of = high_of_;
  Index* const halfedge_of = halfedge_of_;
  Index* const to_vertex = to_vertex_;
  const std::span<const Index> places(to_vertex, groups_.end());
  Index clashes = 0;
  Index added = 0;
  for (Index side = bucket.downs_begin; side < bucket.downs_end; ++side) {
    const Index low = low_of[side];
    const Index up = find(high_of[side], places, groups_.begin_of(low), groups_.next_up_place(low));
    if (up == kNone) {
      add(side, unforeseen);
      ++added;
      continue;
    }
    clashes |= Index{to_vertex[up + 1] != kNone};
    to_vertex[up + 1] = low;
    halfedge_of[side] = up + 1;
  }
  matched = bucket.downs_end - bucket.downs_begin - added;
  return clashes == 0;
}

// A side that runs down, alone along its edge. If its group has places left, its edge gets the next
// two, where the same side would find it once more.
HALFEDGE_NOINLINE void BucketMatcher::add(Index side, Array<UnforeseenEdge>& unforeseen) {
  const Index low = low_of_[side];
  const Index place = groups_.next_up_place(low);
  if (place == groups_.begin_of(low + 1)) {
    is_out_of_memory_ |= !unforeseen.push_back({side, low, high_of_[side]});
    return;
  }
  groups_.next_up_place(low) = place + 2;
  to_vertex_[place] = high_of_[side];
  to_vertex_[place + 1] = low;
  halfedge_of_[side] = place + 1;
}

// The sides that run up and that no other one has matched. False if one of them repeats another.
HALFEDGE_NOINLINE bool BucketMatcher::close_ups(const Bucket& bucket) {
  const std::span<const Index> places(to_vertex_, groups_.end());
  for (Index side = bucket.begin; side < bucket.ups_end; ++side) {
    const Index place = halfedge_of_[side];
    if (to_vertex_[place + 1] != kNone) continue;
    const Index low = low_of_[side];
    to_vertex_[place + 1] = low;
    if (find(high_of_[side], places, groups_.begin_of(low), place) != kNone) return false;
  }
  return true;
}

HALFEDGE_COLD bool sort_unforeseen(Array<UnforeseenEdge>& edges, Array<Index>& marks) {
  introsort(edges, [](const UnforeseenEdge& a, const UnforeseenEdge& b) {
    return a.low != b.low ? a.low < b.low : a.side < b.side;
  });
  for (const UnforeseenEdge& edge : edges) {
    if (std::exchange(marks[edge.high], edge.low) == edge.low) return false;
  }
  return true;
}

}  // namespace halfedge
