#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/decorator/refusal.h>
#include <halfedge/geometry/loop.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>
#include <halfedge/vector.h>

/// Which way faces and vertices face.
namespace halfedge::geometry {

namespace internal {

/// The area vectors of faces that share a vertex, and how long they are together.
struct NormalSum {
  Vector area = {};
  double lengths = 0;

  void add(const Vector& of_face, double its_length) {
    area += of_face;
    lengths += its_length;
  }
  /// Zeros if nothing but rounding errors is left.
  [[nodiscard]] Vector normal() const { return unit(area, 1e-10 * lengths); }
};

}  // namespace internal

/// Normal to the face and twice as long as its area, by Newell's method: the sum of the cross
/// products of the corners. Of a polygon that isn't flat it tells the largest projection. O(degree)
template <HasPositions Mesh>
requires StoresFaceHalfedges<Mesh>
[[nodiscard]] Vector area_vector(const Mesh& mesh, Face f) {
  return internal::area_vector(mesh, mesh.face_halfedge(f));
}

/// The same with length 1; zeros where the face has no area, or one that isn't finite. O(degree)
template <HasPositions Mesh>
requires StoresFaceHalfedges<Mesh>
[[nodiscard]] Vector face_normal(const Mesh& mesh, Face f) {
  return internal::unit(area_vector(mesh, f));
}

/// The sum of the area vectors of the faces around `v`, so that large faces count more, with length
/// 1. Zeros where there are no faces, where their area vectors cancel out (their sum is shorter
/// than 1e-10 of their lengths together), or where one isn't finite. O(sum of the degrees)
template <HasPositions Mesh>
requires StoresFaces<Mesh> && StoresAnchors<Mesh>
[[nodiscard]] Vector vertex_normal(const Mesh& mesh, Vertex v) {
  internal::NormalSum sum;
  for (const Halfedge h : mesh.outgoing_cw(v)) {
    if (mesh.is_boundary(h)) continue;
    const Vector area = internal::area_vector(mesh, h);
    sum.add(area, internal::length(area));
  }
  return sum.normal();
}

/// face_normal of all faces by slot, as floats; zeros at deleted slots. cost: O(halfedges + slots)
/// errors: out-of-memory
template <HasPositions Mesh>
requires StoresFaceHalfedges<Mesh>
[[nodiscard]] Result<Array<Point>> face_normals(const Mesh& mesh) {
  Array<Point> normals;
  if (!normals.resize(mesh.face_slots())) {
    return decorator::internal::no_memory("the normals of the faces");
  }
  for (Index f = 0; f < normals.size(); ++f) {
    const bool is_there = !mesh.is_deleted(Face(f));
    normals[f] = is_there ? internal::rounded(face_normal(mesh, Face(f))) : Point{};
  }
  return normals;
}

/// vertex_normal of all vertices by slot, as floats; zeros at deleted slots. Each face is looked at
/// once, and added to its corners.
/// cost: O(halfedges + slots), 32 bytes for each vertex slot meanwhile
/// errors: out-of-memory
template <HasPositions Mesh>
requires StoresFaceHalfedges<Mesh>
[[nodiscard]] Result<Array<Point>> vertex_normals(const Mesh& mesh) {
  Array<internal::NormalSum> sums;
  Array<Point> normals;
  if (!sums.resize(mesh.vertex_slots(), internal::NormalSum{}) ||
      !normals.resize(mesh.vertex_slots())) {
    return decorator::internal::no_memory("the normals of the vertices");
  }
  for (const Face f : mesh.faces()) {
    const Vector area = area_vector(mesh, f);
    const double length = internal::length(area);
    for (const Vertex v : mesh.face_vertices_ccw(f)) sums[v.index()].add(area, length);
  }
  for (Index v = 0; v < normals.size(); ++v) normals[v] = internal::rounded(sums[v].normal());
  return normals;
}

}  // namespace halfedge::geometry
