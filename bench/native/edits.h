#pragma once

#include <halfedge/mesh.h>

#include <span>

#include "contender.h"

/// One of the common operations, done all over a mesh, a step of history each.
struct Edit {
  const char* name;
  void (*run)(halfedge::Mesh& mesh, halfedge::Index count);
  /// Once for each edge, otherwise for each face.
  bool of_edges;
  /// On the vertices that split_face has put into all faces before.
  bool on_centres;
};

/// flip_edge, split_edge, split_face and collapse.
[[nodiscard]] std::span<const Edit> edits();

/// A mesh that is edited, and made as it was before each edit.
class EditedMesh {
 public:
  explicit EditedMesh(const TriangleMesh& input);

  /// Makes the mesh as it is before the edit, with room for what that adds.
  void prepare(const Edit& edit, bool has_history);
  void run(const Edit& edit);
  void undo_all();
  void redo_all();

 private:
  halfedge::Mesh built_;
  halfedge::Mesh mesh_;
};
