#pragma once

#include <halfedge/connectivity/connectivity.h>
#include <halfedge/mesh.h>
#include <halfedge/refusals.h>
#include <halfedge/steps.h>

#include <type_traits>

namespace halfedge::decorator {

/// A mesh type whose faces, if it knows any, are known to its halfedges; not a const one.
template <class Mesh>
concept Editable =
    !std::is_const_v<Mesh> &&
    (StoresFaces<Mesh> || !StoresFaceHalfedges<Mesh>)&&requires(Mesh & mesh, Halfedge h) {
  mesh.link(h, h);
};
/// A mesh type that can delete faces: one that stores a halfedge of each, or none at all.
template <class Mesh>
concept DeletesFaces = !StoresFaces<Mesh> || StoresFaceHalfedges<Mesh>;
/// A mesh type that can delete vertices: the anchor marks the slot as free.
template <class Mesh>
concept DeletesVertices = StoresAnchors<Mesh>;

/// What all of this folder is written with.
namespace internal {
using namespace refusals;
using namespace steps;
}  // namespace internal

}  // namespace halfedge::decorator
