#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/convert.h>
#include <halfedge/mesh.h>
#include <halfedge/progress.h>
#include <halfedge/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halfedge {

/// What a repair found and mended. `name_of` spells them as the strict builder does.
enum class RepairCode : std::uint8_t {
  kNonFinitePosition,    // a vertex was dropped, and the faces that used it
  kIndexOutOfRange,      // a face was dropped
  kDegreeBelowThree,     // a face was dropped
  kRepeatedVertex,       // a face was simplified, or dropped if nothing was left of it
  kCoincidentPosition,   // vertices were welded
  kDuplicateFace,        // a face was dropped, another one like it kept
  kEdgeWithManyFaces,    // an edge was doubled, so that each copy has one face or two
  kOppositeOrientation,  // a face was turned over
  kNonOrientable,        // an edge was cut: no choice of sides makes its two faces agree
  kNeighboursCut,        // an edge of two faces was cut, for copies of another edge to differ
  kPinchedVertex,        // a vertex was doubled, so that each copy has one closed fan
  kIsolatedVertex,       // a vertex has no face
};
inline constexpr std::size_t kRepairCodeCount = 12;

/// "non-finite-position", ...
[[nodiscard]] const char* name_of(RepairCode code);

/// How to repair.
struct RepairOptions {
  /// Joins vertices. 0: those at the same position (0 and -0 are the same). Above: those closer
  /// than this, so that any two that are joined are closer than this to each other. Where that
  /// leaves a choice, because a chain of vertices is longer than it, the chain is cut between
  /// groups that begin at their smallest position by x, y and z; a group takes the position of that
  /// one. Left out, vertices are kept apart.
  std::optional<double> weld = std::nullopt;
  /// Leaves out the vertices without faces. Otherwise they are kept, but for those without a finite
  /// position.
  bool drop_isolated = false;
  /// Is told of the steps of a repair, if one is necessary, and of the build, and may cancel them
  /// (code cancelled).
  Progress progress = {};
};

/// What has happened to a face of the input.
struct FaceVerdict {
  Index face = kNone;
  /// Whether it is a face of the mesh.
  bool kept = false;
  /// The reasons: bit 1 << code for each.
  std::uint16_t codes = 0;

  [[nodiscard]] bool has(RepairCode code) const {
    return (std::uint32_t{codes} >> std::uint32_t(code) & 1U) != 0;
  }
};

/// What a repair has done, or why it failed.
struct RepairReport {
  /// One sentence each, with items of the input as witness; at most kMaxListed of each code.
  std::vector<Error> problems;
  static constexpr std::size_t kMaxListed = 100;

  /// How many there are of each code, listed or not: faces, edges or vertices, see RepairCode.
  std::array<std::size_t, kRepairCodeCount> counts = {};
  /// Faces that were touched, in order. All others are as in the input.
  Array<FaceVerdict> verdicts;

  /// By vertex of the input: its first vertex in the mesh, or kNone.
  Array<Index> vertex_map;
  /// By vertex of the mesh: the vertex of the input whose position it has. Those that were made by
  /// doubling come last.
  Array<Index> vertex_origin;
  /// By face of the input: the face of the mesh, or kNone.
  Array<Index> face_map;

  /// "3 duplicate faces left out, 12 edges with more than two faces cut."
  std::string summary;

  [[nodiscard]] std::size_t count(RepairCode code) const { return counts[std::size_t(code)]; }
};

/// Makes `mesh` the mesh of these polygons as `build_from_polygons` does, mending what that would
/// refuse; polygons that it accepts give the same mesh. Faces and vertices keep their order.
///
/// - Vertices are welded, if asked for. Faces that can't be are dropped: indices out of range,
///   positions that aren't finite, fewer than three different corners. Where a face comes back to a
///   vertex (a polygon with a hole and a bridge to it), it is kept and the vertex doubled.
/// - Of faces with the same vertices, in either orientation, one is kept; both, where two close a
///   pillow by themselves.
/// - The faces of each component are turned to agree with the majority, or with the outside of a
///   closed component if the votes are equal. A one-sided surface is cut along the fewest edges
///   found.
/// - An edge with more than two faces is doubled: faces are joined that make a closed fan at one of
///   its ends, and after them those that bound the same solid; the rest get boundary edges.
/// - A vertex gets a copy for each fan, where fans can't share it.
///
/// The mesh is valid at level 4. Its shape doesn't depend on the order of the faces, nor on that of
/// the vertices if no two are at the same position.
///
/// False if there is no mesh, with the error in `report.problems`: bad-size, bad-tolerance,
/// too-large, out-of-memory, cancelled. `mesh` is empty then.
///
/// pre: `polygons` doesn't view the arrays of `mesh`
/// cost: O(n) for polygons that need no repair but welding, else O(n log n) and some 80 bytes a
/// corner
[[nodiscard]] bool build_from_soup(Mesh& mesh, const Polygons& polygons,
                                   const RepairOptions& options, RepairReport& report);

/// The same for a mesh type that leaves links out, by way of a full mesh.
template <Storage kStored>
[[nodiscard]] bool build_from_soup(BasicMesh<kStored>& mesh, const Polygons& polygons,
                                   const RepairOptions& options, RepairReport& report) {
  return build_whole(
      mesh, [&](Mesh& whole) { return build_from_soup(whole, polygons, options, report); });
}

}  // namespace halfedge
