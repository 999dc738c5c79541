#include <halfedge/build/build.h>
#include <halfedge/connectivity/compact.h>
#include <halfedge/mesh.h>
#include <halfedge/operations/operations.h>
#include <halfedge/operations/reorder.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "contender.h"
#include "workloads.h"

namespace {

using workloads::require;

class Halfedges final : public Contender {
 public:
  void build(const TriangleMesh& input) override {
    halfedge::BuildReport report;
    const halfedge::Polygons polygons{input.positions, {}, input.corners};
    if (halfedge::build_from_polygons(mesh_, polygons, report)) return;
    std::fprintf(stderr, "halfedge refused the mesh: %s\n", report.problems[0].message.c_str());
    std::abort();
  }

  void reorder() override { require(bool(halfedge::reorder(mesh_))); }

  std::int64_t circulate() override { return workloads::circulate(mesh_); }
  std::uint64_t one_ring_sum() override { return workloads::one_ring_sum(mesh_); }

  void centre() override { workloads::centre(mesh_); }
  void compute_normals() override { workloads::normals(mesh_, of_faces_, of_vertices_); }
  void smooth() override { workloads::smooth(mesh_); }

  std::vector<float> geometry() override {
    std::vector<float> all(mesh_.positions().begin(), mesh_.positions().end());
    for (const halfedge::Point n : of_vertices_) all.insert(all.end(), {n.x, n.y, n.z});
    return all;
  }

  void keep() override { require(kept_.assign(mesh_)); }
  void restore() override { require(mesh_.assign(kept_)); }

  void subdivide() override { workloads::subdivide(mesh_); }

  void split_and_collapse() override {
    const halfedge::Index vertices = mesh_.vertex_slots();
    workloads::split_faces(mesh_);
    workloads::collapse_behind(mesh_, vertices);
  }

  void compact() override { require(bool(halfedge::compact(mesh_))); }

  std::uint64_t valence_sum() override {
    std::uint64_t sum = mesh_.edge_count() + mesh_.face_count();
    for (const halfedge::Vertex v : mesh_.vertices()) {
      sum += std::uint64_t{mesh_.valence(v)} * mesh_.valence(v);
    }
    return sum;
  }

 private:
  halfedge::Mesh mesh_;
  halfedge::Mesh kept_;
  std::vector<halfedge::Point> of_faces_;
  std::vector<halfedge::Point> of_vertices_;
};

}  // namespace

std::unique_ptr<Contender> make_halfedge() { return std::make_unique<Halfedges>(); }
