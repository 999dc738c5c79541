// Compiled without checked circulators: see checked.cpp.

#include <halfedge/mesh.h>

halfedge::Index walk_unchecked(const halfedge::Mesh& mesh, halfedge::Vertex v) {
  halfedge::Index sum = 0;
  for (const halfedge::Vertex w : mesh.vertex_vertices_cw(v)) sum = 10 * sum + w.index();
  for (const halfedge::Face f : mesh.faces()) sum = 10 * sum + f.index();
  return sum;
}
