#pragma once

#include <halfedge/build/build.h>
#include <halfedge/directed_edges/build.h>

#include <cstdint>
#include <cstdlib>
#include <type_traits>

#include "contender.h"

/// One of our own mesh types.
class Variant : public Circulated {
 public:
  /// As `one_ring_sum`, counter-clockwise: along prev, where that is stored.
  virtual std::uint64_t one_ring_sum_ccw() = 0;
};

/// AnyMesh: a BasicMesh, or Directed Edges.
template <class AnyMesh>
class VariantOf final : public Variant {
 public:
  void build(const TriangleMesh& input) override {
    halfedge::BuildReport report;
    const halfedge::Polygons polygons{input.positions, {}, input.corners};
    bool built = false;
    if constexpr (std::is_same_v<AnyMesh, halfedge::DirectedEdgesMesh>) {
      built = halfedge::build_from_triangles(mesh_, polygons, report);
    } else {
      built = halfedge::build_from_polygons(mesh_, polygons, report);
    }
    if (!built) std::exit(1);
  }

  std::int64_t circulate() override {
    std::int64_t counter = 0;
    for (const halfedge::Vertex v : mesh_.vertices()) {
      for ([[maybe_unused]] const halfedge::Face f : mesh_.vertex_faces_cw(v)) ++counter;
    }
    for (const halfedge::Face f : mesh_.faces()) {
      for ([[maybe_unused]] const halfedge::Vertex v : mesh_.face_vertices_ccw(f)) --counter;
    }
    return counter;
  }

  std::uint64_t one_ring_sum() override {
    std::uint64_t sum = 0;
    for (const halfedge::Vertex v : mesh_.vertices()) {
      for (const halfedge::Vertex w : mesh_.vertex_vertices_cw(v)) sum += w.index();
    }
    return sum;
  }

  std::uint64_t one_ring_sum_ccw() override {
    std::uint64_t sum = 0;
    for (const halfedge::Vertex v : mesh_.vertices()) {
      for (const halfedge::Vertex w : mesh_.vertex_vertices_ccw(v)) sum += w.index();
    }
    return sum;
  }

 private:
  AnyMesh mesh_;
};
