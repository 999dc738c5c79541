#include <halfedge/mend/report.h>
#include <halfedge/mend/surface_of.h>
#include <halfedge/refusals.h>
#include <halfedge/sentence.h>

#include <cmath>
#include <utility>

namespace halfedge::mend {

namespace {

struct Wording {
  const char* name;
  const char* noun;
  const char* outcome;
};

// In the order of the codes.
constexpr std::array<Wording, kCodeCount> kWordings{{
    {"stitched-edge", "edge", "stitched"},
    {"split-vertex", "pinched vertex", "split"},
    {"reversed-component", "component", "turned over"},
    {"collapsed-edge", "edge", "collapsed"},
    {"flipped-edge", "edge", "flipped"},
    {"joined-face", "face", "joined with a neighbour"},
    {"removed-face", "face", "on the boundary removed"},
    {"triangulated-face", "face", "cut into triangles"},
    {"dropped-component", "component", "dropped"},
    {"filled-hole", "hole", "filled"},
    {"ambiguous-edge", "edge", "left which several others fit"},
    {"opposite-orientation", "edge", "left between faces of opposite orientation"},
    {"unstitchable-edge", "edge", "left that can't be glued"},
    {"open-component", "open component", "left"},
    {"flat-component", "component", "without volume left"},
    {"zero-length-edge", "edge", "without length left"},
    {"degenerate-face", "face", "without area left"},
    {"large-hole", "larger hole", "left"},
    {"unfillable-hole", "hole", "left that can't be filled"},
    {"folding-hole", "hole", "left whose filling would fold over"},
}};

}  // namespace

const char* name_of(Code code) { return kWordings[std::size_t(code)].name; }

Result<void> check_option(const char* code, std::string_view of, double value, double most) {
  if (value >= 0 && value <= most && std::isfinite(value)) return {};
  return Error{code, sentence::of("{} is {}; expected a {} from 0{}.", of, sentence::number(value),
                                  std::isfinite(most) ? "number" : "finite number",
                                  std::isfinite(most) ? " to " + sentence::number(most) : "")};
}

std::string reason_of(const Error& error) {
  return error.message.substr(0, error.message.size() - 1);
}

Result<void> first_error(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems) {
    if (problem.severity != Severity::kError) continue;
    if (problem.code == "out-of-memory") return refusals::no_memory("the check");
    return refusals::refusal("corrupt-connectivity",
                             sentence::of("the mesh is not valid, expected level 4: {}",
                                          problem.message.substr(0, problem.message.size() - 1)));
  }
  return {};
}

void Report::summarize() {
  summary.clear();
  for (std::size_t i = 0; i < kCodeCount; ++i) {
    if (counts[i] == 0) continue;
    if (!summary.empty()) summary += ", ";
    summary += sentence::of("{} {}", sentence::count_of(counts[i], kWordings[i].noun),
                            kWordings[i].outcome);
  }
  summary = sentence::complete(summary.empty() ? "nothing to repair" : std::move(summary));
}

}  // namespace halfedge::mend
