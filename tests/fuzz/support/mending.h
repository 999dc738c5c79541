#pragma once

#include <halfedge/mend/mend.h>

#include <cstdint>

namespace halfedge::fuzz {

/// The kinds of repairs that `mend_one` has.
constexpr std::uint8_t kRepairs = 6;

/// One repair of a mesh, with any options.
template <class AMesh>
[[nodiscard]] Result<mend::Report> mend_one(AMesh& mesh, std::uint8_t which, std::uint8_t option) {
  constexpr double kTolerances[] = {0, 0.011, 1.5, 1e30};
  const double tolerance = kTolerances[option % 4];
  switch (which % kRepairs) {
    case 0:
      return mend::stitch_boundaries(mesh, {.tolerance = tolerance});
    case 1:
      return mend::split_pinched_vertices(mesh);
    case 2:
      return mend::orient_outward(mesh, {.open = option % 2 == 1, .nested = option % 4 > 1});
    case 3:
      return mend::drop_small_components(
          mesh, {.faces = Index(option % 4), .area = option / 4 % 4 * 0.3, .diagonal = 0});
    case 4:
      return mend::remove_degenerate_faces(mesh, {.tolerance = tolerance});
    default:
      return mend::fill_holes(mesh,
                              {.max_edges = option % 16U + 2, .max_angle = option / 16 * 12.0});
  }
}

}  // namespace halfedge::fuzz
