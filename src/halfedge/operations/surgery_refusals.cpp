#include <halfedge/build/sentence.h>
#include <halfedge/decorator/refusal.h>
#include <halfedge/operations/surgery_refusals.h>

#include <string>
#include <utility>

namespace halfedge::operations {

using decorator::internal::number;
using decorator::internal::refusal;
using decorator::internal::text;

Failure repeated_on_seam(Vertex v) {
  return refusal("repeated-vertex",
                 text(v) +
                     " occurs more than once among the vertices to be glued, expected "
                     "different vertices",
                 {.vertices = {v.index()}});
}

Failure would_repeat_vertex(Face f, Vertex kept, Vertex gone) {
  return refusal("repeated-vertex",
                 text(f) + " has both " + text(kept) + " and " + text(gone) +
                     ", which would become one vertex, expected faces with one of them",
                 {.vertices = {kept.index(), gone.index()}, .faces = {f.index()}});
}

Failure would_be_duplicate(Edge first, Edge second, Vertex a, Vertex b) {
  return refusal("duplicate-edge",
                 text(first) + " and " + text(second) + " would both join " + text(a) + " and " +
                     text(b) + ", expected one edge between two vertices",
                 {.vertices = {a.index(), b.index()}, .edges = {first.index(), second.index()}});
}

Failure would_close_fan(Vertex v, Halfedge h, Halfedge g) {
  return refusal("pinched-vertex",
                 "the faces between " + text(g) + " and " + text(h) + " would close around " +
                     text(v) + ", which has other faces too, expected no others",
                 {.vertices = {v.index()}, .halfedges = {h.index(), g.index()}});
}

Failure no_boundary_end(Edge e, Vertex a, Vertex b) {
  return refusal("no-boundary-end",
                 text(e) + " would become two edges between " + text(a) + " and " + text(b) +
                     ", which are both inside, expected an end on the boundary, or a path of "
                     "edges",
                 {.vertices = {a.index(), b.index()}, .edges = {e.index()}});
}

Failure empty_path() {
  return refusal("not-a-path", "the path is empty, expected one halfedge or more");
}

Failure not_consecutive(Halfedge h, Vertex end, Halfedge following, Vertex begin) {
  return refusal("not-a-path",
                 text(h) + " leads to " + text(end) + ", but the next in the path, " +
                     text(following) + ", leaves " + text(begin),
                 {.halfedges = {h.index(), following.index()}});
}

Failure repeated_on_path(Edge e) {
  return refusal("not-a-path", text(e) + " occurs twice in the path, expected different edges",
                 {.edges = {e.index()}});
}

Failure not_a_quad(Face f, Index degree) {
  return refusal("not-a-quad", text(f) + " has degree " + number(degree) + ", expected 4",
                 {.faces = {f.index()}});
}

Failure ring_too_short(Face f, Face g) {
  return refusal("degree-below-three",
                 "the ring consists of " + text(f) + " and " + text(g) +
                     " only, and would leave faces of degree 2, expected three quads or more",
                 {.faces = {f.index(), g.index()}});
}

Failure repeated_on_ring(Edge e, Vertex v) {
  return refusal("repeated-vertex",
                 "the ring of quads over " + text(e) + " passes " + text(v) +
                     " more than once, expected different vertices",
                 {.vertices = {v.index()}, .edges = {e.index()}});
}

Failure no_triangulation(Face f, Vertex a, Vertex b, Edge existing) {
  Witness witness{.vertices = {a.index(), b.index()}, .faces = {f.index()}};
  if (existing.valid()) witness.edges = {existing.index()};
  return refusal("no-triangulation",
                 text(f) + " can't be cut into triangles without a diagonal from " + text(a) +
                     " to " + text(b) + ", which " +
                     (existing.valid() ? text(existing) + " joins already"
                                       : std::string("one across another face will join")) +
                     ", expected diagonals that are new",
                 std::move(witness));
}

Failure not_a_fraction(const char* name, double value) {
  return refusal("out-of-range", std::string("the ") + name + " is " + sentence::number(value) +
                                     ", expected a number from 0 to 1");
}

Failure valence_below_three(Vertex v, Index valence) {
  return refusal("valence-below-three",
                 text(v) + " has valence " + number(valence) + ", expected 3 at least",
                 {.vertices = {v.index()}});
}

Failure both_valences_below_three(Edge e, Vertex a, Vertex b) {
  return refusal("valence-below-three",
                 "the new face would have two corners: both " + text(a) + " and " + text(b) +
                     ", the ends of " + text(e) + ", have valence 2, expected 3 at one at least",
                 {.vertices = {a.index(), b.index()}, .edges = {e.index()}});
}

}  // namespace halfedge::operations
