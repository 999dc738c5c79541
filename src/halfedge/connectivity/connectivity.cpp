#include <halfedge/connectivity/connectivity.h>

namespace halfedge {

namespace {

using FreeList = Connectivity::FreeList;

// A deleted slot stores the next one of its chain below kDeleted, so that every stored value has
// the sign bit set and can't be taken for a live link.
constexpr Index encode(Index next_free) {
  return next_free == kNone ? kDeleted : kDeleted - 1 - next_free;
}

void push(FreeList& list, Index slot, Index& link) {
  link = encode(list.head);
  list.head = slot;
  ++list.count;
}

Index pop(FreeList& list, const Array<Index>& links, Index stride) {
  const Index slot = list.head;
  list.head = next_free_slot(links[std::size_t{slot} * stride]);
  --list.count;
  return slot;
}

// Grows by half, so that a sequence of single additions is amortised O(1).
bool grow(Array<Index>& array, std::size_t count) {
  if (count <= array.capacity()) return true;
  return array.reserve(std::max(count, array.capacity() + array.capacity() / 2 + 16)) ||
         array.reserve(count);
}

}  // namespace

Connectivity& Connectivity::operator=(Connectivity&& other) noexcept {
  if (this == &other) return *this;
  links_ = std::move(other.links_);
  free_vertices_ = std::exchange(other.free_vertices_, {});
  free_edges_ = std::exchange(other.free_edges_, {});
  free_faces_ = std::exchange(other.free_faces_, {});
  // Not the version of `other`, which a circulator of this mesh may remember by chance.
  version_ = std::max(version_, other.version_) + 1;
  ++other.version_;
  return *this;
}

bool Connectivity::reserve(Index vertices, Index edges, Index faces) {
  const std::size_t halfedges = 2 * std::size_t{edges};
  return links_.vertex_halfedge.reserve(vertices) && links_.face_halfedge.reserve(faces) &&
         links_.next.reserve(halfedges) && links_.prev.reserve(halfedges) &&
         links_.to_vertex.reserve(halfedges) && links_.face.reserve(halfedges);
}

void Connectivity::clear() {
  links_.next.clear();
  links_.prev.clear();
  links_.to_vertex.clear();
  links_.face.clear();
  links_.vertex_halfedge.clear();
  links_.face_halfedge.clear();
  free_vertices_ = free_edges_ = free_faces_ = FreeList{};
  ++version_;
}

bool Connectivity::assign(const Connectivity& other) {
  if (this == &other) return true;
  const Links& from = other.links_;
  const bool fits = links_.next.assign(from.next.span()) && links_.prev.assign(from.prev.span()) &&
                    links_.to_vertex.assign(from.to_vertex.span()) &&
                    links_.face.assign(from.face.span()) &&
                    links_.vertex_halfedge.assign(from.vertex_halfedge.span()) &&
                    links_.face_halfedge.assign(from.face_halfedge.span());
  if (!fits) {
    clear();
    return false;
  }
  free_vertices_ = other.free_vertices_;
  free_edges_ = other.free_edges_;
  free_faces_ = other.free_faces_;
  ++version_;
  return true;
}

Vertex Connectivity::new_vertex() {
  Array<Index>& anchors = links_.vertex_halfedge;
  if (free_vertices_.count > 0) {
    const Index slot = pop(free_vertices_, anchors, 1);
    anchors[slot] = kNone;
    ++version_;
    return Vertex(slot);
  }
  if (anchors.size() >= kMaxSlots || !grow(anchors, anchors.size() + 1)) return {};
  const Vertex v(vertex_slots());
  (void)anchors.resize(anchors.size() + 1, kNone);  // grow() made room
  ++version_;
  return v;
}

Halfedge Connectivity::new_edge(Vertex from, Vertex to) {
  Index slot = 0;
  if (free_edges_.count > 0) {
    slot = 2 * pop(free_edges_, links_.next, 2);
  } else {
    const std::size_t count = links_.next.size() + 2;
    if (count > kMaxSlots || !grow(links_.next, count) || !grow(links_.prev, count) ||
        !grow(links_.to_vertex, count) || !grow(links_.face, count)) {
      return {};
    }
    slot = halfedge_slots();
    // The rooms made above.
    (void)links_.next.resize(count);
    (void)links_.prev.resize(count);
    (void)links_.to_vertex.resize(count);
    (void)links_.face.resize(count);
  }
  const Halfedge h(slot);
  const Halfedge o = opposite(h);
  link(h, o);
  link(o, h);
  set_to_vertex(h, to);
  set_to_vertex(o, from);
  set_face(h, Face{});
  set_face(o, Face{});
  return h;
}

Face Connectivity::new_face(Halfedge h) {
  Array<Index>& firsts = links_.face_halfedge;
  Face f;
  if (free_faces_.count > 0) {
    f = Face(pop(free_faces_, firsts, 1));
  } else {
    if (firsts.size() >= kMaxSlots || !grow(firsts, firsts.size() + 1)) return {};
    f = Face(face_slots());
    (void)firsts.resize(firsts.size() + 1);  // grow() made room
  }
  set_face_halfedge(f, h);
  return f;
}

void Connectivity::adjust_anchor(Vertex v) {
  for (const Halfedge h : outgoing_cw(v)) {
    if (is_boundary(h)) {
      set_vertex_halfedge(v, h);
      return;
    }
  }
}

void Connectivity::release(Vertex v) {
  assert(is_live(v));
  push(free_vertices_, v.index(), links_.vertex_halfedge[v.index()]);
  ++version_;
}

void Connectivity::release(Edge e) {
  assert(is_live(e));
  for (const Index side : {0U, 1U}) {
    const Index h = edge_halfedge(e, side).index();
    links_.next[h] = links_.prev[h] = links_.to_vertex[h] = links_.face[h] = kDeleted;
  }
  push(free_edges_, e.index(), links_.next[edge_halfedge(e).index()]);
  ++version_;
}

void Connectivity::release(Face f) {
  assert(is_live(f));
  push(free_faces_, f.index(), links_.face_halfedge[f.index()]);
  ++version_;
}

}  // namespace halfedge
