#pragma once

#include <halfedge/connectivity/handle.h>
#include <halfedge/result.h>

#include <span>

namespace halfedge::operations::internal {

/// A vertex that is listed twice, or an empty handle.
/// cost: O(n log n). errors: out-of-memory
[[nodiscard]] Result<Vertex> find_repeated(std::span<const Vertex> vertices);

}  // namespace halfedge::operations::internal
