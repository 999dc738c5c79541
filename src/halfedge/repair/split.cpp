#include <halfedge/repair/soup.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <tuple>

namespace halfedge::repair {

namespace {

// Gives the fans of a vertex vertices of their own, where they can't share one.
//
// Copies of an edge must differ in a vertex, or they would be one edge again. They do, if their
// fans differ at one end. Where the fans are the same at both ends, each copy but one gets a fan of
// its own at one of them: its faces are cut from their neighbours there. That makes fans only
// smaller, so nothing else becomes wrong.
class Splitter {
 public:
  Splitter(Surface& surface, const Crowds& crowds, const Faces& input, Log& log)
      : surface_(surface), crowds_(crowds), input_(input), log_(log) {}

  [[nodiscard]] bool run(Array<Index>& vertex_of, Array<Index>& copies) {
    bool torn = true;
    while (torn) {
      if (!collect_fans() || !tear_out_clashes(torn)) return false;
    }
    return number_fans(copies) && number_corners(vertex_of);
  }

 private:
  struct Fan {
    Index vertex;
    Index first;  // a corner
    bool closed;
  };

  [[nodiscard]] bool collect_fans() {
    fans_.clear();
    fan_of_.clear();
    const std::size_t corners = surface_.faces.corners.size();
    if (!fan_of_.resize(corners, kNone)) return false;
    for (Index c = 0; c < corners; ++c) {
      if (fan_of_[c] != kNone) continue;
      const Index fan = Index(fans_.size());
      fan_of_[c] = fan;
      const bool closed = walk(c, c, fan);
      if (!closed) (void)walk(c, surface_.before(c), fan);
      if (!fans_.push_back({surface_.faces.corners[c], c, closed})) return false;
    }
    return true;
  }
  // Marks the corners of a fan, leaving the face of `corner` by `side`. Whether it comes round.
  [[nodiscard]] bool walk(Index corner, Index side, Index fan) {
    const Index vertex = surface_.faces.corners[corner];
    for (;;) {
      const Index mate = surface_.mate[side];
      if (mate == kNone) return false;
      corner = surface_.corner_at(mate, vertex);
      if (fan_of_[corner] != kNone) return true;
      fan_of_[corner] = fan;
      side = surface_.other_side(corner, mate);
    }
  }

  // ---- copies of an edge between the same fans

  struct Copy {
    Index low_fan;
    Index high_fan;
    bool single;
    Index side;
  };

  [[nodiscard]] bool tear_out_clashes(bool& torn) {
    torn = false;
    Array<Copy> copies;
    Index begin = 0;
    for (const Index end : crowds_.end) {
      copies.clear();
      for (Index i = begin; i < end; ++i) {
        const Index side = crowds_.sides[i];
        const Index mate = surface_.mate[side];
        if (mate != kNone && mate < side) continue;  // is seen from there
        if (!copies.push_back(copy_of(side))) return false;
      }
      begin = end;
      introsort(copies.begin(), copies.end(), [](const Copy& a, const Copy& b) {
        return std::tie(a.low_fan, a.high_fan, a.single, a.side) <
               std::tie(b.low_fan, b.high_fan, b.single, b.side);
      });
      for (std::size_t i = 1; i < copies.size(); ++i) {
        if (copies[i - 1].low_fan != copies[i].low_fan ||
            copies[i - 1].high_fan != copies[i].high_fan) {
          continue;
        }
        torn = true;
        set_apart(copies[i].side);
      }
    }
    return true;
  }
  [[nodiscard]] Copy copy_of(Index side) const {
    const Index a = fan_of_[side];
    const Index b = fan_of_[surface_.after(side)];
    const bool up = surface_.from(side) < surface_.to(side);
    return {up ? a : b, up ? b : a, surface_.mate[side] == kNone, side};
  }

  // Gives the copy of an edge that has this side a fan of its own at one end, the one where that
  // takes fewer cuts; where none are left to be made there, all of its faces are cut out.
  void set_apart(Index side) {
    const Index low = std::min(surface_.from(side), surface_.to(side));
    const Index high = std::max(surface_.from(side), surface_.to(side));
    const Index cuts_at_low = cuts_to_make(side, low);
    const Index cuts_at_high = cuts_to_make(side, high);
    const bool at_low = cuts_at_high == 0 || (cuts_at_low > 0 && cuts_at_low <= cuts_at_high);
    const Index mate = surface_.mate[side];
    if (cuts_at_low + cuts_at_high > 0) {
      const Index vertex = at_low ? low : high;
      cut(side_beside(side, vertex));
      if (mate != kNone) cut(side_beside(mate, vertex));
      return;
    }
    cut_out(surface_.face_of[side]);
    if (mate != kNone) cut_out(surface_.face_of[mate]);
  }
  [[nodiscard]] Index side_beside(Index side, Index vertex) const {
    return surface_.other_side(surface_.corner_at(side, vertex), side);
  }
  [[nodiscard]] Index cuts_to_make(Index side, Index vertex) const {
    const Index mate = surface_.mate[side];
    const Index cuts = surface_.mate[side_beside(side, vertex)] != kNone ? 1 : 0;
    if (mate == kNone) return cuts;
    return cuts + (surface_.mate[side_beside(mate, vertex)] != kNone ? 1 : 0);
  }
  void cut_out(Index f) {
    for (Index c = surface_.faces.first[f]; c < surface_.faces.first[f + 1]; ++c) {
      cut(c);
      surface_.split[surface_.faces.corners[c]] = true;  // also where there was nothing to cut
    }
  }
  void cut(Index side) {
    const Index mate = surface_.mate[side];
    if (mate == kNone) return;
    const auto [a, b] =
        std::minmax({surface_.origin[surface_.from(side)], surface_.origin[surface_.to(side)]});
    const auto [f, g] = std::minmax({face_in_input(side), face_in_input(mate)});
    log_.mark(f, RepairCode::kNeighboursCut);
    log_.mark(g, RepairCode::kNeighboursCut);
    log_.add(RepairCode::kNeighboursCut, [a = a, b = b, f = f, g = g] {
      return Error{{},
                   sentence::of("Edge {}-{} of faces {} and {} was cut: the copies of an edge with "
                                "more than two faces beside it could not be told apart otherwise.",
                                a, b, f, g),
                   {.vertices = {a, b}, .faces = {f, g}}};
    });
    surface_.split[surface_.from(side)] = surface_.split[surface_.to(side)] = true;
    surface_.cut(side);
  }
  [[nodiscard]] Index face_in_input(Index corner) const {
    return input_.source[surface_.faces.source[surface_.face_of[corner]]];
  }

  // ---- numbers

  // Fans that may share their vertex do. The first fan, or all that share, keep the vertex.
  [[nodiscard]] bool number_fans(Array<Index>& copies) {
    const std::size_t vertices = surface_.vertex_count();
    if (!count_.resize(vertices, 0) || !taken_.resize(vertices, false) ||
        !pinched_.resize(vertices, false) || !shared_.resize(vertices, kNone) ||
        !vertex_of_fan_.recreate(fans_.size())) {
      return false;
    }
    for (const Fan& fan : fans_) ++count_[fan.vertex];
    for (std::size_t i = 0; i < fans_.size(); ++i) {
      const Fan& fan = fans_[i];
      const Index v = fan.vertex;
      const bool shares = !surface_.split[v] && !fan.closed;
      if (shares && shared_[v] != kNone) {
        vertex_of_fan_[i] = shared_[v];
        continue;
      }
      vertex_of_fan_[i] = surface_.number[v];
      if (taken_[v]) {
        vertex_of_fan_[i] = Index(vertices + copies.size());
        if (!copies.push_back(surface_.number[v])) return false;
        if (!surface_.split[v] && !pinched_[v]) report_pinched(v);
        pinched_[v] = true;
      }
      taken_[v] = true;
      if (shares) shared_[v] = vertex_of_fan_[i];
    }
    return true;
  }

  void report_pinched(Index v) {
    log_.add(RepairCode::kPinchedVertex, [&] {
      Error error{{}, {}, {.vertices = {surface_.origin[v]}}};
      for (const Fan& fan : fans_) {
        if (fan.vertex != v) continue;
        error.witness.faces.push_back(face_in_input(fan.first));
      }
      error.message = sentence::of(
          "Vertex {} joins {} separate fans of faces (beginning with faces {}): it was doubled.",
          surface_.origin[v], count_[v], sentence::list_of(error.witness.faces));
      return error;
    });
  }

  [[nodiscard]] bool number_corners(Array<Index>& vertex_of) const {
    if (!vertex_of.recreate(fan_of_.size())) return false;
    for (std::size_t c = 0; c < fan_of_.size(); ++c) vertex_of[c] = vertex_of_fan_[fan_of_[c]];
    return true;
  }

  Surface& surface_;
  const Crowds& crowds_;
  const Faces& input_;
  Log& log_;
  Array<Fan> fans_;
  Array<Index> fan_of_;         // by corner
  Array<Index> vertex_of_fan_;  // by fan
  Array<Index> count_;          // by vertex: its fans
  Array<bool> taken_;           // by vertex: a fan has it
  Array<bool> pinched_;         // by vertex: more than one has
  Array<Index> shared_;         // by vertex: what its open fans share
};

}  // namespace

bool split_vertices(Surface& surface, const Crowds& crowds, const Faces& faces, Log& log,
                    Array<Index>& vertex_of, Array<Index>& copies) {
  return Splitter(surface, crowds, faces, log).run(vertex_of, copies);
}

}  // namespace halfedge::repair
