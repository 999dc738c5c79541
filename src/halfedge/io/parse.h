#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/build/soup_attribute.h>
#include <halfedge/progress.h>
#include <halfedge/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halfedge {

/// The file formats that can be read.
enum class Format : std::uint8_t { kObj, kOff, kPly, kStl };

/// "OBJ", "OFF", "PLY", "STL".
[[nodiscard]] const char* name_of(Format format);

/// What a file holds: faces over shared vertices as written, not yet a mesh. Vertex i and face j
/// are the i-th vertex and the j-th face of the file; of an STL file, which repeats its vertices,
/// vertex i is the i-th position that differs from those before, if they are welded.
struct ParsedFile {
  Format format = Format::kObj;
  PolygonSoup soup;
  /// What was ignored and a user may want to know, one sentence each.
  std::vector<std::string> notes;
  /// It is no text, and has no lines.
  bool binary = false;
  /// What the file says of its vertices, corners and faces beside positions, under the names that
  /// are usual: `normal`, `color`, `uv`; see docs/files.md. No two of one kind of item have the
  /// same name. `add_attributes` carries them to a mesh.
  std::vector<SoupAttribute> attributes = {};
  /// The words for the numbers of `group`, `object` and `material` of an OBJ file, where they are
  /// not numbers themselves; and as `library` the files of its materials.
  std::vector<SoupNames> names = {};
};

/// How a file is read.
struct ParseOptions {
  /// Whether attributes are read. If not, they cost nothing.
  bool attributes = true;
  /// Whether faces with vertices that don't exist, and triangles of STL without finite positions,
  /// are let through, for `build_from_soup` to leave them out and say so. Otherwise they are an
  /// error here, which names the place.
  bool for_repair = false;
  /// Whether vertices of STL with the same position are one. If not, corner k of triangle i is
  /// vertex 3 i + k, as the file has it.
  bool weld = true;
  /// Is told about every MiB how much has been read, and may cancel that (code cancelled).
  Progress progress = {};
};

/// Reads a file. Its content decides the format; `claimed` (what the name of the file says, or its
/// user) decides where the content leaves it open.
///
/// Positions spelt `nan` or `inf`, faces with fewer than three corners and repeated vertices are
/// read as they stand: they are well-formed text, and the builder refuses them with a reason.
/// A note tells if floats are too coarse for positions that lie far from the origin.
/// Every error but those about the whole file starts with "line N: ", or "byte N: " in a binary
/// file (from 0), and says what was expected; once the format is known, it ends with that. Lines
/// end with LF, CR LF or CR; a UTF-8 byte-order mark is skipped.
///
/// cost: one pass; memory in proportion to the size of the file, whatever its header promises.
///
/// Codes: parse-error, truncated (the file ends too early), index-out-of-range, non-finite-position
/// (in STL), unknown-format, unsupported-format (known, but not readable), not-text (UTF-16,
/// binary), too-large, out-of-memory, cancelled (by who follows the progress).
[[nodiscard]] Result<ParsedFile> parse(std::span<const std::uint8_t> bytes,
                                       std::optional<Format> claimed = std::nullopt,
                                       const ParseOptions& options = {});

/// Reads a Wavefront OBJ file: `v` and `f` with corners as 3, 3/1, 3/1/2 or 3//2, indices from 1 or
/// negative and then counted back from the last vertex so far, `\` at the end of a line. A face may
/// come before its vertices. Texture coordinates and normals become attributes of corners, `v` with
/// six or seven numbers colours of vertices, `g`, `o`, `usemtl` and `s` numbers of faces. Points,
/// lines, curves and unknown statements are ignored, weights, third texture coordinates and
/// ZBrush's comments with colours too, and counted in notes.
[[nodiscard]] Result<ParsedFile> read_obj(std::span<const std::uint8_t> bytes,
                                          const ParseOptions& options = {});

/// Reads a Geomview OFF file, in text or binary form (of either byte order): OFF with the prefixes
/// ST, C, N, 4, n, or no header word at all; the number of edges may be left out; comments
/// anywhere. Normals, colours and texture coordinates of vertices become attributes, and so do
/// colours of faces; 4OFF positions are divided by their fourth coordinate.
[[nodiscard]] Result<ParsedFile> read_off(std::span<const std::uint8_t> bytes,
                                          const ParseOptions& options = {});

/// Reads a PLY file, in text or in either binary form: elements and properties in any order, x, y
/// and z of `vertex` and the list vertex_indices (or vertex_index) of `face` of any types, and
/// `tristrips`. All other properties of vertices and faces become attributes, lists if they have
/// the same length in all rows, and the list `texcoord` of faces one of corners; other lists and
/// elements are ignored, and named in a note.
[[nodiscard]] Result<ParsedFile> read_ply(std::span<const std::uint8_t> bytes,
                                          const ParseOptions& options = {});

/// Reads an STL file, in text or binary form. Positions are welded where all bits are equal, but
/// for the sign of zero, unless the options say otherwise; what is no number has no place in that,
/// and is an error that names the triangle. The two bytes behind a triangle of the binary form
/// become the attribute `attribute` of faces, if any of them isn't 0; normals are ignored, as the
/// corners tell them.
[[nodiscard]] Result<ParsedFile> read_stl(std::span<const std::uint8_t> bytes,
                                          const ParseOptions& options = {});

/// The line, from 1, on which each of these faces starts, in the order asked for; 0 for a face that
/// the file does not have, and for all faces of a binary file. Reads the file again, so that
/// reading keeps no line numbers in memory. pre: `bytes` are what the faces were read from. cost:
/// as reading, whatever the number of faces.
[[nodiscard]] std::vector<std::size_t> lines_of_faces(std::span<const std::uint8_t> bytes,
                                                      Format format, std::span<const Index> faces);

/// Adds to the sentence of each problem, which building a mesh of the file has found, on which
/// lines its faces start, or its vertices if no face is named: "(Line 6)"; in a binary file at
/// which bytes, from 0: "(Byte 84)"; at most eight of them. Vertices of STL and strips of PLY have
/// no place of their own. A vertex that an OBJ file does not have is named as it is written there.
/// pre, cost: as `lines_of_faces`.
void add_places(std::vector<Error>& problems, std::span<const std::uint8_t> bytes, Format format);

}  // namespace halfedge
