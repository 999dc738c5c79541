#pragma once

/// What a mesh measures: templates over every mesh type with positions and the links that they
/// walk, which their `requires` clauses name; prev isn't among them.
///
/// - All is computed in double precision, from the float positions, as seen from a corner: far from
///   the origin nothing is lost. Angles are in radians.
/// - Of an item, nothing is allocated or checked. pre: it is live, the links hold their invariants.
/// - Positions that are no numbers make measures that are none, but where something else is said.
#include <halfedge/geometry/angles.h>
#include <halfedge/geometry/measures.h>
#include <halfedge/geometry/normals.h>
