#pragma once

#include <halfedge/decorator/edit.h>
#include <halfedge/operations/refusals.h>

/// What all operations share. They are templates over the mesh type, and need what a surface is
/// known by; prev may be left out.
namespace halfedge::operations {

template <class Mesh>
concept EditableSurface = StoresSurface<Mesh> && decorator::Editable<Mesh>;

using steps::check_live;

}  // namespace halfedge::operations
