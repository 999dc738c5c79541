#include <halfedge/mend/face_shape.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/mend/short_edges.h>
#include <halfedge/refusals.h>
#include <halfedge/sentence.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace halfedge::mend {

namespace {

using refusals::refusal;

constexpr int kRounds = 32;

Failure thin(Face f, const FaceShape& shape, const std::string& why) {
  return refusal("",
                 sentence::of("{} is {} long and {} wide {}", f, sentence::number(shape.length),
                              sentence::number(shape.width), why),
                 {.faces = {f.index()}});
}

Failure unfinished(Edge e, double length) {
  return refusal(
      "",
      sentence::of(
          "{} has a length of {} and was not reached, expected less to do: repair it once more", e,
          sentence::number(length)),
      {.edges = {e.index()}});
}

class Remover {
 public:
  Remover(Surface& surface, double tolerance, Report& report)
      : surface_(surface),
        tolerance_(tolerance),
        report_(report),
        short_edges_(surface, tolerance, report) {}

  [[nodiscard]] Result<void> run() {
    // What is refused may be possible once more is done: until a round does nothing.
    Report left;
    bool is_done = false;
    for (int round = 0; round < kRounds && !is_done; ++round) {
      left = {};
      is_unfinished_ = false;
      const std::size_t before = steps();
      if (Result<void> done = short_edges_.collapse_all(left); !done) return done;
      if (Result<void> done = remove_thin_faces(left); !done) return done;
      is_done = steps() == before && !is_unfinished_;
    }
    if (!is_done) list_unfinished(left = {});
    for (const Code code : {Code::kZeroLengthEdge, Code::kDegenerateFace}) {
      report_.add(code, left.count(code));
    }
    report_.problems = std::move(left.problems);
    keep_live<Vertex>(report_.vertices);
    keep_live<Edge>(report_.edges);
    keep_live<Face>(report_.faces);
    return {};
  }

 private:
  static Failure no_memory() { return refusals::no_memory("the faces to be removed"); }

  [[nodiscard]] Vector at(Vertex v) const { return point_of(surface_, v); }
  [[nodiscard]] std::size_t steps() const { return steps_ + short_edges_.count(); }

  // Each face, and those that are touched when it goes.
  [[nodiscard]] Result<void> remove_thin_faces(Report& left) {
    std::size_t steps_left = 20 * (std::size_t{surface_.face_slots()} + 50);
    for (Index i = 0; i < surface_.face_slots(); ++i) {
      work_.clear();
      if (!work_.push_back(Face(i))) return no_memory();
      while (!work_.empty() && steps_left > 0) {
        --steps_left;
        const Face f = work_[work_.size() - 1];
        work_.pop_back();
        if (!surface_.is_live(f)) continue;
        const FaceShape shape = shape_of(surface_, f);
        if (!shape.is_thin(tolerance_)) continue;
        Result<void> done = remove(f, shape);
        if (done) continue;
        if (done.error().code == "out-of-memory") return done;
        left.leave(Code::kDegenerateFace, [&] {
          return thin(f, shape, sentence::of("but can't be removed: {}", reason_of(done.error())));
        });
      }
    }
    is_unfinished_ = steps_left == 0;
    return {};
  }

  void list_unfinished(Report& left) const {
    for (Index i = 0; i < surface_.edge_slots(); ++i) {
      const Edge e(i);
      if (!surface_.is_live(e) || !short_edges_.is_short(e)) continue;
      left.leave(Code::kZeroLengthEdge,
                 [&] { return unfinished(e, length_of(surface_, Halfedge(2 * i))); });
    }
    for (Index i = 0; i < surface_.face_slots(); ++i) {
      const Face f(i);
      if (!surface_.is_live(f)) continue;
      const FaceShape shape = shape_of(surface_, f);
      if (!shape.is_thin(tolerance_)) continue;
      left.leave(Code::kDegenerateFace, [&] {
        return thin(f, shape, "and was not reached, expected less to do: repair it once more");
      });
    }
  }

  [[nodiscard]] Result<void> remove(Face f, const FaceShape& shape) {
    if (shape.least <= shape.limit(tolerance_)) {
      Result<void> done = collapse(shape.shortest);
      if (done || !hangs_by(f, shape.shortest)) return done;
      return delete_at_boundary(f, surface_.next(shape.shortest));
    }
    if (!is_triangle(surface_, f)) return cut_up(f);
    const Halfedge beyond = Surface::opposite(shape.longest);
    if (surface_.is_boundary(beyond)) return delete_at_boundary(f, shape.longest);
    if (is_triangle(surface_, surface_.face(beyond))) return flip(shape.longest);
    return join(shape.longest);
  }

  [[nodiscard]] Result<void> collapse(Halfedge side) {
    if (Result<void> done = short_edges_.collapse(side); !done) return done;
    for (const Face moved : short_edges_.moved()) {
      if (!work_.push_back(moved)) return no_memory();
    }
    return {};
  }

  // Whether nothing but this side can hold the face: contracted, it would leave an edge without
  // faces.
  [[nodiscard]] bool hangs_by(Face f, Halfedge side) const {
    const Halfedge after = surface_.next(side);
    return is_triangle(surface_, f) && surface_.is_boundary(Surface::opposite(after)) &&
           surface_.is_boundary(Surface::opposite(surface_.next(after)));
  }

  [[nodiscard]] Result<void> cut_up(Face f) {
    if (Result<Index> done = surface_.triangulate(f); !done) return done;
    return count(Code::kTriangulatedFace);
  }

  // Without the face, the two other sides take the place of the long one, on which they lie.
  [[nodiscard]] Result<void> delete_at_boundary(Face f, Halfedge longest) {
    const Halfedge into_apex = surface_.next(longest);
    const Halfedge from_apex = surface_.next(into_apex);
    const Vertex apex = surface_.to_vertex(into_apex);
    const Face neighbours[] = {surface_.face(Surface::opposite(into_apex)),
                               surface_.face(Surface::opposite(from_apex))};
    if (neighbours[0].valid() && neighbours[1].valid() && surface_.is_boundary(apex)) {
      return refusal("", sentence::of("{} would be pinched", apex));
    }
    if (!work_.reserve_more(2)) return no_memory();
    surface_.delete_face(f);
    for (const Face neighbour : neighbours) {
      if (neighbour.valid()) (void)work_.push_back(neighbour);
    }
    return count(Code::kRemovedFace);
  }

  // The apex lies on the long side: so the triangles that it divides the one beyond into have the
  // normal of that.
  [[nodiscard]] Result<void> flip(Halfedge longest) {
    const Halfedge beyond = Surface::opposite(longest);
    const Edge e = Surface::edge(longest);
    const Vector a = at(surface_.from_vertex(longest));
    const Vector b = at(surface_.to_vertex(longest));
    const Vector apex = at(surface_.to_vertex(surface_.next(longest)));
    const Vector other = at(surface_.to_vertex(surface_.next(beyond)));
    const Face faces[] = {surface_.face(longest), surface_.face(beyond)};
    const bool is_old_thin = shape_of(surface_, faces[1]).is_thin(tolerance_);
    const Vector old = cross(a - b, other - b);
    if (!is_old_thin && (dot(cross(other - a, apex - a), old) < 0 ||
                         dot(cross(b - other, apex - other), old) < 0)) {
      return refusal("", sentence::of("a triangle beyond {} would fold over", e));
    }
    // Each flip makes the thinner triangle wider or, where none has a width, the edge shorter: so
    // none is undone by another.
    const auto now = std::minmax({width_of(a, b, apex), width_of(b, a, other)});
    const auto then = std::minmax({width_of(a, other, apex), width_of(b, apex, other)});
    if (!(now < then || (now == then && length(other - apex) < length(b - a)))) {
      return refusal("", sentence::of("it and {} would be no wider if {} between them were flipped",
                                      faces[1], e));
    }
    if (!work_.reserve_more(2) || !report_.edges.reserve_more(1)) return no_memory();
    Result<Edge> done = surface_.flip_edge(e);
    if (!done) return done;
    (void)report_.edges.push_back(done.value().index());
    for (const Face f : faces) (void)work_.push_back(f);
    return count(Code::kFlippedEdge);
  }

  // The face beyond has more corners: it gains the apex.
  [[nodiscard]] Result<void> join(Halfedge longest) {
    if (!work_.reserve_more(1) || !report_.faces.reserve_more(1)) return no_memory();
    Result<Face> done = surface_.remove_edge(Surface::edge(longest));
    if (!done) return done;
    (void)report_.faces.push_back(done.value().index());
    (void)work_.push_back(done.value());
    return count(Code::kJoinedFace);
  }

  [[nodiscard]] Result<void> count(Code code) {
    ++steps_;
    report_.add(code);
    return {};
  }

  template <class Item>
  void keep_live(Array<Index>& items) {
    introsort(items);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const bool is_first = i == 0 || items[i] != items[i - 1];
      if (is_first && surface_.is_live(Item(items[i]))) items[kept++] = items[i];
    }
    (void)items.resize(kept);  // no larger than it was
  }

  Surface& surface_;
  double tolerance_;
  Report& report_;
  ShortEdges short_edges_;
  Array<Face> work_;
  std::size_t steps_ = 0;
  bool is_unfinished_ = false;  // a round has taken too many steps
};

}  // namespace

Result<Report> remove_degenerate_faces(Surface& surface, const DegenerateOptions& options) {
  if (Result<void> checked = check_option(
          "bad-tolerance", "The tolerance of removing degenerate faces", options.tolerance);
      !checked) {
    return checked;
  }
  if (Result<void> valid = surface.check_valid(); !valid) return valid;
  Report report;
  if (Result<void> done = Remover(surface, options.tolerance, report).run(); !done) {
    return done;
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
