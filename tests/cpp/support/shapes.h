#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/handle.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace halfedge::test {

/// Polygons to build a mesh from. Positions lie on a curve without coincident or collinear points:
/// the tests here are about connectivity.
struct Shape {
  std::string name;
  Index vertices = 0;
  std::vector<std::vector<Index>> faces;
  std::vector<float> positions;
  std::vector<Index> sizes;
  std::vector<Index> corners;

  Shape(std::string its_name, Index vertex_count, std::vector<std::vector<Index>> its_faces)
      : name(std::move(its_name)), vertices(vertex_count), faces(std::move(its_faces)) {
    for (Index v = 0; v < vertices; ++v) {
      const float t = float(v) / float(vertices);
      positions.insert(positions.end(), {t, t * t, t * t * t});
    }
    for (const std::vector<Index>& face : faces) {
      sizes.push_back(Index(face.size()));
      corners.insert(corners.end(), face.begin(), face.end());
    }
  }

  [[nodiscard]] Polygons polygons() const { return {positions, sizes, corners}; }
};

/// The same faces, in an order of chance.
inline Shape in_random_order(Shape shape, std::uint32_t seed = 1) {
  std::shuffle(shape.faces.begin(), shape.faces.end(), std::mt19937(seed));
  return {shape.name, shape.vertices, shape.faces};
}

/// The same, with the numbers of the vertices exchanged by chance.
inline Shape with_random_names(Shape shape, std::uint32_t seed = 1) {
  std::vector<Index> names(shape.vertices);
  std::iota(names.begin(), names.end(), 0U);
  std::shuffle(names.begin(), names.end(), std::mt19937(seed));
  for (std::vector<Index>& face : shape.faces) {
    for (Index& v : face) v = names[v];
  }
  return {shape.name, shape.vertices, shape.faces};
}

inline Shape loose_triangles(Index count) {
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < count; ++i) faces.push_back({3 * i + 2, 3 * i, 3 * i + 1});
  return {"loose triangles", 3 * count, std::move(faces)};
}

/// Two vertices of high valence; the last vertex is one of them.
inline Shape bipyramid(Index valence) {
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < valence; ++i) {
    const Index a = 1 + i;
    const Index b = 1 + (i + 1) % valence;
    faces.push_back({0, a, b});
    faces.push_back({valence + 1, b, a});
  }
  return {"bipyramid", valence + 2, std::move(faces)};
}

/// Triangles around vertex 0, and a face of `valence` corners opposite of it.
inline Shape pyramid(Index valence) {
  std::vector<std::vector<Index>> faces;
  std::vector<Index> base;
  for (Index i = 0; i < valence; ++i) {
    faces.push_back({0, 1 + i, 1 + (i + 1) % valence});
    base.push_back(valence - i);
  }
  faces.push_back(std::move(base));
  return {"pyramid", valence + 1, std::move(faces)};
}

/// (columns + 1) * (rows + 1) vertices row by row; `quad` tells whether a cell stays a quad or is
/// cut into two triangles.
template <class IsQuad>
Shape grid_of(std::string name, Index columns, Index rows, IsQuad is_quad) {
  std::vector<std::vector<Index>> faces;
  for (Index y = 0; y < rows; ++y) {
    for (Index x = 0; x < columns; ++x) {
      const Index a = y * (columns + 1) + x;
      const Index b = a + 1;
      const Index c = b + columns + 1;
      const Index d = c - 1;
      if (is_quad(x, y)) {
        faces.push_back({a, b, c, d});
      } else {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      }
    }
  }
  return {std::move(name), (columns + 1) * (rows + 1), std::move(faces)};
}

inline Shape quad_grid(Index columns, Index rows) {
  return grid_of("quad grid", columns, rows, [](Index, Index) { return true; });
}
inline Shape triangle_grid(Index columns, Index rows) {
  return grid_of("triangle grid", columns, rows, [](Index, Index) { return false; });
}

/// A torus of quads; with `punctures`, so many of its first faces are left out.
inline Shape torus(Index columns, Index rows, Index punctures = 0) {
  std::vector<std::vector<Index>> faces;
  for (Index y = 0; y < rows; ++y) {
    for (Index x = 0; x < columns; ++x) {
      const Index right = (x + 1) % columns;
      const Index up = (y + 1) % rows;
      faces.push_back(
          {y * columns + x, y * columns + right, up * columns + right, up * columns + x});
    }
  }
  faces.erase(faces.begin(), faces.begin() + punctures);
  return {punctures == 0 ? "torus" : "punctured torus", columns * rows, std::move(faces)};
}

inline Shape triangle() { return {"triangle", 3, {{0, 1, 2}}}; }
inline Shape pillow() { return {"pillow", 3, {{0, 1, 2}, {2, 1, 0}}}; }
inline Shape tetrahedron() {
  return {"tetrahedron", 4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}
inline Shape cube() {
  return {"cube",
          8,
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}
/// A fan of triangles around vertex 0.
inline Shape disk(Index valence) {
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < valence; ++i) faces.push_back({0, 1 + i, 1 + (i + 1) % valence});
  return {"disk", valence + 1, std::move(faces)};
}
/// A ring of quads: inner vertices 0 to sides - 1, outer ones after them.
inline Shape annulus(Index sides) {
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < sides; ++i) {
    const Index j = (i + 1) % sides;
    faces.push_back({i, sides + i, sides + j, j});
  }
  return {"annulus", 2 * sides, std::move(faces)};
}
/// `fans` triangles that share vertex 0 and nothing else.
inline Shape pinched(Index fans) {
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < fans; ++i) faces.push_back({0, 1 + 2 * i, 2 + 2 * i});
  return {"pinched vertex", 2 * fans + 1, std::move(faces)};
}
/// A triangle, a quad and a pentagon around vertex 0, and a hexagon outside; closed it is not.
inline Shape mixed_polygons() {
  return {"mixed polygons", 11, {{0, 1, 2}, {0, 2, 3, 4}, {0, 4, 5, 6, 1}, {2, 1, 7, 8, 9, 10}}};
}
inline Shape with_isolated_vertices() { return {"isolated vertices", 6, {{1, 2, 4}}}; }
inline Shape two_components() {
  return {"two components", 7, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 5, 6}}};
}
inline Shape no_faces() { return {"no faces", 0, {}}; }

/// One of each kind of topology; each is a valid mesh.
inline std::vector<Shape> all_shapes() {
  return {no_faces(),
          triangle(),
          pillow(),
          tetrahedron(),
          cube(),
          disk(7),
          annulus(5),
          torus(4, 3),
          torus(5, 4, 1),
          torus(6, 6, 1),
          pinched(2),
          pinched(5),
          mixed_polygons(),
          quad_grid(3, 3),
          triangle_grid(4, 3),
          with_isolated_vertices(),
          two_components(),
          grid_of("mixed grid", 5, 4, [](Index x, Index y) { return (x + 2 * y) % 3 != 0; })};
}

}  // namespace halfedge::test
