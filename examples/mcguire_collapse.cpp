// What McGuire's article "The Half-Edge Data Structure" (2000) is for: mesh simplification
// collapses an edge into a single vertex, deletes the faces bordering the edge, and updates the
// faces which shared the vertices at its end points. All of them are found by adjacency, none by a
// search through the list of faces.

#include <halfedge/build/build.h>
#include <halfedge/dialects/mcguire.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <iostream>
#include <vector>

namespace {

using namespace halfedge;
using namespace halfedge::dialects::mcguire;

// An octahedron: 0 to 3 around the middle, 4 at the top, 5 at the bottom.
constexpr float kPositions[] = {1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
constexpr Index kCorners[] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4,
                              1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5};

std::vector<Face> faces_that_border(const HE_mesh& mesh, const HE_edge* edge) {
  return {mesh.item(edge->face), mesh.item(edge->pair->face)};
}

std::vector<Face> faces_that_use(const HE_mesh& mesh, const HE_vert* vert) {
  std::vector<Face> faces;
  const HE_edge* edge = vert->edge;
  do {
    faces.push_back(mesh.item(edge->face));
    edge = edge->pair->next;
  } while (edge != vert->edge);
  return faces;
}

// `kept` takes the place of `gone`, which has the same ends, in the loop of the face of `gone`.
void replace(Mesh& mesh, Halfedge gone, Halfedge kept) {
  const Face f = mesh.face(gone);
  mesh.link(mesh.prev(gone), kept);
  mesh.link(kept, mesh.next(gone));
  mesh.set_face(kept, f);
  if (mesh.face_halfedge(f) == gone) mesh.set_face_halfedge(f, kept);
}

//        c                     c
//       ╱ ╲                    │
//      ╱ h ╲                   │         The faces on both sides of a-b are deleted, and with
//     a────►b      becomes     b         them a-c and a-d; what used a uses b.
//      ╲   ╱                   │
//       ╲ ╱                    │         pre: both are triangles; a and b have no neighbours in
//        d                     d         common but c and d; nothing here is on a boundary
void collapse(Mesh& mesh, Halfedge h) {
  const Halfedge o = mesh.opposite(h);
  const Vertex a = mesh.from_vertex(h);
  const Vertex b = mesh.to_vertex(h);
  const Halfedge bc = mesh.next(h);
  const Halfedge ca = mesh.prev(h);
  const Halfedge ad = mesh.next(o);
  const Halfedge db = mesh.prev(o);
  const Face left = mesh.face(h);
  const Face right = mesh.face(o);

  std::vector<Halfedge> arriving_at_a;
  for (const Halfedge arriving : mesh.incoming_cw(a)) arriving_at_a.push_back(arriving);
  for (const Halfedge arriving : arriving_at_a) mesh.set_to_vertex(arriving, b);
  replace(mesh, mesh.opposite(ca), bc);
  replace(mesh, mesh.opposite(ad), db);

  // Any outgoing halfedge will do, of those that are left.
  mesh.set_vertex_halfedge(b, bc);
  mesh.set_vertex_halfedge(mesh.to_vertex(bc), mesh.opposite(bc));
  mesh.set_vertex_halfedge(mesh.from_vertex(db), db);

  mesh.release(left);
  mesh.release(right);
  for (const Halfedge gone : {h, ca, ad}) mesh.release(mesh.edge(gone));
  mesh.release(a);
}

void print(const char* title, const std::vector<Face>& faces) {
  std::cout << title << ':';
  for (const Face f : faces) std::cout << ' ' << f.index();
  std::cout << '\n';
}

void print(const Mesh& mesh) {
  std::cout << mesh.vertex_count() << " vertices, " << mesh.edge_count() << " edges, "
            << mesh.face_count() << " faces\n";
  for (const Face f : mesh.faces()) {
    std::cout << ' ';
    for (const Vertex v : mesh.face_vertices_ccw(f)) std::cout << ' ' << v.index();
    std::cout << '\n';
  }
  std::cout << (has_errors(validate(mesh)) ? "not valid\n" : "valid\n");
}

}  // namespace

int main() {
  Mesh mesh;
  BuildReport report;
  if (!build_from_polygons(mesh, {kPositions, {}, kCorners}, report)) {
    std::cerr << report.problems[0].message << '\n';
    return 1;
  }
  print(mesh);

  const Halfedge h = mesh.find_halfedge(Vertex(5), Vertex(0));
  const Result<HE_mesh> copied = copy(mesh);
  if (!copied) {
    std::cerr << copied.error().message << '\n';
    return 1;
  }
  const HE_mesh& he = copied.value();
  print("Edge 5-0 borders faces, which are deleted", faces_that_border(he, he.edge(h)));
  print("Vertex 5 is used by faces, the others of which are updated",
        faces_that_use(he, he.vert(Vertex(5))));
  collapse(mesh, h);
  print(mesh);
}
