#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/decorator/boundary.h>
#include <halfedge/decorator/faces.h>
#include <halfedge/operations/holes.h>
#include <halfedge/operations/requirements.h>

#include <utility>

namespace halfedge::operations {

/// Whether insert_edge(h, g) can be done: else
/// - not-a-halfedge; different-loops
/// - same-corner, if both lead to one vertex; adjacent-corners; edge-exists
/// - repeated-vertex, if the loop has no face, and the part of it that would get one passes a
///   pinched vertex twice; out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_insert_edge(const Mesh& mesh, Halfedge h, Halfedge g) {
  for (const Halfedge given : {h, g}) {
    if (Result<void> live = check_live(mesh, given); !live) return live;
  }
  if (!steps::is_one_loop(mesh, h, g)) {
    return refusals::in_different_loops(h, g);
  }
  const Vertex a = mesh.to_vertex(h);
  const Vertex b = mesh.to_vertex(g);
  if (a == b) return same_corner(a, h, g);
  if (mesh.next(h) == g) return adjacent_corners(g, a, b);
  if (mesh.next(g) == h) return adjacent_corners(h, b, a);
  if (const Edge existing = mesh.find_edge(a, b); existing.valid()) {
    return edge_exists(a, b, existing);
  }
  if (mesh.is_boundary(h)) return internal::check_face_on_boundary(mesh, mesh.next(h), g);
  return {};
}

/// A new edge from to_vertex(h) to to_vertex(g), two corners of one loop, which it divides. The
/// part after h, up to g, becomes a new face; the part after g, up to h, keeps what the loop was: a
/// face is cut in two; of a boundary loop a part is covered, and the rest stays open.
/// (CGAL: Euler::split_face, Euler::add_face_to_border; OpenMesh: insert_edge)
///
///      ---h---> a ------>           ---h---> a ------>
///     |                  |         |         |        |
///     |    face or none  |    =>   |  as     | new    |
///     |                  |         |  before | face   |
///      <------- b <---g--           <------- b <---g--
///
/// attributes: a face cut in two gives its values to the new one, a face on a boundary has the
///             defaults; corners that are cut become two alike; the edge has the defaults
/// returns: the edge; its halfedge 0 leads from a to b in a face, from b to a in the new face of a
///          boundary loop, so that `remove_edge` keeps the old face
/// cost: O(halfedges of the new face + the smaller valence of a and b), and where the loop has no
///       face, of the loop and the sum of the valences along the new face
/// inverse: remove_edge(returned)
/// errors: those of check_insert_edge, out-of-memory
template <EditableSurface Mesh>
[[nodiscard]] Result<Edge> insert_edge(Mesh& mesh, Halfedge h, Halfedge g) {
  if (Result<void> can = check_insert_edge(mesh, h, g); !can) return can;
  Result<Halfedge> inserted = mesh.is_boundary(h) ? decorator::add_face_to_boundary(mesh, h, g)
                                                  : decorator::split_face(mesh, h, g);
  if (!inserted) return std::move(inserted).failure();
  return mesh.edge(inserted.value());
}

namespace internal {

/// Whether the faces of `h` and of opposite(h) can be joined along `count` edges in a row, of which
/// `h` is the first: not if they have other edges or vertices in common.
template <class Mesh>
[[nodiscard]] Result<void> check_join_along(const Mesh& mesh, Halfedge h, Index count) {
  const Face f = mesh.face(h);
  const Face g = mesh.face(mesh.opposite(h));
  Halfedge after = h;
  for (Index i = 0; i < count; ++i) after = mesh.next(after);
  bool is_shared = false;
  for (Halfedge on_loop = after; on_loop != h && !is_shared; on_loop = mesh.next(on_loop)) {
    is_shared = mesh.face(mesh.opposite(on_loop)) == g;
  }
  if (is_shared) {
    Array<Edge> shared;
    Halfedge on_loop = h;
    do {
      if (mesh.face(mesh.opposite(on_loop)) == g && !shared.push_back(mesh.edge(on_loop))) {
        return refusals::no_memory("the edges that two faces share");
      }
      on_loop = mesh.next(on_loop);
    } while (on_loop != h);
    return faces_share_edges(f, g, shared.span());
  }
  for (Halfedge on_loop = after; mesh.next(on_loop) != h; on_loop = mesh.next(on_loop)) {
    for (Halfedge in = mesh.next_on_vertex(on_loop); in != on_loop; in = mesh.next_on_vertex(in)) {
      if (mesh.face(in) == g) return faces_share_vertex(f, g, mesh.to_vertex(in));
    }
  }
  return {};
}

}  // namespace internal

/// Whether remove_edge(e) can be done: else not-an-edge; faces-share-edges or faces-share-vertex,
/// if its two faces have more in common than `e`; edge-without-face, if `e` lies on the boundary
/// and another edge of its face does too; last-edge, of a loop; out-of-memory.
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_remove_edge(const Mesh& mesh, Edge e) {
  if (Result<void> live = check_live(mesh, e); !live) return live;
  const Halfedge h = mesh.edge_halfedge(e);
  if (mesh.is_boundary(e)) {
    return decorator::check_join_face(mesh, mesh.is_boundary(h) ? h : mesh.opposite(h));
  }
  if (Result<void> can = internal::check_join_along(mesh, h, 1); !can) return can;
  return decorator::check_join_face(mesh, h);  // last-edge: all else is known
}

/// Removes an edge; the loops on its two sides become one: that of edge_halfedge(e, 0), with its
/// face, unless the other is a boundary loop. Then the face is gone, and what is left of it belongs
/// to the boundary loop. (CGAL: Euler::join_face; OpenMesh: remove_edge. The drawing is at
/// insert_edge.)
///
/// pre: two faces with nothing else in common, or one that has no other boundary edge
/// attributes: those of the face and the halfedges that stay, stay
/// returns: the joined face; empty if that is a boundary loop
/// cost: O(sum of the valences along one of the faces), on a boundary along both loops
/// inverse: insert_edge(prev(h), prev(opposite(h))), of the halfedge h of e whose loop stays
/// errors: those of check_remove_edge
template <EditableSurface Mesh>
[[nodiscard]] Result<Face> remove_edge(Mesh& mesh, Edge e) {
  if (Result<void> can = check_remove_edge(mesh, e); !can) return can;
  const Halfedge h = mesh.edge_halfedge(e);
  const bool is_turned = mesh.is_boundary(mesh.opposite(h));
  Result<Halfedge> joined = decorator::join_face(mesh, is_turned ? mesh.opposite(h) : h);
  if (!joined) return std::move(joined).failure();
  return mesh.face(joined.value());
}

}  // namespace halfedge::operations
