#pragma once

#include <halfedge/connectivity/links.h>

namespace halfedge {

/// Which links a mesh type stores, beside next and to_vertex, which every mesh has, and opposite
/// and edge, which cost nothing. By default all of them; each one left out saves memory:
///
///   link              bytes a vertex   when left out
///   prev                     24        prev(h) searches, O(min(degree, valence))
///   face                     24        no faces of halfedges, so no boundary either
///   face_halfedge             8        face circulators need a start halfedge
///   vertex_halfedge           4        vertex circulators need a start halfedge
///
/// (of a closed triangle mesh, which has six halfedges and two faces to a vertex). A call that
/// needs a link that is left out doesn't compile; the compiler says which link in one sentence.
struct Storage {
  bool prev = true;
  bool face = true;
  bool face_halfedge = true;
  bool vertex_halfedge = true;
  /// Whether prev is stored is chosen while the program runs, by `choose_prev`, and not by the
  /// type: for bindings, which compile everything once. Every use of prev then costs a test.
  bool prev_at_run_time = false;

  friend constexpr bool operator==(const Storage&, const Storage&) = default;
};

inline constexpr Storage kEverything{};
inline constexpr Storage kWithoutPrev{.prev = false};
inline constexpr Storage kPrevAtRunTime{.prev = false, .prev_at_run_time = true};
inline constexpr Storage kWithoutFaceHalfedges{.face_halfedge = false};
inline constexpr Storage kWithoutFaces{.face = false, .face_halfedge = false};
inline constexpr Storage kWithoutAnchors{.vertex_halfedge = false};
/// next and to_vertex only.
inline constexpr Storage kBareStorage{
    .prev = false, .face = false, .face_halfedge = false, .vertex_halfedge = false};

/// What an algorithm may need of a mesh type, for its `requires` clause.
template <class Mesh>
concept StoresPrev = Mesh::kStorage.prev;
template <class Mesh>
concept StoresFaces = Mesh::kStorage.face;
template <class Mesh>
concept StoresFaceHalfedges = Mesh::kStorage.face_halfedge;
template <class Mesh>
concept StoresAnchors = Mesh::kStorage.vertex_halfedge;
/// All but prev, which algorithms do without if they can.
template <class Mesh>
concept StoresSurface = StoresFaces<Mesh> && StoresFaceHalfedges<Mesh> && StoresAnchors<Mesh>;

namespace internal {

/// Whether `each` holds for all arrays by halfedge that are stored; stops at the first that fails.
template <class Each>
bool for_halfedge_arrays(Storage stored, Links& links, const Each& each) {
  return each(links.next) && each(links.to_vertex) && (!stored.prev || each(links.prev)) &&
         (!stored.face || each(links.face));
}

}  // namespace internal

}  // namespace halfedge
