#include <halfedge/repair/by_vertex.h>
#include <halfedge/repair/soup.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>

namespace halfedge::repair {

namespace {

using sentence::list_of;

class Matcher {
 public:
  Matcher(Surface& surface, const Faces& input, Log& log, Crowds& crowds)
      : surface_(surface), input_(input), log_(log), crowds_(crowds) {}

  [[nodiscard]] bool run() {
    drop_duplicates();
    if (!collect_sides()) return false;
    if (find_duplicates_among_pillows()) {
      drop_duplicates();
      if (!collect_sides()) return false;
    }
    return surface_.mate.resize(surface_.faces.corners.size(), kNone) &&
           surface_.split.resize(surface_.vertex_count(), false) && join_sides();
  }

 private:
  struct Side {
    Index high;  // the larger vertex of its edge
    Index side;
  };

  [[nodiscard]] Index face_in_input(Index f) const {
    return input_.source[surface_.faces.source[f]];
  }

  // ---- duplicates

  void drop_duplicates() {
    Faces& faces = surface_.faces;
    Index kept = 0;
    Index corners = 0;
    for (Index f = 0; f < faces.size(); ++f) {
      if (surface_.kept[f] != faces.source[f]) {
        report_duplicate(f);
        continue;
      }
      const Index begin = faces.first[f];
      const Index end = faces.first[f + 1];
      for (Index c = begin; c < end; ++c, ++corners) {
        faces.corners[corners] = faces.corners[c];
        surface_.face_of[corners] = kept;
        if (!faces.doubled.empty()) faces.doubled[corners] = faces.doubled[c];
      }
      surface_.votes[kept] = surface_.votes[f];
      surface_.pillow[kept] = surface_.pillow[f];
      surface_.kept[kept] = faces.source[kept] = faces.source[f];
      faces.first[kept++] = corners - (end - begin);
    }
    faces.first[kept] = corners;
    // No more than there were: these can't fail.
    (void)faces.first.resize(kept + std::size_t{1});
    (void)faces.corners.resize(corners);
    (void)faces.source.resize(kept);
    (void)surface_.face_of.resize(corners);
    (void)surface_.votes.resize(kept);
    (void)surface_.kept.resize(kept);
    (void)surface_.pillow.resize(kept);
    if (!faces.doubled.empty()) (void)faces.doubled.resize(corners);
  }

  void report_duplicate(Index f) {
    const Index face = face_in_input(f);
    log_.mark(face, RepairCode::kDuplicateFace);
    log_.add(RepairCode::kDuplicateFace, [&] {
      const Index original = input_.source[surface_.kept[f]];
      // Named in the order of the witness, as their places in a file are.
      return Error{
          {},
          sentence::of("Face {} has the vertices of face {}, which was left out.", original, face),
          {.faces = {original, face}}};
    });
  }

  // Two faces that are the same but for their direction are a closed surface, if they are alone at
  // their edges; else one goes. Returns whether there is such a one.
  [[nodiscard]] bool find_duplicates_among_pillows() {
    bool found = false;
    for_each_edge([&](Index, std::span<const Side> sides) {
      if (sides.size() <= 2) return;
      for (const Side& side : sides) {
        const Index f = surface_.face_of[side.side];
        if (surface_.pillow[f] == 0) continue;
        found = true;
        const Index first = surface_.pillow[f] == 1 ? f : f - 1;
        surface_.kept[first + 1] = surface_.faces.source[first];
      }
    });
    return found;
  }

  // ---- edges

  [[nodiscard]] Index low_end(Index side) const {
    return std::min(surface_.from(side), surface_.to(side));
  }

  // Sorts the sides by edge.
  [[nodiscard]] bool collect_sides() {
    const Index count = Index(surface_.faces.corners.size());
    if (!sides_.prepare(surface_.vertex_count(), count)) return false;
    for (Index side = 0; side < count; ++side) sides_.count(low_end(side));
    sides_.divide();
    for (Index side = 0; side < count; ++side) {
      const Index from = surface_.from(side);
      const Index to = surface_.to(side);
      sides_.put(std::min(from, to), {std::max(from, to), side});
    }
    sides_.sort([](const Side& a, const Side& b) {
      return a.high != b.high ? a.high < b.high : a.side < b.side;
    });
    return true;
  }

  // Calls `visit` with the smaller vertex and the sides of each edge in turn.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    sides_.for_each_group(
        [](const Side& a, const Side& b) { return a.high == b.high; },
        [&](Index low, Index begin, Index end) { visit(low, sides_.between(begin, end)); });
  }

  // A face has its own copy of a vertex that it comes back to, so no neighbour at the sides there.
  [[nodiscard]] bool is_loose(Index side) const {
    const Array<bool>& doubled = surface_.faces.doubled;
    return !doubled.empty() && (doubled[side] || doubled[surface_.after(side)]);
  }

  [[nodiscard]] bool join_sides() {
    const Array<bool>& doubled = surface_.faces.doubled;
    for (std::size_t c = 0; c < doubled.size(); ++c) {
      if (doubled[c]) surface_.split[surface_.faces.corners[c]] = true;
    }
    bool fits = true;
    for_each_edge([&](Index low, std::span<const Side> sides) {
      if (sides.size() < 2) return;
      Index loose = 0;
      for (const Side& side : sides) loose += is_loose(side.side) ? 1U : 0U;
      if (sides.size() > 2 || loose > 0) surface_.split[low] = surface_.split[sides[0].high] = true;
      if (loose > 0) {
        fits = fits && join_firm(low, sides);
      } else if (sides.size() == 2) {
        surface_.join(sides[0].side, sides[1].side);
      } else {
        fits = fits && add_crowd(low, sides);
      }
    });
    return fits;
  }

  [[nodiscard]] bool join_firm(Index low, std::span<const Side> sides) {
    Array<Side> firm;
    for (const Side& side : sides) {
      if (!is_loose(side.side) && !firm.push_back(side)) return false;
    }
    if (firm.size() == 2) surface_.join(firm[0].side, firm[1].side);
    return firm.size() <= 2 || add_crowd(low, firm.span());
  }

  [[nodiscard]] bool add_crowd(Index low, std::span<const Side> sides) {
    for (const Side& side : sides) {
      log_.mark(face_in_input(surface_.face_of[side.side]), RepairCode::kEdgeWithManyFaces);
      if (!crowds_.sides.push_back(side.side)) return false;
    }
    log_.add(RepairCode::kEdgeWithManyFaces, [&] {
      const Index a = surface_.origin[low];
      const Index b = surface_.origin[sides[0].high];
      Error error{{}, {}, {.vertices = {std::min(a, b), std::max(a, b)}}};
      for (const Side& side : sides) {
        error.witness.faces.push_back(face_in_input(surface_.face_of[side.side]));
      }
      introsort(error.witness.faces);
      error.message = sentence::of(
          "Edge {}-{} is used by {} faces ({}): it was doubled, so that no copy has more than 2.",
          std::min(a, b), std::max(a, b), sides.size(), list_of(error.witness.faces));
      return error;
    });
    return crowds_.end.push_back(Index(crowds_.sides.size()));
  }

  Surface& surface_;
  const Faces& input_;
  Log& log_;
  Crowds& crowds_;
  ByVertex<Side> sides_;
};

}  // namespace

bool match(Surface& surface, const Faces& faces, Log& log, Crowds& crowds) {
  return Matcher(surface, faces, log, crowds).run();
}

}  // namespace halfedge::repair
