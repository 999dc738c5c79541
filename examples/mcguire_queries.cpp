// The five adjacency queries of Max McGuire's article "The Half-Edge Data Structure" (2000), on a
// cube, with the article's own structs and loops. Each takes constant time for every item that it
// yields. The same queries in our own words are the circulators: mesh.vertex_faces_cw(v) and so on.

#include <halfedge/build/build.h>
#include <halfedge/dialects/mcguire.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace halfedge::dialects::mcguire;
using halfedge::Index;

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

std::vector<HE_edge*> edges_that_use(HE_vert* vert) {
  std::vector<HE_edge*> edges;
  HE_edge* edge = vert->edge;
  do {
    edges.push_back(edge);
    edge = edge->pair->next;
  } while (edge != vert->edge);
  return edges;
}

std::vector<HE_edge*> edges_that_border(HE_face* face) {
  std::vector<HE_edge*> edges;
  HE_edge* edge = face->edge;
  do {
    edges.push_back(edge);
    edge = edge->next;
  } while (edge != face->edge);
  return edges;
}

std::string name_of(const HE_mesh& mesh, const HE_face* face) {
  return kNames[mesh.item(face).index()];
}

std::string name_of(const HE_mesh& mesh, const HE_edge* edge) {
  const auto [a, b] = std::minmax({mesh.item(edge->pair->vert), mesh.item(edge->vert)});
  return std::to_string(a.index()) + "-" + std::to_string(b.index());
}

template <class Items>
void print(const char* question, const HE_mesh& mesh, const Items& answer) {
  std::cout << question << " ";
  for (const auto* item : answer) std::cout << ' ' << name_of(mesh, item);
  std::cout << '\n';
}

void answer(HE_mesh& mesh, HE_vert* vert, HE_edge* edge, HE_face* face) {
  std::vector<HE_face*> faces;
  for (HE_edge* at_vertex : edges_that_use(vert)) faces.push_back(at_vertex->face);
  print("Which faces use vertex 6?", mesh, faces);

  print("Which edges use vertex 6?", mesh, edges_that_use(vert));

  HE_face* face1 = edge->face;
  HE_face* face2 = edge->pair->face;
  print("Which faces border edge 5-6?", mesh, std::vector<HE_face*>{face1, face2});

  print("Which edges border the top?", mesh, edges_that_border(face));

  faces.clear();
  for (HE_edge* at_face : edges_that_border(face)) faces.push_back(at_face->pair->face);
  print("Which faces are adjacent to the top?", mesh, faces);
}

}  // namespace

int main() {
  halfedge::Mesh cube;
  halfedge::BuildReport report;
  if (!halfedge::build_from_polygons(cube, {kPositions, kSizes, kCorners}, report)) {
    std::cerr << report.problems[0].message << '\n';
    return 1;
  }
  halfedge::Result<HE_mesh> copied = copy(cube);
  if (!copied) {
    std::cerr << copied.error().message << '\n';
    return 1;
  }
  HE_mesh& mesh = copied.value();
  const halfedge::Halfedge edge = cube.find_halfedge(halfedge::Vertex(5), halfedge::Vertex(6));
  answer(mesh, mesh.vert(halfedge::Vertex(6)), mesh.edge(edge), mesh.face(halfedge::Face(1)));
}
