#pragma once

#include <halfedge/mesh.h>
#include <halfedge/operations/operations.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "contender.h"

/// What is done to our mesh: the workloads of Sieger and Botsch (see contender.h).
namespace workloads {

inline void require(bool done) {
  if (!done) std::abort();
}

/// ++ for each face of each vertex, -- for each vertex of each face.
inline std::int64_t circulate(const halfedge::Mesh& mesh) {
  std::int64_t counter = 0;
  for (const halfedge::Vertex v : mesh.vertices()) {
    for ([[maybe_unused]] const halfedge::Face f : mesh.vertex_faces_cw(v)) ++counter;
  }
  for (const halfedge::Face f : mesh.faces()) {
    for ([[maybe_unused]] const halfedge::Vertex v : mesh.face_vertices_ccw(f)) --counter;
  }
  return counter;
}

inline std::uint64_t one_ring_sum(const halfedge::Mesh& mesh) {
  std::uint64_t sum = 0;
  for (const halfedge::Vertex v : mesh.vertices()) {
    for (const halfedge::Vertex w : mesh.vertex_vertices_cw(v)) sum += w.index();
  }
  return sum;
}

inline halfedge::Point operator+(halfedge::Point a, halfedge::Point b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline halfedge::Point operator-(halfedge::Point a, halfedge::Point b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline halfedge::Point operator*(float t, halfedge::Point p) { return {t * p.x, t * p.y, t * p.z}; }

inline halfedge::Point unit(halfedge::Point p) {
  return 1 / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) * p;
}

/// The mean of the vertices. Kept out of `centre`, where g++ 12 adds x and y one by one; here it
/// adds both with one instruction, as it does in the flat baseline.
[[gnu::noinline]] inline halfedge::Point mean_position(const halfedge::Mesh& mesh) {
  double sum[3] = {};
  for (const halfedge::Vertex v : mesh.vertices()) {
    const halfedge::Point p = mesh.position(v);
    sum[0] += double(p.x), sum[1] += double(p.y), sum[2] += double(p.z);
  }
  const double count = mesh.vertex_count();
  return {float(sum[0] / count), float(sum[1] / count), float(sum[2] / count)};
}

/// The mean of the vertices goes to the origin. All of them move, so their coordinates are written
/// as one array: that of a deleted one may move along.
inline void centre(halfedge::Mesh& mesh) {
  const halfedge::Point mean = mean_position(mesh);
  const std::span<float> all = mesh.mutable_positions().span();
  for (std::size_t x = 0; x < all.size(); x += 3) {
    all[x] -= mean.x, all[x + 1] -= mean.y, all[x + 2] -= mean.z;
  }
}

/// Unit normals of the faces, from three vertices; of each vertex the sum of those around it, of
/// unit length.
inline void normals(const halfedge::Mesh& mesh, std::vector<halfedge::Point>& of_faces,
                    std::vector<halfedge::Point>& of_vertices) {
  using namespace halfedge;
  of_faces.resize(mesh.face_slots());
  of_vertices.resize(mesh.vertex_slots());
  for (const Face f : mesh.faces()) {
    const Halfedge h = mesh.face_halfedge(f);
    const Point p = mesh.position(mesh.from_vertex(h));
    const Point a = mesh.position(mesh.to_vertex(h)) - p;
    const Point b = mesh.position(mesh.to_vertex(mesh.next(h))) - p;
    of_faces[f.index()] =
        unit({a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x});
  }
  for (const Vertex v : mesh.vertices()) {
    Point sum;
    for (const Face f : mesh.vertex_faces_cw(v)) sum = sum + of_faces[f.index()];
    of_vertices[v.index()] = unit(sum);
  }
}

/// Each vertex that isn't on the boundary goes to the mean of its one-ring, in place.
inline void smooth(halfedge::Mesh& mesh) {
  using namespace halfedge;
  for (const Vertex v : mesh.vertices()) {
    if (mesh.is_boundary(v)) continue;
    Point sum;
    float valence = 0;
    for (const Vertex w : mesh.vertex_vertices_cw(v)) {
      sum = sum + mesh.position(w);
      ++valence;
    }
    mesh.set_position(v, 1 / valence * sum);
  }
}

/// All faces, in the order in which their halfedges lie. These are numbered by vertex, not by face
/// as in the other libraries, where the order of the faces is that of the halfedges.
inline std::vector<halfedge::Face> faces_as_stored(const halfedge::Mesh& mesh) {
  std::vector<halfedge::Face> faces(mesh.face_slots() + 1);  // one to write to in vain
  std::size_t count = 0;
  for (const halfedge::Halfedge h : mesh.halfedges()) {
    const halfedge::Face f = mesh.face(h);
    faces[count] = f;
    count += std::size_t(f.valid() && mesh.face_halfedge(f) == h);  // no branch to mispredict
  }
  faces.resize(count);
  return faces;
}

/// A vertex in each face.
inline void split_faces(halfedge::Mesh& mesh) {
  using namespace halfedge;
  const std::vector<Face> faces = faces_as_stored(mesh);
  require(mesh.reserve(mesh.vertex_slots() + mesh.face_slots(),
                       mesh.edge_slots() + 3 * mesh.face_slots(), 3 * mesh.face_slots()));
  operations::for_each(mesh, std::span<const Face>(faces),
                       [&](Face f) { require(bool(operations::split_face(mesh, f))); });
}

/// Contracts an edge of each vertex behind the first `kept`.
inline void collapse_behind(halfedge::Mesh& mesh, halfedge::Index kept) {
  using namespace halfedge;
  for (Index v = kept; v < mesh.vertex_slots(); ++v) {
    require(bool(operations::collapse(mesh, mesh.vertex_halfedge(Vertex(v)))));
  }
}

/// A step of sqrt(3) subdivision by operations (see Contender).
inline void subdivide(halfedge::Mesh& mesh) {
  using namespace halfedge;
  std::vector<Point> moved(mesh.vertex_slots());
  for (const Vertex v : mesh.vertices()) {
    Point sum;
    unsigned valence = 0;
    for (const Vertex w : mesh.vertex_vertices_cw(v)) {
      sum = sum + mesh.position(w);
      ++valence;
    }
    const float weight = sqrt3_weight(valence);
    moved[v.index()] = (1 - weight) * mesh.position(v) + weight / float(valence) * sum;
  }
  std::vector<Edge> old_edges(mesh.edge_slots());
  for (Index e = 0; e < old_edges.size(); ++e) old_edges[e] = Edge(e);
  split_faces(mesh);
  for (Index v = 0; v < moved.size(); ++v) mesh.set_position(Vertex(v), moved[v]);
  operations::for_each(mesh, std::span<const Edge>(old_edges),
                       [&](Edge e) { (void)operations::flip_edge(mesh, e); });
}

}  // namespace workloads
