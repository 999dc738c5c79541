#include <halfedge/algorithms/polygon_cutter.h>
#include <halfedge/algorithms/quad.h>
#include <halfedge/algorithms/touch_rings.h>
#include <halfedge/algorithms/triangles.h>
#include <halfedge/inlining.h>
#include <halfedge/sentence.h>

#include <algorithm>
#include <array>
#include <utility>

namespace halfedge {

namespace {

using Around = RingOf<Face, walk::LoopCcw, view::Self>;

Error corrupt(Face f) {
  return {"corrupt-connectivity",
          sentence::of("The ring around {} does not close, or leads to vertices that don't exist: "
                       "validate names the broken links.",
                       f),
          {.faces = {f.index()}}};
}

Error no_room_for_triangles() { return no_memory_for("the triangles"); }

class TriangleLister {
 public:
  TriangleLister(const RawLinks& links, std::span<const float> positions, CornersAs corners_as)
      : links_(links), positions_(positions), as_vertices_(corners_as == CornersAs::kVertices) {}

  Result<TriangleList> list(std::size_t expected, std::optional<std::span<const Index>> faces) {
    if (!make_room(expected)) return no_room_for_triangles();
    if (Result<void> added = faces ? add_some(*faces) : add_all(); !added) return added;
    return std::move(list_);
  }

 private:
  [[nodiscard]] bool make_room(std::size_t triangles) {
    return list_.corners.reserve_more(3 * triangles) && list_.faces.reserve_more(triangles);
  }

  // For so many triangles more.
  [[nodiscard]] std::size_t room() const {
    return std::min(list_.corners.capacity() / 3, list_.faces.capacity()) - list_.faces.size();
  }

  Result<void> add_all() {
    RingToucher toucher(links_, Ring::kFaceVertices, Direction::kCcw);
    const Index slots = links_.slots(Face{});
    steps_ = links_.halfedge_slots();  // the loops of all faces have no more
    Result<void> added;
    for (Index f = 0; added && (f = add_triangles(f, slots, toucher)) < slots;) {
      const Index after_quads = add_quads(f, slots, toucher);
      if (after_quads == f)
        added = add_face(Face(f++));
      else
        f = after_quads;
    }
    return added;
  }

  Result<void> add_some(std::span<const Index> faces) {
    Result<void> added;
    for (std::size_t i = 0; added && i < faces.size(); ++i) {
      const Face f(faces[i]);
      steps_ = links_.halfedge_slots();
      if (links_.is_live(f) && has_ring(links_, f)) added = add_face(f);
    }
    return added;
  }

  // The triangles from `f` on, until there is a face that is none, or no room. Returns which.
  Index add_triangles(Index f, Index end, RingToucher& toucher) {
    const RawLinks links = links_;  // a local, which no write of a corner can change
    const bool as_vertices = as_vertices_;
    const Index vertices = links.slots(Vertex{});
    Index* corners = list_.corners.end();
    Index* face = list_.faces.end();
    const Index* const end_of_room = face + room();
    for (; f < end; ++f) {
      toucher.reach(f);
      if (!has_ring(links, Face(f))) continue;
      const Halfedge a = links.stored_halfedge(Face(f));
      std::array<Index, 3> h{};
      if (face == end_of_room || !links.contain(a) || !write_triangle<Around>(links, a, h.data())) {
        break;
      }
      const std::array<Index, 3> v = {to_vertex(links, h[0]), to_vertex(links, h[1]),
                                      to_vertex(links, h[2])};
      if (std::max({v[0], v[1], v[2]}) >= vertices) break;
      std::copy_n(as_vertices ? v.data() : h.data(), 3, corners);
      corners += 3;
      *face++ = f;
    }
    list_.corners.grow_to(std::size_t(corners - list_.corners.begin()));
    list_.faces.grow_to(std::size_t(face - list_.faces.begin()));
    return f;
  }

  struct Quad {
    Index face;
    std::array<Index, 4> corners;
    std::array<Point, 4> points;
  };

  // The same of quads, some at a time: all of them are read before the first is cut. Where vertices
  // are in no order, a processor waits for many corners at once then.
  Index add_quads(Index f, Index end, RingToucher& toucher) {
    std::array<Quad, 16> quads;
    std::size_t count = 0;
    do {
      count = 0;
      const std::size_t most = std::min(quads.size(), room() / 2);
      for (; f < end && count < most; ++f) {
        toucher.reach(f);
        if (!read_quad(Face(f), quads[count])) break;
        ++count;
      }
      for (std::size_t i = 0; i < count; ++i) cut_quad(quads[i]);
    } while (count == quads.size());
    return f;
  }

  // False if the face is no quad, or deleted, or its links lead out of the arrays.
  [[nodiscard]] bool read_quad(Face f, Quad& quad) const {
    const Halfedge first = links_.stored_halfedge(f);
    Halfedge h = first;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!links_.contain(h) || (i > 0 && h == first)) return false;
      const Index v = to_vertex(links_, h.index());
      if (v >= links_.slots(Vertex{})) return false;
      quad.corners[i] = as_vertices_ ? v : h.index();
      quad.points[i] = position(Vertex(v));
      h = links_.next(h);
    }
    quad.face = f.index();
    return h == first;
  }

  void cut_quad(const Quad& quad) {
    const bool along_02 = ear_of_quad(quad.points) == 1;
    const auto& c = quad.corners;
    add_triangle(quad.face, c[0], c[1], along_02 ? c[2] : c[3]);
    add_triangle(quad.face, along_02 ? c[0] : c[1], c[2], c[3]);
  }

  // Any face. pre: it is live
  Result<void> add_face(Face f) {
    bool fits = true;
    bool is_sound = true;
    loop_.clear();
    points_.clear();
    const auto add_corner = [&](Index h) {
      const Index v = to_vertex(links_, h);
      is_sound = is_sound && v < links_.slots(Vertex{});
      if (!is_sound) return;
      fits = fits && loop_.push_back(h) && points_.push_back(position(Vertex(v)));
    };
    const Halfedge first = first_of<Around>(links_, f);
    if (!walk_ring<Around>(links_, first, steps_, add_corner) || !is_sound) return corrupt(f);
    if (!fits || !cut(f)) return no_room_for_triangles();
    return {};
  }

  // The face whose halfedges and points are listed. False when memory is exhausted.
  [[nodiscard]] bool cut(Face f) {
    const std::size_t degree = loop_.size();
    if (degree < 3) return true;
    if (!make_room(degree - 2)) return false;
    if (degree == 3) {
      add(f, 0, 1, 2);
    } else if (degree == 4) {
      const bool along_02 = ear_of_quad(points_.span().first<4>()) == 1;
      add(f, 0, 1, along_02 ? 2 : 3);
      add(f, along_02 ? 0 : 1, 2, 3);
    } else {
      ears_.clear();
      if (cutter_.cut_anyhow(points_.span(), ears_) != PolygonCutter::Outcome::kDone) return false;
      cutter_.for_each_triangle(ears_.span(), [&](Index i, Index j, Index k) { add(f, i, j, k); });
    }
    return true;
  }

  // The triangle of these corners of the face. pre: there is room
  void add(Face f, Index i, Index j, Index k) {
    const auto corner = [&](Index at) {
      return as_vertices_ ? to_vertex(links_, loop_[at]) : loop_[at];
    };
    add_triangle(f.index(), corner(i), corner(j), corner(k));
  }

  HALFEDGE_NOINLINE_IN_WASM void add_triangle(Index face, Index a, Index b, Index c) {
    const std::size_t triangle = list_.faces.size();
    list_.faces.grow_to(triangle + 1);
    list_.corners.grow_to(3 * triangle + 3);
    const Index corners[] = {a, b, c};
    std::copy_n(corners, 3, &list_.corners[3 * triangle]);
    list_.faces[triangle] = face;
  }

  [[nodiscard]] Point position(Vertex v) const {
    const float* const p = &positions_[3 * std::size_t{v.index()}];
    return {p[0], p[1], p[2]};
  }

  static Index to_vertex(const RawLinks& links, Index h) {
    return links.to_vertex(Halfedge(h)).index();
  }

  const RawLinks links_;
  const std::span<const float> positions_;
  const bool as_vertices_;
  TriangleList list_;
  Index steps_ = 0;
  PolygonCutter cutter_;
  Array<Index> loop_;  // the halfedges around a face
  Array<Point> points_;
  Array<Index> ears_;
};

}  // namespace

Result<TriangleList> to_triangles(const RawLinks& links, std::span<const float> positions,
                                  CornersAs corners_as, std::size_t expected,
                                  std::optional<std::span<const Index>> faces) {
  return TriangleLister(links, positions, corners_as).list(expected, faces);
}

}  // namespace halfedge
