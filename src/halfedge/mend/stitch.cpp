#include <halfedge/decorator/refusal.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/repair/soup.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace halfedge::mend {

namespace {

using decorator::internal::refusal;
using decorator::internal::text;

Failure no_memory() { return decorator::internal::no_memory("the boundary edges"); }

Failure several_fit(Edge e, std::size_t count) {
  return refusal("",
                 text(e) + " lies together with " + std::to_string(count - 1) +
                     " other boundary edges, expected one: which to glue it to can't be told",
                 {.edges = {e.index()}});
}

Failure runs_the_same_way(Edge e, Edge other) {
  return refusal("",
                 text(e) + " and " + text(other) +
                     " lie together but run the same way, expected faces of one orientation",
                 {.edges = {e.index(), other.index()}});
}

Failure refused(Edge e, Edge other, const Error& why) {
  const std::string reason = why.message.substr(0, why.message.size() - 1);
  return refusal("",
                 text(e) + " and " + text(other) + " lie together but can't be glued: " + reason,
                 {.edges = {e.index(), other.index()}});
}

// Edges are glued one after another, each by the checked operation. That refuses what would break
// the mesh, but also what breaks it for the moment only: two edges of a slit that end in the same
// vertex must be glued at once, or in the right order.
class Stitcher {
 public:
  Stitcher(Surface& surface, double tolerance, Report& report)
      : surface_(surface), tolerance_(tolerance), report_(report) {}

  [[nodiscard]] Result<void> run() {
    if (!list_boundary() || !match()) return no_memory();
    if (Result<void> done = glue_pairs(); !done) return done;
    if (Result<void> done = close_gaps(); !done) return done;
    for (const Pair& pair : refused_) {
      const Result<void> can = surface_.check_glue(pair.h, pair.g);
      if (!can) {
        report_.leave(Code::kUnstitchableEdge, [&] {
          return refused(Surface::edge(pair.h), Surface::edge(pair.g), can.error());
        });
      } else if (const Result<bool> done = glue(pair.h, pair.g, 1); !done) {
        return done.error();
      }
    }
    return {};
  }

 private:
  struct Pair {
    Halfedge h;
    Halfedge g;
  };
  /// A boundary edge by the places of its ends, in the bucket of the lower one.
  struct Record {
    Index higher;
    Halfedge h;
  };
  /// What a partner is for the edges of a group of more than two.
  static constexpr Index kGroup = 0x8000'0000;
  static constexpr int kRounds = 8;

  [[nodiscard]] Vertex from(Halfedge h) const { return surface_.from_vertex(h); }
  [[nodiscard]] Index place(Vertex v) const { return place_of_[v.index()]; }
  [[nodiscard]] bool is_open(Halfedge h) const {
    return surface_.is_live(h) && surface_.is_boundary(h);
  }

  // Numbers the places where boundary vertices lie.
  [[nodiscard]] bool list_boundary() {
    Array<Vertex> vertices;
    Array<float> positions;
    if (!place_of_.resize(surface_.vertex_slots(), kNone)) return false;
    for (Index i = 0; i < surface_.halfedge_slots(); ++i) {
      const Halfedge h(i);
      if (!is_open(h)) continue;
      if (!boundary_.push_back(h)) return false;
      const Vertex v = from(h);
      if (place(v) != kNone) continue;  // of a pinched vertex
      place_of_[v.index()] = Index(vertices.size());
      const Point p = surface_.position(v);
      if (!vertices.push_back(v) || !positions.push_back(p.x) || !positions.push_back(p.y) ||
          !positions.push_back(p.z)) {
        return false;
      }
    }
    repair::Vertices welded;
    if (!repair::weld(positions.span(), tolerance_, welded)) return false;
    for (const Vertex v : vertices) place_of_[v.index()] = welded.of_input[place(v)];
    places_ = welded.size();
    return true;
  }

  // Sorts the edges by their lower place, and then each bucket, which is small, by the other.
  [[nodiscard]] bool match() {
    Array<std::size_t> begin;
    Array<Record> records;
    if (!begin.resize(places_ + 2, 0) || !records.resize(boundary_.size()) ||
        !partner_.resize(surface_.halfedge_slots(), kNone)) {
      return false;
    }
    const auto lower = [&](Halfedge h) {
      return std::size_t{std::min(place(from(h)), place(surface_.to_vertex(h)))};
    };
    const auto is_usable = [&](Halfedge h) {
      const Index a = place(from(h));
      const Index b = place(surface_.to_vertex(h));
      return a != b && a != kNone && b != kNone;
    };
    for (const Halfedge h : boundary_) {
      if (is_usable(h)) ++begin[lower(h) + 2];
    }
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (const Halfedge h : boundary_) {
      if (!is_usable(h)) continue;
      const Index higher = std::max(place(from(h)), place(surface_.to_vertex(h)));
      records[begin[lower(h) + 1]++] = {higher, h};
    }
    for (std::size_t bucket = 0; bucket < places_; ++bucket) {
      Record* first = records.begin() + begin[bucket];
      Record* const end = records.begin() + begin[bucket + 1];
      introsort(first, end, [](const Record& a, const Record& b) {
        return a.higher != b.higher ? a.higher < b.higher : a.h < b.h;
      });
      while (first != end) {
        Record* last = first + 1;
        while (last != end && last->higher == first->higher) ++last;
        if (!match_group(first, std::size_t(last - first))) return false;
        first = last;
      }
    }
    return true;
  }

  [[nodiscard]] bool match_group(const Record* group, std::size_t count) {
    if (count == 1) return true;
    const Halfedge h = group[0].h;
    if (count > 2) {
      for (std::size_t i = 0; i < count; ++i) {
        partner_[group[i].h.index()] = kGroup | Index(groups_.size());
      }
      return groups_.push_back(count);
    }
    const Halfedge g = group[1].h;
    if (place(from(h)) == place(from(g))) {
      report_.leave(Code::kOppositeOrientation,
                    [&] { return runs_the_same_way(Surface::edge(h), Surface::edge(g)); });
      return true;
    }
    partner_[h.index()] = g.index();
    partner_[g.index()] = h.index();
    return true;
  }

  // Edges of a group belong together where they follow each other, once all others are glued.
  [[nodiscard]] bool are_partners(Halfedge h, Halfedge g) const {
    const Index partner = partner_[h.index()];
    if (partner == g.index()) return true;
    return closes_gaps_ && partner != kNone && (partner & kGroup) != 0 && h != g &&
           partner_[g.index()] == partner && place(from(h)) != place(from(g));
  }

  // From face to face, so that what is glued next is near, also in the cache, and so that a single
  // face is glued to many and not the other way round.
  [[nodiscard]] Result<void> glue_pairs() {
    if (!is_seen_.resize(surface_.face_slots(), false) ||
        !is_refused_.resize(surface_.edge_slots(), false)) {
      return no_memory();
    }
    for (const Halfedge start : boundary_) {
      if (!has_partner(start)) continue;
      queue_.clear();
      if (!add_sides(surface_.face(Surface::opposite(start)))) return no_memory();
      std::size_t first = 0;
      while (first < queue_.size()) {
        const Halfedge h = queue_[first++];
        if (!has_partner(h) || is_refused_[Surface::edge(h).index()]) continue;
        const Pair pair{h, Halfedge(partner_[h.index()])};
        const Face beyond = surface_.face(Surface::opposite(pair.g));
        if (Result<void> done = try_pair(pair); !done) return done;
        if (!add_sides(beyond)) return no_memory();
      }
    }
    return glue_refused();
  }

  [[nodiscard]] bool has_partner(Halfedge h) const {
    return partner_[h.index()] != kNone && (partner_[h.index()] & kGroup) == 0;
  }

  // Puts what is to be glued around a face on the queue, once.
  [[nodiscard]] bool add_sides(Face f) {
    if (is_seen_[f.index()]) return true;
    is_seen_[f.index()] = true;
    const Halfedge first = surface_.halfedge(f);
    Halfedge side = first;
    do {
      const Halfedge o = Surface::opposite(side);
      if (has_partner(o) && !queue_.push_back(o)) return false;
      side = surface_.next(side);
    } while (side != first);
    return true;
  }

  // What is refused may be possible once more is glued.
  [[nodiscard]] Result<void> glue_refused() {
    for (int round = 0; round < kRounds && !refused_.empty(); ++round) {
      Array<Pair> pairs = std::exchange(refused_, {});
      for (const Pair& pair : pairs) {
        if (Result<void> done = try_pair(pair); !done) return done;
      }
      if (refused_.size() == pairs.size()) break;
    }
    return {};
  }

  [[nodiscard]] Result<void> try_pair(const Pair& pair) {
    if (!are_partners(pair.h, pair.g)) return {};  // glued with a neighbour
    Result<bool> done = glue(pair.h, pair.g, 1);
    if (done && !done.value()) done = glue_with_neighbours(pair);
    if (!done) return done.error();
    if (done.value()) return {};
    is_refused_[Surface::edge(pair.h).index()] = is_refused_[Surface::edge(pair.g).index()] = true;
    return refused_.push_back(pair) ? Result<void>{} : no_memory();
  }

  [[nodiscard]] Result<bool> glue_with_neighbours(const Pair& pair) {
    const Halfedge before_g = surface_.prev(pair.g);
    const Halfedge before_h = surface_.prev(pair.h);
    const Halfedge after_g = surface_.next(pair.g);
    const bool extends = are_partners(surface_.next(pair.h), before_g) && before_g != pair.h;
    const bool precedes = are_partners(before_h, after_g) && before_h != pair.g;
    if (extends) {
      Result<bool> done = glue(pair.h, pair.g, 2);
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
    const Result<Edge> done = surface_.glue_path(h, g, n);
    if (!done) {
      if (done.error().code == "out-of-memory") return done.error();
      return false;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Index partner = partner_[glued[0][i].index()];
      if ((partner & kGroup) != 0) groups_[partner & ~kGroup] -= 2;
      partner_[glued[0][i].index()] = partner_[glued[1][i].index()] = kNone;
      if (!report_.edges.push_back(Surface::edge(glued[0][i]).index())) return no_memory();
    }
    report_.add(Code::kStitchedEdge, n);
    return true;
  }

  // Of more than two edges in one place, those that follow each other belong together.
  [[nodiscard]] Result<void> close_gaps() {
    if (groups_.empty()) return {};
    closes_gaps_ = true;
    for (const Halfedge h : boundary_) {
      if (partner_[h.index()] == kNone || (partner_[h.index()] & kGroup) == 0) continue;
      const Halfedge g = surface_.next(h);
      if (!are_partners(h, g)) continue;
      const Result<bool> done = glue(h, g, 1);
      if (!done) return done.error();
    }
    if (Result<void> done = glue_refused(); !done) return done;
    for (const Halfedge h : boundary_) {
      const Index group = partner_[h.index()];
      if (group == kNone || (group & kGroup) == 0) continue;
      const std::size_t count = groups_[group & ~kGroup];
      if (count < 2) continue;
      report_.leave(Code::kAmbiguousEdge, [&] { return several_fit(Surface::edge(h), count); });
    }
    return {};
  }

  Surface& surface_;
  double tolerance_;
  Report& report_;
  Array<Halfedge> boundary_;
  Array<Index> place_of_;  // by vertex: of those on the boundary
  std::size_t places_ = 0;
  Array<Index> partner_;       // by halfedge: the one to be glued to, or its group
  Array<std::size_t> groups_;  // how many lie together
  Array<Pair> refused_;
  Array<Halfedge> queue_;
  Array<bool> is_seen_;     // by face
  Array<bool> is_refused_;  // by edge
  bool closes_gaps_ = false;
};

}  // namespace

Result<Report> stitch_boundaries(Surface& surface, const StitchOptions& options) {
  Report report;
  if (Result<void> done = Stitcher(surface, options.tolerance, report).run(); !done) {
    return done.error();
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
