#include <halfedge/algorithms/array_sizes.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/sentence.h>

#include <algorithm>

namespace halfedge {

namespace {

Error corrupt(const char* link, ItemKind kind, Index index) {
  return {
      "corrupt-connectivity",
      sentence::of("The {} of {} {} breaks the invariants of a mesh: validate names what is wrong.",
                   link, name_of(kind), index)};
}

// Sets of vertices, each named by its smallest. Path halving keeps the trees flat.
Index find_root(Array<Index>& parent, Index v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

void unite(Array<Index>& parent, Index a, Index b) {
  a = find_root(parent, a);
  b = find_root(parent, b);
  if (a < b) {
    parent[b] = a;
  } else {
    parent[a] = b;
  }
}

// Unites the ends of all edges; then replaces each vertex of `of_vertex` by its component.
template <Storage kStored>
Result<void> label_vertices(const BasicConnectivity<kStored>& mesh, Components& components) {
  Array<Index>& label = components.of_vertex;
  if (!label.resize(mesh.vertex_slots())) return no_memory_for("the components of vertices");
  for (Index v = 0; v < label.size(); ++v) {
    const Index anchor = mesh.links().vertex_halfedge[v];
    label[v] = anchor == kNone || is_deleted_link(anchor) ? kNone : v;
  }
  for (const Edge e : mesh.edges()) {
    const Index a = mesh.to_vertex(mesh.edge_halfedge(e, 0)).index();
    const Index b = mesh.to_vertex(mesh.edge_halfedge(e, 1)).index();
    if (a >= label.size() || b >= label.size() || label[a] == kNone || label[b] == kNone) {
      return corrupt("to-vertex", ItemKind::kEdge, e.index());
    }
    unite(label, a, b);
  }
  // A parent is smaller than its children, so its component is known before theirs.
  for (Index v = 0; v < label.size(); ++v) {
    if (label[v] == kNone) continue;
    if (label[v] != v) {
      label[v] = label[label[v]];
    } else {
      label[v] = Index(components.list.size());
      if (!components.list.push_back({})) return no_memory_for("the list of components");
    }
    ++components.list[label[v]].vertices;
  }
  return {};
}

template <Storage kStored>
Result<void> label_faces(const BasicConnectivity<kStored>& mesh, Components& components) {
  Array<Index>& label = components.of_face;
  if (!label.resize(mesh.face_slots(), kNone)) return no_memory_for("the components of faces");
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.face_halfedge(f);
    if (!mesh.is_live(mesh.edge(h))) return corrupt("halfedge", ItemKind::kFace, f.index());
    const Index component = components.of_vertex[mesh.to_vertex(h).index()];
    label[f.index()] = component;
    ++components.list[component].faces;
  }
  return {};
}

template <Storage kStored>
bool all_faces_have(const BasicConnectivity<kStored>& mesh, int degree) {
  if (!check_array_sizes(mesh)) return false;
  for (const Face f : mesh.faces()) {
    const Halfedge first = mesh.face_halfedge(f);
    Halfedge h = first;
    for (int corner = 0; corner < degree; ++corner) {
      if (corner > 0 && h == first) return false;
      if (h.index() >= mesh.halfedge_slots()) return false;
      h = mesh.next(h);
    }
    if (h != first) return false;
  }
  return true;
}

}  // namespace

template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>> Result<Array<Halfedge>> boundary_loops(
    const BasicConnectivity<kStored>& mesh) {
  if (Result<void> sizes = check_array_sizes(mesh); !sizes) return sizes;
  const Links& links = mesh.links();
  Array<Halfedge> loops;
  Array<bool> seen;  // stays empty if the mesh is closed
  for (Index h = 0; h < links.face.size(); ++h) {
    if (links.face[h] != kNone) continue;
    if (seen.empty() && !seen.resize(links.face.size(), false)) {
      return no_memory_for("the marks of boundary halfedges");
    }
    if (seen[h]) continue;
    if (!loops.push_back(Halfedge(h))) return no_memory_for("the list of boundary loops");
    Index at = h;
    while (!seen[at]) {
      seen[at] = true;
      const Index next = links.next[at];
      if (next >= links.face.size() || links.face[next] != kNone) {
        return corrupt("next", ItemKind::kHalfedge, at);
      }
      at = next;
    }
    if (at != h) return corrupt("prev", ItemKind::kHalfedge, at);
  }
  return loops;
}

template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>> Result<Components> connected_components(
    const BasicConnectivity<kStored>& mesh) {
  Result<Array<Halfedge>> loops = boundary_loops(mesh);
  if (!loops) return loops;
  Components components;
  if (Result<void> done = label_vertices(mesh, components); !done) return done;
  if (Result<void> done = label_faces(mesh, components); !done) return done;
  const auto component_of = [&](Halfedge h) -> Component& {
    return components.list[components.of_vertex[mesh.to_vertex(h).index()]];
  };
  for (const Edge e : mesh.edges()) ++component_of(mesh.edge_halfedge(e)).edges;
  for (const Halfedge h : loops.value()) {
    if (mesh.is_live(mesh.edge(h))) ++component_of(h).boundary_loops;
  }
  return components;
}

template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>> Result<std::int64_t> genus(
    const BasicConnectivity<kStored>& mesh) {
  Result<Components> components = connected_components(mesh);
  if (!components) return components;
  std::int64_t sum = 0;
  for (const Component& component : components.value().list) sum += component.genus();
  return sum;
}

template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
bool is_closed(const BasicConnectivity<kStored>& mesh) {
  const Array<Index>& face = mesh.links().face;
  return std::find(face.begin(), face.end(), kNone) == face.end();
}

template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
bool is_triangle_mesh(const BasicConnectivity<kStored>& mesh) { return all_faces_have(mesh, 3); }
template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
bool is_quad_mesh(const BasicConnectivity<kStored>& mesh) { return all_faces_have(mesh, 4); }

#define HALFEDGE_INSTANTIATE(storage)                                                  \
  template Result<Array<Halfedge>> boundary_loops(const BasicConnectivity<storage>&);  \
  template Result<Components> connected_components(const BasicConnectivity<storage>&); \
  template Result<std::int64_t> genus(const BasicConnectivity<storage>&);              \
  template bool is_closed(const BasicConnectivity<storage>&);                          \
  template bool is_triangle_mesh(const BasicConnectivity<storage>&);                   \
  template bool is_quad_mesh(const BasicConnectivity<storage>&)
HALFEDGE_INSTANTIATE(kEverything);
HALFEDGE_INSTANTIATE(kWithoutPrev);
HALFEDGE_INSTANTIATE(kPrevAtRunTime);
#undef HALFEDGE_INSTANTIATE

}  // namespace halfedge
