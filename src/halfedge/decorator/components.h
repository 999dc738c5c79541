#pragma once

#include <halfedge/decorator/edit.h>
#include <halfedge/sort.h>

#include <cstddef>

namespace halfedge::decorator {

namespace internal {

/// Walks over connected components, each a list of edges.
template <class Mesh>
class ComponentWalk {
 public:
  explicit ComponentWalk(const Mesh& mesh) : mesh_(mesh) {}

  /// Room for everything that follows. False when memory is exhausted.
  [[nodiscard]] bool prepare() {
    return seen_.resize(mesh_.edge_slots(), false) && edges_.reserve(mesh_.edge_count());
  }

  [[nodiscard]] bool has_seen(Edge e) const { return seen_[e.index()]; }

  /// The edges of the component of `e`. pre: prepared, e not seen yet
  [[nodiscard]] const Array<Edge>& edges_of(Edge e) {
    edges_.clear();
    see(e);
    std::size_t passed = 0;
    while (passed < edges_.size()) {
      const Edge joined = edges_[passed++];
      // Loops and orbits are cycles of these steps, so what is joined to e is reached.
      for (const Index side : {0U, 1U}) {
        see(mesh_.edge(mesh_.next(mesh_.edge_halfedge(joined, side))));
      }
    }
    return edges_;
  }

 private:
  void see(Edge e) {
    if (has_seen(e)) return;
    seen_[e.index()] = true;
    (void)edges_.push_back(e);  // in the room made by prepare
  }

  const Mesh& mesh_;
  Array<bool> seen_;
  Array<Edge> edges_;
};

template <class Mesh>
void erase_all(Mesh& mesh, const Array<Edge>& edges) {
  for (const Edge e : edges) {
    for (const Index side : {0U, 1U}) {
      const Halfedge h = mesh.edge_halfedge(e, side);
      if (const Face f = face_of(mesh, h); f.valid() && mesh.is_live(f)) release_face(mesh, f);
      if (const Vertex v = mesh.to_vertex(h); mesh.is_live(v)) mesh.release(v);
    }
  }
  for (const Edge e : edges) mesh.release(e);
}

}  // namespace internal

/// Removes the connected component of `h`: the edges joined to it over vertices, and their vertices
/// and faces. (CGAL: erase_connected_component)
///
/// returns: the number of edges removed
/// cost: O(component), and clearing a byte for each edge slot; 4 bytes more for each live edge
/// inverse: none
/// errors: not-a-halfedge, out-of-memory
template <Editable Mesh>
requires DeletesFaces<Mesh> && DeletesVertices<Mesh>
[[nodiscard]] Result<Index> erase_connected_component(Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  ComponentWalk<Mesh> walk(mesh);
  if (!walk.prepare()) return no_memory("the edges of the component");
  const Array<Edge>& edges = walk.edges_of(mesh.edge(h));
  erase_all(mesh, edges);
  return Index(edges.size());
}

/// Removes all connected components but the `keep` largest, by their number of vertices (of two as
/// large, the one with the smaller edge stays), and all isolated vertices.
/// (CGAL: keep_largest_connected_components)
///
/// returns: the number of components removed; isolated vertices don't count
/// cost: O(slots + c log c) of c components. inverse: none
/// errors: out-of-memory
template <Editable Mesh>
requires DeletesFaces<Mesh> && DeletesVertices<Mesh>
[[nodiscard]] Result<Index> keep_largest_connected_components(Mesh& mesh, Index keep) {
  using namespace internal;
  struct Component {
    Edge edge;
    Index vertices = 0;
  };
  Array<Component> components;
  {
    ComponentWalk<Mesh> walk(mesh);
    Array<bool> counted;
    if (!walk.prepare() || !counted.resize(mesh.vertex_slots(), false)) {
      return no_memory("the components");
    }
    for (const Edge e : mesh.edges()) {
      if (walk.has_seen(e)) continue;
      Component component{.edge = e};
      for (const Edge joined : walk.edges_of(e)) {
        for (const Vertex v : mesh.edge_vertices(joined)) {
          component.vertices += counted[v.index()] ? 0U : 1U;
          counted[v.index()] = true;
        }
      }
      if (!components.push_back(component)) return no_memory("the components");
    }
  }
  ComponentWalk<Mesh> walk(mesh);
  if (!walk.prepare()) return no_memory("the components");
  introsort(components.begin(), components.end(), [](const Component& a, const Component& b) {
    return a.vertices != b.vertices ? a.vertices > b.vertices : a.edge < b.edge;
  });
  Index erased = 0;
  for (std::size_t i = keep; i < components.size(); ++i, ++erased) {
    erase_all(mesh, walk.edges_of(components[i].edge));
  }
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (mesh.is_live(Vertex(v)) && mesh.is_isolated(Vertex(v))) mesh.release(Vertex(v));
  }
  return erased;
}

}  // namespace halfedge::decorator
