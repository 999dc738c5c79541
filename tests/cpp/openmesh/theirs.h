#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <utility>

#include "support/sweep.h"

namespace halfedge::test {

/// OpenMesh says on its log stream what it also returns.
class QuietLog {
 public:
  QuietLog() { omerr().disable(); }
  ~QuietLog() { omerr().enable(); }
  QuietLog(const QuietLog&) = delete;
  QuietLog& operator=(const QuietLog&) = delete;
};

/// As polys_of, of a mesh of OpenMesh: the faces that are left.
template <class Theirs>
Polys their_polys(const Theirs& mesh) {
  Polys faces;
  for (const auto f : mesh.faces()) {
    faces.emplace_back();
    for (const auto v : mesh.fv_range(f)) faces.back().push_back(Index(v.idx()));
  }
  return in_order(std::move(faces));
}

}  // namespace halfedge::test
