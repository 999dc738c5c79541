#pragma once

#include <halfedge/mesh.h>

namespace halfedge::fuzz {

/// Expects that the mesh can be written in each form of each format, and that reading that file
/// gives the same polygons and the same bits. pre: no deleted slots, positions are finite
void expect_round_trips(const Mesh& mesh);

}  // namespace halfedge::fuzz
