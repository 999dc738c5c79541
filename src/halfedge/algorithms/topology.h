#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/connectivity.h>
#include <halfedge/result.h>

#include <cstdint>

/// Numbers that don't change when a mesh is bent.
///
/// These functions check what they follow: on a mesh that breaks its invariants they return an
/// error with the code corrupt-connectivity (or false), they don't hang or read out of bounds.
/// All but the first need all links but prev, and are compiled for Connectivity, kWithoutPrev and
/// kPrevAtRunTime: no other mesh type has these links.
/// Those that need memory return an error with the code out-of-memory when there is none.
namespace halfedge {

/// V - E + F over all live items. An isolated vertex counts as a vertex.
template <Storage kStored>
[[nodiscard]] std::int64_t euler_characteristic(const BasicConnectivity<kStored>& mesh) {
  return std::int64_t{mesh.vertex_count()} - mesh.edge_count() + mesh.face_count();
}

/// One halfedge of each boundary loop: its smallest; in index order. cost: O(halfedges)
template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
[[nodiscard]] Result<Array<Halfedge>> boundary_loops(const BasicConnectivity<kStored>& mesh);

/// What one connected component is made of.
struct Component {
  Index vertices = 0;
  Index edges = 0;
  Index faces = 0;
  Index boundary_loops = 0;

  [[nodiscard]] std::int64_t euler_characteristic() const {
    return std::int64_t{vertices} - edges + faces;
  }
  /// The number of handles: V - E + F = 2 - 2 genus - boundary loops. 0 for a disk, an annulus and
  /// a sphere, 1 for a torus, punctured or not. Where fans meet at a pinched vertex they count as
  /// joined in their order around it, as boundary loops run.
  [[nodiscard]] std::int64_t genus() const {
    return (2 - euler_characteristic() - boundary_loops) / 2;
  }
};

/// The connected components, numbered by their smallest vertex.
struct Components {
  Array<Component> list;
  /// By vertex slot and by face slot: the component; kNone for what is deleted and for isolated
  /// vertices, which belong to no surface.
  Array<Index> of_vertex;
  Array<Index> of_face;
};

/// Faces and edges are connected where they share a vertex, so that the fans of a pinched vertex
/// lie in one component. cost: O(slots), nearly
template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
[[nodiscard]] Result<Components> connected_components(const BasicConnectivity<kStored>& mesh);

/// The sum of the genera of all components.
template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
[[nodiscard]] Result<std::int64_t> genus(const BasicConnectivity<kStored>& mesh);

/// Whether no halfedge is a boundary halfedge. True of a mesh without edges.
template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
[[nodiscard]] bool is_closed(const BasicConnectivity<kStored>& mesh);

/// Whether all faces have three, or four, corners. True of a mesh without faces.
template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
[[nodiscard]] bool is_triangle_mesh(const BasicConnectivity<kStored>& mesh);
template <Storage kStored>
requires StoresSurface<BasicConnectivity<kStored>>
[[nodiscard]] bool is_quad_mesh(const BasicConnectivity<kStored>& mesh);

}  // namespace halfedge
