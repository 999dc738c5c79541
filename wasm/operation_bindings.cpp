// The operations on edges, faces and vertices that programs do by the million: see
// operation_bindings.h.

#include "operation_bindings.h"

#include <halfedge/operations/operations.h>

using namespace halfedge;
using namespace halfedge::bindings;

HALFEDGE_EXPORT int flip_edge(Address mesh, Index mode, Index e) {
  return HALFEDGE_OPERATE(flip_edge, Edge(e));
}

HALFEDGE_EXPORT int insert_vertex_on_edge(Address mesh, Index mode, Index e, double x, double y,
                                          double z) {
  return operate(
      mesh, mode,
      [=](const auto& m) { return operations::check_insert_vertex_on_edge(m, Edge(e)); },
      [=](auto& m) {
        return operations::insert_vertex_on_edge(m, Edge(e), position_if_given(mode, x, y, z));
      });
}

HALFEDGE_EXPORT int remove_vertex_on_edge(Address mesh, Index mode, Index v) {
  return HALFEDGE_OPERATE(remove_vertex_on_edge, Vertex(v));
}

HALFEDGE_EXPORT int split_edge(Address mesh, Index mode, Index e, double x, double y, double z) {
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_split_edge(m, Edge(e)); },
      [=](auto& m) {
        return operations::split_edge(m, Edge(e), position_if_given(mode, x, y, z));
      });
}

/// kOption: also where two faces with the same corners would be left.
HALFEDGE_EXPORT int collapse(Address mesh, Index mode, Index h, double x, double y, double z) {
  const auto condition = (mode & kOption) != 0 ? operations::LinkCondition::kPermissive
                                               : operations::LinkCondition::kStrict;
  return operate(
      mesh, mode,
      [=](const auto& m) { return operations::check_collapse(m, Halfedge(h), condition); },
      [=](auto& m) {
        const std::optional<Point> position = position_if_given(mode, x, y, z);
        return operations::collapse(m, Halfedge(h), position, condition);
      });
}

/// What fills the gap on the left is kOption times a value of SplitSide, on the right 4 times that.
HALFEDGE_EXPORT int split_vertex(Address mesh, Index mode, Index left, Index right, double x,
                                 double y, double z) {
  const operations::SplitSides sides{
      .left = static_cast<operations::SplitSide>(mode / kOption % 4),
      .right = static_cast<operations::SplitSide>(mode / (4 * kOption) % 4)};
  const Halfedge hl(left);
  const Halfedge hr(right);
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_split_vertex(m, hl, hr, sides); },
      [=](auto& m) {
        const std::optional<Point> position = position_if_given(mode, x, y, z);
        return operations::split_vertex(m, hl, hr, position, sides);
      });
}

HALFEDGE_EXPORT int insert_edge(Address mesh, Index mode, Index h, Index g) {
  return HALFEDGE_OPERATE(insert_edge, Halfedge(h), Halfedge(g));
}

HALFEDGE_EXPORT int remove_edge(Address mesh, Index mode, Index e) {
  return HALFEDGE_OPERATE(remove_edge, Edge(e));
}

HALFEDGE_EXPORT int split_face(Address mesh, Index mode, Index f, double x, double y, double z) {
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_split_face(m, Face(f)); },
      [=](auto& m) {
        return operations::split_face(m, Face(f), position_if_given(mode, x, y, z));
      });
}

/// Where the words of the refusal lie, which are good until it is forgotten: address and length of
/// its code, its sentence and the lists of its witness.
HALFEDGE_EXPORT Address last_refusal() {
  static std::array<std::uint32_t, 12> words;
  std::uint32_t* word = words.data();
  const auto put = [&](const auto& list) {
    *word++ = static_cast<std::uint32_t>(reinterpret_cast<Address>(list.data()));
    *word++ = static_cast<std::uint32_t>(list.size());
  };
  const auto& [code, message, witness] = refusal.error();
  put(code);
  put(message);
  put(witness.vertices);
  put(witness.halfedges);
  put(witness.edges);
  put(witness.faces);
  return reinterpret_cast<Address>(words.data());
}

/// Frees its memory.
HALFEDGE_EXPORT void forget_refusal() {
  refusal = {};
  (void)Reserve::take_back();
}
