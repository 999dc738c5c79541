#include <halfedge/build/build.h>
#include <halfedge/mesh.h>

#include <cstdio>
#include <cstdlib>

#include "contender.h"

namespace {

class Halfedges final : public Contender {
 public:
  void build(const TriangleMesh& input) override {
    halfedge::BuildReport report;
    const halfedge::Polygons polygons{input.positions, {}, input.corners};
    if (halfedge::build_from_polygons(mesh_, polygons, report)) return;
    std::fprintf(stderr, "halfedge refused the mesh: %s\n", report.problems[0].message.c_str());
    std::abort();
  }

  std::int64_t circulate() override {
    std::int64_t counter = 0;
    for (const halfedge::Vertex v : mesh_.vertices()) {
      for ([[maybe_unused]] const halfedge::Face f : mesh_.vertex_faces_cw(v)) ++counter;
    }
    for (const halfedge::Face f : mesh_.faces()) {
      for ([[maybe_unused]] const halfedge::Vertex v : mesh_.face_vertices_ccw(f)) --counter;
    }
    return counter;
  }

  std::uint64_t one_ring_sum() override {
    std::uint64_t sum = 0;
    for (const halfedge::Vertex v : mesh_.vertices()) {
      for (const halfedge::Vertex w : mesh_.vertex_vertices_cw(v)) sum += w.index();
    }
    return sum;
  }

 private:
  halfedge::Mesh mesh_;
};

}  // namespace

std::unique_ptr<Contender> make_halfedge() { return std::make_unique<Halfedges>(); }
