#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

/// A triangle mesh as every library gets it.
struct TriangleMesh {
  std::vector<float> positions;        // 3 for each vertex
  std::vector<std::uint32_t> corners;  // 3 for each face

  [[nodiscard]] std::size_t vertex_count() const { return positions.size() / 3; }
  [[nodiscard]] std::size_t face_count() const { return corners.size() / 3; }
};

/// One library in the benchmark. The workloads follow Sieger and Botsch, "Design, Implementation,
/// and Evaluation of the Surface_mesh Data Structure" (2011), each written the way the library's
/// own documentation writes it.
class Contender {
 public:
  virtual ~Contender() = default;

  /// Makes the mesh anew, in whatever is the library's fastest documented way.
  virtual void build(const TriangleMesh& input) = 0;

  /// ++ for each face of each vertex, -- for each vertex of each face: 0 for a closed mesh.
  virtual std::int64_t circulate() = 0;

  /// The sum of the indices of the one-ring vertices of all vertices.
  virtual std::uint64_t one_ring_sum() = 0;
};

std::unique_ptr<Contender> make_halfedge();
std::unique_ptr<Contender> make_flat();
std::unique_ptr<Contender> make_openmesh();
std::unique_ptr<Contender> make_cgal();

/// Which OpenMesh it is: Debian's library, with assertions, or one compiled here, without.
const char* openmesh_name();
