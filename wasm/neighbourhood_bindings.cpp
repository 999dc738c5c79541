// What lies around items. See the design in bindings.cpp.

#include <halfedge/algorithms/adjacency.h>
#include <halfedge/algorithms/neighbourhood.h>

#include "bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

namespace {

val to_rows(Adjacency& rows) {
  val result = success("offsets", hand_over(rows.offsets));
  result.set("items", hand_over(rows.items));
  return result;
}

/// `ring` and `direction` are values of Ring and Direction.
val all_rings(Address mesh, int ring, int direction) {
  Adjacency rows;
  const Result<void> result =
      adjacency(mesh_at(mesh), static_cast<Ring>(ring), static_cast<Direction>(direction), rows);
  return result ? to_rows(rows) : failure(result.error());
}

val some_rings(Address mesh, int ring, int direction, Address centres, std::size_t count) {
  Adjacency rows;
  const Result<void> result =
      adjacency(mesh_at(mesh), static_cast<Ring>(ring), static_cast<Direction>(direction),
                array_at<Index>(centres, count), rows);
  return result ? to_rows(rows) : failure(result.error());
}

val rows_by_distance(Address mesh, Address vertices, std::size_t count, Index k) {
  Result<Adjacency> rows = k_ring(mesh_at(mesh), array_at<Index>(vertices, count), k);
  return rows ? to_rows(rows.value()) : failure(rows.error());
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

  function("allRings", &all_rings);
  function("someRings", &some_rings);
  function("kRing", &rows_by_distance);
  function("surroundings", &items_around);
}
