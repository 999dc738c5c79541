#include <halfedge/build/cycle.h>
#include <halfedge/build/diagnose.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <tuple>

namespace halfedge {

namespace {

using internal::Cycle;
using sentence::count_of;
using sentence::list_of;

// A face's side of an edge: it runs from `corner` to the next corner of the face.
struct Side {
  Index low;   // the smaller vertex of the edge
  Index high;  // the larger one
  Index corner;
  Index face;

  [[nodiscard]] bool joins_same(const Side& other) const {
    return low == other.low && high == other.high;
  }
};

struct FaceCycle {
  Cycle cycle;
  Index face;
};

class Neighbours {
 public:
  Neighbours(FaceTable& table, std::size_t vertex_count, ProblemSink& problems)
      : table_(table), vertex_count_(vertex_count), problems_(problems) {}

  [[nodiscard]] bool run() {
    return collect_sides() && find_repeated_faces() && check_edges() && check_vertices();
  }

 private:
  // All sides, sorted so that those of an edge are neighbours, by face.
  [[nodiscard]] bool collect_sides() {
    if (!sides_.reserve(table_.corners.size())) return false;
    for (std::size_t f = 0; f < table_.faces.size(); ++f) {
      const FaceTable::Face& face = table_.faces[f];
      if (face.ignored) continue;
      for (Index c = face.first; c < face.first + face.size; ++c) {
        const Index a = table_.corners[c];
        const Index b = table_.corners[table_.corner_after(c, Index(f))];
        (void)sides_.push_back({std::min(a, b), std::max(a, b), c, Index(f)});  // reserved above
      }
    }
    introsort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    return true;
  }

  [[nodiscard]] bool runs_up(const Side& side) const {
    return table_.corners[side.corner] == side.low;
  }

  // Calls `visit` with the sides of each edge in turn.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    const std::span<const Side> sides = sides_.span();
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while (end < sides.size() && sides[end].joins_same(sides[begin])) ++end;
      visit(sides.subspan(begin, end - begin));
    }
  }

  // What the sides of an edge that aren't ignored amount to.
  struct Edge {
    const Side* first = nullptr;
    const Side* second = nullptr;
    std::size_t count = 0;
    bool manifold = true;
  };
  [[nodiscard]] Edge edge_of(std::span<const Side> sides) const {
    Edge edge;
    for (const Side& side : sides) {
      if (table_.faces[side.face].ignored) continue;
      ++edge.count;
      (edge.count == 1 ? edge.first : edge.second) = &side;
    }
    edge.manifold =
        edge.count < 2 || (edge.count == 2 && runs_up(*edge.first) != runs_up(*edge.second));
    return edge;
  }

  // Faces with the same vertices in the same cyclic order, in either orientation. Only where an
  // edge has too many faces can they be wrong: two triangles back to back are a closed surface.
  [[nodiscard]] bool find_repeated_faces() {
    Array<Index> suspects;
    bool fits = true;
    for_each_edge([&](std::span<const Side> sides) {
      if (edge_of(sides).manifold) return;
      for (const Side& side : sides) fits = fits && suspects.push_back(side.face);
    });
    if (!fits) return false;
    introsort(suspects.begin(), suspects.end());
    Index* const end = std::unique(suspects.begin(), suspects.end());

    Array<FaceCycle> cycles;
    for (const Index* f = suspects.begin(); f != end; ++f) {
      if (!cycles.push_back({Cycle(table_.corners_of(*f)), *f})) return false;
    }
    introsort(cycles.begin(), cycles.end(), [](const FaceCycle& a, const FaceCycle& b) {
      const int order = compare(a.cycle, b.cycle);
      return order != 0 ? order < 0 : a.face < b.face;
    });
    return report_repeats(cycles);
  }

  [[nodiscard]] bool report_repeats(const Array<FaceCycle>& cycles) {
    struct Repeat {
      Index face;
      Index original;
      bool turned_over;
    };
    Array<Repeat> repeats;
    std::size_t original = 0;
    for (std::size_t i = 1; i < cycles.size(); ++i) {
      if (compare(cycles[original].cycle, cycles[i].cycle) != 0) {
        original = i;
        continue;
      }
      const bool turned_over = cycles[original].cycle.reversed != cycles[i].cycle.reversed;
      if (!repeats.push_back({cycles[i].face, cycles[original].face, turned_over})) return false;
    }
    introsort(repeats.begin(), repeats.end(),
              [](const Repeat& a, const Repeat& b) { return a.face < b.face; });
    for (const Repeat& repeat : repeats) {
      table_.faces[repeat.face].ignored = true;
      problems_.add([&] {
        const std::span<const Index> corners = table_.corners_of(repeat.face);
        return Error{"duplicate-face",
                     sentence::of("Face {} repeats face {}{}: both have the vertices {}.",
                                  repeat.face, repeat.original,
                                  repeat.turned_over ? " turned over" : "", list_of(corners)),
                     {.vertices = corners, .faces = {repeat.original, repeat.face}}};
      });
    }
    return true;
  }

  // Edges with too many faces, or two that run the same way; pairs up the corners at the others.
  [[nodiscard]] bool check_edges() {
    if (!face_of_.recreate(table_.corners.size()) || !mate_.resize(table_.corners.size(), kNone) ||
        !suspect_.resize(vertex_count_, false)) {
      return false;
    }
    for_each_edge([&](std::span<const Side> sides) {
      for (const Side& side : sides) face_of_[side.corner] = side.face;
      const Edge edge = edge_of(sides);
      if (!edge.manifold) {
        suspect_[sides[0].low] = suspect_[sides[0].high] = true;
        problems_.add([&] { return edge.count > 2 ? too_many(sides) : same_way(edge); });
      } else if (edge.count == 2) {
        mate_[edge.first->corner] = edge.second->corner;
        mate_[edge.second->corner] = edge.first->corner;
      }
    });
    return true;
  }

  [[nodiscard]] static Error too_many(std::span<const Side> sides) {
    Error error{"edge-with-many-faces", {}, {.vertices = {sides[0].low, sides[0].high}}};
    for (const Side& side : sides) error.witness.faces.push_back(side.face);
    error.message =
        sentence::of("Edge {}-{} is used by {} faces ({}); a manifold edge has at most 2.",
                     sides[0].low, sides[0].high, sides.size(), list_of(error.witness.faces));
    return error;
  }

  [[nodiscard]] Error same_way(const Edge& edge) const {
    const Side& side = *edge.first;
    const Index from = table_.corners[side.corner];
    const Index to = from == side.low ? side.high : side.low;
    return Error{"opposite-orientation",
                 sentence::of("Faces {} and {} both run from vertex {} to vertex {}; neighbours "
                              "must run along their edge in opposite directions.",
                              side.face, edge.second->face, from, to),
                 {.vertices = {from, to}, .faces = {side.face, edge.second->face}}};
  }

  // A fan is a maximal sequence of faces around a vertex, each joined to the next by an edge.
  struct Fan {
    Index vertex;
    Index face;
    bool closed;
  };

  // Vertices at which a closed fan meets another fan: no rotation reaches both. At the ends of a
  // wrong edge fans have no meaning, and that edge has been reported.
  [[nodiscard]] bool check_vertices() {
    Array<Fan> fans;
    if (!collect_fans(fans)) return false;
    introsort(fans.begin(), fans.end(), [](const Fan& a, const Fan& b) {
      return std::tie(a.vertex, a.face) < std::tie(b.vertex, b.face);
    });
    const std::span<const Fan> all = fans.span();
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      std::size_t closed = 0;
      for (; end < all.size() && all[end].vertex == all[begin].vertex; ++end) {
        closed += all[end].closed ? 1U : 0U;
      }
      if (closed == 0 || end - begin == 1 || suspect_[all[begin].vertex]) continue;
      problems_.add([&] { return pinched(all.subspan(begin, end - begin), closed); });
    }
    return true;
  }

  [[nodiscard]] bool collect_fans(Array<Fan>& fans) const {
    Array<bool> visited;
    if (!visited.resize(table_.corners.size(), false)) return false;
    for (std::size_t f = 0; f < table_.faces.size(); ++f) {
      const FaceTable::Face& face = table_.faces[f];
      if (face.ignored) continue;
      for (Index c = face.first; c < face.first + face.size; ++c) {
        if (visited[c]) continue;
        Index at = c;
        for (; at != kNone && !visited[at]; at = clockwise(at)) visited[at] = true;
        const bool closed = at != kNone;
        for (at = counter_clockwise(c); at != kNone && !visited[at]; at = counter_clockwise(at)) {
          visited[at] = true;
        }
        if (!fans.push_back({table_.corners[c], Index(f), closed})) return false;
      }
    }
    return true;
  }

  // The corner of the same vertex in the next face clockwise around it, and counter-clockwise.
  [[nodiscard]] Index clockwise(Index c) const {
    const Index mate = mate_[c];
    return mate == kNone ? kNone : table_.corner_after(mate, face_of_[mate]);
  }
  [[nodiscard]] Index counter_clockwise(Index c) const {
    return mate_[table_.corner_before(c, face_of_[c])];
  }

  [[nodiscard]] static Error pinched(std::span<const Fan> fans, std::size_t closed) {
    Error error{"pinched-vertex", {}, {.vertices = {fans[0].vertex}}};
    for (const Fan& fan : fans) error.witness.faces.push_back(fan.face);
    error.message = sentence::of(
        "Vertex {} joins {} of faces (beginning with faces {}), {} of them closed; a vertex with a "
        "closed fan can have no other.",
        fans[0].vertex, count_of(fans.size(), "separate fan"), list_of(error.witness.faces),
        closed);
    return error;
  }

  FaceTable& table_;
  std::size_t vertex_count_;
  ProblemSink& problems_;
  Array<Side> sides_;
  Array<Index> face_of_;  // by corner
  Array<Index> mate_;     // by corner: the corner that begins the other side of its edge
  Array<bool> suspect_;   // by vertex: an end of a wrong edge
};

}  // namespace

bool diagnose_neighbours(FaceTable& table, std::size_t vertex_count, ProblemSink& problems) {
  return Neighbours(table, vertex_count, problems).run();
}

}  // namespace halfedge
