#include <halfedge/operations/append.h>
#include <halfedge/sentence.h>
#include <halfedge/steps.h>

#include <algorithm>
#include <cstddef>

namespace halfedge::appending {

namespace {

template <class Item>
Error leads_nowhere(const char* link, Item item) {
  return {"corrupt-connectivity",
          sentence::of("The {} of {} {} is no live item, which breaks the "
                       "invariants of a mesh: validate names what is wrong.",
                       link, name_of(kind_of(item)), item.index())};
}

template <class Item>
bool mark_live(const RawLinks& links, Array<Index>& live) {
  if (!live.resize(links.slots(Item{}))) return false;
  for (Index i = 0; i < live.size(); ++i) live[i] = links.is_deleted(Item(i)) ? kNone : 0;
  return true;
}

// The one place where values of attributes pass from one mesh to another.
template <class Item>
void copy_columns(auto& mesh, const Attributes& other, const Array<Index>& map, Index width) {
  constexpr ItemKind kKind = kind_of(Item{});
  for (Attributes::Column& column : mesh.columns(kKind)) {
    const Attribute* const from = other.find(kKind, column->name());
    if (from == nullptr || column->is_generation() || from->type() != column->type() ||
        from->components() != column->components()) {
      continue;
    }
    for (Index i = 0; i < map.size() * width; ++i) {
      const Index to = map[i / width];
      for (Index c = 0; to != kNone && c < column->components(); ++c) {
        mesh.set_attribute(*column, Item(to * width + i % width), c, from->get(i, c));
      }
    }
  }
}

}  // namespace

Error out_of_memory() { return no_memory_for("another mesh"); }

Result<Counts> count_live(const RawLinks& links) {
  const auto is_live = [&](Halfedge h) {
    return links.contain(h) && links.is_live(RawLinks::edge(h));
  };
  Counts live;
  for (Index i = 0; i < links.halfedge_slots(); ++i) {
    const Halfedge h(i);
    if (!is_live(h)) continue;
    live.edges += i % 2;
    if (!is_live(links.next(h))) return leads_nowhere("next", h);
    if (!links.is_live(links.to_vertex(h))) return leads_nowhere("to-vertex", h);
    if (links.face(h).valid() && !links.is_live(links.face(h))) return leads_nowhere("face", h);
  }
  for (Vertex v(0); v.index() < links.slots(v); v = Vertex(v.index() + 1)) {
    if (links.is_deleted(v)) continue;
    ++live.vertices;
    if (has_ring(links, v) && !is_live(links.stored_halfedge(v))) return leads_nowhere("anchor", v);
  }
  for (Face f(0); f.index() < links.slots(f); f = Face(f.index() + 1)) {
    if (links.is_deleted(f)) continue;
    ++live.faces;
    if (!is_live(links.stored_halfedge(f))) return leads_nowhere("halfedge", f);
  }
  return live;
}

template <Storage kStored>
Result<Counts> slots_with(const BasicConnectivity<kStored>& mesh, const Counts& added) {
  const auto needed = [](std::size_t slots, const FreeList& free, std::size_t count) {
    return slots + std::max(count, std::size_t{free.count}) - free.count;
  };
  const Counts slots = {needed(mesh.vertex_slots(), mesh.free_vertices(), added.vertices),
                        needed(mesh.edge_slots(), mesh.free_edges(), added.edges),
                        needed(mesh.face_slots(), mesh.free_faces(), added.faces)};
  if (slots.vertices > kMaxSlots || 2 * slots.edges > kMaxSlots || slots.faces > kMaxSlots) {
    return Error{"too-large", sentence::of("Both meshes together have {} vertices, {} edges and {} "
                                           "faces, more than can be addressed.",
                                           slots.vertices, slots.edges, slots.faces)};
  }
  return slots;
}

template <Storage kStored>
bool make_room(BasicMesh<kStored>& mesh, const Counts& slots) {
  const Links& links = mesh.links();
  // With slack, a mesh that is made by appending many others moves only now and then.
  using steps::with_slack;
  return mesh.reserve(with_slack(slots.vertices, links.vertex_halfedge.capacity()),
                      with_slack(2 * slots.edges, links.next.capacity()) / 2,
                      with_slack(slots.faces, links.face_halfedge.capacity())) ||
         mesh.reserve(Index(slots.vertices), Index(slots.edges), Index(slots.faces));
}

bool list_live(const RawLinks& links, CompactMaps& live) {
  return mark_live<Vertex>(links, live.vertices) && mark_live<Edge>(links, live.edges) &&
         mark_live<Face>(links, live.faces);
}

template <Storage kStored>
void copy_items(BasicMesh<kStored>& mesh, const MeshView& other, CompactMaps& maps) {
  const RawLinks& links = other.links;
  // All items first, so that a slot that is taken again isn't mistaken for one to be copied.
  for (Index v = 0; v < maps.vertices.size(); ++v) {
    if (maps.vertices[v] == kNone) continue;
    const float* const p = &other.positions[3 * std::size_t{v}];
    maps.vertices[v] = mesh.add_vertex({p[0], p[1], p[2]}).index();
  }
  for (Index e = 0; e < maps.edges.size(); ++e) {
    if (maps.edges[e] == kNone) continue;
    const Halfedge h(2 * e);
    const Halfedge made =
        mesh.new_edge(maps(links.to_vertex(RawLinks::opposite(h))), maps(links.to_vertex(h)));
    maps.edges[e] = made.index() / 2;
  }
  for (Index f = 0; f < maps.faces.size(); ++f) {
    if (maps.faces[f] == kNone) continue;
    maps.faces[f] = mesh.new_face(maps(links.stored_halfedge(Face(f)))).index();
  }
  for (Index i = 0; i < 2 * maps.edges.size(); ++i) {
    const Halfedge h(i);
    const Halfedge to = maps(h);
    if (!to.valid()) continue;
    mesh.link(to, maps(links.next(h)));
    if (links.face(h).valid()) mesh.set_face(to, maps(links.face(h)));
  }
  for (Index v = 0; v < maps.vertices.size(); ++v) {
    const Vertex to(maps.vertices[v]);
    if (!to.valid() || !has_ring(links, Vertex(v))) continue;
    mesh.set_vertex_halfedge(to, maps(links.stored_halfedge(Vertex(v))));
  }
  copy_columns<Vertex>(mesh, *other.attributes, maps.vertices, 1);
  copy_columns<Halfedge>(mesh, *other.attributes, maps.edges, 2);
  copy_columns<Edge>(mesh, *other.attributes, maps.edges, 1);
  copy_columns<Face>(mesh, *other.attributes, maps.faces, 1);
}

#define HALFEDGE_INSTANTIATE(storage)                                                   \
  template Result<Counts> slots_with(const BasicConnectivity<storage>&, const Counts&); \
  template bool make_room(BasicMesh<storage>&, const Counts&);                          \
  template void copy_items(BasicMesh<storage>&, const MeshView&, CompactMaps&)
HALFEDGE_INSTANTIATE(kEverything);
HALFEDGE_INSTANTIATE(kWithoutPrev);
HALFEDGE_INSTANTIATE(kPrevAtRunTime);
#undef HALFEDGE_INSTANTIATE

}  // namespace halfedge::appending
