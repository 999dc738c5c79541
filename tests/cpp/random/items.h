#pragma once

#include <halfedge/mesh.h>

#include <vector>

#include "random/operation.h"

/// Sets of items that operations say they may delete.
namespace halfedge::test {

inline void add_edges_and_corners(const Mesh& mesh, Face f, Items& items) {
  if (!f.valid()) return;
  for (const Halfedge h : mesh.face_halfedges_ccw(f)) {
    items.add(h);
    items.add(mesh.to_vertex(h));
  }
}

inline void add_loop(const Mesh& mesh, Halfedge h, Items& items) {
  for (const Halfedge on_loop : mesh.loop_ccw(h)) {
    items.add(on_loop);
    items.add(mesh.to_vertex(on_loop));
  }
}

inline void add_faces_around(const Mesh& mesh, Vertex v, Items& items) {
  for (const Halfedge h : mesh.outgoing_cw(v)) items.add(mesh.face(h));
}

inline void add_everything(const Mesh& mesh, Items& items) {
  for (const Vertex v : mesh.vertices()) items.add(v);
  for (const Edge e : mesh.edges()) items.add(e);
  for (const Face f : mesh.faces()) items.add(f);
}

/// All that is reached from `v` over edges.
inline void add_component(const Mesh& mesh, Vertex v, Items& items) {
  std::vector<Vertex> waiting{v};
  while (!waiting.empty()) {
    const Vertex at = waiting.back();
    waiting.pop_back();
    if (!items.vertices.insert(at.index()).second) continue;
    for (const Halfedge h : mesh.outgoing_cw(at)) {
      items.add(h);
      items.add(mesh.face(h));
      waiting.push_back(mesh.to_vertex(h));
    }
  }
}

}  // namespace halfedge::test
