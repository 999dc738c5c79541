#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstdint>

/// Shapes to begin with, as polygons for the builders.
///
/// All of them are centred on the origin, with y up, the torus around z and the grid in the plane
/// of x and y, as those of three.js. Faces are counter-clockwise as seen from outside, those of the
/// grid as seen from +z. What has a radius and corners only has them on that sphere.
///
/// errors: bad-argument (fewer than is said; a length that isn't positive and finite), too-large,
/// out-of-memory
namespace halfedge::shapes {

/// What the four-sided faces of a shape are: left whole, or cut in two.
enum class Faces : std::uint8_t { kQuads, kTriangles };

/// What closes the end of a cylinder, and the base of a cone: one polygon, triangles around a
/// vertex in its middle, or nothing.
enum class Caps : std::uint8_t { kPolygons, kFans, kOpen };

/// 4 vertices, 6 edges, 4 triangles.
[[nodiscard]] Result<PolygonSoup> tetrahedron(double radius = 1);
/// 8 vertices, 12 edges of length `size`, 6 quads. Bit 0, 1, 2 of a vertex: which side of x, y, z.
[[nodiscard]] Result<PolygonSoup> cube(double size = 1);
/// 6 vertices, 12 edges, 8 triangles.
[[nodiscard]] Result<PolygonSoup> octahedron(double radius = 1);
/// 12 vertices, 30 edges, 20 triangles.
[[nodiscard]] Result<PolygonSoup> icosahedron(double radius = 1);
/// 20 vertices, 30 edges, 12 pentagons.
[[nodiscard]] Result<PolygonSoup> dodecahedron(double radius = 1);

/// A cylinder of one ring, closed by two polygons: 2n vertices, 3n edges, n + 2 faces.
/// pre: sides >= 3
[[nodiscard]] Result<PolygonSoup> prism(Index sides, double radius = 1, double height = 1);

/// n vertices of the base, then the apex, then the middle of a fan; n triangles, then the base.
/// With a polygon for its base n + 1 vertices, 2n edges, n + 1 faces: cone(4) is a pyramid.
/// pre: segments >= 3
[[nodiscard]] Result<PolygonSoup> cone(Index segments, Caps base = Caps::kPolygons,
                                       double radius = 1, double height = 1);

/// rings + 1 circles of vertices, from the bottom to the top, then the middles of fans. `rings`
/// times `segments` quads, then the bottom, then the top.
/// pre: segments >= 3, rings >= 1
[[nodiscard]] Result<PolygonSoup> cylinder(Index segments, Index rings = 1,
                                           Caps caps = Caps::kPolygons, Faces faces = Faces::kQuads,
                                           double radius = 1, double height = 1);

/// Vertex `row * (columns + 1) + column`, face `row * columns + column`; rows from the bottom to
/// the top. Triangles are cut along the diagonal from the lower left to the upper right.
/// pre: columns >= 1, rows >= 1
[[nodiscard]] Result<PolygonSoup> grid(Index columns, Index rows, Faces faces = Faces::kQuads,
                                       double width = 1, double height = 1);

/// `rings` circles of `sides` vertices: as many faces, twice as many edges. `radius` reaches from
/// the centre to the middle of the tube, whose radius is `tube`.
/// pre: rings >= 3, sides >= 3
[[nodiscard]] Result<PolygonSoup> torus(Index rings, Index sides, Faces faces = Faces::kQuads,
                                        double radius = 1, double tube = 0.4);

/// Meridians and circles of latitude: the north pole, rings - 1 circles of `segments` vertices, the
/// south pole; `rings` times `segments` faces, those at the poles triangles.
/// pre: segments >= 3, rings >= 2
[[nodiscard]] Result<PolygonSoup> uv_sphere(Index segments, Index rings,
                                            Faces faces = Faces::kQuads, double radius = 1);

/// An icosahedron whose triangles are cut in four so many times, all vertices on the sphere: with
/// q = 4^subdivisions, 10 q + 2 vertices, 30 q edges, 20 q triangles.
/// pre: subdivisions <= 12
[[nodiscard]] Result<PolygonSoup> ico_sphere(Index subdivisions, double radius = 1);

/// The mesh of a shape, or its error: `mesh_of(torus(48, 24))`.
[[nodiscard]] Result<Mesh> mesh_of(const Result<PolygonSoup>& shape);

}  // namespace halfedge::shapes
