#pragma once

#include <halfedge/mend/repairs.h>

#include <cstddef>
#include <span>

namespace halfedge::mend {

/// Collapses edges, where the mesh allows it and no face turns over.
class ShortEdges {
 public:
  ShortEdges(Surface& surface, double tolerance, Report& report)
      : surface_(surface), tolerance_(tolerance), report_(report) {}

  [[nodiscard]] bool is_short(Edge e) const;

  /// Collapses all that are no longer than the tolerance; `left` gets those that stay.
  [[nodiscard]] Result<void> collapse_all(Report& left);

  /// Collapses the edge of `side`: into a vertex on the boundary, if one end is one, else into the
  /// one of higher valence.
  [[nodiscard]] Result<void> collapse(Halfedge side);

  /// The faces that the last collapse moved a corner of, live or not.
  [[nodiscard]] std::span<const Face> moved() const { return moved_.span(); }
  /// How many were collapsed.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  [[nodiscard]] Halfedge best_side(Halfedge side) const;
  [[nodiscard]] bool folds(Halfedge h) const;
  [[nodiscard]] bool list_moved(Halfedge h);

  Surface& surface_;
  double tolerance_;
  Report& report_;
  Array<Face> moved_;
  std::size_t count_ = 0;
};

}  // namespace halfedge::mend
