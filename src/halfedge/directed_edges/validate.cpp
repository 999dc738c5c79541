#include <halfedge/directed_edges/validate.h>
#include <halfedge/sentence.h>
#include <halfedge/validate/problem_list.h>

#include <cassert>
#include <cstddef>
#include <string>
#include <utility>

namespace halfedge {

namespace {

class DirectedChecker {
 public:
  DirectedChecker(const DirectedEdges& mesh, ProblemList& problems)
      : mesh_(mesh), links_(mesh.links()), problems_(problems) {}

  // ---- level 0, before a link is followed

  void check_array_sizes() {
    const std::size_t size = links_.opposite.size();
    const auto check = [&](const char* name, std::size_t actual, std::size_t expected) {
      if (actual == expected) return;
      add_size_problem(
          [&] { return sentence::of("{} has {} entries, expected {}", name, actual, expected); });
    };
    if (links_.sides % 3 != 0 || links_.sides > size) {
      add_size_problem([&] {
        return sentence::of(
            "there are {} sides of faces, expected three to a face and at most {}, the entries of "
            "opposite",
            links_.sides, size);
      });
      return;
    }
    check("to_vertex", links_.to_vertex.size(), size);
    check("boundary_next", links_.boundary_next.size(), size - links_.sides);
    check("boundary_prev", links_.boundary_prev.size(), size - links_.sides);
    for (const std::size_t slots : {size, links_.vertex_halfedge.size()}) {
      if (slots <= kMaxSlots) continue;
      add_size_problem([&] {
        return sentence::of("an array has {} entries, expected at most {}", slots, kMaxSlots);
      });
    }
  }

  // pre: the array sizes are right.
  void check_references() {
    const Index halfedges = mesh_.halfedge_count();
    for (Index h = 0; h < halfedges; ++h) {
      check_link("opposite", Halfedge(h), Halfedge(links_.opposite[h]), 0, halfedges);
      check_link("to-vertex", Halfedge(h), Vertex(links_.to_vertex[h]), 0, mesh_.vertex_count());
    }
    for (Index h = links_.sides; h < halfedges; ++h) {
      const Index i = h - links_.sides;
      check_link("next", Halfedge(h), Halfedge(links_.boundary_next[i]), links_.sides, halfedges);
      check_link("prev", Halfedge(h), Halfedge(links_.boundary_prev[i]), links_.sides, halfedges);
    }
    for (const Vertex v : mesh_.vertices()) {
      const Halfedge anchor = mesh_.vertex_halfedge(v);
      if (anchor.valid()) check_link("anchor", v, anchor, 0, halfedges);
    }
  }

  // ---- level 0, one step from an item. pre: references are right.

  void check_inverse_links() {
    for (const Halfedge h : mesh_.halfedges()) {
      const Halfedge o = mesh_.opposite(h);
      if (o == h || mesh_.opposite(o) != h) {
        report(Rule::kOppositeMismatch, h, [&] {
          return sentence::of(
              "the opposite of {} is {}{}", h, o,
              (o == h ? ", itself" : sentence::of(", whose opposite is {}", mesh_.opposite(o))));
        });
      }
      const Halfedge n = mesh_.next(h);
      if (mesh_.prev(n) != h) {
        report(Rule::kNextPrevMismatch, h, [&] {
          return sentence::of("next of {} is {}, whose prev is {}", h, n, mesh_.prev(n));
        });
      }
      const Vertex from = mesh_.from_vertex(h);
      if (mesh_.is_isolated(from)) {
        report(Rule::kMissingAnchor, from,
               [&] { return sentence::of("{} has no anchor, although {} leaves it", from, h); });
      }
    }
    for (const Vertex v : mesh_.vertices()) {
      const Halfedge anchor = mesh_.vertex_halfedge(v);
      if (!anchor.valid() || mesh_.from_vertex(anchor) == v) continue;
      report(Rule::kAnchorElsewhere, v, [&] {
        return sentence::of("the anchor of {}, {}, leaves {}", v, anchor,
                            mesh_.from_vertex(anchor));
      });
    }
  }

  // ---- level 1

  void check_ends_agree() {
    for (const Halfedge h : mesh_.halfedges()) {
      const Vertex from = mesh_.from_vertex(h);
      const Vertex to = mesh_.to_vertex(mesh_.opposite(h));
      if (to == from) continue;
      report(Rule::kToFromMismatch, h, [&] {
        return sentence::of("{} leaves {}, but its opposite, {}, leads to {}", h, from,
                            mesh_.opposite(h), to);
      });
    }
  }

  // ---- levels 2 to 4. pre: levels 0 and 1 hold, so that every orbit closes.

  void check_vertex_orbits() {
    Index reached = 0;
    for (const Vertex v : mesh_.vertices()) reached += mesh_.valence(v);
    if (reached == mesh_.halfedge_count()) return;
    Array<bool> seen;
    if (!has_memory(seen.resize(mesh_.halfedge_count(), false), "vertex orbits")) return;
    for (const Vertex v : mesh_.vertices()) {
      for (const Halfedge h : mesh_.outgoing_cw(v)) seen[h.index()] = true;
    }
    for (const Halfedge h : mesh_.halfedges()) {
      if (seen[h.index()]) continue;
      const Vertex v = mesh_.from_vertex(h);
      report(Rule::kUnreachableHalfedge, h, [&] {
        return sentence::of("{} leaves {}, but is not reached by rotating from its anchor, {}", h,
                            v, mesh_.vertex_halfedge(v));
      });
    }
  }

  void check_boundary() {
    for (Index i = links_.sides; i < mesh_.halfedge_count(); ++i) {
      const Halfedge h(i);
      const Vertex v = mesh_.from_vertex(h);
      if (!mesh_.is_boundary(v)) {
        report(Rule::kInteriorAnchor, v, [&] {
          return sentence::of(
              "the anchor of {} is {}, which has a face, although the boundary {} leaves it", v,
              mesh_.vertex_halfedge(v), h);
        });
      }
      const Halfedge o = mesh_.opposite(h);
      if (mesh_.is_boundary(o) && h < o) {
        report(Rule::kEdgeWithoutFace, h, [&] {
          return sentence::of("neither {} nor its opposite, {}, has a face, expected one at least",
                              h, o);
        });
      }
    }
  }

  void check_triangles() {
    for (const Face f : mesh_.faces()) {
      const Halfedge h = mesh_.face_halfedge(f);
      const Vertex a = mesh_.to_vertex(h);
      const Vertex b = mesh_.to_vertex(mesh_.next(h));
      const Vertex c = mesh_.to_vertex(mesh_.prev(h));
      if (a == b || b == c || c == a) {
        report(Rule::kRepeatedVertex, f, [&] {
          return sentence::of("{} has {} at more than one corner", f, a == b || c == a ? a : b);
        });
      }
    }
    for (const Edge e : mesh_.edges()) {
      const Face f = mesh_.face(mesh_.edge_halfedge(e, 0));
      if (f != mesh_.face(mesh_.edge_halfedge(e, 1))) continue;
      report(Rule::kSameFaceTwice, e,
             [&] { return sentence::of("{} has {} on both sides, expected two faces", e, f); });
    }
    check_duplicate_halfedges();
    for (const Vertex v : mesh_.vertices()) {
      if (mesh_.is_isolated(v)) {
        report(Rule::kIsolatedVertex, v,
               [&] { return sentence::of("{} is isolated: it has no edges", v); });
      } else if (mesh_.is_boundary(v) && !mesh_.is_manifold(v)) {
        report(Rule::kPinchedVertex, v,
               [&] { return sentence::of("{} is pinched: its faces form more than one fan", v); });
      }
    }
  }

 private:
  template <class Item, class Message>
  void report(Rule rule, Item item, Message&& message) {
    problems_.add(rule, kind_of(item), item.index(), message);
  }

  template <class Message>
  void add_size_problem(Message&& message) {
    problems_.add(Rule::kArraySize, ItemKind::kMesh, kNone, message);
  }

  [[nodiscard]] bool has_memory(bool allocated, const char* left_out) {
    if (allocated) return true;
    problems_.add(Rule::kOutOfMemory, ItemKind::kMesh, kNone, [&] {
      return std::string("memory is exhausted, so this was not checked: ") + left_out;
    });
    return false;
  }

  template <class Item, class Target>
  void check_link(const char* name, Item item, Target target, Index begin, Index end) {
    if (begin <= target.index() && target.index() < end) return;
    report(target.valid() ? Rule::kIndexOutOfRange : Rule::kEmptyLink, item, [&] {
      return sentence::of("{} of {} is {}, expected at least {} and less than {}", name, item,
                          target.index(), begin, end);
    });
  }

  // Reported at the second of the two, once for each edge: from its smaller vertex.
  void check_duplicate_halfedges() {
    Array<Index> mark;  // by vertex, the last one in whose ring it was seen
    if (!has_memory(mark.resize(mesh_.vertex_count(), kNone), "duplicate halfedges")) return;
    for (const Vertex v : mesh_.vertices()) {
      for (const Halfedge h : mesh_.outgoing_cw(v)) {
        const Vertex to = mesh_.to_vertex(h);
        if (mark[to.index()] == v.index() && v <= to) {
          report(Rule::kDuplicateHalfedge, h, [&] {
            return sentence::of("{} leads from {} to {}, as another halfedge does already", h, v,
                                to);
          });
        }
        mark[to.index()] = v.index();
      }
    }
  }

  const DirectedEdges& mesh_;
  const DirectedLinks& links_;
  ProblemList& problems_;
};

std::vector<Problem> run(const DirectedEdges& mesh, int level, ProblemList problems) {
  assert(0 <= level && level <= kMaxValidationLevel);
  const std::size_t before = problems.error_count();
  const auto clean = [&] { return problems.error_count() == before; };
  DirectedChecker checker(mesh, problems);
  checker.check_array_sizes();
  if (clean()) checker.check_references();
  if (clean()) checker.check_inverse_links();
  if (clean() && level >= 1) checker.check_ends_agree();
  if (clean()) {
    if (level >= 2) checker.check_vertex_orbits();
    if (level >= 3) checker.check_boundary();
    if (level >= 4) checker.check_triangles();
  }
  return std::move(problems).take();
}

}  // namespace

std::vector<Problem> validate(const DirectedEdges& mesh, int level) {
  return run(mesh, level, ProblemList{});
}

std::vector<Problem> validate(const DirectedEdgesMesh& mesh, int level) {
  ProblemList problems;
  const std::size_t expected = 3 * mesh.links().vertex_halfedge.size();
  if (mesh.positions().size() != expected) {
    problems.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
      return sentence::of("positions has {} floats, expected {}: three for each vertex",
                          mesh.positions().size(), expected);
    });
  }
  return run(mesh, level, std::move(problems));
}

}  // namespace halfedge
