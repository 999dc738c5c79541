#pragma once

#include <halfedge/build/build.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/reorder.h>

#include <cstdlib>

#include "contender.h"

/// The same mesh in the order that `reorder` gives to it.
inline TriangleMesh locality_ordered(const TriangleMesh& mesh) {
  halfedge::Mesh built;
  halfedge::BuildReport report;
  const halfedge::Polygons polygons{mesh.positions, {}, mesh.corners};
  if (!build_from_polygons(built, polygons, report) || !reorder(built)) std::abort();
  TriangleMesh result;
  result.positions.assign(built.positions().begin(), built.positions().end());
  result.corners.reserve(mesh.corners.size());
  for (const halfedge::Face f : built.faces()) {
    for (const halfedge::Vertex v : built.face_vertices_ccw(f)) result.corners.push_back(v.index());
  }
  return result;
}
