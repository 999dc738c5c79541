#include <halfedge/build/sentence.h>
#include <halfedge/decorator/refusal.h>
#include <halfedge/mend/measure.h>
#include <halfedge/mend/repairs.h>
#include <halfedge/sort.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace halfedge::mend {

namespace {

using decorator::internal::refusal;
using decorator::internal::text;

// A face that is thinner than this share of its length has no area to speak of: the rounding of
// positions alone could turn it over.
constexpr double kThin = 1e-6;
constexpr int kRounds = 16;

/// How far the corners of a face reach along a line, and away from it.
struct Shape {
  double length = 0;
  double width = 0;
  Halfedge longest;  // sides
  Halfedge shortest;
  double least = 0;  // the length of `shortest`
};

class Remover {
 public:
  Remover(Surface& surface, double tolerance, Report& report)
      : surface_(surface), tolerance_(tolerance), report_(report) {}

  [[nodiscard]] Result<void> run() {
    for (int round = 0; round < kRounds; ++round) {
      // What is refused may be possible once more is done.
      Report left;
      const std::size_t before = steps_;
      if (Result<void> done = collapse_short_edges(left); !done) return done;
      if (Result<void> done = remove_thin_faces(left); !done) return done;
      const bool is_last = steps_ == before || round + 1 == kRounds;
      if (!is_last) continue;
      for (const Code code : {Code::kZeroLengthEdge, Code::kDegenerateFace}) {
        report_.add(code, left.count(code));
      }
      report_.problems = std::move(left.problems);
      break;
    }
    keep_live<Vertex>(report_.vertices);
    keep_live<Edge>(report_.edges);
    keep_live<Face>(report_.faces);
    return {};
  }

 private:
  static Failure no_memory() { return decorator::internal::no_memory("the faces to be removed"); }

  [[nodiscard]] Vector at(Vertex v) const { return point_of(surface_, v); }
  [[nodiscard]] double length_of(Halfedge h) const {
    return length(at(surface_.to_vertex(h)) - at(surface_.from_vertex(h)));
  }
  [[nodiscard]] bool is_triangle(Face f) const {
    const Halfedge h = surface_.halfedge(f);
    return surface_.next(surface_.next(surface_.next(h))) == h;
  }
  [[nodiscard]] double limit_of(double length) const {
    return std::max(tolerance_, kThin * length);
  }

  [[nodiscard]] Shape shape_of(Face f) const {
    Shape shape;
    const Halfedge first = surface_.halfedge(f);
    Halfedge h = first;
    Halfedge far = first;  // where it leads is farthest from where `first` does
    double farthest = -1;
    double side = -1;
    bool is_finite = true;
    do {
      const double own = length_of(h);
      is_finite = is_finite && std::isfinite(own);
      const double away = length(at(surface_.to_vertex(h)) - at(surface_.to_vertex(first)));
      if (own > side) side = own, shape.longest = h;
      if (!shape.shortest.valid() || own < shape.least) shape.least = own, shape.shortest = h;
      if (away > farthest) farthest = away, far = h;
      h = surface_.next(h);
    } while (h != first);
    if (!is_finite) {
      shape.length = shape.width = shape.least = std::numeric_limits<double>::quiet_NaN();
      return shape;  // which is not thin
    }
    // From there the farthest again: of a triangle, take the longest side itself.
    const Vector a =
        is_triangle(f) ? at(surface_.from_vertex(shape.longest)) : at(surface_.to_vertex(far));
    Vector b = at(surface_.to_vertex(shape.longest));
    if (!is_triangle(f)) {
      farthest = -1;
      do {
        const Vector p = at(surface_.to_vertex(h));
        if (length(p - a) > farthest) farthest = length(p - a), b = p;
        h = surface_.next(h);
      } while (h != first);
    }
    shape.length = length(b - a);
    do {
      const Vector p = at(surface_.to_vertex(h));
      if (shape.length > 0) {
        shape.width = std::max(shape.width, length(cross(b - a, p - a)) / shape.length);
      }
      h = surface_.next(h);
    } while (h != first);
    return shape;
  }
  [[nodiscard]] bool is_thin(const Shape& shape) const {
    return shape.width <= limit_of(shape.length);
  }

  // ---- edges without length -----------------------------------------------------------------

  [[nodiscard]] Result<void> collapse_short_edges(Report& left) {
    for (Index i = 0; i < surface_.edge_slots(); ++i) {
      const Edge e(i);
      if (!surface_.is_live(e) || !(length_of(Halfedge(2 * i)) <= tolerance_)) continue;
      Error why;
      const Result<bool> done = collapse(Halfedge(2 * i), why);
      if (!done) return done.error();
      if (done.value()) continue;
      left.leave(Code::kZeroLengthEdge, [&] {
        return refusal("",
                       text(e) + " has a length of " +
                           sentence::number(length_of(Halfedge(2 * i))) +
                           " but can't be collapsed: " + without_stop(why.message),
                       {.edges = {e.index()}});
      });
    }
    return {};
  }

  static std::string without_stop(const std::string& sentence) {
    return sentence.substr(0, sentence.size() - 1);
  }

  // Collapses the edge of `side`, into a boundary vertex if one end is one. False if it is refused.
  [[nodiscard]] Result<bool> collapse(Halfedge side, Error& why) {
    const bool turns = surface_.is_boundary(surface_.from_vertex(side)) &&
                       !surface_.is_boundary(surface_.to_vertex(side));
    for (const bool other : {false, true}) {
      const Halfedge h = turns != other ? Surface::opposite(side) : side;
      if (folds(h)) {
        why =
            refusal("", "a face at " + text(surface_.from_vertex(h)) + " would fold over").error();
        continue;
      }
      const Result<Vertex> kept = surface_.collapse(h);
      if (kept) {
        ++steps_;
        report_.add(Code::kCollapsedEdge);
        if (!report_.vertices.push_back(kept.value().index()) || !see_around(kept.value())) {
          return no_memory();
        }
        return true;
      }
      if (kept.error().code == "out-of-memory") return kept.error();
      why = kept.error();
      return false;  // the other way round it would be refused as well
    }
    return false;
  }

  // Whether a face turns over when the vertex that `h` leaves goes where `h` leads.
  [[nodiscard]] bool folds(Halfedge h) const {
    const Vertex from = surface_.from_vertex(h);
    const Vector to = at(surface_.to_vertex(h));
    if (length(to - at(from)) == 0) return false;
    Halfedge out = h;
    do {
      const Face f = surface_.face(out);
      if (f.valid() && !is_thin(shape_of(f))) {
        const Vector before = area_vector(out, at(from));
        const Vector after = area_vector(out, to);
        if (dot(before, after) < 0) return true;
      }
      out = surface_.rotate_cw(out);
    } while (out != h);
    return false;
  }

  // Twice the area of the face of `h`, if the vertex that h leaves were there.
  [[nodiscard]] Vector area_vector(Halfedge h, const Vector& there) const {
    Vector sum = {};
    Vector last = at(surface_.to_vertex(h)) - there;
    for (Halfedge on_loop = surface_.next(h); surface_.next(on_loop) != h;
         on_loop = surface_.next(on_loop)) {
      const Vector p = at(surface_.to_vertex(on_loop)) - there;
      const Vector n = cross(last, p);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
      last = p;
    }
    return sum;
  }

  // ---- faces without area -------------------------------------------------------------------

  [[nodiscard]] Result<void> remove_thin_faces(Report& left) {
    std::size_t steps_left = 20 * (std::size_t{surface_.face_slots()} + 50);
    for (Index i = 0; i < surface_.face_slots(); ++i) {
      work_.clear();
      if (!work_.push_back(Face(i))) return no_memory();
      while (!work_.empty() && steps_left-- > 0) {
        const Face f = work_[work_.size() - 1];
        work_.pop_back();
        if (!surface_.is_live(f)) continue;
        const Shape shape = shape_of(f);
        if (!is_thin(shape)) continue;
        Error why;
        const Result<bool> done = remove(f, shape, why);
        if (!done) return done.error();
        if (done.value()) ++steps_;
      }
    }
    for (Index i = 0; i < surface_.face_slots(); ++i) {
      const Face f(i);
      if (!surface_.is_live(f)) continue;
      const Shape shape = shape_of(f);
      if (!is_thin(shape)) continue;
      Error why;
      const Result<bool> done = remove(f, shape, why);
      if (!done) return done.error();
      if (done.value()) {
        ++steps_;
        continue;
      }
      left.leave(Code::kDegenerateFace, [&] {
        return refusal("",
                       text(f) + " is " + sentence::number(shape.length) + " long and " +
                           sentence::number(shape.width) +
                           " wide but can't be removed: " + without_stop(why.message),
                       {.faces = {f.index()}});
      });
    }
    return {};
  }

  [[nodiscard]] Result<bool> remove(Face f, const Shape& shape, Error& why) {
    if (shape.least <= limit_of(shape.length)) return collapse(shape.shortest, why);
    if (!is_triangle(f)) return cut_up(f, why);
    const Halfedge beyond = Surface::opposite(shape.longest);
    if (surface_.is_boundary(beyond)) return delete_at_boundary(f, shape.longest, why);
    if (is_triangle(surface_.face(beyond))) return flip(shape.longest, why);
    return join(shape.longest, why);
  }

  [[nodiscard]] Result<bool> outcome(bool done, const Error& refused, Code code, Error& why) {
    if (done) {
      report_.add(code);
      return true;
    }
    if (refused.code == "out-of-memory") return refused;
    why = refused;
    return false;
  }

  [[nodiscard]] Result<bool> cut_up(Face f, Error& why) {
    const Result<Index> done = surface_.triangulate(f);
    return outcome(done.ok(), done ? Error{} : done.error(), Code::kTriangulatedFace, why);
  }

  // Without the face, the two other sides take the place of the long one, on which they lie.
  [[nodiscard]] Result<bool> delete_at_boundary(Face f, Halfedge longest, Error& why) {
    const Halfedge into_apex = surface_.next(longest);
    const Halfedge from_apex = surface_.next(into_apex);
    const Vertex apex = surface_.to_vertex(into_apex);
    const bool has_neighbours = !surface_.is_boundary(Surface::opposite(into_apex)) &&
                                !surface_.is_boundary(Surface::opposite(from_apex));
    if (has_neighbours && surface_.is_boundary(apex)) {
      why = refusal("", text(apex) + " would be pinched").error();
      return false;
    }
    surface_.delete_face(f);
    report_.add(Code::kRemovedFace);
    return true;
  }

  // The apex lies on the long side: so the triangles that it divides the one beyond into have the
  // normal of that.
  [[nodiscard]] Result<bool> flip(Halfedge longest, Error& why) {
    const Halfedge beyond = Surface::opposite(longest);
    const Vertex a = surface_.from_vertex(longest);
    const Vertex b = surface_.to_vertex(longest);
    const Vector apex = at(surface_.to_vertex(surface_.next(longest)));
    const Vector other = at(surface_.to_vertex(surface_.next(beyond)));
    const Vector old = cross(at(a) - at(b), other - at(b));
    const Vector news[] = {cross(other - at(a), apex - at(a)), cross(at(b) - other, apex - other)};
    const Face faces[] = {surface_.face(longest), surface_.face(beyond)};
    const bool is_old_thin = is_thin(shape_of(faces[1]));
    for (const Vector& normal : news) {
      if (!is_old_thin && dot(normal, old) < 0) {
        why = refusal("", "a triangle beyond " + text(Surface::edge(longest)) + " would fold over")
                  .error();
        return false;
      }
    }
    // Where all lie on a line the edge must become shorter, or it would go on for ever.
    if (is_old_thin && !(length(other - apex) < length_of(longest))) {
      why = refusal("", text(faces[1]) + " beyond its longest edge has no area either").error();
      return false;
    }
    const Result<Edge> done = surface_.flip_edge(Surface::edge(longest));
    if (done) {
      if (!report_.edges.push_back(done.value().index()) || !work_.push_back(faces[0]) ||
          !work_.push_back(faces[1])) {
        return no_memory();
      }
    }
    return outcome(done.ok(), done ? Error{} : done.error(), Code::kFlippedEdge, why);
  }

  // The face beyond has more corners: it gains the apex.
  [[nodiscard]] Result<bool> join(Halfedge longest, Error& why) {
    const Result<Face> done = surface_.remove_edge(Surface::edge(longest));
    if (done && !report_.faces.push_back(done.value().index())) return no_memory();
    return outcome(done.ok(), done ? Error{} : done.error(), Code::kJoinedFace, why);
  }

  [[nodiscard]] bool see_around(Vertex v) {
    const Halfedge anchor = surface_.halfedge(v);
    if (!anchor.valid()) return true;
    Halfedge out = anchor;
    do {
      if (surface_.face(out).valid() && !work_.push_back(surface_.face(out))) return false;
      out = surface_.rotate_cw(out);
    } while (out != anchor);
    return true;
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
  Array<Face> work_;
  std::size_t steps_ = 0;
};

}  // namespace

Result<Report> remove_degenerate_faces(Surface& surface, const DegenerateOptions& options) {
  Report report;
  if (Result<void> done = Remover(surface, options.tolerance, report).run(); !done) {
    return done.error();
  }
  report.summarize();
  return report;
}

}  // namespace halfedge::mend
