#include <halfedge/build/cycle.h>
#include <halfedge/repair/by_vertex.h>
#include <halfedge/repair/soup.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <tuple>

namespace halfedge::repair {

namespace {

using internal::Cycle;

class Arranger {
 public:
  Arranger(const Polygons& input, const Vertices& vertices, const Faces& faces, Surface& out)
      : input_(input), vertices_(vertices), faces_(faces), out_(out) {}

  [[nodiscard]] bool run() {
    out_.input = &input_;
    if (!number_vertices() || !sort_faces() || !copy_faces()) return false;
    weigh_duplicates();
    return true;
  }

 private:
  // What a sort compares first, without a look at the corners.
  struct Key {
    Index second;
    Index last;
    Index face;
    Index start;
    bool reversed;
  };

  // By position, then by number.
  [[nodiscard]] bool number_vertices() {
    struct Placed {
      float x, y, z;
      Index vertex;
    };
    const std::size_t count = vertices_.size();
    Array<Placed> placed;
    if (!placed.recreate(count) || !out_.origin.recreate(count) || !out_.number.recreate(count) ||
        !rank_.recreate(count)) {
      return false;
    }
    for (Index v = 0; v < count; ++v) {
      const float* p = &input_.positions[3 * std::size_t{vertices_.origin[v]}];
      placed[v] = {p[0], p[1], p[2], v};
    }
    introsort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
      return std::tie(a.x, a.y, a.z, a.vertex) < std::tie(b.x, b.y, b.z, b.vertex);
    });
    for (Index rank = 0; rank < count; ++rank) {
      const Index v = placed[rank].vertex;
      rank_[v] = rank;
      out_.number[rank] = v;
      out_.origin[rank] = vertices_.origin[v];
    }
    return true;
  }

  [[nodiscard]] bool sort_faces() {
    const std::size_t corner_count = faces_.corners.size();
    if (!corners_.recreate(corner_count) || !keys_.prepare(vertices_.size(), faces_.size())) {
      return false;
    }
    for (std::size_t c = 0; c < corner_count; ++c) corners_[c] = rank_[faces_.corners[c]];
    const auto smallest = [&](Index f) {
      const std::span<const Index> corners = corners_of(f);
      return *std::min_element(corners.begin(), corners.end());
    };
    for (Index f = 0; f < faces_.size(); ++f) keys_.count(smallest(f));
    keys_.divide();
    for (Index f = 0; f < faces_.size(); ++f) {
      const Cycle cycle(corners_of(f));
      keys_.put(cycle.at(0), {cycle.at(1), cycle.at(cycle.corners.size() - 1), f,
                              Index(cycle.start), cycle.reversed});
    }
    keys_.sort([this](const Key& a, const Key& b) { return less(a, b); });
    return true;
  }

  [[nodiscard]] std::span<const Index> corners_of(Index f) const {
    return corners_.span().subspan(faces_.first[f], faces_.first[f + 1] - faces_.first[f]);
  }
  [[nodiscard]] bool less(const Key& a, const Key& b) const {
    if (a.second != b.second) return a.second < b.second;
    if (a.last != b.last) return a.last < b.last;
    const int order = compare_all(a, b);
    if (order != 0) return order < 0;
    return std::tie(a.reversed, a.start, a.face) < std::tie(b.reversed, b.start, b.face);
  }
  [[nodiscard]] int compare_all(const Key& a, const Key& b) const {
    const std::span<const Index> of_a = corners_of(a.face);
    const std::span<const Index> of_b = corners_of(b.face);
    return of_a.size() == 3 && of_b.size() == 3 ? 0 : compare(Cycle(of_a), Cycle(of_b));
  }

  [[nodiscard]] bool copy_faces() {
    Faces& to = out_.faces;
    const std::size_t count = faces_.size();
    if (!to.first.recreate(count + 1) || !to.corners.recreate(corners_.size()) ||
        !to.source.recreate(count) || !to.doubled.recreate(faces_.doubled.size()) ||
        !out_.face_of.recreate(corners_.size()) || !out_.kept.recreate(count) ||
        !out_.votes.resize(count, 1) || !out_.pillow.resize(count, 0)) {
      return false;
    }
    Index at = 0;
    to.first[0] = 0;
    for (Index k = 0; k < count; ++k) {
      const Index f = keys_[k].face;
      for (Index c = faces_.first[f]; c < faces_.first[f + 1]; ++c, ++at) {
        to.corners[at] = corners_[c];
        out_.face_of[at] = k;
        if (!to.doubled.empty()) to.doubled[at] = faces_.doubled[c];
      }
      to.first[k + 1] = at;
      to.source[k] = f;
      out_.kept[k] = f;
    }
    return true;
  }

  // Of each set of duplicates, the first that runs as most of them do is kept. Two that run
  // opposite ways may be the two sides of a closed surface: `match` sees to them.
  void weigh_duplicates() {
    keys_.for_each_group([this](const Key& a, const Key& b) { return is_same(a, b); },
                         [this](Index, Index begin, Index end) {
                           if (end - begin > 1) weigh(begin, end);
                         });
  }
  [[nodiscard]] bool is_same(const Key& a, const Key& b) const {
    return a.second == b.second && a.last == b.last && compare_all(a, b) == 0;
  }
  void weigh(Index begin, Index end) {
    Index turned = begin;
    while (turned < end && !keys_[turned].reversed) ++turned;
    const Index forwards = turned - begin;
    const Index backwards = end - turned;
    const Index kept = forwards >= backwards ? begin : turned;
    const Index votes = std::max(forwards, backwards) - std::min(forwards, backwards);
    const bool is_pillow = forwards == 1 && backwards == 1;
    for (Index k = begin; k < end; ++k) {
      if (!is_pillow) out_.kept[k] = keys_[kept].face;
      out_.votes[k] = votes;
    }
    if (is_pillow) out_.pillow[begin] = 1, out_.pillow[begin + 1] = 2;
  }

  const Polygons& input_;
  const Vertices& vertices_;
  const Faces& faces_;
  Surface& out_;
  Array<Index> rank_;     // by place in Vertices
  Array<Index> corners_;  // ranks, in the order of the input
  ByVertex<Key> keys_;
};

}  // namespace

bool arrange(const Polygons& input, const Vertices& vertices, const Faces& faces, Surface& out) {
  return Arranger(input, vertices, faces, out).run();
}

}  // namespace halfedge::repair
