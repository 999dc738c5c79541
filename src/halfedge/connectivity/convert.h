#pragma once

#include <halfedge/connectivity/connectivity.h>
#include <halfedge/mesh.h>
#include <halfedge/result.h>

#include <cstddef>
#include <utility>

namespace halfedge {

/// What `convert` is made of: the parts that don't depend on the types.
class LinkConversion {
 public:
  /// Makes the arrays that `want` has and `have` hasn't, in `derived`. `faces` is how many there
  /// are; where no link knew any, each loop becomes a face, and they are counted.
  [[nodiscard]] static Result<void> derive(const Links& links, Storage have, Storage want,
                                           Index vertices, Index& faces, Links& derived);

  template <Storage kFrom, Storage kTo>
  [[nodiscard]] static Result<void> run(BasicConnectivity<kFrom>& from,
                                        BasicConnectivity<kTo>& to) {
    if constexpr (kFrom == kTo) {
      if (&from == &to) return {};
    }
    if (!kTo.vertex_halfedge && from.free_vertices_.count > 0) return has_deleted("vertices");
    if (!kTo.face_halfedge && from.free_faces_.count > 0) return has_deleted("faces");
    const Index vertices = from.vertex_slots();
    Index faces = from.face_slots();
    Links derived;
    if (Result<void> done =
            derive(from.links_, from.storage(), to.storage(), vertices, faces, derived);
        !done) {
      return done;
    }
    // So that nothing can fail once links have moved.
    if ((kTo.face || kTo.face_halfedge) && !from.attributes_.reserve(ItemKind::kFace, faces)) {
      return no_memory_for("attributes of faces");
    }
    const auto take = [](bool wanted, bool stored, Array<Index>& link, Array<Index>& made) {
      return wanted ? std::move(stored ? link : made) : Array<Index>{};
    };
    Links& links = from.links_;
    to.links_.next = std::move(links.next);
    to.links_.to_vertex = std::move(links.to_vertex);
    to.links_.prev = take(to.stores_prev(), from.stores_prev(), links.prev, derived.prev);
    to.links_.face = take(kTo.face, kFrom.face, links.face, derived.face);
    to.links_.vertex_halfedge = take(kTo.vertex_halfedge, kFrom.vertex_halfedge,
                                     links.vertex_halfedge, derived.vertex_halfedge);
    to.links_.face_halfedge =
        take(kTo.face_halfedge, kFrom.face_halfedge, links.face_halfedge, derived.face_halfedge);
    to.free_vertices_ = from.free_vertices_;
    to.free_edges_ = from.free_edges_;
    to.free_faces_ = from.free_faces_;
    to.bare_vertices_ = kTo.vertex_halfedge ? 0 : vertices;
    to.bare_faces_ = kTo.face_halfedge || !kTo.face ? 0 : faces;
    to.attributes_ = std::move(from.attributes_);
    (void)to.fit_attributes();
    to.forget_history();
    ++to.version_;
    links = Links{};
    from.clear();
    return {};
  }

  /// Exchanges the columns of two meshes without items.
  template <Storage kOne, Storage kOther>
  static void exchange_attributes(BasicConnectivity<kOne>& one, BasicConnectivity<kOther>& other) {
    std::swap(one.attributes_, other.attributes_);
  }

 private:
  [[nodiscard]] static Error has_deleted(const char* items);
};

/// Moves a mesh into a type that stores other links. Those that `to` doesn't store are freed, those
/// that only `to` stores are derived; the others are handed over, not copied. Vertices, edges and
/// faces keep their indices, deleted ones included; `from` is empty afterwards. After an error
/// both are as before. Attributes come along, those of faces where `to` has slots for faces.
///
/// What is derived: prev from next. Anchors as the builder chooses them, as far as faces are known
/// (a boundary halfedge, the one to the smallest vertex; else that in the face of highest index;
/// else that of lowest index). The halfedge of a face: its one of lowest index. Faces: the loops
/// that a face names; where there is no link of faces at all, each loop becomes one, in the order
/// of their halfedges, so that the surface is closed.
///
/// Links that break the invariants are not followed out of their arrays, so `validate` may be asked
/// about the result.
/// cost: O(slots), only for what is derived
/// errors: out-of-memory; deleted-item, where `to` can't mark deleted vertices or faces: compact it
template <Storage kFrom, Storage kTo>
[[nodiscard]] Result<void> convert(BasicConnectivity<kFrom>&& from, BasicConnectivity<kTo>& to) {
  return LinkConversion::run(from, to);
}

/// The same with positions: dropped where `to` has none, and at the origin where `from` had none.
template <Storage kFrom, Storage kTo>
[[nodiscard]] Result<void> convert(BasicMesh<kFrom>&& from, BasicMesh<kTo>& to) {
  Array<float> positions = std::move(from.mutable_positions());
  Result<void> done = LinkConversion::run(from, to);
  (done ? to.mutable_positions() : from.mutable_positions()) = std::move(positions);
  return done;
}
template <Storage kFrom, Storage kTo>
[[nodiscard]] Result<void> convert(BasicMesh<kFrom>&& from, BasicConnectivity<kTo>& to) {
  Result<void> done = LinkConversion::run(from, to);
  if (done) from.mutable_positions().clear();
  return done;
}
template <Storage kFrom, Storage kTo>
[[nodiscard]] Result<void> convert(BasicConnectivity<kFrom>&& from, BasicMesh<kTo>& to) {
  Array<float> origins;
  if (!origins.resize(3 * std::size_t{from.vertex_slots()}, 0.0F)) {
    return no_memory_for("positions");
  }
  Result<void> done = LinkConversion::run(from, to);
  if (done) to.mutable_positions() = std::move(origins);
  return done;
}

/// Makes `mesh` what `build` makes of a full mesh, which has its attributes: all links are made,
/// and those too many freed. Where `build` returns false, `mesh` is left empty, with its
/// attributes.
template <Storage kStored, class Build>
[[nodiscard]] bool build_whole(BasicMesh<kStored>& mesh, const Build& build) {
  Mesh whole;
  mesh.clear();
  LinkConversion::exchange_attributes(mesh, whole);
  if (build(whole)) return bool(convert(std::move(whole), mesh));  // nothing to derive: can't fail
  LinkConversion::exchange_attributes(mesh, whole);
  return false;
}

}  // namespace halfedge
