#include <halfedge/algorithms/adjacency.h>
#include <halfedge/operations/dual.h>
#include <halfedge/sentence.h>

#include <cstddef>

namespace halfedge {

namespace {

Error out_of_memory() { return no_memory_for("the dual"); }

class DualPlanner {
 public:
  DualPlanner(const RawLinks& links, std::span<const float> positions)
      : links_(links), positions_(positions) {}

  Result<DualPlan> run() {
    // Checks all links that are followed below, which so can't lead out of the arrays.
    if (Result<void> done = list_rings(); !done) return done;
    if (!number_items()) return out_of_memory();
    if (Result<void> done = list_faces(); !done) return done;
    if (Result<void> done = check_faces(); !done) return done;
    if (!place_vertices()) return out_of_memory();
    return std::move(plan_);
  }

 private:
  Result<void> list_rings() {
    Result<void> done = adjacency(links_, Ring::kFaceHalfedges, Direction::kCcw, around_face_);
    if (done) done = adjacency(links_, Ring::kVertexFaces, Direction::kCcw, around_vertex_);
    for (const Index h : around_face_.items) {
      const Vertex to = links_.to_vertex(Halfedge(h));
      const Face across = links_.face(RawLinks::opposite(Halfedge(h)));
      if (links_.is_live(to) && links_.is_live(from_vertex(Halfedge(h))) &&
          (!across.valid() || links_.is_live(across)))
        continue;
      return Error{"corrupt-connectivity",
                   sentence::of("The links of halfedge {} lead to items that don't exist, which "
                                "breaks the invariants of a mesh: validate names what is wrong.",
                                h)};
    }
    for (const Index f : around_vertex_.items) {
      if (links_.is_live(Face(f))) continue;
      return Error{"corrupt-connectivity",
                   sentence::of("Face {} doesn't exist, but lies at a vertex, which breaks the "
                                "invariants of a mesh: validate names what is wrong.",
                                f)};
    }
    return done;
  }

  [[nodiscard]] bool is_interior(Vertex v) const {
    const Halfedge anchor = links_.stored_halfedge(v);
    return links_.contain(anchor) && links_.face(anchor).valid();
  }

  bool number_items() {
    DualMaps& maps = plan_.maps;
    if (!maps.faces.resize(links_.slots(Face{})) || !maps.vertices.resize(links_.slots(Vertex{}))) {
      return false;
    }
    Index live = 0;
    for (Index f = 0; f < maps.faces.size(); ++f) {
      maps.faces[f] = links_.is_deleted(Face(f)) ? kNone : live++;
    }
    Index interior = 0;
    for (Index v = 0; v < maps.vertices.size(); ++v) {
      maps.vertices[v] = is_interior(Vertex(v)) ? interior++ : kNone;
    }
    return true;
  }

  // Which edges of the dual meet in the vertex of each face: no two of them may lead to the same
  // face, and the faces between them must form one fan.
  Result<void> check_faces() {
    Array<Index> shared;  // by face: the edge that the face underway shares with it
    if (!shared.resize(links_.slots(Face{}), kNone)) return out_of_memory();
    for (Index f = 0; f < links_.slots(Face{}); ++f) {
      Index fans = 0;
      for_side(f, [&](Halfedge h) {
        fans += !is_interior(from_vertex(h)) && is_interior(links_.to_vertex(h)) ? 1U : 0U;
      });
      if (fans > 1) return is_pinched(f, fans);
      Error refusal;
      for_side(f, [&](Halfedge h) {
        const Index across = links_.face(RawLinks::opposite(h)).index();
        const bool counts = is_interior(from_vertex(h)) || is_interior(links_.to_vertex(h));
        if (across == kNone || !counts || !refusal.code.empty()) return;
        const Index edge = RawLinks::edge(h).index();
        if (across == f) {
          refusal = is_on_both_sides(f, edge);
        } else if (shared[across] != kNone) {
          refusal = share_two_edges(f, across, shared[across], edge);
        }
        shared[across] = edge;
      });
      if (!refusal.code.empty()) return refusal;
      for_side(f, [&](Halfedge h) {
        const Index across = links_.face(RawLinks::opposite(h)).index();
        if (across != kNone) shared[across] = kNone;
      });
    }
    return {};
  }

  bool place_vertices() {
    Array<float>& out = plan_.polygons.positions;
    for (Index f = 0; f < links_.slots(Face{}); ++f) {
      double sum[3] = {0, 0, 0};
      Index corners = 0;
      for_side(f, [&](Halfedge h) {
        const float* const p = &positions_[3 * std::size_t{links_.to_vertex(h).index()}];
        for (int i = 0; i < 3; ++i) sum[i] += double{p[i]};
        ++corners;
      });
      for (const double coordinate : sum) {
        if (corners > 0 && !out.push_back(float(coordinate / corners))) return false;
      }
    }
    return true;
  }

  Result<void> list_faces() {
    for (Index v = 0; v < links_.slots(Vertex{}); ++v) {
      if (plan_.maps.vertices[v] == kNone) continue;
      const Index first = around_vertex_.offsets[v];
      const Index size = around_vertex_.offsets[v + 1] - first;
      if (size < 3) return has_low_valence(v, size);
      bool fits = plan_.polygons.sizes.push_back(size);
      for (Index i = 0; i < size && fits; ++i) {
        const Index f = around_vertex_.items[first + i];
        fits = plan_.polygons.corners.push_back(plan_.maps.faces[f]);
      }
      if (!fits) return out_of_memory();
    }
    return {};
  }

  template <class Visit>
  void for_side(Index f, const Visit& visit) const {
    for (Index i = around_face_.offsets[f]; i < around_face_.offsets[f + 1]; ++i) {
      visit(Halfedge(around_face_.items[i]));
    }
  }
  [[nodiscard]] Vertex from_vertex(Halfedge h) const {
    return links_.to_vertex(RawLinks::opposite(h));
  }

  static Error has_low_valence(Index v, Index valence) {
    return {"degree-below-three",
            sentence::of("Vertex {} has valence {}: its face in the dual would have as many "
                         "corners, expected 3 or more.",
                         v, valence),
            {.vertices = {v}}};
  }
  static Error is_on_both_sides(Index f, Index edge) {
    return {"same-face-twice",
            sentence::of("Face {} is on both sides of edge {}: the dual would have an edge from a "
                         "vertex to itself.",
                         f, edge),
            {.edges = {edge}, .faces = {f}}};
  }
  static Error share_two_edges(Index f, Index across, Index first, Index second) {
    return {"duplicate-edge",
            sentence::of("Faces {} and {} share edges {} and {}: the dual would have two edges "
                         "between the same vertices.",
                         f, across, first, second),
            {.edges = {first, second}, .faces = {f, across}}};
  }
  static Error is_pinched(Index f, Index fans) {
    return {"pinched-vertex",
            sentence::of("The corners of face {} that are not on the boundary form {} runs: the "
                         "dual would be pinched there, expected one run.",
                         f, fans),
            {.faces = {f}}};
  }

  const RawLinks& links_;
  std::span<const float> positions_;
  Adjacency around_face_;
  Adjacency around_vertex_;
  DualPlan plan_;
};

}  // namespace

Result<DualPlan> plan_dual(const RawLinks& links, std::span<const float> positions) {
  return DualPlanner(links, positions).run();
}

}  // namespace halfedge
