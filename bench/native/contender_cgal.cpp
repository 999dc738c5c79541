#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <cstdlib>
#include <vector>

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

  void centre() override {
    double sum[3] = {};
    for (const auto v : mesh_.vertices()) {
      const Point& p = mesh_.point(v);
      sum[0] += double(p.x()), sum[1] += double(p.y()), sum[2] += double(p.z());
    }
    const auto count = double(mesh_.number_of_vertices());
    const Vector mean(float(sum[0] / count), float(sum[1] / count), float(sum[2] / count));
    for (const auto v : mesh_.vertices()) mesh_.point(v) = mesh_.point(v) - mean;
  }

  void compute_normals() override {
    of_faces_.resize(mesh_.num_faces());
    of_vertices_.resize(mesh_.num_vertices());
    for (const auto f : mesh_.faces()) {
      const auto h = mesh_.halfedge(f);
      const Point& p = mesh_.point(mesh_.source(h));
      of_faces_[f] = unit(CGAL::cross_product(mesh_.point(mesh_.target(h)) - p,
                                              mesh_.point(mesh_.target(mesh_.next(h))) - p));
    }
    for (const auto v : mesh_.vertices()) {
      Vector sum(0, 0, 0);
      for (const auto f : CGAL::faces_around_target(mesh_.halfedge(v), mesh_)) {
        if (f != Mesh::null_face()) sum += of_faces_[f];
      }
      of_vertices_[v] = unit(sum);
    }
  }

  void smooth() override {
    for (const auto v : mesh_.vertices()) {
      if (mesh_.is_border(v)) continue;
      Vector sum(0, 0, 0);
      float valence = 0;
      for (const auto w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_)) {
        sum += mesh_.point(w) - CGAL::ORIGIN;
        ++valence;
      }
      mesh_.point(v) = CGAL::ORIGIN + sum / valence;
    }
  }

  std::vector<float> geometry() override {
    std::vector<float> all;
    for (const auto v : mesh_.vertices()) {
      const Point& p = mesh_.point(v);
      all.insert(all.end(), {p.x(), p.y(), p.z()});
    }
    for (const Vector& n : of_vertices_) all.insert(all.end(), {n.x(), n.y(), n.z()});
    return all;
  }

  void keep() override { kept_ = mesh_; }
  void restore() override { mesh_ = kept_; }

  void subdivide() override {
    std::vector<Point> moved(mesh_.num_vertices());
    for (const auto v : mesh_.vertices()) {
      float sum[3] = {};
      unsigned valence = 0;
      for (const auto w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_)) {
        const Point& p = mesh_.point(w);
        sum[0] += p.x(), sum[1] += p.y(), sum[2] += p.z();
        ++valence;
      }
      const Point& p = mesh_.point(v);
      const float weight = sqrt3_weight(valence);
      const float of_each = weight / float(valence);
      moved[v] =
          Point((1 - weight) * p.x() + of_each * sum[0], (1 - weight) * p.y() + of_each * sum[1],
                (1 - weight) * p.z() + of_each * sum[2]);
    }
    const auto edges = mesh_.num_edges();
    const auto faces = mesh_.num_faces();
    mesh_.reserve(mesh_.num_vertices() + faces, edges + 3 * faces, 3 * faces);
    for (std::uint32_t f = 0; f < faces; ++f) split(Mesh::Face_index(f));
    for (std::uint32_t v = 0; v < moved.size(); ++v) mesh_.point(Mesh::Vertex_index(v)) = moved[v];
    for (std::uint32_t e = 0; e < edges; ++e) {
      const auto h = mesh_.halfedge(Mesh::Edge_index(e));
      if (mesh_.is_border(Mesh::Edge_index(e))) continue;
      const auto a = mesh_.target(mesh_.next(h));
      const auto b = mesh_.target(mesh_.next(mesh_.opposite(h)));
      if (a != b && mesh_.halfedge(a, b) == Mesh::null_halfedge()) {
        CGAL::Euler::flip_edge(h, mesh_);
      }
    }
  }

  void split_and_collapse() override {
    const auto vertices = static_cast<std::uint32_t>(mesh_.num_vertices());
    const auto faces = static_cast<std::uint32_t>(mesh_.num_faces());
    for (std::uint32_t f = 0; f < faces; ++f) split(Mesh::Face_index(f));
    for (std::uint32_t v = vertices; v < vertices + faces; ++v) {
      const auto e = mesh_.edge(mesh_.halfedge(Mesh::Vertex_index(v)));
      if (!CGAL::Euler::does_satisfy_link_condition(e, mesh_)) std::abort();
      CGAL::Euler::collapse_edge(e, mesh_);
    }
  }

  void compact() override { mesh_.collect_garbage(); }

  std::uint64_t valence_sum() override {
    std::uint64_t sum = mesh_.number_of_edges() + mesh_.number_of_faces();
    for (const auto v : mesh_.vertices()) {
      sum += std::uint64_t{mesh_.degree(v)} * mesh_.degree(v);
    }
    return sum;
  }

 private:
  using Point = CGAL::Simple_cartesian<float>::Point_3;
  using Vector = CGAL::Simple_cartesian<float>::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;

  static Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

  void split(Mesh::Face_index f) {
    const auto h = mesh_.halfedge(f);
    float sum[3] = {};
    for (const auto v : CGAL::vertices_around_face(h, mesh_)) {
      const Point& p = mesh_.point(v);
      sum[0] += p.x(), sum[1] += p.y(), sum[2] += p.z();
    }
    const auto spoke = CGAL::Euler::add_center_vertex(h, mesh_);
    mesh_.point(mesh_.target(spoke)) = Point(sum[0] / 3, sum[1] / 3, sum[2] / 3);
  }

  Mesh mesh_;
  Mesh kept_;
  std::vector<Vector> of_faces_;
  std::vector<Vector> of_vertices_;
};

}  // namespace

std::unique_ptr<Contender> make_cgal() { return std::make_unique<Cgal>(); }
