#include <halfedge/operations/surgery_refusals.h>
#include <halfedge/refusals.h>
#include <halfedge/sentence.h>

#include <string>
#include <utility>

namespace halfedge::operations {

using refusals::refusal;

Failure repeated_on_seam(Vertex v) {
  return refusal(
      "repeated-vertex",
      sentence::of(
          "{} occurs more than once among the vertices to be glued, expected different vertices",
          v),
      {.vertices = {v.index()}});
}

Failure would_repeat_vertex(Face f, Vertex kept, Vertex gone) {
  return refusal(
      "repeated-vertex",
      sentence::of(
          "{} has both {} and {}, which would become one vertex, expected faces with one of them",
          f, kept, gone),
      {.vertices = {kept.index(), gone.index()}, .faces = {f.index()}});
}

Failure would_be_duplicate(Edge first, Edge second, Vertex a, Vertex b) {
  return refusal(
      "duplicate-edge",
      sentence::of("{} and {} would both join {} and {}, expected one edge between two vertices",
                   first, second, a, b),
      {.vertices = {a.index(), b.index()}, .edges = {first.index(), second.index()}});
}

Failure would_close_fan(Vertex v, Halfedge h, Halfedge g) {
  return refusal("pinched-vertex",
                 sentence::of("the faces between {} and {} would close around {}, which has other "
                              "faces too, expected no others",
                              g, h, v),
                 {.vertices = {v.index()}, .halfedges = {h.index(), g.index()}});
}

Failure no_boundary_end(Edge e, Vertex a, Vertex b) {
  return refusal("no-boundary-end",
                 sentence::of("{} would become two edges between {} and {}, which are both inside, "
                              "expected an end on the boundary, or a path of edges",
                              e, a, b),
                 {.vertices = {a.index(), b.index()}, .edges = {e.index()}});
}

Failure no_open_end(Edge e, Vertex a, Vertex b) {
  return refusal("no-boundary-end",
                 sentence::of("{} would become two edges between {} and {}, which are both inside, "
                              "expected an end on the boundary, or at another edge of the list",
                              e, a, b),
                 {.vertices = {a.index(), b.index()}, .edges = {e.index()}});
}

Failure repeated_in_list(Edge e) {
  return refusal("repeated-edge",
                 sentence::of("{} occurs twice in the list, expected different edges", e),
                 {.edges = {e.index()}});
}

Failure empty_path() {
  return refusal("not-a-path", "the path is empty, expected one halfedge or more");
}

Failure not_consecutive(Halfedge h, Vertex end, Halfedge following, Vertex begin) {
  return refusal("not-a-path",
                 sentence::of("{} leads to {}, but the next in the path, {}, leaves {}", h, end,
                              following, begin),
                 {.halfedges = {h.index(), following.index()}});
}

Failure repeated_on_path(Edge e) {
  return refusal("not-a-path",
                 sentence::of("{} occurs twice in the path, expected different edges", e),
                 {.edges = {e.index()}});
}

Failure not_a_quad(Face f, Index degree) {
  return refusal("not-a-quad", sentence::of("{} has degree {}, expected 4", f, degree),
                 {.faces = {f.index()}});
}

Failure ring_too_short(Face f, Face g) {
  return refusal("degree-below-three",
                 sentence::of("the ring consists of {} and {} only, and would leave faces of "
                              "degree 2, expected three quads or more",
                              f, g),
                 {.faces = {f.index(), g.index()}});
}

Failure repeated_on_ring(Edge e, Vertex v) {
  return refusal(
      "repeated-vertex",
      sentence::of(
          "the ring of quads over {} passes {} more than once, expected different vertices", e, v),
      {.vertices = {v.index()}, .edges = {e.index()}});
}

Failure no_triangulation(Face f, Vertex a, Vertex b, Edge existing) {
  Witness witness{.vertices = {a.index(), b.index()}, .faces = {f.index()}};
  if (existing.valid()) witness.edges = {existing.index()};
  return refusal(
      "no-triangulation",
      sentence::of("{} can't be cut into triangles without a diagonal from {} to {}, which {}, "
                   "expected diagonals that are new",
                   f, a, b,
                   (existing.valid() ? sentence::of("{} joins already", existing)
                                     : std::string("one across another face will join"))),
      std::move(witness));
}

Failure not_a_fraction(const char* name, double value) {
  return refusal("out-of-range", sentence::of("the {} is {}, expected a number from 0 to 1", name,
                                              sentence::number(value)));
}

Failure valence_below_three(Vertex v, Index valence) {
  return refusal("valence-below-three",
                 sentence::of("{} has valence {}, expected 3 at least", v, valence),
                 {.vertices = {v.index()}});
}

Failure both_valences_below_three(Edge e, Vertex a, Vertex b) {
  return refusal("valence-below-three",
                 sentence::of("the new face would have two corners: both {} and {}, the ends of "
                              "{}, have valence 2, expected 3 at one at least",
                              a, b, e),
                 {.vertices = {a.index(), b.index()}, .edges = {e.index()}});
}

}  // namespace halfedge::operations
