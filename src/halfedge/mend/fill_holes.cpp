#include <halfedge/mend/hole_plan.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/refusals.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace halfedge::mend {

namespace {

using refusals::refusal;

// From kBlocked on for lack of a plan.
enum class Why : std::uint8_t { kFilled, kLarge, kSmall, kNoNumber, kBlocked, kFolding };

// What became of a loop. Triangles beside one that was left may join two of its corners, which
// forbids a diagonal, and may by chance lead the search to what it had missed: it is planned again.
struct Loop {
  Halfedge first;
  Why why = Why::kBlocked;
  std::size_t edges = 0;
  std::size_t joins = HolePlan::kUnplanned;
  double degrees = 0;  // of the fold
};

Code code_of(Why why) {
  if (why == Why::kLarge) return Code::kLargeHole;
  return why == Why::kFolding ? Code::kFoldingHole : Code::kUnfillableHole;
}

std::string sentence_of(const Loop& loop, const FillOptions& options) {
  switch (loop.why) {
    case Why::kLarge:
      return sentence::of("is larger than asked for, expected {} at most", options.max_edges);
    case Why::kSmall:
      return "can't be filled: a face has three corners at least";
    case Why::kNoNumber:
      return "has a position that is no finite number";
    case Why::kBlocked:
      return "can't be filled: each triangulation found joins vertices that are joined already, "
             "expected one that does not";
    case Why::kFilled:
    case Why::kFolding:
      break;
  }
  return sentence::of(
      "would be filled with a fold of {} degrees, expected {} at most between the normals of "
      "neighbours",
      sentence::number(loop.degrees), sentence::number(options.max_angle));
}

Failure left_open(const Loop& loop, const FillOptions& options) {
  return refusal(
      "",
      sentence::of("the boundary loop of halfedge {}, of {}{}{}", loop.first.index(), loop.edges,
                   loop.edges == 1 ? " edge, " : " edges, ", sentence_of(loop, options)),
      {.halfedges = {loop.first.index()}});
}

class Filler {
 public:
  Filler(Surface& surface, const FillOptions& options, Report& report)
      : surface_(surface), options_(options), report_(report), plan_(surface, options.max_angle) {}

  // False when memory is exhausted.
  [[nodiscard]] bool fill(std::span<const Halfedge> loops) {
    if (!loops_.resize(loops.size(), {})) return false;
    for (std::size_t i = 0; i < loops.size(); ++i) look_at(loops_[i], loops[i]);
    for (bool again = true; again;) {
      again = false;
      for (Loop& loop : loops_) {
        if (loop.why < Why::kBlocked) continue;
        if (!fill(loop)) return false;
        again = again || loop.why == Why::kFilled;
      }
    }
    for (const Loop& loop : loops_) {
      if (loop.why == Why::kFilled) continue;
      report_.leave(code_of(loop.why), [&] { return left_open(loop, options_); });
    }
    return true;
  }

 private:
  void look_at(Loop& loop, Halfedge first) {
    bool is_finite = true;
    Halfedge h = first;
    do {
      const Point p = surface_.position(surface_.to_vertex(h));
      is_finite = is_finite && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
      ++loop.edges;
      h = surface_.next(h);
    } while (h != first);
    loop.first = first;
    if (loop.edges > options_.max_edges) {
      loop.why = Why::kLarge;
    } else if (loop.edges < 3) {
      loop.why = Why::kSmall;
    } else if (!is_finite) {
      loop.why = Why::kNoNumber;
    }
  }

  [[nodiscard]] bool fill(Loop& loop) {
    const HolePlan::Outcome outcome = plan_.run(loop.first, loop.joins);
    if (outcome == HolePlan::Outcome::kOutOfMemory) return false;
    if (outcome == HolePlan::Outcome::kSame) return true;
    loop.why = Why::kBlocked;
    if (outcome == HolePlan::Outcome::kBlocked) return true;
    loop.degrees = kDegreesPerRadian * std::acos(std::clamp(plan_.worst(), -1.0, 1.0));
    loop.why = loop.degrees > options_.max_angle ? Why::kFolding : Why::kFilled;
    return loop.why == Why::kFolding || cut(loop.first);
  }

  // One face, from which the ears are cut off.
  [[nodiscard]] bool cut(Halfedge first) {
    const std::span<const Index> ears = plan_.ears();
    const std::size_t n = ears.size() + 3;
    if (!into_.resize(n) || !next_.resize(n) || !prev_.resize(n) ||
        !report_.faces.reserve(report_.faces.size() + n) || n > kMaxSlots ||
        !surface_.make_room(0, Index(n - 3), Index(n - 2))) {
      return false;
    }
    Halfedge h = first;
    for (std::size_t i = 0; i < n; ++i, h = surface_.next(h)) into_[i] = h;
    make_ring(next_, prev_);
    surface_.fill_hole(first);
    (void)report_.faces.push_back(surface_.face(first).index());
    for (const Index corner : ears) {
      const Index a = prev_[corner];
      const Index b = next_[corner];
      const Halfedge diagonal = surface_.split_face(into_[a], into_[b]);
      (void)report_.faces.push_back(surface_.face(Surface::opposite(diagonal)).index());
      into_[b] = diagonal;
      next_[a] = b;
      prev_[b] = a;
    }
    report_.add(Code::kFilledHole);
    return true;
  }

  Surface& surface_;
  const FillOptions& options_;
  Report& report_;
  HolePlan plan_;
  Array<Loop> loops_;
  Array<Halfedge> into_;  // by corner
  Array<Index> next_;
  Array<Index> prev_;
};

}  // namespace

Result<Report> fill_holes(Surface& surface, const FillOptions& options) {
  if (Result<void> checked =
          check_option("bad-angle", "The largest angle of a filling", options.max_angle, 180);
      !checked) {
    return checked;
  }
  Result<Array<Halfedge>> loops = surface.boundary_loops();
  if (!loops) return loops;
  Report report;
  Filler filler(surface, options, report);
  if (!filler.fill(loops.value().span())) {
    return refusals::no_memory("the triangles of a hole");
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
