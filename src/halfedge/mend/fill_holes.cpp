#include <halfedge/decorator/refusal.h>
#include <halfedge/mend/hole_plan.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace halfedge::mend {

namespace {

using decorator::internal::refusal;

Failure no_room_for_triangles() {
  return decorator::internal::no_memory("the triangles of a hole");
}

Failure left_open(Halfedge h, std::size_t edges, const std::string& why) {
  return refusal("",
                 sentence::of("the boundary loop of halfedge {}, of {}{}{}", h.index(), edges,
                              edges == 1 ? " edge, " : " edges, ", why),
                 {.halfedges = {h.index()}});
}

class Filler {
 public:
  Filler(Surface& surface, const FillOptions& options, Report& report)
      : surface_(surface), options_(options), report_(report), plan_(surface, options.max_angle) {}

  [[nodiscard]] Result<void> fill(Halfedge first) {
    std::size_t edges = 0;
    bool is_finite = true;
    Halfedge h = first;
    do {
      const Point p = surface_.position(surface_.to_vertex(h));
      is_finite = is_finite && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
      ++edges;
      h = surface_.next(h);
    } while (h != first);

    if (edges > options_.max_edges) {
      report_.leave(Code::kLargeHole, [&] {
        return left_open(
            first, edges,
            sentence::of("is larger than asked for, expected {} at most", options_.max_edges));
      });
      return {};
    }
    if (edges < 3) {
      report_.leave(Code::kUnfillableHole, [&] {
        return left_open(first, edges, "can't be filled: a face has three corners at least");
      });
      return {};
    }
    if (!is_finite) {
      report_.leave(Code::kUnfillableHole, [&] {
        return left_open(first, edges, "has a position that is no finite number");
      });
      return {};
    }
    return fill(first, edges);
  }

 private:
  [[nodiscard]] Result<void> fill(Halfedge first, std::size_t edges) {
    const HolePlan::Outcome outcome = plan_.run(first);
    if (outcome == HolePlan::Outcome::kOutOfMemory) return no_room_for_triangles();
    if (outcome == HolePlan::Outcome::kBlocked) {
      report_.leave(Code::kUnfillableHole, [&] {
        return left_open(first, edges,
                         "can't be filled: each triangulation found joins vertices that are joined "
                         "already, expected one that does not");
      });
      return {};
    }
    const double degrees = 57.29577951308232 * std::acos(std::clamp(plan_.worst(), -1.0, 1.0));
    if (degrees > options_.max_angle) {
      report_.leave(Code::kFoldingHole, [&] {
        return left_open(
            first, edges,
            sentence::of("would be filled with a fold of {} degrees, expected {} at most between "
                         "the normals of neighbours",
                         sentence::number(degrees), sentence::number(options_.max_angle)));
      });
      return {};
    }
    return cut(first) ? Result<void>{} : no_room_for_triangles();
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
    for (std::size_t i = 0; i < n; ++i, h = surface_.next(h)) {
      into_[i] = h;
      next_[i] = Index(i + 1 == n ? 0 : i + 1);
      prev_[i] = Index(i == 0 ? n - 1 : i - 1);
    }
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
  Array<Halfedge> into_;  // by corner
  Array<Index> next_;
  Array<Index> prev_;
};

}  // namespace

Result<Report> fill_holes(Surface& surface, const FillOptions& options) {
  if (const Result<void> checked =
          check_option("bad-angle", "The largest angle of a filling", options.max_angle, 180);
      !checked) {
    return checked.error();
  }
  const Result<Array<Halfedge>> loops = surface.boundary_loops();
  if (!loops) return loops.error();
  Report report;
  Filler filler(surface, options, report);
  for (const Halfedge h : loops.value()) {
    if (!surface.is_live(h)) continue;
    if (Result<void> done = filler.fill(h); !done) return done.error();
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
