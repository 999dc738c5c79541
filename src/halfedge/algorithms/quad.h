#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/inlining.h>
#include <halfedge/mesh.h>

#include <span>

namespace halfedge {

/// The ear of a quad, as PolygonTriangulator chooses it where no diagonal is forbidden: 1, which
/// cuts it from corner 0 to 2, or 2, from 1 to 3. A file of its own, for speed: most polygons are
/// quads.
[[nodiscard]] HALFEDGE_NOINLINE Index ear_of_quad(std::span<const Point, 4> points);

}  // namespace halfedge
