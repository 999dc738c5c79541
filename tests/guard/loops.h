#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contender.h"

/// One of the main loops of the library, all over a mesh.
struct Loop {
  std::string name;
  /// The loop of the flat baseline it is compared with.
  std::string yardstick;
  std::size_t faces;
  std::function<void()> run;
  /// What is done before, and not counted; empty for nothing.
  std::function<void()> prepare = {};
};

/// Those of the flat baseline; they are their own yardstick, and named after themselves.
[[nodiscard]] std::vector<Loop> flat_loops(const TriangleMesh& natural,
                                           const TriangleMesh& shuffled);

/// All that is compared with them.
[[nodiscard]] std::vector<Loop> guarded_loops(const TriangleMesh& natural,
                                              const TriangleMesh& shuffled);
