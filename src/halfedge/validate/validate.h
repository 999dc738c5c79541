#pragma once

#include <halfedge/connectivity/convert.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfedge {

/// How bad a problem is. Only an error makes a mesh invalid.
enum class Severity : std::uint8_t { kError, kWarning, kInfo };

/// "error", "warning", "info".
[[nodiscard]] constexpr const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kInfo:
      return "info";
  }
  return "problem";
}

/// One thing that is wrong with one item.
struct Problem {
  /// Stable, in kebab-case, one of those listed at `validate`; never freed.
  std::string_view code;
  Severity severity = Severity::kError;
  /// kMesh, with an index of kNone, where no single item is to blame.
  ItemKind kind = ItemKind::kMesh;
  Index index = kNone;
  /// One sentence that names the item, its value and what was expected.
  std::string message;
};

/// The highest level of `validate` that is about links.
inline constexpr int kMaxValidationLevel = 4;
/// Beyond it: all levels, and where the vertices lie.
inline constexpr int kGeometryLevel = 5;

/// So many problems of one code are listed; one more then says how many are left out, so that a
/// mesh of a million broken faces makes no gigabyte of sentences.
inline constexpr std::size_t kMaxProblemsPerCode = 1000;

/// What `validate` says when there is no memory to check anything.
[[nodiscard]] std::vector<Problem> not_validated();

template <class Reduced, class Whole>
[[nodiscard]] std::vector<Problem> validate_copy(const Reduced& mesh, int level);

/// Checks the invariants of a mesh, all those of `level` and below. An empty list means valid.
///
/// The levels are those of CGAL's is_valid, the checks go further:
///
/// 0 | array-size               the four halfedge arrays are equally long, an even number, as many
///   |                          as can be addressed; positions are three floats a vertex slot.
///   |                          opposite(h) = h ^ 1 is then an involution without fixed points (1).
///   | free-list                each chain of deleted slots ends, and holds all deleted slots
///   | half-deleted-edge        the links of an edge are all deleted or none is
///   | empty-link               next, prev, to-vertex and the halfedge of a face are never empty
///   | index-out-of-range       links lead to slots that exist
///   | deleted-reference        no live item refers to a deleted one (7)
///   | next-prev-mismatch       next and prev are inverse permutations of the live halfedges (1)
///   | missing-anchor           a vertex that halfedges leave has an anchor
///   | anchor-elsewhere         from(anchor(v)) == v (4)
///   | face-halfedge-elsewhere  face(face_halfedge(f)) == f (3)
/// 1 | to-from-mismatch         to(h) == from(next(h)) (2)
///   | face-mismatch            face(h) == face(next(h)) (3)
/// 2 | unreachable-halfedge     every halfedge that leaves v is reached by rotating from its
///   |                          anchor: the orbits of the vertices add up to all halfedges (6)
/// 3 | face-with-many-loops     a face has one loop, so that face loops and boundary loops add up
///   |                          to all halfedges (3)
///   | interior-anchor          the anchor of a boundary vertex is a boundary halfedge (5)
///   | edge-without-face        an edge has a face on at least one side
/// 4 | degree-below-three       a face has three corners or more
///   | repeated-vertex          the corners of a face are different vertices
///   | duplicate-halfedge       at most one halfedge leads from one vertex to another
///   | same-face-twice          the two sides of an edge are different faces
///   | pinched-vertex           warning: the faces at a vertex form one fan
///   | isolated-vertex          information: a vertex has an edge
///   | out-of-memory            there was memory for the checks; those left out are named
/// 5 | non-finite-position      the coordinates of a vertex are finite numbers
///   | zero-length-edge         warning: the ends of an edge lie apart
///   | degenerate-face          warning: a face is wider than 10^-6 of its length, and has an area;
///   |                          told of the edge alone, where one of a triangle has no length
///   | coincident-vertices      warning: what lies in one place is joined by edges without length
///
/// Numbers in brackets are the invariants listed at `Connectivity`. Levels 0 to 3 accept the
/// degenerate complexes (one loop edge, one segment); level 4 is for polygon meshes.
///
/// The arrays may hold anything, of any size: no index is used before it is checked, no walk is
/// begun before it is known to end. So, within level 0, nothing follows a link that is out of
/// range, and levels 2 to 4, which walk around vertices and faces, are checked only where levels 0
/// and 1 find no error. So is level 5, kGeometryLevel, for meshes that have positions; others have
/// nothing to check there.
///
/// pre: 0 <= level <= kGeometryLevel
/// cost: O(slots), at most 4 bytes a vertex and 1 byte a halfedge of scratch memory; level 5 some
/// 60 bytes a vertex
[[nodiscard]] std::vector<Problem> validate(const Connectivity& mesh,
                                            int level = kMaxValidationLevel);
[[nodiscard]] std::vector<Problem> validate(const Mesh& mesh, int level = kMaxValidationLevel);
/// A copy is made only if prev isn't stored.
[[nodiscard]] std::vector<Problem> validate(const BasicMesh<kPrevAtRunTime>& mesh,
                                            int level = kMaxValidationLevel);

/// The same of a mesh type that leaves links out: they are derived in a copy (see `convert`), and
/// the copy is checked. Where no link knows of faces, each loop counts as a face.
template <Storage kStored>
[[nodiscard]] std::vector<Problem> validate(const BasicConnectivity<kStored>& mesh,
                                            int level = kMaxValidationLevel) {
  return validate_copy<BasicConnectivity<kStored>, Connectivity>(mesh, level);
}
template <Storage kStored>
[[nodiscard]] std::vector<Problem> validate(const BasicMesh<kStored>& mesh,
                                            int level = kMaxValidationLevel) {
  return validate_copy<BasicMesh<kStored>, Mesh>(mesh, level);
}

/// Whether one of them is an error, not only a warning or information.
[[nodiscard]] bool has_errors(std::span<const Problem> problems);

template <class Reduced, class Whole>
std::vector<Problem> validate_copy(const Reduced& mesh, int level) {
  Reduced copy;
  Whole whole;
  if (!copy.assign(mesh) || !convert(std::move(copy), whole)) return not_validated();
  return validate(whole, level);
}

}  // namespace halfedge
