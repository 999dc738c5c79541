#pragma once

#include <halfedge/geometry/loop.h>
#include <halfedge/mesh.h>
#include <halfedge/vector.h>

#include <cassert>
#include <cmath>
#include <numbers>

/// Angles, in radians, and what is made of them.
namespace halfedge::geometry {

/// The angle inside the face of `h` at the corner where h ends: between h and next(h), in [0, 2
/// pi), more than pi where the corner is reflex as seen along the normal of the face. 0 where h has
/// no face, so that those of the incoming halfedges add up to the angle of the faces around a
/// vertex; 0 where a side has no length. cost: O(1) in a triangle, else O(degree)
template <HasPositions Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] double corner_angle(const Mesh& mesh, Halfedge h) {
  if (mesh.is_boundary(h)) return 0;
  const Halfedge out = mesh.next(h);
  const Vector corner = internal::place(mesh, mesh.to_vertex(h));
  const Vector back = internal::place(mesh, mesh.from_vertex(h)) - corner;
  const Vector on = internal::place(mesh, mesh.to_vertex(out)) - corner;
  if (dot(back, back) == 0 || dot(on, on) == 0) return 0;
  const Vector turn = cross(on, back);
  const double angle = std::atan2(internal::length(turn), dot(on, back));
  // A triangle has no reflex corners; a thin one would have, by rounding.
  if (mesh.next(mesh.next(out)) == h) return angle;
  const bool is_reflex = dot(turn, internal::area_vector(mesh, h)) < 0;
  return is_reflex ? 2 * std::numbers::pi - angle : angle;
}

/// By how much the surface bends at an edge: the angle between the normals of its two faces, in
/// (-pi, pi]; positive where it is convex, negative where it is concave. 0 on the boundary, and
/// beside a face that has no area, or one that isn't finite.
/// cost: O(degrees of both)
template <HasPositions Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] double dihedral_angle(const Mesh& mesh, Edge e) {
  const Halfedge h = mesh.edge_halfedge(e, 0);
  const Halfedge g = mesh.edge_halfedge(e, 1);
  if (mesh.is_boundary(h) || mesh.is_boundary(g)) return 0;
  const Vector left = internal::unit(internal::area_vector(mesh, h));
  const Vector right = internal::unit(internal::area_vector(mesh, g));
  if (left == Vector{} || right == Vector{}) return 0;
  const Vector turn = cross(left, right);
  const Vector along =
      internal::place(mesh, mesh.to_vertex(h)) - internal::place(mesh, mesh.from_vertex(h));
  const double angle = std::atan2(internal::length(turn), dot(left, right));
  return dot(turn, along) < 0 && angle < std::numbers::pi ? -angle : angle;
}

namespace internal {

/// Of the angle opposite to `h` in its triangle; 0 if there is none, or one without area.
template <class Mesh>
[[nodiscard]] double opposite_cotangent(const Mesh& mesh, Halfedge h) {
  if (mesh.is_boundary(h)) return 0;
  const Halfedge out = mesh.next(h);
  assert(mesh.next(mesh.next(out)) == h && "cotan_weight is of edges between triangles");
  const Vector corner = place(mesh, mesh.to_vertex(out));
  const Vector to = place(mesh, mesh.to_vertex(h)) - corner;
  const Vector from = place(mesh, mesh.from_vertex(h)) - corner;
  const double twice_area = length(cross(from, to));
  return twice_area > 0 ? dot(from, to) / twice_area : 0;
}

}  // namespace internal

/// Half the sum of the cotangents of the angles opposite to an edge in its one or two triangles:
/// its weight in the Laplacian of Pinkall and Polthier (1993). A triangle without area adds 0. O(1)
/// pre: the faces of the edge are triangles
template <HasPositions Mesh>
requires StoresFaces<Mesh>
[[nodiscard]] double cotan_weight(const Mesh& mesh, Edge e) {
  return (internal::opposite_cotangent(mesh, mesh.edge_halfedge(e, 0)) +
          internal::opposite_cotangent(mesh, mesh.edge_halfedge(e, 1))) /
         2;
}

/// By how much the surface at a vertex is curved: 2 pi minus pi for each boundary halfedge that
/// leaves it, minus the angles of its corners. 2 pi for an isolated vertex. In a triangle mesh
/// those of all vertices add up to 2 pi times the Euler characteristic (Gauss and Bonnet), with
/// boundaries and pinched vertices too. cost: O(valence) among triangles, else O(sum of the
/// degrees)
template <HasPositions Mesh>
requires StoresFaces<Mesh> && StoresAnchors<Mesh>
[[nodiscard]] double angle_defect(const Mesh& mesh, Vertex v) {
  double defect = 2 * std::numbers::pi;
  for (const Halfedge in : mesh.incoming_cw(v)) {
    // As many boundary halfedges arrive as leave.
    defect -= mesh.is_boundary(in) ? std::numbers::pi : corner_angle(mesh, in);
  }
  return defect;
}

}  // namespace halfedge::geometry
