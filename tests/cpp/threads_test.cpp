// What takes a mesh as const writes nothing, and meshes share nothing: so threads need no lock to
// read one mesh, or to edit one of their own. ThreadSanitizer sees more than can be told here: the
// preset tsan.

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/geometry/geometry.h>
#include <halfedge/io/bytes.h>
#include <halfedge/io/write.h>
#include <halfedge/operations/operations.h>
#include <halfedge/validate/validate.h>

#include <array>
#include <barrier>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string_view>
#include <thread>
#include <vector>

#include "support/complexes.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {
namespace {

Mesh with_all() {
  Mesh mesh = reference_build(triangle_grid(6, 5));
  add_attributes_of_all_kinds(mesh);
  EXPECT_TRUE(mesh.enable_generations());
  EXPECT_TRUE(mesh.enable_history());
  EXPECT_TRUE(operations::delete_face(mesh, Face(3)).ok());
  mesh.end_step();
  return mesh;
}

/// Numbers that depend on all that a mesh is asked.
std::vector<double> answers(const Mesh& mesh) {
  std::vector<double> all;
  const auto add = [&](auto number) { all.push_back(double(number)); };
  for (const Vertex v : mesh.vertices()) {
    for (const Vertex w : mesh.vertex_vertices_ccw(v)) add(w.index());
    for (const Face f : mesh.vertex_faces_cw(v)) add(f.index());
    add(mesh.valence(v));
    for (const double coordinate : geometry::vertex_normal(mesh, v)) add(coordinate);
  }
  for (const Face f : mesh.faces()) add(geometry::face_area(mesh, f));
  for (const Edge e : mesh.edges()) {
    add(operations::check_flip_edge(mesh, e).ok());
    add(operations::check_collapse(mesh, mesh.edge_halfedge(e)).ok());
    add(mesh.find_edge(Vertex(0), mesh.to_vertex(mesh.edge_halfedge(e))).index());
  }
  for (const ItemKind kind : kItemKinds) {
    for (const auto& column : mesh.attributes().of(kind)) add(column->get(1, 0));
  }
  add(validate(mesh, kGeometryLevel).size());
  add(connected_components(mesh).value().list.size());
  add(boundary_loops(mesh).value().size());
  add(copy_of(mesh).face_count());
  for (const auto hash = std::hash<std::string_view>();
       const Format format : {Format::kObj, Format::kOff, Format::kPly, Format::kStl}) {
    const Array<std::uint8_t> file = write(mesh, format).value();
    add(hash({reinterpret_cast<const char*>(file.begin()), file.size()}));
  }
  const Array<std::uint8_t> bytes = to_bytes(mesh).value();
  add(std::hash<std::string_view>()({reinterpret_cast<const char*>(bytes.begin()), bytes.size()}));
  return all;
}

/// The object itself, with the bytes that no function shows.
std::array<unsigned char, sizeof(Mesh)> object_of(const Mesh& mesh) {
  std::array<unsigned char, sizeof(Mesh)> bytes = {};
  std::memcpy(bytes.data(), static_cast<const void*>(&mesh), sizeof mesh);
  return bytes;
}

TEST(Threads, ReadingAMeshWritesNothing) {
  const Mesh mesh = with_all();
  const auto object = object_of(mesh);
  const Snapshot arrays(mesh);
  (void)answers(mesh);
  EXPECT_EQ(object_of(mesh), object);
  EXPECT_TRUE(Snapshot(mesh) == arrays);
}

/// Calls `work` many times in each of four threads that begin together: it returns what is expected
/// each time.
template <class Work>
void expect_same_in_threads(const std::vector<double>& expected, const Work& work) {
  std::array<int, 4> differing = {};
  std::barrier start(differing.size());
  std::vector<std::thread> threads;
  threads.reserve(differing.size());
  for (int& count : differing) {
    threads.emplace_back([&] {
      start.arrive_and_wait();
      for (int times = 0; times < 10; ++times) count += work() == expected ? 0 : 1;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(differing, (std::array<int, 4>{}));
}

TEST(Threads, ReadOneMesh) {
  const Mesh mesh = with_all();
  expect_same_in_threads(answers(mesh), [&] { return answers(mesh); });
}

/// Edits of all sorts, taken back and done again.
std::vector<double> edited(Mesh mesh) {
  for (Index e = 0; e < 60; ++e) {
    (void)operations::flip_edge(mesh, Edge(e));
    (void)operations::split_edge(mesh, Edge(e / 2));
    if (e % 3 == 0) (void)operations::collapse(mesh, Halfedge(2 * e));
    mesh.end_step();
  }
  EXPECT_TRUE(compact(mesh));
  mesh.end_step();
  while (mesh.undo()) {
  }
  while (mesh.redo()) {
  }
  return answers(mesh);
}

TEST(Threads, EditMeshesOfTheirOwn) {
  expect_same_in_threads(edited(with_all()), [] { return edited(with_all()); });
}

}  // namespace

}  // namespace halfedge::test
