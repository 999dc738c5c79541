#pragma once

#include <halfedge/mesh.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>
#include <vector>

#include "support/shapes.h"

namespace halfedge::test {

/// The contract of build_from_polygons written down with a map and the low-level functions, slow
/// and plain: what the builder is compared with, but for the numbering of edges. Edges are numbered
/// by first use. The input must be a manifold.
inline Mesh reference_build(const Shape& shape) {
  Mesh mesh;
  for (Index v = 0; v < shape.vertices; ++v) {
    (void)mesh.add_vertex(
        {shape.positions[3 * v], shape.positions[3 * v + 1], shape.positions[3 * v + 2]});
  }
  std::map<std::pair<Index, Index>, Halfedge> by_ends;
  const auto halfedge = [&](Index from, Index to) {
    const auto found = by_ends.find({from, to});
    if (found != by_ends.end()) return found->second;
    const Halfedge h = mesh.new_edge(Vertex(from), Vertex(to));
    by_ends[{from, to}] = h;
    by_ends[{to, from}] = mesh.opposite(h);
    return h;
  };

  for (const std::vector<Index>& corners : shape.faces) {
    const std::size_t degree = corners.size();
    const Face f = mesh.new_face(halfedge(corners[degree - 1], corners[0]));
    for (std::size_t i = 0; i < degree; ++i) {
      const Halfedge h = halfedge(corners[i], corners[(i + 1) % degree]);
      assert(mesh.is_boundary(h) && "two faces on one side of an edge");
      mesh.set_face(h, f);
      mesh.link(h, halfedge(corners[(i + 1) % degree], corners[(i + 2) % degree]));
      mesh.set_vertex_halfedge(Vertex(corners[i]), h);
    }
  }

  // The fans of a boundary vertex, by the vertex their boundary halfedge leads to, form one cycle.
  std::vector<std::vector<Halfedge>> leaving(shape.vertices);
  for (const auto& [ends, h] : by_ends) {
    if (mesh.is_boundary(h)) leaving[ends.first].push_back(h);
  }
  for (Index v = 0; v < shape.vertices; ++v) {
    const std::vector<Halfedge>& fans = leaving[v];
    for (std::size_t i = 0; i < fans.size(); ++i) {
      Halfedge arriving = mesh.opposite(fans[i]);
      while (!mesh.is_boundary(arriving)) arriving = mesh.opposite(mesh.next(arriving));
      mesh.link(arriving, fans[(i + 1) % fans.size()]);
    }
    if (!fans.empty()) mesh.set_vertex_halfedge(Vertex(v), fans[0]);
  }
  return mesh;
}

}  // namespace halfedge::test
