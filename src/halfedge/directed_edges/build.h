#pragma once

#include <halfedge/build/build.h>
#include <halfedge/build/polygons.h>
#include <halfedge/directed_edges/directed_edges.h>

namespace halfedge {

/// Makes `mesh` the Directed Edges of these triangles: vertex i and face j are vertex i and face j
/// of the input. Refuses what `build_from_polygons` refuses, with the same report, and a face of
/// more than three corners (code: not-a-triangle); `mesh` is then left empty. Anchors and the order
/// of fans at a pinched vertex are the same too, so that all circulators give the same. The
/// boundary halfedges are numbered in the order of their opposites.
///
/// pre: `polygons` doesn't view the arrays of `mesh`
/// Memory of `mesh` is reused if it suffices, and exactly what is needed where it doesn't; peak
/// beyond the mesh is at most 8 bytes a vertex, which are given back before positions are copied.
/// cost: O(vertices + corners); O(n log n) for the n fans of a pinched vertex; a refusal as there
[[nodiscard]] bool build_from_triangles(DirectedEdgesMesh& mesh, const Polygons& polygons,
                                        BuildReport& report);

}  // namespace halfedge
