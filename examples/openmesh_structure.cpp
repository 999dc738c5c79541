// "The Halfedge Data Structure" of OpenMesh's documentation, in OpenMesh's names: the links (1) to
// (7), circulating by the opposite of the previous halfedge, telling the boundary by the outgoing
// halfedge of a vertex, and keeping it so after a low-level change of topology.

#include <halfedge/build/build.h>
#include <halfedge/dialects/openmesh.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <iostream>
#include <string>
#include <vector>

namespace {

using MyMesh = halfedge::dialects::openmesh::PolyMesh<halfedge::Mesh>;

// A box without its lid 4-5-6-7.
//
//      7───────6
//     ╱│      ╱│        z y
//    4───────5 │        │╱
//    │ 3─────│─2        └─ x
//    │╱      │╱
//    0───────1
constexpr float kPositions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0,
                                0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
constexpr halfedge::Index kSizes[] = {4, 4, 4, 4, 4};
constexpr halfedge::Index kCorners[] = {0, 3, 2, 1, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
constexpr const char* kNames[] = {"bottom", "front", "right", "back", "left"};

std::string name_of(const MyMesh&, MyMesh::VertexHandle vh) { return std::to_string(vh.idx()); }
std::string name_of(const MyMesh&, MyMesh::FaceHandle fh) { return kNames[fh.idx()]; }
std::string name_of(const MyMesh& mesh, MyMesh::HalfedgeHandle heh) {
  return name_of(mesh, mesh.from_vertex_handle(heh)) + ">" +
         name_of(mesh, mesh.to_vertex_handle(heh));
}

template <class Range>
void print(const char* title, const MyMesh& mesh, const Range& items) {
  std::cout << title << ':';
  for (const auto item : items) std::cout << ' ' << name_of(mesh, item);
  std::cout << (items.begin() == items.end() ? " none\n" : "\n");
}

void print_links(const MyMesh& mesh, MyMesh::VertexHandle vh, MyMesh::FaceHandle fh) {
  const MyMesh::HalfedgeHandle heh = mesh.halfedge_handle(fh);
  std::cout << "(1) vertex " << vh << " has the outgoing halfedge "
            << name_of(mesh, mesh.halfedge_handle(vh)) << '\n'
            << "(2) the " << name_of(mesh, fh) << " has the halfedge " << name_of(mesh, heh) << '\n'
            << "(3) which points to vertex " << mesh.to_vertex_handle(heh) << ",\n"
            << "(4) belongs to the " << name_of(mesh, mesh.face_handle(heh)) << ",\n"
            << "(5) has the next halfedge " << name_of(mesh, mesh.next_halfedge_handle(heh))
            << ",\n"
            << "(6) the opposite halfedge " << name_of(mesh, mesh.opposite_halfedge_handle(heh))
            << ",\n"
            << "(7) and the previous halfedge " << name_of(mesh, mesh.prev_halfedge_handle(heh))
            << ".\n";
}

// Around a vertex: from its halfedge on to the opposite of the previous one, without a branch.
std::vector<MyMesh::HalfedgeHandle> circulate(const MyMesh& mesh, MyMesh::VertexHandle vh) {
  std::vector<MyMesh::HalfedgeHandle> outgoing;
  MyMesh::HalfedgeHandle heh = mesh.halfedge_handle(vh);
  do {
    outgoing.push_back(heh);
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (heh != mesh.halfedge_handle(vh));
  return outgoing;
}

std::vector<MyMesh::VertexHandle> boundary_vertices(const MyMesh& mesh) {
  std::vector<MyMesh::VertexHandle> found;
  for (const MyMesh::VertexHandle vh : mesh.vertices()) {
    if (mesh.is_boundary(vh)) found.push_back(vh);
  }
  return found;
}

// Takes a face away, and puts it into the gap to the left of a boundary halfedge.
void move_face(MyMesh& mesh, MyMesh::FaceHandle fh, MyMesh::HalfedgeHandle gap) {
  // A circulator must not be used after a change: first where it goes, then the changes.
  std::vector<MyMesh::HalfedgeHandle> left;
  for (const MyMesh::HalfedgeHandle heh : mesh.fh_range(fh)) left.push_back(heh);
  std::vector<MyMesh::HalfedgeHandle> filled;
  for (const MyMesh::HalfedgeHandle heh : mesh.hl_range(gap)) filled.push_back(heh);

  for (const MyMesh::HalfedgeHandle heh : left) mesh.set_boundary(heh);
  for (const MyMesh::HalfedgeHandle heh : filled) mesh.set_face_handle(heh, fh);
  mesh.set_halfedge_handle(fh, gap);
}

}  // namespace

int main() {
  halfedge::Mesh box;
  halfedge::BuildReport report;
  if (!halfedge::build_from_polygons(box, {kPositions, kSizes, kCorners}, report)) {
    std::cerr << report.problems[0].message << '\n';
    return 1;
  }
  MyMesh mesh(box);
  const MyMesh::VertexHandle vh(0);
  const MyMesh::FaceHandle front(1);
  const MyMesh::FaceHandle bottom(0);

  print_links(mesh, vh, front);
  print("Around the front, its vertices", mesh, mesh.fv_range(front));
  print("its halfedges", mesh, mesh.fh_range(front));
  print("its neighbours", mesh, mesh.ff_range(front));
  print("Around vertex 0, by the opposite of the previous", mesh, circulate(mesh, vh));
  print("its one-ring", mesh, mesh.vv_range(vh));
  print("incoming halfedges", mesh, mesh.vih_range(vh));
  print("faces", mesh, mesh.vf_range(vh));

  print("On the boundary", mesh, boundary_vertices(mesh));
  move_face(mesh, bottom, mesh.find_halfedge(MyMesh::VertexHandle(4), MyMesh::VertexHandle(5)));
  print("The bottom becomes the lid", mesh, mesh.fv_range(bottom));
  print("On the boundary, say outgoing halfedges", mesh, boundary_vertices(mesh));
  std::cout << "A problem, says validate: " << halfedge::validate(box)[0].code << '\n';
  for (const MyMesh::VertexHandle vertex : mesh.vertices()) mesh.adjust_outgoing_halfedge(vertex);
  print("On the boundary, when they are adjusted", mesh, boundary_vertices(mesh));
  std::cout << "Problems left: " << halfedge::validate(box).size() << '\n';
}
