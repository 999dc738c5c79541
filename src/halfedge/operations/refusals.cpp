#include <halfedge/build/sentence.h>
#include <halfedge/decorator/refusal.h>
#include <halfedge/operations/refusals.h>

#include <string>
#include <utility>

namespace halfedge::operations {

using decorator::internal::number;
using decorator::internal::refusal;
using decorator::internal::text;

Failure is_boundary_edge(Edge e, Halfedge side) {
  return refusal("boundary-edge",
                 text(e) + " lies on the boundary: " + text(side) +
                     " has no face, expected a face on either side",
                 {.halfedges = {side.index()}, .edges = {e.index()}});
}

Failure not_a_triangle(Face f, Index degree) {
  return refusal("not-a-triangle", text(f) + " has degree " + number(degree) + ", expected 3",
                 {.faces = {f.index()}});
}

Failure same_vertex(Edge e, Vertex v) {
  return refusal("same-vertex",
                 "the corners opposite to " + text(e) + " are both " + text(v) +
                     ", expected two different vertices",
                 {.vertices = {v.index()}, .edges = {e.index()}});
}

Failure edge_exists(Vertex a, Vertex b, Edge existing) {
  return refusal("edge-exists",
                 text(a) + " and " + text(b) + " are joined by " + text(existing) +
                     " already, expected two vertices without an edge between them",
                 {.vertices = {a.index(), b.index()}, .edges = {existing.index()}});
}

// ---- faces added, joined, divided -----------------------------------------------------------

Failure degree_below_three(Index degree, std::span<const Vertex> corners) {
  Witness witness;
  for (const Vertex v : corners) witness.vertices.push_back(v.index());
  return refusal("degree-below-three",
                 "the face would have degree " + number(degree) + ", expected 3 at least",
                 std::move(witness));
}

Failure repeated_vertex(Vertex v) {
  return refusal("repeated-vertex",
                 text(v) + " would be at two corners of one face, expected different vertices",
                 {.vertices = {v.index()}});
}

Failure duplicate_face(Face f, bool is_reversed) {
  return refusal("duplicate-face",
                 text(f) + " has the same corners" + (is_reversed ? ", in reverse" : "") +
                     ", expected a face that is not there yet",
                 {.faces = {f.index()}});
}

Failure edge_with_many_faces(Edge e, Face f, Face g) {
  return refusal(
      "edge-with-many-faces",
      text(e) + " has two faces already, " + text(f) + " and " + text(g) + ", expected one at most",
      {.edges = {e.index()}, .faces = {f.index(), g.index()}});
}

Failure opposite_orientation(Edge e, Face f, Vertex a, Vertex b) {
  return refusal("opposite-orientation",
                 text(f) + " runs along " + text(e) + " from " + text(a) + " to " + text(b) +
                     ", as the new face would, expected the opposite direction",
                 {.vertices = {a.index(), b.index()}, .edges = {e.index()}, .faces = {f.index()}});
}

Failure closed_beside_another(Vertex v, Face f, Face g) {
  Witness witness{.vertices = {v.index()}};
  for (const Face face : {f, g}) {
    if (face.valid()) witness.faces.push_back(face.index());
  }
  const bool is_closed = !g.valid();
  return refusal("pinched-vertex",
                 "the faces around " + text(v) + (is_closed ? " are" : " would be") +
                     " closed, and " + (is_closed ? "the new face" : text(g)) +
                     " would not be among them, expected no other face beside closed ones",
                 std::move(witness));
}

Failure same_corner(Vertex v, Halfedge h, Halfedge g) {
  return refusal("same-corner",
                 text(h) + " and " + text(g) + " both lead to " + text(v) +
                     ", expected two different vertices",
                 {.vertices = {v.index()}, .halfedges = {h.index(), g.index()}});
}

Failure adjacent_corners(Halfedge between, Vertex a, Vertex b) {
  return refusal("adjacent-corners",
                 text(a) + " and " + text(b) + " are joined by " + text(between) +
                     " of the same loop, expected two corners that are not neighbours",
                 {.vertices = {a.index(), b.index()}, .halfedges = {between.index()}});
}

Failure faces_share_edges(Face f, Face g, std::span<const Edge> edges) {
  Witness witness{.faces = {f.index(), g.index()}};
  for (const Edge e : edges) witness.edges.push_back(e.index());
  return refusal("faces-share-edges",
                 text(f) + " and " + text(g) + " share " + number(Index(edges.size())) +
                     " edges, expected " + text(edges[0]) + " to be the only one",
                 std::move(witness));
}

Failure faces_share_vertex(Face f, Face g, Vertex v) {
  return refusal("faces-share-vertex",
                 text(f) + " and " + text(g) + " also meet at " + text(v) +
                     ", which would be at two corners of the joined face, expected them to share "
                     "nothing else",
                 {.vertices = {v.index()}, .faces = {f.index(), g.index()}});
}

Failure is_isolated_vertex(Vertex v) {
  return refusal("isolated-vertex", text(v) + " has no face, expected a vertex with faces",
                 {.vertices = {v.index()}});
}

Failure is_pinched_vertex(Vertex v, Halfedge h, Halfedge g) {
  return refusal("pinched-vertex",
                 "the faces around " + text(v) + " are in separate fans, beginning at " + text(h) +
                     " and " + text(g) + ", expected one fan",
                 {.vertices = {v.index()}, .halfedges = {h.index(), g.index()}});
}

Failure degenerate_face(Face f) {
  return refusal("degenerate-face", text(f) + " has no area, expected a face with a normal",
                 {.faces = {f.index()}});
}

Failure not_finite(const char* name, double value) {
  return refusal("not-finite", std::string("the ") + name + " is " + sentence::number(value) +
                                   ", expected a finite number");
}

// ---- edges divided and contracted -----------------------------------------------------------

Failure not_valence_two(Vertex v, Index valence) {
  return refusal("not-valence-two", text(v) + " has valence " + number(valence) + ", expected 2",
                 {.vertices = {v.index()}});
}

Failure would_have_two_corners(Vertex v, Face f) {
  return refusal("degree-below-three",
                 text(f) + " has degree 3 and would lose its corner " + text(v) +
                     ", expected four corners or more",
                 {.vertices = {v.index()}, .faces = {f.index()}});
}

Failure joins_boundary_vertices(Edge e, Vertex a, Vertex b) {
  return refusal("boundary-vertices",
                 text(e) + " lies inside, but " + text(a) + " and " + text(b) +
                     " both lie on the boundary, which would meet itself there, expected at most "
                     "one of them to",
                 {.vertices = {a.index(), b.index()}, .edges = {e.index()}});
}

Failure would_leave_bare_edge(Face f, Edge g, Edge k) {
  return refusal("edge-without-face",
                 text(f) + " would vanish, and its edges " + number(g.index()) + " and " +
                     number(k.index()) +
                     ", both on the boundary, would become one without a face, expected a face "
                     "beyond one of them",
                 {.edges = {g.index(), k.index()}, .faces = {f.index()}});
}

Failure is_common_neighbour(Vertex v, Edge e, Edge to_a, Edge to_b) {
  return refusal("common-neighbour",
                 text(v) + " is joined to both ends of " + text(e) + ", by " + text(to_a) +
                     " and " + text(to_b) +
                     ", which would become two edges between the same vertices, expected only "
                     "corners of triangles at " +
                     text(e) + " to be joined to both",
                 {.vertices = {v.index()}, .edges = {to_a.index(), to_b.index()}});
}

Failure has_both_ends(Face f, Edge e, Vertex a, Vertex b) {
  return refusal("repeated-vertex",
                 text(f) + " has both ends of " + text(e) + " as corners, " + text(a) + " and " +
                     text(b) + ", which would become one, expected only faces at " + text(e) +
                     " to have both",
                 {.vertices = {a.index(), b.index()}, .faces = {f.index()}});
}

Failure would_leave_pillow(Edge e, Face f, Face g) {
  return refusal("leaves-pillow",
                 "without " + text(e) + ", " + text(f) + " and " + text(g) +
                     " would have the same corners and lie upon each other, expected another face "
                     "between them",
                 {.edges = {e.index()}, .faces = {f.index(), g.index()}});
}

Failure leave_different_vertices(Halfedge h, Vertex v, Halfedge g, Vertex w) {
  return refusal("different-vertices",
                 text(h) + " leaves " + text(v) + " and " + text(g) + " leaves " + text(w) +
                     ", expected one vertex",
                 {.vertices = {v.index(), w.index()}, .halfedges = {h.index(), g.index()}});
}

Failure nothing_between(Halfedge h, Halfedge g) {
  return refusal("nothing-between",
                 "no halfedge lies counter-clockwise between " + text(h) + " and " + text(g) +
                     ", and without a triangle the new vertex would have one edge, expected a "
                     "halfedge between or a triangle",
                 {.halfedges = {h.index(), g.index()}});
}

Failure would_be_bare_edge(Vertex v, Halfedge h, Halfedge g) {
  return refusal("edge-without-face",
                 "the new edge at " + text(v) +
                     " would have no face on either side: the boundary lies to the left of " +
                     text(h) + " and to the right of " + text(g) +
                     ", expected a face or a triangle on one side",
                 {.vertices = {v.index()}, .halfedges = {h.index(), g.index()}});
}

}  // namespace halfedge::operations
