#include <halfedge/operations/reorder.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>

namespace halfedge {

namespace {

constexpr ItemKind kKinds[] = {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge,
                               ItemKind::kFace};

// Where links lead to afterwards; out of the arrays to nothing.
struct Target {
  const Array<Index>& map;
  // The lowest bits of a link stay: that of a halfedge is its side.
  Index kept_bits = 0;

  [[nodiscard]] Index operator()(Index old) const {
    const Index item = old >> kept_bits;
    const Index now = item < map.size() ? map[item] : kNone;
    return now == kNone ? kNone : (now << kept_bits) + (old - (item << kept_bits));
  }
};

// Whether new slots are old ones, and there are as many.
bool changes_nothing(const Array<Index>& order, const Array<Index>& map) {
  if (order.size() != map.size()) return false;
  Index different = 0;
  for (Index i = 0; i < order.size(); ++i) different |= order[i] ^ i;
  return different == 0;
}

// Writes in order and reads from all over a copy: of reads, more can be underway at a time.
void move_rows(const Array<Index>& order, std::size_t width, Target target, Array<Index>& links,
               Array<std::byte>& copy) {
  if (links.empty()) return;
  std::memcpy(copy.data(), links.data(), links.size() * sizeof(Index));
  const auto* const old = reinterpret_cast<const Index*>(copy.data());
  Index* to = links.data();
  for (const Index row : order) {
    for (std::size_t i = 0; i < width; ++i) *to++ = target(old[width * row + i]);
  }
  links.grow_to(width * order.size());  // no larger than it is
}

// The same with rows of bytes.
void move_bytes(const Array<Index>& order, std::size_t width, std::span<std::byte> bytes,
                Array<std::byte>& copy) {
  if (bytes.empty()) return;
  std::memcpy(copy.data(), bytes.data(), bytes.size());
  std::byte* to = bytes.data();
  for (const Index row : order) {
    std::memcpy(to, copy.data() + width * row, width);
    to += width;
  }
}

}  // namespace

Result<void> Reordering::plan(const Links& links, const Attributes& attributes,
                              std::size_t vertex_slots, std::size_t face_slots,
                              Array<Index>&& vertices) {
  vertices_ = std::move(vertices);
  if (!reserve(links, attributes, vertex_slots, face_slots) || !number_edges(links)) {
    return Error{"out-of-memory", "There is not enough memory to reorder the mesh."};
  }
  number_faces(links);
  return {};
}

bool Reordering::moves_anything() const {
  return !changes_nothing(vertices_, maps_.vertices) || !changes_nothing(edges_, maps_.edges) ||
         !changes_nothing(faces_, maps_.faces);
}

bool Reordering::reserve(const Links& links, const Attributes& attributes, std::size_t vertex_slots,
                         std::size_t face_slots) {
  const std::size_t edge_slots = links.next.size() / 2;
  std::size_t longest = std::max({links.next.size() * sizeof(Index), face_slots * sizeof(Index),
                                  3 * vertex_slots * sizeof(float)});
  for (const ItemKind kind : kKinds) {
    for (const Attributes::Column& column : attributes.of(kind)) {
      longest = std::max(longest, column->bytes().size());
    }
  }
  return maps_.vertices.resize(vertex_slots, kNone) && maps_.edges.resize(edge_slots, kNone) &&
         maps_.faces.resize(face_slots, kNone) && edges_.reserve(edge_slots) &&
         faces_.reserve(face_slots) && old_.resize(longest);
}

// By counting; edges with the same smaller vertex keep their order.
bool Reordering::number_edges(const Links& links) {
  for (Index v = 0; v < vertices_.size(); ++v) maps_.vertices[vertices_[v]] = v;

  const Index nowhere = Index(vertices_.size());  // if both ends are, which breaks the invariants
  Array<Index> begin;                             // of the groups of vertices, one on
  if (!begin.resize(vertices_.size() + 2, 0)) return false;
  Index live = 0;
  const Target vertex{maps_.vertices};
  for (std::size_t e = 0; e < maps_.edges.size(); ++e) {
    if (is_deleted_link(links.next[2 * e])) continue;
    const Index low =
        std::min({vertex(links.to_vertex[2 * e]), vertex(links.to_vertex[2 * e + 1]), nowhere});
    maps_.edges[e] = low;
    ++begin[low + 1];
    ++live;
  }
  for (std::size_t group = 1; group < begin.size(); ++group) begin[group] += begin[group - 1];
  edges_.grow_to(live);
  for (std::size_t e = 0; e < maps_.edges.size(); ++e) {
    Index& place = maps_.edges[e];
    if (place == kNone) continue;
    place = begin[place]++;
    edges_[place] = Index(e);
  }
  return true;
}

void Reordering::number_faces(const Links& links) {
  const auto list = [this](Index f) {
    if (f >= maps_.faces.size() || maps_.faces[f] != kNone) return;
    const Index place = Index(faces_.size());
    maps_.faces[f] = place;
    faces_.grow_to(place + 1);
    faces_[place] = f;
  };
  if (!links.face.empty()) {
    for (const std::size_t e : edges_) {
      list(links.face[2 * e]);
      list(links.face[2 * e + 1]);
    }
  }
  for (Index f = 0; f < maps_.faces.size(); ++f) {  // those that no halfedge names
    if (links.face_halfedge.empty() || !is_deleted_link(links.face_halfedge[f])) list(f);
  }
}

void Reordering::move_links(Links& links) {
  const Target halfedge{maps_.edges, 1};
  move_rows(vertices_, 1, halfedge, links.vertex_halfedge, old_);
  move_rows(faces_, 1, halfedge, links.face_halfedge, old_);
  move_rows(edges_, 2, Target{maps_.vertices}, links.to_vertex, old_);
  move_rows(edges_, 2, Target{maps_.faces}, links.face, old_);
  move_rows(edges_, 2, halfedge, links.prev, old_);
  move_rows(edges_, 2, halfedge, links.next, old_);
}

void Reordering::move_attributes(Attributes& attributes) {
  for (const ItemKind kind : kKinds) {
    const bool is_halfedge = kind == ItemKind::kHalfedge;
    const bool is_of_edge = is_halfedge || kind == ItemKind::kEdge;
    const Array<Index>& of_face_or_edge = is_of_edge ? edges_ : faces_;
    const Array<Index>& order = kind == ItemKind::kVertex ? vertices_ : of_face_or_edge;
    for (Attributes::Column& column : attributes.of(kind)) {
      const std::size_t width = is_halfedge ? 2 : 1;
      move_bytes(order, width * column->stride(), column->bytes(), old_);
      column->resize(Index(width * order.size()));
    }
  }
}

void Reordering::move_positions(Array<float>& positions) {
  move_bytes(vertices_, 3 * sizeof(float), std::as_writable_bytes(positions.span()), old_);
  positions.grow_to(3 * vertices_.size());
}

}  // namespace halfedge
