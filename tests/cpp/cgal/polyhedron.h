#pragma once

// CGAL before ours: its templates call a function `halfedge`, and must not find our namespace.
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

#include "support/shapes.h"

namespace halfedge::test {

using CgalPolyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<float>>;

/// Builds CGAL's polyhedron of the same vertices and faces in the same order.
class CgalBuilder : public CGAL::Modifier_base<CgalPolyhedron::HalfedgeDS> {
 public:
  explicit CgalBuilder(const Shape& shape) : shape_(shape) {}

  void operator()(CgalPolyhedron::HalfedgeDS& hds) override {
    CGAL::Polyhedron_incremental_builder_3<CgalPolyhedron::HalfedgeDS> builder(hds);
    builder.begin_surface(shape_.vertices, shape_.faces.size());
    for (std::size_t v = 0; v < shape_.vertices; ++v) {
      const float* p = &shape_.positions[3 * v];
      builder.add_vertex({p[0], p[1], p[2]});
    }
    for (const std::vector<Index>& face : shape_.faces) {
      taken_ = taken_ && builder.test_facet(face.begin(), face.end());
      if (taken_) builder.add_facet(face.begin(), face.end());
    }
    taken_ = taken_ && !builder.check_unconnected_vertices();
    if (!taken_) return builder.rollback();
    builder.end_surface();
    taken_ = !builder.error();
  }

  /// Whether CGAL took them: it has no isolated vertices, and depends on the order of the faces.
  [[nodiscard]] bool taken() const { return taken_; }

 private:
  const Shape& shape_;
  bool taken_ = true;
};

}  // namespace halfedge::test
