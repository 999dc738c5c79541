#include <halfedge/repair/log.h>
#include <halfedge/sentence.h>

#include <string>
#include <utility>

namespace halfedge {

const char* name_of(RepairCode code) {
  switch (code) {
    case RepairCode::kNonFinitePosition:
      return "non-finite-position";
    case RepairCode::kIndexOutOfRange:
      return "index-out-of-range";
    case RepairCode::kDegreeBelowThree:
      return "degree-below-three";
    case RepairCode::kRepeatedVertex:
      return "repeated-vertex";
    case RepairCode::kCoincidentPosition:
      return "coincident-position";
    case RepairCode::kDuplicateFace:
      return "duplicate-face";
    case RepairCode::kEdgeWithManyFaces:
      return "edge-with-many-faces";
    case RepairCode::kOppositeOrientation:
      return "opposite-orientation";
    case RepairCode::kNonOrientable:
      return "non-orientable";
    case RepairCode::kNeighboursCut:
      return "neighbours-cut";
    case RepairCode::kPinchedVertex:
      return "pinched-vertex";
    case RepairCode::kIsolatedVertex:
      return "isolated-vertex";
  }
  return "";
}

namespace repair {

namespace {

using sentence::count_of;

/// How many faces were dropped for what their codes don't tell alone.
struct Dropped {
  std::size_t without_position = 0;
  std::size_t repeated = 0;
};

std::string summary_of(const RepairReport& report, const RepairOptions& options,
                       const Dropped& dropped, std::size_t doubled_vertices) {
  std::string list;
  const auto say = [&](std::size_t count, const char* noun, const char* done) {
    if (count == 0) return;
    if (!list.empty()) list += ", ";
    list += sentence::of("{} {}", count_of(count, noun), done);
  };
  const auto count = [&](RepairCode code) { return report.count(code); };
  const std::size_t misplaced = count(RepairCode::kNonFinitePosition);
  say(misplaced, "vertex", "without a finite position left out");
  say(dropped.without_position, "face",
      misplaced == 1 ? "that used it left out" : "that used them left out");
  say(count(RepairCode::kCoincidentPosition), "vertex", "welded to others");
  say(count(RepairCode::kIndexOutOfRange), "face", "with an index out of range left out");
  say(count(RepairCode::kDegreeBelowThree), "face", "with fewer than 3 corners left out");
  say(dropped.repeated, "face", "that used a vertex twice left out");
  say(count(RepairCode::kRepeatedVertex) - dropped.repeated, "face",
      "that used a vertex twice simplified");
  say(count(RepairCode::kDuplicateFace), "duplicate face", "left out");
  say(count(RepairCode::kEdgeWithManyFaces), "edge", "with more than two faces cut");
  say(count(RepairCode::kNeighboursCut), "edge", "beside such edges cut");
  say(count(RepairCode::kOppositeOrientation), "face", "turned over");
  say(count(RepairCode::kNonOrientable), "edge", "of one-sided surfaces cut");
  say(count(RepairCode::kPinchedVertex), "pinched vertex", "split");
  say(doubled_vertices, "vertex", doubled_vertices == 1 ? "added as a copy" : "added as copies");
  if (list.empty()) list = "nothing to repair";
  say(count(RepairCode::kIsolatedVertex), "vertex",
      options.drop_isolated ? "without faces left out" : "without faces kept");
  return sentence::complete(std::move(list));
}

}  // namespace

bool Log::finish(const RepairOptions& options, std::size_t doubled_vertices) {
  std::size_t touched = 0;
  for (const std::uint16_t mark : marks_) touched += mark != 0 ? 1 : 0;
  if (!report_.verdicts.reserve(touched)) return false;
  Dropped dropped;
  for (Index f = 0; f < marks_.size(); ++f) {
    if (marks_[f] == 0) continue;
    const FaceVerdict verdict{f, report_.face_map[f] != kNone, marks_[f]};
    dropped.without_position += !verdict.kept && verdict.has(RepairCode::kNonFinitePosition);
    dropped.repeated += verdict.has(RepairCode::kRepeatedVertex) && !verdict.kept &&
                        !verdict.has(RepairCode::kDuplicateFace);
    (void)report_.verdicts.push_back(verdict);  // reserved above
  }
  report_.summary = summary_of(report_, options, dropped, doubled_vertices);
  return true;
}

}  // namespace repair

}  // namespace halfedge
