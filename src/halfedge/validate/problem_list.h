#pragma once

#include <halfedge/sentence.h>
#include <halfedge/validate/validate.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace halfedge {

/// What `validate` can find wrong. In the order of the table in validate.h.
enum class Rule : std::uint8_t {
  kArraySize,
  kFreeList,
  kHalfDeletedEdge,
  kEmptyLink,
  kIndexOutOfRange,
  kDeletedReference,
  kOppositeMismatch,  // Directed Edges only: elsewhere opposites aren't stored
  kNextPrevMismatch,
  kMissingAnchor,
  kAnchorElsewhere,
  kFaceHalfedgeElsewhere,
  kToFromMismatch,
  kFaceMismatch,
  kUnreachableHalfedge,
  kFaceWithManyLoops,
  kInteriorAnchor,
  kEdgeWithoutFace,
  kDegreeBelowThree,
  kRepeatedVertex,
  kDuplicateHalfedge,
  kSameFaceTwice,
  kPinchedVertex,
  kIsolatedVertex,
  kOutOfMemory,
  kNonFinitePosition,
  kZeroLengthEdge,
  kDegenerateFace,
  kCoincidentVertices,
};
inline constexpr std::size_t kRuleCount = std::size_t(Rule::kCoincidentVertices) + 1;

/// Collects problems; a rule that is broken too often is counted, no longer listed.
class ProblemList {
 public:
  /// `message` is called only if the problem is listed: sentences cost more than checks. It gets
  /// its capital and its full stop here.
  template <class Message>
  void add(Rule rule, ItemKind kind, Index index, Message&& message) {
    if (severity(rule) == Severity::kError) ++error_count_;
    if (++counts_[std::size_t(rule)] <= kMaxProblemsPerCode) {
      listed_.push_back({code(rule), severity(rule), kind, index, sentence::complete(message())});
    }
  }

  [[nodiscard]] std::size_t error_count() const { return error_count_; }

  /// The problems in the order found, and for each long list the number of those left out.
  [[nodiscard]] std::vector<Problem> take() && {
    for (std::size_t rule = 0; rule < kRuleCount; ++rule) {
      if (counts_[rule] <= kMaxProblemsPerCode) continue;
      const std::string left_out = std::to_string(counts_[rule] - kMaxProblemsPerCode);
      listed_.push_back({code(Rule(rule)), severity(Rule(rule)), ItemKind::kMesh, kNone,
                         sentence::of("And {} more problems with this code.", left_out)});
    }
    return std::move(listed_);
  }

  [[nodiscard]] static constexpr std::string_view code(Rule rule) {
    constexpr std::array<std::string_view, kRuleCount> kCodes = {"array-size",
                                                                 "free-list",
                                                                 "half-deleted-edge",
                                                                 "empty-link",
                                                                 "index-out-of-range",
                                                                 "deleted-reference",
                                                                 "opposite-mismatch",
                                                                 "next-prev-mismatch",
                                                                 "missing-anchor",
                                                                 "anchor-elsewhere",
                                                                 "face-halfedge-elsewhere",
                                                                 "to-from-mismatch",
                                                                 "face-mismatch",
                                                                 "unreachable-halfedge",
                                                                 "face-with-many-loops",
                                                                 "interior-anchor",
                                                                 "edge-without-face",
                                                                 "degree-below-three",
                                                                 "repeated-vertex",
                                                                 "duplicate-halfedge",
                                                                 "same-face-twice",
                                                                 "pinched-vertex",
                                                                 "isolated-vertex",
                                                                 "out-of-memory",
                                                                 "non-finite-position",
                                                                 "zero-length-edge",
                                                                 "degenerate-face",
                                                                 "coincident-vertices"};
    return kCodes[std::size_t(rule)];
  }
  [[nodiscard]] static constexpr Severity severity(Rule rule) {
    if (rule == Rule::kIsolatedVertex) return Severity::kInfo;
    const bool is_warning = rule == Rule::kPinchedVertex || rule > Rule::kNonFinitePosition;
    return is_warning ? Severity::kWarning : Severity::kError;
  }

 private:
  std::vector<Problem> listed_;
  std::array<std::size_t, kRuleCount> counts_{};
  std::size_t error_count_ = 0;
};

}  // namespace halfedge
