#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "contender.h"

namespace {

struct Traits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
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

 private:
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

  static OpenMesh::VertexHandle vertex(std::uint32_t index) {
    return OpenMesh::VertexHandle(static_cast<int>(index));
  }

  Mesh mesh_;
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
