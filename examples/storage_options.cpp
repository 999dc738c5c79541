// What each link costs: the same closed triangle mesh with and without some of them.

#include <halfedge/halfedge.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using namespace halfedge;

// A torus of `sides` times `sides` vertices, and two triangles for each of them.
PolygonSoup torus(Index sides) {
  PolygonSoup soup;
  const float turn = 6.2831853F / float(sides);
  if (!soup.positions.reserve(3 * std::size_t{sides} * sides) ||
      !soup.corners.reserve(6 * std::size_t{sides} * sides)) {
    std::exit(1);
  }
  for (Index i = 0; i < sides; ++i) {
    for (Index j = 0; j < sides; ++j) {
      const float radius = 2 + std::cos(turn * float(j));
      const Index right = (i + 1) % sides;
      const Index up = (j + 1) % sides;
      const Index quad[] = {i * sides + j, right * sides + j, right * sides + up, i * sides + up};
      for (const float coordinate :
           {radius * std::cos(turn * float(i)), radius * std::sin(turn * float(i)),
            std::sin(turn * float(j))}) {
        (void)soup.positions.push_back(coordinate);
      }
      for (const int corner : {0, 1, 2, 0, 2, 3}) (void)soup.corners.push_back(quad[corner]);
    }
  }
  return soup;
}

template <Storage kStored>
std::size_t bytes_of(const BasicMesh<kStored>& mesh) {
  const Links& links = mesh.links();
  std::size_t bytes = mesh.positions().size_bytes();
  for (const Array<Index>* link : {&links.next, &links.prev, &links.to_vertex, &links.face,
                                   &links.vertex_halfedge, &links.face_halfedge}) {
    bytes += sizeof(Index) * link->capacity();
  }
  return bytes;
}

template <Storage kStored>
void print(const char* name, const PolygonSoup& soup) {
  BasicMesh<kStored> mesh;
  BuildReport report;
  if (!build_from_polygons(mesh, soup.view(), report)) std::exit(1);
  std::printf("%-26s %4.0f bytes a vertex\n", name,
              double(bytes_of(mesh)) / double(mesh.vertex_count()));
}

}  // namespace

int main() {
  const PolygonSoup soup = torus(64);
  print<kEverything>("everything", soup);
  print<kWithoutPrev>("without prev", soup);
  print<kWithoutFaceHalfedges>("without face -> halfedge", soup);
  print<kWithoutFaces>("without faces", soup);
  print<kWithoutAnchors>("without vertex -> halfedge", soup);
  print<kBareStorage>("next and to-vertex only", soup);
  return 0;
}
