#pragma once

#include <halfedge/connectivity/connectivity.h>
#include <halfedge/result.h>

namespace halfedge {

/// Whether the halfedge arrays are equally long and hold whole edges, so that an index below
/// halfedge_slots() is in range in each of them. For code that takes nothing else for granted.
template <Storage kStored>
[[nodiscard]] Result<void> check_array_sizes(const BasicConnectivity<kStored>& mesh) {
  const Links& links = mesh.links();
  const std::size_t size = links.next.size();
  if (size % 2 == 0 && links.prev.size() == (mesh.stores_prev() ? size : 0) &&
      links.to_vertex.size() == size && links.face.size() == (kStored.face ? size : 0)) {
    return {};
  }
  return Error{"corrupt-connectivity",
               "The halfedge arrays differ in length: validate names them."};
}

}  // namespace halfedge
