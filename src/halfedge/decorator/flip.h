#pragma once

#include <halfedge/decorator/edit.h>
#include <halfedge/sentence.h>

namespace halfedge::decorator {

/// Whether flip_edge(h) can be done: else not-a-halfedge; boundary-halfedge; not-a-triangle;
/// same-loop.
template <Editable Mesh>
[[nodiscard]] Result<void> check_flip_edge(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  for (const Halfedge side : {h, mesh.opposite(h)}) {
    if (is_boundary(mesh, side)) return on_boundary(side);
  }
  for (const Halfedge side : {h, mesh.opposite(h)}) {
    if (mesh.next(side) != side && mesh.next(mesh.next(mesh.next(side))) == side) continue;
    Index degree = 0;
    for ([[maybe_unused]] const Halfedge on_loop : mesh.loop_ccw(side)) ++degree;
    return refusal("not-a-triangle",
                   sentence::of("the face of {} has degree {}, expected 3", side, degree),
                   halfedges_of({side}));
  }
  if (is_one_loop(mesh, h, mesh.opposite(h))) return in_same_loop(h, mesh.opposite(h));
  return {};
}

namespace internal {

/// flip_edge, all checks done.
template <class Mesh>
void turn_edge(Mesh& mesh, Halfedge h) {
  const Halfedge o = mesh.opposite(h);
  const Halfedge h23 = mesh.next(h);
  const Halfedge h30 = mesh.prev(h);
  const Halfedge h01 = mesh.next(o);
  const Halfedge h12 = mesh.prev(o);
  const Vertex v0 = mesh.to_vertex(o);
  const Vertex v1 = mesh.to_vertex(h01);
  const Vertex v2 = mesh.to_vertex(h);
  const Vertex v3 = mesh.to_vertex(h23);
  const Face left = face_of(mesh, h);
  const Face right = face_of(mesh, o);
  mesh.copy_corner(h, h23);
  mesh.copy_corner(o, h01);
  replace_anchor(mesh, v0, h, h01);
  replace_anchor(mesh, v2, o, h23);
  replace_in_face(mesh, left, h23, h);
  replace_in_face(mesh, right, h01, o);
  mesh.set_to_vertex(h, v3);
  mesh.set_to_vertex(o, v1);
  if (mesh.history() != nullptr) [[unlikely]] {
    for (const Halfedge side : {h, h30, h01, o, h12, h23}) mesh.note_loop_links(side);
  }
  const auto writer = mesh.unnoted_writer();
  writer.set_face(h01, left);
  writer.set_face(h23, right);
  const Halfedge loops[2][3] = {{h, h30, h01}, {o, h12, h23}};
  for (const auto& [first, second, third] : loops) {
    writer.link(first, second);
    writer.link(second, third);
    writer.link(third, first);
  }
}

}  // namespace internal

/// Turns the edge of `h` counter-clockwise in the quad of its two triangles. (CGAL: flip_edge)
///
///     3 ------- 2           3 ------- 2
///     |       ´ |           | `       |
///     |   h ´   |     =>    |   ` h   |       h led from 0 to 2, and leads from 1 to 3
///     | ´       |           |       ` |
///     0 ------- 1           0 ------- 1
///
/// As the other operations of this layer it asks for no more than the links do: 1 and 3 may be
/// joined by an edge already, or be the same vertex.
///
/// pre: different triangles on the two sides
/// attributes: the corners at 1 and 3 are divided into two alike, those at 0 and 2 joined
/// returns: h. cost: O(1). inverse: itself three times; twice turns h around
/// errors: those of check_flip_edge
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> flip_edge(Mesh& mesh, Halfedge h) {
  if (Result<void> can = check_flip_edge(mesh, h); !can) return can;
  internal::turn_edge(mesh, h);
  return h;
}

}  // namespace halfedge::decorator
