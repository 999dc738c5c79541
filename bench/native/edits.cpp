#include "edits.h"

#include <halfedge/build/build.h>
#include <halfedge/operations/operations.h>

#include <array>
#include <cstdlib>

namespace {

using namespace halfedge;

void require(bool done) {
  if (!done) std::abort();
}

void flip_edges(Mesh& mesh, Index edges) {
  for (Index e = 0; e < edges; ++e) {
    (void)operations::flip_edge(mesh, Edge(e));  // some have neighbours that are joined
    mesh.end_step();
  }
}

void split_edges(Mesh& mesh, Index edges) {
  for (Index e = 0; e < edges; ++e) {
    require(bool(operations::split_edge(mesh, Edge(e))));
    mesh.end_step();
  }
}

void split_faces(Mesh& mesh, Index faces) {
  for (Index f = 0; f < faces; ++f) {
    require(bool(operations::split_face(mesh, Face(f))));
    mesh.end_step();
  }
}

// Of the vertices that split_faces has added to so many faces.
void collapse_centres(Mesh& mesh, Index faces) {
  const Index all = mesh.vertex_slots();
  for (Index v = all - faces; v < all; ++v) {
    require(bool(operations::collapse(mesh, mesh.vertex_halfedge(Vertex(v)))));
    mesh.end_step();
  }
}

constexpr std::array kEdits = {
    Edit{"flip_edge", flip_edges, true, false},
    Edit{"split_edge", split_edges, true, false},
    Edit{"split_face", split_faces, false, false},
    Edit{"collapse", collapse_centres, false, true},
};

}  // namespace

std::span<const Edit> edits() { return kEdits; }

EditedMesh::EditedMesh(const TriangleMesh& input) {
  BuildReport report;
  require(build_from_polygons(built_, {input.positions, {}, input.corners}, report));
}

void EditedMesh::prepare(const Edit& edit, bool has_history) {
  const Index edges = built_.edge_slots();
  const Index faces = built_.face_slots();
  mesh_.disable_history();
  require(mesh_.assign(built_));
  require(mesh_.reserve(built_.vertex_slots() + edges, 4 * edges, 3 * faces + 2 * edges));
  if (edit.on_centres) split_faces(mesh_, faces);
  if (has_history) require(mesh_.enable_history());
}

void EditedMesh::run(const Edit& edit) {
  edit.run(mesh_, edit.of_edges ? built_.edge_slots() : built_.face_slots());
}

void EditedMesh::undo_all() {
  while (mesh_.undo()) continue;
}

void EditedMesh::redo_all() {
  while (mesh_.redo()) continue;
}
