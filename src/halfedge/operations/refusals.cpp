#include <halfedge/decorator/refusal.h>
#include <halfedge/operations/refusals.h>

namespace halfedge::operations {

using decorator::internal::number;
using decorator::internal::refusal;
using decorator::internal::text;

Error is_boundary_edge(Edge e, Halfedge side) {
  return refusal("boundary-edge",
                 text(e) + " lies on the boundary: " + text(side) +
                     " has no face, expected a face on either side",
                 {.halfedges = {side.index()}, .edges = {e.index()}});
}

Error not_a_triangle(Face f, Index degree) {
  return refusal("not-a-triangle", text(f) + " has degree " + number(degree) + ", expected 3",
                 {.faces = {f.index()}});
}

Error same_vertex(Edge e, Vertex v) {
  return refusal("same-vertex",
                 "the corners opposite to " + text(e) + " are both " + text(v) +
                     ", expected two different vertices",
                 {.vertices = {v.index()}, .edges = {e.index()}});
}

Error edge_exists(Vertex a, Vertex b, Edge existing) {
  return refusal("edge-exists",
                 text(a) + " and " + text(b) + " are joined by " + text(existing) +
                     " already, expected two vertices without an edge between them",
                 {.vertices = {a.index(), b.index()}, .edges = {existing.index()}});
}

}  // namespace halfedge::operations
