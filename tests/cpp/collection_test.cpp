// The clean meshes of the collection: counts and topology as its README says, valid, and the same
// whatever the order of their faces.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/build/build.h>
#include <halfedge/io/parse.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "support/data_files.h"

namespace halfedge::test {
namespace {

struct Facts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundary_loops = 0;
  std::size_t components = 0;
  std::int64_t genus = 0;

  friend bool operator==(const Facts&, const Facts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Facts& f) {
    return out << "V " << f.vertices << ", E " << f.edges << ", F " << f.faces << ", "
               << f.boundary_loops << " boundary loops, " << f.components << " components, genus "
               << f.genus;
  }
};

// "| file | format | KB | V | E | F | faces | topology | ...", the topology as in "2 boundary
// loops, 1 comp, genus 0 (total)" or "closed, 1 comp, genus 1 (total)".
std::map<std::string, Facts> table_of_readme() {
  std::map<std::string, Facts> table;
  std::ifstream readme(data_folder() / "README.md");
  for (std::string line; std::getline(readme, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
    if (cells.size() < 9 || cells[8].find("genus") == std::string::npos) continue;
    Facts facts;
    std::istringstream(cells[4]) >> facts.vertices;
    std::istringstream(cells[5]) >> facts.edges;
    std::istringstream(cells[6]) >> facts.faces;
    std::istringstream topology(cells[8]);
    std::string word;
    if (cells[8].find("closed") == std::string::npos) topology >> facts.boundary_loops;
    std::getline(topology, word, ',');
    topology >> facts.components;
    std::getline(topology, word, ',');
    topology >> word >> facts.genus;
    std::string file;
    std::istringstream(cells[1]) >> file;
    table[file] = facts;
  }
  return table;
}

Facts facts_of(const Mesh& mesh) {
  return {mesh.vertex_count(),
          mesh.edge_count(),
          mesh.face_count(),
          boundary_loops(mesh).value().size(),
          connected_components(mesh).value().list.size(),
          genus(mesh).value()};
}

Mesh built(const Polygons& polygons) {
  Mesh mesh;
  BuildReport report;
  EXPECT_TRUE(build_from_polygons(mesh, polygons, report)) << report.problems[0].message;
  return mesh;
}

TEST(Collection, HasTheCountsAndTheTopologyOfItsReadmeAndIsValid) {
  HALFEDGE_NEEDS_DATA();
  const std::map<std::string, Facts> table = table_of_readme();
  std::size_t checked = 0;
  for (const auto& path : data_files("good", {".obj", ".off", ".ply", ".stl"})) {
    SCOPED_TRACE(path.filename());
    const Result<ParsedFile> file = parse_file(path);
    ASSERT_TRUE(file) << file.error().message;
    const Mesh mesh = built(file.value().soup.view());
    EXPECT_EQ(facts_of(mesh), table.at(path.filename().string()));
    const std::vector<Problem> problems = validate(mesh);
    EXPECT_TRUE(problems.empty()) << problems[0].message;
    ++checked;
  }
  EXPECT_GE(checked, 80U);
}

// A halfedge by what doesn't depend on the numbers of edges and faces.
struct Side {
  Index from, to, next_to, prev_from, face;
  bool is_first_of_face;
  friend auto operator<=>(const Side&, const Side&) = default;
};

// The sides of a mesh, whose face f is the face `name[f]` of the file, in order.
std::vector<Side> sides_of(const Mesh& mesh, const std::vector<std::size_t>& name) {
  std::vector<Side> sides;
  for (const Halfedge h : mesh.halfedges()) {
    const Face f = mesh.face(h);
    sides.push_back({mesh.from_vertex(h).index(), mesh.to_vertex(h).index(),
                     mesh.to_vertex(mesh.next(h)).index(), mesh.from_vertex(mesh.prev(h)).index(),
                     f.valid() ? Index(name[f.index()]) : kNone,
                     f.valid() && mesh.face_halfedge(f) == h});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

TEST(Collection, GivesTheSameMeshesInAnyOrderOfFaces) {
  HALFEDGE_NEEDS_DATA();
  constexpr std::size_t kMaxFaces = 15000;  // or it takes minutes under the sanitizers
  std::mt19937 random(7);
  for (const auto& path : data_files("good", {".obj", ".off", ".ply", ".stl"})) {
    SCOPED_TRACE(path.filename());
    const Result<ParsedFile> file = parse_file(path);
    if (!file || file.value().soup.view().face_count() > kMaxFaces) continue;
    const Polygons polygons = file.value().soup.view();
    std::vector<std::size_t> order(polygons.face_count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::vector<Side> expected = sides_of(built(polygons), order);

    std::vector<std::size_t> first(order.size() + 1, 0);
    for (const std::size_t f : order) {
      first[f + 1] = first[f] + (polygons.sizes.empty() ? 3 : polygons.sizes[f]);
    }
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Index> sizes;
    std::vector<Index> corners;
    for (const std::size_t f : order) {
      sizes.push_back(Index(first[f + 1] - first[f]));
      for (std::size_t c = first[f]; c < first[f + 1]; ++c) corners.push_back(polygons.corners[c]);
    }
    const Mesh shuffled = built({polygons.positions, sizes, corners});
    EXPECT_TRUE(sides_of(shuffled, order) == expected);
    for (const Vertex v : shuffled.vertices()) {
      const Halfedge anchor = shuffled.vertex_halfedge(v);
      if (shuffled.is_boundary(v)) continue;
      Face last = shuffled.face(anchor);
      for (const Face f : shuffled.vertex_faces_cw(v)) last = std::max(last, f);
      EXPECT_EQ(shuffled.face(anchor), last) << "the anchor of vertex " << v.index();
    }
  }
}

}  // namespace
}  // namespace halfedge::test
