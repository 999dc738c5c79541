#pragma once

#include <gtest/gtest.h>
#include <halfedge/decorator/decorator.h>
#include <halfedge/mesh.h>
#include <halfedge/validate/validate.h>

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/invariants.h"
#include "support/matching.h"
#include "support/reference_build.h"
#include "support/shapes.h"

namespace halfedge::test {

/// All arrays of a mesh, its attributes and its free lists: equal means that nothing at all was
/// changed.
struct Snapshot {
  std::vector<std::vector<Index>> links;
  std::vector<float> positions;
  std::vector<Index> free;
  std::vector<std::vector<std::byte>> attributes;

  template <Storage kStored>
  explicit Snapshot(const BasicMesh<kStored>& mesh) {
    const Links& all = mesh.links();
    for (const Array<Index>* array : {&all.next, &all.prev, &all.to_vertex, &all.face,
                                      &all.vertex_halfedge, &all.face_halfedge}) {
      links.emplace_back(array->begin(), array->end());
    }
    positions.assign(mesh.positions().begin(), mesh.positions().end());
    for (const FreeList& list : {mesh.free_vertices(), mesh.free_edges(), mesh.free_faces()}) {
      free.insert(free.end(), {list.head, list.count});
    }
    for (const ItemKind kind :
         {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
      for (const auto& column : mesh.attributes().of(kind)) {
        EXPECT_EQ(column->slots(), mesh.slots(kind)) << column->name();
        attributes.emplace_back(column->bytes().begin(), column->bytes().end());
      }
    }
  }
  friend bool operator==(const Snapshot&, const Snapshot&) = default;
  /// The same, whatever prev is, which may not be stored.
  [[nodiscard]] bool equals_but_prev(Snapshot other) const {
    other.links[1] = links[1];
    return *this == other;
  }
};

/// What is live, with its links, but for those that leave a choice: anchors, halfedges of faces.
struct LiveItems {
  std::vector<std::vector<Index>> halfedges;
  std::vector<Index> vertices;
  std::vector<Index> faces;

  explicit LiveItems(const Mesh& mesh) {
    for (const Halfedge h : mesh.halfedges()) {
      halfedges.push_back({h.index(), mesh.next(h).index(), mesh.prev(h).index(),
                           mesh.to_vertex(h).index(), mesh.face(h).index()});
    }
    for (const Vertex v : mesh.vertices()) vertices.push_back(v.index());
    for (const Face f : mesh.faces()) faces.push_back(f.index());
  }
  friend bool operator==(const LiveItems&, const LiveItems&) = default;
};

inline Mesh copy_of(const Mesh& mesh) {
  Mesh copy;
  EXPECT_TRUE(copy.assign(mesh));
  return copy;
}

/// Valid at level 3, by `validate` and by the definitions.
inline void expect_valid_complex(const Mesh& mesh) {
  const std::vector<Problem> problems = validate(mesh, 3);
  EXPECT_TRUE(problems.empty()) << problems[0].message;
  EXPECT_TRUE(Invariants(mesh).hold_for_complex());
}

/// That `result` is an error with this code, a sentence, and nothing has changed.
template <class T>
void expect_refused(const Result<T>& result, std::string_view code, const Mesh& mesh,
                    const Snapshot& before) {
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, code) << result.error().message;
  const std::string& message = result.error().message;
  EXPECT_TRUE(message.size() > 30 && std::isupper(message[0]) && message.back() == '.') << message;
  EXPECT_TRUE(Snapshot(mesh) == before);
}

/// Gives the mesh attributes of each kind of item, type and policy, with different values.
inline void add_attributes_of_all_kinds(Mesh& mesh) {
  double value = 1;
  Index number = 0;
  for (const ItemKind kind :
       {ItemKind::kVertex, ItemKind::kHalfedge, ItemKind::kEdge, ItemKind::kFace}) {
    for (const OnSplit policy : {OnSplit::kInterpolate, OnSplit::kNormalize, OnSplit::kCopy,
                                 OnSplit::kDefault, OnSplit::kCopyCorner}) {
      const AttributeOptions options{
          .type = Scalar((3 * number) % 8), .components = 1 + number % 3, .on_split = policy};
      const Result<Attribute*> column = mesh.add_attribute(kind, name_of(policy), options);
      ASSERT_TRUE(column);
      for (Index item = 0; item < mesh.slots(kind); ++item) {
        for (Index i = 0; i < options.components; ++i) {
          column.value()->set(item, i, value, nullptr);
          value = value < 120 ? value + 1 : 1;
        }
      }
      ++number;
    }
  }
}

/// The corners of the loop of `h`, from to_vertex(h) on.
inline std::vector<Index> corners_of(const Mesh& mesh, Halfedge h) {
  std::vector<Index> corners;
  for (const Halfedge on_loop : mesh.loop_ccw(h))
    corners.push_back(mesh.to_vertex(on_loop).index());
  return corners;
}

/// The numbers that Euler operations change: vertices, edges, loops (of faces and boundaries), and
/// components with edges.
struct Counts {
  std::int64_t vertices = 0;
  std::int64_t edges = 0;
  std::int64_t loops = 0;
  std::int64_t faces = 0;
  std::int64_t components = 0;
  std::int64_t isolated = 0;

  explicit Counts(const Mesh& mesh)
      : vertices(mesh.vertex_count()), edges(mesh.edge_count()), faces(mesh.face_count()) {
    for (const Vertex v : mesh.vertices()) isolated += mesh.is_isolated(v) ? 1 : 0;
    std::set<Halfedge> on_loops;
    std::set<Halfedge> reached;
    for (const Halfedge h : mesh.halfedges()) {
      if (on_loops.count(h) == 0) {
        ++loops;
        for (Halfedge on_loop = h; on_loops.insert(on_loop).second;) on_loop = mesh.next(on_loop);
      }
      if (reached.count(h) == 0) {
        ++components;
        std::vector<Halfedge> stack = {h};
        while (!stack.empty()) {
          const Halfedge at = stack.back();
          stack.pop_back();
          if (!reached.insert(at).second) continue;
          stack.insert(stack.end(), {mesh.next(at), mesh.opposite(at)});
        }
      }
    }
  }
  /// V - E + L = 2 C - 2 G, but for isolated vertices
  [[nodiscard]] std::int64_t euler() const { return vertices - isolated - edges + loops; }
  [[nodiscard]] std::int64_t genus() const { return components - euler() / 2; }

  [[nodiscard]] std::vector<std::int64_t> since(const Counts& before) const {
    return {vertices - before.vertices, edges - before.edges, loops - before.loops};
  }
};

inline Mesh loop_complex() {
  Mesh mesh;
  EXPECT_TRUE(decorator::make_loop(mesh).ok());
  return mesh;
}
inline Mesh segment_complex() {
  Mesh mesh;
  EXPECT_TRUE(decorator::make_segment(mesh).ok());
  return mesh;
}

/// Two tori of four by three quads, side by side.
inline Shape two_tori() {
  const Shape one = torus(4, 3);
  std::vector<std::vector<Index>> faces = one.faces;
  for (std::vector<Index> face : one.faces) {
    for (Index& v : face) v += one.vertices;
    faces.push_back(face);
  }
  return {"two tori", 2 * one.vertices, faces};
}

/// Two tori joined by a tube.
inline Mesh genus_two() {
  Mesh mesh = reference_build(two_tori());
  const Halfedge h = mesh.face_halfedge(Face(0));
  const Halfedge g = mesh.face_halfedge(Face(mesh.face_count() - 1));
  EXPECT_TRUE(decorator::join_loop(mesh, h, g).ok());
  EXPECT_EQ(Counts(mesh).genus(), 2);
  return mesh;
}

/// One mesh of each topology, small and degenerate ones included.
inline std::vector<std::pair<std::string, Mesh>> all_complexes() {
  std::vector<std::pair<std::string, Mesh>> all;
  for (const Shape& shape : all_shapes()) {
    if (shape.faces.size() > 30) continue;  // the tests here are quadratic or worse
    all.emplace_back(shape.name, reference_build(shape));
  }
  all.emplace_back("loop", loop_complex());
  all.emplace_back("segment", segment_complex());
  all.emplace_back("genus two", genus_two());
  Mesh flower = loop_complex();  // a vertex, three loop edges
  for (int i = 0; i < 2; ++i)
    EXPECT_TRUE(decorator::split_face(flower, Halfedge(0), Halfedge(0)).ok());
  all.emplace_back("flower", std::move(flower));
  Mesh path = segment_complex();  // a path with a branch
  EXPECT_TRUE(decorator::split_edge(path, Halfedge(0)).ok());
  EXPECT_TRUE(decorator::insert_tip(path, Halfedge(2)).ok());
  all.emplace_back("tree", std::move(path));
  Mesh holes = loop_complex();  // a face of one corner, and a hole of one edge
  EXPECT_TRUE(decorator::make_hole(holes, Halfedge(1)).ok());
  all.emplace_back("loop with a hole", std::move(holes));
  return all;
}

}  // namespace halfedge::test
