#include <halfedge/mend/face_shape.h>
#include <halfedge/mend/short_edges.h>
#include <halfedge/refusals.h>
#include <halfedge/sentence.h>

namespace halfedge::mend {

using refusals::refusal;

bool ShortEdges::is_short(Edge e) const {
  return length_of(surface_, Halfedge(2 * e.index())) <= tolerance_;
}

Result<void> ShortEdges::collapse_all(Report& left) {
  for (Index i = 0; i < surface_.edge_slots(); ++i) {
    const Edge e(i);
    if (!surface_.is_live(e) || !is_short(e)) continue;
    const Halfedge side(2 * i);
    Result<void> done = collapse(side);
    if (done) continue;
    if (done.error().code == "out-of-memory") return done;
    left.leave(Code::kZeroLengthEdge, [&] {
      return refusal(
          "",
          sentence::of("{} has a length of {} but can't be collapsed: {}", e,
                       sentence::number(length_of(surface_, side)), reason_of(done.error())),
          {.edges = {e.index()}});
    });
  }
  return {};
}

Result<void> ShortEdges::collapse(Halfedge side) {
  const Halfedge best = best_side(side);
  Result<void> refused;
  for (const Halfedge h : {best, Surface::opposite(best)}) {
    if (folds(h)) {
      refused = refusal("", sentence::of("a face at {} would fold over", surface_.from_vertex(h)));
      continue;
    }
    // Before, since it is the vertex that goes whose faces have to be known.
    if (!list_moved(h) || !report_.vertices.reserve_more(1)) {
      return refusals::no_memory("the faces to be removed");
    }
    Result<Vertex> kept = surface_.collapse(h);
    if (!kept) return kept;  // the other way round it would be refused as well
    ++count_;
    report_.add(Code::kCollapsedEdge);
    (void)report_.vertices.push_back(kept.value().index());
    return {};
  }
  return refused;
}

// A vertex that many others are collapsed into, one by one, should be the one that stays: around
// both in step, the smaller valence ends the search.
Halfedge ShortEdges::best_side(Halfedge side) const {
  const Halfedge other = Surface::opposite(side);
  const bool from_boundary = surface_.is_boundary(surface_.from_vertex(side));
  if (from_boundary != surface_.is_boundary(surface_.to_vertex(side))) {
    return from_boundary ? other : side;
  }
  Halfedge at_from = surface_.rotate_cw(side);
  Halfedge at_to = surface_.rotate_cw(other);
  while (at_from != side && at_to != other) {
    at_from = surface_.rotate_cw(at_from);
    at_to = surface_.rotate_cw(at_to);
  }
  return at_from == side ? side : other;
}

// Whether a face turns over when the vertex that `h` leaves goes where `h` leads.
bool ShortEdges::folds(Halfedge h) const {
  const Vector from = point_of(surface_, surface_.from_vertex(h));
  const Vector to = point_of(surface_, surface_.to_vertex(h));
  if (length(to - from) == 0) return false;
  Halfedge out = h;
  do {
    const Face f = surface_.face(out);
    if (f.valid() && !shape_of(surface_, f).is_thin(tolerance_)) {
      const Vector before = area_vector(surface_, out, from);
      if (dot(before, area_vector(surface_, out, to)) < 0) return true;
    }
    out = surface_.rotate_cw(out);
  } while (out != h);
  return false;
}

bool ShortEdges::list_moved(Halfedge h) {
  moved_.clear();
  Halfedge out = h;
  do {
    if (surface_.face(out).valid() && !moved_.push_back(surface_.face(out))) return false;
    out = surface_.rotate_cw(out);
  } while (out != h);
  return true;
}

}  // namespace halfedge::mend
