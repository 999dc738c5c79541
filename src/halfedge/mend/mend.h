#pragma once

#include <halfedge/mend/repairs.h>
#include <halfedge/mend/surface_of.h>
#include <halfedge/mesh.h>

/// The repairs of repairs.h, which tells what they do, for a mesh that stores all links but perhaps
/// prev.
namespace halfedge::mend {

template <Storage kStored>
[[nodiscard]] Result<Report> stitch_boundaries(BasicMesh<kStored>& mesh,
                                               const StitchOptions& options = {}) {
  SurfaceOf<kStored> surface(mesh);
  return stitch_boundaries(static_cast<Surface&>(surface), options);
}

template <Storage kStored>
[[nodiscard]] Result<Report> split_pinched_vertices(BasicMesh<kStored>& mesh) {
  SurfaceOf<kStored> surface(mesh);
  return split_pinched_vertices(static_cast<Surface&>(surface));
}

template <Storage kStored>
[[nodiscard]] Result<Report> orient_outward(BasicMesh<kStored>& mesh,
                                            const OrientOptions& options = {}) {
  SurfaceOf<kStored> surface(mesh);
  return orient_outward(static_cast<Surface&>(surface), options);
}

template <Storage kStored>
[[nodiscard]] Result<Report> drop_small_components(BasicMesh<kStored>& mesh,
                                                   const DropOptions& options) {
  SurfaceOf<kStored> surface(mesh);
  return drop_small_components(static_cast<Surface&>(surface), options);
}

template <Storage kStored>
[[nodiscard]] Result<Report> remove_degenerate_faces(BasicMesh<kStored>& mesh,
                                                     const DegenerateOptions& options = {}) {
  SurfaceOf<kStored> surface(mesh);
  return remove_degenerate_faces(static_cast<Surface&>(surface), options);
}

template <Storage kStored>
[[nodiscard]] Result<Report> fill_holes(BasicMesh<kStored>& mesh, const FillOptions& options = {}) {
  SurfaceOf<kStored> surface(mesh);
  return fill_holes(static_cast<Surface&>(surface), options);
}

}  // namespace halfedge::mend
