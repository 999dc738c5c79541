// Directed Edges for JavaScript: as in bindings.cpp, a mesh is named by its address.

#include <halfedge/directed_edges/build.h>
#include <halfedge/directed_edges/convert.h>
#include <halfedge/directed_edges/directed_edges.h>
#include <halfedge/directed_edges/validate.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "bindings.h"

namespace {

using namespace halfedge;
using namespace halfedge::bindings;

DirectedEdgesMesh& directed_at(Address address) {
  return *reinterpret_cast<DirectedEdgesMesh*>(address);
}

void destroy(Address address) { std::destroy_at(&directed_at(address)), free_block(address); }

/// Directed Edges on their way to JavaScript.
class NewDirectedEdges {
 public:
  NewDirectedEdges() : address_(allocate(sizeof(DirectedEdgesMesh))) {
    if (address_ != 0) new (reinterpret_cast<void*>(address_)) DirectedEdgesMesh;
  }
  NewDirectedEdges(const NewDirectedEdges&) = delete;
  NewDirectedEdges& operator=(const NewDirectedEdges&) = delete;
  ~NewDirectedEdges() {
    if (address_ != 0) destroy(address_);
  }
  explicit operator bool() const { return address_ != 0; }
  DirectedEdgesMesh& operator*() const { return directed_at(address_); }
  val release() { return success("mesh", val(std::exchange(address_, 0))); }

 private:
  Address address_;
};

val build_directed(Address positions, std::size_t position_count, Address corners,
                   std::size_t corner_count) {
  NewDirectedEdges mesh;
  if (!mesh) return failure(no_room_for_a_mesh());
  BuildReport report;
  const Polygons triangles{
      array_at<float>(positions, position_count), {}, array_at<Index>(corners, corner_count)};
  if (!build_from_triangles(*mesh, triangles, report)) {
    return failure(report.problems, report.problem_count);
  }
  return mesh.release();
}

val from_full(Address full) {
  NewDirectedEdges mesh;
  if (!mesh) return failure(no_room_for_a_mesh());
  const Result<void> result = from_mesh(mesh_at(full), *mesh);
  return result ? mesh.release() : failure(result.error());
}

val to_full(Address address) {
  NewMesh full(true);
  if (!full) return failure(no_room_for_a_mesh());
  Mesh mesh;
  Result<void> result = to_mesh(directed_at(address), mesh);
  if (result) result = convert(std::move(mesh), *full);
  return result ? success("mesh", val(full.release())) : failure(result.error());
}

/// The words that `DirectedLinks.refresh` reads. They are good until the next call.
Address directed_layout(Address address) {
  static std::array<std::uint32_t, 9> words;
  const auto at = [](const auto* data) {
    return static_cast<std::uint32_t>(reinterpret_cast<Address>(data));
  };
  const DirectedEdgesMesh& mesh = directed_at(address);
  const DirectedLinks& links = mesh.links();
  words = {at(links.opposite.data()),
           at(links.to_vertex.data()),
           at(links.boundary_next.data()),
           at(links.boundary_prev.data()),
           at(links.vertex_halfedge.data()),
           at(mesh.positions().data()),
           mesh.vertex_count(),
           mesh.halfedge_count(),
           links.sides};
  return reinterpret_cast<Address>(words.data());
}

val validate_directed(Address mesh, int level) {
  return to_list(validate(directed_at(mesh), level));
}

}  // namespace

EMSCRIPTEN_BINDINGS(directed_edges) {
  using emscripten::function;
  function("buildDirectedEdges", &build_directed);
  function("directedEdgesFromMesh", &from_full);
  function("directedEdgesToMesh", &to_full);
  function("destroyDirectedEdges", &destroy);
  function("directedEdgesLayout", &directed_layout);
  function("validateDirectedEdges", &validate_directed);
}
