#pragma once

#include <halfedge/mend/surface.h>
#include <halfedge/validate/problem_list.h>

namespace halfedge {

/// Level 5: where the vertices lie. What it calls degenerate, mend::remove_degenerate_faces removes
/// where it can. pre: levels 0 and 1 hold; there are three floats for each vertex slot.
void check_geometry(const mend::SurfaceView& surface, ProblemList& problems);

}  // namespace halfedge
