#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

#include "contender.h"

/// Each face cut in four at the middles of its edges; the order of faces and vertices is kept.
inline TriangleMesh subdivided(const TriangleMesh& mesh) {
  TriangleMesh finer;
  finer.positions = mesh.positions;
  finer.corners.reserve(4 * mesh.corners.size());
  std::unordered_map<std::uint64_t, std::uint32_t> middle_of;
  middle_of.reserve(2 * mesh.corners.size());
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto next = static_cast<std::uint32_t>(finer.vertex_count());
    const auto [entry, is_new] = middle_of.try_emplace(std::uint64_t{low} << 32 | high, next);
    if (is_new) {
      for (std::size_t i = 0; i < 3; ++i) {
        finer.positions.push_back((mesh.positions[3 * a + i] + mesh.positions[3 * b + i]) / 2);
      }
    }
    return entry->second;
  };
  for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
    const std::uint32_t v[3] = {mesh.corners[c], mesh.corners[c + 1], mesh.corners[c + 2]};
    const std::uint32_t m[3] = {middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0])};
    for (const std::uint32_t corner :
         {v[0], m[0], m[2], v[1], m[1], m[0], v[2], m[2], m[1], m[0], m[1], m[2]}) {
      finer.corners.push_back(corner);
    }
  }
  return finer;
}

/// An icosahedron whose faces were cut in four `levels` times, on a sphere: 20 * 4^levels faces.
inline TriangleMesh sphere(int levels) {
  const float t = (1 + std::sqrt(5.0F)) / 2;
  TriangleMesh mesh;
  mesh.positions = {-1, t,  0,  1, t, 0,  -1, -t, 0,  1, -t, 0, 0,  -1, t,  0,  1, t,
                    0,  -1, -t, 0, 1, -t, t,  0,  -1, t, 0,  1, -t, 0,  -1, -t, 0, 1};
  mesh.corners = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                  4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                  6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (int level = 0; level < levels; ++level) mesh = subdivided(mesh);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    float* p = &mesh.positions[3 * v];
    const float length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    for (std::size_t i = 0; i < 3; ++i) p[i] /= length;
  }
  return mesh;
}

/// A torus of side * side vertices, all of valence 6: 2 * side * side faces, row by row.
inline TriangleMesh torus(std::uint32_t side) {
  TriangleMesh mesh;
  mesh.positions.reserve(3 * std::size_t{side} * side);
  mesh.corners.reserve(6 * std::size_t{side} * side);
  const float turn = 6.2831853F / float(side);
  for (std::uint32_t y = 0; y < side; ++y) {
    const float radius = 3 + std::cos(turn * float(y));
    const std::uint32_t here = side * y;
    const std::uint32_t below = side * ((y + 1) % side);
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t right = (x + 1) % side;
      mesh.positions.insert(mesh.positions.end(),
                            {radius * std::cos(turn * float(x)), radius * std::sin(turn * float(x)),
                             std::sin(turn * float(y))});
      mesh.corners.insert(mesh.corners.end(), {here + x, here + right, below + right,  //
                                               here + x, below + right, below + x});
    }
  }
  return mesh;
}

/// Two vertices of that valence, the first and the last one.
inline TriangleMesh bipyramid(std::uint32_t valence) {
  TriangleMesh mesh;
  mesh.positions.resize(3 * (std::size_t{valence} + 2));
  for (std::uint32_t i = 0; i < valence; ++i) {
    const std::uint32_t a = 1 + i;
    const std::uint32_t b = 1 + (i + 1) % valence;
    mesh.corners.insert(mesh.corners.end(), {0, a, b, valence + 1, b, a});
  }
  return mesh;
}

/// The same mesh with vertices and faces in random order: what a file can hold at its worst.
inline TriangleMesh shuffled(const TriangleMesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> new_vertex(mesh.vertex_count());
  std::iota(new_vertex.begin(), new_vertex.end(), 0U);
  std::shuffle(new_vertex.begin(), new_vertex.end(), random);
  std::vector<std::uint32_t> face(mesh.face_count());
  std::iota(face.begin(), face.end(), 0U);
  std::shuffle(face.begin(), face.end(), random);

  TriangleMesh result;
  result.positions.resize(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    std::copy_n(&mesh.positions[3 * v], 3, &result.positions[3 * std::size_t{new_vertex[v]}]);
  }
  result.corners.reserve(mesh.corners.size());
  for (const std::uint32_t f : face) {
    for (std::size_t i = 0; i < 3; ++i) {
      result.corners.push_back(new_vertex[mesh.corners[3 * std::size_t{f} + i]]);
    }
  }
  return result;
}
