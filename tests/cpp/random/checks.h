#pragma once

#include <gtest/gtest.h>
#include <halfedge/mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "random/operation.h"

/// What holds after every operation, whatever it is.
namespace halfedge::test {

/// The vertices of all faces and boundary loops at `v`.
inline void add_neighbours(const Mesh& mesh, Vertex v, Items& near) {
  near.add(v);
  for (const Halfedge h : mesh.outgoing_cw(v)) {
    for (const Halfedge on_loop : mesh.loop_ccw(h)) near.add(mesh.to_vertex(on_loop));
  }
}

/// What an operation may touch: items with an end at one of these vertices.
inline Items touched_by(const Mesh& mesh, const Call& call) {
  Items near;
  const auto add_halfedge = [&](Halfedge h) {
    if (!mesh.is_live(h)) return;
    add_neighbours(mesh, mesh.from_vertex(h), near);
    add_neighbours(mesh, mesh.to_vertex(h), near);
  };
  add_halfedge(call.h);
  add_halfedge(call.g);
  if (mesh.is_live(call.e)) add_halfedge(mesh.edge_halfedge(call.e));
  if (mesh.is_live(call.v)) add_neighbours(mesh, call.v, near);
  if (mesh.is_live(call.f)) {
    for (const Vertex v : mesh.face_vertices_ccw(call.f)) add_neighbours(mesh, v, near);
  }
  for (const Halfedge h : call.path) add_halfedge(h);
  for (const Edge e : call.edges) {
    if (mesh.is_live(e)) add_halfedge(mesh.edge_halfedge(e));
  }
  for (const Vertex v : call.corners) {
    if (mesh.is_live(v)) add_neighbours(mesh, v, near);
  }
  return near;
}

/// The attributes of one item, byte by byte.
inline bool same_attributes(const Mesh& before, const Mesh& after, ItemKind kind, Index item) {
  const std::span<const Attributes::Column> columns = before.attributes().of(kind);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Attribute& a = *columns[i];
    const Attribute& b = *after.attributes().of(kind)[i];
    const std::size_t offset = a.stride() * item;
    if (std::memcmp(a.bytes().data() + offset, b.bytes().data() + offset, a.stride()) != 0) {
      return false;
    }
  }
  return true;
}

/// Whether an item that was live is still the same, not another one in its slot.
template <class Item>
bool is_kept(const Mesh& before, const Mesh& after, Item item) {
  return after.is_live(item) && before.generation(item) == after.generation(item);
}

/// The items that were deleted are among those that the operation names.
inline void expect_only_named_items_deleted(const Mesh& before, const Mesh& after,
                                            const Operation& op, const Call& call) {
  Items named;
  if (op.deletes != nullptr) op.deletes(before, call, named);
  for (const Vertex v : before.vertices()) {
    if (!is_kept(before, after, v)) {
      EXPECT_EQ(named.vertices.count(v.index()), 1U) << "vertex " << v.index() << " was deleted";
    }
  }
  for (const Edge e : before.edges()) {
    if (!is_kept(before, after, e)) {
      EXPECT_EQ(named.edges.count(e.index()), 1U) << "edge " << e.index() << " was deleted";
    }
  }
  for (const Face f : before.faces()) {
    if (!is_kept(before, after, f)) {
      EXPECT_EQ(named.faces.count(f.index()), 1U) << "face " << f.index() << " was deleted";
    }
  }
}

/// Items away from the arguments have the same links, positions and attributes.
inline void expect_rest_unchanged(const Mesh& before, const Mesh& after, const Operation& op,
                                  const Call& call) {
  const Items near = touched_by(before, call);
  const auto is_near = [&](Vertex v) { return near.vertices.count(v.index()) > 0; };
  for (const Vertex v : before.vertices()) {
    if (is_kept(before, after, v) && !op.moves) {
      EXPECT_EQ(before.position(v), after.position(v)) << "vertex " << v.index() << " has moved";
    }
  }
  if (op.everywhere) return;
  for (const Vertex v : before.vertices()) {
    if (is_near(v)) continue;
    EXPECT_EQ(before.position(v), after.position(v)) << "vertex " << v.index() << " has moved";
    EXPECT_TRUE(is_kept(before, after, v) && before.vertex_halfedge(v) == after.vertex_halfedge(v))
        << "anchor of vertex " << v.index();
    EXPECT_TRUE(same_attributes(before, after, ItemKind::kVertex, v.index()))
        << "attributes of vertex " << v.index();
  }
  for (const Halfedge h : before.halfedges()) {
    if (is_near(before.from_vertex(h)) || is_near(before.to_vertex(h))) continue;
    EXPECT_TRUE(is_kept(before, after, before.edge(h)) && before.next(h) == after.next(h) &&
                before.prev(h) == after.prev(h) && before.to_vertex(h) == after.to_vertex(h) &&
                before.face(h) == after.face(h))
        << "links of halfedge " << h.index();
    EXPECT_TRUE(same_attributes(before, after, ItemKind::kHalfedge, h.index()))
        << "attributes of halfedge " << h.index();
    EXPECT_TRUE(same_attributes(before, after, ItemKind::kEdge, h.index() / 2))
        << "attributes of edge " << h.index() / 2;
  }
  for (const Face f : before.faces()) {
    bool is_near_one = false;
    for (const Vertex v : before.face_vertices_ccw(f)) is_near_one = is_near_one || is_near(v);
    if (is_near_one) continue;
    EXPECT_TRUE(is_kept(before, after, f) && before.face_halfedge(f) == after.face_halfedge(f))
        << "face " << f.index();
    EXPECT_TRUE(same_attributes(before, after, ItemKind::kFace, f.index()))
        << "attributes of face " << f.index();
  }
}

/// Whether an item has in one column what another one has in the other, byte by byte.
inline bool same_value(const Attribute& a, Index item, const Attribute& b, Index other) {
  const std::size_t size = a.stride();
  return std::memcmp(a.bytes().data() + size * item, b.bytes().data() + size * other, size) == 0;
}
inline bool has_default_value(const Attribute& column, Index item) {
  const std::size_t size = column.stride();
  return std::memcmp(column.bytes().data() + size * item, column.default_value().data(), size) == 0;
}

/// Every live item has a position and values that are numbers.
inline void expect_defined_values(const Mesh& mesh) {
  for (const Vertex v : mesh.vertices()) {
    const Point p = mesh.position(v);
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
        << "position of vertex " << v.index();
  }
  const auto check = [&](ItemKind kind, Index item) {
    for (const auto& column : mesh.attributes().of(kind)) {
      for (Index i = 0; i < column->components(); ++i) {
        EXPECT_TRUE(std::isfinite(column->get(item, i)))
            << column->name() << " of " << name_of(kind) << " " << item;
      }
    }
  };
  for (const Vertex v : mesh.vertices()) check(ItemKind::kVertex, v.index());
  for (const Halfedge h : mesh.halfedges()) check(ItemKind::kHalfedge, h.index());
  for (const Edge e : mesh.edges()) check(ItemKind::kEdge, e.index());
  for (const Face f : mesh.faces()) check(ItemKind::kFace, f.index());
}

/// Policies that copy mix no values: what an item has, one had before, or is the default.
template <class Item>
void expect_copied_values(const Mesh& before, const Mesh& after) {
  const std::span<const Attributes::Column> columns = after.attributes().of(kind_of(Item{}));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Attribute& has = *columns[i];
    const Attribute& had = *before.attributes().of(kind_of(Item{}))[i];
    const OnSplit policy = has.on_split();
    if (policy == OnSplit::kInterpolate || policy == OnSplit::kNormalize) continue;
    if (has.is_generation()) continue;
    const Index old_slots = before.slots(Item{});
    for (Index item = 0; item < after.slots(Item{}); ++item) {
      if (!after.is_live(Item(item)) || has_default_value(has, item)) continue;
      const auto was_at = [&](Index old) {
        return before.is_live(Item(old)) && same_value(had, old, has, item);
      };
      bool is_known = item < old_slots && was_at(item);
      for (Index old = 0; old < old_slots && !is_known; ++old) is_known = was_at(old);
      EXPECT_TRUE(is_known) << "value '" << has.name() << "' of " << name_of(has.kind()) << " "
                            << item << " is of no item from before";
    }
  }
}

/// Values of corners that are copied stay at their vertex, if it stays where it is: a side of a
/// face that ends there has the default, or what one had that ended there, or at a vertex that is
/// no more.
inline void expect_corner_values_stay(const Mesh& before, const Mesh& after) {
  const char* const name = name_of(OnSplit::kCopyCorner);
  const Attribute& had = *before.find_attribute(ItemKind::kHalfedge, name);
  const Attribute& has = *after.find_attribute(ItemKind::kHalfedge, name);
  for (const Halfedge h : after.halfedges()) {
    const Vertex v = after.to_vertex(h);
    if (after.is_boundary(h) || has_default_value(has, h.index())) continue;
    if (!before.is_live(v) || !is_kept(before, after, v)) continue;
    if (before.position(v) != after.position(v)) continue;
    const auto was_at = [&](Halfedge old) {
      const Vertex w = before.to_vertex(old);
      return (w == v || !is_kept(before, after, w)) && same_value(had, old.index(), has, h.index());
    };
    if (before.is_live(h) && was_at(h)) continue;
    const auto all = before.halfedges();
    EXPECT_TRUE(std::ranges::any_of(all, was_at))
        << "halfedge " << h.index() << " has the value of a corner that was not at vertex "
        << v.index();
  }
}

inline int euler_characteristic(const Mesh& mesh) {
  return int(mesh.vertex_count()) - int(mesh.edge_count()) + int(mesh.face_count());
}

}  // namespace halfedge::test
