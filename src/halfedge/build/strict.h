#pragma once

#include <halfedge/build/build.h>
#include <halfedge/build/connect.h>
#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>

#include <span>

/// What strict builders share beside connecting: what comes before it, and after.
namespace halfedge {

/// Whether the sizes of the arrays fit together, each face has three corners or more, and all of
/// them are vertices: the pre-condition of connecting.
[[nodiscard]] bool can_be_connected(const Polygons& polygons);

/// kNotManifold if a number isn't finite, kOutOfMemory if there is none.
[[nodiscard]] ConnectResult copy_positions(std::span<const float> from, Array<float>& to);

/// Writes down why a build ended as it did, unless it is kDone; returns whether it is.
[[nodiscard]] bool explain(ConnectResult result, const Polygons& polygons, BuildReport& report);

}  // namespace halfedge
