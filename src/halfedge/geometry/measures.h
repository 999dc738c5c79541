#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/geometry/loop.h>
#include <halfedge/mesh.h>
#include <halfedge/refusals.h>
#include <halfedge/result.h>
#include <halfedge/sentence.h>
#include <halfedge/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

/// Lengths, areas and volume, and the middle of things.
namespace halfedge::geometry {

/// How far apart the ends of an edge are. O(1)
template <HasPositions Mesh>
[[nodiscard]] double edge_length(const Mesh& mesh, Edge e) {
  const Halfedge h = mesh.edge_halfedge(e);
  return internal::length(internal::place(mesh, mesh.to_vertex(h)) -
                          internal::place(mesh, mesh.from_vertex(h)));
}

/// Halfway between the ends of an edge, where split_edge puts its vertex. O(1)
template <HasPositions Mesh>
[[nodiscard]] Vector edge_midpoint(const Mesh& mesh, Edge e) {
  const Halfedge h = mesh.edge_halfedge(e);
  Vector sum = internal::place(mesh, mesh.from_vertex(h));
  sum += internal::place(mesh, mesh.to_vertex(h));
  return {sum[0] / 2, sum[1] / 2, sum[2] / 2};
}

/// Half the length of the area vector: of a flat polygon its area, whether it is convex or not, and
/// of another one that of its largest projection. O(degree)
template <HasPositions Mesh>
requires StoresFaceHalfedges<Mesh>
[[nodiscard]] double face_area(const Mesh& mesh, Face f) {
  return internal::length(internal::area_vector(mesh, mesh.face_halfedge(f))) / 2;
}

/// The mean of the corners, where split_face and dual put their vertices. O(degree)
template <HasPositions Mesh>
requires StoresFaceHalfedges<Mesh>
[[nodiscard]] Vector face_centroid(const Mesh& mesh, Face f) {
  return internal::centroid(mesh, mesh.face_halfedge(f));
}

/// Its share of the faces around it: of each the area, divided by the degree. The areas of all
/// vertices add up to that of the mesh. O(sum of the degrees)
template <HasPositions Mesh>
requires StoresFaces<Mesh> && StoresAnchors<Mesh>
[[nodiscard]] double vertex_area(const Mesh& mesh, Vertex v) {
  double sum = 0;
  for (const Halfedge h : mesh.outgoing_cw(v)) {
    if (mesh.is_boundary(h)) continue;
    double degree = 0;
    for ([[maybe_unused]] const Halfedge on_loop : mesh.loop_ccw(h)) ++degree;
    sum += internal::length(internal::area_vector(mesh, h)) / (2 * degree);
  }
  return sum;
}

/// The sum of the areas of the faces. O(halfedges + slots)
template <HasPositions Mesh>
requires StoresFaceHalfedges<Mesh>
[[nodiscard]] double area(const Mesh& mesh) {
  double sum = 0;
  for (const Face f : mesh.faces()) sum += face_area(mesh, f);
  return sum;
}

namespace internal {

/// open-surface, with the smallest boundary halfedge as witness; out-of-memory
template <class Mesh>
[[nodiscard]] Result<void> check_closed(const Mesh& mesh) {
  Index loops = 0;
  Halfedge first;
  Array<bool> seen;  // stays empty if the mesh is closed
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_boundary(h)) continue;
    if (seen.empty() && !seen.resize(mesh.halfedge_slots(), false)) {
      return refusals::no_memory("the count of boundary loops");
    }
    if (seen[h.index()]) continue;
    for (const Halfedge on_loop : mesh.loop_ccw(h)) seen[on_loop.index()] = true;
    if (loops++ == 0) first = h;
  }
  if (loops == 0) return {};
  return refusals::refusal("open-surface",
                           sentence::of("the mesh has {}, expected a closed surface",
                                        sentence::count_of(loops, "boundary loop")),
                           {.halfedges = {first.index()}});
}

}  // namespace internal

/// The volume inside, positive where the faces look outwards: the sum over the faces of centroid .
/// area vector / 3, seen from a corner. Where faces aren't flat it is that of their triangles with
/// the centroid. 0 without faces.
/// cost: O(halfedges + slots)
/// errors: open-surface, if there is a boundary; out-of-memory, only while its loops are counted
template <HasPositions Mesh>
requires StoresFaces<Mesh> && StoresFaceHalfedges<Mesh>
[[nodiscard]] Result<double> volume(const Mesh& mesh) {
  if (Result<void> closed = internal::check_closed(mesh); !closed) return closed;
  double sum = 0;
  std::optional<Vector> origin;
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.face_halfedge(f);
    if (!origin) origin = internal::place(mesh, mesh.to_vertex(h));
    sum += dot(internal::centroid(mesh, h, *origin), internal::area_vector(mesh, h));
  }
  return sum / 6;
}

/// From the smallest to the largest coordinates.
struct Box {
  Point min;
  Point max;

  friend bool operator==(const Box&, const Box&) = default;
};

/// Of all live vertices, isolated ones too, but those with a coordinate that is infinite or no
/// number; none if there is no vertex. O(slots)
template <HasPositions Mesh>
[[nodiscard]] std::optional<Box> bounding_box(const Mesh& mesh) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Box box = {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const Vertex v : mesh.vertices()) {
    const Point p = mesh.position(v);
    if (!std::isfinite(double{p.x} + double{p.y} + double{p.z})) continue;
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  if (!(box.min.x <= box.max.x)) return std::nullopt;
  return box;
}

}  // namespace halfedge::geometry
