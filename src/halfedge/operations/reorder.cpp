#include <halfedge/operations/reorder.h>

#include <algorithm>
#include <cstring>
#include <span>

namespace halfedge {

namespace {

// Sorts by counting: items with the same key stay in their order. `map` holds the key of each item,
// at most `last`, and its place in `order` then; kNone for items that are left out, in both.
// `order` has room for all. False when memory is exhausted.
[[nodiscard]] bool sort_by_key(Array<Index>& map, Index last, Array<Index>& order) {
  Array<Index> begin;  // of the items with each key, one on
  if (!begin.resize(std::size_t{last} + 2, 0)) return false;
  Index count = 0;
  for (const Index key : map) {
    if (key == kNone) continue;
    ++begin[std::size_t{key} + 1];
    ++count;
  }
  for (std::size_t key = 1; key < begin.size(); ++key) begin[key] += begin[key - 1];
  order.grow_to(count);
  for (Index item = 0; item < map.size(); ++item) {
    Index& place = map[item];
    if (place == kNone) continue;
    place = begin[place]++;
    order[place] = item;
  }
  return true;
}

// Whether new slots are old ones, and there are as many.
bool changes_nothing(const Array<Index>& order, const Array<Index>& map) {
  if (order.size() != map.size()) return false;
  Index different = 0;
  for (Index i = 0; i < order.size(); ++i) different |= order[i] ^ i;
  return different == 0;
}

// Writes in order and reads from all over a copy: of reads, more can be underway at a time.
template <unsigned kKeptBits>
void move_rows(const Array<Index>& order, std::size_t width, MovedLink<kKeptBits> moved,
               Array<Index>& links, Array<std::byte>& copy) {
  if (links.empty()) return;
  std::memcpy(copy.data(), links.data(), links.size() * sizeof(Index));
  const auto* const old = reinterpret_cast<const Index*>(copy.data());
  Index* to = links.data();
  for (const Index row : order) {
    for (std::size_t i = 0; i < width; ++i) *to++ = moved(old[width * row + i]);
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
  const bool is_reserved = reserve(links, attributes, vertex_slots, face_slots);
  if (is_reserved) number_vertices();
  if (!is_reserved || !number_faces(links) || !number_edges(links)) {
    return no_memory_for("reordering the mesh");
  }
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
  for (const ItemKind kind : kItemKinds) {
    for (const Attributes::Column& column : attributes.of(kind)) {
      longest = std::max(longest, column->bytes().size());
    }
  }
  return maps_.vertices.resize(vertex_slots, kNone) && maps_.edges.resize(edge_slots, kNone) &&
         maps_.faces.resize(face_slots, kNone) && edges_.reserve(edge_slots) &&
         faces_.reserve(face_slots) && old_.resize(longest);
}

void Reordering::number_vertices() {
  for (Index v = 0; v < vertices_.size(); ++v) maps_.vertices[vertices_[v]] = v;
}

// By the smallest of their vertices. Where halfedges store no faces, all stay in their order.
bool Reordering::number_faces(const Links& links) {
  const Index nowhere = Index(vertices_.size());  // after all others
  for (Index f = 0; f < maps_.faces.size(); ++f) {
    const bool is_live = links.face_halfedge.empty() || !is_deleted_link(links.face_halfedge[f]);
    if (is_live) maps_.faces[f] = nowhere;
  }
  const MovedLink<> vertex{maps_.vertices};
  for (std::size_t h = 0; h < links.face.size(); ++h) {
    const Index f = links.face[h];  // out of the arrays if `h` is deleted
    if (f >= maps_.faces.size() || maps_.faces[f] == kNone) continue;
    maps_.faces[f] = std::min(maps_.faces[f], vertex(links.to_vertex[h]));
  }
  return sort_by_key(maps_.faces, nowhere, faces_);
}

// By the smaller of their faces; by the smaller of their vertices where that isn't known.
bool Reordering::number_edges(const Links& links) {
  const bool has_faces = !links.face.empty() && !faces_.empty();
  const Array<Index>& items = has_faces ? links.face : links.to_vertex;
  const MovedLink<> number{has_faces ? maps_.faces : maps_.vertices};
  const Index nowhere = Index((has_faces ? faces_ : vertices_).size());
  for (std::size_t e = 0; e < maps_.edges.size(); ++e) {
    if (is_deleted_link(links.next[2 * e])) continue;
    maps_.edges[e] = std::min({number(items[2 * e]), number(items[2 * e + 1]), nowhere});
  }
  return sort_by_key(maps_.edges, nowhere, edges_);
}

void Reordering::move_links(Links& links) {
  const MovedHalfedge halfedge{maps_.edges};
  move_rows(vertices_, 1, halfedge, links.vertex_halfedge, old_);
  move_rows(faces_, 1, halfedge, links.face_halfedge, old_);
  move_rows(edges_, 2, MovedLink<>{maps_.vertices}, links.to_vertex, old_);
  move_rows(edges_, 2, MovedLink<>{maps_.faces}, links.face, old_);
  move_rows(edges_, 2, halfedge, links.prev, old_);
  move_rows(edges_, 2, halfedge, links.next, old_);
}

void Reordering::move_attributes(Attributes& attributes) {
  for (const ItemKind kind : kItemKinds) {
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
