#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdlib>
#include <vector>

#include "contender.h"

namespace {

struct Traits : OpenMesh::DefaultTraits {
  // Whether an item was deleted must be stored for it to be deleted.
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

class OpenMeshes final : public Contender {
 public:
  void build(const TriangleMesh& input) override {
    mesh_.clear();
    const std::size_t faces = input.face_count();
    mesh_.reserve(input.vertex_count(), 3 * faces / 2, faces);
    for (std::size_t v = 0; v < input.vertex_count(); ++v) {
      const float* p = &input.positions[3 * v];
      mesh_.add_vertex(Mesh::Point(p[0], p[1], p[2]));
    }
    for (std::size_t f = 0; f < faces; ++f) {
      const std::uint32_t* v = &input.corners[3 * f];
      mesh_.add_face(vertex(v[0]), vertex(v[1]), vertex(v[2]));
    }
  }

  std::int64_t circulate() override {
    std::int64_t counter = 0;
    for (const auto v : mesh_.vertices()) {
      for (auto it = mesh_.cvf_iter(v); it.is_valid(); ++it) ++counter;
    }
    for (const auto f : mesh_.faces()) {
      for (auto it = mesh_.cfv_iter(f); it.is_valid(); ++it) --counter;
    }
    return counter;
  }

  std::uint64_t one_ring_sum() override {
    std::uint64_t sum = 0;
    for (const auto v : mesh_.vertices()) {
      for (auto it = mesh_.cvv_iter(v); it.is_valid(); ++it) {
        sum += static_cast<std::uint64_t>(it->idx());
      }
    }
    return sum;
  }

  void centre() override {
    double sum[3] = {};
    for (const auto v : mesh_.vertices()) {
      const Mesh::Point& p = mesh_.point(v);
      for (int i = 0; i < 3; ++i) sum[i] += double(p[i]);
    }
    const auto count = double(mesh_.n_vertices());
    const Mesh::Point mean(float(sum[0] / count), float(sum[1] / count), float(sum[2] / count));
    for (const auto v : mesh_.vertices()) mesh_.set_point(v, mesh_.point(v) - mean);
  }

  void compute_normals() override {
    of_faces_.resize(mesh_.n_faces());
    of_vertices_.resize(mesh_.n_vertices());
    for (const auto f : mesh_.faces()) {
      const auto h = mesh_.halfedge_handle(f);
      const Mesh::Point& p = mesh_.point(mesh_.from_vertex_handle(h));
      const Mesh::Point a = mesh_.point(mesh_.to_vertex_handle(h)) - p;
      const Mesh::Point b = mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h))) - p;
      of_faces_[std::size_t(f.idx())] = OpenMesh::cross(a, b).normalized();
    }
    for (const auto v : mesh_.vertices()) {
      Mesh::Point sum(0, 0, 0);
      for (auto it = mesh_.cvf_iter(v); it.is_valid(); ++it)
        sum += of_faces_[std::size_t(it->idx())];
      of_vertices_[std::size_t(v.idx())] = sum.normalized();
    }
  }

  void smooth() override {
    for (const auto v : mesh_.vertices()) {
      if (mesh_.is_boundary(v)) continue;
      Mesh::Point sum(0, 0, 0);
      float valence = 0;
      for (auto it = mesh_.cvv_iter(v); it.is_valid(); ++it, ++valence) sum += mesh_.point(*it);
      mesh_.set_point(v, sum / valence);
    }
  }

  std::vector<float> geometry() override {
    std::vector<float> all;
    for (const auto v : mesh_.vertices()) append(all, mesh_.point(v));
    for (const Mesh::Point& n : of_vertices_) append(all, n);
    return all;
  }

  void keep() override { kept_ = mesh_; }
  void restore() override { mesh_ = kept_; }

  void subdivide() override {
    std::vector<Mesh::Point> moved(mesh_.n_vertices());
    for (const auto v : mesh_.vertices()) {
      Mesh::Point sum(0, 0, 0);
      unsigned valence = 0;
      for (auto it = mesh_.cvv_iter(v); it.is_valid(); ++it, ++valence) sum += mesh_.point(*it);
      const float weight = sqrt3_weight(valence);
      moved[std::size_t(v.idx())] = (1 - weight) * mesh_.point(v) + weight / float(valence) * sum;
    }
    const std::size_t edges = mesh_.n_edges();
    const std::size_t faces = mesh_.n_faces();
    mesh_.reserve(mesh_.n_vertices() + faces, edges + 3 * faces, 3 * faces);
    for (std::size_t f = 0; f < faces; ++f) split(face(f));
    for (std::size_t v = 0; v < moved.size(); ++v) {
      mesh_.set_point(vertex(std::uint32_t(v)), moved[v]);
    }
    for (std::size_t e = 0; e < edges; ++e) {
      const OpenMesh::EdgeHandle edge(static_cast<int>(e));
      if (mesh_.is_flip_ok(edge)) mesh_.flip(edge);
    }
  }

  void split_and_collapse() override {
    const std::size_t vertices = mesh_.n_vertices();
    const std::size_t faces = mesh_.n_faces();
    for (std::size_t f = 0; f < faces; ++f) split(face(f));
    for (std::size_t v = vertices; v < vertices + faces; ++v) {
      const auto h = mesh_.halfedge_handle(vertex(std::uint32_t(v)));
      if (!mesh_.is_collapse_ok(h)) std::abort();
      mesh_.collapse(h);
    }
  }

  void compact() override { mesh_.garbage_collection(); }

  std::uint64_t valence_sum() override {
    std::uint64_t sum = 0;
    for ([[maybe_unused]] const auto e : mesh_.edges()) ++sum;
    for ([[maybe_unused]] const auto f : mesh_.faces()) ++sum;
    for (const auto v : mesh_.vertices()) {
      sum += std::uint64_t{mesh_.valence(v)} * mesh_.valence(v);
    }
    return sum;
  }

 private:
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

  static OpenMesh::VertexHandle vertex(std::uint32_t index) {
    return OpenMesh::VertexHandle(static_cast<int>(index));
  }

  static OpenMesh::FaceHandle face(std::size_t index) {
    return OpenMesh::FaceHandle(static_cast<int>(index));
  }

  static void append(std::vector<float>& all, const Mesh::Point& p) {
    all.insert(all.end(), {p[0], p[1], p[2]});
  }

  void split(OpenMesh::FaceHandle f) { mesh_.split(f, mesh_.calc_face_centroid(f)); }

  Mesh mesh_;
  Mesh kept_;
  std::vector<Mesh::Point> of_faces_;
  std::vector<Mesh::Point> of_vertices_;
};

}  // namespace

std::unique_ptr<Contender> make_openmesh() { return std::make_unique<OpenMeshes>(); }

const char* openmesh_name() {
#if defined(HALFEDGE_OPENMESH_COMPILED)
  return "OpenMesh, compiled here";
#else
  return "OpenMesh, Debian's";
#endif
}
