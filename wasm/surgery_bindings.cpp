// The operations that glue and cut, along edges, paths and loops, and those on orientation: see
// operation_bindings.h.

#include <halfedge/operations/operations.h>

#include <algorithm>
#include <utility>

#include "operation_bindings.h"

using namespace halfedge;
using namespace halfedge::bindings;

HALFEDGE_EXPORT int glue(Address mesh, Index mode, Index h, Index g) {
  return HALFEDGE_OPERATE(glue, Halfedge(h), Halfedge(g));
}

HALFEDGE_EXPORT int glue_path(Address mesh, Index mode, Index h, Index g, std::size_t count) {
  return HALFEDGE_OPERATE(glue_path, Halfedge(h), Halfedge(g), count);
}

HALFEDGE_EXPORT int cut(Address mesh, Index mode, Index h) {
  return HALFEDGE_OPERATE(cut, Halfedge(h));
}

HALFEDGE_EXPORT int cut_path(Address mesh, Index mode, Address path, std::size_t count) {
  return HALFEDGE_OPERATE(cut_path, items_at<Halfedge>(path, count));
}

/// Returns how many, and writes the halfedges that the core returns over the list.
HALFEDGE_EXPORT int cut_edges(Address mesh, Index mode, Address edges, std::size_t count) {
  const std::span<const Edge> listed = items_at<Edge>(edges, count);
  return operate(
      mesh, mode, [=](const auto& m) { return operations::check_cut_edges(m, listed); },
      [=](auto& m) -> Result<Index> {
        Result<Array<Halfedge>> copies = operations::cut_edges(m, listed);
        if (!copies) return std::move(copies).failure();
        std::copy(copies.value().begin(), copies.value().end(), reinterpret_cast<Halfedge*>(edges));
        return Index(count);
      });
}

HALFEDGE_EXPORT int split_loop(Address mesh, Index mode, Address cycle, std::size_t count) {
  return HALFEDGE_OPERATE(split_loop, items_at<Halfedge>(cycle, count));
}

HALFEDGE_EXPORT int join_loop(Address mesh, Index mode, Index h, Index g) {
  return HALFEDGE_OPERATE(join_loop, Halfedge(h), Halfedge(g));
}

HALFEDGE_EXPORT int bridge(Address mesh, Index mode, Index h, Index g) {
  return HALFEDGE_OPERATE(bridge, Halfedge(h), Halfedge(g));
}

HALFEDGE_EXPORT int remove_bridge(Address mesh, Index mode, Index s) {
  return HALFEDGE_OPERATE(remove_bridge, Halfedge(s));
}

HALFEDGE_EXPORT int reverse(Address mesh, Index mode) {
  return apply(mesh, mode, [](auto& m) { return operations::reverse(m); });
}

HALFEDGE_EXPORT int reverse_component(Address mesh, Index mode, Index h) {
  return apply(mesh, mode, [=](auto& m) { return operations::reverse_component(m, Halfedge(h)); });
}
