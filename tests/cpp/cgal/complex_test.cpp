// The operations of the decorator beside CGAL's: the same calls give the same complex.
//
// CGAL's reads what it has freed, or leaves a link to it, where an edge that goes away lies twice
// in a row on one loop; ours is called there in decorator_test.cpp only. The cases:
//   join_face    an edge that is a loop of one on one of its sides
//   join_vertex  an edge that ends in a vertex without other edges, on either end
//   erase_center_vertex   a face of two corners before h: prev(h) is erased, and returned
//   split_loop, join_loop   a halfedge without a face: its face, a null handle, is written to
//   erase_face   an edge without a face on either side, or a vertex that the face passes twice

#include "cgal/complex.h"

#include <gtest/gtest.h>
#include <halfedge/algorithms/topology.h>
#include <halfedge/decorator/decorator.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/complexes.h"
#include "support/operations.h"

namespace halfedge::test {
namespace {

// Whether CGAL's form of the call is defined, and means the same.
bool is_comparable(const Mesh& mesh, const DecoratorCall& call) {
  const Halfedge h = call.h;
  const auto follows = [&](Halfedge a, Halfedge b) { return mesh.next(a) == b; };
  switch (call.op) {
    case Op::kJoinFace:
      return !follows(h, h) && !follows(mesh.opposite(h), mesh.opposite(h));
    case Op::kJoinVertex:
      return !follows(h, mesh.opposite(h)) && !follows(mesh.opposite(h), h);
    case Op::kSplitEdge:  // split_vertex(prev(h), opposite(h)), which are the same at an end
      return !follows(mesh.opposite(h), h);
    case Op::kJoinEdge:  // join_vertex(opposite(h))
      return !follows(mesh.opposite(h), h);
    case Op::kEraseTip:
      return false;
    case Op::kEraseCenter:
      return mesh.from_vertex(mesh.prev(h)) != mesh.to_vertex(h);
    case Op::kAddVertexAndFace:
      return h != call.g;
    case Op::kSplitLoop:
      return call.cycle.size() == 3 &&
             std::none_of(call.cycle.begin(), call.cycle.end(),
                          [&](Halfedge on_cycle) { return mesh.is_boundary(on_cycle); });
    case Op::kJoinLoop:
      for (const Halfedge on_loop : mesh.loop_ccw(call.g)) {
        if (mesh.is_boundary(mesh.opposite(on_loop))) return false;
      }
      return true;
    case Op::kEraseFace: {
      std::set<Vertex> corners;
      for (const Halfedge on_loop : mesh.loop_ccw(h)) {
        if (!corners.insert(mesh.to_vertex(on_loop)).second) return false;
        if (mesh.face(mesh.opposite(on_loop)) == mesh.face(h)) return false;
      }
      return corners.size() > 2;
    }
    default:
      return true;
  }
}

TheirHalfedge apply_theirs(Mirror& mirror, const DecoratorCall& call) {
  TheirDecorator decorator(mirror.complex);
  const auto at = [&](Halfedge h) {
    return h.valid() ? mirror.halfedges[h.index()] : TheirHalfedge();
  };
  const TheirHalfedge h = at(call.h);
  const TheirHalfedge g = at(call.g);
  switch (call.op) {
    case Op::kMakeLoop:
      return decorator.create_loop();
    case Op::kMakeSegment:
      return decorator.create_segment();
    case Op::kSplitFace:
      return decorator.split_face(h, g);
    case Op::kSplitVertex:
      return decorator.split_vertex(h, g);
    case Op::kSplitEdge:  // as CGAL's Polyhedron has it
      return decorator.split_vertex(decorator.find_prev(h), h->opposite())->opposite();
    case Op::kInsertTip:
      return decorator.split_vertex(h, h)->opposite();
    case Op::kCreateCenter:
      return decorator.create_center_vertex(h);
    case Op::kFillHole:
      return decorator.fill_hole(h);
    case Op::kAddFace:
      return decorator.add_face_to_border(h, g);
    case Op::kAddVertexAndFace: {  // as CGAL's Polyhedron has it
      const TheirHalfedge closing = decorator.add_face_to_border(h, g);
      decorator.split_vertex(g, closing->opposite());
      return g->next();
    }
    case Op::kSplitLoop: {
      const auto& cycle = call.cycle;
      const TheirHalfedge made = decorator.split_loop(at(cycle[0]), at(cycle[1]), at(cycle[2]));
      // Theirs leaves a vertex with a halfedge that has gone to its copy.
      for (const Halfedge on_cycle : cycle) decorator.set_vertex_halfedge(at(on_cycle));
      return made;
    }
    case Op::kFlip:
      return decorator.flip_edge(h);
    case Op::kMakeHole:
      return decorator.make_hole(h);
    case Op::kJoinFace:
      return decorator.join_face(h);
    case Op::kJoinVertex:
      return decorator.join_vertex(h);
    case Op::kJoinEdge: {
      const TheirHalfedge following = h->next();
      decorator.join_vertex(h->opposite());
      return following;
    }
    case Op::kEraseTip:
      break;
    case Op::kEraseCenter:
      return decorator.erase_center_vertex(h);
    case Op::kEraseFace:
      decorator.erase_face(h);
      return {};
    case Op::kJoinLoop:
      return decorator.join_loop(h, g);
  }
  return {};
}

TEST(CgalOperations, AgreeInRandomSequences) {
  std::vector<int> compared(kOpCount);
  std::uint32_t seed = 0;
  for (int round = 0; round < 12; ++round) {
    for (auto& [name, mesh] : all_complexes()) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      RandomCalls random(seed++);
      (void)decorator::keep_largest_connected_components(mesh, kNone);  // no isolated vertices
      Mirror mirror(mesh);
      for (int step = 0; step < 200; ++step) {
        const DecoratorCall call = random.next(mesh);
        if (!check(mesh, call).ok() || !is_comparable(mesh, call)) continue;
        SCOPED_TRACE("step " + std::to_string(step) + ", operation " +
                     std::to_string(int(call.op)));
        const TheirHalfedge theirs = apply_theirs(mirror, call);
        const Result<Halfedge> ours = *apply(mesh, call);
        ASSERT_TRUE(ours.ok()) << ours.error().message;
        ASSERT_EQ(mirror.follow(mesh, ours.value(), theirs), "");
        ASSERT_TRUE(they_accept(mirror.complex, 3));
        ASSERT_TRUE(validate(mesh, 3).empty());
        ++compared[std::size_t(call.op)];
      }
    }
  }
  std::cout << "calls compared, by operation:";
  for (const int count : compared) std::cout << " " << count;
  std::cout << "\n";
  for (int op = 0; op < kOpCount; ++op) {
    EXPECT_TRUE(Op(op) == Op::kEraseTip || compared[std::size_t(op)] > 50) << op;
  }
}

TEST(CgalOperations, AgreeOnInsideOut) {
  for (auto& [name, mesh] : all_complexes()) {
    SCOPED_TRACE(name);
    (void)decorator::keep_largest_connected_components(mesh, kNone);
    // CGAL knows that a boundary loop isn't reversed yet by an edge whose sides have one vertex,
    // as a loop edge always has.
    bool has_loop_edges = false;
    for (const Halfedge h : mesh.halfedges()) {
      has_loop_edges = has_loop_edges || mesh.from_vertex(h) == mesh.to_vertex(h);
    }
    if (has_loop_edges && !is_closed(mesh)) continue;
    Mirror mirror(mesh);
    TheirDecorator(mirror.complex).inside_out();
    ASSERT_TRUE(decorator::inside_out(mesh).ok());
    EXPECT_EQ(mirror.follow(mesh, {}, {}), "");
    EXPECT_TRUE(they_accept(mirror.complex, 3));
  }
}

TEST(CgalOperations, AgreeOnComponents) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomCalls random(seed);
    Mesh mesh = reference_build(two_components());
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(decorator::make_loop(mesh).ok());
      const Halfedge segment = decorator::make_segment(mesh).value();
      for (int j = 0; j < i; ++j) ASSERT_TRUE(decorator::split_edge(mesh, segment).ok());
    }
    Mirror mirror(mesh);
    const Halfedge h = random.any(mesh);
    TheirDecorator decorator(mirror.complex);
    decorator.erase_connected_component(mirror.halfedges.at(h.index()));
    ASSERT_TRUE(decorator::erase_connected_component(mesh, h).ok());
    EXPECT_EQ(mirror.follow(mesh, {}, {}), "");
    // Of components of one size CGAL keeps others; they are as many.
    const Index keep = Index(random.below(8));
    const unsigned theirs = decorator.keep_largest_connected_components(keep);
    EXPECT_EQ(decorator::keep_largest_connected_components(mesh, keep).value(), theirs);
    EXPECT_EQ(mesh.vertex_count(), mirror.complex.size_of_vertices());
  }
}

TEST(CgalOperations, AgreeOnTheNormalOrderOfEdges) {
  std::size_t with_boundary = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = reference_build(quad_grid(4, 3));
    RandomCalls random(seed);
    for (int i = 0; i < 12; ++i) {
      const DecoratorCall call = random.next(mesh);
      if (check(mesh, call).ok()) (void)apply(mesh, call);
    }
    Mirror mirror(mesh);
    mirror.complex.normalize_border();
    const decorator::BoundaryOrder order = decorator::normalize_boundary(mesh).value();
    EXPECT_EQ(order.boundary_edges, mirror.complex.size_of_border_edges());
    EXPECT_EQ(order.boundary_halfedges, mirror.complex.size_of_border_halfedges());
    EXPECT_TRUE(TheirDecorator(mirror.complex).normalized_border_is_valid());
    EXPECT_TRUE(decorator::is_boundary_normalized(mesh));
    with_boundary += order.boundary_edges > 0 ? 1 : 0;

    // Halfedge by halfedge in the same order.
    std::map<const void*, Index> new_of;
    for (const auto& [h, handle] : mirror.halfedges)
      new_of[&*handle] = order.new_halfedge[h].index();
    auto theirs = mirror.complex.halfedges_begin();
    for (const Halfedge h : mesh.halfedges()) EXPECT_EQ(new_of.at(&*theirs++), h.index());
  }
  EXPECT_GT(with_boundary, 30U);
}

}  // namespace
}  // namespace halfedge::test
