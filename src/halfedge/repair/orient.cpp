#include <halfedge/repair/soup.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstdint>

namespace halfedge::repair {

namespace {

// Turns the faces of each component, as joined at edges with two faces.
class Orienter {
 public:
  Orienter(Surface& surface, const Faces& input, Log& log)
      : surface_(surface), input_(input), log_(log) {}

  [[nodiscard]] bool run() {
    const std::size_t count = surface_.faces.size();
    if (!surface_.flipped.resize(count, false)) return false;
    if (all_agree()) return true;
    if (!component_.reserve(count) || !reached_.resize(count, false)) return false;
    for (Index seed = 0; seed < count; ++seed) {
      if (reached_[seed]) continue;
      spread(seed);
      if (count_disagreements() > 0 && !settle()) return false;
      vote();
      cut_disagreements();
      report_turned();
    }
    return true;
  }

 private:
  // Whether the two faces at a side run along it in the same direction.
  [[nodiscard]] bool disagrees(Index side) const {
    const Index mate = surface_.mate[side];
    return mate != kNone && surface_.runs_up(side) == surface_.runs_up(mate);
  }
  [[nodiscard]] bool all_agree() const {
    for (Index side = 0; side < surface_.mate.size(); ++side) {
      if (disagrees(side)) return false;
    }
    return true;
  }
  template <class Visit>
  void for_each_side(Index f, const Visit& visit) const {
    for (Index c = surface_.faces.first[f]; c < surface_.faces.first[f + 1]; ++c) visit(c);
  }

  // Collects the component of `seed`, turning each face to agree with the one it is reached from.
  void spread(Index seed) {
    component_.clear();
    reach(seed);
    surface_.flipped[seed] = false;
    std::size_t done = 0;
    while (done < component_.size()) {  // it grows on the way
      for_each_side(component_[done++], [&](Index side) {
        const Index mate = surface_.mate[side];
        if (mate == kNone) return;
        const Index next = surface_.face_of[mate];
        if (reached_[next]) return;
        reach(next);
        surface_.flipped[next] = false;
        surface_.flipped[next] = disagrees(side);
      });
    }
  }
  void reach(Index f) {
    reached_[f] = true;
    (void)component_.push_back(f);  // reserved for all faces
  }

  // Two for each edge.
  [[nodiscard]] std::size_t count_disagreements() const {
    std::size_t count = 0;
    for (const Index f : component_) {
      for_each_side(f, [&](Index side) { count += disagrees(side) ? 1U : 0U; });
    }
    return count;
  }

  // ---- one-sided components

  // At which edges the faces can't agree depends on how orientation is spread. Tries that of the
  // input and those of a few seeds, shortens the line of such edges, and keeps the shortest.
  [[nodiscard]] bool settle() {
    constexpr std::size_t kSeeds = 4;
    constexpr int kSweepsInVain = 3;
    Array<Index> members;
    Array<bool> best;
    if (!members.assign(component_.span()) || !best.recreate(members.size()) ||
        (gain_.empty() && !gain_.resize(surface_.faces.size(), 0))) {
      return false;
    }
    introsort(members.begin(), members.end());
    std::size_t fewest = SIZE_MAX;
    const auto keep_if_better = [&] {
      const std::size_t found = count_disagreements();
      if (found >= fewest) return false;
      fewest = found;
      for (std::size_t i = 0; i < members.size(); ++i) best[i] = surface_.flipped[members[i]];
      return true;
    };
    for (std::size_t attempt = 0; attempt <= kSeeds; ++attempt) {
      for (const Index f : members) reached_[f] = attempt == 0;
      if (attempt == 0) {
        for (const Index f : members) surface_.flipped[f] = false;
      } else {
        spread(members[(attempt - 1) * (members.size() - 1) / kSeeds]);
      }
      find_gains(members);
      if (!improve(members)) return false;
      (void)keep_if_better();
      for (int sweep = 0, in_vain = 0; in_vain < kSweepsInVain && budget_ > 0; ++sweep) {
        for (std::size_t i = 0; i < members.size() && budget_ > 0; ++i) {
          const Index f = members[sweep % 2 == 0 ? i : members.size() - 1 - i];
          if (gain_[f] == 0) turn(f);
        }
        if (!improve(members)) return false;
        in_vain = keep_if_better() ? 0 : in_vain + 1;
      }
    }
    for (std::size_t i = 0; i < members.size(); ++i) surface_.flipped[members[i]] = best[i];
    return true;
  }

  // How many more of the sides of a face disagree than agree; and a limit to what is tried next, as
  // a few faces with very many sides could be turned very often.
  void find_gains(const Array<Index>& members) {
    budget_ = 64;
    for (const Index f : members) {
      gain_[f] = 0;
      for_each_side(f, [&](Index side) {
        if (surface_.mate[side] != kNone) gain_[f] += disagrees(side) ? 1 : -1;
        budget_ += 32;
      });
    }
  }
  void turn(Index f) {
    surface_.flipped[f] = !surface_.flipped[f];
    gain_[f] = -gain_[f];
    for_each_side(f, [&](Index side) {
      --budget_;
      if (surface_.mate[side] != kNone) {
        gain_[surface_.face_of[surface_.mate[side]]] += disagrees(side) ? 2 : -2;
      }
    });
  }

  // Turns single faces as long as that makes more neighbours agree.
  [[nodiscard]] bool improve(const Array<Index>& members) {
    Array<Index> waiting;
    for (const Index f : members) {
      if (gain_[f] > 0 && !waiting.push_back(f)) return false;
    }
    bool fits = true;
    while (!waiting.empty() && budget_ > 0) {
      const Index f = waiting[waiting.size() - 1];
      waiting.pop_back();
      if (gain_[f] <= 0) continue;
      turn(f);
      for_each_side(f, [&](Index side) {
        const Index mate = surface_.mate[side];
        if (mate == kNone || gain_[surface_.face_of[mate]] <= 0) return;
        fits = fits && waiting.push_back(surface_.face_of[mate]);
      });
      if (!fits) return false;
    }
    return true;
  }

  void cut_disagreements() {
    for (const Index f : component_) {
      for_each_side(f, [&](Index side) {
        if (!disagrees(side)) return;
        const Index mate = surface_.mate[side];
        const Index a = face_in_input(f);
        const Index b = face_in_input(surface_.face_of[mate]);
        const Index from = surface_.origin[surface_.from(side)];
        const Index to = surface_.origin[surface_.to(side)];
        log_.mark(a, RepairCode::kNonOrientable);
        log_.mark(b, RepairCode::kNonOrientable);
        log_.add(RepairCode::kNonOrientable, [&] {
          return Error{
              {},
              sentence::of(
                  "Edge {}-{} between faces {} and {} was cut: the surface is one-sided there.",
                  std::min(from, to), std::max(from, to), std::min(a, b), std::max(a, b)),
              {.vertices = {std::min(from, to), std::max(from, to)},
               .faces = {std::min(a, b), std::max(a, b)}}};
        });
        surface_.split[surface_.from(side)] = surface_.split[surface_.to(side)] = true;
        surface_.cut(side);
      });
    }
  }

  // ---- which way round

  void vote() {
    std::int64_t turned = 0;
    for (const Index f : component_) {
      turned +=
          surface_.flipped[f] ? std::int64_t{surface_.votes[f]} : -std::int64_t{surface_.votes[f]};
    }
    if (turned < 0 || (turned == 0 && !is_inside_out())) return;
    for (const Index f : component_) surface_.flipped[f] = !surface_.flipped[f];
  }

  // Whether the component is closed and encloses a negative volume.
  [[nodiscard]] bool is_inside_out() const {
    const float* o = surface_.position(surface_.faces.corners[surface_.faces.first[component_[0]]]);
    double volume = 0;
    bool is_closed = true;
    for (const Index f : component_) {
      const Index first = surface_.faces.first[f];
      for_each_side(f, [&](Index side) {
        is_closed = is_closed && surface_.mate[side] != kNone && !disagrees(side);
        if (side == first || surface_.after(side) == first) return;
        const double part = determinant(o, surface_.position(surface_.from(first)),
                                        surface_.position(surface_.from(side)),
                                        surface_.position(surface_.to(side)));
        volume += surface_.flipped[f] ? -part : part;
      });
    }
    return is_closed && volume < 0;
  }
  [[nodiscard]] static double determinant(const float* o, const float* a, const float* b,
                                          const float* c) {
    const auto at = [o](const float* p, int i) { return double{p[i]} - double{o[i]}; };
    return at(a, 0) * (at(b, 1) * at(c, 2) - at(b, 2) * at(c, 1)) +
           at(a, 1) * (at(b, 2) * at(c, 0) - at(b, 0) * at(c, 2)) +
           at(a, 2) * (at(b, 0) * at(c, 1) - at(b, 1) * at(c, 0));
  }

  void report_turned() {
    for (const Index f : component_) {
      if (!surface_.flipped[f]) continue;
      const Index face = face_in_input(f);
      log_.mark(face, RepairCode::kOppositeOrientation);
      log_.add(RepairCode::kOppositeOrientation, [&] {
        return Error{{},
                     sentence::of("Face {} was turned over, to agree with its neighbours.", face),
                     {.faces = {face}}};
      });
    }
  }
  [[nodiscard]] Index face_in_input(Index f) const {
    return input_.source[surface_.faces.source[f]];
  }

  Surface& surface_;
  const Faces& input_;
  Log& log_;
  Array<Index> component_;
  Array<bool> reached_;
  Array<std::int32_t> gain_;  // by face, see find_gains
  std::int64_t budget_ = 0;
};

}  // namespace

bool orient(Surface& surface, const Faces& faces, Log& log) {
  return Orienter(surface, faces, log).run();
}

}  // namespace halfedge::repair
