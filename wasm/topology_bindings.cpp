// Questions about a whole mesh: whether it is valid, its topology, and its faces as triangles. See
// the design in bindings.cpp.

#include <halfedge/algorithms/topology.h>
#include <halfedge/algorithms/triangles.h>
#include <halfedge/validate/validate.h>

#include <cstdint>
#include <vector>

#include "bindings.h"

namespace {

using namespace halfedge;
using namespace halfedge::bindings;

val validate_mesh(Address mesh, int level) {
  const std::vector<Problem> problems = validate(mesh_at(mesh), level);
  return to_list(problems);
}

double euler(Address mesh) { return static_cast<double>(euler_characteristic(mesh_at(mesh))); }

val total_genus(Address mesh) {
  const Result<std::int64_t> result = genus(mesh_at(mesh));
  if (!result) return failure(result.error());
  return success("genus", val(static_cast<double>(result.value())));
}

val loops(Address mesh) {
  Result<Array<Halfedge>> result = boundary_loops(mesh_at(mesh));
  if (!result) return failure(result.error());
  return success("halfedges", hand_over(result.value()));
}

val components(Address mesh) {
  Result<Components> result = connected_components(mesh_at(mesh));
  if (!result) return failure(result.error());
  Components& found = result.value();
  val out = val::object();
  out.set("list", hand_over(found.list));  // vertices, edges, faces, boundary loops
  out.set("ofVertex", hand_over(found.of_vertex));
  out.set("ofFace", hand_over(found.of_face));
  return out;
}

bool closed(Address mesh) { return is_closed(mesh_at(mesh)); }

/// Whether all faces have three, or else four, corners.
bool only_triangles_or_quads(Address mesh, bool triangles) {
  return triangles ? is_triangle_mesh(mesh_at(mesh)) : is_quad_mesh(mesh_at(mesh));
}

/// `corners_as` is a value of CornersAs. Of all faces, if `faces` is 0.
val triangles_of(Address address, int corners_as, Address faces, std::size_t count) {
  const AnyMesh& mesh = mesh_at(address);
  const CornersAs as = static_cast<CornersAs>(corners_as);
  Result<TriangleList> triangles =
      faces == 0 ? to_triangles(mesh, as) : to_triangles(mesh, array_at<Index>(faces, count), as);
  if (!triangles) return failure(triangles.error());
  val result = success("corners", hand_over(triangles.value().corners));
  result.set("faces", hand_over(triangles.value().faces));
  return result;
}

}  // namespace

EMSCRIPTEN_BINDINGS(halfedge_topology) {
  using emscripten::function;

  function("validate", &validate_mesh);
  function("eulerCharacteristic", &euler);
  function("genus", &total_genus);
  function("boundaryLoops", &loops);
  function("components", &components);
  function("isClosed", &closed);
  function("onlyTrianglesOrQuads", &only_triangles_or_quads);
  function("toTriangles", &triangles_of);
}
