// Questions about the surface and about what lies around items. See the design in bindings.cpp.

#include <halfedge/algorithms/neighbourhood.h>
#include <halfedge/algorithms/topology.h>

#include "bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

namespace {

bool closed(Address mesh) { return is_closed(mesh_at(mesh)); }

/// Whether all faces have three, or else four, corners.
bool only_triangles_or_quads(Address mesh, bool triangles) {
  return triangles ? is_triangle_mesh(mesh_at(mesh)) : is_quad_mesh(mesh_at(mesh));
}

val rows_by_distance(Address mesh, Address vertices, std::size_t count, Index k) {
  Result<Adjacency> rows = k_ring(mesh_at(mesh), array_at<Index>(vertices, count), k);
  if (!rows) return failure(rows.error());
  val result = success("offsets", hand_over(rows.value().offsets));
  result.set("items", hand_over(rows.value().items));
  return result;
}

/// `which` is a value of Surroundings.
val items_around(Address mesh, int which, Address vertices, std::size_t vertex_count, Address edges,
                 std::size_t edge_count, Address faces, std::size_t face_count) {
  const Items items{array_at<Index>(vertices, vertex_count), array_at<Index>(edges, edge_count),
                    array_at<Index>(faces, face_count)};
  const AnyMesh& m = mesh_at(mesh);
  if (Result<void> sizes = check_array_sizes(m); !sizes) return failure(sizes.error());
  Result<ItemSet> set = surroundings(RawLinks(m), static_cast<Surroundings>(which), items);
  if (!set) return failure(set.error());
  val result = success("vertices", hand_over(set.value().vertices));
  result.set("edges", hand_over(set.value().edges));
  result.set("faces", hand_over(set.value().faces));
  return result;
}

}  // namespace

EMSCRIPTEN_BINDINGS(halfedge_neighbourhood) {
  using emscripten::function;

  function("isClosed", &closed);
  function("onlyTrianglesOrQuads", &only_triangles_or_quads);
  function("kRing", &rows_by_distance);
  function("surroundings", &items_around);
}
