// Meshes out of nothing, out of other meshes, and out of bytes. See the design in bindings.cpp.

#include <halfedge/build/build.h>
#include <halfedge/io/bytes.h>
#include <halfedge/operations/append.h>
#include <halfedge/operations/dual.h>
#include <halfedge/operations/extract.h>
#include <halfedge/shapes/shapes.h>

#include <type_traits>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

namespace {

/// `kind` is an index into the SHAPES of web/src/shapes.ts; `a` and `b` are its numbers of parts,
/// `x` and `y` its lengths; `faces` and `caps` are values of their enums.
Result<PolygonSoup> polygons_of(int kind, Index a, Index b, double x, double y, shapes::Faces faces,
                                shapes::Caps caps) {
  switch (kind) {
    case 0:
      return shapes::tetrahedron(x);
    case 1:
      return shapes::cube(x);
    case 2:
      return shapes::octahedron(x);
    case 3:
      return shapes::icosahedron(x);
    case 4:
      return shapes::dodecahedron(x);
    case 5:
      return shapes::prism(a, x, y);
    case 6:
      return shapes::cone(a, caps, x, y);
    case 7:
      return shapes::cylinder(a, b, caps, faces, x, y);
    case 8:
      return shapes::grid(a, b, faces, x, y);
    case 9:
      return shapes::torus(a, b, faces, x, y);
    case 10:
      return shapes::uv_sphere(a, b, faces, x);
    default:
      return shapes::ico_sphere(a, x);
  }
}

val shape(int kind, Index a, Index b, double x, double y, int faces, int caps, bool stores_prev) {
  NewMesh mesh(stores_prev);
  if (!mesh) return failure(no_room_for_a_mesh());
  const Result<PolygonSoup> polygons = polygons_of(
      kind, a, b, x, y, static_cast<shapes::Faces>(faces), static_cast<shapes::Caps>(caps));
  if (!polygons) return failure(polygons.error());
  BuildReport report;
  if (!build_from_polygons(*mesh, polygons.value().view(), report)) {
    return failure(report.problems, report.problem_count);
  }
  return success("mesh", val(mesh.release()));
}

val dual_of(Address address) {
  const AnyMesh& original = mesh_at(address);
  NewMesh mesh(original.stores_prev());
  if (!mesh) return failure(no_room_for_a_mesh());
  const Result<DualMaps> maps = dual(original, *mesh);
  if (!maps) return failure(maps.error());
  return success("mesh", val(mesh.release()));
}

/// Returns where vertices, edges and faces went, by slot. `mode` as of an operation.
val append_mesh(Address address, Address other, Index mode) {
  AnyMesh& mesh = mesh_at(address);
  Result<CompactMaps> maps = append(mesh, mesh_at(other));
  if ((mode & kKeepStepOpen) == 0) mesh.end_step();
  write_layout(mesh);
  if (!maps) return failure(maps.error());
  val result = success("vertices", hand_over(maps.value().vertices));
  result.set("edges", hand_over(maps.value().edges));
  result.set("faces", hand_over(maps.value().faces));
  return result;
}

/// Returns the mesh of some faces, and the items that it is a copy of.
val extract_part(Address address, Address faces, std::size_t count) {
  const AnyMesh& mesh = mesh_at(address);
  NewMesh part(mesh.stores_prev());
  if (!part) return failure(no_room_for_a_mesh());
  Result<ItemSet> items = extract(mesh, array_at<Index>(faces, count), *part);
  if (!items) return failure(items.error());
  val result = success("mesh", val(part.release()));
  result.set("vertices", hand_over(items.value().vertices));
  result.set("edges", hand_over(items.value().edges));
  result.set("faces", hand_over(items.value().faces));
  return result;
}

val mesh_to_bytes(Address address) {
  Result<Array<std::uint8_t>> bytes = to_bytes(mesh_at(address));
  if (!bytes) return failure(bytes.error());
  return success("bytes", hand_over(bytes.value()));
}

/// `is_ours`: another thread with this module has made the bytes.
val mesh_from_bytes(Address address, std::size_t count, bool is_ours) {
  const std::span<const std::uint8_t> bytes = array_at<std::uint8_t>(address, count);
  const Result<bool> with_prev = stores_prev(bytes);
  if (!with_prev) return failure(with_prev.error());
  NewMesh mesh(with_prev.value());
  if (!mesh) return failure(no_room_for_a_mesh());
  const BytesFrom from = is_ours ? BytesFrom::kThisProgram : BytesFrom::kAnywhere;
  const Result<void> done = from_bytes(bytes, *mesh, from);
  if (!done) return failure(done.error());
  return success("mesh", val(mesh.release()));
}

}  // namespace

HALFEDGE_EXPORT int check_append(Address mesh, Address other) {
  if (!Reserve::take_back()) return kNoRoom;
  return answer(halfedge::check_append(mesh_at(mesh), mesh_at(other)));
}

HALFEDGE_EXPORT int check_dual(Address mesh) {
  if (!Reserve::take_back()) return kNoRoom;
  return answer(halfedge::check_dual(mesh_at(mesh)));
}

EMSCRIPTEN_BINDINGS(halfedge_making) {
  using emscripten::function;

  function("shape", &shape);
  function("dual", &dual_of);
  function("append", &append_mesh);
  function("extract", &extract_part);
  function("toBytes", &mesh_to_bytes);
  function("fromBytes", &mesh_from_bytes);
}
