// Compiles as it stands. With one of the macros, it calls what needs a link that isn't stored, or
// what else a mesh can't do, and must not compile: see the tests missing_links.* in
// tests/cpp/CMakeLists.txt.

#include <halfedge/halfedge.h>

using namespace halfedge;

namespace {

Index without_faces(const BasicConnectivity<kWithoutFaces>& mesh, Vertex v) {
#if defined(FACES_AROUND_VERTEX)
  for (const Face f : mesh.vertex_faces_cw(v)) return f.index();
#elif defined(BOUNDARY_WITHOUT_FACES)
  return mesh.is_boundary(v) ? 1 : 0;
#endif
  for (const Vertex w : mesh.vertex_vertices_cw(v)) return w.index();
  return kNone;
}

Index without_face_halfedges(const BasicConnectivity<kWithoutFaceHalfedges>& mesh, Face f,
                             Halfedge start) {
#if defined(FACE_WITHOUT_START)
  for (const Vertex w : mesh.face_vertices_ccw(f)) return w.index();
#endif
  for (const Vertex w : mesh.face_vertices_ccw(f, start)) return w.index();
  return kNone;
}

Index without_anchors(const BasicConnectivity<kWithoutAnchors>& mesh, Vertex v, Halfedge start) {
#if defined(VERTEX_WITHOUT_START)
  for (const Vertex w : mesh.vertex_vertices_cw(v)) return w.index();
#endif
  for (const Vertex w : mesh.vertex_vertices_cw(v, start)) return w.index();
  return kNone;
}

std::int64_t numbers(const BasicMesh<kWithoutFaceHalfedges>& mesh) {
#if defined(TOPOLOGY_WITHOUT_FACES)
  if (!is_closed(mesh)) return genus(mesh).value();
#endif
  return euler_characteristic(mesh);
}

void edit([[maybe_unused]] const Mesh& original, Mesh& mesh) {
#if defined(EDIT_OF_CONST_MESH)
  (void)operations::flip_edge(original, Edge(0));
#elif defined(COPY_OF_MESH)
  mesh = Mesh(original);
#endif
  (void)operations::flip_edge(mesh, Edge(0));
}

// An algorithm that says in its requires clause what it needs.
template <StoresPrev Mesh>
Index sum_of_prev(const Mesh& mesh) {
  Index sum = 0;
  for (const Halfedge h : mesh.halfedges()) sum += mesh.prev(h).index();
  return sum;
}
#if defined(ALGORITHM_WITHOUT_PREV)
using Chosen = BasicConnectivity<kWithoutPrev>;
#else
using Chosen = Connectivity;
#endif

#if defined(PREV_IN_TWO_WAYS)
bool is_closed_with_both(const Connectivity&) {
  return is_closed(BasicConnectivity<Storage{.prev_at_run_time = true}>{});
}
#endif

}  // namespace

int main() {
  Mesh mesh;
  edit({}, mesh);
  (void)numbers({});
  return int(without_faces({}, Vertex(0)) + without_face_halfedges({}, Face(0), Halfedge(0)) +
             without_anchors({}, Vertex(0), Halfedge(0)) + sum_of_prev(Chosen{}));
}
