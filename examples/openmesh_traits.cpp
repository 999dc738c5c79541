// "Developer Documentation" of OpenMesh: the previous halfedge need not be stored, since it can be
// derived from the links to the next ones; leaving it out gains memory. And a mesh is customised:
// by what it stores, and by data for each edge, for which a face-based structure has no place.

#include <halfedge/build/build.h>
#include <halfedge/connectivity/convert.h>
#include <halfedge/dialects/openmesh.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

// In OpenMesh these are traits: HalfedgeAttributes with and without Attributes::PrevHalfedge.
using Stored = halfedge::Mesh;
using Reduced = halfedge::BasicMesh<halfedge::Storage{.prev = false}>;
using MyMesh = halfedge::dialects::openmesh::PolyMesh<const Stored>;
using MyReducedMesh = halfedge::dialects::openmesh::PolyMesh<const Reduced>;

// A torus of triangles: 8 × 8 squares, each cut in two.
constexpr halfedge::Index kSide = 8;

bool build_torus(Stored& mesh) {
  const auto at = [](halfedge::Index x, halfedge::Index y) {
    return y % kSide * kSide + x % kSide;
  };
  std::vector<float> positions;
  std::vector<halfedge::Index> corners;
  for (halfedge::Index y = 0; y < kSide; ++y) {
    for (halfedge::Index x = 0; x < kSide; ++x) {
      positions.insert(positions.end(), {float(x), float(y), 0});
      corners.insert(corners.end(), {at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      corners.insert(corners.end(), {at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  halfedge::BuildReport report;
  if (halfedge::build_from_polygons(mesh, {positions, {}, corners}, report)) return true;
  std::cerr << report.problems[0].message << '\n';
  return false;
}

// What the links take, positions left out.
template <class Mesh>
std::size_t bytes_per_vertex(const Mesh& mesh) {
  const halfedge::Links& links = mesh.links();
  std::size_t count = 0;
  for (const auto* link : {&links.next, &links.prev, &links.to_vertex, &links.face,
                           &links.vertex_halfedge, &links.face_halfedge}) {
    count += link->size();
  }
  return count * sizeof(halfedge::Index) / mesh.vertex_count();
}

// Round the loop until the next one is where it began.
MyReducedMesh::HalfedgeHandle prev_by_walking(const MyReducedMesh& mesh,
                                              MyReducedMesh::HalfedgeHandle heh) {
  MyReducedMesh::HalfedgeHandle at = heh;
  while (mesh.next_halfedge_handle(at) != heh) at = mesh.next_halfedge_handle(at);
  return at;
}

template <class Mesh>
std::string one_ring(const Mesh& mesh, typename Mesh::VertexHandle vh) {
  std::string ring;
  for (const auto neighbour : mesh.vv_ccw_range(vh)) ring += " " + std::to_string(neighbour.idx());
  return ring;
}

}  // namespace

int main() {
  Stored stored;
  Stored copy;
  Reduced reduced;
  if (!build_torus(stored) || !copy.assign(stored)) return 1;
  if (const auto converted = halfedge::convert(std::move(copy), reduced); !converted) {
    std::cerr << converted.error().message << '\n';
    return 1;
  }
  const MyMesh mesh(stored);
  const MyReducedMesh without_prev(reduced);

  std::cout << mesh.n_vertices() << " vertices, " << mesh.n_edges() << " edges, " << mesh.n_faces()
            << " faces\n"
            << "with prev: " << bytes_per_vertex(stored) << " bytes a vertex\n"
            << "without:   " << bytes_per_vertex(reduced) << " bytes a vertex\n";

  std::size_t same = 0;
  for (const MyMesh::HalfedgeHandle heh : mesh.halfedges()) {
    const MyMesh::HalfedgeHandle prev = mesh.prev_halfedge_handle(heh);
    same += prev_by_walking(without_prev, heh) == prev &&
            without_prev.prev_halfedge_handle(heh) == prev;
  }
  std::cout << "walking finds the same prev for " << same << " of " << mesh.n_halfedges()
            << " halfedges\n";
  const MyMesh::VertexHandle vh(0);
  std::cout << "one-ring of vertex 0, with prev:" << one_ring(mesh, vh) << '\n'
            << "and without:                    " << one_ring(without_prev, vh) << '\n';

  // Data for each edge: an array, since items are indices. So for vertices, halfedges and faces.
  std::vector<int> faces_of_edge(mesh.n_edges(), 0);
  for (const MyMesh::FaceHandle fh : mesh.faces()) {
    for (const MyMesh::EdgeHandle eh : mesh.fe_range(fh)) ++faces_of_edge[std::size_t(eh.idx())];
  }
  std::cout << "edges with two faces: " << std::count(faces_of_edge.begin(), faces_of_edge.end(), 2)
            << '\n';
}
