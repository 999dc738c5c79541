#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/corrupt.h>
#include <halfedge/algorithms/rings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

namespace halfedge {

namespace {

Error corrupt(ItemKind kind, Index index) {
  return {"corrupt-connectivity", "the ring around " + std::string(name_of(kind)) + " " +
                                      std::to_string(index) +
                                      " does not close: validate names the broken links"};
}

Error out_of_memory() {
  return {"out-of-memory", "memory is exhausted: no room for the adjacency lists"};
}

// Whether valences differ so much that a processor can't guess where the laps around vertices end.
// Looks at a few vertices, and at none of a small mesh, where it doesn't matter.
bool valences_vary(const Connectivity& mesh, const RawLinks& links) {
  using Outgoing = RingOf<Vertex, walk::RotateCw, view::Self>;
  constexpr Index kSamples = 64;
  constexpr Index kMostSteps = 15;
  if (mesh.vertex_slots() < 64 * kSamples) return false;
  std::array<Index, kMostSteps + 1> count{};  // by valence
  for (Index i = 0; i < kSamples; ++i) {
    const Vertex v(i * (mesh.vertex_slots() / kSamples));
    Index steps = kMostSteps;
    if (has_ring(mesh, v)) {
      (void)walk_ring<Outgoing>(links, first_of<Outgoing>(mesh, links, v), steps, [](Index) {});
    }
    ++count[kMostSteps - steps];
  }
  return *std::max_element(count.begin(), count.end()) < kSamples / 8 * 7;
}

// Writes the whole mesh's rings to arrays with room for them; the orbits of a valid mesh don't
// overlap, so all of them together have no more items than there are halfedges. Returns the first
// item whose ring is broken, or kNone.
template <class Ring, bool kTryShort = false>
Index write_all(const Connectivity& mesh, Adjacency& out) {
  using Centre = typename Ring::Centre;
  const RawLinks links(mesh);
  if constexpr (std::is_same_v<Centre, Vertex> && !kTryShort) {
    if (valences_vary(mesh, links)) return write_all<Ring, true>(mesh, out);
  }
  const Index slots = mesh.slots(Centre{});
  Index steps = mesh.halfedge_slots();
  Index* const items = out.items.data();
  Index* const offsets = out.offsets.data();
  Index size = 0;
  for (Index i = 0; i < slots; ++i) {
    offsets[i] = size;
    if (!has_ring(mesh, Centre(i))) continue;
    const Halfedge first = first_of<Ring>(mesh, links, Centre(i));
    if constexpr (kTryShort) {
      const Index length = write_short_ring<Ring>(links, first, items + size);
      if (length <= std::min(steps, kShortRing)) {
        steps -= length;
        size += length;
        continue;
      }
    }
    const bool closes = walk_ring<Ring>(links, first, steps, [&](Index item) {
      items[size] = item;  // a missing face is overwritten by the next item
      size += !Ring::View::kCanBeEmpty || item != kNone ? 1 : 0;
    });
    if (!closes) return i;
  }
  offsets[slots] = size;
  (void)out.items.resize(size);  // shrinks
  return kNone;
}

// The length of one ring, or kNone if it is broken. Writes what fits.
template <class Ring>
Index write_one(const Connectivity& mesh, Index centre, Index* out, Index room) {
  using Centre = typename Ring::Centre;
  if (!has_ring(mesh, Centre(centre))) return 0;
  Index steps = mesh.halfedge_slots();
  Index size = 0;
  const RawLinks links(mesh);
  const Halfedge first = first_of<Ring>(mesh, links, Centre(centre));
  const bool closes = walk_ring<Ring>(links, first, steps, [&](Index item) {
    if (Ring::View::kCanBeEmpty && item == kNone) return;
    if (size < room) out[size] = item;
    ++size;
  });
  return closes ? size : kNone;
}

// What is known of a ring at run time.
struct RingFunctions {
  ItemKind kind;  // of the centre
  Index (*slots)(const Connectivity&);
  bool (*is_live)(const Connectivity&, Index);
  Index (*write_all)(const Connectivity&, Adjacency&);
  Index (*write_one)(const Connectivity&, Index, Index*, Index);
};

template <class Ring>
constexpr RingFunctions functions() {
  using Centre = typename Ring::Centre;
  return {kind_of(Centre{}), [](const Connectivity& mesh) { return mesh.slots(Centre{}); },
          [](const Connectivity& mesh, Index centre) { return mesh.is_live(Centre(centre)); },
          &write_all<Ring>, &write_one<Ring>};
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

// `where` says which of several it is, as in " at position 3".
Error no_such_centre(const Connectivity& mesh, const RingFunctions& functions, Index centre,
                     const std::string& where) {
  const std::string item = name_of(functions.kind) + (" " + std::to_string(centre)) + where;
  const Index slots = functions.slots(mesh);
  if (centre < slots) return {"deleted-item", item + " is deleted"};
  return {"index-out-of-range",
          item + " does not exist, expected less than " + std::to_string(slots)};
}

// Counts the ring of each centre into `offsets`, summed up.
Result<void> sum_ring_lengths(const Connectivity& mesh, const RingFunctions& functions,
                              std::span<const Index> centres, Array<Index>& offsets) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    offsets[i] = Index(size);
    if (!functions.is_live(mesh, centres[i])) {
      return no_such_centre(mesh, functions, centres[i], " at position " + std::to_string(i));
    }
    const Index length = functions.write_one(mesh, centres[i], nullptr, 0);
    if (length == kNone) return corrupt(functions.kind, centres[i]);
    size += length;
    if (size >= kNone) {
      return Error{"too-large", "the rings of the first " + std::to_string(i + 1) + " items have " +
                                    std::to_string(size) + " items, expected less than " +
                                    std::to_string(kNone)};
    }
  }
  offsets[centres.size()] = Index(size);
  return {};
}

// Leaves `out` empty if `result` is an error.
Result<void> finish(Result<void> result, Adjacency& out) {
  if (!result.ok()) {
    out.offsets.clear();
    out.items.clear();
  }
  return result;
}

}  // namespace

Result<void> adjacency(const Connectivity& mesh, Ring ring, Direction direction, Adjacency& out) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return finish(sizes, out);
  const RingFunctions functions = functions_of(ring, direction);
  // More than the items: a missing face is written before it is skipped, a short ring in full.
  if (!out.offsets.recreate(std::size_t{functions.slots(mesh)} + 1) ||
      !out.items.recreate(std::size_t{mesh.halfedge_slots()} + kShortRing)) {
    return finish(out_of_memory(), out);
  }
  const Index broken = functions.write_all(mesh, out);
  return finish(broken == kNone ? Result<void>{} : corrupt(functions.kind, broken), out);
}

Result<void> adjacency(const Connectivity& mesh, Ring ring, Direction direction,
                       std::span<const Index> centres, Adjacency& out) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return finish(sizes, out);
  const RingFunctions functions = functions_of(ring, direction);
  if (!out.offsets.recreate(centres.size() + 1)) return finish(out_of_memory(), out);
  Result<void> counted = sum_ring_lengths(mesh, functions, centres, out.offsets);
  if (!counted) return finish(counted, out);
  if (!out.items.recreate(out.offsets[centres.size()])) return finish(out_of_memory(), out);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Index first = out.offsets[i];
    (void)functions.write_one(mesh, centres[i], out.items.data() + first,
                              out.offsets[i + 1] - first);
  }
  return {};
}

Result<Index> write_ring(const Connectivity& mesh, Ring ring, Direction direction, Index centre,
                         std::span<Index> out) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes.error();
  const RingFunctions functions = functions_of(ring, direction);
  if (!functions.is_live(mesh, centre)) return no_such_centre(mesh, functions, centre, "");
  const Index room = Index(std::min(out.size(), std::size_t{kNone}));
  const Index length = functions.write_one(mesh, centre, out.data(), room);
  if (length == kNone) return corrupt(functions.kind, centre);
  return length;
}

}  // namespace halfedge
