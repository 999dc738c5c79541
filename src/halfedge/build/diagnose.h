#pragma once

#include <halfedge/build/build.h>
#include <halfedge/build/polygons.h>
#include <halfedge/connectivity/array.h>

#include <cstddef>
#include <span>

namespace halfedge {

/// A build has failed: fills `report` with everything that keeps these polygons from being an
/// oriented 2-manifold. This is the slow road, taken when the fast one has ended; it shares nothing
/// with it, and leaves the report empty for polygons that can be built.
///
/// cost: O(n log n) for n corners, whatever the input; 24 bytes a corner
void diagnose(const Polygons& polygons, BuildReport& report);

/// Counts every problem, writes down the first ones.
class ProblemSink {
 public:
  explicit ProblemSink(BuildReport& report) : report_(report) {}

  /// `describe` makes the Error; it isn't called once the list is full.
  template <class Describe>
  void add(const Describe& describe) {
    ++report_.problem_count;
    if (report_.problems.size() < BuildReport::kMaxListed) report_.problems.push_back(describe());
  }

 private:
  BuildReport& report_;
};

/// The faces of polygons, by index.
struct FaceTable {
  struct Face {
    Index first = 0;
    Index size = 0;
    /// Wrong by itself or a repeat of another: it takes no part in what is checked after it.
    bool ignored = false;
  };

  std::span<const Index> corners;
  Array<Face> faces;

  [[nodiscard]] std::span<const Index> corners_of(Index f) const {
    return corners.subspan(faces[f].first, faces[f].size);
  }
  [[nodiscard]] Index corner_after(Index c, Index f) const {
    const Face& face = faces[f];
    return c + 1 == face.first + face.size ? face.first : c + 1;
  }
  [[nodiscard]] Index corner_before(Index c, Index f) const {
    const Face& face = faces[f];
    return c == face.first ? face.first + face.size - 1 : c - 1;
  }
};

/// The second half of a diagnosis: what is wrong between faces. pre: the faces that aren't ignored
/// have three corners or more, which are different vertices below `vertex_count`.
/// Returns false when memory is exhausted.
[[nodiscard]] bool diagnose_neighbours(FaceTable& table, std::size_t vertex_count,
                                       ProblemSink& problems);

}  // namespace halfedge
