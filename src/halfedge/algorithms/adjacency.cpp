#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/corrupt.h>

#include <algorithm>
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

// The links as the walks and views of the circulators read them, by raw pointers. A halfedge is
// checked against `halfedge_slots` once, when it is stepped to; the arrays are equally long.
class RawLinks {
 public:
  explicit RawLinks(const Connectivity& mesh)
      : halfedge_slots_(mesh.halfedge_slots()),
        next_(mesh.links().next.data()),
        prev_(mesh.links().prev.data()),
        to_vertex_(mesh.links().to_vertex.data()),
        face_(mesh.links().face.data()) {}

  [[nodiscard]] bool contain(Halfedge h) const { return h.index() < halfedge_slots_; }

  [[nodiscard]] Halfedge next(Halfedge h) const { return Halfedge(next_[h.index()]); }
  [[nodiscard]] Halfedge prev(Halfedge h) const { return Halfedge(prev_[h.index()]); }
  [[nodiscard]] Vertex to_vertex(Halfedge h) const { return Vertex(to_vertex_[h.index()]); }
  [[nodiscard]] Face face(Halfedge h) const { return Face(face_[h.index()]); }
  [[nodiscard]] static Halfedge opposite(Halfedge h) { return Connectivity::opposite(h); }
  [[nodiscard]] static Edge edge(Halfedge h) { return Connectivity::edge(h); }
  [[nodiscard]] Halfedge rotate_cw(Halfedge h) const { return next(opposite(h)); }
  [[nodiscard]] Halfedge rotate_ccw(Halfedge h) const { return opposite(prev(h)); }

 private:
  Index halfedge_slots_;
  const Index* next_;
  const Index* prev_;
  const Index* to_vertex_;
  const Index* face_;
};

// A ring is a centre, a walk and a view; the circulators are made of the same ones.
template <class CentreType, class WalkType, class ViewType>
struct RingOf {
  using Centre = CentreType;
  using Walk = WalkType;
  using View = ViewType;
  // The exact reverse of a lap that begins at the anchor begins one step on from it.
  static constexpr bool kBeginsOneStepOn =
      std::is_same_v<Walk, walk::RotateCcw> || std::is_same_v<Walk, walk::LoopCw>;
};

Halfedge stored_halfedge(const Connectivity& mesh, Vertex v) { return mesh.vertex_halfedge(v); }
Halfedge stored_halfedge(const Connectivity& mesh, Face f) { return mesh.face_halfedge(f); }
Halfedge stored_halfedge(const Connectivity& mesh, Edge e) { return mesh.edge_halfedge(e); }

bool has_ring(const Connectivity& mesh, Vertex v) {
  return !mesh.is_deleted(v) && !mesh.is_isolated(v);
}
bool has_ring(const Connectivity& mesh, Face f) { return !mesh.is_deleted(f); }
bool has_ring(const Connectivity& mesh, Edge e) { return !mesh.is_deleted(e); }

// Shows `put` each item of the ring, in order. Takes at most `steps` steps and counts them down;
// false if they don't suffice or lead out of the arrays, which only happens if the mesh is corrupt.
template <class Ring, class Put>
bool walk_ring(const RawLinks& links, Halfedge first, Index& steps, Put&& put) {
  if (!links.contain(first)) return false;
  if constexpr (Ring::kBeginsOneStepOn) {
    first = Ring::Walk::on(links, first);
    if (!links.contain(first)) return false;
  }
  Halfedge h = first;
  do {
    if (steps-- == 0) return false;
    put(Ring::View::of(links, h).index());
    h = Ring::Walk::on(links, h);
    if (!links.contain(h)) return false;
  } while (h != first);
  return true;
}

// Writes the whole mesh's rings to arrays with room for them; the orbits of a valid mesh don't
// overlap, so all of them together have no more items than there are halfedges. Returns the first
// item whose ring is broken, or kNone.
template <class Ring>
Index write_all(const Connectivity& mesh, Adjacency& out) {
  using Centre = typename Ring::Centre;
  const RawLinks links(mesh);
  const Index slots = mesh.slots(Centre{});
  Index steps = mesh.halfedge_slots();
  Index* const items = out.items.data();
  Index* const offsets = out.offsets.data();
  Index size = 0;
  for (Index i = 0; i < slots; ++i) {
    offsets[i] = size;
    if (!has_ring(mesh, Centre(i))) continue;
    const bool closes =
        walk_ring<Ring>(links, stored_halfedge(mesh, Centre(i)), steps, [&](Index item) {
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
  const bool closes = walk_ring<Ring>(RawLinks(mesh), stored_halfedge(mesh, Centre(centre)), steps,
                                      [&](Index item) {
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
  // One item more: a missing face is written before it is skipped.
  if (!out.offsets.recreate(std::size_t{functions.slots(mesh)} + 1) ||
      !out.items.recreate(std::size_t{mesh.halfedge_slots()} + 1)) {
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
