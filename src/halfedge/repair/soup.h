#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>
#include <halfedge/repair/log.h>
#include <halfedge/repair/weld.h>

#include <cstddef>
#include <cstdint>
#include <span>

/// The steps of a repair, each on what the one before has left. They return false when memory is
/// exhausted.
namespace halfedge::repair {

/// Faces over them, in the order of the input.
struct Faces {
  Array<Index> first;    // of the corners of each face, and the end
  Array<Index> corners;  // vertices
  Array<Index> source;   // the face of the input
  /// By corner: the face comes back to this vertex elsewhere. Empty if none does.
  Array<bool> doubled;

  [[nodiscard]] std::size_t size() const { return source.size(); }
  [[nodiscard]] std::span<const Index> corners_of(Index f) const {
    return corners.span().subspan(first[f], first[f + 1] - first[f]);
  }
};

/// Takes over the faces that have three corners or more, after dropping repeats that enclose
/// nothing.
[[nodiscard]] bool clean(const Polygons& input, const Vertices& vertices, Log& log, Faces& out);

/// Faces as a surface: which side of a face is joined to which. Its order of faces and vertices is
/// canonical: it depends on positions, not on the input's order, so nor does what follows.
///
/// Corner c of a face is also the name of its side from there to the next corner.
struct Surface {
  const Polygons* input = nullptr;
  Array<Index> origin;   // by vertex: a vertex of the input
  Array<Index> number;   // by vertex: its place in Vertices
  Faces faces;           // `source` is a place in the Faces that it was made from
  Array<Index> face_of;  // by corner
  Array<Index> mate;     // by side: the one across the edge, or kNone
  Array<Index> kept;     // by face: the `source` of the duplicate that is kept, as a rule its own
  Array<Index> votes;    // by face: the copies that spoke for its orientation, less those against
  /// By face: 1 and 2 for a face and the next one where they are the same, but run opposite ways.
  Array<std::uint8_t> pillow;
  Array<bool> flipped;  // by face: to be turned over
  Array<bool> split;    // by vertex: each of its fans needs a vertex of its own

  [[nodiscard]] std::size_t vertex_count() const { return origin.size(); }
  [[nodiscard]] Index after(Index c) const {
    const Index f = face_of[c];
    return c + 1 == faces.first[f + 1] ? faces.first[f] : c + 1;
  }
  [[nodiscard]] Index before(Index c) const {
    const Index f = face_of[c];
    return c == faces.first[f] ? faces.first[f + 1] - 1 : c - 1;
  }
  [[nodiscard]] Index from(Index side) const { return faces.corners[side]; }
  [[nodiscard]] Index to(Index side) const { return faces.corners[after(side)]; }
  /// Whether the side runs from the smaller vertex to the larger, in the face as it will be.
  [[nodiscard]] bool runs_up(Index side) const {
    return (from(side) < to(side)) != flipped[face_of[side]];
  }
  /// The corner at `vertex`, an end of `side`.
  [[nodiscard]] Index corner_at(Index side, Index vertex) const {
    return faces.corners[side] == vertex ? side : after(side);
  }
  /// The other side of the same face at a corner.
  [[nodiscard]] Index other_side(Index corner, Index side) const {
    return side == corner ? before(corner) : corner;
  }
  [[nodiscard]] const float* position(Index vertex) const {
    return &input->positions[3 * std::size_t{origin[vertex]}];
  }
  void join(Index a, Index b) { mate[a] = b, mate[b] = a; }
  void cut(Index side) {
    if (mate[side] == kNone) return;
    mate[mate[side]] = kNone;
    mate[side] = kNone;
  }
};

/// The sides of edges with more than two faces, edge after edge.
struct Crowds {
  Array<Index> sides;
  Array<Index> end;  // of each edge, in `sides`
};

/// Copies the faces in canonical order, and finds duplicates.
[[nodiscard]] bool arrange(const Polygons& input, const Vertices& vertices, const Faces& faces,
                           Surface& out);

/// Drops duplicates, joins the sides of edges with two faces, lists those of edges with more.
[[nodiscard]] bool match(Surface& surface, const Faces& faces, Log& log, Crowds& crowds);

/// Decides which faces are to be turned over, and cuts edges where none of it helps.
[[nodiscard]] bool orient(Surface& surface, const Faces& faces, Log& log);

/// Joins the sides of edges with more than two faces.
[[nodiscard]] bool match_crowds(Surface& surface, const Crowds& crowds);

/// By corner: the vertex that it gets, where fans can't share one. Those below vertex_count() are
/// places in Vertices; the rest are copies, and `copies` has the place of each.
[[nodiscard]] bool split_vertices(Surface& surface, const Crowds& crowds, const Faces& faces,
                                  Log& log, Array<Index>& vertex_of, Array<Index>& copies);

}  // namespace halfedge::repair
