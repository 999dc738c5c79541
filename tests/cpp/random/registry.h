#pragma once

#include "random/operation.h"

/// The operations, by group: one source file each, because they are templates.
namespace halfedge::test {

void add_face_operations(Operations& all);
void add_seam_operations(Operations& all);
void add_form_operations(Operations& all);
void add_mesh_operations(Operations& all);
void add_euler_operations(Operations& all);

}  // namespace halfedge::test
