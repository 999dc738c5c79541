#pragma once

#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/handle.h>

#include <type_traits>

namespace halfedge {

/// Loops over faces are written once for any size; for triangles the size is a constant.
using Three = std::integral_constant<Index, 3>;

/// Calls `visit(face, its corners, their number)` for each face.
template <bool kTriangles, class Visit>
void for_each_face(const Polygons& polygons, const Visit& visit) {
  const Index* corners = polygons.corners.data();
  const Index count = Index(polygons.face_count());
  for (Index f = 0; f < count; ++f) {
    if constexpr (kTriangles) {
      visit(f, corners, Three{});
      corners += 3;
    } else {
      const Index size = polygons.sizes[f];
      visit(f, corners, size);
      corners += size;
    }
  }
}

}  // namespace halfedge
