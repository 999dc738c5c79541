// A program for debugging, whose circulators are checked, linked with code that was compiled
// without that, as a library may be: each side has its own functions. Neither is optimised, so that
// nothing is in line.

#include <halfedge/operations/add_face.h>

#include <utility>

halfedge::Index walk_unchecked(const halfedge::Mesh& mesh, halfedge::Vertex v);

int main() {
  using namespace halfedge;
  Mesh mesh;
  Vertex corners[5];
  for (Vertex& v : corners) v = mesh.add_vertex({});
  const auto [v, a, b, c, d] = corners;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, d)}) {
    if (!operations::add_face(mesh, {v, from, to})) return 1;
  }
  Index sum = 0;
  for (const Vertex w : mesh.vertex_vertices_cw(v)) sum = 10 * sum + w.index();
  for (const Face f : mesh.faces()) sum = 10 * sum + f.index();
  return sum == 4321012 || sum == 1234012 ? walk_unchecked(mesh, v) != sum : 2;
}
