#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/rings.h>
#include <halfedge/algorithms/touch_rings.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

namespace halfedge {

namespace {

Error corrupt(ItemKind kind, Index index) {
  return {"corrupt-connectivity",
          sentence::of("The ring around {} {} does not close: validate names the broken links.",
                       name_of(kind), index)};
}

Error no_room_for_lists() { return no_memory_for("the adjacency lists"); }

// Whether valences differ so much that a processor can't guess where the laps around vertices end.
// Looks at a few vertices, and at none of a small mesh, where it doesn't matter.
bool valences_vary(const RawLinks& links) {
  using Outgoing = RingOf<Vertex, walk::RotateCw, view::Self>;
  constexpr Index kSamples = 64;
  constexpr Index kMostSteps = 15;
  if (links.slots(Vertex{}) < 64 * kSamples) return false;
  std::array<Index, kMostSteps + 1> count{};  // by valence
  for (Index i = 0; i < kSamples; ++i) {
    const Vertex v(i * (links.slots(Vertex{}) / kSamples));
    Index steps = kMostSteps;
    if (has_ring(links, v)) {
      (void)walk_ring<Outgoing>(links, first_of<Outgoing>(links, v), steps, [](Index) {});
    }
    ++count[kMostSteps - steps];
  }
  return *std::max_element(count.begin(), count.end()) < kSamples / 8 * 7;
}

// Whether most faces are triangles. Looks at a few.
bool most_are_triangles(const RawLinks& links) {
  using Around = RingOf<Face, walk::LoopCcw, view::Self>;
  constexpr Index kSamples = 64;
  Index triangles = 0;
  for (Index i = 0; i < kSamples; ++i) {
    const Face f(Index(std::uint64_t{i} * links.slots(Face{}) / kSamples));
    Index steps = 4;
    if (!links.is_live(f)) continue;
    const bool closes = walk_ring<Around>(links, first_of<Around>(links, f), steps, [](Index) {});
    triangles += closes && steps == 1 ? 1 : 0;
  }
  return triangles > kSamples / 2;
}

// Whether short rings are best written without a loop.
bool pays_to_unroll(const RawLinks& links, ItemKind centre) {
  if (centre == ItemKind::kVertex) return valences_vary(links);
  return centre == ItemKind::kFace && most_are_triangles(links);
}

// Writes the ring that begins at `first` to `at`, and moves that behind it. False if it is broken,
// or longer than there is room before `end`. Where items can be missing `steps` counts down the
// steps; elsewhere the place to write to tells how many were taken.
template <class Ring>
bool write_ring_at(const RawLinks& links, Halfedge first, Index*& at, const Index* end,
                   [[maybe_unused]] Index& steps) {
  if constexpr (Ring::View::kCanBeEmpty) {
    return walk_ring<Ring>(links, first, steps, [&at](Index item) {
      *at = item;  // a missing item is overwritten by the next one
      at += item != kNone ? 1 : 0;
    });
  } else {
    if (!first.valid()) return false;
    Halfedge h = first;
    do {
      if (at == end) return false;
      *at++ = Ring::View::of(links, h).index();
      h = Ring::Walk::on(links, h);
      if (!links.contain(h)) return false;
    } while (h != first);
    return true;
  }
}

// The same for rings of a few items, without a loop whose end has to be found. False, with `at`
// where it was, if the ring is longer, broken, or has a missing item.
template <class Ring>
bool write_short_at(const RawLinks& links, Halfedge first, Index*& at, const Index* end,
                    Index& steps) {
  constexpr bool kCanBeEmpty = Ring::View::kCanBeEmpty;
  const Index room = kCanBeEmpty ? steps : Index(end - at);
  Index length = 3;
  if constexpr (std::is_same_v<typename Ring::Centre, Face>) {
    if (room < length || !write_triangle<Ring>(links, first, at)) return false;
  } else {
    length = write_short_ring<Ring>(links, first, at);
    if (length > std::min(room, kShortRing)) return false;
  }
  at += length;
  if constexpr (kCanBeEmpty) steps -= length;
  return true;
}

// Where the rings of a whole mesh are written, and how far they are.
struct Written {
  Index* const offsets;
  Index* const items;
  const Index* const end;
  Index* at;
  Index steps;  // that are left
};

// Writes the rings of `begin` to `stop` to arrays with room for them; the orbits of a valid mesh
// don't overlap, so all of them together have no more items than there are halfedges. Returns the
// first item whose ring is broken, or kNone.
template <class Ring, bool kTryShort>
Index write_rows(const RawLinks& of_mesh, Index begin, Index stop, Written& written) {
  using Centre = typename Ring::Centre;
  const RawLinks links = of_mesh;  // a local, which no write of an item can change
  const auto [offsets, items, end, place, steps_left] = written;
  Index* at = place;
  Index steps = steps_left;
  for (Index i = begin; i < stop; ++i) {
    offsets[i] = Index(at - items);
    if (!has_ring(links, Centre(i))) continue;
    const Halfedge first = first_of<Ring>(links, Centre(i));
    if (!first.valid()) return i;
    if constexpr (kTryShort) {
      if (write_short_at<Ring>(links, first, at, end, steps)) continue;
    }
    if (!write_ring_at<Ring>(links, first, at, end, steps)) return i;
  }
  written.at = at;
  written.steps = steps;
  return kNone;
}

// The length of one ring, or kNone if it is broken. Writes what fits, after the first `skip` items.
template <class Ring>
Index write_one(const RawLinks& links, Index centre, Index skip, Index* out, Index room) {
  using Centre = typename Ring::Centre;
  if (!has_ring(links, Centre(centre))) return 0;
  Index steps = links.halfedge_slots();
  Index size = 0;
  const Halfedge first = first_of<Ring>(links, Centre(centre));
  const bool closes = walk_ring<Ring>(links, first, steps, [&](Index item) {
    if (Ring::View::kCanBeEmpty && item == kNone) return;
    if (size >= skip && size - skip < room) out[size - skip] = item;
    ++size;
  });
  return closes ? size : kNone;
}

// What is known of a ring at run time.
struct RingFunctions {
  ItemKind kind;  // of the centre
  Index (*slots)(const RawLinks&);
  bool (*is_live)(const RawLinks&, Index);
  Index (*write_rows)(const RawLinks&, Index, Index, Written&);
  Index (*write_short_rows)(const RawLinks&, Index, Index, Written&);
  Index (*write_one)(const RawLinks&, Index, Index, Index*, Index);
};

template <class Ring>
constexpr RingFunctions functions() {
  using Centre = typename Ring::Centre;
  return {kind_of(Centre{}),
          [](const RawLinks& links) { return links.slots(Centre{}); },
          [](const RawLinks& links, Index centre) { return links.is_live(Centre(centre)); },
          &write_rows<Ring, false>,
          &write_rows<Ring, !std::is_same_v<Centre, Edge>>,
          &write_one<Ring>};
}

template <class View>
RingFunctions around_vertex(Direction direction) {
  return direction == Direction::kCw ? functions<RingOf<Vertex, walk::RotateCw, View>>()
                                     : functions<RingOf<Vertex, walk::RotateCcw, View>>();
}
template <class View>
RingFunctions around_face(Direction direction) {
  return direction == Direction::kCw ? functions<RingOf<Face, walk::LoopCw, View>>()
                                     : functions<RingOf<Face, walk::LoopCcw, View>>();
}
template <class View>
RingFunctions across_edge() {
  return functions<RingOf<Edge, walk::AcrossEdge, View>>();
}

RingFunctions functions_of(Ring ring, Direction direction) {
  switch (ring) {
    case Ring::kVertexVertices:
      return around_vertex<view::ToVertex>(direction);
    case Ring::kVertexOutgoing:
      return around_vertex<view::Self>(direction);
    case Ring::kVertexIncoming:
      return around_vertex<view::Opposite>(direction);
    case Ring::kVertexEdges:
      return around_vertex<view::ItsEdge>(direction);
    case Ring::kVertexFaces:
      return around_vertex<view::ItsFace>(direction);
    case Ring::kFaceVertices:
      return around_face<view::ToVertex>(direction);
    case Ring::kFaceHalfedges:
      return around_face<view::Self>(direction);
    case Ring::kFaceEdges:
      return around_face<view::ItsEdge>(direction);
    case Ring::kFaceFaces:
      return around_face<view::OppositeFace>(direction);
    case Ring::kEdgeVertices:
      return across_edge<view::ToVertex>();
    case Ring::kEdgeHalfedges:
      return across_edge<view::Self>();
    case Ring::kEdgeFaces:
      return across_edge<view::ItsFace>();
  }
  return across_edge<view::Self>();
}

// Writes the rings of the whole mesh, in blocks where it pays to touch those first. Returns what
// write_rows does.
Index write_all(const RawLinks& links, const RingFunctions& functions, const RingLayout& rings,
                Adjacency& out) {
  const auto write =
      pays_to_unroll(links, functions.kind) ? functions.write_short_rows : functions.write_rows;
  const bool scattered = are_scattered(rings);
  const Index slots = functions.slots(links);
  const Index together = scattered ? kRingsTouched : slots;
  Index* const items = out.items.data();
  Written written{out.offsets.data(), items, items + links.halfedge_slots(), items,
                  links.halfedge_slots()};
  for (Index begin = 0; begin < slots; begin += together) {
    if (scattered) touch_rings(rings, begin);
    const Index broken = write(links, begin, begin + std::min(together, slots - begin), written);
    if (broken != kNone) return broken;
  }
  const Index count = Index(written.at - items);
  out.offsets[slots] = count;
  (void)out.items.resize(count);  // shrinks
  return kNone;
}

// `where` says which of several it is, as in " at position 3".
Error no_such_centre(const RawLinks& links, const RingFunctions& functions, Index centre,
                     const std::string& where) {
  const std::string item = name_of(functions.kind) + (sentence::of(" {}", centre)) + where;
  const Index slots = functions.slots(links);
  if (centre < slots)
    return {"deleted-item", sentence::complete(sentence::of("{} is deleted", item))};
  return {"index-out-of-range", sentence::complete(sentence::of(
                                    "{} does not exist, expected less than {}", item, slots))};
}

// Counts the ring of each centre into `offsets`, summed up.
Result<void> sum_ring_lengths(const RawLinks& links, const RingFunctions& functions,
                              std::span<const Index> centres, Array<Index>& offsets) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    offsets[i] = Index(size);
    if (!functions.is_live(links, centres[i])) {
      return no_such_centre(links, functions, centres[i], sentence::of(" at position {}", i));
    }
    const Index length = functions.write_one(links, centres[i], 0, nullptr, 0);
    if (length == kNone) return corrupt(functions.kind, centres[i]);
    size += length;
    if (size >= kNone) {
      return Error{
          "too-large",
          sentence::of("The rings of the first {} items have {} items, expected less than {}.",
                       i + 1, size, kNone)};
    }
  }
  offsets[centres.size()] = Index(size);
  return {};
}

// Leaves `out` empty if `result` is an error.
Result<void> finish(Result<void> result, Adjacency& out) {
  if (!result.ok()) out.clear();
  return result;
}

// Without prev only one direction can be walked. The other is its exact reverse.
struct Walkable {
  Direction direction;
  bool is_reverse = false;

  Walkable(const RawLinks& links, Ring ring, Direction wanted) : direction(wanted) {
    if (links.stores_prev() || ring >= Ring::kEdgeVertices) return;
    direction = ring >= Ring::kFaceVertices ? Direction::kCcw : Direction::kCw;
    is_reverse = direction != wanted;
  }
  void turn_rows(Adjacency& rows) const {
    for (std::size_t i = 0; is_reverse && i + 1 < rows.offsets.size(); ++i) {
      std::reverse(rows.items.data() + rows.offsets[i], rows.items.data() + rows.offsets[i + 1]);
    }
  }
};

}  // namespace

Result<void> adjacency(const RawLinks& links, Ring ring, Direction direction, Adjacency& out) {
  const Walkable walkable(links, ring, direction);
  const RingFunctions functions = functions_of(ring, walkable.direction);
  // More than the items: a missing face is written before it is skipped, a short ring in full.
  if (!out.offsets.recreate(std::size_t{functions.slots(links)} + 1) ||
      !out.items.recreate(std::size_t{links.halfedge_slots()} + kShortRing)) {
    return finish(no_room_for_lists(), out);
  }
  const RingLayout rings = layout_of(links, ring, walkable.direction);
  const Index broken = write_all(links, functions, rings, out);
  if (broken != kNone) return finish(corrupt(functions.kind, broken), out);
  walkable.turn_rows(out);
  return {};
}

Result<void> adjacency(const RawLinks& links, Ring ring, Direction direction,
                       std::span<const Index> centres, Adjacency& out) {
  const Walkable walkable(links, ring, direction);
  const RingFunctions functions = functions_of(ring, walkable.direction);
  if (!out.offsets.recreate(centres.size() + 1)) return finish(no_room_for_lists(), out);
  Result<void> counted = sum_ring_lengths(links, functions, centres, out.offsets);
  if (!counted) return finish(counted, out);
  if (!out.items.recreate(out.offsets[centres.size()])) return finish(no_room_for_lists(), out);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Index first = out.offsets[i];
    (void)functions.write_one(links, centres[i], 0, out.items.data() + first,
                              out.offsets[i + 1] - first);
  }
  walkable.turn_rows(out);
  return {};
}

Result<Index> write_ring(const RawLinks& links, Ring ring, Direction direction, Index centre,
                         std::span<Index> out) {
  const Walkable walkable(links, ring, direction);
  const RingFunctions functions = functions_of(ring, walkable.direction);
  if (!functions.is_live(links, centre)) return no_such_centre(links, functions, centre, "");
  const Index room = Index(std::min(out.size(), std::size_t{kNone}));
  const Index length = functions.write_one(links, centre, 0, out.data(), room);
  if (length == kNone) return corrupt(functions.kind, centre);
  const Index written = std::min(length, room);
  if (walkable.is_reverse) {  // of what doesn't fit, its end comes first
    if (length > room) {
      (void)functions.write_one(links, centre, length - room, out.data(), room);
    }
    std::reverse(out.data(), out.data() + written);
  }
  return length;
}

}  // namespace halfedge
