#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/connectivity.h>
#include <halfedge/mesh.h>
#include <halfedge/prefetch.h>
#include <halfedge/refusals.h>
#include <halfedge/result.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

/// The steps of which the operations consist. A link that the mesh type doesn't store is empty when
/// read and not written. New items get the attributes of those that they are made of, as far as the
/// steps say; else the default, as all that is new. What a step costs is O(1), but for the search
/// for a prev that isn't stored.
namespace halfedge::steps {

// ---- checks ---------------------------------------------------------------------------------

template <class Mesh, class Item>
[[nodiscard]] Result<void> check_live(const Mesh& mesh, Item item) {
  if (mesh.is_live(item)) return {};
  return refusals::not_live(kind_of(item), item.index(), mesh.slots(item));
}

template <class Mesh>
[[nodiscard]] Face face_of(const Mesh& mesh, [[maybe_unused]] Halfedge h) {
  if constexpr (StoresFaces<Mesh>) return mesh.face(h);
  return {};
}

/// Where faces aren't stored every loop counts as a face.
template <class Mesh>
[[nodiscard]] bool is_boundary(const Mesh& mesh, [[maybe_unused]] Halfedge h) {
  return StoresFaces<Mesh> && !face_of(mesh, h).valid();
}

/// O(1) if one of them has a face, else O(degree).
template <class Mesh>
[[nodiscard]] bool is_one_loop(const Mesh& mesh, Halfedge h, Halfedge g) {
  if (face_of(mesh, h).valid() || face_of(mesh, g).valid()) {
    return face_of(mesh, h) == face_of(mesh, g);
  }
  for (const Halfedge on_loop : mesh.loop_ccw(h)) {
    if (on_loop == g) return true;
  }
  return false;
}

// ---- memory ---------------------------------------------------------------------------------

/// How much to reserve for `count` items where there is room for `capacity`, so that a sequence of
/// operations is amortised O(1) each.
/// pre: count <= kMaxSlots
[[nodiscard]] inline Index with_slack(std::uint64_t count, std::uint64_t capacity) {
  if (count <= capacity) return Index(count);
  const std::size_t ample = internal::ample_capacity(std::size_t(count), std::size_t(capacity));
  return Index(std::min(ample, std::size_t{kMaxSlots}));
}

template <class Mesh>
[[nodiscard]] std::size_t vertex_capacity(const Mesh& mesh) {
  std::size_t capacity = kMaxSlots;
  if constexpr (StoresAnchors<Mesh>) capacity = mesh.links().vertex_halfedge.capacity();
  if constexpr (HasPositions<Mesh>) {
    capacity = std::min(capacity, mesh.position_array().capacity() / 3);
  }
  return capacity;
}

/// Room for so many items more, so that new_vertex, new_edge and new_face succeed so many times.
/// False when memory is exhausted; the mesh is then as it was.
template <class Mesh>
[[nodiscard]] bool make_room(Mesh& mesh, Index vertices, Index edges, Index faces) {
  const auto count = [](std::uint64_t slots, const FreeList& free, Index more) {
    return slots + (more > free.count ? more - free.count : 0);
  };
  const std::uint64_t v = count(mesh.vertex_slots(), mesh.free_vertices(), vertices);
  const std::uint64_t e = count(mesh.edge_slots(), mesh.free_edges(), edges);
  const std::uint64_t f = count(mesh.face_slots(), mesh.free_faces(), faces);
  const std::size_t edge_room = mesh.capacity(ItemKind::kEdge);
  const std::size_t face_room = mesh.links().face_halfedge.capacity();
  const std::size_t vertex_room = vertex_capacity(mesh);
  if (v <= vertex_room && e <= edge_room && f <= face_room && !mesh.attributes().has_any()) {
    return true;
  }
  if (v > kMaxSlots || e > kMaxSlots / 2 || f > kMaxSlots) return false;
  return mesh.reserve(with_slack(v, vertex_room), std::min(with_slack(e, edge_room), kMaxSlots / 2),
                      with_slack(f, face_room)) ||
         mesh.reserve(Index(v), Index(e), Index(f));
}

// ---- cache ----------------------------------------------------------------------------------
// Always inlined, for the reason that `prefetch` is.

/// Asks for the lines of memory where the links of `h` are, to have them on their way while others
/// are waited for.
template <class Mesh>
[[gnu::always_inline]] inline void fetch_links(const Mesh& mesh, Halfedge h) {
  const Links& links = mesh.links();
  prefetch(links.next.data() + h.index());
  prefetch(links.to_vertex.data() + h.index());
  if (mesh.stores_prev()) prefetch(links.prev.data() + h.index());
  if constexpr (StoresFaces<Mesh>) prefetch(links.face.data() + h.index());
}

/// The same for the halfedges that a vertex and a face know. Either may be empty.
template <class Mesh>
[[gnu::always_inline]] inline void fetch_halfedges_of(const Mesh& mesh, Vertex v, Face f) {
  const Links& links = mesh.links();
  if (StoresAnchors<Mesh> && v.valid()) prefetch(links.vertex_halfedge.data() + v.index());
  if (StoresFaceHalfedges<Mesh> && f.valid()) prefetch(links.face_halfedge.data() + f.index());
}

/// The same for a position, where there are any.
template <class Mesh>
[[gnu::always_inline]] inline void fetch_position([[maybe_unused]] const Mesh& mesh,
                                                  [[maybe_unused]] Vertex v) {
  if constexpr (HasPositions<Mesh>) {
    prefetch(mesh.positions().data() + 3 * std::size_t{v.index()});
  }
}

// ---- faces ----------------------------------------------------------------------------------

template <class Mesh>
void set_face(Mesh& mesh, [[maybe_unused]] Halfedge h, [[maybe_unused]] Face f) {
  if constexpr (StoresFaces<Mesh>) mesh.set_face(h, f);
}

template <class Mesh>
void set_face_of_loop(Mesh& mesh, Halfedge h, Face f) {
  if constexpr (StoresFaces<Mesh>) {
    const auto writer = mesh.writer();
    Halfedge on_loop = h;
    do {
      writer.set_face(on_loop, f);
      on_loop = mesh.next(on_loop);
    } while (on_loop != h);
  }
}

/// A new face whose halfedge is `h`, with the attributes of `like` if that is not empty; empty
/// where faces aren't stored. pre: there is room for it
template <class Mesh>
[[nodiscard]] Face new_face_like(Mesh& mesh, [[maybe_unused]] Halfedge h,
                                 [[maybe_unused]] Face like) {
  Face f;
  if constexpr (StoresFaces<Mesh>) {
    f = mesh.new_face(h);
    if (like.valid()) mesh.copy_attributes(f, like);
  }
  return f;
}

/// The loop of `h` becomes a new face, with the attributes of `like` if that is not empty.
/// pre: there is room for it
template <class Mesh>
void make_face(Mesh& mesh, Halfedge h, Face like = {}) {
  const Face f = new_face_like(mesh, h, like);
  set_face_of_loop(mesh, h, f);
}

template <class Mesh>
void release_face(Mesh& mesh, Face f) {
  if constexpr (StoresFaceHalfedges<Mesh>) {
    if (f.valid()) mesh.release(f);
  }
}

/// If `gone` is the halfedge of its face `f`, `instead` becomes it.
template <class Mesh>
void replace_in_face(Mesh& mesh, Face f, Halfedge gone, Halfedge instead) {
  if constexpr (StoresFaceHalfedges<Mesh>) {
    if (f.valid() && mesh.face_halfedge(f) == gone) mesh.set_face_halfedge(f, instead);
  }
}

/// If the halfedge of `f` doesn't lie in it any more, `instead` becomes it.
template <class Mesh>
void mend_face(Mesh& mesh, Face f, Halfedge instead) {
  if constexpr (StoresFaceHalfedges<Mesh>) {
    if (f.valid() && mesh.face(mesh.face_halfedge(f)) != f) mesh.set_face_halfedge(f, instead);
  }
}

// ---- vertices -------------------------------------------------------------------------------

template <class Mesh>
void set_anchor(Mesh& mesh, [[maybe_unused]] Vertex v, [[maybe_unused]] Halfedge h) {
  if constexpr (StoresAnchors<Mesh>) mesh.set_vertex_halfedge(v, h);
}

/// If `gone` is the anchor of `v`, `instead` becomes it.
template <class Mesh>
void replace_anchor(Mesh& mesh, Vertex v, Halfedge gone, Halfedge instead) {
  if constexpr (StoresAnchors<Mesh>) {
    if (mesh.vertex_halfedge(v) == gone) mesh.set_vertex_halfedge(v, instead);
  }
}

/// Invariants 4 and 5 at the vertex that `leaving` leaves; an anchor that holds them stays.
/// O(valence)
template <class Mesh>
void mend_anchor(Mesh& mesh, Halfedge leaving) {
  if constexpr (StoresAnchors<Mesh>) {
    const Vertex v = mesh.from_vertex(leaving);
    const Halfedge anchor = mesh.vertex_halfedge(v);
    if (!anchor.valid() || mesh.from_vertex(anchor) != v) mesh.set_vertex_halfedge(v, leaving);
    if constexpr (StoresFaces<Mesh>) {
      if (!mesh.is_boundary(mesh.vertex_halfedge(v))) mesh.adjust_anchor(v);
    }
  }
}

/// As mend_anchor for all vertices of the loop of `h`. O(sum of valences)
template <class Mesh>
void mend_anchors_of_loop(Mesh& mesh, Halfedge h) {
  Halfedge on_loop = h;
  do {
    mend_anchor(mesh, on_loop);
    on_loop = mesh.next(on_loop);
  } while (on_loop != h);
}

/// A new vertex with the attributes of `v`, where that is if vertices have positions.
/// pre: there is room for it
template <class Mesh>
[[nodiscard]] Vertex copy_vertex(Mesh& mesh, Vertex v) {
  const Vertex copy = mesh.new_vertex();
  if constexpr (HasPositions<Mesh>) mesh.set_position(copy, mesh.position(v));
  mesh.copy_attributes(copy, v);
  return copy;
}

/// (1 - t) a + t b
[[nodiscard]] inline Point blend(Point a, Point b, double t) {
  const auto mean = [t](float from, float to) {
    return float((1 - t) * double{from} + t * double{to});
  };
  return {mean(a.x, b.x), mean(a.y, b.y), mean(a.z, b.z)};
}

/// A new vertex between `a` and `b`: midway, or nearer to `b` if `t` > 1/2.
/// pre: there is room for it
template <class Mesh>
[[nodiscard]] Vertex new_vertex_between(Mesh& mesh, Vertex a, Vertex b, double t = 0.5) {
  const Vertex v = mesh.new_vertex();
  if constexpr (HasPositions<Mesh>) {
    mesh.set_position(v, blend(mesh.position(a), mesh.position(b), t));
  }
  mesh.blend_attributes(v, a, b, t);
  return v;
}

// ---- edges ----------------------------------------------------------------------------------

/// The edge of `h` gets the attributes of that of `like`, whose direction it has.
template <class Mesh>
void copy_edge(Mesh& mesh, Halfedge h, Halfedge like) {
  mesh.copy_attributes(mesh.edge(h), mesh.edge(like));
  mesh.copy_attributes(h, like);
  mesh.copy_attributes(mesh.opposite(h), mesh.opposite(like));
}

/// A new edge with the attributes of the edge of `like`, whose direction it has.
/// pre: there is room for it
template <class Mesh>
[[nodiscard]] Halfedge new_edge_like(Mesh& mesh, Vertex from, Vertex to, Halfedge like) {
  const Halfedge h = mesh.new_edge(from, to);
  copy_edge(mesh, h, like);
  return h;
}

/// The tip of the edge of `h` enters the corner after `v`: v -> opposite(h), h -> next(v). So the
/// corner is divided into two alike.
template <class Mesh>
void insert_tip(Mesh& mesh, Halfedge h, Halfedge v) {
  mesh.copy_corner(h, v);
  const auto writer = mesh.writer();
  writer.link(h, mesh.next(v));
  writer.link(v, mesh.opposite(h));
  writer.set_to_vertex(h, mesh.to_vertex(v));
}

/// `h` enters the loop of `f` after `f`: f -> h -> next(f). So the corner after `f` becomes two
/// alike.
template <class Mesh>
void insert_halfedge(Mesh& mesh, Halfedge h, Halfedge f) {
  mesh.copy_corner(h, f);
  mesh.link(h, mesh.next(f));
  mesh.link(f, h);
  set_face(mesh, h, face_of(mesh, f));
}

/// The next halfedge clockwise after `h` that leaves from_vertex(h) by another edge, or empty.
template <class Mesh>
[[nodiscard]] Halfedge beside(const Mesh& mesh, Halfedge h) {
  Halfedge found = mesh.rotate_cw(h);
  if (found == mesh.opposite(h)) found = mesh.rotate_cw(found);  // h is a loop edge
  return found == h ? Halfedge{} : found;
}

/// Takes an edge out of the orbits of its ends, whose anchors move on where they must, and releases
/// it. An end that has no other edge is left isolated. Faces are the caller's.
template <class Mesh>
void erase_edge(Mesh& mesh, Halfedge h) {
  const Halfedge o = mesh.opposite(h);
  for (const Halfedge side : {h, o}) {
    replace_anchor(mesh, mesh.from_vertex(side), side, beside(mesh, side));
  }
  const Halfedge before[] = {mesh.prev(h), mesh.prev(o)};
  const Halfedge after[] = {beside(mesh, h), beside(mesh, o)};
  for (const int side : {0, 1}) {
    if (mesh.edge(before[side]) != mesh.edge(h)) mesh.link(before[side], after[side]);
  }
  mesh.release(mesh.edge(h));
}

}  // namespace halfedge::steps
