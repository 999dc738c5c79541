#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <unordered_map>
#include <vector>

#include "contender.h"

/// An icosahedron whose faces were cut in four `levels` times, with bumps: 20 * 4^levels faces, in
/// the order in which subdivision makes them.
inline TriangleMesh bumpy_sphere(int levels) {
  const float t = (1 + std::sqrt(5.0F)) / 2;
  TriangleMesh mesh;
  mesh.positions = {-1, t,  0,  1, t, 0,  -1, -t, 0,  1, -t, 0, 0,  -1, t,  0,  1, t,
                    0,  -1, -t, 0, 1, -t, t,  0,  -1, t, 0,  1, -t, 0,  -1, -t, 0, 1};
  mesh.corners = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                  4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                  6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (int level = 0; level < levels; ++level) {
    std::unordered_map<std::uint64_t, std::uint32_t> middle_of;
    middle_of.reserve(2 * mesh.corners.size());
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [low, high] = std::minmax(a, b);
      const auto next = static_cast<std::uint32_t>(mesh.vertex_count());
      const auto [entry, is_new] = middle_of.try_emplace(std::uint64_t{low} << 32 | high, next);
      if (is_new) {
        for (std::size_t i = 0; i < 3; ++i) {
          mesh.positions.push_back((mesh.positions[3 * a + i] + mesh.positions[3 * b + i]) / 2);
        }
      }
      return entry->second;
    };
    std::vector<std::uint32_t> finer;
    finer.reserve(4 * mesh.corners.size());
    for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
      const std::uint32_t v[3] = {mesh.corners[c], mesh.corners[c + 1], mesh.corners[c + 2]};
      const std::uint32_t m[3] = {middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0])};
      for (const std::uint32_t corner :
           {v[0], m[0], m[2], v[1], m[1], m[0], v[2], m[2], m[1], m[0], m[1], m[2]}) {
        finer.push_back(corner);
      }
    }
    mesh.corners = std::move(finer);
  }
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    float* p = &mesh.positions[3 * v];
    const float length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    const float radius = 1 + 0.05F * std::sin(9 * p[0] / length) * std::cos(7 * p[1] / length);
    for (std::size_t i = 0; i < 3; ++i) p[i] *= radius / length;
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
