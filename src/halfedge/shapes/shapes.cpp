#include <halfedge/build/build.h>
#include <halfedge/build/connect.h>
#include <halfedge/sentence.h>
#include <halfedge/shapes/maker.h>
#include <halfedge/shapes/shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

namespace halfedge::shapes {

namespace {

constexpr double kGolden = std::numbers::phi;

struct Corner {
  double x, y, z;
};

// A solid by its table: corners of any size, and faces of `degree` corners each.
Result<PolygonSoup> solid(const char* name, std::span<const Corner> corners, std::size_t degree,
                          std::span<const std::uint8_t> faces, double radius) {
  if (Error error; refused({check_lengths(name, {radius})}, error)) return error;
  const std::size_t face_count = faces.size() / degree;
  Maker maker(name, double(corners.size()), double(face_count), double(faces.size()));
  if (!maker.ready()) return maker.take();
  for (const Corner& c : corners) {
    const double scale = radius / std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
    maker.vertex(scale * c.x, scale * c.y, scale * c.z);
  }
  std::array<Index, 5> face;
  for (std::size_t first = 0; first < faces.size(); first += degree) {
    for (std::size_t i = 0; i < degree; ++i) face[i] = faces[first + i];
    maker.face(std::span<const Index>(face).first(degree));
  }
  return maker.take();
}

// A circle of vertices around y, counter-clockwise as seen from above.
void circle(Maker& maker, Index segments, double radius, double y) {
  for (Index i = 0; i < segments; ++i) {
    const Turn at = turn(i, segments);
    maker.vertex(radius * at.cosine, y, -radius * at.sine);
  }
}

// What closes the circle of vertices from `first` on, seen from above or from below.
void cap(Maker& maker, Caps kind, Index first, Index segments, Index middle, bool from_above) {
  if (kind == Caps::kPolygons) return maker.polygon(first, segments, !from_above);
  if (kind == Caps::kOpen) return;
  for (Index i = 0; i < segments; ++i) {
    const Index here = first + i;
    const Index next = first + (i + 1) % segments;
    if (from_above) {
      maker.face({middle, here, next});
    } else {
      maker.face({middle, next, here});
    }
  }
}

// How many vertices, faces and corners a cap adds.
struct CapCounts {
  double vertices, faces, corners;
};
CapCounts count_cap(Caps kind, double segments) {
  if (kind == Caps::kPolygons) return {0, 1, segments};
  if (kind == Caps::kFans) return {1, segments, 3 * segments};
  return {0, 0, 0};
}

// How many faces, and corners of faces, so many quads are.
constexpr double faces_of(double quads, Faces faces) {
  return faces == Faces::kQuads ? quads : 2 * quads;
}
constexpr double corners_of(double quads, Faces faces) {
  return faces == Faces::kQuads ? 4 * quads : 6 * quads;
}

}  // namespace

Result<PolygonSoup> tetrahedron(double radius) {
  static constexpr Corner kCorners[] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  static constexpr std::uint8_t kFaces[] = {2, 1, 0, 0, 3, 2, 1, 3, 0, 2, 3, 1};
  return solid("a tetrahedron", kCorners, 3, kFaces, radius);
}

Result<PolygonSoup> cube(double size) {
  static constexpr Corner kCorners[] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                        {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
  static constexpr std::uint8_t kFaces[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                            2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  if (Error error; refused({check_lengths("a cube", {size})}, error)) return error;
  return solid("a cube", kCorners, 4, kFaces, size * (std::numbers::sqrt3 / 2));
}

Result<PolygonSoup> octahedron(double radius) {
  static constexpr Corner kCorners[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                        {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  static constexpr std::uint8_t kFaces[] = {0, 2, 4, 0, 4, 3, 0, 3, 5, 0, 5, 2,
                                            1, 2, 5, 1, 5, 3, 1, 3, 4, 1, 4, 2};
  return solid("an octahedron", kCorners, 3, kFaces, radius);
}

Result<PolygonSoup> icosahedron(double radius) {
  static constexpr double kG = kGolden;
  static constexpr Corner kCorners[] = {{-1, kG, 0}, {1, kG, 0}, {-1, -kG, 0}, {1, -kG, 0},
                                        {0, -1, kG}, {0, 1, kG}, {0, -1, -kG}, {0, 1, -kG},
                                        {kG, 0, -1}, {kG, 0, 1}, {-kG, 0, -1}, {-kG, 0, 1}};
  static constexpr std::uint8_t kFaces[] = {0, 11, 5, 0, 5,  1,  0,  1,  7,  0,  7, 10, 0, 10, 11,
                                            1, 5,  9, 5, 11, 4,  11, 10, 2,  10, 7, 6,  7, 1,  8,
                                            3, 9,  4, 3, 4,  2,  3,  2,  6,  3,  6, 8,  3, 8,  9,
                                            4, 9,  5, 2, 4,  11, 6,  2,  10, 8,  6, 7,  9, 8,  1};
  return solid("an icosahedron", kCorners, 3, kFaces, radius);
}

Result<PolygonSoup> dodecahedron(double radius) {
  static constexpr double kG = kGolden;
  static constexpr double kI = 1 / kGolden;
  static constexpr Corner kCorners[] = {{-1, -1, -1},  {1, -1, -1},  {-1, 1, -1},  {1, 1, -1},
                                        {-1, -1, 1},   {1, -1, 1},   {-1, 1, 1},   {1, 1, 1},
                                        {0, -kI, -kG}, {0, kI, -kG}, {0, -kI, kG}, {0, kI, kG},
                                        {-kI, -kG, 0}, {kI, -kG, 0}, {-kI, kG, 0}, {kI, kG, 0},
                                        {-kG, 0, -kI}, {kG, 0, -kI}, {-kG, 0, kI}, {kG, 0, kI}};
  static constexpr std::uint8_t kFaces[] = {
      0, 16, 2,  9, 8,  0, 8,  1,  13, 12, 0, 12, 4, 18, 16, 4, 10, 11, 6,  18,
      2, 14, 15, 3, 9,  1, 17, 19, 5,  13, 1, 8,  9, 3,  17, 4, 12, 13, 5,  10,
      2, 16, 18, 6, 14, 5, 19, 7,  11, 10, 6, 11, 7, 15, 14, 3, 15, 7,  19, 17};
  return solid("a dodecahedron", kCorners, 5, kFaces, radius);
}

Result<PolygonSoup> prism(Index sides, double radius, double height) {
  if (Error error; refused({check_count("a prism", "side", sides, 3)}, error)) return error;
  return cylinder(sides, 1, Caps::kPolygons, Faces::kQuads, radius, height);
}

Result<PolygonSoup> cone(Index segments, Caps base, double radius, double height) {
  Error error;
  if (refused({check_count("a cone", "segment", segments, 3),
               check_lengths("a cone", {radius, height})},
              error)) {
    return error;
  }
  const double n = segments;
  const CapCounts more = count_cap(base, n);
  Maker maker("a cone", n + 1 + more.vertices, n + more.faces, 3 * n + more.corners);
  if (!maker.ready()) return maker.take();
  circle(maker, segments, radius, -height / 2);
  maker.vertex(0, height / 2, 0);
  if (base == Caps::kFans) maker.vertex(0, -height / 2, 0);
  for (Index i = 0; i < segments; ++i) maker.face({i, (i + 1) % segments, segments});
  cap(maker, base, 0, segments, segments + 1, false);
  return maker.take();
}

Result<PolygonSoup> cylinder(Index segments, Index rings, Caps caps, Faces faces, double radius,
                             double height) {
  Error error;
  if (refused({check_count("a cylinder", "segment", segments, 3),
               check_count("a cylinder", "ring", rings, 1),
               check_lengths("a cylinder", {radius, height})},
              error)) {
    return error;
  }
  const double quads = double(segments) * rings;
  const CapCounts more = count_cap(caps, segments);
  Maker maker("a cylinder", quads + segments + 2 * more.vertices,
              faces_of(quads, faces) + 2 * more.faces, corners_of(quads, faces) + 2 * more.corners);
  if (!maker.ready()) return maker.take();
  for (std::uint64_t ring = 0; ring <= rings; ++ring) {
    circle(maker, segments, radius, height * (double(ring) / double(rings) - 0.5));
  }
  for (Index ring = 0; ring < rings; ++ring) {
    for (Index i = 0; i < segments; ++i) {
      const Index here = ring * segments + i;
      const Index next = ring * segments + (i + 1) % segments;
      maker.quad(here, next, next + segments, here + segments, faces);
    }
  }
  const Index top = rings * segments;
  const Index middle = top + segments;
  if (caps == Caps::kFans) {
    maker.vertex(0, -height / 2, 0);
    maker.vertex(0, height / 2, 0);
  }
  cap(maker, caps, 0, segments, middle, false);
  cap(maker, caps, top, segments, middle + 1, true);
  return maker.take();
}

Result<PolygonSoup> grid(Index columns, Index rows, Faces faces, double width, double height) {
  Error error;
  if (refused({check_count("a grid", "column", columns, 1), check_count("a grid", "row", rows, 1),
               check_lengths("a grid", {width, height})},
              error)) {
    return error;
  }
  const double quads = double(columns) * rows;
  Maker maker("a grid", quads + columns + rows + 1, faces_of(quads, faces),
              corners_of(quads, faces));
  if (!maker.ready()) return maker.take();
  for (Index row = 0; row <= rows; ++row) {
    for (Index column = 0; column <= columns; ++column) {
      maker.vertex(width * (double(column) / columns - 0.5), height * (double(row) / rows - 0.5),
                   0);
    }
  }
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column < columns; ++column) {
      const Index a = row * (columns + 1) + column;
      maker.quad(a, a + 1, a + columns + 2, a + columns + 1, faces);
    }
  }
  return maker.take();
}

Result<PolygonSoup> torus(Index rings, Index sides, Faces faces, double radius, double tube) {
  Error error;
  if (refused({check_count("a torus", "ring", rings, 3), check_count("a torus", "side", sides, 3),
               check_lengths("a torus", {radius, tube, radius + tube})},
              error)) {
    return error;
  }
  const double quads = double(rings) * sides;
  Maker maker("a torus", quads, faces_of(quads, faces), corners_of(quads, faces));
  if (!maker.ready()) return maker.take();
  for (Index ring = 0; ring < rings; ++ring) {
    const Turn around = turn(ring, rings);
    for (Index side = 0; side < sides; ++side) {
      const Turn across = turn(side, sides);
      const double distance = radius + tube * across.cosine;
      maker.vertex(distance * around.cosine, distance * around.sine, tube * across.sine);
    }
  }
  for (Index ring = 0; ring < rings; ++ring) {
    const Index here = ring * sides;
    const Index next = (ring + 1) % rings * sides;
    for (Index side = 0; side < sides; ++side) {
      const Index up = (side + 1) % sides;
      maker.quad(here + side, next + side, next + up, here + up, faces);
    }
  }
  return maker.take();
}

Result<PolygonSoup> uv_sphere(Index segments, Index rings, Faces faces, double radius) {
  Error error;
  if (refused(
          {check_count("a uv-sphere", "segment", segments, 3),
           check_count("a uv-sphere", "ring", rings, 2), check_lengths("a uv-sphere", {radius})},
          error)) {
    return error;
  }
  const double triangles = 2 * double(segments);
  const double quads = (double(rings) - 2) * segments;
  Maker maker("a uv-sphere", quads + segments + 2, triangles + faces_of(quads, faces),
              3 * triangles + corners_of(quads, faces));
  if (!maker.ready()) return maker.take();
  maker.vertex(0, radius, 0);
  for (Index ring = 1; ring < rings; ++ring) {
    const Turn down = turn(ring, 2 * std::uint64_t{rings});
    circle(maker, segments, radius * down.sine, radius * down.cosine);
  }
  maker.vertex(0, -radius, 0);
  const Index south = (rings - 1) * segments + 1;
  for (Index ring = 0; ring < rings; ++ring) {
    const Index upper = 1 + (ring - 1) * segments;  // wraps around in the first ring: unused there
    const Index lower = upper + segments;
    for (Index i = 0; i < segments; ++i) {
      const Index next = (i + 1) % segments;
      if (ring == 0) {
        maker.face({lower + i, lower + next, 0});
      } else if (ring + 1 == rings) {
        maker.face({south, upper + next, upper + i});
      } else {
        maker.quad(lower + i, lower + next, upper + next, upper + i, faces);
      }
    }
  }
  return maker.take();
}

namespace {

// Cuts each triangle in four, with the new vertices on the unit sphere. The mesh of the triangles
// numbers their edges: the vertex in the middle of edge e is number e of the new ones.
ConnectResult subdivide(PolygonSoup& soup) {
  Links links;
  const ConnectResult connected = connect<false>(soup.view(), links);
  if (connected != ConnectResult::kDone) return connected;
  const std::size_t edges = links.next.size() / 2;
  const std::size_t old_vertices = soup.positions.size() / 3;
  Array<Index> corners;
  if (!corners.resize(4 * soup.corners.size()) ||
      !soup.positions.resize(3 * (old_vertices + edges))) {
    return ConnectResult::kOutOfMemory;
  }
  for (std::size_t e = 0; e < edges; ++e) {
    const float* const a = &soup.positions[3 * std::size_t{links.to_vertex[2 * e]}];
    const float* const b = &soup.positions[3 * std::size_t{links.to_vertex[2 * e + 1]}];
    const double middle[] = {double{a[0]} + b[0], double{a[1]} + b[1], double{a[2]} + b[2]};
    const double length =
        std::sqrt(middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      soup.positions[3 * (old_vertices + e) + i] = float(middle[i] / length);
    }
  }
  for (std::size_t f = 0; f < links.face_halfedge.size(); ++f) {
    const Index* const v = &soup.corners[3 * f];
    Index middle[3];  // of the sides v2 v0, v0 v1, v1 v2
    Index h = links.face_halfedge[f];
    for (Index& m : middle) {
      m = Index(old_vertices) + h / 2;
      h = links.next[h];
    }
    const Index four[] = {v[0],      middle[1], middle[0], middle[1], v[1],      middle[2],
                          middle[0], middle[2], v[2],      middle[1], middle[2], middle[0]};
    std::copy(std::begin(four), std::end(four), &corners[12 * f]);
  }
  soup.corners = std::move(corners);
  return ConnectResult::kDone;
}

}  // namespace

Result<PolygonSoup> ico_sphere(Index subdivisions, double radius) {
  if (Error error; refused({check_lengths("an ico-sphere", {radius})}, error)) return error;
  if (subdivisions > 12) {
    return Error{"too-large", sentence::of("An ico-sphere of {} subdivisions has more items than "
                                           "can be addressed, expected at most 12.",
                                           subdivisions)};
  }
  Result<PolygonSoup> shape = icosahedron();
  for (Index i = 0; shape && i < subdivisions; ++i) {
    if (subdivide(shape.value()) == ConnectResult::kDone) continue;
    return Error{"out-of-memory",
                 sentence::of("There is not enough memory for an ico-sphere of {} subdivisions.",
                              subdivisions)};
  }
  if (!shape) return shape;
  for (float& coordinate : shape.value().positions) coordinate = float(coordinate * radius);
  return shape;
}

Result<Mesh> mesh_of(const Result<PolygonSoup>& shape) {
  if (!shape) return shape.error();
  Mesh mesh;
  BuildReport report;
  if (!build_from_polygons(mesh, shape.value().view(), report)) return report.problems[0];
  return mesh;
}

}  // namespace halfedge::shapes
