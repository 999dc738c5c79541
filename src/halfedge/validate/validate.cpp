#include <halfedge/validate/problem_list.h>
#include <halfedge/validate/validate.h>

#include <algorithm>
#include <cassert>
#include <string>

namespace halfedge {

namespace {

std::string number(Index index) { return index == kNone ? "none" : std::to_string(index); }

std::string text(ItemKind kind, Index index) {
  return std::string(name_of(kind)) + " " + number(index);
}
template <class Tag>
std::string text(Handle<Tag> item) {
  return text(kind_of(item), item.index());
}

class Validator {
 public:
  explicit Validator(const Connectivity& mesh) : mesh_(mesh), links_(mesh.links()) {}

  void check_positions(std::size_t size) {
    const std::size_t slots = links_.vertex_halfedge.size();
    if (size == 3 * slots) return;
    problems_.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
      return "positions has " + std::to_string(size) + " floats, expected " +
             std::to_string(3 * slots) + ": three for each vertex slot";
    });
  }

  // Each step needs what the steps before it have checked, and is left out where they failed.
  [[nodiscard]] std::vector<Problem> run(int level) && {
    check_array_sizes();
    if (clean()) check_references();
    if (clean()) {
      check_inverse_links();
      if (level >= 1) check_loops_agree();
    }
    if (clean()) {
      if (level >= 2) check_vertex_orbits();
      if (level >= 3) check_face_loops();
      if (level >= 3) check_boundary();
      if (level >= 4) check_polygons();
    }
    return std::move(problems_).take();
  }

 private:
  [[nodiscard]] bool clean() const { return problems_.error_count() == 0; }

  template <class Item, class Message>
  void report(Rule rule, Item item, Message&& message) {
    problems_.add(rule, kind_of(item), item.index(), message);
  }

  [[nodiscard]] bool has_memory(bool allocated, const char* left_out) {
    if (allocated) return true;
    problems_.add(Rule::kOutOfMemory, ItemKind::kMesh, kNone, [&] {
      return std::string("memory is exhausted, so this was not checked: ") + left_out;
    });
    return false;
  }

  // ---- level 0: array sizes ---------------------------------------------------------------------

  void check_array_sizes() {
    const std::size_t size = links_.next.size();
    check_halfedge_array("prev", links_.prev.size(), size);
    check_halfedge_array("to_vertex", links_.to_vertex.size(), size);
    check_halfedge_array("face", links_.face.size(), size);
    if (size % 2 != 0) {
      problems_.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
        return "next has " + std::to_string(size) + " entries, expected an even number: " +
               "the two halfedges of an edge lie side by side";
      });
    }
    check_addressable("next", size);
    check_addressable("vertex_halfedge", links_.vertex_halfedge.size());
    check_addressable("face_halfedge", links_.face_halfedge.size());
  }

  void check_halfedge_array(const char* name, std::size_t size, std::size_t expected) {
    if (size == expected) return;
    problems_.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
      return std::string(name) + " has " + std::to_string(size) + " entries, expected " +
             std::to_string(expected) + ": one for each halfedge, as next has";
    });
  }

  void check_addressable(const char* name, std::size_t size) {
    if (size <= kMaxSlots) return;
    problems_.add(Rule::kArraySize, ItemKind::kMesh, kNone, [&] {
      return std::string(name) + " has " + std::to_string(size) + " entries, expected at most " +
             std::to_string(kMaxSlots) + ": the sign bit marks empty and deleted links";
    });
  }

  // ---- level 0: live and deleted slots, and what links refer to
  // -----------------------------------

  void check_references() {
    check_free_list(ItemKind::kVertex, mesh_.free_vertices(), links_.vertex_halfedge, 1);
    check_free_list(ItemKind::kEdge, mesh_.free_edges(), links_.next, 2);
    check_free_list(ItemKind::kFace, mesh_.free_faces(), links_.face_halfedge, 1);
    for (Index e = 0; e < mesh_.edge_slots(); ++e) check_edge_references(Edge(e));
    for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
      const Index anchor = links_.vertex_halfedge[v];
      if (anchor == kNone || is_deleted_link(anchor)) continue;
      check_link("anchor", Vertex(v), Halfedge(anchor));
    }
    for (Index f = 0; f < mesh_.face_slots(); ++f) {
      const Index first = links_.face_halfedge[f];
      if (!is_deleted_link(first)) check_link("halfedge", Face(f), Halfedge(first));
    }
  }

  // A chain with as many entries as there are deleted slots, all of them deleted, and with an end
  // visits none twice, so it holds them all.
  void check_free_list(ItemKind kind, const Connectivity::FreeList& list, const Array<Index>& links,
                       std::size_t stride) {
    const std::size_t slots = links.size() / stride;
    Index deleted = 0;
    for (std::size_t slot = 0; slot < slots; ++slot) {
      deleted += is_deleted_link(links[slot * stride]) ? 1 : 0;
    }
    const auto complain = [&](Index slot, const std::string& what) {
      problems_.add(Rule::kFreeList, kind, slot, [&] {
        return std::string("the chain of deleted ") + name_of(kind) + " slots " + what;
      });
    };
    if (deleted != list.count) {
      return complain(kNone, "should have " + number(list.count) + " entries, but " +
                                 number(deleted) + " slots are marked as deleted");
    }
    Index length = 0;
    for (Index slot = list.head; slot != kNone; ++length) {
      if (slot >= slots) {
        return complain(kNone, "leads to slot " + number(slot) + " of " + std::to_string(slots));
      }
      const Index link = links[slot * stride];
      if (!is_deleted_link(link)) {
        return complain(slot, "leads to slot " + number(slot) + ", which is not deleted");
      }
      if (length == deleted) {
        return complain(slot, "runs in a circle through slot " + number(slot));
      }
      slot = next_free_slot(link);
    }
    if (length != deleted) {
      complain(kNone, "ends after " + number(length) + " of " + number(deleted) + " deleted slots");
    }
  }

  void check_edge_references(Edge e) {
    const std::size_t first = mesh_.edge_halfedge(e).index();
    unsigned deleted = 0;
    for (const Array<Index>* links :
         {&links_.next, &links_.prev, &links_.to_vertex, &links_.face}) {
      for (const std::size_t h : {first, first + 1}) {
        deleted += is_deleted_link((*links)[h]) ? 1U : 0U;
      }
    }
    if (deleted == 8) return;
    if (deleted != 0) {
      return report(Rule::kHalfDeletedEdge, e, [&] {
        return text(e) + " is half deleted: " + std::to_string(deleted) +
               " of the 8 links of its halfedges are marked as deleted, expected all or none";
      });
    }
    for (const Index side : {0U, 1U}) {
      const Halfedge h = mesh_.edge_halfedge(e, side);
      check_link("next", h, mesh_.next(h));
      check_link("prev", h, mesh_.prev(h));
      check_link("to-vertex", h, mesh_.to_vertex(h));
      if (!mesh_.is_boundary(h)) check_link("face", h, mesh_.face(h));
    }
  }

  template <class Item, class Target>
  void check_link(const char* name, Item item, Target target) {
    if (mesh_.is_live(target)) return;
    const auto subject = [&] { return "the " + std::string(name) + " of " + text(item); };
    if (!target.valid()) {
      report(Rule::kEmptyLink, item,
             [&] { return subject() + " is empty, expected a " + name_of(kind_of(target)); });
    } else if (target.index() >= mesh_.slots(Target{})) {
      report(Rule::kIndexOutOfRange, item, [&] {
        return subject() + " is " + text(target) + ", expected less than " +
               number(mesh_.slots(Target{}));
      });
    } else {
      report(Rule::kDeletedReference, item,
             [&] { return subject() + " is " + text(target) + ", which is deleted"; });
    }
  }

  // ---- level 0: next against prev, anchors, halfedges of faces
  // --------------------------------------

  void check_inverse_links() {
    // prev(next(h)) == h for all h makes next injective, and so a permutation with the inverse
    // prev.
    for (const Halfedge h : mesh_.halfedges()) {
      const Halfedge n = mesh_.next(h);
      if (mesh_.prev(n) == h) continue;
      report(Rule::kNextPrevMismatch, h, [&] {
        return "the next of " + text(h) + " is " + text(n) + ", whose prev is " +
               text(mesh_.prev(n));
      });
    }
    check_missing_anchors();
    for (const Vertex v : mesh_.vertices()) {
      const Halfedge anchor = mesh_.vertex_halfedge(v);
      if (!anchor.valid() || mesh_.from_vertex(anchor) == v) continue;
      report(Rule::kAnchorElsewhere, v, [&] {
        return "the anchor of " + text(v) + " is " + text(anchor) + ", which leaves " +
               text(mesh_.from_vertex(anchor));
      });
    }
    for (const Face f : mesh_.faces()) {
      const Halfedge first = mesh_.face_halfedge(f);
      if (mesh_.face(first) == f) continue;
      report(Rule::kFaceHalfedgeElsewhere, f, [&] {
        return "the halfedge of " + text(f) + " is " + text(first) + ", which lies in " +
               text(mesh_.face(first));
      });
    }
  }

  void check_missing_anchors() {
    const auto lacks_anchor = [&](Vertex v) { return !mesh_.vertex_halfedge(v).valid(); };
    const bool none_lacks =
        std::none_of(mesh_.links().vertex_halfedge.begin(), mesh_.links().vertex_halfedge.end(),
                     [](Index anchor) { return anchor == kNone; });
    if (none_lacks) return;
    Array<Index> leaving;  // by vertex, one halfedge that leaves it
    if (!has_memory(leaving.resize(mesh_.vertex_slots(), kNone), "missing anchors")) return;
    for (const Halfedge h : mesh_.halfedges()) leaving[mesh_.from_vertex(h).index()] = h.index();
    for (const Vertex v : mesh_.vertices()) {
      if (!lacks_anchor(v) || leaving[v.index()] == kNone) continue;
      report(Rule::kMissingAnchor, v, [&] {
        return text(v) + " has no anchor, although " + text(Halfedge(leaving[v.index()])) +
               " leaves it";
      });
    }
  }

  // ---- level 1 ----------------------------------------------------------------------------------

  void check_loops_agree() {
    for (const Halfedge h : mesh_.halfedges()) {
      const Halfedge n = mesh_.next(h);
      if (mesh_.from_vertex(n) != mesh_.to_vertex(h)) {
        report(Rule::kToFromMismatch, h, [&] {
          return text(h) + " leads to " + text(mesh_.to_vertex(h)) + ", but its next, " + text(n) +
                 ", leaves " + text(mesh_.from_vertex(n));
        });
      }
      if (mesh_.face(n) != mesh_.face(h)) {
        report(Rule::kFaceMismatch, h, [&] {
          return text(h) + " lies in " + text(mesh_.face(h)) + ", but its next, " + text(n) +
                 ", lies in " + text(mesh_.face(n));
        });
      }
    }
  }

  // ---- levels 2 to 4: next is a permutation by now, so all orbits and loops close
  // -------------------

  void check_vertex_orbits() {
    Index reached = 0;
    for (const Vertex v : mesh_.vertices()) reached += mesh_.valence(v);
    if (reached == mesh_.halfedge_count()) return;

    Array<bool> seen;
    if (!has_memory(seen.resize(mesh_.halfedge_slots(), false), "vertex orbits")) return;
    for (const Vertex v : mesh_.vertices()) {
      for (const Halfedge h : mesh_.outgoing_cw(v)) seen[h.index()] = true;
    }
    for (const Halfedge h : mesh_.halfedges()) {
      if (seen[h.index()]) continue;
      const Vertex v = mesh_.from_vertex(h);
      report(Rule::kUnreachableHalfedge, h, [&] {
        return text(h) + " leaves " + text(v) +
               ", but is not reached by rotating from its anchor, " +
               text(mesh_.vertex_halfedge(v));
      });
    }
  }

  void check_face_loops() {
    Index reached = 0;
    for (const Face f : mesh_.faces()) reached += mesh_.degree(f);
    for (const Halfedge h : mesh_.halfedges()) reached += mesh_.is_boundary(h) ? 1 : 0;
    if (reached == mesh_.halfedge_count()) return;

    Array<bool> seen;
    if (!has_memory(seen.resize(mesh_.halfedge_slots(), false), "face loops")) return;
    const auto see_loop = [&](Halfedge first) {
      for (const Halfedge h : mesh_.loop_ccw(first)) seen[h.index()] = true;
    };
    for (const Face f : mesh_.faces()) see_loop(mesh_.face_halfedge(f));
    for (const Halfedge h : mesh_.halfedges()) {
      if (mesh_.is_boundary(h) || seen[h.index()]) continue;
      see_loop(h);
      report(Rule::kFaceWithManyLoops, mesh_.face(h), [&] {
        return text(mesh_.face(h)) + " has a second loop, through " + text(h) +
               ", beside that of its halfedge, " + text(mesh_.face_halfedge(mesh_.face(h)));
      });
    }
  }

  void check_boundary() {
    for (const Vertex v : mesh_.vertices()) {
      if (mesh_.is_boundary(v)) continue;
      for (const Halfedge h : mesh_.outgoing_cw(v)) {
        if (!mesh_.is_boundary(h)) continue;
        report(Rule::kInteriorAnchor, v, [&] {
          return "the anchor of " + text(v) + " is " + text(mesh_.vertex_halfedge(v)) +
                 ", which has a face, although the boundary halfedge " + number(h.index()) +
                 " leaves it";
        });
        break;
      }
    }
    for (const Edge e : mesh_.edges()) {
      if (!mesh_.is_boundary(mesh_.edge_halfedge(e, 0)) ||
          !mesh_.is_boundary(mesh_.edge_halfedge(e, 1))) {
        continue;
      }
      report(Rule::kEdgeWithoutFace, e,
             [&] { return text(e) + " has no face on either side, expected one at least"; });
    }
  }

  // ---- level 4 ----------------------------------------------------------------------------------

  void check_polygons() {
    check_degrees();
    Array<Index> mark;  // by vertex, the last face or vertex in whose ring it was seen
    if (has_memory(mark.resize(mesh_.vertex_slots(), kNone), "repeated vertices and edges")) {
      check_repeated_vertices(mark);
      std::fill(mark.begin(), mark.end(), kNone);
      check_duplicate_halfedges(mark);
    }
    for (const Edge e : mesh_.edges()) {
      const Face f = mesh_.face(mesh_.edge_halfedge(e, 0));
      if (!f.valid() || f != mesh_.face(mesh_.edge_halfedge(e, 1))) continue;
      report(Rule::kSameFaceTwice, e,
             [&] { return text(e) + " has " + text(f) + " on both sides, expected two faces"; });
    }
    check_vertices();
  }

  void check_degrees() {
    for (const Face f : mesh_.faces()) {
      const Halfedge first = mesh_.face_halfedge(f);
      const Halfedge second = mesh_.next(first);
      if (first != second && mesh_.next(second) != first) continue;
      report(Rule::kDegreeBelowThree, f, [&] {
        return text(f) + " has " + number(mesh_.degree(f)) +
               (first == second ? " corner" : " corners") + ", expected three or more";
      });
    }
  }

  void check_repeated_vertices(Array<Index>& mark) {
    for (const Face f : mesh_.faces()) {
      for (const Vertex v : mesh_.face_vertices_ccw(f)) {
        if (mark[v.index()] == f.index()) {
          report(Rule::kRepeatedVertex, f,
                 [&] { return text(f) + " has " + text(v) + " at more than one corner"; });
        }
        mark[v.index()] = f.index();
      }
    }
  }

  // Reported at the second of the two, once for each edge: from its smaller vertex.
  void check_duplicate_halfedges(Array<Index>& mark) {
    for (const Vertex v : mesh_.vertices()) {
      for (const Halfedge h : mesh_.outgoing_cw(v)) {
        const Vertex to = mesh_.to_vertex(h);
        if (mark[to.index()] == v.index() && v <= to) {
          report(Rule::kDuplicateHalfedge, h, [&] {
            return text(h) + " leads from " + text(v) + " to " + text(to) +
                   ", as another halfedge does already";
          });
        }
        mark[to.index()] = v.index();
      }
    }
  }

  void check_vertices() {
    for (const Vertex v : mesh_.vertices()) {
      if (mesh_.is_isolated(v)) {
        report(Rule::kIsolatedVertex, v, [&] { return text(v) + " is isolated: it has no edges"; });
      } else if (mesh_.is_boundary(v) && !mesh_.is_manifold(v)) {
        report(Rule::kPinchedVertex, v,
               [&] { return text(v) + " is pinched: its faces form more than one fan"; });
      }
    }
  }

  const Connectivity& mesh_;
  const Links& links_;
  ProblemList problems_;
};

}  // namespace

std::vector<Problem> validate(const Connectivity& mesh, int level) {
  assert(0 <= level && level <= kMaxValidationLevel);
  return Validator(mesh).run(level);
}

std::vector<Problem> validate(const Mesh& mesh, int level) {
  assert(0 <= level && level <= kMaxValidationLevel);
  Validator validator(mesh);
  validator.check_positions(mesh.positions().size());
  return std::move(validator).run(level);
}

bool has_errors(std::span<const Problem> problems) {
  return std::any_of(problems.begin(), problems.end(),
                     [](const Problem& p) { return p.severity == Severity::kError; });
}

}  // namespace halfedge
