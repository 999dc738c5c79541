#include <halfedge/mend/partners.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/refusals.h>
#include <halfedge/sentence.h>

#include <cstddef>
#include <utility>

namespace halfedge::mend {

namespace {

using refusals::refusal;

Failure no_memory() { return refusals::no_memory("the boundary edges"); }

Failure several_fit(Edge e, std::size_t count) {
  return refusal("",
                 sentence::of("{} lies together with {} other boundary edges, expected one: which "
                              "to glue it to can't be told",
                              e, count - 1),
                 {.edges = {e.index()}});
}

Failure refused(Edge e, Edge other, const Error& why) {
  return refusal(
      "", sentence::of("{} and {} lie together but can't be glued: {}", e, other, reason_of(why)),
      {.edges = {e.index(), other.index()}});
}

// Edges are glued one after another, each by the checked operation. That refuses what would break
// the mesh, but also what breaks it for the moment only: two edges of a slit that end in the same
// vertex must be glued at once, or in the right order.
class Stitcher {
 public:
  Stitcher(Surface& surface, Report& report)
      : surface_(surface), report_(report), partners_(surface) {}

  [[nodiscard]] Result<void> run(double tolerance) {
    if (!partners_.find(tolerance, report_) || !is_seen_.resize(surface_.face_slots(), false) ||
        !is_refused_.resize(surface_.edge_slots(), false)) {
      return no_memory();
    }
    if (Result<void> done = glue_pairs(); !done) return done;
    // What is refused, or can't be told, may be possible once more is glued.
    closes_gaps_ = true;
    std::size_t before = 0;
    do {
      before = count();
      if (Result<void> done = glue_refused(); !done) return done;
      if (Result<void> done = close_gaps(); !done) return done;
      if (!partners_.pair_up(new_pairs_, report_)) return no_memory();
    } while (before < count() || !new_pairs_.empty());
    list_what_is_left();
    return {};
  }

 private:
  using Pair = Partners::Pair;

  [[nodiscard]] std::size_t count() const { return report_.count(Code::kStitchedEdge); }
  // Edges of a group belong together where they follow each other, once all others are glued.
  [[nodiscard]] bool are_partners(Halfedge h, Halfedge g) const {
    return partners_.are(h, g) || (closes_gaps_ && partners_.are_in_group(h, g));
  }

  // From face to face, so that what is glued next is near, also in the cache, and so that a single
  // face is glued to many and not the other way round.
  [[nodiscard]] Result<void> glue_pairs() {
    for (const Halfedge start : partners_.boundary()) {
      if (!partners_.of(start).valid()) continue;
      queue_.clear();
      if (!add_sides(surface_.face(Surface::opposite(start)))) return no_memory();
      std::size_t first = 0;
      while (first < queue_.size()) {
        const Halfedge h = queue_[first++];
        const Halfedge g = partners_.of(h);
        if (!g.valid() || is_refused_[Surface::edge(h).index()]) continue;
        const Face beyond = surface_.face(Surface::opposite(g));
        if (Result<void> done = try_pair({h, g}); !done) return done;
        if (!add_sides(beyond)) return no_memory();
      }
    }
    return {};
  }

  // Puts what is to be glued around a face on the queue, once.
  [[nodiscard]] bool add_sides(Face f) {
    if (is_seen_[f.index()]) return true;
    is_seen_[f.index()] = true;
    const Halfedge first = surface_.halfedge(f);
    Halfedge side = first;
    do {
      const Halfedge o = Surface::opposite(side);
      if (partners_.of(o).valid() && !queue_.push_back(o)) return false;
      side = surface_.next(side);
    } while (side != first);
    return true;
  }

  [[nodiscard]] Result<void> glue_refused() {
    for (const Array<Pair>& pairs : {std::exchange(refused_, {}), std::exchange(new_pairs_, {})}) {
      for (const Pair& pair : pairs) {
        if (Result<void> done = try_pair(pair); !done) return done;
      }
    }
    return {};
  }

  [[nodiscard]] Result<void> try_pair(const Pair& pair) {
    if (!are_partners(pair.h, pair.g)) return {};  // glued with a neighbour
    Result<bool> done = glue_somehow(pair);
    if (!done) return done;
    if (done.value()) return {};
    is_refused_[Surface::edge(pair.h).index()] = is_refused_[Surface::edge(pair.g).index()] = true;
    return refused_.push_back(pair) ? Result<void>{} : no_memory();
  }

  // Of more than two edges in one place, those that follow each other belong together. When they
  // are glued, those before and after them follow each other.
  [[nodiscard]] Result<void> close_gaps() {
    for (Halfedge h : partners_.boundary()) {
      while (partners_.group_size(h) > 0) {
        const Halfedge g = surface_.next(h);
        if (!partners_.are_in_group(h, g)) break;
        const Halfedge before[] = {surface_.prev(h), surface_.prev(surface_.prev(h))};
        Result<bool> done = glue_somehow({h, g});
        if (!done) return done;
        if (!done.value()) break;
        h = surface_.is_live(before[0]) && surface_.is_boundary(before[0]) ? before[0] : before[1];
        if (!surface_.is_live(h)) break;
      }
    }
    return {};
  }

  // Alone, or else with what follows or precedes. False if it is refused.
  [[nodiscard]] Result<bool> glue_somehow(const Pair& pair) {
    Result<bool> done = glue(pair.h, pair.g, 1);
    if (!done || done.value()) return done;
    const Halfedge before_g = surface_.prev(pair.g);
    const Halfedge before_h = surface_.prev(pair.h);
    const Halfedge after_g = surface_.next(pair.g);
    const bool extends = are_partners(surface_.next(pair.h), before_g) && before_g != pair.h;
    const bool precedes = are_partners(before_h, after_g) && before_h != pair.g;
    if (extends) {
      done = glue(pair.h, pair.g, 2);
      if (!done || done.value()) return done;
    }
    if (precedes) return glue(before_h, after_g, 2);
    return false;
  }

  // False if it is refused.
  [[nodiscard]] Result<bool> glue(Halfedge h, Halfedge g, std::size_t n) {
    Halfedge glued[2][2] = {};
    for (std::size_t i = 0; i < n; ++i) {
      glued[0][i] = i == 0 ? h : surface_.next(glued[0][i - 1]);
      glued[1][i] = i == 0 ? g : surface_.prev(glued[1][i - 1]);
    }
    if (!report_.edges.reserve_more(n)) return no_memory();
    const Result<Edge> done = surface_.glue_path(h, g, n);
    if (!done) {
      if (done.error().code == "out-of-memory") return done.error();
      return false;
    }
    for (std::size_t i = 0; i < n; ++i) {
      partners_.forget(glued[0][i], glued[1][i]);
      (void)report_.edges.push_back(Surface::edge(glued[0][i]).index());
    }
    report_.add(Code::kStitchedEdge, n);
    return true;
  }

  void list_what_is_left() {
    for (const Halfedge h : partners_.boundary()) {
      const std::size_t together = partners_.group_size(h);
      if (together == 0) continue;
      report_.leave(Code::kAmbiguousEdge, [&] { return several_fit(Surface::edge(h), together); });
    }
    for (const Pair& pair : refused_) {
      if (!are_partners(pair.h, pair.g)) continue;  // glued with a neighbour after all
      const Result<void> can = surface_.check_glue(pair.h, pair.g);
      report_.leave(Code::kUnstitchableEdge, [&] {
        return refused(Surface::edge(pair.h), Surface::edge(pair.g), can.error());
      });
    }
  }

  Surface& surface_;
  Report& report_;
  Partners partners_;
  Array<Pair> refused_;
  Array<Pair> new_pairs_;  // of what were groups
  Array<Halfedge> queue_;
  Array<bool> is_seen_;     // by face
  Array<bool> is_refused_;  // by edge
  bool closes_gaps_ = false;
};

}  // namespace

Result<Report> stitch_boundaries(Surface& surface, const StitchOptions& options) {
  Report report;
  if (Result<void> checked =
          check_option("bad-tolerance", "The tolerance of stitching", options.tolerance);
      !checked) {
    return checked;
  }
  if (Result<void> done = Stitcher(surface, report).run(options.tolerance); !done) {
    return done;
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
