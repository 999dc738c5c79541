#include <halfedge/algorithms/touch_rings.h>
#include <halfedge/inlining.h>
#include <halfedge/prefetch.h>

#include <array>
#include <cstddef>

namespace halfedge {

namespace {

const Index* items_of(const RawLinks& links, Ring ring) {
  switch (ring) {
    case Ring::kVertexVertices:
    case Ring::kFaceVertices:
      return links.all_to_vertex();
    case Ring::kVertexFaces:
    case Ring::kFaceFaces:
      return links.all_face();
    case Ring::kVertexOutgoing:
    case Ring::kVertexIncoming:
    case Ring::kVertexEdges:
    case Ring::kFaceHalfedges:
    case Ring::kFaceEdges:
    case Ring::kEdgeVertices:
    case Ring::kEdgeHalfedges:
    case Ring::kEdgeFaces:
      break;
  }
  return nullptr;  // nothing is read but the steps
}

}  // namespace

HALFEDGE_NOINLINE RingLayout layout_of(const RawLinks& links, Ring ring, Direction direction) {
  if (ring >= Ring::kEdgeVertices) return {};
  const bool around_face = ring >= Ring::kFaceVertices;
  const bool cw = direction == Direction::kCw;
  RingLayout rings;
  rings.firsts =
      around_face ? links.all_stored_halfedges(Face{}) : links.all_stored_halfedges(Vertex{});
  rings.steps = around_face == cw ? links.all_prev() : links.all_next();
  rings.items = items_of(links, ring);
  if (rings.items == nullptr) rings.items = rings.steps;
  rings.centres = around_face ? links.slots(Face{}) : links.slots(Vertex{});
  rings.halfedges = links.halfedge_slots();
  rings.before = !around_face && cw ? 1 : 0;
  rings.after = !around_face && !cw ? 1 : 0;
  rings.length = around_face ? 3 : 6;
  return rings;
}

HALFEDGE_NOINLINE bool are_scattered(const RingLayout& rings) {
  constexpr Index kSamples = 64;
  constexpr Index kFar = 1U << 16U;  // a quarter of a megabyte of each array
  if (rings.centres < 64 * kSamples) return false;
  Index far = 0;
  for (Index i = 0; i < kSamples; ++i) {
    // One more each time, so as not to meet only the boundary of a grid.
    const Index h = rings.firsts[i * (rings.centres / kSamples) + i];
    if (h >= rings.halfedges) continue;
    far += rings.steps[h ^ rings.before] - h + kFar > 2 * kFar ? 1 : 0;
  }
  return far > kSamples / 8;
}

HALFEDGE_NOINLINE void touch_rings(const RingLayout& rings, Index centre) {
  if (rings.centres - centre < kRingsTouched) return;
  const auto [firsts, steps, items, centres, halfedges, before, after, length] = rings;
  std::array<Index, kRingsTouched> at;
  for (std::size_t i = 0; i < kRingsTouched; ++i) {
    const Index first = firsts[centre + i];
    at[i] = first < halfedges ? first : 0;
  }
  for (Index step = 0; step < length; ++step) {
    for (Index& h : at) {
      touch(items + h);
      const Index next = steps[h ^ before] ^ after;
      h = next < halfedges ? next : 0;
    }
  }
  for (const Index h : at) touch(items + h);
}

HALFEDGE_NOINLINE RingToucher::RingToucher(const RawLinks& links, Ring ring, Direction direction)
    : rings_(layout_of(links, ring, direction)), untouched_(are_scattered(rings_) ? 0 : kNone) {}

HALFEDGE_NOINLINE void RingToucher::touch_from(Index centre) {
  touch_rings(rings_, centre);
  untouched_ = centre + kRingsTouched;
}

}  // namespace halfedge
