#pragma once

#include <halfedge/mend/report.h>
#include <halfedge/mend/surface.h>
#include <halfedge/result.h>

#include <cstddef>
#include <limits>

/// Repairs of a mesh that is there already: what `build_from_soup` does for polygons, and more that
/// needs neighbours. (docs/repairs.md tells which to take, and in which order.)
///
/// They are declared for a Surface, which any mesh can be; `mend.h` has them for meshes.
///
/// The contract of each:
/// - It does all that it can, and reports the rest: `Report` says what was done, what not, and why.
/// - What is valid at level 4 of `validate` is so afterwards.
/// - Live items keep their indices; deleted slots are taken by the next new items.
/// - With history on, it can be undone to the last word. `Mesh::end_step` closes the step.
/// - The only error, but where others are named, is out-of-memory: then a part may have been done,
///   of which all this holds. Options are checked before anything is done.
namespace halfedge::mend {

struct StitchOptions {
  /// Vertices closer than this count as one; 0: those at the same position.
  double tolerance = 0;
};

/// Glues boundary edges that lie together, end to end, and run opposite ways: closes cracks, and
/// joins the triangles of a soup. Vertices are joined where their edges are, not where they merely
/// touch; those stay that are reached first, from face to face, with position and attributes.
/// (CGAL: stitch_borders)
///
/// Of more than two edges that lie together those are glued that close a gap at a vertex, and the
/// two that are left of four; others are left (ambiguous-edge). So is what runs the same way
/// (opposite-orientation), and what no valid mesh allows, such as a second edge between two
/// vertices (unstitchable-edge).
///
/// report: edges: those that were glued and stay
/// cost: O(n log n) of n boundary edges, and the valences of the vertices that go
/// errors: bad-tolerance, for one that is negative or no finite number
[[nodiscard]] Result<Report> stitch_boundaries(Surface& surface, const StitchOptions& options);

/// Gives each fan of faces at a pinched vertex a vertex of its own: the one of the anchor keeps the
/// vertex, others get copies, with its position and attributes.
/// (CGAL: duplicate_non_manifold_vertices)
///
/// report: vertices: the copies. cost: O(halfedges)
[[nodiscard]] Result<Report> split_pinched_vertices(Surface& surface);

struct OrientOptions {
  /// Open components too, as if each were closed by a cone from the centre of its area: most of it
  /// faces away from there. Without, they are left.
  bool open = false;
  /// Closed components inside of an odd number of others are cavities, and face inward. Without,
  /// each closed component faces outward, wherever it lies.
  bool nested = false;
};

/// Turns components over so that their faces, counter-clockwise, are seen from outside: the signed
/// volume of each closed component becomes positive, but that of cavities with `nested`. (CGAL:
/// orient; with `nested`, orient_to_bound_a_volume)
///
/// What is open (open-component; not with `open`), or has a volume of next to nothing or none that
/// is finite (flat-component), is left.
///
/// attributes: as operations::reverse
/// report: faces: those that were turned over
/// cost: O(slots), nearly; with `nested` besides, for each component whose box lies in that of
///       another, three times the faces of the other, and up to sixteen times where the two touch
[[nodiscard]] Result<Report> orient_outward(Surface& surface, const OrientOptions& options);

/// A component that is too small by one of these is dropped.
struct DropOptions {
  Index faces = 0;      ///< it has fewer faces
  double area = 0;      ///< its area is a smaller share, 0 to 1, of that of the largest one
  double diagonal = 0;  ///< so is the diagonal of its box
};

/// Deletes components that are too small: the dust of a scan. Isolated vertices stay
/// (operations::delete_isolated_vertices). (CGAL: keep_large_connected_components)
///
/// report: faces: those that were deleted. cost: O(slots), nearly
/// errors: bad-share, for one that is no number from 0 to 1
[[nodiscard]] Result<Report> drop_small_components(Surface& surface, const DropOptions& options);

struct DegenerateOptions {
  /// Edges no longer than this are collapsed, and faces no wider removed. In any case those without
  /// length, and faces so narrow (10^-6 of their length) that rounding may turn them over.
  double tolerance = 0;
};

/// Removes faces without area, and edges without length, so that the surface stays where it is:
/// - a short edge is collapsed, where the link condition allows it and no face turns over;
/// - of a triangle whose corner lies on the opposite side, that side is flipped, where the thinner
///   of the two faces becomes wider; beside a larger face it is removed, so that the corner becomes
///   one of that face; on the boundary the triangle is deleted, unless that pinches a vertex; so is
///   one that has nothing beside it, or only beyond its short edge;
/// - a larger face whose corners lie on a line is cut into triangles, and then so on.
/// (CGAL: remove_degenerate_faces, remove_almost_degenerate_faces)
///
/// What none of this can remove is left (zero-length-edge, degenerate-face): all that is short or
/// thin in the end is reported.
///
/// attributes: as operations::collapse, flip_edge, remove_edge, triangulate
/// report: vertices: those that edges were collapsed into; edges: those that were flipped; faces:
///         those that gained a corner
/// cost: O(slots), and what the operations cost
/// errors: bad-tolerance, for one that is negative or no finite number; corrupt-connectivity, for a
///         mesh that isn't valid at level 4
[[nodiscard]] Result<Report> remove_degenerate_faces(Surface& surface,
                                                     const DegenerateOptions& options);

struct FillOptions {
  /// Boundary loops with more edges are left.
  std::size_t max_edges = std::numeric_limits<std::size_t>::max();
  /// In degrees, between the normals of neighbours: what can only be filled with a sharper fold is
  /// left, such as the outline of a flat sheet. 180 fills it too.
  double max_angle = 160;
};

/// Fills boundary loops with triangles, without new vertices, so that they fold little against
/// each other and the faces around: HolePlan tells how. (CGAL: triangulate_hole)
///
/// Left is what has too many edges (large-hole), what would fold over (folding-hole), and what
/// would join vertices that are joined already, or has fewer than three edges (unfillable-hole).
/// A loop that was left is planned again where a triangle beside it joins two of its vertices.
///
/// attributes: new faces and edges have the defaults; corners what the boundary halfedges had
/// report: faces: the new ones
/// cost: of a loop of n edges O(n^3) up to 200, above about O(n log n) and the valences
/// errors: bad-angle, for one that is no number from 0 to 180
[[nodiscard]] Result<Report> fill_holes(Surface& surface, const FillOptions& options);

}  // namespace halfedge::mend
