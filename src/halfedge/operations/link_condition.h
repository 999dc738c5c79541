#pragma once

#include <halfedge/inlining.h>
#include <halfedge/operations/requirements.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

/// Whether an edge can be contracted.
namespace halfedge::operations {

namespace internal {

/// The halfedges at an edge that may be contracted. A side is a triangle, a larger face, or nothing
/// (the boundary); its apex is the third corner of a triangle, else empty.
///
///             b                    h leads from a to b, and a disappears
///           ´ | `
///     left ´  |  ` right
///         `   h   ´
///           ` | ´
///             a
struct CollapseSite {
  Halfedge h, o, after_h, after_o;
  Vertex a, b, left, right;
  bool left_is_triangle = false;
  bool right_is_triangle = false;

  template <class Mesh>
  HALFEDGE_NOINLINE_IN_WASM CollapseSite(const Mesh& mesh, Halfedge collapsed)
      : h(collapsed),
        o(mesh.opposite(h)),
        after_h(mesh.next(h)),
        after_o(mesh.next(o)),
        a(mesh.to_vertex(o)),
        b(mesh.to_vertex(h)),
        left_is_triangle(!mesh.is_boundary(h) && mesh.next(mesh.next(after_h)) == h),
        right_is_triangle(!mesh.is_boundary(o) && mesh.next(mesh.next(after_o)) == o) {
    if (left_is_triangle) left = mesh.to_vertex(after_h);
    if (right_is_triangle) right = mesh.to_vertex(after_o);
  }
};

/// Whether the vertex `v` is a corner of the loop of `h`.
template <class Mesh>
[[nodiscard]] bool is_on_loop(const Mesh& mesh, Halfedge h, Vertex v) {
  Halfedge on_loop = h;
  do {
    if (mesh.to_vertex(on_loop) == v) return true;
    on_loop = mesh.next(on_loop);
  } while (on_loop != h);
  return false;
}

/// find_common_neighbour, by a lap around each neighbour of a. Nothing if one around b is shorter
/// than all of these.
template <class Mesh>
[[nodiscard]] std::optional<Halfedge> find_near_few(const Mesh& mesh, const CollapseSite& site) {
  Halfedge around_b = site.o;
  for (Halfedge of_a = mesh.rotate_cw(site.h); of_a != site.h; of_a = mesh.rotate_cw(of_a)) {
    const Vertex v = mesh.to_vertex(of_a);
    if (v == site.left || v == site.right) continue;
    const Halfedge o = mesh.opposite(of_a);
    for (Halfedge g = mesh.rotate_cw(o); g != o; g = mesh.rotate_cw(g)) {
      if (mesh.to_vertex(g) == site.b) return mesh.opposite(g);
      around_b = mesh.rotate_cw(around_b);
      if (around_b == site.o) return {};
    }
  }
  return Halfedge{};
}

/// A halfedge from b to a common neighbour of a and b that is not an apex, or empty. The neighbours
/// of b are looked for in a set of 64 bits first, so few of them need a walk around a. Where b has
/// many, as it may after many collapses, those of a are asked.
template <class Mesh>
[[nodiscard]] Halfedge find_common_neighbour(const Mesh& mesh, const CollapseSite& site) {
  constexpr int kMany = 64;
  const auto bit = [](Vertex v) { return std::uint64_t{1} << (v.index() % 64); };
  const auto is_apex = [&](Vertex v) { return v == site.left || v == site.right; };
  std::uint64_t around_a = 0;
  for (Halfedge g = mesh.rotate_cw(site.h); g != site.h; g = mesh.rotate_cw(g)) {
    if (const Vertex v = mesh.to_vertex(g); !is_apex(v)) around_a |= bit(v);
  }
  if (around_a == 0) return {};
  int seen = 0;
  for (Halfedge g = mesh.rotate_cw(site.o); g != site.o; g = mesh.rotate_cw(g)) {
    if (++seen == kMany) [[unlikely]] {
      if (const std::optional<Halfedge> found = find_near_few(mesh, site)) return *found;
    }
    const Vertex v = mesh.to_vertex(g);
    if ((around_a & bit(v)) == 0 || is_apex(v)) continue;
    for (Halfedge of_a = mesh.rotate_cw(site.h); of_a != site.h; of_a = mesh.rotate_cw(of_a)) {
      if (mesh.to_vertex(of_a) == v) return g;
    }
  }
  return {};
}

/// A face that has both a and b as corners, and not the edge between them; or empty.
template <class Mesh>
[[nodiscard]] Face find_face_at_both_ends(const Mesh& mesh, const CollapseSite& site) {
  for (Halfedge g = mesh.rotate_cw(site.h); g != site.h; g = mesh.rotate_cw(g)) {
    if (mesh.is_boundary(g) || g == site.after_o) continue;
    if (mesh.next(mesh.next(mesh.next(g))) == g) continue;  // else b would be a common neighbour
    if (is_on_loop(mesh, g, site.b)) return mesh.face(g);
  }
  return {};
}

/// Whether find_pillow may find something: b would have valence two then, which is rare.
template <class Mesh>
[[nodiscard]] bool can_leave_pillow(const Mesh& mesh, const CollapseSite& site) {
  const auto has_valence_below_four = [&](Halfedge leaving) {
    const Halfedge third = mesh.rotate_cw(mesh.rotate_cw(leaving));
    return third == leaving || mesh.rotate_cw(third) == leaving;
  };
  return has_valence_below_four(site.o) && has_valence_below_four(site.h);
}

/// The two faces of which a closed component would consist, glued along all their edges; else
/// empty.
/// pre: can_leave_pillow
template <class Mesh>
[[nodiscard]] std::pair<Face, Face> find_pillow(const Mesh& mesh, const CollapseSite& site) {
  // The faces at a and b that stay, each of them once.
  Face found[2];
  std::size_t count = 0;
  Halfedge in_first;
  for (const Halfedge start : {site.h, site.o}) {
    Halfedge g = start;
    do {
      const Face f = mesh.face(g);
      if (!f.valid()) return {};
      const bool vanishes = (site.left_is_triangle && f == mesh.face(site.h)) ||
                            (site.right_is_triangle && f == mesh.face(site.o));
      if (!vanishes && f != found[0] && f != found[1]) {
        if (count == 2) return {};
        if (count == 0) in_first = g;
        found[count++] = f;
      }
      g = mesh.rotate_cw(g);
    } while (g != start);
  }
  const auto is_end = [&](Vertex v) { return v == site.a || v == site.b; };
  Halfedge g = in_first;
  do {
    const Halfedge across = mesh.opposite(g);
    if (!is_end(mesh.to_vertex(g)) && !is_end(mesh.to_vertex(across)) &&
        mesh.face(across) != found[1]) {
      return {};
    }
    g = mesh.next(g);
  } while (g != in_first);
  return {found[0], found[1]};
}

/// A loop edge among the edge and the triangles beside it, of a degenerate complex; or empty.
template <class Mesh>
[[nodiscard]] Halfedge find_loop_edge(const Mesh& mesh, const CollapseSite& site) {
  if (site.a == site.b) return site.h;
  if (site.left == site.b) return site.after_h;
  if (site.left == site.a) return mesh.next(site.after_h);
  if (site.right == site.a) return site.after_o;
  if (site.right == site.b) return mesh.next(site.after_o);
  return {};
}

/// What makes a collapse impossible; the items say what of, where there are such.
struct CollapseObstacle {
  enum class Kind : std::uint8_t {
    kNone,
    kLoopEdge,        // `side` leads back to where it begins
    kSameLoop,        // one face on both sides
    kPinches,         // an interior edge between two boundary vertices
    kSameApex,        // two triangles with the same corners
    kBareEdge,        // the triangle of `side` has no face beyond its other edges
    kRepeatedVertex,  // `face` has both ends as corners
    kNeighbour,       // `side` leads to a common neighbour
    kPillow,          // `face` and `other_face` would have the same corners
  };
  Kind kind = Kind::kNone;
  Halfedge side = {};
  Face face = {};
  Face other_face = {};
};

}  // namespace internal

/// What a collapse may leave of a closed component.
enum class LinkCondition : std::uint8_t {
  kStrict,     ///< the link condition: no two faces on the same corners, glued along all edges
  kPermissive  ///< two such faces too, as of a tetrahedron (OpenMesh allows them)
};

namespace internal {

template <class Mesh>
[[nodiscard]] CollapseObstacle find_collapse_obstacle(const Mesh& mesh, const CollapseSite& site,
                                                      LinkCondition condition) {
  using Kind = CollapseObstacle::Kind;
  if (mesh.face(site.h) == mesh.face(site.o)) return {Kind::kSameLoop};
  if (const Halfedge g = find_loop_edge(mesh, site); g.valid()) return {Kind::kLoopEdge, g};
  const bool is_interior = !mesh.is_boundary(site.h) && !mesh.is_boundary(site.o);
  if (is_interior && mesh.is_boundary(site.a) && mesh.is_boundary(site.b)) return {Kind::kPinches};
  if (site.left.valid() && site.left == site.right) return {Kind::kSameApex};
  const auto has_bare_edges = [&](Halfedge after) {
    return mesh.is_boundary(mesh.opposite(after)) &&
           mesh.is_boundary(mesh.opposite(mesh.next(after)));
  };
  if (site.left_is_triangle && has_bare_edges(site.after_h)) return {Kind::kBareEdge, site.h};
  if (site.right_is_triangle && has_bare_edges(site.after_o)) return {Kind::kBareEdge, site.o};
  if (const Halfedge g = find_common_neighbour(mesh, site); g.valid()) {
    return {Kind::kNeighbour, g};
  }
  if (const Face f = find_face_at_both_ends(mesh, site); f.valid()) {
    return {Kind::kRepeatedVertex, {}, f};
  }
  if (condition == LinkCondition::kStrict && can_leave_pillow(mesh, site)) {
    const auto [f, g] = find_pillow(mesh, site);
    if (f.valid()) return {Kind::kPillow, {}, f, g};
  }
  return {};
}

template <class Mesh>
[[nodiscard]] Failure explain(const Mesh& mesh, const CollapseSite& site,
                              const CollapseObstacle& obstacle) {
  using Kind = CollapseObstacle::Kind;
  const Edge e = mesh.edge(site.h);
  switch (obstacle.kind) {
    case Kind::kLoopEdge:
      return refusals::is_loop_edge(obstacle.side, mesh.to_vertex(obstacle.side));
    case Kind::kSameLoop:
      return refusals::in_same_loop(site.h, site.o);
    case Kind::kPinches:
      return joins_boundary_vertices(e, site.a, site.b);
    case Kind::kSameApex:
      return same_vertex(e, site.left);
    case Kind::kBareEdge: {
      const Halfedge after = mesh.next(obstacle.side);
      return would_leave_bare_edge(mesh.face(obstacle.side), mesh.edge(after),
                                   mesh.edge(mesh.next(after)));
    }
    case Kind::kRepeatedVertex:
      return has_both_ends(obstacle.face, e, site.a, site.b);
    case Kind::kNeighbour: {
      const Vertex v = mesh.to_vertex(obstacle.side);
      return is_common_neighbour(v, e, mesh.find_edge(site.a, v), mesh.edge(obstacle.side));
    }
    case Kind::kPillow:
      return would_leave_pillow(e, obstacle.face, obstacle.other_face);
    case Kind::kNone:
      break;
  }
  return {};
}

/// check_collapse of a live halfedge.
template <class Mesh>
[[nodiscard]] Result<void> check_site(const Mesh& mesh, const CollapseSite& site,
                                      LinkCondition condition) {
  const CollapseObstacle obstacle = find_collapse_obstacle(mesh, site, condition);
  if (obstacle.kind == CollapseObstacle::Kind::kNone) return {};
  return explain(mesh, site, obstacle);
}

}  // namespace internal

/// Whether collapse(h) can be done, without a sentence: allocates nothing. (OpenMesh:
/// is_collapse_ok; CGAL: does_satisfy_link_condition)
///
/// pre: h is live. cost: as check_collapse
template <EditableSurface Mesh>
[[nodiscard]] bool is_collapse_ok(const Mesh& mesh, Halfedge h,
                                  LinkCondition condition = LinkCondition::kStrict) {
  return internal::find_collapse_obstacle(mesh, internal::CollapseSite(mesh, h), condition).kind ==
         internal::CollapseObstacle::Kind::kNone;
}

/// Whether collapse(h) can be done. With a = from_vertex(h) and b = to_vertex(h), else:
///
///   not-a-halfedge
///   same-loop          one face lies on both sides
///   loop-edge          the edge, or another one of a triangle beside it, leads back to where it
///                      begins
///   boundary-vertices  a and b lie on the boundary, their edge doesn't: b would be pinched
///   same-vertex        the triangles on both sides have the same third corner
///   edge-without-face  a triangle on one side is on the boundary with its two other edges, which
///                      would become one
///   common-neighbour   a and b have a neighbour in common that isn't the third corner of a
///                      triangle beside the edge: it would be joined to b twice
///   repeated-vertex    a and b are corners of a face that doesn't have their edge
///   leaves-pillow      two faces would have the same corners and all their edges in common;
///                      allowed by LinkCondition::kPermissive
///
/// The witness has the items named: that neighbour with its two edges, those faces. For triangle
/// meshes these are the link condition (Dey et al., Topology preserving edge contraction, 1999).
///
/// cost: O(valences of both ends, degrees of the faces at a) while the valences are in the tens;
///       beyond, the valences of the neighbours of a if that is less than b's, else up to
///       O(product of the valences)
template <EditableSurface Mesh>
[[nodiscard]] Result<void> check_collapse(const Mesh& mesh, Halfedge h,
                                          LinkCondition condition = LinkCondition::kStrict) {
  if (Result<void> live = check_live(mesh, h); !live) return live;
  return internal::check_site(mesh, internal::CollapseSite(mesh, h), condition);
}

}  // namespace halfedge::operations
