#pragma once

#include <halfedge/connectivity/array.h>
#include <halfedge/connectivity/handle.h>
#include <halfedge/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace halfedge::mend {

/// What a repair did, and then what it had to leave. In JavaScript the names of `name_of`.
enum class Code : std::uint8_t {
  kStitchedEdge,       ///< two boundary edges became this one
  kSplitVertex,        ///< a pinched vertex: each of its fans has one of its own now
  kReversedComponent,  ///< turned over
  kCollapsedEdge,      ///< without length, or the short one of a face without area
  kFlippedEdge,        ///< the long one of a face without area
  kJoinedFace,         ///< a face without area became a part of the one beyond its long edge
  kRemovedFace,        ///< a face without area, on the boundary
  kTriangulatedFace,   ///< a face without area and more than three corners
  kDroppedComponent,
  kFilledHole,

  kAmbiguousEdge,        ///< more than one other fits
  kOppositeOrientation,  ///< the one that fits runs the same way
  kUnstitchableEdge,     ///< to glue it would break the mesh
  kOpenComponent,        ///< it has no inside
  kFlatComponent,        ///< its volume is next to nothing, or no finite number
  kZeroLengthEdge,       ///< to collapse it would break the mesh
  kDegenerateFace,       ///< no step is allowed that would remove it
  kLargeHole,            ///< more edges than asked for
  kUnfillableHole,       ///< each filling would join vertices that are joined already
  kFoldingHole,          ///< each filling that was found folds over
};
inline constexpr std::size_t kCodeCount = std::size_t(Code::kFoldingHole) + 1;

/// "stitched-edge" and so on: stable, in kebab-case.
[[nodiscard]] const char* name_of(Code code);

/// Refuses what is no finite number from 0, or one above `most`, as `code`. `of` names the option
/// as a sentence begins with it: "The tolerance of stitching".
[[nodiscard]] Result<void> check_option(const char* code, std::string_view of, double value,
                                        double most = std::numeric_limits<double>::infinity());

/// What an error says, to end another sentence with: without its full stop.
[[nodiscard]] std::string reason_of(const Error& error);

/// What a repair has done, and what not.
struct Report {
  /// So many problems of one code are listed.
  static constexpr std::size_t kMaxListed = 100;

  /// How many items each code was found of, listed or not.
  std::array<std::size_t, kCodeCount> counts{};
  /// What could not be done: the code, a sentence that says why, and the items.
  std::vector<Error> problems;
  /// The items that were touched or made, and are live: each repair says which.
  Array<Index> vertices;
  Array<Index> edges;
  Array<Index> faces;
  /// All of it in one readable line.
  std::string summary;

  [[nodiscard]] std::size_t count(Code code) const { return counts[std::size_t(code)]; }

  /// One more of `code`, which needs no sentence.
  void add(Code code, std::size_t more = 1) { counts[std::size_t(code)] += more; }
  /// One more that had to be left. `describe` makes the Error, whose code is that of `code`; it
  /// isn't called once there are enough.
  template <class Describe>
  void leave(Code code, const Describe& describe) {
    if (counts[std::size_t(code)]++ >= kMaxListed) return;
    Error error = Result<void>(describe()).error();
    error.code = name_of(code);
    problems.push_back(std::move(error));
  }
  /// Writes the summary.
  void summarize();
};

}  // namespace halfedge::mend
