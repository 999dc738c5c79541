#pragma once

#include <halfedge/mesh.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace halfedge::test {

using TheirMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

/// Compares our mesh with OpenMesh's of the same polygons, added in the same order: every link,
/// every boundary flag, every circulator in both directions with its start. Halfedges are matched
/// by their ends, since edges are numbered differently.
///
/// Where several fans meet at a vertex, OpenMesh joins them in an order that depends on insertion;
/// there, and only there, fans are compared as a set.
class Comparison {
 public:
  Comparison(const Mesh& ours, TheirMesh& theirs) : ours_(ours), theirs_(theirs) {}

  /// The first difference, or an empty string.
  [[nodiscard]] std::string run() {
    if (!match_halfedges()) return difference_;
    for (const Halfedge h : ours_.halfedges()) {
      if (!compare_links(h) || !compare_loops(h) || !compare_explicit_starts(h)) return difference_;
    }
    for (const Edge e : ours_.edges()) {
      if (!compare_edge(e)) return difference_;
    }
    for (const Vertex v : ours_.vertices()) {
      if (ours_.is_isolated(v)) continue;  // OpenMesh 9 reads out of bounds there
      if (ours_.is_manifold(v) ? !compare_vertex(v) : !compare_fans(v)) return difference_;
    }
    for (const Face f : ours_.faces()) {
      if (!compare_face(f)) return difference_;
    }
    return {};
  }

  [[nodiscard]] std::size_t pinched_vertices() const { return pinched_vertices_; }

 private:
  using Items = std::vector<Index>;

  // ---- matching -----------------------------------------------------------------------------

  bool match_halfedges() {
    if (!same("vertices", ours_.vertex_count(), theirs_.n_vertices()) ||
        !same("edges", ours_.edge_count(), theirs_.n_edges()) ||
        !same("faces", ours_.face_count(), theirs_.n_faces())) {
      return false;
    }
    std::vector<std::array<Index, 3>> by_ends;
    for (Index h = 0; h < theirs_.n_halfedges(); ++h) {
      const OpenMesh::HalfedgeHandle handle{int(h)};
      by_ends.push_back({Index(theirs_.from_vertex_handle(handle).idx()),
                         Index(theirs_.to_vertex_handle(handle).idx()), h});
    }
    std::sort(by_ends.begin(), by_ends.end());
    their_halfedge_.assign(ours_.halfedge_slots(), kNone);
    our_halfedge_.assign(theirs_.n_halfedges(), kNone);
    for (const Halfedge h : ours_.halfedges()) {
      const std::array<Index, 3> key = {ours_.from_vertex(h).index(), ours_.to_vertex(h).index(),
                                        0};
      const auto found = std::lower_bound(by_ends.begin(), by_ends.end(), key);
      if (found == by_ends.end() || (*found)[0] != key[0] || (*found)[1] != key[1]) {
        return same("halfedge by its ends", h.index(), kNone);
      }
      their_halfedge_[h.index()] = (*found)[2];
      our_halfedge_[(*found)[2]] = h.index();
    }
    return std::find(our_halfedge_.begin(), our_halfedge_.end(), kNone) == our_halfedge_.end() ||
           same("unmatched halfedges of theirs", 0, 1);
  }

  [[nodiscard]] OpenMesh::HalfedgeHandle their(Halfedge h) const {
    return OpenMesh::HalfedgeHandle(int(their_halfedge_[h.index()]));
  }
  [[nodiscard]] static OpenMesh::VertexHandle their(Vertex v) {
    return OpenMesh::VertexHandle(int(v.index()));
  }
  [[nodiscard]] static OpenMesh::FaceHandle their(Face f) {
    return OpenMesh::FaceHandle(int(f.index()));
  }

  // An item of theirs as ours.
  [[nodiscard]] Index translated(OpenMesh::HalfedgeHandle h) const {
    return h.is_valid() ? our_halfedge_[std::size_t(h.idx())] : kNone;
  }
  [[nodiscard]] Index translated(OpenMesh::EdgeHandle e) const {
    return translated(theirs_.halfedge_handle(e, 0)) / 2;
  }
  [[nodiscard]] static Index translated(OpenMesh::VertexHandle v) { return Index(v.idx()); }
  [[nodiscard]] static Index translated(OpenMesh::FaceHandle f) { return Index(f.idx()); }

  // ---- collecting ---------------------------------------------------------------------------

  template <class Range>
  [[nodiscard]] std::span<const Index> collect(const Range& range) {
    ours_listed_.clear();
    for (const auto item : range) ours_listed_.push_back(item.index());
    return ours_listed_;
  }
  template <class Range>
  [[nodiscard]] std::span<const Index> collect_theirs(const Range& range) {
    theirs_listed_.clear();
    for (auto item = range.begin(); item != range.end(); ++item) {
      theirs_listed_.push_back(translated(*item));
      // OpenMesh's ranges of a broken mesh have no end.
      if (theirs_listed_.size() > theirs_.n_halfedges()) break;
    }
    return theirs_listed_;
  }

  static std::string text(std::span<const Index> items) {
    std::string text;
    for (const Index item : items) text += " " + std::to_string(item);
    return text;
  }

  bool same(const std::string& what, Index ours, std::size_t theirs) {
    if (ours == Index(theirs)) return true;
    difference_ = what + ": ours " + std::to_string(ours) + ", theirs " + std::to_string(theirs);
    return false;
  }

  template <class OurRange, class TheirRange>
  bool same_items(const char* kind, Index item, const OurRange& ours, const TheirRange& theirs) {
    const std::span<const Index> a = collect(ours);
    const std::span<const Index> b = collect_theirs(theirs);
    if (std::equal(a.begin(), a.end(), b.begin(), b.end())) return true;
    difference_ = std::string(kind) + " of " + std::to_string(item) + ": ours" + text(a) +
                  ", theirs" + text(b);
    return false;
  }

  // ---- comparing ----------------------------------------------------------------------------

  bool compare_links(Halfedge h) {
    const auto t = their(h);
    const std::string of = " of halfedge " + std::to_string(h.index());
    // The boundary halfedge that follows at a pinched vertex is a matter of insertion.
    const bool free_next = ours_.is_boundary(h) && !ours_.is_manifold(ours_.to_vertex(h));
    const bool free_prev = ours_.is_boundary(h) && !ours_.is_manifold(ours_.from_vertex(h));
    return same("to" + of, ours_.to_vertex(h).index(), translated(theirs_.to_vertex_handle(t))) &&
           same("from" + of, ours_.from_vertex(h).index(),
                translated(theirs_.from_vertex_handle(t))) &&
           same("opposite" + of, ours_.opposite(h).index(),
                translated(theirs_.opposite_halfedge_handle(t))) &&
           same("face" + of, ours_.face(h).index(), translated(theirs_.face_handle(t))) &&
           same("boundary" + of, ours_.is_boundary(h), theirs_.is_boundary(t)) &&
           (free_next || same("next" + of, ours_.next(h).index(),
                              translated(theirs_.next_halfedge_handle(t)))) &&
           (free_prev ||
            same("prev" + of, ours_.prev(h).index(), translated(theirs_.prev_halfedge_handle(t))));
  }

  // Each boundary loop once and each face loop from each of its halfedges.
  bool compare_loops(Halfedge h) {
    if (ours_.is_boundary(h)) {
      bool first = true;
      bool pinched = false;
      for (const Halfedge on_loop : ours_.loop_ccw(h)) {
        first = first && h <= on_loop;
        pinched = pinched || !ours_.is_manifold(ours_.to_vertex(on_loop));
        if (!first || pinched) return true;
      }
    }
    const auto t = their(h);
    return same_items("loop ccw", h.index(), ours_.loop_ccw(h), theirs_.hl_ccw_range(t)) &&
           same_items("loop cw", h.index(), ours_.loop_cw(h), theirs_.hl_cw_range(t));
  }

  bool compare_explicit_starts(Halfedge h) {
    const Vertex v = ours_.from_vertex(h);
    if (!ours_.is_manifold(v)) return true;
    const auto t = their(h);
    const auto arriving = theirs_.opposite_halfedge_handle(t);
    return same_items("outgoing cw from", h.index(), ours_.outgoing_cw(v, h),
                      theirs_.voh_cw_range(t)) &&
           same_items("outgoing ccw from", h.index(), ours_.outgoing_ccw(v, h),
                      theirs_.voh_ccw_range(t)) &&
           same_items("incoming cw from", h.index(), ours_.incoming_cw(v, h),
                      theirs_.vih_cw_range(arriving)) &&
           same_items("incoming ccw from", h.index(), ours_.incoming_ccw(v, h),
                      theirs_.vih_ccw_range(arriving));
  }

  // OpenMesh 9 has no circulators around an edge; its sides may be the other way round.
  bool compare_edge(Edge e) {
    const Halfedge h = ours_.edge_halfedge(e, 0);
    const auto t = theirs_.edge_handle(their(h));
    const Index side = translated(theirs_.halfedge_handle(t, 0)) == h.index() ? 0 : 1;
    Items vertices;
    Items halfedges;
    Items faces;
    for (const Index i : {side, 1 - side}) {
      const auto on_side = theirs_.halfedge_handle(t, i);
      vertices.push_back(translated(theirs_.to_vertex_handle(on_side)));
      halfedges.push_back(translated(on_side));
      if (!theirs_.is_boundary(on_side)) faces.push_back(translated(theirs_.face_handle(on_side)));
    }
    const auto equal = [&](const char* kind, const auto& range, const Items& items) {
      const std::span<const Index> listed = collect(range);
      if (std::equal(listed.begin(), listed.end(), items.begin(), items.end())) return true;
      difference_ = std::string(kind) + " of edge " + std::to_string(e.index());
      return false;
    };
    return equal("vertices", ours_.edge_vertices(e), vertices) &&
           equal("halfedges", ours_.edge_halfedges(e), halfedges) &&
           equal("faces", ours_.edge_faces(e), faces) &&
           same("boundary of edge " + std::to_string(e.index()), ours_.is_boundary(e),
                theirs_.is_boundary(t));
  }

  bool compare_vertex(Vertex v) {
    const auto t = their(v);
    const Index i = v.index();
    const std::string of = " of vertex " + std::to_string(i);
    return same("anchor" + of, ours_.vertex_halfedge(v).index(),
                translated(theirs_.halfedge_handle(t))) &&
           same("boundary" + of, ours_.is_boundary(v), theirs_.is_boundary(t)) &&
           same("manifold" + of, ours_.is_manifold(v), theirs_.is_manifold(t)) &&
           same("valence" + of, ours_.valence(v), theirs_.valence(t)) &&
           same_items("vertices cw", i, ours_.vertex_vertices_cw(v), theirs_.vv_cw_range(t)) &&
           same_items("vertices ccw", i, ours_.vertex_vertices_ccw(v), theirs_.vv_ccw_range(t)) &&
           same_items("outgoing cw", i, ours_.outgoing_cw(v), theirs_.voh_cw_range(t)) &&
           same_items("outgoing ccw", i, ours_.outgoing_ccw(v), theirs_.voh_ccw_range(t)) &&
           same_items("incoming cw", i, ours_.incoming_cw(v), theirs_.vih_cw_range(t)) &&
           same_items("incoming ccw", i, ours_.incoming_ccw(v), theirs_.vih_ccw_range(t)) &&
           same_items("edges cw", i, ours_.vertex_edges_cw(v), theirs_.ve_cw_range(t)) &&
           same_items("edges ccw", i, ours_.vertex_edges_ccw(v), theirs_.ve_ccw_range(t)) &&
           same_items("faces cw", i, ours_.vertex_faces_cw(v), theirs_.vf_cw_range(t)) &&
           same_items("faces ccw", i, ours_.vertex_faces_ccw(v), theirs_.vf_ccw_range(t));
  }

  // The fans at a pinched vertex, each from its boundary halfedge on clockwise.
  [[nodiscard]] std::vector<Items> fans(std::span<const Index> outgoing) const {
    std::vector<Items> fans;
    for (const Index h : outgoing) {
      if (fans.empty() || ours_.is_boundary(Halfedge(h))) fans.emplace_back();
      fans.back().push_back(h);
    }
    std::sort(fans.begin(), fans.end());
    return fans;
  }

  bool compare_fans(Vertex v) {
    ++pinched_vertices_;
    const auto t = their(v);
    const std::string of = " of vertex " + std::to_string(v.index());
    const std::vector<Items> ours = fans(collect(ours_.outgoing_cw(v)));
    const std::vector<Items> theirs = fans(collect_theirs(theirs_.voh_cw_range(t)));
    if (ours != theirs) {
      difference_ = "fans" + of;
      return false;
    }
    return same("boundary" + of, ours_.is_boundary(v), theirs_.is_boundary(t)) &&
           same("boundary anchor" + of, true, theirs_.is_boundary(theirs_.halfedge_handle(t))) &&
           same("manifold" + of, false, theirs_.is_manifold(t)) &&
           same("valence" + of, ours_.valence(v), theirs_.valence(t));
  }

  bool compare_face(Face f) {
    const auto t = their(f);
    const Index i = f.index();
    const std::string of = " of face " + std::to_string(i);
    return same("first halfedge" + of, ours_.face_halfedge(f).index(),
                translated(theirs_.halfedge_handle(t))) &&
           same("boundary" + of, ours_.is_boundary(f), theirs_.is_boundary(t)) &&
           same("degree" + of, ours_.degree(f), theirs_.valence(t)) &&
           same_items("vertices ccw", i, ours_.face_vertices_ccw(f), theirs_.fv_ccw_range(t)) &&
           same_items("vertices cw", i, ours_.face_vertices_cw(f), theirs_.fv_cw_range(t)) &&
           same_items("halfedges ccw", i, ours_.face_halfedges_ccw(f), theirs_.fh_ccw_range(t)) &&
           same_items("halfedges cw", i, ours_.face_halfedges_cw(f), theirs_.fh_cw_range(t)) &&
           same_items("edges ccw", i, ours_.face_edges_ccw(f), theirs_.fe_ccw_range(t)) &&
           same_items("edges cw", i, ours_.face_edges_cw(f), theirs_.fe_cw_range(t)) &&
           same_items("faces ccw", i, ours_.face_faces_ccw(f), theirs_.ff_ccw_range(t)) &&
           same_items("faces cw", i, ours_.face_faces_cw(f), theirs_.ff_cw_range(t));
  }

  const Mesh& ours_;
  TheirMesh& theirs_;
  Items their_halfedge_;  // by our halfedge
  Items our_halfedge_;    // by their halfedge
  Items ours_listed_;
  Items theirs_listed_;
  std::size_t pinched_vertices_ = 0;
  std::string difference_;
};

}  // namespace halfedge::test
