#pragma once

#include <halfedge/mend/report.h>
#include <halfedge/mend/surface.h>

#include <cstddef>

namespace halfedge::mend {

/// Which boundary edges lie together, end to end. Two that do and run opposite ways are partners.
/// More than two are a group: of those, who belongs to whom is told by what is glued around them.
class Partners {
 public:
  struct Pair {
    Halfedge h;
    Halfedge g;
  };

  explicit Partners(const Surface& surface) : surface_(surface) {}

  /// Finds them: ends closer than `tolerance` lie together. What runs the same way is left in
  /// `report`. False when memory is exhausted. O(n log n) of n boundary edges
  [[nodiscard]] bool find(double tolerance, Report& report);

  /// The boundary halfedges that there were, of edges with a face.
  [[nodiscard]] const Array<Halfedge>& boundary() const { return boundary_; }

  /// The partner of `h`, or empty.
  [[nodiscard]] Halfedge of(Halfedge h) const {
    const Index partner = partner_[h.index()];
    return partner == kNone || (partner & kGroup) != 0 ? Halfedge{} : Halfedge(partner);
  }
  [[nodiscard]] bool are(Halfedge h, Halfedge g) const { return of(h) == g && g.valid(); }
  /// Whether they are of one group and run opposite ways.
  [[nodiscard]] bool are_in_group(Halfedge h, Halfedge g) const {
    return group_size(h) > 0 && h != g && partner_[h.index()] == partner_[g.index()] &&
           place(surface_.from_vertex(h)) != place(surface_.from_vertex(g));
  }
  /// How many lie together with `h`, itself included; 0 if it is in no group.
  [[nodiscard]] std::size_t group_size(Halfedge h) const {
    const Index group = partner_[h.index()];
    return group == kNone || (group & kGroup) == 0 ? 0 : groups_[group & ~kGroup];
  }

  /// These two are glued: they are nobody's partners any more.
  void forget(Halfedge h, Halfedge g);
  /// Of groups that two are left of, these are partners now: adds them to `pairs`, or leaves them
  /// in `report`. False when memory is exhausted.
  [[nodiscard]] bool pair_up(Array<Pair>& pairs, Report& report);

 private:
  /// A boundary edge by the places of its ends, in the bucket of the lower one.
  struct Record {
    Index higher;
    Halfedge h;
  };
  /// What a partner is for the edges of a group.
  static constexpr Index kGroup = 0x8000'0000;

  [[nodiscard]] Index place(Vertex v) const { return place_of_[v.index()]; }
  [[nodiscard]] bool list_boundary(double tolerance);
  [[nodiscard]] bool match(Report& report);
  [[nodiscard]] bool match_group(const Record* group, std::size_t count, Report& report);
  bool join(Halfedge h, Halfedge g, Report& report);

  const Surface& surface_;
  Array<Halfedge> boundary_;
  Array<Index> place_of_;  // by vertex: of those on the boundary
  std::size_t places_ = 0;
  Array<Index> partner_;       // by halfedge: the one to be glued to, or its group
  Array<std::size_t> groups_;  // how many lie together
};

}  // namespace halfedge::mend
