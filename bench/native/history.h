#pragma once

#include <string>

#include "meshes.h"

/// A row for each of the common operations, done all over the mesh, a step of history each: off, in
/// milliseconds, and on, as a multiple of that; and to undo and redo all these steps, as well.
void compare_history(const std::string& label, const TriangleMesh& input);
