// The WebAssembly module of the JavaScript package: the functions of these files, and its memory.
//
// Design. JavaScript walks a mesh by reading its arrays in place, as typed arrays over this memory;
// `layout` says where they lie. What is called here works on a whole mesh, so embind's cost of a
// call doesn't matter, and its conversions are used only for numbers and for the few objects that
// report something. Edits are called per item, without embind: see operation_bindings.h.
//
// - A mesh is named by its address, a number. The wrapper (web/src/links.ts) keeps it to itself,
//   calls `destroyMesh` once, and never passes it on after that. No embind class: no garbage
//   collector ever frees the objects of one.
// - Inputs are copied by JavaScript into memory from `allocate`, and freed by it, whatever happens.
// - Arrays are handed over by address; JavaScript copies and frees them. No embind vectors.
// - Errors are objects. Nothing throws in either direction, so nothing leaks on the way.
//
// The types of this module for TypeScript are in web/src/core.d.ts. No algorithm belongs here.

#include "bindings.h"

#include <halfedge/build/build.h>

#include <new>

namespace {

using namespace halfedge;
using namespace halfedge::bindings;

Address create_mesh(bool stores_prev) { return NewMesh(stores_prev).release(); }

Address clone_mesh(Address address) {
  const AnyMesh& original = mesh_at(address);
  NewMesh copy(original.stores_prev());
  if (!copy || !(*copy).assign(original)) return 0;
  return copy.release();
}

Address layout(Address address) {
  write_layout(mesh_at(address));
  return reinterpret_cast<Address>(layout_words.data());
}

val build(Address positions, std::size_t position_count, Address sizes, std::size_t size_count,
          Address corners, std::size_t corner_count, bool stores_prev) {
  NewMesh mesh(stores_prev);
  if (!mesh) return failure(no_room_for_a_mesh());
  BuildReport report;
  const Polygons polygons{array_at<float>(positions, position_count),
                          array_at<Index>(sizes, size_count),
                          array_at<Index>(corners, corner_count)};
  if (!build_from_polygons(*mesh, polygons, report)) {
    return failure(report.problems, report.problem_count);
  }
  return success("mesh", val(mesh.release()));
}

}  // namespace

EMSCRIPTEN_BINDINGS(halfedge) {
  using emscripten::function;

  std::set_new_handler(&Reserve::on_exhaustion);
  (void)Reserve::take_back();

  function("allocate", &allocate);
  function("free", &free_block);
  function("bytesInUse", &bytes_in_use);

  function("createMesh", &create_mesh);
  function("cloneMesh", &clone_mesh);
  function("destroyMesh", &destroy_mesh);
  function("layout", &layout);
  function("build", &build);
}
