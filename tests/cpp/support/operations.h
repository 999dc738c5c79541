#pragma once

#include <halfedge/decorator/decorator.h>

#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

namespace halfedge::test {

/// The operations of the decorator that random sequences are made of.
enum class Op {
  kMakeLoop,
  kMakeSegment,
  kSplitFace,
  kSplitVertex,
  kSplitEdge,
  kInsertTip,
  kCreateCenter,
  kFillHole,
  kAddFace,
  kAddVertexAndFace,
  kSplitLoop,
  kFlip,
  kMakeHole,
  kJoinFace,
  kJoinVertex,
  kJoinEdge,
  kEraseTip,
  kEraseCenter,
  kEraseFace,
  kJoinLoop,
};
inline constexpr int kOpCount = int(Op::kJoinLoop) + 1;
/// From here on nothing is made.
inline constexpr int kFirstRemoval = int(Op::kMakeHole);

/// An operation with the halfedges it is called with; those of a split_loop are in `cycle`.
struct DecoratorCall {
  Op op = Op::kMakeLoop;
  Halfedge h = {};
  Halfedge g = {};
  std::vector<Halfedge> cycle = {};
};

/// What it returns; empty where a mesh type hasn't the links it needs.
template <class Mesh>
std::optional<Result<Halfedge>> apply(Mesh& mesh, const DecoratorCall& call) {
  using namespace decorator;
  const Halfedge h = call.h;
  const Halfedge g = call.g;
  switch (call.op) {
    case Op::kMakeLoop:
      return make_loop(mesh);
    case Op::kMakeSegment:
      return make_segment(mesh);
    case Op::kSplitFace:
      return split_face(mesh, h, g);
    case Op::kSplitVertex:
      return split_vertex(mesh, h, g);
    case Op::kSplitEdge:
      return split_edge(mesh, h);
    case Op::kInsertTip:
      return insert_tip(mesh, h);
    case Op::kCreateCenter:
      return create_center_vertex(mesh, h);
    case Op::kFillHole:
      if constexpr (requires { fill_hole(mesh, h); }) return fill_hole(mesh, h);
      break;
    case Op::kAddFace:
      if constexpr (requires { add_face_to_boundary(mesh, h, g); }) {
        return add_face_to_boundary(mesh, h, g);
      }
      break;
    case Op::kAddVertexAndFace:
      if constexpr (requires { add_vertex_and_face_to_boundary(mesh, h, g); }) {
        return add_vertex_and_face_to_boundary(mesh, h, g);
      }
      break;
    case Op::kSplitLoop:
      return split_loop(mesh, call.cycle);
    case Op::kFlip:
      return flip_edge(mesh, h);
    case Op::kMakeHole:
      if constexpr (requires { make_hole(mesh, h); }) return make_hole(mesh, h);
      break;
    case Op::kJoinFace:
      if constexpr (requires { join_face(mesh, h); }) return join_face(mesh, h);
      break;
    case Op::kJoinVertex:
      if constexpr (requires { join_vertex(mesh, h); }) return join_vertex(mesh, h);
      break;
    case Op::kJoinEdge:
      if constexpr (requires { join_edge(mesh, h); }) return join_edge(mesh, h);
      break;
    case Op::kEraseTip:
      if constexpr (requires { erase_tip(mesh, h); }) return erase_tip(mesh, h);
      break;
    case Op::kEraseCenter:
      if constexpr (requires { erase_center_vertex(mesh, h); }) return erase_center_vertex(mesh, h);
      break;
    case Op::kEraseFace:
      if constexpr (requires { erase_face(mesh, h); }) {
        const Result<void> erased = erase_face(mesh, h);
        return erased ? Result<Halfedge>(Halfedge{}) : Result<Halfedge>(erased.error());
      }
      break;
    case Op::kJoinLoop:
      if constexpr (requires { join_loop(mesh, h, g); }) return join_loop(mesh, h, g);
      break;
  }
  return std::nullopt;
}

/// What `check_x` says of it.
template <class Mesh>
Result<void> check(const Mesh& mesh, const DecoratorCall& call) {
  using namespace decorator;
  const Halfedge h = call.h;
  const Halfedge g = call.g;
  switch (call.op) {
    case Op::kMakeLoop:
    case Op::kMakeSegment:
      return {};
    case Op::kSplitFace:
      return check_split_face(mesh, h, g);
    case Op::kSplitVertex:
      return check_split_vertex(mesh, h, g);
    case Op::kSplitEdge:
      return check_split_edge(mesh, h);
    case Op::kInsertTip:
      return check_split_vertex(mesh, h, h);
    case Op::kCreateCenter:
      return check_create_center_vertex(mesh, h);
    case Op::kFillHole:
      return check_fill_hole(mesh, h);
    case Op::kAddFace:
    case Op::kAddVertexAndFace:
      return check_add_face_to_boundary(mesh, h, g);
    case Op::kSplitLoop:
      return check_split_loop(mesh, call.cycle);
    case Op::kFlip:
      return check_flip_edge(mesh, h);
    case Op::kMakeHole:
      return check_make_hole(mesh, h);
    case Op::kJoinFace:
      return check_join_face(mesh, h);
    case Op::kJoinVertex:
      return check_join_vertex(mesh, h);
    case Op::kJoinEdge:
      return check_join_edge(mesh, h);
    case Op::kEraseTip:
      return check_erase_tip(mesh, h);
    case Op::kEraseCenter:
      return check_erase_center_vertex(mesh, h);
    case Op::kEraseFace:
      return check_erase_face(mesh, h);
    case Op::kJoinLoop:
      return check_join_loop(mesh, h, g);
  }
  return {};
}

/// Calls with halfedges that often fit; a mesh of about `size` edges stays about that large.
class RandomCalls {
 public:
  explicit RandomCalls(std::uint32_t seed, std::size_t size = 40) : random_(seed), size_(size) {}

  template <class Mesh>
  DecoratorCall next(const Mesh& mesh) {
    DecoratorCall call;
    const bool remove = below(2 * size_) < mesh.edge_count();
    call.op = Op(remove ? kFirstRemoval + int(below(std::size_t(kOpCount - kFirstRemoval)))
                        : int(below(kFirstRemoval)));
    if (call.op <= Op::kMakeSegment && mesh.edge_count() > 0 && below(4) > 0) {
      call.op = Op::kSplitFace;
    }
    if (mesh.edge_count() == 0) {
      call.op = below(2) == 0 ? Op::kMakeLoop : Op::kMakeSegment;
      return call;
    }
    call.h = any(mesh);
    call.g = any(mesh);
    if (call.op == Op::kSplitVertex) {
      call.g = call.h;
      for (std::size_t i = below(6); i > 0; --i) call.g = mesh.next_on_vertex(call.g);
    } else if (call.op != Op::kJoinLoop && below(8) > 0) {
      call.g = call.h;
      for (std::size_t i = below(6); i > 0; --i) call.g = mesh.next(call.g);
    }
    if (call.op == Op::kSplitLoop) call.cycle = cycle_at(mesh, call.h);
    return call;
  }

  std::size_t below(std::size_t count) { return std::size_t(random_()) % count; }

  template <class Mesh>
  Halfedge any(const Mesh& mesh) {
    std::vector<Halfedge> live;
    for (const Halfedge h : mesh.halfedges()) live.push_back(h);
    return live[below(live.size())];
  }

  /// A cycle through `h`: three halfedges if there are such, else the loop of h.
  template <class Mesh>
  std::vector<Halfedge> cycle_at(const Mesh& mesh, Halfedge h) {
    std::vector<std::vector<Halfedge>> found;
    for (const Halfedge i : mesh.loop_ccw(h)) {
      if (found.empty()) found.emplace_back();
      found[0].push_back(i);
    }
    const auto leaving = [&](Halfedge in) {
      return mesh.outgoing_cw(mesh.to_vertex(in), mesh.opposite(in));
    };
    for (const Halfedge i : leaving(h)) {
      for (const Halfedge j : leaving(i)) {
        if (mesh.to_vertex(j) == mesh.from_vertex(h)) found.push_back({h, i, j});
      }
    }
    return found[below(found.size())];
  }

 private:
  std::mt19937 random_;
  std::size_t size_;
};

}  // namespace halfedge::test
