// The operations of the decorator undo each other, on every complex and with every argument; and
// whatever their sequence, the invariants hold.

#include <gtest/gtest.h>
#include <halfedge/decorator/decorator.h>

#include <iostream>
#include <string>
#include <vector>

#include "support/complexes.h"
#include "support/operations.h"
#include "support/storages.h"

namespace halfedge::test {
namespace {

using namespace decorator;

// Makes something by `make`, undoes it by `undo`: all live links are as before. Making it again
// takes the same slots, so that all arrays are the same as after the first time.
template <class Make, class Undo>
void expect_undone(const Mesh& original, Make make, Undo undo) {
  Mesh mesh = copy_of(original);
  const auto made = make(mesh);
  ASSERT_TRUE(made.ok());
  expect_valid_complex(mesh);
  const Snapshot first(mesh);
  ASSERT_TRUE(undo(mesh, made.value()));
  expect_valid_complex(mesh);
  EXPECT_TRUE(LiveItems(mesh) == LiveItems(original));
  ASSERT_TRUE(make(mesh).ok());
  const Snapshot again(mesh);
  EXPECT_TRUE(again.links[0] == first.links[0] && again.links[1] == first.links[1] &&
              again.links[2] == first.links[2] && again.links[3] == first.links[3] &&
              again.positions == first.positions && again.free == first.free);
  expect_valid_complex(mesh);
}

// Whether something was made again, and a halfedge of it, as it was and as it is.
struct Made {
  Made(bool is_ok, Halfedge old_one = {}, Halfedge new_one = {})
      : ok(is_ok), was(old_one), is(new_one) {}
  bool ok;
  Halfedge was;
  Halfedge is;
};

// Removes something by `remove`, makes it again by `make`: the same but for the numbers of items.
template <class Remove, class Make>
void expect_restored(const Mesh& original, Remove remove, Make make) {
  Mesh mesh = copy_of(original);
  const auto removed = remove(mesh);
  ASSERT_TRUE(removed.ok()) << removed.error().message;
  expect_valid_complex(mesh);
  Matching<View<Mesh>, View<Mesh>>::Matched kept;
  for (const Halfedge h : mesh.halfedges()) kept.emplace_back(h.index(), h.index());
  const Made made = make(mesh, removed.value());
  ASSERT_TRUE(made.ok);
  expect_valid_complex(mesh);
  if (made.was.valid()) kept.emplace_back(made.was.index(), made.is.index());
  if (kept.empty()) return;
  Matching same(View{original}, View{std::as_const(mesh)});
  EXPECT_EQ(same.run(kept), "");
}

// Calls `law(mesh, h)` for every halfedge of every complex.
template <class Law>
void for_all_halfedges(Law law) {
  for (const auto& [name, mesh] : all_complexes()) {
    for (const Halfedge h : mesh.halfedges()) {
      SCOPED_TRACE(name + ", halfedge " + std::to_string(h.index()));
      law(mesh, h);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(DecoratorLaws, JoinFaceUndoesSplitFace) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    for (const Halfedge g : mesh.loop_ccw(h)) {
      if (mesh.is_boundary(h)) continue;
      expect_undone(
          mesh, [&](Mesh& m) { return split_face(m, h, g); },
          [&](Mesh& m, Halfedge d) { return join_face(m, d).value() == h; });
    }
  });
}

TEST(DecoratorLaws, SplitFaceRestoresWhatJoinFaceRemoved) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    const Halfedge o = mesh.opposite(h);
    if (!check_join_face(mesh, h).ok() || mesh.is_boundary(h) || mesh.is_boundary(o)) return;
    const Halfedge before_h = mesh.prev(h) == h ? mesh.prev(o) : mesh.prev(h);
    const Halfedge before_o = mesh.prev(o) == o ? mesh.prev(h) : mesh.prev(o);
    expect_restored(
        mesh, [&](Mesh& m) { return join_face(m, h); },
        [&](Mesh& m, Halfedge returned) {
          return returned == before_h && split_face(m, before_h, before_o).ok();
        });
  });
}

TEST(DecoratorLaws, JoinVertexUndoesSplitVertex) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    for (const Halfedge out : mesh.outgoing_cw(mesh.to_vertex(h))) {
      const Halfedge g = mesh.opposite(out);
      if (mesh.is_boundary(h) && mesh.is_boundary(g)) continue;
      expect_undone(
          mesh, [&](Mesh& m) { return split_vertex(m, h, g); },
          [&](Mesh& m, Halfedge d) { return join_vertex(m, d).value() == h; });
    }
  });
}

TEST(DecoratorLaws, SplitVertexRestoresWhatJoinVertexRemoved) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    if (!check_join_vertex(mesh, h).ok()) return;
    const Halfedge o = mesh.opposite(h);
    const Halfedge before_o = mesh.prev(o) == h ? mesh.prev(h) : mesh.prev(o);
    const Halfedge before_h = mesh.prev(h) == o ? mesh.prev(o) : mesh.prev(h);
    expect_restored(
        mesh, [&](Mesh& m) { return join_vertex(m, h); },
        [&](Mesh& m, Halfedge returned) {
          return returned == before_o && split_vertex(m, before_o, before_h).ok();
        });
  });
}

TEST(DecoratorLaws, JoinEdgeAndSplitEdgeUndoEachOther) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    expect_undone(
        mesh, [&](Mesh& m) { return split_edge(m, h); },
        [&](Mesh& m, Halfedge k) { return join_edge(m, k).value() == h; });
    if (!check_join_edge(mesh, h).ok()) return;
    expect_restored(
        mesh, [&](Mesh& m) { return join_edge(m, h); },
        [&](Mesh& m, Halfedge returned) {
          return returned == mesh.next(h) && split_edge(m, returned).ok();
        });
  });
}

TEST(DecoratorLaws, EraseTipAndInsertTipUndoEachOther) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    if (!mesh.is_boundary(h)) {
      expect_undone(
          mesh, [&](Mesh& m) { return insert_tip(m, h); },
          [&](Mesh& m, Halfedge tip) { return erase_tip(m, tip).value() == h; });
    }
    if (!check_erase_tip(mesh, h).ok()) return;
    expect_restored(
        mesh, [&](Mesh& m) { return erase_tip(m, h); },
        [&](Mesh& m, Halfedge returned) {
          return returned == mesh.prev(h) && insert_tip(m, returned).ok();
        });
  });
}

TEST(DecoratorLaws, CenterVerticesAreErasedAndCreated) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    if (!mesh.is_boundary(h)) {
      expect_undone(
          mesh, [&](Mesh& m) { return create_center_vertex(m, h); },
          [&](Mesh& m, Halfedge k) { return erase_center_vertex(m, k).value() == h; });
    }
    if (!check_erase_center_vertex(mesh, h).ok()) return;
    for (const Face f : mesh.vertex_faces_cw(mesh.to_vertex(h))) {
      if (mesh.degree(f) != 3) return;
    }
    expect_restored(
        mesh, [&](Mesh& m) { return erase_center_vertex(m, h); },
        [&](Mesh& m, Halfedge returned) {
          return returned == mesh.prev(h) && create_center_vertex(m, returned).ok();
        });
  });
}

TEST(DecoratorLaws, HolesAreMadeAndFilled) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    if (mesh.is_boundary(h)) {
      expect_undone(
          mesh, [&](Mesh& m) { return fill_hole(m, h); },
          [&](Mesh& m, Halfedge) { return make_hole(m, h).ok(); });
    } else if (check_make_hole(mesh, h).ok()) {
      expect_undone(
          mesh, [&](Mesh& m) { return make_hole(m, h); },
          [&](Mesh& m, Halfedge) { return fill_hole(m, h).ok(); });
    }
  });
}

TEST(DecoratorLaws, FacesOnTheBoundaryAreErasedAndJoined) {
  for_all_halfedges([](const Mesh& mesh, Halfedge h) {
    if (!mesh.is_boundary(h)) return;
    for (const Halfedge g : mesh.loop_ccw(h)) {
      expect_undone(
          mesh, [&](Mesh& m) { return add_face_to_boundary(m, h, g); },
          [&](Mesh& m, Halfedge d) { return join_face(m, m.opposite(d)).ok(); });
      expect_undone(
          mesh, [&](Mesh& m) { return add_face_to_boundary(m, h, g); },
          [&](Mesh& m, Halfedge d) { return erase_face(m, d).ok(); });
      expect_undone(
          mesh, [&](Mesh& m) { return add_vertex_and_face_to_boundary(m, h, g); },
          [&](Mesh& m, Halfedge k) { return erase_face(m, k).ok(); });
    }
  });
}

TEST(DecoratorLaws, LoopsAreJoinedAndSplit) {
  RandomCalls random(1);
  for_all_halfedges([&](const Mesh& mesh, Halfedge h) {
    for (int tries = 0; tries < 3; ++tries) {
      const std::vector<Halfedge> cycle = random.cycle_at(mesh, h);
      if (!check_split_loop(mesh, cycle).ok()) continue;
      expect_undone(
          mesh, [&](Mesh& m) { return split_loop(m, cycle); },
          [&](Mesh& m, Halfedge g) { return join_loop(m, cycle[0], g).value() == cycle[0]; });
    }
    const Halfedge g = random.any(mesh);
    if (!check_join_loop(mesh, h, g).ok()) return;
    std::vector<Halfedge> cycle;
    for (const Halfedge on_loop : mesh.loop_ccw(h)) cycle.push_back(on_loop);
    if (mesh.is_boundary(h) || mesh.is_boundary(g)) return;
    expect_restored(
        mesh, [&](Mesh& m) { return join_loop(m, h, g); },
        [&](Mesh& m, Halfedge) {
          const Result<Halfedge> copy = split_loop(m, cycle);
          return Made(copy.ok(), g, copy.value());
        });
  });
}

TEST(DecoratorLaws, FourFlipsAreNone) {
  std::size_t flips = 0;
  for_all_halfedges([&](const Mesh& mesh, Halfedge h) {
    if (!check_flip_edge(mesh, h).ok()) return;
    ++flips;
    Mesh turned = copy_of(mesh);
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(flip_edge(turned, h).ok());
      expect_valid_complex(turned);
    }
    EXPECT_TRUE(LiveItems(turned) == LiveItems(mesh));
  });
  EXPECT_GT(flips, 80U);
}

// By how much vertices, edges and loops change.
std::vector<std::int64_t> expected_change(const Mesh& mesh, const DecoratorCall& call) {
  const auto n = [&](Halfedge h) { return std::int64_t(corners_of(mesh, h).size()); };
  switch (call.op) {
    case Op::kMakeLoop:
      return {1, 1, 2};
    case Op::kMakeSegment:
      return {2, 1, 1};
    case Op::kSplitFace:
    case Op::kAddFace:
      return {0, 1, 1};
    case Op::kSplitVertex:
    case Op::kSplitEdge:
    case Op::kInsertTip:
      return {1, 1, 0};
    case Op::kCreateCenter:
      return {1, n(call.h), n(call.h) - 1};
    case Op::kAddVertexAndFace:
      return {1, 2, 1};
    case Op::kSplitLoop:
      return {std::int64_t(call.cycle.size()), std::int64_t(call.cycle.size()), 2};
    case Op::kJoinLoop:
      return {-n(call.h), -n(call.h), -2};
    case Op::kJoinFace:
      return {0, -1, -1};
    case Op::kJoinVertex:
    case Op::kJoinEdge:
    case Op::kEraseTip:
      return {-1, -1, 0};
    case Op::kEraseCenter: {
      const std::int64_t valence = mesh.valence(mesh.to_vertex(call.h));
      return {-1, -valence, 1 - valence};
    }
    case Op::kFlip:
    case Op::kFillHole:
    case Op::kMakeHole:
      return {0, 0, 0};
    case Op::kEraseFace:
      return {};  // as many as have no other face
  }
  return {};
}

// One step: refused with everything unchanged, or done with the counts as Euler has them.
void take(Mesh& mesh, const DecoratorCall& call, std::vector<int>& done) {
  const Result<void> can = check(std::as_const(mesh), call);
  if (!can) {
    const Snapshot before(mesh);
    expect_refused(*apply(mesh, call), can.error().code, mesh, before);
    return;
  }
  const std::vector<std::int64_t> expected = expected_change(mesh, call);
  const Counts before(mesh);
  const Result<Halfedge> result = *apply(mesh, call);
  ASSERT_TRUE(result.ok()) << result.error().message;
  ++done[std::size_t(call.op)];
  expect_valid_complex(mesh);
  const Counts after(mesh);
  EXPECT_EQ(after.euler() % 2, 0);
  EXPECT_GE(after.genus(), 0);
  if (!expected.empty()) {
    EXPECT_EQ(after.since(before), expected);
    EXPECT_TRUE(mesh.is_live(result.value()));
  }
  const bool changes_genus = call.op == Op::kSplitLoop || call.op == Op::kJoinLoop;
  if (!changes_genus && call.op != Op::kEraseFace) {
    EXPECT_EQ(after.genus(), before.genus());
  }
}

TEST(DecoratorLaws, HoldInRandomSequences) {
  std::vector<int> done(kOpCount);
  std::int64_t largest_genus = 0;
  std::uint32_t seed = 0;
  for (int round = 0; round < 3; ++round) {
    for (auto& [name, mesh] : all_complexes()) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      RandomCalls random(seed++);
      for (int step = 0; step < 250; ++step) {
        const DecoratorCall call = random.next(mesh);
        SCOPED_TRACE("step " + std::to_string(step) + ", operation " +
                     std::to_string(int(call.op)));
        take(mesh, call, done);
        if (HasFailure()) return;
      }
      largest_genus = std::max(largest_genus, Counts(mesh).genus());
    }
  }
  std::cout << "operations done, by kind:";
  for (const int count : done) std::cout << " " << count;
  std::cout << "; largest genus " << largest_genus << "\n";
  for (const int count : done) EXPECT_GT(count, 30);
  EXPECT_GT(largest_genus, 1);
}

// The same calls, of those that a mesh type has the links for, on it and on the whole mesh: the
// links that both store are the same.
template <class Stored>
class DecoratorStorage : public testing::Test {};
TYPED_TEST_SUITE(DecoratorStorage, AllStorages);

template <class Part>
bool has_same_links(const Part& part, const Mesh& whole) {
  constexpr Storage kStored = Part::kStorage;
  bool same =
      part.vertex_count() == whole.vertex_count() && part.edge_count() == whole.edge_count();
  for (const Halfedge h : whole.halfedges()) {
    same = same && part.next(h) == whole.next(h) && part.prev(h) == whole.prev(h) &&
           part.to_vertex(h) == whole.to_vertex(h);
    if constexpr (kStored.face) same = same && part.face(h) == whole.face(h);
  }
  for (const Vertex v : whole.vertices()) {
    same = same && part.position(v) == whole.position(v);
    if constexpr (kStored.vertex_halfedge && kStored.face) {
      same = same && part.vertex_halfedge(v) == whole.vertex_halfedge(v);
    }
  }
  if constexpr (kStored.face && kStored.face_halfedge) {
    for (const Face f : whole.faces())
      same = same && part.face_halfedge(f) == whole.face_halfedge(f);
  }
  return same;
}

TYPED_TEST(DecoratorStorage, GivesTheSameLinks) {
  using Part = BasicMesh<TypeParam::kStorage>;
  if constexpr (!Editable<Part>) {
    // Faces that halfedges don't know can't follow a change.
    EXPECT_FALSE((requires(Part & mesh, Halfedge h) { split_face(mesh, h, h); }));
    EXPECT_FALSE((requires(Part & mesh) { make_loop(mesh); }));
  } else {
    int done = 0;
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
      RandomCalls random(seed);
      Mesh whole;
      Part part;
      for (int step = 0; step < 120; ++step) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
        const DecoratorCall call = random.next(whole);
        // Without faces a hole and a face are the same.
        const bool is_of_holes = call.op == Op::kMakeHole || call.op == Op::kEraseFace;
        if ((!Part::kStorage.face && is_of_holes) || !check(whole, call).ok()) continue;
        const auto result = apply(part, call);
        if (!result) continue;
        ASSERT_TRUE(result->ok()) << result->error().message;
        const Result<Halfedge> expected = *apply(whole, call);
        EXPECT_EQ(result->value(), expected.value());
        ASSERT_TRUE(has_same_links(part, whole));
        ++done;
      }
      const std::vector<Problem> problems = validate(part, 3);
      EXPECT_TRUE(problems.empty()) << problems[0].message;
      ASSERT_TRUE(inside_out(part).ok());
      ASSERT_TRUE(inside_out(whole).ok());
      EXPECT_TRUE(has_same_links(part, whole));
    }
    EXPECT_GT(done, 150);
  }
}

}  // namespace
}  // namespace halfedge::test
