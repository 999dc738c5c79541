// The five adjacency queries of Max McGuire's article "The Half-Edge Data Structure" (2000), on a
// cube. Each takes constant time for every item that it yields.

#include <halfedge/build/build.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <iostream>
#include <string>

namespace {

using namespace halfedge;

//      7───────6
//     ╱│      ╱│        z y
//    4───────5 │        │╱
//    │ 3─────│─2        └─ x
//    │╱      │╱
//    0───────1
constexpr float kPositions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0,
                                0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
constexpr Index kSizes[] = {4, 4, 4, 4, 4, 4};
constexpr Index kCorners[] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                              1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
constexpr const char* kNames[] = {"bottom", "top", "front", "right", "back", "left"};

std::string name_of(const Mesh&, Face f) { return kNames[f.index()]; }

std::string name_of(const Mesh& mesh, Edge e) {
  const Halfedge h = mesh.edge_halfedge(e);
  const auto [a, b] = std::minmax({mesh.from_vertex(h), mesh.to_vertex(h)});
  return std::to_string(a.index()) + "-" + std::to_string(b.index());
}

template <class Range>
void print(const char* question, const Mesh& mesh, const Range& answer) {
  std::cout << question << " ";
  for (const auto item : answer) std::cout << ' ' << name_of(mesh, item);
  std::cout << '\n';
}

}  // namespace

int main() {
  Mesh mesh;
  BuildReport report;
  if (!build_from_polygons(mesh, {kPositions, kSizes, kCorners}, report)) {
    std::cerr << report.problems[0].message << '\n';
    return 1;
  }
  const Vertex vertex(6);
  const Edge edge = mesh.find_edge(Vertex(5), Vertex(6));
  const Face top(1);

  print("Which faces use vertex 6?", mesh, mesh.vertex_faces_ccw(vertex));
  print("Which edges use vertex 6?", mesh, mesh.vertex_edges_ccw(vertex));
  print("Which faces border edge 5-6?", mesh, mesh.edge_faces(edge));
  print("Which edges border the top?", mesh, mesh.face_edges_ccw(top));
  print("Which faces are adjacent to the top?", mesh, mesh.face_faces_ccw(top));
}
