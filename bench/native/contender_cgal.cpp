#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "contender.h"

namespace {

class Cgal final : public Contender {
 public:
  void build(const TriangleMesh& input) override {
    mesh_.clear();
    const auto vertices = static_cast<std::uint32_t>(input.vertex_count());
    const auto faces = static_cast<std::uint32_t>(input.face_count());
    mesh_.reserve(vertices, faces + faces / 2, faces);
    for (std::size_t v = 0; v < vertices; ++v) {
      const float* p = &input.positions[3 * v];
      mesh_.add_vertex(Point(p[0], p[1], p[2]));
    }
    for (std::size_t f = 0; f < faces; ++f) {
      const std::uint32_t* v = &input.corners[3 * f];
      mesh_.add_face(Mesh::Vertex_index(v[0]), Mesh::Vertex_index(v[1]), Mesh::Vertex_index(v[2]));
    }
  }

  std::int64_t circulate() override {
    std::int64_t counter = 0;
    for (const auto v : mesh_.vertices()) {
      for (const auto f : CGAL::faces_around_target(mesh_.halfedge(v), mesh_)) {
        if (f != Mesh::null_face()) ++counter;
      }
    }
    for (const auto f : mesh_.faces()) {
      for ([[maybe_unused]] const auto v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_)) {
        --counter;
      }
    }
    return counter;
  }

  std::uint64_t one_ring_sum() override {
    std::uint64_t sum = 0;
    for (const auto v : mesh_.vertices()) {
      for (const auto w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_)) {
        sum += static_cast<std::uint64_t>(w);
      }
    }
    return sum;
  }

 private:
  using Point = CGAL::Simple_cartesian<float>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh mesh_;
};

}  // namespace

std::unique_ptr<Contender> make_cgal() { return std::make_unique<Cgal>(); }
