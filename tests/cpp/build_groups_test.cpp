#include <gtest/gtest.h>
#include <halfedge/build/build.h>
#include <halfedge/directed_edges/build.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/built.h"
#include "support/canonical.h"
#include "support/random_polygons.h"
#include "support/reference_build.h"
#include "support/same_links.h"
#include "support/shapes.h"

// Where edges find their places: whether a vertex has more sides that run up or more that run down,
// and whether they match, depends on the numbers of the vertices around it.

namespace halfedge::test {
namespace {

/// The whole mesh, with prev or without, or nothing where the polygons are not manifold. Returns
/// whether they are.
bool expect_as_described(const Shape& shape) {
  BuildReport report;
  Mesh mesh;
  if (!build_from_polygons(mesh, shape.polygons(), report)) return false;
  expect_valid(mesh, shape.name);
  expect_same(mesh, reference_build(shape), shape.name);

  BasicMesh<kWithoutPrev> without;
  EXPECT_TRUE(build_from_polygons(without, shape.polygons(), report)) << shape.name;
  EXPECT_TRUE(without.links().prev.empty());
  expect_same_links_but_prev(without.links(), mesh.links(), shape.name);
  return true;
}

/// As if each edge but some were cut: triangles and larger faces that share few sides.
Shape thinned(const Shape& shape, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::vector<Index>> faces = shape.faces;
  std::erase_if(faces, [&](const std::vector<Index>&) { return random() % 3 == 0; });
  return {shape.name + ", thinned", shape.vertices, std::move(faces)};
}

/// Each polygon cut from its first corner.
Shape triangulated(const Shape& shape) {
  std::vector<std::vector<Index>> triangles;
  for (const std::vector<Index>& face : shape.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      triangles.push_back({face[0], face[i - 1], face[i]});
    }
  }
  return {shape.name + ", triangulated", shape.vertices, std::move(triangles)};
}

TEST(BuildGroups, MakeTheMeshThatTheContractDescribesOfEveryShape) {
  for (const Shape& shape : all_shapes()) {
    EXPECT_TRUE(expect_as_described(shape)) << shape.name;
    EXPECT_TRUE(expect_as_described(in_random_order(shape))) << shape.name;
    expect_as_described(with_random_names(triangulated(shape)));
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      expect_as_described(with_random_names(thinned(shape, seed), seed));
    }
  }
}

TEST(BuildGroups, MakeTheMeshThatTheContractDescribesOfRandomFaces) {
  int manifold = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    expect_as_described(random_polygons(seed));
    manifold += expect_as_described(triangulated(random_polygons(seed))) ? 1 : 0;
  }
  EXPECT_GT(manifold, 50);  // diagonals can meet
}

TEST(BuildGroups, HoldTheEdgesOfHubsAndOfLooseTriangles) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    EXPECT_TRUE(expect_as_described(in_random_order(with_random_names(disk(12 + seed), seed))));
    EXPECT_TRUE(
        expect_as_described(in_random_order(with_random_names(bipyramid(12 + seed), seed))));
  }
  EXPECT_TRUE(expect_as_described(in_random_order(loose_triangles(5000))));
}

/// A grid of more vertices than 16 bits count, with holes and pinched vertices. Memory is fetched
/// ahead for nearly all of it.
Shape large_grid() {
  Shape shape = triangle_grid(330, 330);
  std::mt19937 random(7);
  std::erase_if(shape.faces, [&](const std::vector<Index>&) { return random() % 50 == 0; });
  return in_random_order(with_random_names(shape));
}

TEST(BuildGroups, MakeTheMeshThatTheContractDescribesOfALargeGridInNoOrder) {
  EXPECT_TRUE(expect_as_described(large_grid()));
}

TEST(BuildGroups, RefuseALargeGridWithOneFaceTwice) {
  Shape grid = large_grid();
  grid.faces.push_back(grid.faces[12'345]);
  const Shape shape{grid.name, grid.vertices, grid.faces};
  Mesh mesh;
  BuildReport report;
  ASSERT_FALSE(build_from_polygons(mesh, shape.polygons(), report));
  EXPECT_EQ(report.problems[0].code, "duplicate-face");
  EXPECT_EQ(mesh.vertex_slots(), 0U);
}

// ---- all ways in which sides can match, be left, or clash

/// Whether the faces around `v` form open fans only, or one closed one. No two sides may be the
/// same.
bool has_one_cycle(const Shape& shape, Index v) {
  std::map<Index, Index>
      out_of_in;  // of each face: to which vertex it leaves, by that it comes from
  std::set<Index> outs;
  for (const std::vector<Index>& face : shape.faces) {
    const std::size_t i = std::size_t(std::find(face.begin(), face.end(), v) - face.begin());
    if (i == face.size()) continue;
    const Index out = face[(i + 1) % face.size()];
    out_of_in[face[(i + face.size() - 1) % face.size()]] = out;
    outs.insert(out);
  }
  std::size_t in_open_fans = 0;
  for (const auto& [in, out] : out_of_in) {
    if (outs.contains(in)) continue;
    for (auto at = out_of_in.find(in); at != out_of_in.end(); at = out_of_in.find(at->second)) {
      ++in_open_fans;
    }
  }
  if (in_open_fans == out_of_in.size()) return true;
  std::size_t lap = 0;
  const Index start = out_of_in.begin()->first;
  Index at = start;
  do {
    at = out_of_in.at(at);
    ++lap;
  } while (at != start && out_of_in.contains(at));
  return lap == out_of_in.size();
}

bool is_manifold(const Shape& shape) {
  std::set<std::pair<Index, Index>> sides;
  for (const std::vector<Index>& face : shape.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (!sides.insert({face[i], face[(i + 1) % face.size()]}).second) return false;
    }
  }
  for (Index v = 0; v < shape.vertices; ++v) {
    if (!has_one_cycle(shape, v)) return false;
  }
  return true;
}

/// Every collection of up to four triangles over five vertices.
TEST(BuildGroups, RefuseJustWhatIsNoManifold) {
  std::vector<std::vector<Index>> triangles;
  for (Index a = 0; a < 5; ++a) {
    for (Index b = a + 1; b < 5; ++b) {
      for (Index c = b + 1; c < 5; ++c) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, b});
      }
    }
  }
  std::vector<std::vector<Index>> faces;
  int refused = 0;
  int built = 0;
  const auto add_faces = [&](const auto& self, std::size_t first) -> void {
    const Shape shape{"some triangles", 5, faces};
    const bool accepted = expect_as_described(shape);
    EXPECT_EQ(accepted, is_manifold(shape)) << testing::PrintToString(faces);
    (accepted ? built : refused) += 1;
    if (faces.size() == 4) return;
    for (std::size_t i = first; i < triangles.size(); ++i) {
      faces.push_back(triangles[i]);
      self(self, i);
      faces.pop_back();
    }
  };
  add_faces(add_faces, 0);
  EXPECT_GT(built, 500);
  EXPECT_GT(refused, 5000);
}

/// Up to three triangles over four vertices, whose corners may be the same. A side from a vertex to
/// itself finds its place among the others, and must not be taken for one of them.
TEST(BuildGroups, RefuseEveryTriangleThatHasAVertexTwice) {
  std::vector<std::vector<Index>> triangles;
  for (Index corners = 0; corners < 64; ++corners) {
    triangles.push_back({corners / 16, corners / 4 % 4, corners % 4});
  }
  const auto has_a_vertex_twice = [](const std::vector<Index>& face) {
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
  };
  Mesh mesh;
  DirectedEdgesMesh directed;
  BuildReport report;
  int refused = 0;
  std::vector<std::vector<Index>> faces;
  const auto add_faces = [&](const auto& self, std::size_t first) -> void {
    if (std::ranges::any_of(faces, has_a_vertex_twice)) {
      const Shape shape{"", 4, faces};
      EXPECT_FALSE(build_from_polygons(mesh, shape.polygons(), report) ||
                   build_from_triangles(directed, shape.polygons(), report))
          << testing::PrintToString(faces);
      ++refused;
    }
    if (faces.size() == 3) return;
    for (std::size_t i = first; i < triangles.size(); ++i) {
      faces.push_back(triangles[i]);
      self(self, i);
      faces.pop_back();
    }
  };
  add_faces(add_faces, 0);
  EXPECT_GT(refused, 40'000);
}

}  // namespace
}  // namespace halfedge::test
