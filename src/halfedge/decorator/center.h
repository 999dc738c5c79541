#pragma once

#include <halfedge/decorator/edit.h>
#include <halfedge/geometry/loop.h>
#include <halfedge/sentence.h>

namespace halfedge::decorator {

namespace internal {

/// The mean of the corners of the loop of `h`.
template <HasPositions Mesh>
[[nodiscard]] Point centroid(const Mesh& mesh, Halfedge h) {
  return geometry::internal::rounded(geometry::internal::centroid(mesh, h));
}

/// A vertex behind the last one, at the mean of three. pre: there is room for it
template <class Mesh>
[[nodiscard]] Vertex append_vertex_between(Mesh& mesh,
                                           [[maybe_unused]] const Vertex (&corners)[3]) {
  if constexpr (HasPositions<Mesh>) {
    const Point p = mesh.position(corners[0]);
    const Point q = mesh.position(corners[1]);
    const Point r = mesh.position(corners[2]);
    const auto mean = [](float x, float y, float z) {
      return float((double{x} + double{y} + double{z}) / 3);
    };
    return mesh.append_vertex({mean(p.x, q.x, r.x), mean(p.y, q.y, r.y), mean(p.z, q.z, r.z)});
  } else {
    return mesh.append_vertex();
  }
}

/// The edges and faces that an operation adds, behind all others.
template <class Mesh>
class AppendedItems {
 public:
  AppendedItems(Mesh& mesh, Index edges, Index faces)
      : writer_(mesh.unnoted_writer()), edge_(mesh.append_edges(edges)) {
    if constexpr (StoresFaces<Mesh>) face_ = mesh.append_faces(faces);
  }
  [[nodiscard]] const auto& writer() const { return writer_; }
  [[nodiscard]] Halfedge new_edge(Vertex from, Vertex to) {
    const Halfedge h = Mesh::edge_halfedge(edge_);
    edge_ = Edge(edge_.index() + 1);
    writer_.set_to_vertex(h, to);
    writer_.set_to_vertex(Mesh::opposite(h), from);
    return h;
  }
  [[nodiscard]] Face new_face(Halfedge h) {
    const Face f = face_;
    if constexpr (StoresFaces<Mesh>) {
      face_ = Face(f.index() + 1);
      writer_.set_face_halfedge(f, h);
    }
    return f;
  }

 private:
  typename Mesh::UnnotedWriter writer_;
  Edge edge_;
  Face face_;
};

/// The same, wherever there are slots for them.
template <class Mesh>
class RecycledItems {
 public:
  explicit RecycledItems(Mesh& mesh) : mesh_(mesh), writer_(mesh.writer()) {}
  [[nodiscard]] const auto& writer() const { return writer_; }
  [[nodiscard]] Halfedge new_edge(Vertex from, Vertex to) {
    return mesh_.new_unlinked_edge(from, to);
  }
  [[nodiscard]] Face new_face(Halfedge h) { return new_face_like(mesh_, h, {}); }

 private:
  Mesh& mesh_;
  typename Mesh::Writer writer_;
};

/// Joins `c`, which is isolated, to the corners of the loop of `h`; see create_center_vertex.
template <class Mesh, class Items>
[[nodiscard]] Halfedge fan_out(Mesh& mesh, Halfedge h, Vertex c, Items&& items) {
  const Face f = face_of(mesh, h);
  const auto of_sides = mesh.unnoted_writer();
  const auto& of_new = items.writer();
  const Halfedge k = items.new_edge(mesh.to_vertex(h), c);
  const bool has_attributes = mesh.attributes().has_any();
  if (has_attributes) {
    mesh.average_attributes(k, [&](const auto& add) {
      for (const Halfedge on_loop : mesh.loop_ccw(h)) add(on_loop.index());
    });
    mesh.copy_corner(mesh.opposite(k), h);
  }
  set_anchor(mesh, c, mesh.opposite(k));

  // A triangle consists of a side, the spoke from its end to c, and the one from its beginning,
  // back. The last one is that of h.
  const auto make_triangle = [&](Halfedge side, Halfedge spoke, Halfedge back, Face triangle) {
    mesh.note_loop_links(side);
    of_sides.set_next(side, spoke);
    of_new.set_prev(spoke, side);
    of_new.link(spoke, back);
    of_new.set_next(back, side);
    of_sides.set_prev(side, back);
    of_sides.set_face(side, triangle);
    for (const Halfedge corner : {spoke, back}) of_new.set_face(corner, triangle);
  };
  Halfedge before = k;
  for (Halfedge side = mesh.next(h); side != h;) {
    const Halfedge following = mesh.next(side);
    const Halfedge spoke = items.new_edge(mesh.to_vertex(side), c);
    const Face triangle = items.new_face(side);
    if (has_attributes) {
      mesh.copy_corner(spoke, k);
      mesh.copy_corner(mesh.opposite(spoke), side);
      if (f.valid()) mesh.copy_attributes(triangle, f);
    }
    make_triangle(side, spoke, mesh.opposite(before), triangle);
    before = spoke;
    side = following;
  }
  make_triangle(h, k, mesh.opposite(before), f);
  mend_face(mesh, f, h);
  return k;
}

/// Whether new items go behind all others, in room that is there, and have no attributes: the usual
/// case, where a step has little to decide.
template <class Mesh>
[[nodiscard]] bool can_just_append(Mesh& mesh, Index vertices, Index edges, Index faces) {
  const auto fit = [](std::size_t slots, std::size_t capacity) { return slots <= capacity; };
  const Index deleted =
      mesh.free_vertices().count | mesh.free_edges().count | mesh.free_faces().count;
  return !mesh.attributes().has_any() && deleted == 0 &&
         fit(std::size_t{mesh.vertex_slots()} + vertices, vertex_capacity(mesh)) &&
         fit(mesh.halfedge_slots() + 2 * std::size_t{edges}, mesh.capacity(ItemKind::kHalfedge)) &&
         fit(std::size_t{mesh.face_slots()} + faces, mesh.links().face_halfedge.capacity());
}

/// add_center_vertex for a triangle, written out: half of the instructions, so that a processor
/// which waits for memory sees twice as far ahead. pre: can_just_append(mesh, 1, 3, 2)
template <class Mesh>
[[nodiscard]] Halfedge add_center_vertex_to_triangle(Mesh& mesh, const Halfedge (&sides)[3]) {
  const Vertex corners[3] = {mesh.to_vertex(sides[0]), mesh.to_vertex(sides[1]),
                             mesh.to_vertex(sides[2])};
  const Face f = mesh.face(sides[0]);
  const Vertex c = append_vertex_between(mesh, corners);
  const Halfedge to_c = Mesh::edge_halfedge(mesh.append_edges(3));
  const Halfedge spokes[3] = {to_c, Halfedge(to_c.index() + 2), Halfedge(to_c.index() + 4)};
  const Face added = mesh.append_faces(2);
  const Face faces[3] = {f, added, Face(added.index() + 1)};
  for (const Halfedge side : sides) mesh.note_loop_links(side);
  const auto writer = mesh.unnoted_writer();
  for (const int i : {0, 1, 2}) {
    const Halfedge spoke = spokes[i];
    const Halfedge back = Mesh::opposite(spokes[(i + 2) % 3]);
    writer.set_to_vertex(spoke, c);
    writer.set_to_vertex(Mesh::opposite(spoke), corners[i]);
    writer.link(sides[i], spoke);
    writer.link(spoke, back);
    writer.link(back, sides[i]);
    for (const Halfedge h : {sides[i], spoke, back}) writer.set_face(h, faces[i]);
    if (i > 0) writer.set_face_halfedge(faces[i], sides[i]);
  }
  writer.set_vertex_halfedge(c, Mesh::opposite(to_c));
  mend_face(mesh, f, sides[0]);
  return to_c;
}

/// create_center_vertex, all checks done.
template <class Mesh>
[[nodiscard]] Result<Halfedge> add_center_vertex(Mesh& mesh, Halfedge h) {
  if constexpr (StoresSurface<Mesh>) {
    const Halfedge second = mesh.next(h);
    fetch_links(mesh, second);
    const Halfedge sides[3] = {h, second, mesh.next(second)};
    fetch_links(mesh, sides[2]);
    const bool is_triangle = sides[1] != h && mesh.next(sides[2]) == h;
    if (is_triangle && can_just_append(mesh, 1, 3, 2)) {
      return add_center_vertex_to_triangle(mesh, sides);
    }
  }
  Index degree = 0;
  for ([[maybe_unused]] const Halfedge on_loop : mesh.loop_ccw(h)) ++degree;
  if (!make_room(mesh, 1, degree, degree - 1)) return no_memory("a vertex, its edges and faces");
  const Vertex c = mesh.new_vertex();
  if constexpr (HasPositions<Mesh>) mesh.set_position(c, centroid(mesh, h));
  mesh.average_attributes(c, [&](const auto& add) {
    for (const Halfedge on_loop : mesh.loop_ccw(h)) add(mesh.to_vertex(on_loop).index());
  });
  if (mesh.free_edges().count > 0 || mesh.free_faces().count > 0) {
    return fan_out(mesh, h, c, RecycledItems(mesh));
  }
  return fan_out(mesh, h, c, AppendedItems(mesh, degree, degree - 1));
}

}  // namespace internal

/// Whether create_center_vertex(h) can be done: else not-a-halfedge, boundary-halfedge.
template <Editable Mesh>
[[nodiscard]] Result<void> check_create_center_vertex(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  if (is_boundary(mesh, h)) return on_boundary(h);
  return {};
}

/// A new vertex in the face of `h`, joined to each of its n corners: n triangles. (CGAL:
/// create_center_vertex)
///
///     * ---h---> *        * ---h---> *
///     |          |        | `.    .k |
///     |          |   =>   |    `c´   |      next(h) == k
///     |          |        | .´    `. |
///     * <------- *        * <------- *
///
/// pre: h has a face
/// returns: k, from to_vertex(h) to the new vertex c, which is at the mean of the corners. The
///          triangle of h and k keeps the face, n - 1 faces are new and have its attributes. The
///          attributes of c and of its corners are means too.
/// cost: O(degree). inverse: erase_center_vertex(k), which returns h
/// errors: those of check_create_center_vertex, out-of-memory
template <Editable Mesh>
[[nodiscard]] Result<Halfedge> create_center_vertex(Mesh& mesh, Halfedge h) {
  if (Result<void> can = check_create_center_vertex(mesh, h); !can) return can;
  return internal::add_center_vertex(mesh, h);
}

/// Whether erase_center_vertex(h) can be done: else not-a-halfedge; boundary-vertex; loop-edge;
/// repeated-vertex, if one loop passes to_vertex(h) more than once; last-edge, if no edge but those
/// of to_vertex(h) would be left for the face.
template <Editable Mesh>
[[nodiscard]] Result<void> check_erase_center_vertex(const Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> live = check_live(mesh, h); !live) return live;
  const Vertex c = mesh.to_vertex(h);
  bool has_rim = false;
  Halfedge in = h;
  do {
    if (is_boundary(mesh, in)) {
      return refusal(
          "boundary-vertex",
          sentence::of("{} lies on a boundary: {} has no face, expected a face at every corner", c,
                       in),
          {.vertices = {c.index()}, .halfedges = {in.index()}});
    }
    if (mesh.from_vertex(in) == c) return is_loop_edge(in, c);
    for (Halfedge on_loop = mesh.next(in); on_loop != in; on_loop = mesh.next(on_loop)) {
      if (mesh.to_vertex(on_loop) == c) {
        return refusal("repeated-vertex",
                       sentence::of("{} is at two corners of one face, where {} and {} lead, "
                                    "expected one corner in each face",
                                    c, in, on_loop),
                       {.vertices = {c.index()}, .halfedges = {in.index(), on_loop.index()}});
      }
      has_rim = has_rim || mesh.from_vertex(on_loop) != c;
    }
    in = mesh.next_on_vertex(in);
  } while (in != h);
  if (!has_rim) return last_edge(h, sentence::of("{} and the joined face", mesh.from_vertex(h)));
  return {};
}

/// Removes the vertex to_vertex(h) with its edges; the faces around it become one, that of `h`.
/// (CGAL: erase_center_vertex; the drawing is at create_center_vertex)
///
/// pre: every corner at the vertex has a face, all of them different
/// returns: the halfedge before the corner where h was: prev(h), if that stays
/// cost: O(sum of the degrees of the faces); where prev isn't stored, O(valence^2) besides
/// inverse: create_center_vertex(returned), if the faces were triangles
/// errors: those of check_erase_center_vertex
template <Editable Mesh>
requires DeletesFaces<Mesh> && DeletesVertices<Mesh>
[[nodiscard]] Result<Halfedge> erase_center_vertex(Mesh& mesh, Halfedge h) {
  using namespace internal;
  if (Result<void> can = check_erase_center_vertex(mesh, h); !can) return can;
  const Vertex c = mesh.to_vertex(h);
  const Face f = face_of(mesh, h);
  Halfedge returned = mesh.prev(h);
  while (mesh.from_vertex(returned) == c) returned = mesh.prev(mesh.opposite(returned));

  for (Halfedge spoke = mesh.next_on_vertex(h); spoke != h;) {
    const Halfedge following = mesh.next_on_vertex(spoke);
    release_face(mesh, face_of(mesh, spoke));
    erase_edge(mesh, spoke);
    spoke = following;
  }
  erase_edge(mesh, h);
  mesh.release(c);
  set_face_of_loop(mesh, returned, f);
  if constexpr (StoresFaceHalfedges<Mesh>) {
    if (mesh.is_deleted(mesh.face_halfedge(f))) mesh.set_face_halfedge(f, returned);
  }
  return returned;
}

}  // namespace halfedge::decorator
