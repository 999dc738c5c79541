// Faces added one by one, and deleted, beside OpenMesh's add_face and delete_*.

#include <gtest/gtest.h>
#include <halfedge/operations/add_face.h>
#include <halfedge/operations/deletion.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "openmesh/theirs.h"
#include "support/sweep.h"

namespace halfedge::test {
namespace {

using Theirs = OpenMesh::PolyMesh_ArrayKernelT<>;

bool add_face(Theirs& mesh, const std::vector<Index>& corners) {
  const QuietLog quiet;
  std::vector<OpenMesh::VertexHandle> handles;
  for (const Index v : corners) handles.emplace_back(int(v));
  return mesh.add_face(handles).is_valid();
}

Result<Face> add_face(Mesh& mesh, const std::vector<Index>& corners) {
  std::vector<Vertex> handles;
  for (const Index v : corners) handles.emplace_back(v);
  return operations::add_face(mesh, handles);
}

/// The same mesh with the same numbers of vertices and faces.
Theirs mirror(const Mesh& mesh) {
  Theirs theirs;
  theirs.request_vertex_status();
  theirs.request_edge_status();
  theirs.request_face_status();
  for (Index v = 0; v < mesh.vertex_slots(); ++v) theirs.add_vertex({0, 0, 0});
  for (const Face f : mesh.faces()) {
    EXPECT_TRUE(add_face(theirs, corners_of(mesh, mesh.face_halfedge(f))));
  }
  return theirs;
}

// ---- add_face -------------------------------------------------------------------------------

TEST(OpenMeshAddFace, TakesTheFacesOfAMeshInAnyOrder) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    Shape shape = random_polygons(seed);
    SCOPED_TRACE(shape.name);
    std::mt19937 random(seed);
    std::shuffle(shape.faces.begin(), shape.faces.end(), random);
    Mesh ours;
    Theirs theirs;
    for (Index v = 0; v < shape.vertices; ++v) {
      ASSERT_TRUE(ours.add_vertex({}).valid());
      theirs.add_vertex({0, 0, 0});
    }
    for (const std::vector<Index>& face : shape.faces) {
      ASSERT_TRUE(add_face(ours, face));
      ASSERT_TRUE(add_face(theirs, face));
    }
    EXPECT_EQ(polys_of(ours), their_polys(theirs));
    EXPECT_EQ(ours.edge_count(), theirs.n_edges());
  }
}

/// Three to five different vertices, along edges of the mesh as a rule, so that much can go wrong.
std::vector<Index> random_corners(const Mesh& mesh, std::mt19937& random) {
  const auto below = [&](Index count) { return Index(random() % count); };
  std::vector<Index> corners;
  Vertex v(below(mesh.vertex_slots()));
  const Index degree = 3 + below(3);
  for (int tries = 0; corners.size() < degree && tries < 40; ++tries) {
    if (std::find(corners.begin(), corners.end(), v.index()) == corners.end()) {
      corners.push_back(v.index());
    }
    Halfedge out = mesh.vertex_halfedge(v);
    if (out.valid() && below(4) > 0) {
      for (Index turns = below(4); turns > 0; --turns) out = mesh.rotate_cw(out);
      v = mesh.to_vertex(out);
    } else {
      v = Vertex(below(mesh.vertex_slots()));
    }
  }
  return corners;
}

TEST(OpenMeshAddFace, TakesTheSameFaces) {
  int added = 0;
  int refused = 0;
  std::uint32_t seed = 0;
  for (const auto& [name, mesh] : meshes_to_sweep()) {
    if (mesh.vertex_slots() == 0) continue;
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    std::mt19937 random(seed++);
    for (int i = 0; i < 200; ++i) {
      const std::vector<Index> corners = random_corners(mesh, random);
      if (corners.size() < 3) continue;
      Mesh ours = copy_of(mesh);
      Theirs theirs = mirror(mesh);
      const Result<Face> face = add_face(ours, corners);
      const bool is_added = add_face(theirs, corners);
      ASSERT_EQ(face.ok(), is_added) << (face ? "" : face.error().message);
      (face ? added : refused)++;
      EXPECT_EQ(polys_of(ours), their_polys(theirs));
    }
  }
  EXPECT_GT(added, 200);
  EXPECT_GT(refused, 200);
}

// ---- deletion -------------------------------------------------------------------------------

/// That the same faces, edges and vertices are left, and OpenMesh's garbage collection leaves as
/// many.
void expect_same(const Mesh& ours, Theirs& theirs) {
  std::vector<Index> vertices;
  for (const auto v : theirs.vertices()) vertices.push_back(Index(v.idx()));
  std::vector<Index> our_vertices;
  for (const Vertex v : ours.vertices()) our_vertices.push_back(v.index());
  EXPECT_EQ(our_vertices, vertices);
  EXPECT_EQ(polys_of(ours), their_polys(theirs));
  theirs.garbage_collection();
  EXPECT_EQ(ours.vertex_count(), theirs.n_vertices());
  EXPECT_EQ(ours.edge_count(), theirs.n_edges());
  EXPECT_EQ(ours.face_count(), theirs.n_faces());
}

TEST(OpenMeshDeletion, LeavesTheSame) {
  for (const auto& [name, mesh] : meshes_to_sweep()) {
    SCOPED_TRACE(name);
    for (const bool keeps : {false, true}) {
      const operations::DeleteOptions options{.keep_isolated_vertices = keeps};
      for (const Face f : mesh.faces()) {
        SCOPED_TRACE("face " + std::to_string(f.index()));
        Theirs theirs = mirror(mesh);
        Mesh ours = copy_of(mesh);
        ASSERT_TRUE(operations::delete_face(ours, f, options));
        theirs.delete_face(OpenMesh::FaceHandle(int(f.index())), !keeps);
        expect_same(ours, theirs);
      }
      for (const Edge e : mesh.edges()) {
        SCOPED_TRACE("edge " + std::to_string(e.index()));
        Theirs theirs = mirror(mesh);
        Mesh ours = copy_of(mesh);
        ASSERT_TRUE(operations::delete_edge(ours, e, options));
        const Halfedge h = mesh.edge_halfedge(e);
        const OpenMesh::VertexHandle from(int(mesh.from_vertex(h).index()));
        const OpenMesh::VertexHandle to(int(mesh.to_vertex(h).index()));
        theirs.delete_edge(theirs.edge_handle(theirs.find_halfedge(from, to)), !keeps);
        expect_same(ours, theirs);
      }
      for (const Vertex v : mesh.vertices()) {
        SCOPED_TRACE("vertex " + std::to_string(v.index()));
        if (mesh.is_isolated(v)) continue;  // OpenMesh 9 reads out of bounds there
        Theirs theirs = mirror(mesh);
        Mesh ours = copy_of(mesh);
        ASSERT_TRUE(operations::delete_vertex(ours, v, options));
        theirs.delete_vertex(OpenMesh::VertexHandle(int(v.index())), !keeps);
        expect_same(ours, theirs);
      }
    }
  }
}

}  // namespace
}  // namespace halfedge::test
