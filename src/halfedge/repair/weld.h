#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>

#include <cstddef>
#include <optional>
#include <span>

namespace halfedge::repair {

/// The vertices that the input has once coincident ones are joined.
struct Vertices {
  Array<Index> of_input;  // by vertex of the input; kNone if its position isn't finite
  Array<Index> origin;    // a vertex of the input for each

  [[nodiscard]] std::size_t size() const { return origin.size(); }
};

/// Numbers the vertices by their first one in the input. Expected time is linear, and n log n with
/// a tolerance above 0. False when memory is exhausted.
[[nodiscard]] bool weld(std::span<const float> positions, std::optional<double> tolerance,
                        Vertices& out);

}  // namespace halfedge::repair
