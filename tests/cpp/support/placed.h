#pragma once

#include <halfedge/mesh.h>
#include <halfedge/operations/split_face.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/built.h"
#include "support/shapes.h"

/// Meshes whose vertices lie somewhere on purpose.
namespace halfedge::test {

/// The shape with its vertices at these places.
inline Shape placed(Shape shape, const std::vector<Point>& places) {
  EXPECT_EQ(places.size(), shape.vertices);
  shape.positions.clear();
  for (const Point p : places) shape.positions.insert(shape.positions.end(), {p.x, p.y, p.z});
  return shape;
}

/// The same at places of chance in a cube of side 2.
inline Shape scattered(Shape shape, std::uint32_t seed) {
  std::mt19937 random(seed);
  for (float& coordinate : shape.positions) {
    coordinate = std::uniform_real_distribution<float>(-1, 1)(random);
  }
  return shape;
}

inline Shape polygon(Index corners) {
  std::vector<Index> face(corners);
  for (Index i = 0; i < corners; ++i) face[i] = i;
  return {"a face with " + std::to_string(corners) + " corners", corners, {face}};
}

/// A mesh of one face, 0, with these corners, which may lie anywhere, and nowhere.
inline Mesh face_at(const std::vector<Point>& corners) {
  Mesh mesh = built(polygon(Index(corners.size())));
  for (Index i = 0; i < corners.size(); ++i) mesh.set_position(Vertex(i), corners[i]);
  return mesh;
}

/// Corners, mostly reflex ones among them, around the origin of a tilted plane, each at an angle of
/// its own: so the sides don't cross.
inline std::vector<Point> star_shaped(Index corners, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Point> places;
  for (Index i = 0; i < corners; ++i) {
    const float r = std::uniform_real_distribution<float>(0.2F, 1)(random);
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / float(corners);
    const float x = r * std::cos(angle);
    const float y = r * std::sin(angle);
    places.push_back({x, y, x / 2 - y / 4});  // powers of two: nearly no rounding
  }
  return places;
}

/// Moves all vertices by `by`.
inline void translate(Mesh& mesh, Point by) {
  for (const Vertex v : mesh.vertices()) {
    const Point p = mesh.position(v);
    mesh.set_position(v, {p.x + by.x, p.y + by.y, p.z + by.z});
  }
}

/// Multiplies all coordinates.
inline void scale(Mesh& mesh, float factor) {
  for (float& coordinate : mesh.mutable_positions()) coordinate *= factor;
}

/// The mesh of the shape, larger faces split around a vertex in them, all at places of chance.
inline Mesh scattered_triangles(const Shape& shape, std::uint32_t seed) {
  Mesh mesh = built(shape);
  for (Index f = 0, faces = mesh.face_slots(); f < faces; ++f) {
    if (mesh.degree(Face(f)) > 3) (void)operations::split_face(mesh, Face(f));
  }
  std::mt19937 random(seed);
  for (float& coordinate : mesh.mutable_positions()) {
    coordinate = std::uniform_real_distribution<float>(-1, 1)(random);
  }
  return mesh;
}

/// As all measures of ours see a place.
inline Vector vector_of(Point p) { return {double{p.x}, double{p.y}, double{p.z}}; }
inline Vector vector_of(const Mesh& mesh, Vertex v) { return vector_of(mesh.position(v)); }

/// An upright solid on the letter L of three unit squares, two units high. Faces 0 and 1 are its
/// bottom and its top, the others its sides; vertices 0 to 5 below, 6 to 11 above; 3 and 9 are at
/// the reflex corners.
inline Mesh l_prism() {
  const std::vector<Point> letter = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                     {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  std::vector<Point> places = letter;
  for (const Point p : letter) places.push_back({p.x, p.y, 2});
  std::vector<std::vector<Index>> faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (Index i = 0; i < 6; ++i) faces.push_back({i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i});
  return built(placed({"an L", 12, faces}, places));
}

}  // namespace halfedge::test
