#include <halfedge/operations/refusals.h>
#include <halfedge/refusals.h>
#include <halfedge/sentence.h>

#include <string>
#include <utility>

namespace halfedge::operations {

using refusals::refusal;

Failure is_boundary_edge(Edge e, Halfedge side) {
  return refusal(
      "boundary-edge",
      sentence::of("{} lies on the boundary: {} has no face, expected a face on either side", e,
                   side),
      {.halfedges = {side.index()}, .edges = {e.index()}});
}

Failure not_a_triangle(Face f, Index degree) {
  return refusal("not-a-triangle", sentence::of("{} has degree {}, expected 3", f, degree),
                 {.faces = {f.index()}});
}

Failure same_vertex(Edge e, Vertex v) {
  return refusal(
      "same-vertex",
      sentence::of("the corners opposite to {} are both {}, expected two different vertices", e, v),
      {.vertices = {v.index()}, .edges = {e.index()}});
}

Failure same_side_twice(Halfedge h, Vertex v) {
  return refusal(
      "same-vertex",
      sentence::of("{} is given for both sides, and with a triangle on each the new vertex would "
                   "have two edges to {}, expected two halfedges or a corner on one side",
                   h, v),
      {.vertices = {v.index()}, .halfedges = {h.index()}});
}

Failure edge_exists(Vertex a, Vertex b, Edge existing) {
  return refusal(
      "edge-exists",
      sentence::of(
          "{} and {} are joined by {} already, expected two vertices without an edge between them",
          a, b, existing),
      {.vertices = {a.index(), b.index()}, .edges = {existing.index()}});
}

// ---- faces added, joined, divided -----------------------------------------------------------

Failure degree_below_three(Index degree, std::span<const Vertex> corners, Vertex without) {
  Witness witness;
  if (without.valid()) witness.vertices.push_back(without.index());
  for (const Vertex v : corners) witness.vertices.push_back(v.index());
  const std::string which = without.valid() ? sentence::of(" without {}", without) : "";
  return refusal(
      "degree-below-three",
      sentence::of("the face{} would have degree {}, expected 3 at least", which, degree),
      std::move(witness));
}

Failure repeated_vertex(Vertex v) {
  return refusal(
      "repeated-vertex",
      sentence::of("{} would be at two corners of one face, expected different vertices", v),
      {.vertices = {v.index()}});
}

Failure duplicate_face(Face f, bool is_reversed) {
  return refusal("duplicate-face",
                 sentence::of("{} has the same corners{}, expected a face that is not there yet", f,
                              is_reversed ? ", in reverse" : ""),
                 {.faces = {f.index()}});
}

Failure edge_with_many_faces(Edge e, Face f, Face g) {
  return refusal("edge-with-many-faces",
                 sentence::of("{} has two faces already, {} and {}, expected one at most", e, f, g),
                 {.edges = {e.index()}, .faces = {f.index(), g.index()}});
}

Failure opposite_orientation(Edge e, Face f, Vertex a, Vertex b) {
  return refusal(
      "opposite-orientation",
      sentence::of(
          "{} runs along {} from {} to {}, as the new face would, expected the opposite direction",
          f, e, a, b),
      {.vertices = {a.index(), b.index()}, .edges = {e.index()}, .faces = {f.index()}});
}

Failure closed_beside_another(Vertex v, Face f, Face g) {
  Witness witness{.vertices = {v.index()}};
  for (const Face face : {f, g}) {
    if (face.valid()) witness.faces.push_back(face.index());
  }
  const bool is_closed = !g.valid();
  return refusal(
      "pinched-vertex",
      sentence::of("the faces around {}{} closed, and {} would not be among them, expected no "
                   "other face beside closed ones",
                   v, is_closed ? " are" : " would be",
                   is_closed ? "the new face" : sentence::of("{}", g)),
      std::move(witness));
}

Failure same_corner(Vertex v, Halfedge h, Halfedge g) {
  return refusal(
      "same-corner",
      sentence::of("{} and {} both lead to {}, expected two different vertices", h, g, v),
      {.vertices = {v.index()}, .halfedges = {h.index(), g.index()}});
}

Failure adjacent_corners(Halfedge between, Vertex a, Vertex b) {
  return refusal("adjacent-corners",
                 sentence::of("{} and {} are joined by {} of the same loop, expected two corners "
                              "that are not neighbours",
                              a, b, between),
                 {.vertices = {a.index(), b.index()}, .halfedges = {between.index()}});
}

Failure faces_share_edges(Face f, Face g, std::span<const Edge> edges) {
  Witness witness{.faces = {f.index(), g.index()}};
  for (const Edge e : edges) witness.edges.push_back(e.index());
  return refusal("faces-share-edges",
                 sentence::of("{} and {} share {} edges, expected {} to be the only one", f, g,
                              Index(edges.size()), edges[0]),
                 std::move(witness));
}

Failure faces_share_vertex(Face f, Face g, Vertex v) {
  return refusal("faces-share-vertex",
                 sentence::of("{} and {} also meet at {}, which would be at two corners of the "
                              "joined face, expected them to share nothing else",
                              f, g, v),
                 {.vertices = {v.index()}, .faces = {f.index(), g.index()}});
}

Failure is_isolated_vertex(Vertex v) {
  return refusal("isolated-vertex", sentence::of("{} has no face, expected a vertex with faces", v),
                 {.vertices = {v.index()}});
}

Failure is_pinched_vertex(Vertex v, Halfedge h, Halfedge g) {
  return refusal(
      "pinched-vertex",
      sentence::of(
          "the faces around {} are in separate fans, beginning at {} and {}, expected one fan", v,
          h, g),
      {.vertices = {v.index()}, .halfedges = {h.index(), g.index()}});
}

Failure degenerate_face(Face f) {
  return refusal("degenerate-face",
                 sentence::of("{} has no area, expected a face with a normal", f),
                 {.faces = {f.index()}});
}

Failure not_finite(const char* name, double value) {
  return refusal("not-finite", sentence::of("the {} is {}, expected a finite number", name,
                                            sentence::number(value)));
}

Failure too_far(Face f, double offset) {
  return refusal("not-finite",
                 sentence::of("an offset of {} takes {} to where positions fit no 32-bit floats, "
                              "expected a smaller one",
                              sentence::number(offset), f),
                 {.faces = {f.index()}});
}

// ---- edges divided and contracted -----------------------------------------------------------

Failure not_valence_two(Vertex v, Index valence) {
  return refusal("not-valence-two", sentence::of("{} has valence {}, expected 2", v, valence),
                 {.vertices = {v.index()}});
}

Failure would_have_two_corners(Vertex v, Face f) {
  return refusal(
      "degree-below-three",
      sentence::of("{} has degree 3 and would lose its corner {}, expected four corners or more", f,
                   v),
      {.vertices = {v.index()}, .faces = {f.index()}});
}

Failure joins_boundary_vertices(Edge e, Vertex a, Vertex b) {
  return refusal("boundary-vertices",
                 sentence::of("{} lies inside, but {} and {} both lie on the boundary, which would "
                              "meet itself there, expected at most one of them to",
                              e, a, b),
                 {.vertices = {a.index(), b.index()}, .edges = {e.index()}});
}

Failure would_leave_bare_edge(Face f, Edge g, Edge k) {
  return refusal("edge-without-face",
                 sentence::of("{} would vanish, and its edges {} and {}, both on the boundary, "
                              "would become one without a face, expected a face beyond one of them",
                              f, g.index(), k.index()),
                 {.edges = {g.index(), k.index()}, .faces = {f.index()}});
}

Failure is_common_neighbour(Vertex v, Edge e, Edge to_a, Edge to_b) {
  return refusal(
      "common-neighbour",
      sentence::of(
          "{} is joined to both ends of {}, by {} and {}, which would become two edges between the "
          "same vertices, expected only corners of triangles at {} to be joined to both",
          v, e, to_a, to_b, e),
      {.vertices = {v.index()}, .edges = {to_a.index(), to_b.index()}});
}

Failure has_both_ends(Face f, Edge e, Vertex a, Vertex b) {
  return refusal("repeated-vertex",
                 sentence::of("{} has both ends of {} as corners, {} and {}, which would become "
                              "one, expected only faces at {} to have both",
                              f, e, a, b, e),
                 {.vertices = {a.index(), b.index()}, .faces = {f.index()}});
}

Failure would_leave_pillow(Edge e, Face f, Face g) {
  return refusal("leaves-pillow",
                 sentence::of("without {}, {} and {} would have the same corners and lie upon each "
                              "other, expected another face between them",
                              e, f, g),
                 {.edges = {e.index()}, .faces = {f.index(), g.index()}});
}

Failure leave_different_vertices(Halfedge h, Vertex v, Halfedge g, Vertex w) {
  return refusal("different-vertices",
                 sentence::of("{} leaves {} and {} leaves {}, expected one vertex", h, v, g, w),
                 {.vertices = {v.index(), w.index()}, .halfedges = {h.index(), g.index()}});
}

Failure nothing_between(Halfedge h, Halfedge g) {
  return refusal(
      "nothing-between",
      sentence::of("no halfedge lies counter-clockwise between {} and {}, and without a triangle "
                   "the new vertex would have one edge, expected a halfedge between or a triangle",
                   h, g),
      {.halfedges = {h.index(), g.index()}});
}

Failure would_be_bare_edge(Vertex v, Halfedge h, Halfedge g) {
  return refusal(
      "edge-without-face",
      sentence::of("the new edge at {} would have no face on either side: the boundary lies to the "
                   "left of {} and to the right of {}, expected a face or a triangle on one side",
                   v, h, g),
      {.vertices = {v.index()}, .halfedges = {h.index(), g.index()}});
}

}  // namespace halfedge::operations
