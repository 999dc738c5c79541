#include <halfedge/build/match_bucket.h>
#include <halfedge/inlining.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace halfedge {

namespace {

constexpr Index kAtOnce = 16;

#if defined(__wasm_simd128__) || defined(__SSE2__)
constexpr bool kCanCompareAtOnce = true;

// Which of so many words are this one: a bit for each.
[[gnu::always_inline]] inline Index words_equal_to(Index sought, const Index* words) {
#if defined(__wasm_simd128__)
  const auto are_equal = [=, four = wasm_i32x4_splat(std::int32_t(sought))](int i) {
    return wasm_i32x4_eq(wasm_v128_load(words + i), four);
  };
  const v128_t first = wasm_i16x8_narrow_i32x4(are_equal(0), are_equal(4));
  const v128_t last = wasm_i16x8_narrow_i32x4(are_equal(8), are_equal(12));
  return Index(wasm_i8x16_bitmask(wasm_i8x16_narrow_i16x8(first, last)));
#else
  const auto are_equal = [=, four = _mm_set1_epi32(std::int32_t(sought))](int i) {
    return _mm_cmpeq_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(words + i)), four);
  };
  const __m128i first = _mm_packs_epi32(are_equal(0), are_equal(4));
  const __m128i last = _mm_packs_epi32(are_equal(8), are_equal(12));
  return Index(_mm_movemask_epi8(_mm_packs_epi16(first, last)));
#endif
}
#else
constexpr bool kCanCompareAtOnce = false;
Index words_equal_to(Index, const Index*) { return 0; }
#endif

// The first of the places `begin`, `begin + 2`, ... before `end` that holds this vertex, or kNone.
// Those between them hold the smaller vertex of the group, if any, and not this one.
[[gnu::always_inline]] inline Index find(Index vertex, std::span<const Index> places, Index begin,
                                         Index end) {
  for (; kCanCompareAtOnce && places.size() - begin >= kAtOnce; begin += kAtOnce) {
    const Index found = words_equal_to(vertex, places.data() + begin);
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
  Index* const next_places = groups_.next_places();
  std::fill(to_vertex + bucket.begin, to_vertex + bucket.end, kNone);
  Index loops = 0;
  for (Index side = bucket.begin; side < bucket.ups_end; ++side) {
    const Index low = low_of[side];
    const Index high = high_of[side];
    Index& next_place = next_places[2 * std::size_t{low}];
    const Index place = next_place;
    next_place = place + 2;
    to_vertex[place] = high;
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
  const Index* const next_places = groups_.next_places();
  Index clashes = 0;
  Index added = 0;
  for (Index side = bucket.downs_begin; side < bucket.downs_end; ++side) {
    const Index low = low_of[side];
    const Index* const next = next_places + 2 * std::size_t{low};  // as begin_of() reads it
    const Index up = find(high_of[side], places, next[1] - 1, next[0]);
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
