#pragma once

#include <halfedge/sentence.h>
#include <halfedge/validate/problem_list.h>
#include <halfedge/validate/validate.h>

#include <string>

namespace halfedge {

/// What the groups of checks share: the mesh, which stores all links, the list they report to, and
/// the words for it.
template <class Mesh>
class Checker {
 public:
  Checker(const Mesh& mesh, ProblemList& problems) : mesh_(mesh), problems_(problems) {}

 protected:
  /// `message` is called if the problem is listed.
  template <class Item, class Message>
  void report(Rule rule, Item item, Message&& message) {
    problems_.add(rule, kind_of(item), item.index(), message);
  }

  /// Whether there was memory; if not, says what was left out.
  [[nodiscard]] bool has_memory(bool allocated, const char* left_out) {
    if (allocated) return true;
    problems_.add(Rule::kOutOfMemory, ItemKind::kMesh, kNone, [&] {
      return std::string("memory is exhausted, so this was not checked: ") + left_out;
    });
    return false;
  }

  const Mesh& mesh_;
  ProblemList& problems_;
};

/// Level 0, before a link is followed: array sizes, deleted slots, index ranges.
template <class Mesh>
class ReferenceChecker : Checker<Mesh> {
 public:
  using Checker<Mesh>::Checker;
  void check_array_sizes();
  /// pre: the array sizes are right.
  void check_references();

 private:
  using Checker<Mesh>::mesh_;
  using Checker<Mesh>::problems_;
  using Checker<Mesh>::report;

  void check_halfedge_array(const char* name, std::size_t size, std::size_t expected);
  void check_addressable(const char* name, std::size_t size);
  void check_free_list(ItemKind kind, const FreeList& list, const Array<Index>& links,
                       std::size_t stride);
  void check_edge_references(Edge e);
  [[nodiscard]] bool is_in_range(Halfedge h) const;
  template <class Item, class Target>
  void check_link(const char* name, Item item, Target target);
};

/// Levels 0 and 1, one step from an item. pre: references are right.
template <class Mesh>
class LinkChecker : Checker<Mesh> {
 public:
  using Checker<Mesh>::Checker;
  /// Level 0: next against prev, anchors, halfedges of faces.
  void check_inverse_links();
  /// Level 1.
  void check_loops_agree();

 private:
  using Checker<Mesh>::mesh_;
  using Checker<Mesh>::has_memory;
  using Checker<Mesh>::report;

  void check_missing_anchors();
};

/// Levels 2 and 3, around vertices and faces. pre: levels 0 and 1 hold; `next` then permutes the
/// live halfedges, so that every orbit and every loop closes.
template <class Mesh>
class OrbitChecker : Checker<Mesh> {
 public:
  using Checker<Mesh>::Checker;
  /// Level 2.
  void check_vertex_orbits();
  /// Level 3.
  void check_face_loops();
  void check_boundary();

 private:
  using Checker<Mesh>::mesh_;
  using Checker<Mesh>::has_memory;
  using Checker<Mesh>::report;

  void check_boundary_anchors();
};

/// Level 4: the rules of polygon meshes. pre: levels 0 and 1 hold.
template <class Mesh>
class PolygonChecker : Checker<Mesh> {
 public:
  using Checker<Mesh>::Checker;
  void check_polygons();

 private:
  using Checker<Mesh>::mesh_;
  using Checker<Mesh>::has_memory;
  using Checker<Mesh>::report;

  void check_degrees();
  void check_repeated_vertices(Array<Index>& mark);
  void check_duplicate_halfedges(Array<Index>& mark);
  void check_vertices();
};

}  // namespace halfedge
